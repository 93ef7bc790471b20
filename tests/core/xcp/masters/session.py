"""A tool at a plant: connects, reads, writes and measures by the addresses of the A2L, while a controller makes the plant tick, in
lockstep. Prints TAP.

    session.py A2L FOLDER CONTROLLER CALIBRATION serial|socket|datagram|locked SECONDS

FOLDER has the controller's module; CONTROLLER and CALIBRATION are addresses of the plant's channels; SECONDS of the plant's time are
measured."""
import random
import struct
import sys

import a2l
import master
import stimulation

sys.path.insert(0, sys.argv[2])
import cart_link as plant  # noqa: E402

plant.TRIES = 10 ** 6

A2L, KIND, SECONDS = a2l.A2l(sys.argv[1]), sys.argv[5], int(sys.argv[6])
REAL = plant.REAL
tests = [0, 0]


def result(good, name):
    tests[0] += 1
    tests[1] += not good
    print("%s %d - %s: %s" % ("ok" if good else "not ok", tests[0], KIND, name), flush=True)


def refusal(call, *arguments):
    try:
        call(*arguments)
    except master.Refused as e:
        return str(e)
    return "nothing"


def new_master():
    return master.Master(sys.argv[4], KIND == "serial")


def read(x, name):
    address, kind = A2L.all[name][:2]
    return struct.unpack("<" + kind, x.read(address, a2l.SIZES[kind]))[0]


def write(x, name, value):
    address, kind = A2L.characteristics[name][:2]
    x.short_download(address, struct.pack("<" + kind, value))


def rounded(value):
    return struct.unpack(REAL, struct.pack(REAL, value))[0]


def identity(x):
    resource, mode, protocol, transport = x.connect()
    words = A2L.if_data["PROTOCOL_LAYER"]
    result((resource, mode & 0xC7, protocol, transport) == (13, 0xC0, 1, 1), "CONNECT: CAL, DAQ and STIM, little-endian, blocks")
    result([x.max_cto, x.max_dto] == [int(w) for w in words[8:10]], "the sizes of packets are those of the A2L")
    result(x.identity(1) == "cart" and x.identity(5) == A2L.epk, "the name of the A2L, and its EPK")
    result(x.read(A2L.epk_at, 16) == A2L.epk.encode(), "the EPK at ADDR_EPK")
    result(x.ask(0xC0, "B", 0) == b"\0\1\4\1\0" and int(words[0], 0) == 0x0104, "GET_VERSION: that of the A2L")
    result("unknown" in refusal(x.ask, 0xC0, "B", 1).lower(), "no other command of the second level")
    ticks, size, unit = A2L.if_data["TIMESTAMP_SUPPORTED"]
    granularity, largest, mode, count = struct.unpack("<BBBH", x.ask(0xD9)[2:7])
    result(size == "SIZE_DWORD" and mode & 7 == 4 and int(ticks) == count and unit == "UNIT_100NS" and mode >> 4 == 2
           and count * 100 == plant.PERIOD_NS, "the time stamp is that of the A2L: the step")
    width = struct.calcsize(REAL)
    result(granularity == largest == width and A2L.if_data["STIM"] == [
        "GRANULARITY_ODT_ENTRY_SIZE_STIM_" + ("DWORD" if width == 4 else "DLONG"), str(width)], "whole inputs, as the A2L says")
    event = A2L.if_data["EVENT"]
    properties, _, length, cycle, unit, _ = struct.unpack("<BBBBBB", x.ask(0xD7, "xH", 0))
    result(properties & 0x0C == 0x0C and event[3] == "DAQ_STIM" and A2L.inputs == ["u.force", "u.push"],
           "the event is of both directions, and the inputs can be written")
    result(x.upload(length).decode() == event[0].strip('"') and [cycle, unit] == [int(w) for w in event[5:7]],
           "the event is that of the A2L")


