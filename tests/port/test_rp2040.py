"""The Raspberry Pi Pico in its emulator: the bits of the host, one number of instructions, a controller on its serial line,
and the program as the boot ROM of the chip demands it."""
# Depends on: core port models tools Makefile
import re
import struct
import subprocess

import numpy
import pytest

from harness.project import ROOT, turn

from lab import build
from pico import PORT, copied, emulated, package  # noqa: F401


def checksum(data):
    """CRC-32/MPEG-2."""
    value = 0xFFFFFFFF
    for byte in data:
        value ^= byte << 24
        for _ in range(8):
            value = (value << 1 ^ (0x04C11DB7 if value >> 31 else 0)) & 0xFFFFFFFF
    return value


@pytest.fixture(scope='module')
def program(isochron, tmp_path_factory):
    """The program of the pendulum: as ELF, and as UF2 by `isochron flash` into a folder that stands for the drive."""
    drive = tmp_path_factory.mktemp('drive')
    done = isochron('run', ROOT / 'models/pendulum.scene', '--target', 'rp2040', '--seconds', 0.02, '--out', drive / 'elf')
    assert done.status == 0, done.errors
    flashed = isochron('flash', ROOT / 'models/pendulum.scene', '--target', 'rp2040', '--board', drive, '--out', drive / 'elf')
    assert flashed.status == 0, flashed.errors
    return drive / 'elf/program.elf', drive / 'program.uf2'


def test_the_second_stage_has_the_checksum_that_the_boot_rom_computes(program, tmp_path):
    assert checksum(b'123456789') == 0x0376E6E7      # of the catalogue of parametrised CRC algorithms
    flash = tmp_path / 'flash'
    subprocess.run(['arm-none-eabi-objcopy', '-O', 'binary', program[0], flash], check=True)
    stage = flash.read_bytes()[:256]
    assert checksum(stage[:252]) == struct.unpack('<I', stage[252:])[0]
    wrong = bytearray(program[1].read_bytes())
    wrong[32 + 8] ^= 1
    (tmp_path / 'wrong.uf2').write_bytes(wrong)
    done = emulated(tmp_path / 'wrong.uf2')
    assert done.returncode == 1 and b'checksum of the second stage is wrong' in done.stderr


def test_the_file_for_the_drive_has_the_bytes_of_the_program_in_whole_blocks(program, tmp_path):
    flash = tmp_path / 'flash'
    subprocess.run(['arm-none-eabi-objcopy', '-O', 'binary', program[0], flash], check=True)
    data, blocks = flash.read_bytes(), program[1].read_bytes()
    assert len(blocks) % 512 == 0
    count, held = len(blocks) // 512, b''
    for number in range(count):
        block = blocks[512 * number:512 * (number + 1)]
        magic, second, flags, address, size, at, total, family = struct.unpack_from('<8I', block)
        assert (magic, second, struct.unpack_from('<I', block, 508)[0]) == (0x0A324655, 0x9E5D5157, 0x0AB16F30)
        assert (flags, address, size, at, total, family) == (0x2000, 0x10000000 + 256 * number, 256, number, count, 0xE48BFF56)
        held += block[32:288]
    assert held == data.ljust(len(held), b'\0') and len(held) - len(data) < 256
    assert emulated(program[1]).stdout == emulated(program[0]).stdout != b''


@pytest.mark.parametrize('scene, method, real', [('double_pendulum', 'rk4', 'float'), ('cart_pole', 'bdf4', 'float'),
                                                 ('four_bar', 'euler', 'float'), ('pendulum', 'rk4', 'double')])
def test_a_plant_has_the_bits_of_the_host_and_one_number_of_instructions(isochron, scene, method, real):
    words = ['run', ROOT / f'models/{scene}.scene', '--method', method, '--real', real, '--seconds', 0.05]
    host, pico = isochron(*words), isochron(*words, '--target', 'rp2040')
    assert pico.status == 0, pico.errors
    assert pico.said['hash'] == host.said['hash']
    if scene == 'double_pendulum':
        assert isochron(*words, '--target', 'stm32f407').said['hash'] == host.said['hash']
    least, _, most, unit = pico.said['execution'].split()
    assert least == most and unit == 'instructions'
    assert pico.said['overruns'] == '0'


def test_a_controller_on_its_serial_line_gets_the_bits_of_the_host(isochron):
    host, pico = (isochron('hil', '--seconds', 0.1, '--target', target) for target in ('host', 'rp2040'))
    assert pico.said['link_inputs'] == '100' and pico.said['hash'] == host.said['hash']
    free = isochron('hil', '--seconds', 0.1, '--target', 'rp2040', '--mode', 'free')
    assert free.status == 1 and 'a controller runs with --mode lockstep' in free.errors


def test_the_port_keeps_its_duties(isochron):
    if turn(4) not in (None, 0):
        pytest.skip('its turn is another time')
    done = isochron('conform', '--target', 'rp2040')
    assert done.status == 0 and 'FAILED' not in done.printed, done.printed + done.errors
    duties = {line.split()[0]: line for line in done.printed.splitlines() if ' ok: ' in line}
    assert duties.keys() >= {'arithmetic', 'duration', 'stack', 'start', 'clock', 'wrap', 'tick', 'jitter', 'catching_up',
                             'interrupts', 'console', 'channel', 'exit', 'bits', 'count'}


