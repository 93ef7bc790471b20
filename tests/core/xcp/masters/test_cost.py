"""What measurement and calibration cost a firmware: bytes, and instructions of a tick, on the Cortex-M4F in float."""
import re

import pytest
from plants import CART

from harness.programs import compiles, on_board, run
from harness.project import ROOT
from lab import build

SLAVE = [path for path in sorted((ROOT / 'core/xcp').glob('*.c')) if 'example' not in path.name]
PORT = [f'port/mps2/{name}.c' for name in ('port', 'console', 'semihosting', 'start')]


@pytest.fixture
def objects(laboratory, tmp_path):
    for source in SLAVE:
        compiles(*build.port('cortex-m4f').compile, '-c', source, '-o', tmp_path / f'{source.stem}.o')
    return sorted(tmp_path.glob('*.o'))


def test_not_more_than_7200_bytes_of_flash_and_2000_of_ram(objects):
    rows = [list(map(int, line.split()[:3])) for line in run('arm-none-eabi-size', *objects).printed.splitlines()[1:]]
    flash, ram = sum(row[0] + row[1] for row in rows), sum(row[1] + row[2] for row in rows)
    print(f'\n# flash {flash} bytes\n# ram {ram} bytes')
    assert flash <= 7200 and ram <= 2000


def test_the_slave_calls_nothing_but_isochron_memcpy_and_memset(objects):
    names = re.findall(r'^ +U (\S+)$', run('arm-none-eabi-nm', '-u', *objects).printed, re.M)
    assert names and [name for name in names if not re.fullmatch(
        'iso_[a-z0-9_]+|memcpy|memset|__aeabi_mem(cpy|set|clr)[48]?', name)] == []


def test_a_plant_with_a_link_that_was_not_asked_for_it_names_nothing_of_it(isoc):
    assert 'xcp' not in isoc(CART, '--link').file('interface.c').lower()
    assert 'xcp' in isoc(CART, '--link', '--xcp', 'open').file('interface.c')


def test_not_more_than_140_instructions_of_a_tick_when_nothing_is_connected_and_800_with_a_list_of_8_values(
        program, proves, laboratory):
    sources = [path for path in SLAVE if path.name != 'service.c']
    firmware = program(*sources, 'tests/core/xcp/masters/cost.c', 'tests/tap.c', 'tests/core/xcp/xcp/service.c', *PORT, target='cortex-m4f')
    printed = proves(*on_board(firmware)).printed
    print('\n' + printed)
    takes = {name: int(number) for name, number in re.findall(r'^# (.*) (\d+)$', printed, re.M)}
    assert takes['nothing connected'] <= 140 and takes['with a list of 8 values'] <= 800
