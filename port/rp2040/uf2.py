"""Writes a program as UF2, for the boot loader of the RP2040, which shows itself as a drive: uf2.py PROGRAM.elf FILE.uf2

UF2 specification, Microsoft (2018): blocks of 512 bytes, each with 256 for flash, in the order of their addresses.
"""
import struct
import sys

PAGE, FLASH, FAMILY = 256, 0x10000000, 0xE48BFF56
START_1, START_2, END, HAS_FAMILY = 0x0A324655, 0x9E5D5157, 0x0AB16F30, 0x2000


def pages(program):
    """The bytes of the ELF file's segments, by pages of flash; a part that no segment has is 0."""
    first, = struct.unpack_from('<I', program, 28)
    size, count = struct.unpack_from('<2H', program, 42)
    kept = {}
    for at in range(first, first + size * count, size):
        kind, offset, _, address, length = struct.unpack_from('<5I', program, at)
        for i in range(length if kind == 1 else 0):
            page, place = divmod(address + i - FLASH, PAGE)
            kept.setdefault(page, bytearray(PAGE))[place] = program[offset + i]
    return kept


def uf2(program):
    kept = pages(program)
    return b''.join(struct.pack('<8I476sI', START_1, START_2, HAS_FAMILY, FLASH + PAGE * page, PAGE, number, len(kept),
                                FAMILY, bytes(kept[page]), END) for number, page in enumerate(sorted(kept)))


if __name__ == '__main__':
    with open(sys.argv[1], 'rb') as source:
        made = uf2(source.read())
    with open(sys.argv[2], 'wb') as target:
        target.write(made)
    print(f'{sys.argv[2]} {len(made) // 512} blocks')
