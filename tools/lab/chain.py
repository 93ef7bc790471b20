"""The scene of a hanging chain of uniform rods of 1 kg and 1 m, 20 mm thick. All joints of a planar chain turn about z;
those of a spatial one about z and x in turn.

    python3 tools/lab/chain.py LENGTH planar|spatial
"""
import sys

HEAD = '''\
# A {kind} chain of uniform rods: {length}.

gravity (0, -9.81, 0) m/s^2
step 1 ms
method rk4

constant radius = 10 mm
constant long = 1 kg * radius^2 / 2
constant across = 1 kg * ((1 m)^2 / 12 + radius^2 / 4)

{first}

repeat i from 1 to {pairs} {{
{even}
{odd}
}}
{last}

output tip = position of rod{length} at (0, -1, 0) m
output energy = energy
'''


def rod(index, axis, parent, start):
    """A rod and its joint, with indices as isoc has them."""
    return (f'    body rod{index} {{ mass 1 kg; com (0, -0.5, 0) m; inertia (across, long, across) }}\n'
            f'    joint j{index} revolute {{ parent {parent}; child rod{index}; axis {axis}; start {start} deg }}')


def scene(length, kind):
    axis = {'planar': 'z', 'spatial': 'x'}[kind]
    return HEAD.format(
        kind=kind, length=length, pairs=(length - 1) // 2,
        first=rod(1, 'z', 'ground', 90),
        even=rod('[2 * i]', axis, 'rod[2 * i - 1] at (0, -1, 0) m', 0),
        odd=rod('[2 * i + 1]', 'z', 'rod[2 * i] at (0, -1, 0) m', 0),
        last='' if length % 2 else rod(length, axis, f'rod{length - 1} at (0, -1, 0) m', 0))


if __name__ == '__main__':
    if len(sys.argv) != 3 or not sys.argv[1].isdigit() or sys.argv[1] == '0' or sys.argv[2] not in ('planar', 'spatial'):
        sys.exit(f'usage: {sys.argv[0]} LENGTH planar|spatial')
    sys.stdout.write(scene(int(sys.argv[1]), sys.argv[2]))
