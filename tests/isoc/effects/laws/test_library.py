"""Every effect of the library, from its start on, against a law that is written apart from it, in one scene with rk4. In double
alone: in float the same text takes the same way (test_effects.py), and hides more behind its rounding."""
import shutil

import library
import pytest
from harness.plants import other_effect


def test_each_effect_has_a_law_and_each_of_its_outputs(tmp_path):
    assert library.kinds('models/effects') == []
    folder = tmp_path / 'effects'
    shutil.copytree('models/effects', folder)
    shutil.copy('models/effects/lag.scene', folder / 'planted.scene')
    with (folder / 'lag.scene').open('a') as file:
        file.write('output planted\n')
    assert library.kinds(folder) == ['no law of planted', 'no law of lag.planted']


@pytest.fixture(scope='module')
def rows(plant):
    return library.rows_of(plant(library.scene()).follow(8).rows['y'])


def test_each_effect_is_what_its_law_says(rows):
    _, found = library.compare(rows)
    assert not any(found.values()), found


@pytest.mark.parametrize('planted', ['late', 'factor'])
def test_a_defect_in_the_laws_is_found_in_each_output(rows, planted):
    assert library.not_found(rows, planted) == []


# A kind, what its definition says, and what it says instead.
DEFECTS = [
    ('battery', 'next before = charge', 'next before = previous(before)'), ('contact', 'arm = -radius', 'arm = radius'),
    ('dc_motor', r'resistance \* warmth \* current - back', 'resistance * current - back'), ('delayed', r'4 \* step', '3 * step'),
    ('encoder', r'floor\(position', 'round(position'), ('friction', r'0\.5 \* near\^2', '0.5 * abs(near)'),
    ('gusts', r'side_2 \+ x \* side', 'side_2'), ('imu', 'next turn = turned', 'next turn = turn'),
    ('jammed', r'next held = if\(active, held, position of along\)', 'next held = position of along'),
    ('rate_limit', '-fall, rise', '-rise, rise'), ('sensor', 'next sampled = now', 'next sampled = previous(now)'),
    ('stuck', r'next held = if\(active, held, input\)', 'next held = input')]


def test_a_defect_in_an_effect_is_found_in_it_and_in_no_other(plant):
    """All of them in one scene."""
    text = library.scene() + ''.join(other_effect(*defect) for defect in DEFECTS)
    _, found = library.compare(library.rows_of(plant(text).follow(8).rows['y']))
    assert {kind for kind, lines in found.items() if lines} == {kind for kind, *_ in DEFECTS}
