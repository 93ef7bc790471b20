"""`isochron functions`: the functions of core/numbers: domain, largest error, and the instructions of a call that is
inlined on the Cortex-M4F in float, with the constants that it loads, without those that load its arguments and keep its
result."""
import collections
import re

from lab import build, table

# The error is a bound that a test holds: a number, or the names of it in tests/core/numbers/exhaustive/HEADER.c.
Function = collections.namedtuple('Function', 'word header arguments value error float double outside')
FUNCTIONS = [Function(*row) for row in (
    ('sin and cos', 'sincos', 1, 'iso_sincos(x[0])', 'cosine_bound', 'up to 10,000', 'up to 10,000',
     'meaningless; NaN of an infinity and of a NaN'),
    ('exp', 'exp', 1, 'iso_exp(x[0])', 'bound', 'up to 87.33', 'up to 708.39',
     'the value at the end of the domain; of a NaN too, by its sign'),
    ('log', 'log', 1, 'iso_log(x[0])', 'bound', 'from 1.2e-38', 'from 2.2e-308',
     'below: the value there; below 0: NaN; of an infinity that of the largest number; of a NaN up to 0.7 more, or '
     'NaN, by its sign'),
    ('power', 'power', 2, 'iso_power(x[0], x[1])', '1 + 3 abs(y log x)', 'from 0', 'from 0',
     'of 0, and beyond exp: 0 or an infinity; below 0: NaN; of 0 to the power 0, an infinity or a NaN: NaN'),
    ('tanh', 'tanh', 1, 'iso_tanh(x[0])', 'bound', 'all', 'all', 'of a NaN 1, with its sign'),
    ('atan2', 'angle', 2, 'iso_atan2(x[0], x[1])', 'bound', 'all', 'all',
     'of two zeros: 0, or pi where x is -0, with the sign of y; of two infinities, or a NaN: NaN'),
    ('asin', 'angle', 1, 'iso_asin(x[0])', 'inverse_bound', 'up to 1', 'up to 1', 'NaN'),
    ('acos', 'angle', 1, 'iso_acos(x[0])', 'inverse_bound', 'up to 1', 'up to 1', 'NaN'),
    ('sqrt', 'sqrt', 1, 'iso_sqrt(x[0])', '0.5', 'from 0', 'from 0', 'NaN; -0 of -0'),
    ('1 / sqrt', 'root', 1, 'iso_inverse_root(x[0])', 'bound', 'from 4.0e-31', 'from 4.1e-292',
     'finite at and near 0; below: NaN; of an infinity 0; of a NaN: NaN'),
    ('floor', 'pieces', 1, 'iso_floor(x[0])', 'exact', 'all', 'all', 'an infinity and a NaN stay'),
    ('round', 'pieces', 1, 'iso_round(x[0])', 'exact', 'all', 'all', 'an infinity and a NaN stay'),
    ('sign', 'pieces', 1, 'iso_sign(x[0])', 'exact', 'all', 'all', 'of a NaN 1, with its sign'),
    ('abs', 'real', 1, 'iso_abs(x[0])', 'exact', 'all', 'all', 'of a NaN: NaN'),
    ('min, max', 'real', 2, 'iso_min(x[0], x[1])', 'exact', 'all', 'all', 'of a NaN: it or the other number'),
    ('max(x, 0)', 'real', 1, 'iso_positive(x[0])', 'exact', 'all', 'all', 'of a NaN: it or 0, by its sign'),
    ('min(x, 0)', 'real', 1, 'iso_negative(x[0])', 'exact', 'all', 'all', 'of a NaN: 0 or it, by its sign'),
    ('clamp', 'real', 3, 'iso_clamp(x[0], x[1], x[2])', 'exact', 'all', 'all', 'of a NaN: it or a limit'),
    ('comparison', 'real', 2, 'iso_above(x[0], x[1])', 'exact', 'all', 'all',
     'of a NaN, or of an infinity with itself: 0 or 1'),
    ('noise, once a tick', 'noise', 1, 'iso_noise(iso_bits_of(x[0]), 7)', 'mean 0, variance 1', 'all ticks', 'all ticks',
     ''),
    ('if', 'pieces', 3, 'iso_where(x[0], x[1]) + iso_unless(x[0], x[2])', 'exact', 'all', 'all',
     'a condition that is a NaN holds or does not'),
)]
PAIR = 'const iso_sine_cosine s = {}; y[0] = s.sin; y[1] = s.cos;'
CALL = '''\
void {name}(real *restrict const y, const real *restrict const x);
void {name}(real *restrict const y, const real *restrict const x)
{{
    {result}
}}
'''


def source():
    """C with each as a function f0, f1, ... of its arguments x."""
    headers = ['turns', *sorted({f.header for f in FUNCTIONS})]
    return ''.join(f'#include "core/numbers/{header}.h"\n' for header in headers) + ''.join(
        CALL.format(name=f'f{i}', result=(PAIR if f.header == 'sincos' else 'y[0] = {};').format(f.value))
        for i, f in enumerate(FUNCTIONS))


def counted(listing):
    """The instructions of each f of the output of objdump; lines of data and padding do not count."""
    count, name = collections.Counter(), ''
    for line in listing.splitlines():
        if label := re.match(r'[0-9a-f]+ <(f\d+)>:', line):
            name = label[1]
        elif re.match(r' +[0-9a-f]+:', line) and line.split()[2] not in ('.word', 'nop'):
            count[name] += 1
    return count


def bound(function):
    """The largest error, as the test of the whole domain has it."""
    if not function.error.endswith('bound'):
        return function.error
    text = (build.ROOT / f'tests/core/numbers/exhaustive/{function.header}.c').read_text()
    return re.search(rf'[ ,]{function.error} = ([0-9.]*)[,;]', text)[1].removesuffix('.0')


def rows(count):
    for i, f in enumerate(FUNCTIONS):
        # Its loads, its store and the return are not its own; sine and cosine have a second store.
        own = count[f'f{i}'] - f.arguments - 2 - (f.header == 'sincos')
        yield [f'`{f.word}`', f.float, f.double, bound(f) + (' of 1.0' if i == 0 else ''), f.outside, own]


def run(_):
    port = build.port('cortex-m4f')
    port.need_compiler()
    folder = build.ROOT / 'build/functions'
    folder.mkdir(parents=True, exist_ok=True)
    (folder / 'calls.c').write_text(source())
    build.call([*port.compile, '-c', folder / 'calls.c', '-o', folder / 'calls.o'], cwd=build.ROOT)
    count = counted(build.call([port.objdump, '-d', folder / 'calls.o']))
    table.show(['function', 'domain in float', 'in double', 'largest error, ulp', 'outside of the domain',
                'instructions'], rows(count), 'lllllr')
