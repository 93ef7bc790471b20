"""The addresses of an A2L: a symbol that the program does not have, has twice, or of which it has fewer bytes is told."""
import pytest

from lab import a2l
from lab.build import Wrong

PROGRAM = a2l.Addresses([('memory_float', 0x20000000, 128), ('name', 0x100, 5), ('two_float', 1, 1), ('two_double', 2, 1),
                         ('far', 0xfffffff0, 32), ('iso_statistics', 0x20001000, 16)])


def test_filled():
    text = a2l.filled('EPK @name+0@ SIZE @bytes of memory@\n@memory+4@\n', PROGRAM, [], 'float')
    assert text == 'EPK 0x00000100 SIZE 0x80\n0x20000004\n'


@pytest.mark.parametrize('real, type', [('float', 'FLOAT32_IEEE'), ('double', 'FLOAT64_IEEE')])
def test_statistics(real, type):
    places = [('place__REAL__iso_statistics__error', 0, 9), ('choice__A_UINT64__absent__histogram', 0, 1),
              ('choice__A_UINT64__iso_statistics__margin', 0, 16), ('choice__A_UINT64__iso_statistics__beyond', 0, 17)]
    text = a2l.filled('@statistics@\n@names of statistics@\n', PROGRAM, places, real)
    assert f'MEASUREMENT statistics.error "statistic" {type} NO_COMPU_METHOD 0 0 -1e+38 1e+38\n      ECU_ADDRESS 0x20001008' in text
    assert 'statistics.margin "statistic" A_INT64 NO_COMPU_METHOD 0 0 -9223372036854775807 9223372036854775807' in text
    assert 'absent' not in text and 'beyond' not in text
    assert text.endswith('        statistics.error\n        statistics.margin\n')


@pytest.mark.parametrize('place, said', [
    ('@absent+0@', 'the program has 0 symbols absent, and not one'), ('@two+0@', 'the program has 2 symbols two, and not one'),
    ('@memory+128@', 'memory has 128 bytes, and nothing at 128'), ('@far+16@', 'far is beyond the 32 bits of an address of XCP'),
    ('@bytes of absent@', 'the program has 0 symbols absent')])
def test_refused(place, said):
    with pytest.raises(Wrong, match=said):
        a2l.filled(f'ECU_ADDRESS {place}\n', PROGRAM, [], 'float')
