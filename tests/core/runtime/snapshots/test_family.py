"""A plant goes on from a record bit for bit (family.c): models by every method, in float and in double, with and without a
check of its steps (with one, a step may be made again) and smooth inputs; the scene with all effects of the library, its
noise, delays and faults among them; scenes with events; and a drive whose faults come by the clock."""
import re

import pytest

from harness.programs import REPORT, path_of, run
from harness.project import ROOT, turn
from lab import build

MODELS = {path: path.read_text() for path in sorted((ROOT / 'models').glob('*.scene'))}
LARGE = ROOT / 'models/stewart.scene'
SHARED = [path for path, text in MODELS.items() if not re.search('^ *effect ', text, re.M) and path != LARGE]
OTHERS = (('tests/isoc/effects/all.scene', 'rk4', 4200), ('tests/isoc/events/events.scene', 'rk4', 900),
          ('tests/isoc/events/holds.scene', 'rk4', 900), ('models/cart_pole_drive.scene', 'adams', 9000))
SOURCES = ['tests/core/runtime/snapshots/family.c', 'core/numbers/self_check.c', REPORT]
HEAD = '#include "tests/core/runtime/snapshots/family.h"\n'


def members():
    """Of each its scene, its method, how many ticks, a line more and options: a half is checked, and a half of those with
    inputs has them smooth."""
    tried = 0
    for method in build.methods():
        for path in MODELS if method == 'rk4' else SHARED:
            if path != LARGE:
                tried += 1
                text = MODELS[path]
                checked = tried % 2 and not re.search('^checked', text, re.M)
                smooth = tried // 2 % 2 == 0 and re.search('^input', text, re.M)
                yield path, method, 300, 'checked yes' if checked else '', ['--inputs', 'smooth'] if smooth else []


@pytest.fixture(scope='module')
def family(isoc, program, tmp_path_factory):
    """family(real, planted=): the program of all members; each has its plant twice."""
    sources = {}

    def member(folder, number, path, method, ticks, line, options, real):
        scene = path_of(f'include "{path}"\n{line}\n', folder, f'{path.stem}_{number}.scene')
        name = f'{path.stem}_{number}'
        made = isoc(scene, '--name', name, '--real', real, '--method', method, *options)
        assert made.status == 0, made.errors
        before = ', &before[i]' if 'const before)' in made.file(f'{name}.h') else ''
        return name, path_of(f'''#include "{made.folder / name}.c"
{HEAD}static iso_plant plant_of(const int i)
{{
    static {name}_memory memory[2]{', before[2]' if before else ''};
    return {name}_plant(&memory[i]{before});
}}
extern const family_member {name};
const family_member {name} = {{"{path.stem}, {method}, {line} {' '.join(options)}", {ticks}, plant_of}};
''', folder, f'{name}.c')

    def of(real, planted=None):
        if real not in sources:
            folder = tmp_path_factory.mktemp('family')
            others = [(ROOT / path, method, ticks, '', []) for path, method, ticks in OTHERS] if real == 'float' else []
            made = [member(folder, number, *one, real) for number, one in enumerate([*members(), *others])]
            listed = ''.join(f'extern const family_member {name};\n' for name, _ in made) + \
                'const family_member *const family[] = {' + ''.join(f'&{name}, ' for name, _ in made) + '0};\n'
            sources[real] = [path for _, path in made] + [path_of(HEAD + listed, folder, 'family.c')]
        return program(*SOURCES, 'core/runtime/snapshot.c', *sources[real], real=real, planted=planted)

    return of


@pytest.mark.parametrize('real', ('float', 'double'))
def test_each_plant_goes_on_from_a_record_bit_for_bit(family, proves, real):
    seed = turn(1000000)
    proves(family(real), 1 if seed is None else seed)


def test_found_a_record_that_has_4_bytes_of_the_memory_alone(family):
    whole = 'memcpy(snapshot + sizeof head, plant->memory, head.memory_bytes);'
    planted = family('double', {'core/runtime/snapshot.c': (whole, whole.replace('head.memory_bytes', '4'))})
    assert run(planted, 1).finds('goes on bit for bit')
