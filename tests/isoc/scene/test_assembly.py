"""Where two ways to assemble a loop meet, its start is a double root: found to the rounding, not to its root, and said; where loops have a
freedom, or meet what no start can tell apart, that is said instead. `isochron run` shows what was assembled."""
import pathlib
import re


def slider_crank(crank, pin, guide, sides='a'):
    """A crank of 153 mm and a rod of 306 mm, with these properties of their joints; one for each side."""
    return 'step 1 ms\n' + ''.join(f'''body crank_{side} {{ mass 38 g; inertia (1, 1, 1) * 1e-4 kg*m^2 }}
body rod_{side} {{ mass 38 g; inertia (1, 1, 1) * 1e-4 kg*m^2 }}
body slider_{side} {{ mass 76 g }}
joint shaft_{side} revolute {{ parent ground; child crank_{side}; axis z; {crank} }}
joint pin_{side} revolute {{ parent crank_{side} at (153, 0, 0) mm; child rod_{side}; axis z; {pin} }}
joint guide_{side} prismatic {{ parent ground; child slider_{side}; axis x; {guide} }}
close piston_{side} line {{ parent slider_{side}; child rod_{side} at (306, 0, 0) mm; axis z }}
''' for side in sides) + 'output place = position of guide_a\n'


def said(isoc, scene):
    """All that isoc says, and what it tells as assembled, by name."""
    made = isoc(scene, '--real', 'double')
    return made.printed + made.errors, {name: float(value) for name, value in re.findall(r'^assembled (\w+) (\S+)', made.printed, re.M)}


def is_line(line, text):
    return re.search(f'^{line}$', text, re.M)


def test_a_dead_centre_is_found_and_said(isoc):
    """The outer one, likewise from where no gap is left, the inner one, and two at once."""
    text, at = said(isoc, slider_crank('start about 20 deg', '', 'start 459 mm'))
    assert is_line('dead_position shaft_a pin_a', text) and abs(at['shaft_a']) < 1e-12
    text, at = said(isoc, slider_crank('', '', 'start 459 mm'))
    assert is_line('dead_position shaft_a pin_a', text) and 'pin_a' not in at and 'state_bytes' in text
    text, _ = said(isoc, slider_crank('start about 170 deg', 'start about 170 deg', 'start 153 mm'))
    assert is_line('dead_position shaft_a pin_a', text)
    text, at = said(isoc, slider_crank('start about 20 deg', '', 'start 459 mm', 'ab'))
    assert is_line('dead_position shaft_a pin_a shaft_b pin_b', text) and max(abs(at['shaft_a']), abs(at['shaft_b'])) < 1e-12


def test_beside_a_dead_centre_there_are_two_ways_and_one_is_found(isoc):
    """10 um beside it; a freedom is no dead centre."""
    text, at = said(isoc, slider_crank('start about 20 deg', '', 'start 458.99 mm'))
    assert 'dead_position' not in text and 'state_bytes' in text and 0.001 < at['shaft_a'] < 0.1
    text, _ = said(isoc, slider_crank('start about 20 deg', '', ''))
    assert 'leave 1 of 3 coordinates undetermined' in text


def test_a_distance_that_is_the_least_possible_one_is_found_and_said(isoc):
    """As the axle of a car axis has it."""
    text, at = said(isoc, '''step 1 ms
body left { mass 1 kg }
body right { mass 1 kg }
joint strut prismatic { parent ground; child left; axis y; start 0.5 m }
body hub { mass 1 kg }
joint swing revolute { parent ground at (1, 0, 0) m; child hub; axis z; start 0 rad }
joint leg prismatic { parent hub; child right; axis y }
close axle distance { parent left; child right; length 1 m }
output place = position of leg
''')
    assert abs(at['leg'] - 0.5) < 1e-9 and is_line('dead_position leg', text)


def test_a_flat_parallelogram_has_one_freedom_and_two_ways_to_move(isoc):
    text = pathlib.Path('models/parallelogram.scene').read_text()
    flat = re.sub(r'^ *(start|speed) .*\n', '', re.sub('^stabilisation .*', 'stabilisation baumgarte', text, flags=re.M), flags=re.M)
    assert 'leave 1 of 3 coordinates undetermined' in said(isoc, flat)[0]
    held = re.sub('^(joint crank_shaft.*)$', r'\1 start 0 deg', flat, flags=re.M)
    assert 'ways to move meet at the start, where the constraints have rank 1, and 2 beside it' in said(isoc, held)[0]


def test_a_run_shows_what_was_assembled(isochron, tmp_path):
    (tmp_path / 'shown.scene').write_text(slider_crank('', 'start about 90 deg', 'start 400 mm'))
    assert re.search(r'^assembled shaft_a [-0-9.]+ rad$', isochron('run', tmp_path / 'shown.scene', '--seconds', '0.01').printed, re.M)
