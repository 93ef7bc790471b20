"""`isochron a2l`: a plant with a link, with measurement and calibration over XCP, and its A2L: the template that isoc
wrote, with the addresses of the linked program.

@SYMBOL+OFFSET@ in the template becomes a number, and so does @bytes of SYMBOL@. The symbols of the object of
tools/a2l/places.c list the statistics: place__ or choice__, type, symbol and name; choice__ are those that a program
may lack. Any other symbol that the program does not have, or has twice, is an error: then nothing is written.
"""
import pathlib
import re

from lab import build, link
from lab.build import ROOT, Wrong


def symbols(nm, file):
    """The (name, address, bytes) of each symbol that the file defines and that has a size."""
    lines = [line.split() for line in build.call([*nm.split(), '-S', '--defined-only', file]).splitlines()]
    return [(words[3], int(words[0], 16), int(words[1], 16)) for words in lines if len(words) == 4]


class Addresses:
    def __init__(self, symbols):
        self.of = {}
        for name, address, size in symbols:
            self.of.setdefault(re.sub('_(float|double)$', '', name), []).append((address, size))

    def size(self, symbol):
        return self.one(symbol)[1]

    def one(self, symbol):
        found = self.of.get(symbol, [])
        if len(found) != 1:
            raise Wrong(f'a2l: the program has {len(found)} symbols {symbol}, and not one')
        return found[0]

    def at(self, symbol, offset):
        address, size = self.one(symbol)
        if offset >= size:
            raise Wrong(f'a2l: {symbol} has {size} bytes, and nothing at {offset}')
        if address + offset > 0xffffffff:
            raise Wrong(f'a2l: {symbol} is beyond the 32 bits of an address of XCP')
        return f'0x{address + offset:08X}'


def statistics(addresses, places):
    """The (name, type, symbol, offset) of each statistic that the program has."""
    for place, _, size in places:
        sort, *of = place.split('__')
        if sort == 'place' or sort == 'choice' and of[1] in addresses.of and size <= addresses.size(of[1]):
            yield of[2], of[0], of[1], size - 1


def measurement(addresses, real, name, type, symbol, offset):
    if type == 'REAL':
        type, most = 'FLOAT64_IEEE' if real == 'double' else 'FLOAT32_IEEE', '1e+38'
    else:
        type = 'A_INT64' if name == 'margin' else type
        most = '9223372036854775807' if type == 'A_INT64' else '18446744073709551615'
    least = '0' if type == 'A_UINT64' else f'-{most}'
    return (f'    /begin MEASUREMENT statistics.{name} "statistic" {type} NO_COMPU_METHOD 0 0 {least} {most}\n'
            f'      ECU_ADDRESS {addresses.at(symbol, offset)}\n'
            '      /begin IF_DATA XCP /begin DAQ_EVENT FIXED_EVENT_LIST EVENT 0 /end DAQ_EVENT /end IF_DATA\n'
            '    /end MEASUREMENT')


def filled(template, addresses, places, real):
    """The A2L."""
    there = list(statistics(addresses, places))
    text = template.replace('@statistics@', '\n'.join(measurement(addresses, real, *one) for one in there))
    text = text.replace('@names of statistics@', '\n'.join(f'        statistics.{name}' for name, *_ in there))
    text = re.sub('@bytes of ([a-z_]+)@', lambda found: f'0x{addresses.size(found[1]):X}', text)
    return re.sub(r'@([a-z_]+)\+(\d+)@', lambda found: addresses.at(found[1], int(found[2])), text)


def write(plant):
    """Writes the A2L of a calibrated plant beside it; its path."""
    port, places = plant.port, plant.sources / 'places.o'
    build.call([*port.compile, '-c', 'tools/a2l/places.c', '-o', places.absolute()], cwd=ROOT)
    text = filled((plant.sources / 'plant.a2l.in').read_text(), Addresses(symbols(port.nm, plant.program)),
                  symbols(port.nm, places), plant.real)
    path = plant.folder / f'{pathlib.Path(plant.scene).stem}.a2l'
    build.write(path, text)
    return path


def run(options):
    plant = link.linked(options)
    path = write(plant)
    print(f'program {plant.program}\na2l {path}')
