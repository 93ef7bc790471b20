"""Tunables from which a number of the plant follows at compile time: a run cannot set them, and is told so."""
import pytest

SCENE = '''
step 1 ms
tunable rotor = 0.1 kg*m^2
tunable mass = 1 kg
tunable drag = 1 N*m*s/rad
body upper { rod 1 m of 1 kg at (0, 0, -0.5) m }
body lower { rod 1 m of mass at (0, 0, -0.5) m }
joint shoulder revolute { parent ground; child upper; axis y; damping drag }
joint elbow revolute { parent upper at (0, 0, -1) m; child lower; axis y; armature rotor }
effect block stop { along elbow; lower -90 deg; upper 90 deg; impact 3 rad/s }
output bend = position of elbow
'''


@pytest.mark.parametrize('tunable, is_built_in', [('rotor', True), ('mass', True), ('drag', False)])
def test_inertia_of_a_joint(isoc, tunable, is_built_in):
    """The stiffness of a stop follows from the inertia of its joint: from all of the mass matrix, as the armature of the
    last joint, which stands in one entry alone. Without the stop nothing does."""
    told = f"a number of the plant is made of '{tunable}'"
    assert (told in isoc(SCENE, '--vary', tunable).errors) == is_built_in
    free = SCENE.replace('effect block', '# effect block')
    assert told not in isoc(free, '--vary', tunable).errors
