"""The local error that a method tells, beside the true one: of every method on the double pendulum; and of checked methods
where it is hard to tell: long steps in chains and close encounters, and steps whose end is put onto closures."""
import pytest

from harness.project import ROOT
from lab import chain

HERE = 'tests/core/methods/estimate/'
OURS = [HERE + 'local_error.c', 'tests/core/methods/order/plant.c', 'tests/core/methods/order/double_pendulum.c']


@pytest.mark.parametrize('real', ('double', 'float'))
def test_every_method_on_the_double_pendulum(isoc, of_plant, proves, real):
    """A plant of an implicit method has a Jacobian for all. Articulated bodies round less: more errors are more than
    rounding."""
    made = isoc(ROOT / 'models/double_pendulum.scene', '--real', real, '--method', 'bdf4', '--formulation', 'articulated')
    plant = made.folder / 'plant.c'
    proves(of_plant(plant, HERE + 'estimate.c', 'tests/general.c', *OURS, real=real, by='gcc', level='-O1'))
    proves(of_plant(plant, HERE + 'adams.c', *OURS, real=real, by='gcc', level='-O1'))


@pytest.mark.parametrize('name, method, runs', (
    # Chains of rods that fall from the horizontal.
    ('triple', 'bdf4', ['5 200 heun rk4 ab4 abm4 bdf4 rosenbrock adams -- adams_formula']),
    ('chain', 'rk4', ['3 200 heun rk4 ab4 abm4 adams -- adams_formula']),
    ('pleiades', '', ['3 1000 heun rk4 ab4 abm4 adams -- adams_formula']),
    # With a projection. The top turns at 150 rad/s: Milne's estimate needs shorter steps there.
    ('spatial', 'bdf4', ['1 1000 heun rk4 ab4 abm4 bdf4 rosenbrock adams -- unsettled']),
    ('heavy_top', 'bdf4', ['0.3 2000 heun rk4 ab4 rosenbrock adams -- unsettled abm4 abm4_pec',
                           '0.1 16000 abm4 abm4_pecece bdf4'])))
def test_where_it_is_hard_to_tell(isoc, settled, proves, name, method, runs):
    scenes = {'triple': lambda: chain.scene(3, 'planar'), 'chain': lambda: chain.scene(30, 'planar'),
              'spatial': lambda: ROOT / 'tests/core/methods/order/spatial.scene', 'heavy_top': lambda: ROOT / HERE / 'heavy_top.scene'}
    plant = ROOT / HERE / 'pleiades.c' if name == 'pleiades' else \
        isoc(scenes[name](), '--real', 'double', '--method', method).folder / 'plant.c'
    free = ['-DSETTLE=NULL'] if name in ('triple', 'chain', 'pleiades') else []
    program = settled(plant, HERE + 'mechanisms.c', *free)
    for words in runs:
        proves(program, *words.split())


@pytest.mark.parametrize('method', ('rk4', 'abm4', 'bdf4', 'adams'))
def test_the_estimate_is_an_output_of_every_kind_of_method(isoc, program, method):
    text = (ROOT / HERE / 'heavy_top.scene').read_text() + '\noutput error = local_error\n'
    made = isoc(text, '--real', 'double', '--method', method)
    program(made, by='clang', real='double', flags=['-fPIC'], link=['-shared'])
    assert 'error' in made.file('plant.h').lower()
