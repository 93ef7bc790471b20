"""What the link takes of a tick beside the loop, on the Cortex-M4F in float: instructions, with one input and six
outputs. And the sizes that documents name."""
import pytest

from harness.programs import on_board, run
from harness.project import ROOT

FIRMWARE = [f'tests/{name}.c' for name in ('core/link/controllers/cost', 'tap')] + [
    f'core/{name}.c' for name in ('link/command', 'link/frame', 'runtime/loop', 'runtime/control', 'runtime/snapshot')] + [
    f'port/mps2/{name}.c' for name in ('port', 'console', 'semihosting', 'start')]


def words_of(document):
    """Of a document, wherever its lines end."""
    return ' '.join((ROOT / document).read_text().split())


@pytest.fixture
def beside(isoc, program, proves, laboratory):
    """beside(outputs): the instructions of the link, of a plant with so many outputs, all of the same speed."""
    lines = (ROOT / 'tests/promises/ticks/one.scene').read_text().splitlines()

    def of(outputs):
        text = [line for line in lines if not line.startswith('output')] + [f'output y_{i} = speed of pivot' for i in range(outputs)]
        made = isoc('\n'.join(text) + '\n', '--link')
        done = proves(*on_board(program(made, *FIRMWARE, target='cortex-m4f')))
        print('\n' + done.printed)
        return int(done.printed.split('# the link beside it ')[1].split()[0])

    return of


def test_the_link_takes_at_most_2200_instructions_of_a_tick_and_what_the_reference_says_of_a_byte(beside):
    """Control: eight outputs more."""
    six, fourteen = beside(6), beside(14)
    assert 0 < six <= 2200 < fourteen
    byte = (fourteen - six + 16) // 32
    assert f'So a byte of outputs takes {byte}. The second plant has eight outputs more.' in words_of('core/link/README.md')


def test_sizes_and_limits_in_the_documents_of_core_are_the_constants_of_the_code(program):
    texts = [line.split(' ', 1) for line in run(program('tests/core/link/controllers/limits.c')).printed.splitlines()]
    assert len(texts) == 14 and [text for document, text in texts if text not in words_of(document)] == []
    assert 'A packet of commands has up to 65 bytes (MAX_CTO)' not in words_of('core/xcp/README.md')
