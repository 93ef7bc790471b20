"""Scenes of random rods, and of random platforms on legs."""
import math
import random


def vector(x, y, z):
    return f'({x!r}, {y!r}, {z!r})'


def rods(seed):
    """3 to 8 random rods in a plane, each on one before it or on the ground: of any length, hung at an end along x, along -y or aslant, some
    with the centre of mass beside their line, some with an armature. Of a rod along an axis articulated bodies have simpler equations."""
    r = random.Random(seed)
    lines, ends = ['gravity (0, -9.81, 0) m/s^2\nstep 1 ms\nmethod rk4'], []
    for i in range(r.randint(3, 8)):
        size = r.uniform(0.2, 2)
        x, y = r.choice([(size, 0), (0.6 * size, -0.8 * size), (0, -size), (0, -size)])
        part, beside, mass = r.uniform(0.2, 0.8), 0.1 * size * (r.random() < 0.3), r.uniform(0.1, 10)
        parent = None if i == 0 or r.random() < 0.1 else r.randrange(i) if r.random() < 0.2 else i - 1
        place = 'ground' if parent is None else f'rod{parent} at {vector(*ends[parent], 0)} m'
        inertia = mass * size * size * r.uniform(0.05, 0.2)
        armature = f'; armature {r.uniform(0.01, 0.1)} kg*m^2' * (r.random() < 0.2)
        ends.append((x, y))
        lines += [f'body rod{i} {{ mass {mass} kg; com {vector(part * x + beside, part * y + beside, 0)} m; '
                  f'inertia {vector(0.6 * inertia, 0.6 * inertia, inertia)} kg*m^2 }}',
                  f'joint j{i} revolute {{ parent {place}; child rod{i}; axis z; start {r.uniform(-180, 180)} deg; '
                  f'speed {r.uniform(-3, 3)} rad/s{armature} }}']
    return '\n'.join(lines + ['output energy = energy']) + '\n'


