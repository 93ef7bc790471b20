"""The top of the project has its rooms alone. Includes go only downward: generated and hand-written plants -> core ->
port's header; ports know the number type only; the target's code uses no header of a hosted C library; nothing includes
tools or tests but themselves. The folders of core and of isoc stand in an order of their own: a file includes its own
folder and those before it, and of isoc it calls no others either.
"""
import collections
import pathlib
import re
import subprocess

import pytest

from harness.project import ROOT, make

CORE = 'numbers methods runtime wire application link snapshots xcp conform'.split()
ISOC = ('base scene graph method formula mechanism effects tree closure dynamics implicit plant stability emit export linear '
        'sweep').split()
TOP = 'request products pipeline main'.split()
ROOMS = {'core', 'port', 'models', 'tests', 'tools', 'build', 'Makefile', 'README.md'}
# Without a hosted C library, and with one.
FREE, HOSTED = '<(stdint|stddef|stdbool|float|limits|string)\\.h>', '<[a-z0-9_/]+\\.h>'


def downto(rooms, file, above):
    """A pattern of the rooms up to that of the file; all for a file that stands above them."""
    room = file.split('/')[above]
    return '(' + '|'.join(rooms[:rooms.index(room) + 1] if room in rooms else rooms) + ')'


def of_core(file):
    return f'"(core/{downto(CORE, file, 1)}/[a-z0-9_]+\\.h|port/(port|channel)\\.h)"'


def of_isoc(file):
    """What isoc writes for the other end of a wire stands in export."""
    more = '|core/wire/protocol\\.h|core/link/frame\\.h|port/channel\\.h' if file.startswith('tools/isoc/export/') else ''
    return f'"(tools/isoc/{downto(ISOC, file, 2)}/[a-z0-9_]+\\.h|core/(numbers|methods)/[a-z0-9_]+\\.h{more})"|{HOSTED}'


# What the files of a place may include, the first that fits; a function says it by the file.
MAY = [
    ('core/', of_core),
    ('port/(host|posix|unix)/', f'"(port/[a-z0-9_/]+\\.h|core/numbers/real\\.h)"|{HOSTED}'),
    ('port/', '"(port/[a-z0-9_/]+\\.h|core/numbers/real\\.h)"'),
    # A controller, with the header that isoc writes for it.
    ('models/hil/', f'"[a-z0-9_]+_link\\.h"|{HOSTED}'),
    ('models/', '"core/(numbers|methods|runtime)/[a-z0-9_]+\\.h"'),
    ('build/', '"(core/(numbers|methods|runtime)/[a-z0-9_]+\\.h|plant\\.h|.*\\.c)"'),
    # What the compiler is made of at its top.
    (r'tools/isoc/[a-z]+\.[ch]$', f'"(tools/isoc/([a-z]+/)?|core/(numbers|methods)/)[a-z0-9_]+\\.h"|{HOSTED}'),
    ('tools/isoc/', of_isoc),
    # A plant in lanes.
    (r'tools/(measure/batch|python/lanes|lab/rig)\.c$', f'"((core|tools/python)/[a-z0-9_/]+\\.h|plant\\.c)"|{HOSTED}'),
    # The library of a plant in Python is a platform too.
    ('tools/python/', '"(tools/(python|client)/[a-z0-9_]+\\.h|core/[a-z0-9_/]+\\.h|port/port\\.h)"'),
    # Generated plants.
    (r'tools/measure/order\.c$', f'"(tools/[a-z0-9_/]+|core/[a-z0-9_/]+|coarse|middle|fine)\\.h"|{HOSTED}'),
    ('tools/', f'"(tools|core)/[a-z0-9_/]+\\.h"|{HOSTED}'),
]


def is_allowed(file, include):
    pattern = next(pattern for place, pattern in MAY if re.match(place, file))
    return re.fullmatch(f'{pattern(file) if callable(pattern) else pattern}|{FREE}', include) is not None


def sources():
    """Files of C of the project, and the plants that it has made."""
    yield from (path for room in ('core', 'port', 'models', 'tools') for path in (ROOT / room).rglob('*.[ch]'))
    for real in 'float', 'double':
        yield from ROOT.glob(f'build/*/{real}/*/plant.[ch]')


def violations(files):
    """Each include that its layer forbids, of these texts by their names."""
    return [f'{name}:{number}: {found[1]}' for name, text in files.items() for number, line in enumerate(text.splitlines(), 1)
            if (found := re.match(r'[ \t]*#[ \t]*include[ \t]*(.*?)[ \t]*(/\*.*)?$', line)) and not is_allowed(name, found[1])]


def strange(folder):
    """What stands at the top of the project and is none of its rooms. Hidden files aside."""
    return {path.name for path in folder.iterdir() if not path.name.startswith('.')} - ROOMS


