"""A master of XCP 1.x, from the standard: ASAM MCD-1 XCP, part 2 (protocol), part 3 (Ethernet, SxI). It knows nothing of the slave
but what it tells and what its A2L says."""
import os
import select
import socket
import struct

ERRORS = {
    0x00: "CMD_SYNCH", 0x11: "DAQ_ACTIVE", 0x20: "CMD_UNKNOWN", 0x21: "CMD_SYNTAX", 0x22: "OUT_OF_RANGE",
    0x23: "WRITE_PROTECTED", 0x24: "ACCESS_DENIED", 0x25: "ACCESS_LOCKED", 0x27: "MODE_NOT_VALID", 0x29: "SEQUENCE",
    0x2A: "DAQ_CONFIG", 0x30: "MEMORY_OVERFLOW",
}


PATIENCE = 1800.0  # s: as long as a test may take (tests/harness/tap.py)


class Refused(Exception):
    """ERR of the slave; its argument is the name of the error."""


def connect(address):
    """A socket to tcp:HOST:PORT, udp:HOST:PORT or unix:PATH."""
    if address.startswith("unix:"):
        s = socket.socket(socket.AF_UNIX)
        s.connect(address[5:])
        return s
    kind, host, port = address.split(":")
    if kind == "udp":
        s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        s.connect((host, int(port)))
        return s
    s = socket.create_connection((host, int(port)))
    s.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return s


