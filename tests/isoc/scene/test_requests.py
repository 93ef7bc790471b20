"""One process that carries out many calls of isoc (tests/host/requests.c) writes the same files and messages as build/isoc, with the same
status, whichever calls came before."""
import glob
import re
import subprocess

import pytest
from harness.plants import Requests, replaced
from harness.project import ROOT

# Where the output goes, if not to a file; arguments of isoc, with a folder behind an -o that ends them.
CALLS = '''- tests/isoc/scene/good.scene -o
- BAD -o
/dev/full --methods
- --help
- tests/isoc/scene/closed.scene --method bdf4 --real double -o
- tests/isoc/scene/good.scene --fast -o
/dev/full tests/isoc/scene/effect.scene -o
- tests/isoc/scene/effect.scene --link --xcp open -o
- absent.scene -o
- tests/isoc/scene/loop.scene --standalone --name loop --step 500us -o
- tests/isoc/scene/loop.scene --formulation articulated --factors sparse -o
- tests/isoc/scene/good.scene --method rk5 -o
- models/cart_pole.scene --python -o
- models/cart_pole.scene --fmu --fmi 2 -o
- models/cart_pole.scene --fmu --exchange -o
- models/cart_pole.scene --lanes --method euler -o
- models/cart_pole.scene --linear -o
- models/four_bar.scene --equations latex
- models/four_bar.scene --dot
- models/double_pendulum.scene --mjcf
- models/cart_pole_drive.scene --set rod_mass=-1kg -o
- models/cart_pole_drive.scene --effects
- models/cart_pole_drive.scene --files
- models/cart_pole_drive.scene --shape
- models/cart_pole_drive.scene --method adams --tolerance 1e-9 -o'''.splitlines()


@pytest.fixture(scope='module')
def bad(tmp_path_factory):
    text = (ROOT / 'tests/isoc/scene/good.scene').read_text()
    path = tmp_path_factory.mktemp('bad') / 'bad.scene'
    path.write_text(re.sub('^step .*', 'step 1 kg ?', text.replace('kg', 'kgg'), flags=re.M) + 'output y = position of nothing\n')
    return path


def outcome(ask, call, number, bad, place):
    """The status of a call, what it said and printed, and its files."""
    output, *words = call.replace('BAD', str(bad)).split()
    folder, said, printed = place / f'{number}', place / 'said', place / 'printed'
    words += [str(folder)] * (words[-1] == '-o')
    status = ask('/dev/full' if output != '-' else printed, said, *words)
    files = {path.relative_to(folder): path.read_bytes() for path in folder.rglob('*') if path.is_file()}
    return status, said.read_text(), printed.read_text() if output == '-' else '', files


def alone(printed, said, *words):
    with open(printed, 'w') as out, open(said, 'w') as errors:
        return subprocess.run(['build/isoc', *words], stdout=out, stderr=errors).returncode


def outcomes(ask, bad, place, is_reversed=False):
    """Of all calls by number; folders have the same names, since messages tell them."""
    place.mkdir(exist_ok=True)
    order = sorted(range(len(CALLS)), reverse=is_reversed)
    made = {n: outcome(ask, CALLS[n], n, bad, place) for n in order}
    for folder in place.iterdir():
        subprocess.run(['rm', '-r', folder], check=True)
    return made


def test_one_process_does_what_each_call_alone_does(bad, tmp_path, tmp_path_factory):
    expected = outcomes(alone, bad, tmp_path / 'calls')
    statuses = [status for status, *_ in expected.values()]
    assert statuses.count(0) > 10 and statuses.count(1) > 5 and set(statuses) == {0, 1}
    process = Requests(tmp_path_factory.mktemp)
    assert outcomes(process.ask, bad, tmp_path / 'calls') == expected
    assert outcomes(process.ask, bad, tmp_path / 'calls', is_reversed=True) == expected
    process.end()


def test_a_request_that_keeps_what_the_one_before_it_was_told_is_found(bad, tmp_path, tmp_path_factory):
    (tmp_path / 'tools/isoc').mkdir(parents=True)
    planted = replaced(r'^    request r = \{0\};$', '    static request r;', (ROOT / 'tools/isoc/main.c').read_text())
    (tmp_path / 'tools/isoc/main.c').write_text(planted)
    # As make links it: all objects of isoc but that of main.c.
    objects = [path for path in glob.glob('build/obj/tools/isoc/**/*.o', recursive=True) + glob.glob('build/obj/tools/isoc/*.o') if not path.endswith('/main.o')]
    program = tmp_path / 'requests'
    subprocess.run(['gcc', '-std=c11', '-O0', '-D_POSIX_C_SOURCE=200809L', '-DISO_REAL_DOUBLE', '-I', tmp_path, '-I', ROOT, 'tests/host/requests.c',
                    *dict.fromkeys(objects), '-lm', '-o', program], check=True)
    process = Requests(tmp_path_factory.mktemp)
    process.end()
    process.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    first, second, *_ = (outcome(process.ask, call, n, bad, tmp_path) for n, call in enumerate(CALLS[:2]))
    process.end()
    assert first[0] == 0 and second[1].startswith('isoc: error: more than one scene')
