"""Random definitions with parts in one another, and the scene of the same effects in which none is a part."""
import random

HEAD = '''step 1 ms
body b { mass 1 kg }
joint rail prismatic { parent ground; child b; axis x; start 0.1 m; speed 1 m/s }
body w { mass 2 kg; com (0, 0.1, 0) m; inertia (1, 2, 3) g*m^2 }
joint hinge revolute { parent b; child w; axis z; start 0.5 rad }
'''
USES = {'one': '(speed of rail / 1 m * 1 s)', 'two': '0.3'}


class Kinds:
    """Kinds of effects: the first two have no parts, each later one has some of those before. All have the same operands,
    a fault `off`, and an output `y`."""

    def __init__(self, seed):
        self.seed, r = seed, random.Random(seed)
        self.names = [f'kind{i}' for i in range(r.randrange(4, 7))]
        self.parts = {name: [(f'part{n}', r.choice(self.names[:i])) for n in range(r.randrange(1, 4))] if i > 1 else []
                      for i, name in enumerate(self.names)}

    def numbers(self, *of):
        return random.Random(repr((self.seed, of))).choices(range(1, 9), k=4)

    def lines(self, kind, shown):
        """`shown` are the formulas of what its parts show."""
        a, b, c, _ = self.numbers(kind)
        inner = '(' + ' + '.join(f'{y} * 0.5' for y in shown) + ')' if shown else '0'
        return ['joint along', 'body place', 'signal x', 'value k', 'fault off',
                f'state z = 0.{a}; rate z = (x - z) * {b} Hz + {inner} * 1 Hz',
                'memory m = k; next m = 0.5 * m + x',
                'every 2 ms at 1 ms { let slow = x + 0.1 * m }',
                f'effort on along = -{c} N * (1 - off) * (position of along / 1 m + z + slow) * k',
                f'force on place = ((1 - off) * z * 0.{a} N, m * 0.1 N, 0)',
                f'output y = z + 0.{c} * m + {inner}',
                'loss = (1 - off) * 1 W * z^2']

    def given(self, kind, n):
        """The x and the factor of k that it gives its part number n."""
        a, b, _, d = self.numbers(kind, n)
        return f'(x * 0.{a} + 0.1 * z + previous(x) * 0.{b})', d / 4

    def scene(self):
        text = [HEAD]
        for kind in self.names:
            parts = [f'part {part} {inner} {{ along along; place place at (0.1, 0, 0) m; x {x}; k (k * {k}) }}'
                     for n, (part, inner) in enumerate(self.parts[kind]) for x, k in [self.given(kind, n)]]
            text += [f'effect {kind} {{', *self.lines(kind, [f'{part}.y' for part, _ in self.parts[kind]]), *parts, '}']
        text += [f'effect {use} {self.names[-1]} {{ along rail; place w; x {x}; k 0.5 }}' for use, x in USES.items()]
        return '\n'.join(text + self.outputs('.'))

    def flat(self):
        """Each part is an effect of the scene; what it reads of that which had it are outputs."""
        text = [HEAD]
        for kind in self.names:
            signals = [f'signal y{n}' for n, _ in enumerate(self.parts[kind])]
            gives = [f'output give{n} = {self.given(kind, n)[0]}' for n, _ in enumerate(self.parts[kind])]
            text += [f'effect {kind} {{', *signals, *self.lines(kind, [f'y{n}' for n, _ in enumerate(signals)]), *gives, '}']
        for use, kind, x, k, depth in self.uses():
            shown = ''.join(f'; y{n} {use}_{part}.y' for n, (part, _) in enumerate(self.parts[kind]))
            x = x if depth == 0 else '{}.give{}'.format(*x)
            text.append(f'effect {use} {kind} {{ along rail; place w at ({0.1 * depth}, 0, 0) m; x {x}; k {k}{shown} }}')
        return '\n'.join(text + self.outputs('_'))

    def uses(self):
        """The name in the flat scene, the kind, x or who gives it, k, and the depth."""
        found = []

        def visit(use, kind, x, k, depth):
            found.append((use, kind, x, k, depth))
            for n, (part, inner) in enumerate(self.parts[kind]):
                visit(f'{use}_{part}', inner, (use, n), k * self.given(kind, n)[1], depth + 1)
        for use, x in USES.items():
            visit(use, self.names[-1], x, 0.5, 0)
        return found

    def outputs(self, point):
        deepest = max((use for use, *_ in self.uses() if use.startswith('one')), key=len)
        loss = 'loss of one' if point == '.' else ' + '.join(f'loss of {use}' for use, *_ in self.uses() if use[:3] == 'one')
        return ['output both = one.y + two.y', f'output deep = {deepest.replace("_", point)}.y', f'output loss = {loss}', '']
