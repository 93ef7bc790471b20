"""Every instruction of a core that a compiler may emit has a rule in its table of cycles (tools/measure/cycles/cores).

The instructions are found, not listed: encodings, all of 16 bits and many of 32 bits, are disassembled, and what comes
out is assembled again for the core. What the assembler takes is an instruction of the core, but for the few below."""
import functools
import pathlib
import random
import re
import struct
import subprocess
import tempfile

import pytest

CORES = pathlib.Path('tools/measure/cycles/cores')
FLAGS = {
    'cortex-m0': ['-mcpu=cortex-m0', '-mfpu=softvfp'], 'cortex-m0plus': ['-mcpu=cortex-m0plus', '-mfpu=softvfp'],
    'cortex-m3': ['-mcpu=cortex-m3', '-mfpu=softvfp'], 'cortex-m4f': ['-mcpu=cortex-m4', '-mfpu=fpv4-sp-d16'],
    'cortex-m7': ['-mcpu=cortex-m7', '-mfpu=fpv5-d16'],
}
# What is of a coprocessor, and what the assembler takes though cores of the profile M lack it.
NOT_OF_THE_CORE = re.compile(r'(ldc|stc|cdp|mcr|mcrr|mrc|mrrc)2?l?$|setend|f(ld|st)m(ia|db)x|v(ld|st)[1-4]\.')
OF_FPV5 = re.compile(r'vcvt[amnp]\.|v(max|min)nm|vsel|vrint|.*\.f64')
# Names that the disassembler has others for: of the same encodings, or of an operand, as `mov r1, r2, rrx`.
NEVER_PRINTED = set('ldm stm rsb vldm vstm adr rrx'.split())
IS_BRANCH = re.compile(r'(bl?|b(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)|cbn?z)([.][nw])?$')
HINTS = [0xBF00] * 8 + [0xBF10, 0xBF20, 0xBF30, 0xBF40]  # behind the last condition


def second_halves(chance):
    """Of encodings of 32 bits: at random, and a few registers with all operations between them."""
    some = [chance.randrange(1 << 16) for _ in range(24)]
    registers = (1, 1, 2), (15, 1, 2), (15, 0, 2), (0, 2, 1), (0, 15, 2), (1, 15, 3), (1, 15, 15), (8, 15, 15)
    some += [a << 12 | b << 8 | k << 4 | c for a, b, c in registers for k in range(16)]
    some += [0x8000 | n for n in (0, 1, 2, 3, 4, 0xF0)] + [0x8100, 0x8800, 0xF000, 0xF800, 0x9000, 0xB800]
    return some + [a << 12 | c << 8 | k << 4 for a in (0, 3, 15) for c in (10, 11) for k in (0, 1, 4, 8, 12)]


@functools.cache
def disassembled(seed):
    """The instructions that the encodings are, by their names: some of each, with their operands."""
    chance = random.Random(seed)
    halves = list(range(0xE800)) + HINTS
    for first in range(0xE800, 0x10000):
        for second in second_halves(chance):
            halves += (first, second)
    found = {}
    with tempfile.NamedTemporaryFile() as data:  # other workers of the tests disassemble too
        data.write(struct.pack(f'<{len(halves)}H', *halves))
        data.flush()
        for machine in ('armv7e-m', 'arm_any'):
            listing = subprocess.run(
                ['arm-none-eabi-objdump', '-D', '-b', 'binary', '-m', machine, '-M', 'force-thumb', data.name],
                capture_output=True, text=True, check=True).stdout
            for cells in (line.split('\t') for line in listing.splitlines()):
                if len(cells) > 2 and cells[2].strip():
                    text = ' '.join(cells[2:]).split('@')[0].split(';')[0].strip()
                    some = found.setdefault(cells[2].split()[0], [])
                    if len(some) < 12 and not re.search('UNDEF|unpred|<|VPR|r FPSCR', text):
                        some.append(text)
    return found