class Platform:
    """A random platform on 2 to 6 legs, in a plane (odd seeds) or in space. A leg in the plane has two rods; one in space is a universal
    joint with a slide or, unless 4 divides the seed, three turns. Springs keep the knees bent. A closure has the platform as its parent
    or as its child. The platform may carry a pendulum, and stand on a carrier that moves."""

    def __init__(self, seed):
        self.r = r = random.Random(seed)
        in_plane = seed % 2
        legs, high = 2 + r.randrange(3 if in_plane else 5), r.uniform(0.5, 1)
        self.lines = [f'gravity {vector(0, -9.81, 0) if in_plane else vector(0, 0, -9.81)} m/s^2\nstep 1 ms\nmethod rk4']
        place = 'ground'
        if r.random() < 0.3:
            self.body('carrier', 3, 0.3, 'z')
            self.lines.append('joint rail prismatic { parent ground; child carrier; axis x; spring 500 N/m rest 0 m; start 0 m; speed 0.2 m/s }')
            place = 'carrier'
        self.body('platform', r.uniform(2, 10), 0.4, 'x' if in_plane else 'z')
        if in_plane:
            self.lines.append(f'''body nothing_x {{ mass 0 kg }}
body nothing_y {{ mass 0 kg }}
joint x prismatic {{ parent {place}; child nothing_x; axis x; start 0 m }}
joint y prismatic {{ parent nothing_x; child nothing_y; axis y; start 0 m }}
joint turn revolute {{ parent nothing_y; child platform; axis z; start 0 rad }}''')
        else:
            self.lines.append(f'joint afloat free {{ parent {place}; child platform; start at {vector(0, 0, high)} m quaternion (1, 0, 0, 0) }}')
        for n in range(legs):
            angle = 2 * math.pi * (n + r.uniform(-0.2, 0.2)) / legs
            far, near, beside = r.uniform(0.8, 1.2), r.uniform(0.2, 0.4), angle + r.uniform(-0.3, 0.3)
            foot, place = (far * math.cos(angle), far * math.sin(angle)), (near * math.cos(beside), near * math.sin(beside))
            if in_plane:
                self.plane_leg(n, *foot, *place)
            else:
                leg = self.slide_leg if seed % 4 == 0 or r.random() < 0.6 else self.turn_leg
                leg(n, *foot, *place, r.uniform(-0.1, 0.1), high)
        if r.random() < 0.4:
            self.body('bob', r.uniform(0.2, 1), 0.3, 'x')
            self.lines.append('joint swing revolute { parent platform; child bob; axis z; start -1 rad; speed 2 rad/s }')
        self.text = '\n'.join(self.lines + ['output energy = energy', 'output violation = violation']) + '\n'

    def body(self, name, mass, size, along):
        i, part = mass * size * size * self.r.uniform(0.05, 0.2), size * self.r.uniform(0.3, 0.7)
        com, inertia = ((part, 0, 0), (0.1 * i, i, i)) if along == 'x' else ((0, 0, part), (i, i, 0.1 * i))
        self.lines.append(f'body {name} {{ mass {mass} kg; com {vector(*com)} m; inertia {vector(*inertia)} kg*m^2 }}')

    def rods(self, n, size):
        for part in ('thigh', 'shin'):
            self.body(f'{part}{n}', self.r.uniform(0.1, 1), size, 'x')

    def closes(self, kind, n, on_platform, on_leg, axis=''):
        sides = [f'platform at {on_platform} m', f'shin{n} at {on_leg} m']
        parent, child = sides if self.r.random() < 0.5 else sides[::-1]
        self.lines.append(f'close end{n} {kind} {{ parent {parent}; child {child}{axis} }}')

    def knee(self, n, size, axis, angle):
        self.lines.append(f'joint knee{n} revolute {{ parent thigh{n} at {vector(size, 0, 0)} m; child shin{n}; axis {axis}; '
                          f'start about {angle} rad; spring 1 kN*m/rad rest {angle} rad }}')

    def bend(self, d):
        """The size of two rods whose ends are d apart, and how far their knee is bent."""
        size = d * self.r.uniform(0.55, 0.9)
        return size, 2 * math.atan2(math.sqrt(size**2 - d**2 / 4), d / 2)

    def plane_leg(self, n, x, y, u, v):
        """From a foot at x, y to a place on the platform at u, v."""
        size, bend = self.bend(math.hypot(u - x, v - y))
        self.rods(n, size)
        self.lines.append(f'joint hip{n} revolute {{ parent ground at {vector(x, y, 0)} m; child thigh{n}; axis z; '
                          f'start about {math.atan2(v - y, u - x) + bend / 2} rad }}')
        self.knee(n, size, 'z', -bend)
        self.closes('line', n, vector(u, v, 0), vector(size, 0, 0), '; axis z')

    def slide_leg(self, n, x, y, u, v, w, high):
        """From a foot at x, y, 0 to a place at u, v, w of the platform, which stands at 0, 0, high."""
        a, d = u - x, w + high
        length = math.sqrt(a * a + (v - y)**2 + d * d)
        self.body(f'thigh{n}', self.r.uniform(0.1, 1), 0.5 * length, 'z')
        self.body(f'shin{n}', self.r.uniform(0.1, 1), -0.5 * length, 'z')
        self.lines += [f'joint hip{n} universal {{ parent ground at {vector(x, y, 0)} m; child thigh{n}; axis x; second y; '
                       f'start rotate {math.atan2(y - v, d)} rad rotate {math.asin(a / length)} rad }}',
                       f'joint slide{n} prismatic {{ parent thigh{n}; child shin{n}; axis z; start {length} m; '
                       f'spring 2 kN/m rest {length} m; damping 5 N*s/m }}']
        self.closes('spherical', n, vector(u, v, w), vector(0, 0, 0))

    def turn_leg(self, n, x, y, u, v, w, high):
        flat = math.hypot(u - x, v - y)
        size, bend = self.bend(math.hypot(flat, w + high))
        self.body(f'hub{n}', self.r.uniform(0.1, 1), 0.1, 'x')
        self.rods(n, size)
        self.lines += [f'joint yaw{n} revolute {{ parent ground at {vector(x, y, 0)} m; child hub{n}; axis z; '
                       f'start about {math.atan2(v - y, u - x)} rad }}',
                       f'joint hip{n} revolute {{ parent hub{n}; child thigh{n}; axis y; start about {-math.atan2(w + high, flat) - bend / 2} rad }}']
        self.knee(n, size, 'y', bend)
        self.closes('spherical', n, vector(u, v, w), vector(size, 0, 0))
