"""The machine whose cycles are counted: the board, its clock and memories, and the table of its core."""
import collections
import pathlib
import re

from lab import table
from lab.build import Wrong

CYCLES = pathlib.Path(__file__).resolve().parents[1] / 'measure/cycles'
Machine = collections.namedtuple('Machine', 'core hz board flash ram')


def boards():
    """All boards: name, target, core, clock, flash, RAM, and where that is published; the first of a target stands
    where no other is asked for."""
    return table.read(CYCLES / 'boards.txt', '|')


def cores(target):
    return sorted(path.stem for path in (CYCLES / 'cores').glob(f'{target}*.txt'))


def path_of(core):
    return CYCLES / 'cores' / f'{core}.txt'


def machine(target, core='', board='', clock=''):
    """That of a target, with another table, board or clock where these are asked for."""
    tables = cores(target)
    there = [row for row in boards() if row[1] == target]
    if not tables or not there:
        raise Wrong(f'cycles has no table for --target {target}: {why_none(target)}. It can be: '
                    + ' '.join(dict.fromkeys(row[1] for row in boards())))
    chosen = [row for row in there if not board or row[0] == board]
    if not chosen:
        names = ' '.join(row[0] for row in there)
        raise Wrong(f'--board {board} is unknown; of --target {target} it can be: {names}')
    name, _, its_core, its_clock, flash, ram, _ = chosen[0]
    core, clock = core or its_core, clock or its_clock
    if core not in tables:
        raise Wrong(f'--core {core} is no table of --target {target}; it can be: ' + ' '.join(tables))
    hz = hertz(clock)
    if not 1e3 <= hz <= 1e10:
        raise Wrong(f'--clock {clock} is no clock; it could be 168MHz, from 1kHz to 10GHz')
    return Machine(core, hz, name, int(flash), int(ram))


def why_none(target):
    if target in ('cortex-m33', 'cortex-m55'):
        return f'of the Cortex-M{target.removeprefix("cortex-m")} no published table of cycles is used here'
    if target.startswith('rv32'):
        return 'the cycles of a RISC-V core are a matter of its maker, and no published table of one is used here'
    if target.startswith('stm32'):
        return 'its core is a Cortex-M4F: --target cortex-m4f, with --board and --clock, counts the same code'
    return 'a processor with caches and a system beside the plant has none'


def hertz(text):
    """Of a number with a unit; 0 if it is none."""
    number = re.fullmatch(r'((?:\d+\.?\d*|\.\d+)(?:[eE]\d+)?) *([kMG]?)Hz', text)
    return float(number[1]) * {'': 1, 'k': 1e3, 'M': 1e6, 'G': 1e9}[number[2]] if number else 0