@pytest.fixture(scope='module')
def mends(tmp_path_factory):
    """A program that meets what the emulator's package has otherwise than the chip."""
    folder, port = tmp_path_factory.mktemp('mends'), build.port('rp2040')
    sources = [ROOT / 'tests/port/rp2040_mends.c', *(PORT / name for name in ('start.c', 'console.c', 'boot2.S'))]
    subprocess.run([*port.compile, f'-I{ROOT}', *sources, *port.link[1:], '-o', folder / 'mends.elf'], check=True, cwd=ROOT)
    return folder / 'mends.elf'


FOUND = b'held_off 1\nstill_held 1\nalarms_early 0\nsystick_us 3000\nend\n'


@pytest.mark.parametrize('mend', [None, 'mendWaking(this.mcu.core);', 'mendSysTick(this.mcu, this);', 'mendAlarms(this.mcu);'])
def test_the_emulator_is_as_the_chip_and_without_a_mend_of_the_package_it_is_not(mends, tmp_path, mend):
    emulator = copied(tmp_path, mend)
    try:
        printed = emulated(mends, emulator=emulator, seconds=10).stdout
    except subprocess.TimeoutExpired:
        printed = b''
    assert (printed == FOUND) == (mend is None), printed


def test_without_the_package_the_command_that_installs_it_is_named(program, tmp_path):
    done = emulated(program[0], emulator=copied(tmp_path, package=False))
    assert done.returncode == 1 and re.search(rb'rp2040js 1\.4\.1 is missing\. Install it with: make build/rp2040js', done.stderr)


# Pins out and in, the value of a count, and where it is at the start: an encoder without an index counts from there.
CART = {'pole': (10, 6, 6.2831853e-4, 0.08726646), 'cart': (13, 8, 1.0e-4, 0.0)}
FAULT = '''effect reading stuck {
    input position of hinge
}
at 100 ms set reading.active = 1
at 115 ms set reading.active = 0
output shown = reading.value
'''


def row(kind, place, pin, at_0, at_1, safe='0.0'):
    return (f'{{.place = {place}, .kind = PINS_{kind}, .pin = {pin}, .at_0 = R({at_0}), .at_1 = R({at_1}), '
            f'.safe = R({safe})}}')


def test_a_controller_in_a_second_pico_joined_by_pins_alone_keeps_a_pole_upright(isochron, tmp_path):
    """Encoder edges go there, pulses come back. For 15 ms the encoder of the pole sticks."""
    seconds = 10 if turn(4) is None else 0.4
    scene = (ROOT / 'models/cart_pole.scene').read_text()
    scene = re.sub(r'^input force .*$', 'input force', scene, flags=re.M)
    outputs = scene.index('output ')
    (tmp_path / 'cart.scene').write_text(scene[:outputs] + FAULT + 'output place = position of rail\noutput pole = position of hinge\n')
    tables = {
        'plant': ([row('DUTY', 0, 3, '-20.0', '20.0')],
                  [row('QUADRATURE', place, out, 0.0, count) for place, (out, _, count, _) in enumerate(CART.values())]),
        'controller': ([row('QUADRATURE', place, pin, begin, begin + count) for place, (_, pin, count, begin) in enumerate(CART.values())],
                       [row('DUTY', 0, 14, '-20.0', '20.0', '0.5')])}
    for name, (inputs, shown) in tables.items():
        (tmp_path / f'{name}.h').write_text(f'#define PINS_INPUTS {", ".join(inputs)}\n#define PINS_OUTPUTS {", ".join(shown)}\n')
    made = isochron('run', 'cart.scene', '--target', 'rp2040', '--seconds', 0.001, cwd=tmp_path, CFLAGS='-include plant.h')
    assert made.status == 0, made.errors
    port = build.port('rp2040')
    files = ['tests/port/rp2040_controller.c', 'port/rp2040/boot2.S', 'port/soft/aeabi.c', 'port/soft/root.c']
    sources = [*(ROOT / file for file in files), *(path for path in PORT.glob('*.c') if path.name != 'channel.c')]
    subprocess.run([*port.compile, f'-I{ROOT}', '-include', tmp_path / 'controller.h', *sources, *port.link[1:], '-o',
                    tmp_path / 'controller.elf'], check=True, cwd=ROOT)
    wires = [f'{out + i}>{pin + i}' for out, pin, *_ in CART.values() for i in range(2)]

    (tmp_path / 'out').mkdir()

    def run(time, *joined):
        done = subprocess.run([ROOT / 'build/trace', '-o', tmp_path / 'out', '--clock', 'instructions', '--', 'node',
                               PORT / 'joined.mjs', tmp_path / 'build/rp2040/float/cart/program.elf', str(int(time * 1e9)),
                               tmp_path / 'controller.elf', *joined], capture_output=True, text=True)
        return done, numpy.genfromtxt(tmp_path / 'out/trace.csv', delimiter=',', names=True)
    done, trace = run(seconds, *wires, '3<14')
    assert done.returncode == 0 and 'overruns 0' in done.stdout, done.stdout + done.stderr
    assert len(set(trace['shown'][101:115])) == 1
    assert max(abs(trace['pole'])) < numpy.radians(5.1) and max(abs(trace['pole'][-20:])) < numpy.radians(2)
    # The control: without the encoder of the pole it falls.
    fell = run(0.4, *wires[2:], '3<14')[1]
    assert max(abs(fell['pole'])) > 0.3
