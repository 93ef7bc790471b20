"""Plants side by side in this process: many lanes of one plant, each with its own inputs, tunables, faults and states.

    carts = lanes.Lanes("build/many/lanes/lanes.so")
    carts.tunables["rod_mass"][3] = 0.2      # of lane 3
    rows = carts.record(1000, force=1.5)     # rows["pole"][tick, lane]

tools/python/README.md says how the library is made. Numbers are in SI units.
"""
from __future__ import annotations

import array
import ctypes
import os
from collections.abc import Iterable

_KINDS = ("states", "inputs", "tunables", "outputs")


class LanesError(Exception):
    """A request cannot be carried out."""


class _Column(ctypes.Structure):
    _fields_ = (("values", ctypes.c_void_p), ("of_step", ctypes.c_size_t), ("of_lane", ctypes.c_size_t))


def _open_library(path):
    library = ctypes.CDLL(os.path.abspath(path))
    at, word, number = ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint
    for name, result, arguments in (
        ("name", ctypes.c_char_p, (ctypes.c_int, ctypes.c_uint16)),
        ("start", ctypes.c_bool, (at,)),
        ("numbers", at, (at, ctypes.c_int)),
        ("is_driven", ctypes.c_bool, (at, ctypes.c_uint16)),
        ("restart", None, (at, ctypes.c_char_p)),
        ("hash", word, (at, number)),
        ("stopped_at", word, (at, number)),
        ("run", word, (at, word, at, at)),
    ):
        function = getattr(library, "iso_side_" + name)
        function.restype, function.argtypes = result, arguments
    return library


class Lanes:
    """`count` plants. `states`, `inputs`, `tunables` and `outputs` are, by name, a memoryview of a number for each lane, in the
    plants themselves: the next step takes, and checks, a value written to an input or a tunable. An input that is a
    function of time is none of them."""

    def __init__(self, path: str) -> None:
        self._library = library = _open_library(path)
        size, alignment, self.count, self._real_bytes = (ctypes.c_size_t * 4).in_dll(library, "iso_side_sizes")
        self.REAL = "f" if self._real_bytes == 4 else "d"
        self._block = (ctypes.c_char * (size + alignment))()
        self._at = -(-ctypes.addressof(self._block) // alignment) * alignment
        self.start()
        self.states, inputs, self.tunables, self.outputs = (self._views(kind) for kind in range(len(_KINDS)))
        self._places = {name: i for i, name in enumerate(inputs) if not library.iso_side_is_driven(self._at, i)}
        self.inputs, self._rows = {name: inputs[name] for name in self._places}, len(inputs)

    def _views(self, kind):
        views, row = {}, self.count * self._real_bytes
        first = self._library.iso_side_numbers(self._at, kind)
        name = self._library.iso_side_name(kind, 0)
        while name is not None:
            raw = (ctypes.c_char * row).from_address(first + len(views) * row)
            raw.block = self._block  # which lives as long as a view of it
            views[name.decode()] = memoryview(raw).cast("B").cast(self.REAL)
            name = self._library.iso_side_name(kind, len(views))
        return views

    def start(self) -> None:
        """Puts all lanes to tick 0, with the tunables of the scene."""
        if not self._library.iso_side_start(self._at):
            raise LanesError("this processor, or its mode, computes other bits: it rounds otherwise, or flushes small numbers")
        self.tick = 0

    def restart(self, lanes: Iterable[int]) -> None:
        """Puts these lanes to their start, with the tunables of the scene, also those that the guard has stopped. The tick is
        common and goes on: functions of time, noise, and values that are computed every few ticks follow it."""
        chosen = bytearray(self.count)
        for lane in lanes:
            if not 0 <= lane < self.count:
                raise LanesError("there is no lane %r: they are 0 to %d" % (lane, self.count - 1))
            chosen[lane] = 1
        self._library.iso_side_restart(self._at, bytes(chosen))

    def step(self, **inputs) -> bool:
        """Makes a step in all lanes; an input is a number for all of them, or one for each. Returns whether a lane runs."""
        for name, values in inputs.items():
            view = self._input(name)
            view[:] = self._array([values] * self.count if not hasattr(values, "__len__") else values, name, self.count)
        self.tick += self._library.iso_side_run(self._at, 1, self._columns({}), None)
        return not all(self.stopped())

    def record(self, ticks: int, /, **inputs) -> dict[str, memoryview]:
        """Makes so many steps. An input is a number; as many numbers as there are steps, for all lanes; or a buffer of the
        shape (steps, lanes). Returns each output: a memoryview of the shape (steps + 1, lanes), the first row before the first
        step, which numpy.asarray takes without a copy. Where the guard has stopped all lanes, fewer rows."""
        given = {name: self._steps(name, ticks, values) for name, values in inputs.items()}
        size, row = self._real_bytes, self.count
        block = bytearray(size * row * (ticks + 1) * len(self.outputs))
        rows = (ctypes.c_char * len(block)).from_buffer(block)
        done = self._library.iso_side_run(self._at, ticks, self._columns(given), ctypes.addressof(rows))
        self.tick += done
        whole, each = memoryview(block), size * row * (ticks + 1)
        return {name: whole[i * each:i * each + size * row * (done + 1)].cast(self.REAL, (done + 1, row))
                for i, name in enumerate(self.outputs)}

    def hashes(self) -> list[int]:
        """Of the trajectory of each lane since its start: that of the same plant alone."""
        return [self._library.iso_side_hash(self._at, lane) for lane in range(self.count)]

    def stopped(self) -> list[int]:
        """For each lane the tick that its guard ended, of the common ticks; 0: it runs."""
        return [self._library.iso_side_stopped_at(self._at, lane) for lane in range(self.count)]

    def _input(self, name):
        if name not in self.inputs:
            raise LanesError("no input is called %s; there are: %s" % (name, " ".join(self.inputs)))
        return self.inputs[name]

    def _array(self, values, name, count):
        numbers = array.array(self.REAL, values)
        if len(numbers) != count:
            raise LanesError("%s has %d numbers for %d" % (name, len(numbers), count))
        return numbers

    def _steps(self, name, ticks, values):
        """The numbers of an input, and how far apart those of two steps and of two lanes are."""
        self._input(name)
        if not hasattr(values, "__len__"):
            return array.array(self.REAL, [values]), 0, 0
        try:
            view = memoryview(values)
        except TypeError:
            view = None
        if view is None or view.ndim == 1:
            return self._array(values, name, ticks), 1, 0
        if view.shape != (ticks, self.count):
            raise LanesError("%s has the shape %s, and not (%d, %d)" % (name, view.shape, ticks, self.count))
        flat = memoryview(view.tobytes()).cast(view.format)
        return array.array(self.REAL, flat), self.count, 1

    def _columns(self, given):
        columns = (_Column * max(1, self._rows))()
        for name, (numbers, of_step, of_lane) in given.items():
            columns[self._places[name]] = _Column(numbers.buffer_info()[0], of_step, of_lane)
        return columns
