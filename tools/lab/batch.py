"""`isochron batch`: how many steps of a plant a core makes in a second: of one alone, and of 8, 16 and 32 side by side
(isoc --lanes), with all parts of a tick: checks of inputs, guard, outputs. Compiled for this processor, as the width of
its vectors matters. Beside them those of MuJoCo, where its library is installed, with the mechanism that isoc --mjcf
writes: RK4 of the same step, in double, without contact. Each is measured three times, in turns, and the best counts:
other work of the machine makes it slower, never faster."""
import os
import re
import subprocess

from lab import build, table
from lab.build import Wrong

LANES = 1, 8, 16, 32
MEASURE = build.ROOT / 'tools/measure'
EACH = os.environ.get('EACH', '0.2')  # seconds of a run


def program_of_mujoco(options, folder):
    """The command of a run by MuJoCo, of the mechanism as folder/mujoco.xml."""
    model, program, own = folder / 'mujoco.xml', folder / 'mujoco', MEASURE / 'mujoco.c'
    try:
        build.host_program(folder / 'headers', [own], ['-E'], (), stderr=subprocess.DEVNULL)
    except Wrong:
        raise Wrong('libmujoco is not installed (apt-get install libmujoco-dev)')
    written = subprocess.run([build.tools('isoc'), options.scene, '--mjcf', *build.isoc_options(options)],
                             capture_output=True, text=True)
    if written.returncode:
        raise Wrong(re.search('error: (.*)', written.stderr)[1])
    model.write_text(written.stdout)
    try:
        build.host_program(program, [own], (), ['-lmujoco', '-lm'], stderr=subprocess.STDOUT)
        build.call([program, model, 0], stderr=subprocess.STDOUT)
    except Wrong as wrong:
        raise Wrong(str(wrong) or 'it does not run')
    return [program, model]


def run(options):
    folder = build.outputs('batch', options.scene)
    plant = build.plant(options, 'none', folder, ['--lanes'])
    real = ['-DISO_REAL_DOUBLE'] if plant.real == 'double' else []
    commands, why = {}, ''
    for lanes in LANES:
        width = [f'-DISO_LANES={lanes}'] if lanes > 1 else []
        commands[str(lanes)] = [build.host_program(folder / f'batch_{lanes}', [MEASURE / 'batch.c'], [
            *real, '-march=native', '-Wno-psabi', *width, '-iquote', folder]).absolute()]
    try:
        commands['mujoco'] = program_of_mujoco(options, folder)
    except Wrong as wrong:
        why = str(wrong)
    best, hashes = {}, {}
    with build.progress('measures'):
        for name, command in [*commands.items()] * 3:
            _, steps, word = build.call([*command, EACH]).split()
            best[name] = max(best.get(name, 0), float(steps))
            hashes.setdefault(name, set()).add(word)

    def row(name, steps):
        times = steps / best['1']
        return [name, f'{steps / 1e6:.3g} million', f'{times:.2g}' if times < 1 else f'{times:.1f}']
    rows = [row(name, best[name]) for name in map(str, LANES)]
    if 'mujoco' in best:
        rows.append(row(f'MuJoCo {hashes["mujoco"].pop()}, one in double, RK4', best['mujoco']))
    table.show(['plants side by side', 'steps of a plant in a second', 'times one alone'], rows, 'rrr')
    if why:
        print(f'No row of MuJoCo: {why}.')
    elif left_out := re.match(r'<!-- [^;]*; (.*)\. -->', (folder / 'mujoco.xml').read_text()):
        print(f'MuJoCo runs without {left_out[1]}.')
    if len(set().union(*(hashes[name] for name in map(str, LANES)))) > 1:
        raise Wrong('a lane has other bits than the plant alone')