def uploads(x, link):
    """All that the A2L names, against what the controller sees."""
    y = link.start("lockstep")
    good = True
    for tick in range(1, 200):
        y = link.exchange(force=5.0)
        if tick % 40 == 0:
            good = good and all(read(x, "y." + name) == getattr(y, name) for name in plant.OUTPUTS)
            good = good and read(x, "x.rail") == y.cart_position and read(x, "x.hinge") == y.pole
            good = good and read(x, "u.force") == 5.0 and read(x, "statistics.tick") == tick
    result(good, "outputs, states, inputs and the tick are what the controller has")
    result(all(read(x, name) is not None for name in A2L.all), "all %d names of the A2L can be read" % len(A2L.all))
    starts = {"p.rod_mass": 0.2, "p.half_length": 0.25, "p.rail_damping": 0.1, "p.reading_active": 0.0}
    result({name: read(x, name) for name in A2L.characteristics} == {n: rounded(v) for n, v in starts.items()},
           "tunables and faults have the values of the scene")
    ranges = [A2L.characteristics[n][2:] for n in ("p.rod_mass", "p.half_length", "p.rail_damping")]
    result(ranges == [("kg", 0.05, 1.0), ("m", 0.1, 0.4), ("N*s/m", 0.0, 10.0)], "units and ranges are those of the scene")
    first = A2L.all["x.rail"][0]
    data = x.read(first, 40)
    crc = plant.crc16(data)
    result(x.checksum(first, 40) == (8, crc), "BUILD_CHECKSUM, while nothing ticks")
    link.stop()


def outputs_of_run(link, ticks, at=None, what=None):
    """The outputs of each tick; behind tick `at`, `what` is done."""
    rows = [link.start("lockstep")]
    for tick in range(1, ticks + 1):
        if tick - 1 == at:
            what()
        rows.append(link.exchange(force=5.0 if tick % 100 < 50 else -5.0))
    link.stop()
    return rows


def first_difference(a, b):
    return next((i for i in range(len(a)) if a[i] != b[i]), None)


def writes(x, link):
    free = outputs_of_run(link, 60)
    again = outputs_of_run(link, 60)
    changed = outputs_of_run(link, 60, 20, lambda: write(x, "p.rod_mass", 0.3))
    result(first_difference(free, again) is None and first_difference(free, changed) == 21,
           "a tunable that is written behind tick 20 takes effect in the step to tick 21")
    stuck = outputs_of_run(link, 60, 20, lambda: write(x, "p.reading_active", 1.0))
    result(len({row.seen for row in stuck[20:]}) == 1 and stuck[60].seen != free[60].seen and stuck[60].pole == free[60].pole,
           "so does a fault")
    names = ["p.rod_mass", "p.half_length", "p.rail_damping"]
    address, kind = A2L.characteristics[names[0]][:2]
    before = [read(x, n) for n in names]
    bad = refusal(x.download, address, struct.pack("<3" + kind, 0.4, 0.3, 11.0))
    result(bad == "OUT_OF_RANGE" and [read(x, n) for n in names] == before, "one number beyond its limits: none is set")
    bad = refusal(x.download, address, struct.pack("<3" + kind, 0.4, float("nan"), 1.0))
    result(bad == "OUT_OF_RANGE" and [read(x, n) for n in names] == before, "one that is no number: none is set")
    x.download(address, struct.pack("<3" + kind, 0.4, 0.3, 1.0))
    result([read(x, n) for n in names] == [rounded(v) for v in (0.4, 0.3, 1.0)], "three at once are set")
    result(refusal(x.short_download, A2L.all["x.rail"][0], b"\0" * 4) == "WRITE_PROTECTED", "a state is not written")
    result(refusal(x.read, 16, 4) == "ACCESS_DENIED", "other memory is not read")
    result(refusal(x.short_download, 16, b"\0" * 4) == "ACCESS_DENIED", "nor written")


