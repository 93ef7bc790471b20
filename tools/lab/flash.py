"""isochron flash: writes the program of a scene into a real board, and starts it there."""
import os

from . import build


def run(options):
    port = build.port(options.target, options.real or 'float')
    if not port.flash:
        boards = [name for name in build.targets() if build.port(name).flash]
        raise build.Wrong(f'--target {options.target} is no real board; these are: {" ".join(boards)}')
    # Until reset, unless a time was asked for.
    seconds = str(build.nanoseconds(options.seconds)) if options.seconds else '0'
    bench = build.plant(options, run_ns=seconds)
    build.need(bench.port.flash_tools.split(), bench.port.install)
    print(build.call(['sh', '-c', f'exec {bench.port.flash}'],
                     env={**os.environ, 'FROM': f'{build.ROOT}/', 'PROGRAM': str(bench.program.absolute())}), end='')
