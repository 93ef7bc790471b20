"""A picture shows every kind of joint, and of closure between bodies, that isoc has: by what the kind moves or holds."""
import re
import struct
import subprocess

SCENE = """step 1 ms
body a { box (0.2, 0.3, 0.4) m of 1 kg }
body b { box (0.2, 0.3, 0.4) m of 1 kg }
joint of_a free { parent ground; child a }
"""
# Properties that name something of the scene; of others isoc's message has an example.
GIVEN = {'parent': 'parent a at (0.5, 0, 0) m', 'child': 'child b at (-0.5, 0, 0) m'}
# They slide in several directions, and so hold their child at no place.
NOWHERE = {'planar', 'free'}


def kinds(isoc, statement):
    """All that isoc knows, as it says where one is unknown."""
    said = isoc(SCENE + statement + ' unknown { }', '--shape', writes=False).errors
    words = re.search('error: expected (.*); found', said).group(1)
    return re.split(', | or ', words)


def shape(isoc, before, statement, kind):
    """The shape of a scene with this kind, which gets the properties that isoc misses; None where it is not between
    bodies."""
    properties = []
    while True:
        made = isoc(SCENE + before + '%s %s {\n%s\n}\n' % (statement, kind, '\n'.join(properties)), '--shape',
                    writes=False)
        missing = re.findall(r"has no (\w+): (.*)", made.errors)
        if not missing:
            assert made.status == 0, made.errors
            return made.printed
        if 'first' in dict(missing):
            return None
        properties += [GIVEN.get(word, example) for word, example in missing]


def picture(folder, text):
    """The still of a shape; bodies a and b stand apart. The stream is that of core/application/stream.h."""
    names = [f'shown{i}_{part}' for i in (0, 1) for part in 'at_x at_y at_z turn_w turn_x turn_y turn_z'.split()]
    head = {'scene': 'kinds', 'method': 'rk4', 'step': '0.001', 'real': 'double', 'names': ','.join(names),
            'period_ns': 'f4240', 'duration_ns': '0', 'states': '0', 'outputs': '%x' % len(names)}
    stream = 'isochron 2\n' + ''.join(f'{key} {value}\n' for key, value in head.items()) + '\n'
    row = struct.pack('<c14d', b'r', 0, 0, 0, 1, 0, 0, 0, 1, 0.2, 0.1, 1, 0, 0, 0)
    (folder / 'stream').write_bytes(stream.encode() + row)
    (folder / 'shape').write_text(text)
    return subprocess.run(['build/show', 'still', '0', folder / 'shape', f'cat {folder}/stream'], capture_output=True,
                          text=True)


def is_drawn(folder, text):
    """Whether a picture has more polygons than one without the line of the kind; the bodies have a solid each."""
    polygons = [picture(folder, t).stdout.count('<path') for t in (text, re.sub(r'\n(joint\tj|closure)\t.*', '', text))]
    assert polygons[1] > 0
    return polygons[0] > polygons[1]


def undrawn(isoc, folder, before, statement):
    shapes = {kind: shape(isoc, before, statement, kind) for kind in kinds(isoc, statement)}
    assert len(shapes) >= 9
    return {kind for kind, text in shapes.items() if text is not None and not is_drawn(folder, text)}


def test_joints(isoc, tmp_path):
    assert undrawn(isoc, tmp_path, '', 'joint j') == NOWHERE


def test_closures(isoc, tmp_path):
    assert undrawn(isoc, tmp_path, 'joint of_b free { parent ground; child b }\n', 'close c') == set()


def test_what_is_not_drawn_is_found(isoc, tmp_path):
    text = shape(isoc, '', 'joint j', 'screw')
    assert is_drawn(tmp_path, text) and not is_drawn(tmp_path, text.replace('\tscrew\t', '\tplanar\t'))
    assert picture(tmp_path, text.replace('\tscrew\t', '\tknot\t')).stderr == "show: no joint is called 'knot'\n"
