"""An input with a value is an input of the FMU, which begins with it; one that is a function of time is local."""
import pytest
from importer import OK, Instance

SCENE = '''step 1 ms
body b {{ mass 1 kg }}
joint j prismatic {{ parent ground; child b; axis x; spring 10 N/m; drive push }}
input push = {}
input level {} in 0 to 1
effect pull {{ joint along; signal level; effort on along = level * 2 N; output level }}
effect p pull {{ along j; level level }}
output x = position of j
output shown = p.level
'''
TICKS = 100


def run(fmu, first=None, level=None):
    """The hash of a run, and what it shows at its start and its end; `first` sets an input before the start, `level` after it."""
    plant = Instance(fmu)
    if first is not None:
        assert fmu.version == 2 or plant.set_name('level', first) == OK
    assert plant.enter() == OK
    if first is not None and fmu.version == 2:
        assert plant.set_name('level', first) == OK
    assert plant.leave() == OK
    places = fmu.references(['shown'])
    start = plant.get(places)
    assert level is None or plant.set_name('level', level) == OK
    for _ in range(TICKS):
        assert plant.step(0.001) == OK
    shown = start + plant.get(places)
    made = plant.hash()
    plant.free()
    return made, shown


@pytest.mark.parametrize('version', [2, 3])
def test_value(fmu, version):
    by_value, by_hand = (fmu(SCENE.format('0.5 N', level), version) for level in ('= 0.25', ''))
    level, push = by_value.by_name['level'], by_value.by_name['push']
    assert level.causality == push.causality == 'input'
    assert float(level.start) == 0.25 and float(push.start) == 0.5 and float(by_hand.by_name['level'].start) == 0
    assert run(by_value)[1] == [0.25, 0.25]
    assert run(by_value) == run(by_hand, first=0.25)
    assert run(by_value, first=0.75) == run(by_hand, first=0.75)
    assert run(by_value, level=0.75)[1] == [0.25, 0.75]
    assert run(by_value, level=0.75)[0] == run(by_hand, level=0.75)[0] != run(by_value)[0]


@pytest.mark.parametrize('version', [2, 3])
def test_zero_beyond_the_limits(fmu, version):
    """An input without a value begins at the limit that is nearest to zero."""
    model = fmu(SCENE.format('0.5 N', '').replace('in 0 to 1', 'in 0.5 to 1'), version)
    assert float(model.by_name['level'].start) == 0.5
    assert run(model)[1] == [0.5, 0.5] and run(model) == run(model, first=0.5)


@pytest.mark.parametrize('version', [2, 3])
def test_function_of_time(fmu, version):
    model = fmu(SCENE.format('0.5 N * sin(3 Hz)', '= 0.25'), version)
    assert model.by_name['push'].causality == 'local' and model.by_name['level'].causality == 'input'
    plant = Instance(model)
    assert plant.begin() == OK and plant.set_name('push', 1.0) != OK
    plant.free()


@pytest.mark.parametrize('version', [2, 3])
def test_control(fmu, version):
    """Found: an instance that begins with zeros."""
    model = fmu(SCENE.format('0.5 N', '= 0.25'), version, change=lambda text: text.replace('R(0.0) : fmu_starts[i]', 'R(0.0) : R(0.0)'))
    assert run(model)[1] != [0.25, 0.25]
