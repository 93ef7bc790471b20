# The controller's end of a link to a plant: the same in all modules that isoc writes. Python 3 on POSIX, without other
# modules than those that come with it, over any stream of bytes; core/link/README.md has the frames.
#
# What is lost on the wire is sent again: a question after PATIENCE seconds, TRIES times.
import os
import select
import socket
import struct
import termios
import types

VERSION, PATIENCE, TRIES = 1, 0.5, 20
MODES = {"free": 0, "lockstep": 1}
REASONS = {
    1: "a frame of this type or length is not known",
    2: "another plant, method, step or type of numbers: make the module again",
    3: "there is no such mode",
    4: "no run has been started",
    5: "the program makes one run, and it has begun",
}
# Commands (core/link/command.h), states of a plant, and why a command was not done.
STATE, RUN, REST, RESET, TAKE, READ, WRITE, RESTORE = range(1, 9)
STATES = {0: "no run", 1: "runs", 2: "rests", 3: "stopped by the guard"}
PIECE = 128
ANSWERS = {
    1: "this is no snapshot",
    2: "the snapshot is of another version",
    3: "the snapshot is not whole",
    4: "the snapshot is damaged",
    5: "the snapshot has another type of numbers",
    6: "the snapshot is of another plant, method or step",
    7: "the snapshot has a number that no plant has",
    16: "there is no run",
    17: "the guard has stopped the plant",
    18: "a piece beyond the end",
}
# How a run went, in the order of the frame.
END = (
    "ticks late lost overruns restarts violated margin execution_min execution_max execution_sum restart_max "
    "inputs_held inputs_clamped tunables_held tunables_clamped outputs_held near_singular near_singular_first "
    "near_singular_closure guard tick adams_restarts substeps rejected budget_bound evaluations hash link_inputs "
    "link_late link_repeated link_stale link_missing link_safe link_damaged link_refused link_unsent"
).split()


class LinkError(Exception):
    """The plant has refused, or does not answer."""


def crc16(data):
    crc = 0xFFFF
    for byte in data:
        x = crc >> 8 ^ byte
        x ^= x >> 4
        crc = (crc << 8 ^ x << 12 ^ x << 5 ^ x) & 0xFFFF
    return crc


def cobs(data):
    out = bytearray()
    for part in data.split(b"\0"):
        while len(part) >= 254:
            out += b"\xff" + part[:254]
            part = part[254:]
        out += bytes([len(part) + 1]) + part
    return bytes(out)


def decobs(data):
    """None if a block ends behind the data."""
    out, at = bytearray(), 0
    while at < len(data):
        end = at + data[at]
        if data[at] == 0 or end > len(data):
            return None
        out += data[at + 1:end]
        if data[at] < 255 and end < len(data):
            out.append(0)
        at = end
    return bytes(out)


def frame(kind, payload=b""):
    data = kind.encode() + payload
    return b"\0" + cobs(data + struct.pack("<H", crc16(data))) + b"\0"


def connect(address):
    """A descriptor for unix:PATH, tcp:HOST:PORT, fd:NUMBER or the path of a device."""
    if address.startswith("unix:"):
        s = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        s.connect(address[5:])
        return s.detach()
    if address.startswith("tcp:"):
        host, port = address[4:].rsplit(":", 1)
        s = socket.create_connection((host, int(port)))
        s.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)  # each frame leaves at once
        return s.detach()
    if address.startswith("fd:"):
        return int(address[3:])
    file = os.open(address, os.O_RDWR | os.O_NOCTTY)
    if os.isatty(file):  # bytes as they are, at the speed that stty has set
        mode = termios.tcgetattr(file)
        mode[0] &= ~(termios.IGNBRK | termios.BRKINT | termios.PARMRK | termios.ISTRIP | termios.INLCR | termios.IGNCR
                     | termios.ICRNL | termios.IXON | termios.IXOFF)
        mode[1] &= ~termios.OPOST
        mode[2] = mode[2] & ~(termios.CSIZE | termios.PARENB) | termios.CS8 | termios.CLOCAL | termios.CREAD
        mode[3] &= ~(termios.ECHO | termios.ECHONL | termios.ICANON | termios.ISIG | termios.IEXTEN)
        termios.tcsetattr(file, termios.TCSANOW, mode)
    return file


