"""A library of Arduino and its sketch, compiled with the flags of the core's own platform.txt, to which a user adds none:
no root comes from the C library. tests/use/firmware/test_arduino_all.py has all models and effects."""
from arduino import ROOTS, SKETCH, compiled, needs_the_core, package, wanted, with_effect
from harness.plants import replaced


@needs_the_core
def test_a_library_and_its_sketch_take_no_root_of_libm(isoc):
    folder = package(isoc, with_effect('contact'))
    (folder / 'sketch.cpp').write_text(SKETCH)
    for language, source in (('c', 'plant_of_it.c'), ('cpp', 'sketch.cpp')):
        said = compiled(folder, language, source, '-fno-lto')
        assert said.returncode == 0, said.stderr
    assert not wanted('avr-nm', folder / 'plant_of_it.c.o') & {'sqrt', 'sqrtf', 'errno'}
    assert 'plant_of_it_model' in wanted('avr-nm', folder / 'sketch.cpp.o')


@needs_the_core
def test_found_a_package_without_its_root(isoc):
    folder = package(isoc, ROOTS)
    root = folder / 'core/numbers/sqrt.h'
    root.write_text(replaced(r'#include "../../port/soft/own_root.h"\n', '', root.read_text()))
    compiled(folder, 'c', 'plant_of_it.c', '-fno-lto')
    assert wanted('avr-nm', folder / 'plant_of_it.c.o') & {'sqrt', 'sqrtf'}
