"""A million packets that nobody should send, between the ticks of a plant; fewer under valgrind; and defects that they
find."""
import pytest
from plants import CART

from harness.programs import REPORT, run

SOURCES = ['tests/core/xcp/masters/malformed.c', REPORT, 'core/numbers/self_check.c',
           *(f'core/xcp/{name}.c' for name in ('access', 'daq', 'measure', 'stimulation', 'slave', 'transfer'))]
DENIED = ' ? ISO_XCP_ACCESS_DENIED : ISO_XCP_WRITE_PROTECTED;'


@pytest.fixture
def packets(isoc, program):
    return lambda level='-O2', planted=None: program(isoc(CART), *SOURCES, by='gcc', level=level, planted=planted)


def test_what_holds_of_every_packet_holds(packets, proves):
    proves(packets(), 1000000)
    proves('valgrind', '--quiet', '--error-exitcode=99', packets(), 20000)


@pytest.mark.parametrize('name, old, new', (
    ('access', DENIED, DENIED.replace('ISO_XCP_WRITE_PROTECTED', '(memcpy((uint8_t *)(uintptr_t)iso_xcp_at(access, address, count), '
                                      'bytes, count), ISO_XCP_NONE)')),
    ('access', 'x <= limits->most', 'x <= x'), ('access', 'i * sizeof(real) < offset + count; i++', 'i * sizeof(real) <= offset; i++'),
    ('stimulation', ' < access->input_count ?', ' < 10000 ?')))
def test_found(packets, name, old, new):
    """A download to all that can be read, limits that are not looked at, a download of which the first number is checked, a
    place of an input that is not looked at."""
    assert run(packets(planted={f'core/xcp/{name}.c': (old, new)}), 1000000).finds()
