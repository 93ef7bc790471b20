"""The angle of a joint that turns without limit: by each method for a minute, and for a day."""
import pytest

from harness.programs import REPORT
from harness.project import ROOT

ROTOR = (ROOT / 'tests/promises/hard/rotor.scene').read_text()


@pytest.fixture
def rotor(isoc, program):
    """rotor(method, real, more in the joint): the program of rotor.c with this plant."""
    def call(method, real='float', more=''):
        tolerance = ['--tolerance', '1e-6'] if method == 'adams' else []
        made = isoc(ROTOR.replace('continuous', f'continuous; {more}'), '--real', real, '--method', method, *tolerance)
        assert made.status == 0, made.errors
        return program('tests/promises/hard/rotor.c', REPORT, made, real=real, by='clang', level='-O1')
    return call


# Those whose kernels differ; heun is by the kernel of rk4.
@pytest.mark.parametrize('method, real', [
    *((method, 'float') for method in 'euler rk4 semi_implicit ab4 abm4 bdf4 rosenbrock adams'.split()), ('ab4', 'double')])
def test_it_turns_at_several_speeds_for_a_minute(rotor, proves, method, real):
    proves(rotor(method, real), 60000, 'more')


@pytest.mark.parametrize('method', ['rk4', 'ab4', 'bdf4'])
def test_it_slows_down(rotor, proves, method):
    proves(rotor(method, more='damping 0.05 N*m*s/rad'), 60000, 'slows')


def test_it_turns_for_a_day(rotor, proves):
    proves(rotor('rk4'), 86400000)
