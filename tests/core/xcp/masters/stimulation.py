"""What the steps of a plant take of the packets of a stimulation: an interpreter of core/xcp/README.md, and a random master."""
import random
import struct

import a2l
import master

LAYOUTS = [[["force"], ["push"]], [["push", "force"]], [["push"]], [["force"], ["push", "push"]]]
PATIENCE = {"force": 5}  # ticks behind which the scene has a safe value


class Inputs:
    """A list of some tables of inputs. `whole` and `missed` are what the slave counts."""

    def __init__(self):
        self.tables, self.whole, self.missed = None, 0, 0

    def start(self, tables):
        self.tables, self.due, self.coming, self.held, self.new, self.age = tables, 0, [], None, False, 0

    def stop(self):
        self.tables = None

    def packet(self, table, values, is_long_as_said):
        if self.tables is None or not 0 <= table < len(self.tables):
            return
        if table == 0:
            self.due, self.coming = 0, []
        if table != self.due or not is_long_as_said:
            self.due = None  # until a first one comes
            return
        self.coming += list(zip(self.tables[table], values))
        self.due = table + 1
        if self.due == len(self.tables):
            self.held, self.new, self.due = dict(self.coming), True, None
            self.whole += 1

    def step(self, own):
        """The inputs of a step whose own are these."""
        if self.tables is None:
            return own
        self.age = 0 if self.new else self.age + 1
        self.missed += not self.new
        self.new = False
        held = self.held or {}
        return {name: held[name] if name in held and not self.age >= PATIENCE.get(name, 1 << 40) else own[name] for name in own}


class RandomMaster:
    """What it sends to the slave, it tells the interpreter."""

    def __init__(self, x, A2L, seed):
        self.x, self.A2L, self.chance, self.inputs, self.first = x, A2L, random.Random(seed), Inputs(), 0

    def entry(self, name):
        address, kind = self.A2L.measurements["u." + name][:2]
        return address, a2l.SIZES[kind]

    def value(self):
        kind = self.chance.random()
        return float("nan") if kind < 0.05 else 400.0 if kind < 0.1 else self.chance.randrange(-80, 81) / 4

    def start(self):
        tables = self.chance.choice(LAYOUTS)
        self.first = self.x.stimulate([[self.entry(name) for name in table] for table in tables])
        self.inputs.start(tables)

    def send(self, table, wrong=0):
        kind = self.A2L.measurements["u.force"][1]
        count = len(self.inputs.tables[table]) if self.inputs.tables and table < len(self.inputs.tables) else 1
        values = [self.value() for _ in range(count)]
        data = struct.pack("<%d%s" % (count, kind), *values)
        data = data + b"\1" if wrong == 1 else data[:-1] if wrong == 2 else data
        self.x.put(bytes([self.first + table]) + data)
        self.inputs.packet(table, values, wrong == 0)

    def sample(self):
        for table in range(len(self.inputs.tables or [0])):
            self.send(table)

    def act(self):
        """Something between two steps; the slave has seen it when this is over."""
        kind = self.chance.random()
        if kind < 0.35:
            self.sample()
        elif kind < 0.45:
            self.sample(), self.sample()
        elif kind < 0.55:
            for _ in range(self.chance.randrange(1, 4)):
                self.send(self.chance.randrange(3), self.chance.choice([0, 0, 0, 1, 2]))
        elif kind < 0.58:
            self.x.stop()
            self.inputs.stop()
        elif kind < 0.62:
            self.start()
        self.x.status()


def tried(x, A2L, link, plant, ticks, seed):
    """Outputs and end of a run that is stimulated, and of one whose controller gives what the interpreter says; the counts of the
    slave and of the interpreter."""
    def count():
        return [struct.unpack("<Q", x.read(A2L.all["statistics.xcp_" + name][0], 8))[0] for name in ("stimuli", "missed")]

    random_master, own, taken = RandomMaster(x, A2L, seed), random.Random(seed + 1), []
    before = count()
    rows = [link.start("lockstep")]
    random_master.start()
    for tick in range(ticks):
        if not 40 <= tick % 60 < 52:  # for as long as no input has patience
            random_master.act()
        given = {"force": own.randrange(-40, 41) / 4, "push": own.randrange(-8, 9) / 4}
        taken.append(random_master.inputs.step(given))
        rows.append(link.exchange(**given))
    x.stop()
    ends = [link.stop()]
    counted = [after - earlier for after, earlier in zip(count(), before)]
    again = [link.start("lockstep")]
    again += [link.exchange(**inputs) for inputs in taken]
    ends.append(link.stop())
    same = ("hash", "inputs_held", "inputs_clamped", "ticks")
    return rows == again and all(ends[0][n] == ends[1][n] for n in same), counted, [random_master.inputs.whole, random_master.inputs.missed]


def refused(x, A2L):
    """What cannot be a stimulation is refused; the error of each."""
    def error(tables, mode=0x02, prescaler=1):
        x.ask(0xD6)
        x.ask(0xD5, "xH", 1)
        x.ask(0xD4, "xHB", 0, len(tables))
        for number, table in enumerate(tables):
            x.ask(0xD3, "xHBB", 0, number, len(table))
        for number, table in enumerate(tables):
            x.ask(0xE2, "xHBB", 0, number, 0)
            for address, size in table:
                x.ask(0xE1, "BBBI", 0xFF, size, 0, address)
        try:
            x.ask(0xE0, "BHHBB", mode, 0, 0, prescaler, 0)
            x.ask(0xDE, "BH", 1, 0)
        except master.Refused as e:
            return str(e)
        return "nothing"

    address, kind = A2L.measurements["u.force"][:2]
    size = a2l.SIZES[kind]
    state = A2L.measurements["x.rail"][0]
    return [error([[(address, size)]], 0x12), error([[(address, size)]], 0x02, 2), error([[(state, size)]]),
            error([[(address, size // 2)]]), error([[(address, 2 * size)]]), error([17 * [(address, size)]]),
            error(12 * [[(address, size)]]), error([[(address, size)]])] == [
        "MODE_NOT_VALID", "OUT_OF_RANGE"] + 5 * ["DAQ_CONFIG"] + ["nothing"]
