"""What plants side by side need stands in core/numbers/lanes.h and core/runtime/lanes.h: who reads a method or the loop
meets none of it."""
import pathlib
import re

HERE = {'core/numbers/lanes.h', 'core/runtime/lanes.h'}
SWITCHES = {'core/numbers/real.h': 1, 'core/numbers/sqrt.h': 2, 'core/runtime/plant.h': 1, 'core/runtime/tick.h': 1}
TABLES = {'core/methods/rosenbrock.h'}  # of numbers that are no quotients


def core():
    return {str(path): path.read_text() for path in sorted(pathlib.Path('core').glob('*/*.[ch]')) if str(path) not in HERE}


def switches(files):
    return {path: count for path, text in files.items() if (count := len(re.findall(r'\bISO_LANES\b', text)))}


def scalars(files):
    return {path for path, text in files.items()
            if path.startswith('core/methods/') and re.search(r'\b(iso_scalar|ISO_SCALAR)\b', text)}


def test_the_number_of_lanes_is_asked_for_in_few_places():
    assert switches(core()) == SWITCHES


def test_methods_compute_with_reals():
    assert scalars(core()) == TABLES


def test_found_a_method_with_lanes():
    files = core()
    files['core/methods/euler.h'] += '#ifdef ISO_LANES\n#endif\nstatic const iso_scalar half;\n'
    assert switches(files) != SWITCHES and scalars(files) == TABLES | {'core/methods/euler.h'}
