"""Random scenes with blocks of a rate, and an interpreter of them that follows the meaning in tools/isoc/README.md row by row
and shares no code with isoc."""
import random

EACH = (1, 0)


def words_of(formula):
    """A formula as the scene has it: ('+', factor, a, b), ('previous', a), ('sample', n, a), ('name', text), ('time',) or
    a number."""
    kind = formula[0]
    if kind == '+':
        return f'({words_of(formula[2])} + {formula[1]} * {words_of(formula[3])})'
    if kind == 'previous':
        return f'previous({words_of(formula[1])})'
    if kind == 'sample':
        return f'sample({words_of(formula[2])}, every {formula[1]} ms)'
    return {'name': lambda: formula[1], 'time': lambda: '(time / 1 ms)', 'number': lambda: str(formula[1])}[kind]()


class Scene:
    """Things: (owner, name) -> (rate, formula), of signals with the owner None; memories likewise with a start. An
    effect's formulas name its own things, `x` is its operand, a formula of the scene, in which an output of an effect
    is EFFECT.NAME."""

    def __init__(self, seed):
        self.r = random.Random(seed)
        self.rates = [EACH] + [self.drawn_rate() for _ in range(2)]
        self.things, self.memories, self.operands, self.text = {}, {}, {}, []
        seen = []
        for i in range(self.r.randrange(3, 6)):
            seen.append(self.signal(i, seen) if self.r.random() < 0.4 else self.effect(i, seen))
        self.shown = [self.output(i, name) for i, name in enumerate(seen)]

    def drawn_rate(self):
        every = self.r.randrange(2, 8)
        return every, self.r.randrange(every)

    def formula(self, names, depth=0):
        kinds = ['name'] * 4 + ['+'] * 4 + ['time', 'number', 'previous', 'sample']
        kind = '+' if depth == 0 else self.r.choice(kinds if depth < 4 else ['name', 'time'])
        if kind == '+':
            return '+', self.r.choice([-0.5, 0.25, 0.5]), self.formula(names, depth + 1), self.formula(names, depth + 1)
        if kind == 'previous':
            return 'previous', self.formula(names, depth + 1)
        if kind == 'sample':
            return 'sample', self.r.randrange(1, 6), self.formula(names, depth + 1)
        if kind == 'name' and names:
            return 'name', self.r.choice(names)
        return ('number', self.r.randrange(-4, 5)) if kind == 'number' else ('time',)

    def within(self, rate, lines):
        """Lines in a block, which has no phase where that is 0."""
        phase = f' at {rate[1]} ms' if rate[1] else ''
        return lines if rate == EACH else [f'every {rate[0]} ms{phase} {{', *lines, '}']

    def signal(self, i, seen):
        rate, formula = self.r.choice(self.rates), self.formula(seen)
        self.things[None, f's{i}'] = rate, formula
        self.text += self.within(rate, [f'signal s{i} = {words_of(formula)}'])
        return f's{i}'

    def effect(self, i, seen):
        """Its own rate is that of its block; or the block of the scene has its use."""
        rate, is_used_in_block = self.r.choice(self.rates), self.r.random() < 0.3
        outer = self.r.choice(self.rates)
        names = ['x', 'm', 'n']
        used = rate if is_used_in_block else EACH
        self.operands[f'e{i}'] = used, self.formula(seen)
        lines = []
        for memory in 'mn':
            start, own = self.r.randrange(-3, 4), self.formula(names)
            next_of = '+', 0.5, ('number', 1), own
            self.memories[f'e{i}', memory] = rate, start, next_of
            lines += [f'memory {memory} = {start}', f'next {memory} = {words_of(next_of)}']
        inner = self.formula(names)
        self.things[f'e{i}', 'inner'] = rate, inner
        lines += [f'let inner = {words_of(inner)}']
        # Outside of the block of the effect, where that is its own.
        beside = used if is_used_in_block else self.r.choice([EACH, outer])
        shown = self.formula([*names, 'inner'])
        self.things[f'e{i}', 'y'] = beside, shown
        shows = [f'output y = {words_of(shown)}']
        body = lines + shows if is_used_in_block else self.within(rate, lines) + self.within(beside, shows)
        use = [f'effect e{i} kind{i} {{ x {words_of(self.operands[f"e{i}"][1])} }}']
        self.text += [f'effect kind{i} {{', 'signal x', *body, '}'] + (self.within(rate, use) if is_used_in_block else use)
        return f'e{i}.y'

    def output(self, i, name):
        rate = self.r.choice(self.rates)
        self.text += self.within(rate, [f'output o{i} = {name}'])
        return rate, ('name', name)

    def __str__(self):
        return '\n'.join(['step 1 ms', 'body b { mass 1 kg }',
                          'joint j prismatic { parent ground; child b; axis x }', *self.text, ''])


