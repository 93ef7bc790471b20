"""The pictures of the gallery, models/README.md, are those that `isochron pictures` draws, one for each model. Those of
gnuplot are the same to the last byte; in graphs the places are a matter of the machine's fonts."""
import re

import pytest

from harness.project import ROOT

PICTURES = ROOT / 'models/pictures'
NAMES = [*sorted(path.stem for path in ROOT.glob('models/*.scene')), 'hil', 'double_pendulum_film']


@pytest.fixture
def drawn(laboratory):
    """drawn(name): what the command of the gallery draws."""
    from lab import pictures
    commands = {pictures.name_of(words): words for words in pictures.commands()}
    assert set(commands) == set(NAMES), 'one for each model, one of hil, and one that moves'
    return lambda name: pictures.drawn(commands[name])


def compared(drawing):
    """Of a graph the nodes, edges and texts, of another drawing all."""
    return re.findall('<title>.*</title>|>[^<]*</text>', drawing) if 'class="graph"' in drawing else drawing


@pytest.mark.parametrize('name', NAMES)
def test_a_picture_is_what_its_command_draws(drawn, name):
    kept = (PICTURES / f'{name}.svg').read_text()
    name_drawn, drawing = drawn(name)
    assert name_drawn == name and f'](pictures/{name}.svg)' in (ROOT / 'models/README.md').read_text()
    assert compared(kept) == compared(drawing) and 50 < len(kept) < (200000 if name.endswith('_film') else 45000)


def test_found_a_point_that_is_moved():
    kept = (PICTURES / 'pendulum.svg').read_text()
    moved = re.sub(' L1', ' L2', kept, count=1)
    assert moved != kept and compared(moved) != compared(kept)
    graph = (PICTURES / 'squeezer.svg').read_text()
    assert compared(graph.replace('</title>', '2</title>', 1)) != compared(graph)