class Link:
    """A link to the plant. The outputs have the names of the scene; so have the inputs of `exchange`."""

    def __init__(self, address=None):
        address = address or os.environ.get("ISOCHRON_LINK")
        if not address:
            raise LinkError("no address is given, and ISOCHRON_LINK has none")
        self.file = connect(address)
        self.tick = 0  # of the outputs
        self.mode = self.ticks = None
        self.outputs = None  # the latest, also those of the last tick
        self.end = None  # how the run went, once it is over
        self.inputs = dict.fromkeys(INPUTS, 0.0)
        self.sent, self.piece, self.pieces = b"", bytearray(), []
        self.number = 0  # of the last command

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.file)

    def start(self, mode="lockstep", ticks=0):
        """Starts a run of so many ticks, 0: until it is ended. Returns the outputs of tick 0."""
        self.end, self.mode, self.ticks, self.piece, self.pieces = None, mode, ticks, bytearray(), []
        while select.select([self.file], [], [], 0)[0] and os.read(self.file, 4096):
            pass
        self._send("s", struct.pack("<QBQ", IDENTITY, MODES[mode], ticks))
        outputs = self._await(0)
        if outputs is None:  # the end of a run that went on
            self.end = None
            outputs = self._await(0)
        return outputs

    def exchange(self, /, **inputs):
        """Sends the inputs, those that are not given as they were, and returns the next outputs, in a free run the
        latest; None if the run is over."""
        for name in inputs.keys() - self.inputs.keys():
            raise LinkError("no input is called %s; there are: %s" % (name, " ".join(INPUTS)))
        self.inputs.update(inputs)
        self._send("u", struct.pack("<Q%d%s" % (len(INPUTS), REAL), self.tick, *self.inputs.values()))
        outputs = self._await(self.tick + 1)
        while outputs is not None and self.mode == "free":
            data = self._receive(0)
            if data is None:
                break
            done, newer = self._take(data, self.tick + 1)
            outputs = newer if done else outputs
        return outputs

    def stop(self):
        """Ends the run. Returns how it went."""
        if self.end is None:
            self._send("e", b"")
            self._await(1 << 64)
        return self.end

    def run(self, ticks=0):
        """Runs for so many ticks, 0: without an end. This and what follows return how the plant is."""
        return self._do(RUN, struct.pack("<Q", ticks))

    def pause(self):
        return self._do(REST)

    def state(self):
        return self._do(STATE)

    def reset(self):
        """Begins a run in the mode of the last, also after the guard; the plant rests at tick 0. Returns its outputs."""
        return self._move(RESET)

    def snapshot(self):
        """Takes a snapshot. Returns it as bytes."""
        size, record = self._do(TAKE).snapshot_bytes, b""
        while len(record) < size:
            piece = self._ask(READ, struct.pack("<I", len(record)))
            if len(piece) <= 4 or struct.unpack("<I", piece[:4])[0] != len(record):
                raise LinkError("a piece of the snapshot is not that which was asked for")
            record += piece[4:]
        return record

    def restore(self, record):
        """Puts the plant to a snapshot of any plant of its kind; it rests there. Returns its outputs."""
        for at in range(0, len(record), PIECE):
            self._ask(WRITE, struct.pack("<I", at) + record[at:at + PIECE])
        return self._move(RESTORE, struct.pack("<I", len(record)))

    def _ask(self, command, payload):
        """The answer to a command, which is sent again until it comes."""
        self.number = self.number % 255 + 1
        self._send("c", bytes([command, self.number]) + payload)
        tries = 0
        while tries < TRIES:
            data = self._receive(PATIENCE)
            if data is None:
                tries += 1
                self._write()
            elif data[:1] == b"C" and data[1:3] == bytes([command, self.number]):
                if data[3] != 0:
                    raise LinkError("refused: " + ANSWERS.get(data[3], "not known"))
                return data[4:]
            else:
                self._take(data, 0)
        raise LinkError("the plant does not answer")

    def _do(self, command, payload=b""):
        """A command whose answer says how the plant is. The first of a link asks for that alone: then no number of a
        controller before is taken for one of this."""
        if self.number == 0 and command != STATE:
            self._do(STATE)
        state, tick, left, hash_so_far, size = struct.unpack("<BQQQI", self._ask(command, payload))
        return types.SimpleNamespace(state=STATES.get(state), tick=tick, left=left, hash=hash_so_far, snapshot_bytes=size)

    def _move(self, command, payload=b""):
        tick = self._do(command, payload).tick
        self.end = None
        return self._await(tick)

    def _send(self, kind, payload):
        self.sent = frame(kind, payload)
        self._write()

    def _write(self):
        """A plant that has closed the link may have said before how the run ended: what it sent is still to be read."""
        data = self.sent
        try:
            while data:
                data = data[os.write(self.file, data):]
        except (BrokenPipeError, ConnectionResetError):
            pass

    def _receive(self, patience):
        """The next whole frame; None after so many seconds without a byte. What is damaged is dropped."""
        while True:
            while self.pieces:
                data = decobs(self.pieces.pop(0))
                if data is not None and len(data) >= 3 and struct.pack("<H", crc16(data[:-2])) == data[-2:]:
                    return data[:-2]
            if not select.select([self.file], [], [], patience)[0]:
                return None
            try:
                data = os.read(self.file, 4096)
            except ConnectionResetError:
                data = b""
            if not data:
                raise LinkError("the plant has closed the link")
            pieces = (bytes(self.piece) + data).split(b"\0")
            self.piece = bytearray(pieces.pop())
            self.pieces += pieces

    def _take(self, data, least):
        """Whether it is what is waited for: outputs of a tick from `least` on, or, where those of the next tick are due, of
        an earlier one to which somebody else has put the plant; or the end, which is None."""
        kind, payload = data[:1], data[1:]
        if kind == b"y" and len(payload) == struct.calcsize("<Q%d%s" % (len(OUTPUTS), REAL)):
            tick, *values = struct.unpack("<Q%d%s" % (len(OUTPUTS), REAL), payload)
            if tick >= least or (least == self.tick + 1 and tick < self.tick):
                self.tick = tick
                self.outputs = types.SimpleNamespace(**dict(zip(OUTPUTS, values)))
                return not self.ticks or tick < self.ticks, self.outputs  # those of the last tick need no answer
        elif kind == b"e" and len(payload) == 8 * len(END):
            self.end = dict(zip(END, struct.unpack("<%dQ" % len(END), payload)))
            self.end["margin"] -= self.end["margin"] >> 63 << 64
            return True, None
        elif kind == b"n" and len(payload) == 2:
            raise LinkError("refused: " + REASONS.get(payload[0], "for a reason that is not known"))
        return False, None

    def _await(self, least):
        tries = 0
        while tries < TRIES:
            data = self._receive(PATIENCE)
            if data is None:
                tries += 1
                self._write()
                continue
            done, outputs = self._take(data, least)
            if done:
                return outputs
        raise LinkError("the plant does not answer")
