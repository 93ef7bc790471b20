"""isoc --dot: graphviz draws every body, joint and closure of a scene, closures dashed, frames dotted, with their effects."""
import pathlib
import re
import subprocess

import pytest

SCENES = sorted(pathlib.Path('models').glob('*.scene')) + sorted(pathlib.Path('tests/isoc/scene').glob('*.scene'))
# Bodies, joints and closures of repeats, which are counted by hand.
REPEATED = {'stewart': (12, 12, 6), 'n_four_bar': (5, 5, 2)}


def drawn(isoc, path):
    """The drawing, against which nothing is said."""
    graph = isoc(path, '--dot', writes=False).printed
    done = subprocess.run(['dot', '-Tsvg'], input=graph, capture_output=True, text=True)
    assert done.returncode == 0 and done.stderr == '', done.stderr
    return done.stdout


@pytest.mark.parametrize('path', SCENES, ids=lambda path: path.stem)
def test_a_drawing_has_a_node_for_each_body_and_an_edge_for_each_joint(isoc, path):
    """Frames are nodes on dotted edges, closures dashed ones. Of repeats and included files the number of words says nothing."""
    drawing, text = drawn(isoc, path), path.read_text()
    if re.search('^ *(include|repeat) ', text, re.M):
        return
    n = {word: len(re.findall(f'^{word} ', text, re.M)) for word in ('body', 'frame', 'joint', 'spring', 'close')}
    bodies, joints, closures = (a + b for a, b in zip((n['body'], n['joint'], n['close']), REPEATED.get(path.stem, (0, 0, 0))))
    assert drawing.count('class="node"') == bodies + n['frame'] + 1, 'and the ground'
    assert drawing.count('class="edge"') == joints + closures + n['frame'] + n['spring']
    assert drawing.count('stroke-dasharray="5,2"') == closures and drawing.count('stroke-dasharray="1,5"') == n['frame']


@pytest.mark.parametrize('scene, text', [('closed', text) for text in (
    'force jet: thrust', 'chain', 'distance', 'gear', 'universal', 'damping', 'states: tube_slide, tube_turn, tube_slide_speed,', 'tube_turn_speed')] + [
    ('closures', 'states: clock_1'), ('frames', 'finger'), ('frames', 'spring, damping'), ('good', 'drive: push'), ('good', 'revolute')])
def test_effects_are_shown(isoc, scene, text):
    drawing = drawn(isoc, pathlib.Path(f'tests/isoc/scene/{scene}.scene'))
    assert f'>{text}</text>' in drawing and '>no such effect</text>' not in drawing


def test_the_picture_of_the_squeezer_is_what_graphviz_draws(isoc):
    """Nodes, edges and texts; where they stand is a matter of the machine's fonts."""
    def told(drawing):
        return re.findall('<title>.*</title>|>[^<]*</text>', drawing)

    found = told(drawn(isoc, pathlib.Path('models/squeezer.scene')))
    assert len(found) > 40 and found == told(pathlib.Path('models/pictures/squeezer.svg').read_text())


def test_half_a_graph_and_a_scene_with_mistakes_have_no_drawing(isoc):
    half = isoc(pathlib.Path('models/pendulum.scene'), '--dot', writes=False).printed[:60]
    assert subprocess.run(['dot', '-Tsvg'], input=half, capture_output=True, text=True).returncode
    bad = isoc('step 1 ms\n', '--dot', writes=False)
    assert bad.status == 1 and bad.printed == '' and bad.errors
