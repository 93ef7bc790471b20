"""The generated tables in Markdown files are those that their commands print (tests/digits.md: tests/reference/*.t), and
`isochron tables` writes them again. What takes long is measured by turns: every eighth row of the tables of cost; two
lengths of chains; and the tables of drift and of bench whole, one at a time."""
# Depends on: *.md core port models tools Makefile
import pathlib
import re
import shlex

import pytest

from harness.project import ROOT, turn
from lab import tables
from lab.build import Wrong

FILES = [file for file in tables.FILES if file not in ('tests/digits.md', 'models/cycles.md')]
TURN = turn(8, pathlib.Path(__file__))
WHOLE = TURN is None
# The turns of what is measured whole.
TURNS_OF = {'bench models/double_pendulum': (1, 5), 'bench models/cart_pole': (2, 6), 'drift': (3, 7)}
LENGTHS = [8, 16] if not TURN else [TURN, 16 - TURN]


def written(text):
    """The rows that a Markdown file has of each command."""
    return {found[1]: [line for line in found[2].splitlines() if line.startswith(('|', '-'))] for found in tables.TABLE.finditer(text)}


COMMANDS = {command: (file, rows) for file in FILES for command, rows in written((ROOT / file).read_text()).items()}


def of_this_turn(command, rows):
    """Of the rows of a command, those that are measured."""
    if WHOLE or not command.startswith(('isochron cost', 'isochron chains')):
        return rows
    if command.startswith('isochron cost'):
        return rows[:2] + rows[2:][TURN::8]
    lengths = '|'.join(map(str, LENGTHS))
    growth = r'|- [a-z]*, 8 to 16 ' if TURN == 0 else ''
    return [row for row in rows if re.match(rf'[|-][^,]*, ({lengths}) |[|] chain|[|]---{growth}', row)]


@pytest.mark.parametrize('command', COMMANDS)
def test_the_table_is_what_its_command_prints(isochron, laboratory, command):
    words, rows = shlex.split(command)[1:], of_this_turn(command, COMMANDS[command][1])
    due = next((turns for head, turns in TURNS_OF.items() if command.removeprefix('isochron ').startswith(head)), (TURN,))
    if not WHOLE and TURN not in due or len(rows) <= 2:
        pytest.skip(f'it is not its turn, {TURN} of 8')
    if not WHOLE and words[0] == 'chains':
        words += ['--lengths', ' '.join(map(str, LENGTHS))]
    words = [ROOT / word if word.startswith('models/') else word for word in words]
    done = isochron(*words, **({} if WHOLE else {'TURN': f'{TURN}/8'}))
    assert done.status == 0, done.errors
    printed = [line for line in done.printed.splitlines() if line.startswith(('|', '-'))]
    assert printed == rows
    if words[0] == 'drift':
        # The picture beside the table, but for the name of the gnuplot that drew it.
        of = [re.sub('<desc>.*', '', path.read_text()) for path in (
            ROOT / 'models/pictures/four_bar_violation.svg', laboratory / 'build/drift/four_bar/violation.svg')]
        assert of[0] == of[1]


def test_found_one_thing_changed():
    """A digit of the last row that is measured, if one is, and that row left out."""
    for command, (file, rows) in COMMANDS.items():
        text = (ROOT / file).read_text()
        row = [row for row in of_this_turn(command, rows) if re.search('[a-z0-9]', row)][-1]
        for change in re.sub(r'[a-z0-9]([^a-z0-9]*)$', r'7x\1', row), '':
            changed = written(text.replace(row + '\n', change + '\n' if change else ''))
            assert of_this_turn(command, changed[command]) != of_this_turn(command, rows) or len(of_this_turn(command, rows)) == 2


@pytest.mark.parametrize('effect, most', [('friction', 85), ('stop', 150), ('lag', 30)])
def test_budgets(effect, most):
    """What the same takes that is written by hand."""
    step = re.search(rf'^[|] `{effect}` .*[|] \+(\d+) [|] [+-]\d+ [|]$', (ROOT / 'models/README.md').read_text(), re.M)
    assert 0 < int(step[1]) <= most


def test_only_what_is_between_the_lines_is_written(isochron, laboratory):
    methods = isochron('methods').printed.rstrip('\n')
    file = laboratory / 'good.md'
    file.write_text('one\n<!-- isochron methods -->\ntwo\n<!-- end -->\nthree\n')
    assert isochron('tables', 'good.md').printed == 'good.md is rewritten\n'
    assert file.read_text() == f'one\n<!-- isochron methods -->\n\n{methods}\n\n<!-- end -->\nthree\n'
    assert isochron('tables', 'good.md').printed == 'good.md is unchanged\n'


@pytest.mark.parametrize('text, said', [('<!-- isochron methodes -->\ntwo\n<!-- end -->\n', 'failed: isochron methodes'),
                                        ('<!-- isochron methods -->\ntwo\n', 'a table without an end')])
def test_found_what_fails(isochron, laboratory, text, said):
    (laboratory / 'bad.md').write_text(text)
    done = isochron('tables', 'bad.md')
    assert done.status == 1 and f'{said}; bad.md stays as it is' in done.errors and (laboratory / 'bad.md').read_text() == text
    with pytest.raises(Wrong):
        tables.rewritten(text)


def test_the_readme_begins_with_the_instructions_of_the_table():
    said = re.search(r': (\d+)\s+instructions a millisecond for a double pendulum', (ROOT / 'README.md').read_text())
    rows = [[cell.strip() for cell in line.split('|')[1:-1]] for line in COMMANDS['isochron cost --parts models'][1]]
    head, row = rows[0], next(cells for cells in rows if cells[0] == 'double_pendulum')
    assert said[1] == row[head.index('rk4')]