def snapshots(x, link):
    """A snapshot of tick 30, to which the plant is put at tick 60: the controller goes along, and sees the same again."""
    def go(y, to):
        rows = []
        while y.tick < to:
            y = link.exchange(force=20 * y.pole + y.tick % 7)
            y.tick = link.tick
            rows.append(y)
        return rows

    def user(*words):
        answer, size, address = struct.unpack("<BxxII", x.ask(0xF1, *words)[:11])
        return answer, size, address

    y = link.start("lockstep")
    y.tick = 0
    y = go(y, 30)[-1]
    answer, size, address = user("B", 5)
    record = x.upload_from(address, size)
    first = go(y, 60)
    result(answer == 0 and record[:4] == b"ISOS" and user("BxxI", 8, size)[0] == 19,
           "a snapshot of %d bytes; a plant that does not rest is not put to it" % size)
    x.ask(0xF1, "B", 3)
    for at in range(0, size, 50):
        x.short_download(address + at, record[at:at + 50])
    result(user("BxxI", 8, size - 1)[0] == 3 and user("BxxI", 8, size)[0] == 0, "one that rests is")
    y = link.exchange(force=0.0)
    y.tick = link.tick
    result(y.tick == 30, "the controller is where its plant is")
    x.ask(0xF1, "BxxI", 2, 0)
    result(go(y, 60) == first, "and sees the same again")
    link.stop()


def measures(x, link):
    """Eight values and the tick at every tick; against what the controller has at that tick."""
    ticks = SECONDS * 1000000000 // plant.PERIOD_NS
    names = ["x.rail", "x.hinge", "y.cart_speed", "y.pole", "y.energy", "p.rod_mass", "u.force", "statistics.tick"]
    columns = [A2L.all[n] for n in names]
    table = [(c[0], a2l.SIZES[c[1]]) for c in columns]
    x.connect()  # resets what was measured
    y = link.start("lockstep", ticks)
    x.measure([table[:5], table[5:]])
    seen, y_of = [], [y]
    while y:
        y_of.append(y)
        seen += x.take_samples()
        y = link.exchange(force=20 * y.pole)
    x.status()  # its answer comes behind all samples
    seen += x.take_samples()
    y_of = y_of[1:]
    form = ["<BI" + "".join(c[1] for c in columns[:5]), "<B" + "".join(c[1] for c in columns[5:])]
    firsts = [struct.unpack(form[0], p) for p in seen if p[0] & 0x7F == 0]
    seconds = [struct.unpack(form[1], p) for p in seen if p[0] == 1]
    result(len(firsts) == len(seconds) == ticks, "a list of 8 values for %d s: %d samples of %d ticks" % (
        SECONDS, len(firsts), ticks))
    result([f[1] for f in firsts] == list(range(1, ticks + 1)) == [s[-1] for s in seconds] and all(f[0] == 0 for f in firsts),
           "every tick has its own, by time stamp and tick; none was lost")
    last = [(f[2:], s[1:]) for f, s in zip(firsts, seconds)][:len(y_of) - 1]
    good = all((f[0], f[1], f[3], f[4]) == (y.cart_position, y.pole, y.pole, y.energy)
               for (f, s), y in zip(last, y_of[1:]))
    result(good and len(last) > 0, "its values are those that the controller has at that tick")
    result(all((b - a) & 0xFFFF == 1 for a, b in zip(x.counters, x.counters[1:])), "no packet of the slave is missing")
    result(link.end["lost"] == link.end["overruns"] == 0, "the loop has lost no tick")
    x.stop()
    result(x.status()[0] == 0, "measurement stops")


def stimulates(x, link):
    ticks = 180 if KIND == "serial" else 360
    same, counted, expected = stimulation.tried(x, A2L, link, plant, ticks, 7)
    result(same, "%d ticks with a random stimulation: to the bit the run of what the meaning says" % ticks)
    result(counted == expected and expected[0] > ticks // 6 and expected[1] > ticks // 8,
           "%d samples were whole, %d steps had none: the slave has counted them" % tuple(expected))
    result(stimulation.refused(x, A2L), "what is no list of whole inputs without a stamp is refused")
    x.stop()