@functools.cache
def instructions(core, seed):
    """The names of those that the assembler takes for the core; branches go to what follows."""
    lines, names = ['.syntax unified', '.thumb'], {}
    for name, texts in disassembled(seed).items():
        for text in texts:
            lines.append(re.sub(r'0x[0-9a-f]+$', '.+4', text) if IS_BRANCH.match(name) else text)
            names[len(lines)] = name
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, 'all.s')
        source.write_text('\n'.join(lines) + '\n')
        said = subprocess.run(['arm-none-eabi-as', '-mthumb', *FLAGS[core], source, '-o', source.with_suffix('.o')],
                              capture_output=True, text=True).stderr
    wrong = {int(number) for number in re.findall(r':(\d+): Error', said)}
    lacks = OF_FPV5 if core == 'cortex-m4f' else re.compile('$^') if core == 'cortex-m7' else re.compile('v')
    return {name for line, name in names.items()
            if line not in wrong and not NOT_OF_THE_CORE.match(name) and not lacks.match(name)}


def unknown(table, names):
    return subprocess.run(['build/cycles', 'unknown', table], input='\n'.join(sorted(names)), capture_output=True, text=True,
                          check=True).stdout.split()


def rules(table):
    return [line.split('|')[0].split() for line in table.read_text().splitlines() if line.count('|') == 5 and line[0] != '#']


@pytest.mark.parametrize('core', FLAGS)
def test_every_instruction_has_a_rule(core, seed):
    names = instructions(core, seed)
    assert len(names) >= (60 if core.startswith('cortex-m0') else 150)
    assert unknown(CORES / f'{core}.txt', names) == []


@pytest.mark.parametrize('core', FLAGS)
def test_the_instructions_that_were_found_are_all(core, seed):
    """Each name of a rule is among them; so is `smulbb` where there is the DSP extension, and only there."""
    stems = {re.split('[.]', name)[0] for name in instructions(core, seed)} | instructions(core, seed)
    stems |= {stem.removesuffix('s') for stem in stems}
    unseen = {name for names in rules(CORES / f'{core}.txt') for name in names
              if not any(re.fullmatch(name.replace('.', r'[.]').replace('*', '.*'), stem) for stem in stems)}
    assert unseen <= NEVER_PRINTED
    assert ('smulbb' in stems) == (core in ('cortex-m4f', 'cortex-m7'))


@pytest.mark.parametrize('core', FLAGS)
def test_found_each_rule_that_is_taken_out(core, seed, tmp_path):
    """An instruction of each has no rule then: so no rule serves in the place of another."""
    table = CORES / f'{core}.txt'
    lines, less = table.read_text().splitlines(keepends=True), tmp_path / 'less.txt'
    names, found = instructions(core, seed), 0
    for i in (i for i, line in enumerate(lines) if line.count('|') == 5 and line[0] != '#'):
        less.write_text(''.join(lines[:i] + lines[i + 1:]))
        typed = all('.' in name for name in lines[i].split('|')[0].split())
        assert typed or unknown(less, names), lines[i]
        found += 1
    assert found >= 20


def avr_instructions(folder):
    """Of the AVR all encodings of 16 bits, in front of one that could be an address."""
    data = folder / 'encodings'
    data.write_bytes(b''.join(struct.pack('<HH', first, 0) for first in range(1 << 16)))
    listing = subprocess.run(['avr-objdump', '-D', '-b', 'binary', '-m', 'avr:51', data], capture_output=True, text=True, check=True).stdout
    return {cells[2].split()[0] for cells in (line.split('\t') for line in listing.splitlines())
            if len(cells) > 2 and cells[2].strip() and not cells[2].startswith('.')}


def test_every_instruction_of_the_avr_has_a_rule(tmp_path):
    """But for those that other cores have, and for spm of boot loaders, which takes as long as the flash."""
    names = avr_instructions(tmp_path)
    others = set(unknown(CORES / 'atmega1284p.txt', names))
    assert len(names) > 90 and others <= set('des eicall eijmp spm xch lac las lat'.split())
