"""isochron flags: PORT_OPTIMISE of a port is the optimisation with which a step takes least: on the Cortex-M4F by
cycles, on the host by instructions; -O2 where none takes much less. One of the two targets by turns."""
import pytest

from harness.project import ROOT, turn

# With and without effects, and with a closed loop.
MODELS = ' '.join(str(ROOT / f'models/{name}.scene') for name in ('double_pendulum', 'cart_pole_drive', 'four_bar'))


def least(head, relative, what):
    """The level that the last row recommends, by cycles or by instructions: -O2, or the least of those that take a
    twentieth less."""
    parts = {name.split(',')[0]: float(part) for name, part in zip(head, relative)
             if name.startswith('-O') and name.endswith(', cycles') == (what == 'cycles')}
    best = min(parts, key=parts.get)
    return best if parts[best] < 0.95 else '-O2'


@pytest.mark.parametrize('target, port, what, words', (
    ('cortex-m4f', 'cortex-m4f', 'cycles', []), ('host', 'host', 'instructions', ['--real', 'double'])))
def test_the_optimisation_in_use_is_the_one_that_the_table_recommends(isochron, target, port, what, words):
    now = turn(2)
    if now is not None and (target == 'host') != (now == 1):
        pytest.skip(f'the turn is {now}')
    of = isochron('flags', '--target', target, '--models', MODELS, *words)
    assert of.status == 0, of.errors
    head, relative = of.rows[0], of.rows[-1]
    from lab import build
    assert least(head, relative, what) == build.port(target, words[-1] if words else 'float').optimise
    assert least(head, relative[:-1] + ['0.5'], what) == '-O3'
    if target == 'cortex-m4f':
        said = (f'-Os takes {relative[5]} of the instructions of -O2 and {relative[6]} of its cycles, -O3 '
                f'{relative[8]} of its cycles')
        assert said in ' '.join((ROOT / 'port/README.md').read_text().split())


def test_another_target_is_refused(isochron):
    of = isochron('flags', '--target', 'cortex-m3')
    assert of.status == 1 and 'is of the host or the cortex-m4f' in of.errors