def damage(x, link):
    """Bytes that are no packets, and packets that are no commands, during a run: its hash stays, and so does the connection."""
    def run(disturb):
        y = link.start("lockstep", 400)
        while y:
            y = disturb(y) or link.exchange(force=20 * y.pole)
        return link.end["hash"]

    chance = random.Random(1)
    codes = [0xFA, 0xF5, 0xF4, 0xF3, 0xE2, 0xE1, 0xE0, 0xDE, 0xD3, 0xD4, 0xC0, 0x00, 0xF6]

    def garbage(_):
        if KIND == "serial" and chance.random() < 0.3:
            x.line.sendall(chance.randbytes(chance.randrange(1, 40)))
        packet = bytes([chance.choice(codes)]) + chance.randbytes(chance.randrange(0, 20))
        frame = bytearray(x.frame(packet))
        if KIND == "datagram" and chance.random() < 0.3:
            frame = frame[:chance.randrange(len(frame))] or b"\1"
        if KIND == "datagram" and chance.random() < 0.3:
            frame = bytes(frame) + x.frame(packet)
        if KIND == "serial" and chance.random() < 0.3:
            frame[chance.randrange(len(frame))] ^= 1 << chance.randrange(8)
        x.line.sendall(frame)
        x.get(0)

    plain = run(lambda _: None)
    result(plain == run(garbage), "400 ticks with garbage: the same hash")
    for _ in range(12):  # a claimed frame of 71 bytes is filled by nine of 8
        x.put(b"\xfc")
    while x.get() != b"\xfe\x00":
        pass
    x.put(b"\xff\x00")
    packet = x.get()
    while packet == b"\xfe\x00":
        packet = x.get()
    result(packet[0] == 0xFF and x.synch() and x.identity(1) == "cart", "then SYNCH and CONNECT are answered")


def leaves(x):
    """A master that goes in the middle of a frame."""
    x.line.sendall(x.frame(b"\xf0" + bytes(40))[:20])
    x.close()
    y = new_master()
    y.connect()
    result(y.identity(1) == "cart", "the next master is served when one has gone within a frame")
    return y


def policies(x):
    """The counts of a scene with a histogram, whose outputs come a tick later; in virtual time no step takes any."""
    x.connect()
    bins = ["statistics.histogram_%d" % i for i in range(32)]
    with plant.Link(sys.argv[3]) as link:
        for ticks in (70, 50):
            outputs_of_run(link, ticks)
            result([read(x, n) for n in bins] == [ticks] + 31 * [0] and read(x, "statistics.latency") == 1,
                   "the histogram has the %d ticks of this run" % ticks)
    result(read(x, "statistics.histogram_width") == plant.PERIOD_NS // 32, "and its width")


def takes_over(x):
    """Another master: what it sends before its CONNECT is not heard, and what the first sends behind that is not either."""
    y = new_master()
    y.patience = 0.2
    result(refusal(y.status) == "no answer" and x.synch(), "a second master is not heard before it connects")
    y.patience = master.PATIENCE
    y.connect()
    x.patience = 0.2
    result(y.identity(1) == "cart" and refusal(x.status) == "no answer", "then it is, and the first is not")
    x.close()
    y.line.sendall(y.frame(b"\xfc") + y.frame(b"\xfd"))
    result(y.get()[:2] == b"\xfe\x00" and y.get()[0] == 0xFF, "two packets in a datagram are two commands")
    return y


def locked(x):
    x.connect()
    result(x.status() == (0, 13), "what is locked is locked behind CONNECT")
    result(refusal(write, x, "p.rod_mass", 0.3) == "ACCESS_LOCKED" and refusal(x.measure, []) == "ACCESS_LOCKED",
           "without the key nothing is written or measured")
    result(read(x, "p.rod_mass") == rounded(0.2), "what it shows can be read")
    for resource in (1, 4, 8):
        x.unlock(resource, lambda seed: bytes(b ^ 0x5A for b in seed))
    write(x, "p.rod_mass", 0.3)
    result(read(x, "p.rod_mass") == rounded(0.3) and x.status() == (0, 0), "with the key it is")
    x.connect()
    result(refusal(x.unlock, 1, lambda seed: seed) == "ACCESS_LOCKED", "a wrong key is refused")


x = new_master()
if KIND == "locked":
    locked(x)
    policies(x)
else:
    with plant.Link(sys.argv[3]) as link:
        identity(x)
        uploads(x, link)
        writes(x, link)
        snapshots(x, link)
        measures(x, link)
        stimulates(x, link)
        damage(x, link)
        if KIND == "socket":
            x = leaves(x)
        if KIND == "datagram":
            x = takes_over(x)
        x.disconnect()
print("1..%d" % tests[0])
sys.exit(tests[1] > 0)
