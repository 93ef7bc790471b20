"""isochron new: writes a first scene."""
import os

from . import build

SCENE = """# A pendulum of 1 m, let go at 90 degrees. Next: isochron run {file}, isochron show {file}
gravity (0, -9.81, 0) m/s^2
step 1 ms
method rk4
body bob {{
    mass 1 kg
    com (0, -1, 0) m
}}
joint pivot revolute {{
    parent ground
    child bob
    axis z
    start 90 deg
}}
output theta = position of pivot
output energy = energy
"""


def run(options):
    file = options.words[0] if options.words[0].endswith('.scene') else f'{options.words[0]}.scene'
    try:
        with open(file, 'x') as scene:
            scene.write(SCENE.format(file=file))
    except FileExistsError:
        raise build.Wrong(f'{file} is there already') from None
    except OSError as error:
        raise build.Wrong(f'{file}: {error.strerror}') from None
    print(f'scene {os.path.relpath(file)}')