class Master:
    def __init__(self, address, is_serial, patience=PATIENCE):
        self.line, self.is_serial, self.patience = connect(address), is_serial, patience
        self.is_datagram = self.line.type == socket.SOCK_DGRAM
        self.counter, self.data, self.samples, self.counters = 0, b"", [], []

    def close(self):
        self.line.close()

    # --- Transport ---------------------------------------------------------------------------------------------

    def frame(self, packet):
        frame = struct.pack("<HH", len(packet), self.counter & 0xFFFF) + packet
        self.counter += 1
        if self.is_serial:
            frame += b"\0" * (len(frame) % 2)
            frame += struct.pack("<H", sum(struct.unpack("<%dH" % (len(frame) // 2), frame)) & 0xFFFF)
        return frame

    def put(self, packet):
        self.line.sendall(self.frame(packet))

    def cut(self):
        """The next packet of what has come; None if it is not whole."""
        if len(self.data) < 4:
            return None
        length, counter = struct.unpack("<HH", self.data[:4])
        even = 4 + length + length % 2
        size = even + 2 if self.is_serial else 4 + length
        if len(self.data) < size:
            return None
        frame, self.data = self.data[:size], self.data[size:]
        if self.is_serial:
            words = struct.unpack("<%dH" % (size // 2), frame)
            assert sum(words[:-1]) & 0xFFFF == words[-1], "a checksum of the slave"
        self.counters.append(counter)
        return frame[4:4 + length]

    def get(self, patience=None):
        """The next response; samples that come before it are kept. None where there is none in time."""
        patience = self.patience if patience is None else patience
        while True:
            packet = self.cut()
            while packet is not None:
                if packet[0] >= 0xFC:
                    return packet
                self.samples.append(packet)
                packet = self.cut()
            if not select.select([self.line], [], [], patience)[0]:
                return None
            more = self.line.recv(65536)
            if not more:
                return None
            if self.is_datagram:
                assert len(more) == 4 + struct.unpack("<H", more[:2])[0], "a datagram of the slave has one packet"
            self.data += more

    def take_samples(self):
        while self.get(0) is not None:
            pass
        taken, self.samples = self.samples, []
        return taken

    def ask(self, code, form="", *values):
        self.put(bytes([code]) + struct.pack("<" + form, *values))
        return self.answer()

    def answer(self):
        packet = self.get()
        if packet is None:
            raise Refused("no answer")
        if packet[0] != 0xFF:
            raise Refused(ERRORS.get(packet[1], hex(packet[1])))
        return packet[1:]

    # --- Commands ----------------------------------------------------------------------------------------------

    def connect(self):
        resource, mode, cto, dto, protocol, transport = struct.unpack("<BBBHBB", self.ask(0xFF, "B", 0))
        self.max_cto, self.max_dto = cto, dto
        return resource, mode, protocol, transport

    def disconnect(self):
        self.ask(0xFE)

    def status(self):
        """Session status and protected resources."""
        return struct.unpack("<BB", self.ask(0xFD)[:2])

    def synch(self):
        try:
            self.ask(0xFC)
        except Refused as e:
            return str(e) == "CMD_SYNCH"
        return False

    def identity(self, kind):
        _, length = struct.unpack("<BxxI", self.ask(0xFA, "B", kind))
        return self.upload(length).decode() if length else ""

    def point(self, address):
        self.ask(0xF6, "xxBI", 0, address)

    def upload(self, count):
        """From the MTA on, in blocks."""
        data = b""
        while len(data) < count:
            part = min(255, count - len(data))
            self.put(struct.pack("<BB", 0xF5, part))
            got = b""
            while len(got) < part:
                got += self.answer()
            data += got
        return data

    def read(self, address, count):
        if count < self.max_cto:
            return self.ask(0xF4, "BxBI", count, 0, address)
        self.point(address)
        return self.upload(count)

    def upload_from(self, address, count):
        self.point(address)
        return self.upload(count)

    def download(self, address, data):
        """One block of up to 255 bytes."""
        self.point(address)
        most, left, code = self.max_cto - 2, len(data), 0xF0
        while left > 0:
            part = data[len(data) - left:][:most]
            self.put(struct.pack("<BB", code, left) + part)
            left, code = left - len(part), 0xEF
        self.answer()

    def short_download(self, address, data):
        self.ask(0xED, "BxBI%ds" % len(data), len(data), 0, address, data)

    def checksum(self, address, count):
        self.point(address)
        return struct.unpack("<BxxI", self.ask(0xF3, "xxxI", count))

    def unlock(self, resource, key_of):
        answer = self.ask(0xF8, "BB", 0, resource)
        seed = answer[1:1 + answer[0]]
        if seed:
            key = key_of(seed)
            self.ask(0xF7, "B%ds" % len(key), len(key), key)

    def measure(self, tables, prescaler=1):
        """Makes and starts one list of tables; each has entries (address, size)."""
        self.ask(0xD6)
        self.ask(0xD5, "xH", 1)
        self.ask(0xD4, "xHB", 0, len(tables))
        for number, table in enumerate(tables):
            self.ask(0xD3, "xHBB", 0, number, len(table))
        for number, table in enumerate(tables):
            self.ask(0xE2, "xHBB", 0, number, 0)
            if number % 2 == 0:
                for address, size in table:
                    self.ask(0xE1, "BBBI", 0xFF, size, 0, address)
            else:  # as many at once as a packet has room for
                for at in range(0, len(table), 7):
                    some = table[at:at + 7]
                    self.ask(0xC7, "B" + "BBIBx" * len(some), len(some), *(n for a, size in some for n in (0xFF, size, a, 0)))
        self.ask(0xE0, "BHHBB", 0x10, 0, 0, prescaler, 0)
        self.ask(0xDE, "BH", 2, 0)
        self.samples = []
        self.ask(0xDD, "B", 1)

    def stimulate(self, tables):
        """Makes and starts one list, the other way: each table has addresses of inputs, all of one size."""
        self.ask(0xD6)
        self.ask(0xD5, "xH", 1)
        self.ask(0xD4, "xHB", 0, len(tables))
        for number, table in enumerate(tables):
            self.ask(0xD3, "xHBB", 0, number, len(table))
        for number, table in enumerate(tables):
            self.ask(0xE2, "xHBB", 0, number, 0)
            for address, size in table:
                self.ask(0xE1, "BBBI", 0xFF, size, 0, address)
        self.ask(0xE0, "BHHBB", 0x02, 0, 0, 1, 0)
        return self.ask(0xDE, "BH", 1, 0)[0]

    def stop(self):
        self.ask(0xDD, "B", 0)
