"""Programs of plants whose equations are in reach of a test (order/plant.c), and what they put right after a step
(order/settled.c)."""
import re

import pytest

from harness.programs import REPORT


@pytest.fixture(scope='session')
def of_plant(program):
    """of_plant(plant, source, ...): the program of these sources with the plant in this file. Kernels of which the compiler
    knows neither recipe nor n are not unrolled."""
    def make(plant, *sources, real='double', flags=(), by='clang', level='-O0'):
        words = [f'-DPLANT="{plant}"', '-DISO_UNROLL=', *flags]
        return program(*sources, REPORT, 'core/numbers/self_check.c', real=real, by=by, level=level, flags=words)

    return make


@pytest.fixture(scope='session')
def settled(of_plant):
    """settled(plant, source, flag ...): likewise with what the plant puts right after a step."""
    def make(plant, source, *flags, by='clang'):
        pivots = re.search(r'^    real pivots\[(\d+)\];$', plant.read_text(), re.M)
        told = [f'-DPIVOTS={pivots[1]}'] if pivots else []
        return of_plant(plant, 'tests/core/methods/order/settled.c', source, flags=[*flags, *told], by=by)

    return make