class Rows:
    """The outputs of rows 0, first + 1, first + 2, ..."""

    def __init__(self, scene, count, first=0):
        self.scene, self.kept, self.sampled, self.latest, self.before = scene, {}, {}, {}, {}
        self.numbers = {name: start for name, (_, start, _) in scene.memories.items()}
        self.row, rows = 0, []
        self.shown = [0.0] * len(scene.shown)
        self.end_of_row()
        self.before = dict(self.latest)
        rows.append(list(self.shown))
        for self.row in range(first + 1, first + count + 1):
            self.before.update({key: value for key, value in self.latest.items() if self.is_due(key[1])})
            after = {name: self.value(formula, name[0], rate) if self.is_due(rate) else self.numbers[name]
                     for name, (rate, _, formula) in scene.memories.items()}
            self.numbers = after
            self.end_of_row()
            rows.append(list(self.shown))
        self.rows = rows

    def is_due(self, rate):
        return self.row == 0 or self.row % rate[0] == rate[1]

    def end_of_row(self):
        """Held things, outputs and pasts, of the memories as they are now."""
        kept = {}
        for (owner, name), (rate, formula) in self.scene.things.items():
            if self.is_due(rate):
                kept[owner, name] = self.value(formula, owner, rate)
        self.kept.update(kept)
        for i, (rate, formula) in enumerate(self.scene.shown):
            if self.is_due(rate):
                self.shown[i] = self.value(formula, None, rate)
        self.remember()

    def remember(self):
        """What `previous` and `sample` keep of this row."""
        latest, sampled = {}, {}

        def visit(formula, owner, rate):
            if formula[0] == 'previous' and self.is_due(rate):
                latest[owner, rate, formula] = self.value(formula[1], owner, rate)
            if formula[0] == 'sample':
                sampled[owner, formula] = self.value(formula, owner, rate)
                rate = EACH
            for part in formula[1:]:
                if isinstance(part, tuple):
                    visit(part, owner, rate)
        for (owner, _), (rate, formula) in self.scene.things.items():
            visit(formula, owner, rate)
        for (owner, _), (rate, _, formula) in self.scene.memories.items():
            visit(formula, owner, rate)
        for owner, (rate, formula) in self.scene.operands.items():
            visit(formula, None, rate)
        self.latest.update(latest)
        self.sampled.update(sampled)

    def value(self, formula, owner, rate):
        """In this row, where it stands in the definition of `owner`, in a block of this rate."""
        kind = formula[0]
        if kind == '+':
            return self.value(formula[2], owner, rate) + formula[1] * self.value(formula[3], owner, rate)
        if kind == 'previous':
            key = owner, rate, formula
            return self.before[key] if key in self.before else self.value(formula[1], owner, rate)
        if kind == 'sample':
            is_due = self.is_due((formula[1], 0))
            return self.value(formula[2], owner, EACH) if is_due else self.sampled[owner, formula]
        if kind == 'name':
            return self.named(formula[1], owner, rate)
        return float(formula[1]) if kind == 'number' else float(self.row)

    def named(self, name, owner, rate):
        if name == 'x':
            of, formula = self.scene.operands[owner]
            return self.value(formula, None, of)
        owner, name = name.split('.') if '.' in name else (owner, name)
        if (owner, name) in self.numbers:
            return self.numbers[owner, name]
        of, formula = self.scene.things[owner, name]
        if of == EACH or of == rate or self.is_due(of):
            return self.value(formula, owner, of)
        return self.kept[owner, name]