def unlisted(folder):
    """Folders, and files at the top of isoc, that the orders above leave out."""
    rooms = [path.name for path in folder.glob('core/*') if path.is_dir()]
    rooms += [path.stem for path in folder.glob('tools/isoc/*') if path.is_dir() or path.suffix == '.c']
    return set(rooms) - set(CORE + ISOC + TOP)


def test_the_top_of_the_project_has_its_rooms_alone(tmp_path):
    assert not strange(ROOT)
    (tmp_path / 'core').mkdir()
    (tmp_path / 'step').write_text('')
    assert strange(tmp_path) == {'step'}


def test_every_include_goes_downward():
    files = {str(path.relative_to(ROOT)): path.read_text() for path in sources()}
    assert len(files) > 300 and not violations(files)


@pytest.mark.parametrize('file, include', [
    ('core/runtime/loop.c', '"tools/isoc/graph/graph.h"'), ('core/runtime/loop.c', '"port/host/script.h"'),
    ('core/runtime/loop.c', '"models/pendulum.h"'), ('core/runtime/loop.h', '<stdio.h>'), ('core/runtime/loop.h', '<math.h>'),
    ('port/host/sim.c', '"core/runtime/loop.h"'), ('port/mps2/start.c', '<stdlib.h>'), ('port/port.h', '"core/runtime/plant.h"'),
    ('models/oscillator.c', '"port/port.h"'), ('models/oscillator.c', '<math.h>'), ('models/hil/controller.c', '"core/link/link.h"'),
    ('build/host/float/tree/plant.c', '"port/port.h"'), ('tools/isoc/main.c', '"tests/tap.h"'),
    ('tools/isoc/main.c', '"port/port.h"'), ('core/methods/euler.h', '"core/runtime/plant.h"'),
    ('core/runtime/loop.c', '"core/application/stream.h"'), ('tools/isoc/graph/graph.c', '"tools/isoc/mechanism/mechanism.h"'),
    ('tools/isoc/implicit/jacobian.c', '"tools/isoc/emit/code.h"'), ('tools/isoc/plant/plant.c', '"core/wire/protocol.h"'),
    ('tools/isoc/export/link.c', '"core/application/stream.h"')])
def test_found_an_include_that_goes_upward(file, include):
    assert violations({file: f'#include <stdint.h>\n#include {include}\n'}) == [f'{file}:2: {include}']


def test_includes_downward_are_let_through():
    assert not violations({'core/runtime/loop.c': '#include "port/port.h"\n', 'port/host/sim.c': '#include <stdio.h>\n',
                           'build/host/float/tree/plant.c': '#  include "plant.h" /* of the same folder */\n'})


def test_every_room_has_its_place_in_the_order(tmp_path):
    assert not unlisted(ROOT)
    for room in 'core/extra', 'tools/isoc/base':
        (tmp_path / room).mkdir(parents=True)
    assert unlisted(tmp_path) == {'extra'}


def calls(folder):
    """(room, name, room): each name of a room that another one refers to, by the objects of isoc: one for each of its
    folders, and for each file at its top."""
    refers, of = collections.defaultdict(set), {}
    objects = [path for room in ISOC + TOP if (path := folder / f'{room}.o').exists()]
    for line in subprocess.run(['nm', '-A', '-P', *objects], capture_output=True, text=True, check=True).stdout.splitlines():
        place, name, kind = line.split()[:3]
        room = pathlib.Path(place.rstrip(':')).stem
        if kind == 'U':
            refers[room].add(name)
        elif kind in 'BCDRT':
            of[name] = room
    return {(room, name, of[name]) for room, names in refers.items() for name in names & of.keys()}


def upward(found):
    order = ISOC + TOP
    return {call for call in found if order.index(call[0]) < order.index(call[2])}


def test_every_call_from_a_room_of_isoc_goes_downward(tmp_path):
    make('tools')
    folder = ROOT / 'build/obj/tools/isoc'
    found = calls(folder)
    assert len(found) > 500 and not upward(found)
    (tmp_path / 'graph.c').write_text('int plant_build(void), planted(void); int planted(void) { return plant_build(); }\n')
    subprocess.run(['gcc', '-c', tmp_path / 'graph.c', '-o', tmp_path / 'graph.o'], check=True)
    (tmp_path / 'plant.o').write_bytes((folder / 'plant.o').read_bytes())
    assert upward(calls(tmp_path)) == {('graph', 'plant_build', 'plant')}


def rooms(text):
    """Those of the table of the rooms, in its order."""
    return re.findall(r'^\| `([a-z]*)`', text.split('\n## The rooms\n')[1], flags=re.M)


def test_the_design_of_isoc_has_its_rooms_in_their_order():
    text = (ROOT / 'tools/isoc/DESIGN.md').read_text()
    assert rooms(text) == ISOC
    assert rooms(re.sub(r'^\| `tree` .*\n', '', text, flags=re.M)) != ISOC
