"""--repair-inertia: the nearest tensor that a body has, about the same principal axes."""
import random

import numpy as np
import pytest

from write_robots import load_import

load_import()  # finds the modules of the program
import inertia  # noqa: E402

EDGES = np.array([[0, 1, 1], [1, 0, 1], [1, 1, 0]], float)  # moments of one second moment of mass each


def matrix(values):
    xx, yy, zz, xy, xz, yz = values
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def any_tensor(r):
    axes, _ = np.linalg.qr(np.array([[r.gauss(0, 1) for _ in range(3)] for _ in range(3)]))
    m = axes @ np.diag([r.uniform(-1, 3) for _ in range(3)]) @ axes.T
    return (m[0, 0], m[1, 1], m[2, 2], m[0, 1], m[0, 2], m[1, 2])


def fault(values, found):
    """What is wrong with it as the nearest point of a cone: it lies in it, what it is away has no part in any direction that
    stays in the cone, and none along itself."""
    axes = np.linalg.eigh(matrix(values))[1]
    turned = axes.T @ matrix(found) @ axes
    moments = np.diag(turned)
    if np.abs(turned - np.diag(moments)).max() > 1e-12:
        return 'it has other axes'
    second = moments.sum() / 2 - moments
    if second.min() < -1e-12:
        return 'no body has it'
    away = np.diag(axes.T @ matrix(values) @ axes) - moments
    return '' if (EDGES @ away).max() < 1e-12 and abs(away @ moments) < 1e-12 else 'another one is nearer'


@pytest.mark.seeds(200)
def test_it_is_the_nearest(seed):
    values = any_tensor(random.Random(seed))
    found = inertia.nearest_possible(values)
    assert fault(values, found) == ''
    assert inertia.excess(found) == 0 and not inertia.is_negative(found)
    moments = np.linalg.eigvalsh(matrix(values))
    assert inertia.is_negative(values) == (moments[0] < 0)
    if moments[0] > 0:
        assert abs(inertia.excess(values) - max(moments[2] / (moments[0] + moments[1]) - 1, 0)) < 1e-9


def test_found_others():
    values = (0.01, 0.03, 0.05, 0.0, 0.0, 0.0)
    assert fault(values, values) == 'no body has it'
    assert fault(values, (0.01, 0.03, 0.04, 0.0, 0.0, 0.0)) == 'another one is nearer'
    assert fault(values, (0.04 / 3, 0.1 / 3, 0.14 / 3, 0.0, 0.0, 1e-6)) == 'it has other axes'
    assert fault(values, (0.04 / 3, 0.1 / 3, 0.14 / 3, 0.0, 0.0, 0.0)) == ''
