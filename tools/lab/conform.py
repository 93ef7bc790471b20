"""`isochron conform`: a line for each duty of a port; the status is 1 if one failed (port/README.md)."""
import os
import pathlib
import subprocess

from lab import build, stack
from lab.build import ROOT, Wrong

# The plants that are run on the host and on the target: scene, method, step.
PLANTS = [
    ('double_pendulum', 'rk4', None),
    ('cart_pole_drive', 'heun', None),
    ('four_bar', 'euler', '2ms'),
    ('rigid_body', 'rk4', None),
    ('cart_pole', 'bdf4', None),
]
DURATION = 9876543210  # ns, of which a port must give every digit to the program


def stack_of_step(**of):
    """The bytes that the compiler knows of; 0, if it knows none."""
    with build.overheard():
        try:
            plant = build.plant(ROOT / 'models/double_pendulum.scene', folder=pathlib.Path('build/conform/stack'), **of)
            return stack.depth(stack.of_plant(plant))
        except Wrong:
            return 0


def duties(folder, **of):
    """Tells what the program that tries the duties finds; whether the port has them all."""
    on_silicon = DURATION if of.get('board') else None
    plant = build.plant(ROOT / 'models/double_pendulum.scene', 'conform', folder, run_ns=on_silicon, **of)
    plant.port.need_runner()
    environment = {**os.environ, 'FROM': f'{ROOT}/', 'PROGRAM': str(plant.program.absolute()),
                   'NANOSECONDS': str(DURATION)}
    return subprocess.run([build.tools('duties'), str(stack_of_step(**of)), 'sh', '-c', f'exec {plant.port.exec}'],
                          env=environment).returncode == 0


def summaries(folder, name, method, step, seconds, targets, of):
    """Of a run of a plant on each of the targets; empty where there is none, which is told."""
    for target in targets:
        with build.overheard() as said:
            try:
                plant = build.plant(ROOT / f'models/{name}.scene', folder=folder / name / target, method=method,
                                    step=step,
                                    **{**of, 'target': target, 'board': of['board'] if target != 'host' else None})
                yield plant.run(seconds).summary
                continue
            except Wrong as wrong:
                said.seek(0)
                why = [line for line in f'{said.read()}{wrong}'.splitlines() if not line.startswith('  ')]
        print('\n'.join(why[:5]))
        yield {}


def run(options):
    target = options.target or 'host'
    of = {'target': target, 'real': options.real or 'float', 'board': options.board}
    folder = pathlib.Path('build/conform', target, of['real'])
    good = duties(folder, **of)
    different, counts, varying = [], [], []
    for name, method, step in PLANTS:
        on_host, there = summaries(folder, name, method, step, options.seconds, ('host', target), of)
        least, _, most, *_ = [*there.get('execution', '').split(), 'none', 'none', 'none']
        counts.append(f'{name} {least}')
        if there.get('hash') is None or there['hash'] != on_host.get('hash'):
            different.append(name)
        if least != most:
            varying.append(f'{name} {least} to {most}')
    print(f'bits FAILED: another hash than on the host: {" ".join(different)}' if different else
          f'bits ok: {len(PLANTS)} plants with the hash of the host')
    clock = build.port(target, of['real']).clock
    if clock not in ('instructions', 'cycles'):
        print(f'count has none: the clock counts {clock}')
    elif varying:
        print(f'count FAILED: {clock} of the steps: {" ".join(varying)}')
    else:
        print(f'count ok: {clock} of every step: {" ".join(counts)}')
    return not good or different != [] or clock in ('instructions', 'cycles') and varying != []
