"""A plant in this process, as a library of C: rows of all that it keeps, as arrays of numpy."""
import ctypes
import sys

try:
    import numpy as np
except ImportError:
    sys.exit('numpy is missing. Install it with: apt-get install python3-numpy, for /usr/bin/python3')

NUMBERS = {4: np.float32, 8: np.float64}


class Rig(ctypes.Structure):
    """The struct `rig` of rig.c."""
    _fields_ = [(name, ctypes.c_uint32) for name in
                'states inputs outputs parameters memories bytes x u p y real_bytes period_ns progress'.split()] + [
                    ('step', ctypes.c_double), ('output_names', ctypes.c_char_p), ('output_units', ctypes.c_char_p),
                    ('memory', ctypes.c_void_p)] + [(name, ctypes.c_uint64) for name in (
                        'inputs_held inputs_clamped parameters_held parameters_clamped outputs_held restarts near_singular events '
                        'late_events').split()] + [('guard', ctypes.c_uint32)]


class Plant:
    """A row is all that it keeps: rows['x'], ['u'], ['p'] and ['y'] are arrays of all rows; behind the inputs u has the
    memories. `now` has one row, where the plant stands, in its own memory."""

    def __init__(self, library):
        self.library = ctypes.CDLL(str(library))
        self.library.rig_go.restype = ctypes.c_uint64
        self.library.rig_open()
        self.facts = facts = Rig.in_dll(self.library, 'rig')
        self.number = NUMBERS[facts.real_bytes]
        self.step_size, self.states = facts.step, facts.states
        self.names = facts.output_names.decode().split(',')
        # The first field covers all bytes of a row: numpy copies what stands in a field.
        fields = [('memory', f'V{facts.bytes}', 0)] + [
            (name, (self.number, (size,)), place) for name, size, place in (
                ('x', facts.states, facts.x), ('u', facts.inputs + facts.memories, facts.u),
                ('p', facts.parameters, facts.p), ('y', facts.outputs, facts.y),
                ('local_error', 1, facts.progress)) if place or name != 'local_error']
        names, formats, offsets = map(list, zip(*fields))
        self.row = np.dtype({'names': names, 'formats': formats, 'offsets': offsets, 'itemsize': facts.bytes})
        memory = (ctypes.c_char * facts.bytes).from_address(facts.memory)
        self.now = np.frombuffer(memory, self.row, 1)

    def _array(self, values):
        return None if values is None else np.ascontiguousarray(values, self.number).ctypes

    def start(self, tunables=None):
        """Puts it to its start."""
        self.library.rig_start(self._array(tunables))
        self.library.rig_output()

    def begin(self, tick):
        """Begins the method anew where it stands, before the tick of this number."""
        self.library.rig_begin(ctypes.c_uint64(tick))

    def go(self, ticks, every=1, given=None, first=0, which=None):
        """The rows of so many ticks from where it stands, that behind the last one too, and how many were made until
        the guard ended it. `given`: the inputs of each tick, all or those that `which` marks; `first`: the number of
        the first."""
        rows = np.zeros(ticks // every + 1, self.row)
        marks = None if which is None else np.ascontiguousarray(which, bool).ctypes
        ended = self.library.rig_go(*map(ctypes.c_uint64, (first, ticks, every)), self._array(given), marks, rows.ctypes)
        return rows[:ended // every + 1], ended

    def run(self, ticks, every=1, tunables=None, given=None, whole=True, first=0):
        """The rows of a run from the start. A guard that ends it is a failure, but with whole=False: then the rows up
        to there."""
        self.start(tunables)
        rows, ended = self.go(ticks, every, given, first)
        assert ended == ticks or not whole, f'the guard ended it at tick {ended}'
        return rows

    def outputs_at(self, rows, x, slopes=None):
        """The outputs of these rows with other states."""
        rows = rows.copy()
        rows['x'] = x
        self.library.rig_look(rows.ctypes, ctypes.c_size_t(len(rows)), None if slopes is None else slopes.ctypes)
        return rows['y']

    def slopes_at(self, rows, x):
        """The derivatives of these rows with other states, and the outputs."""
        slopes = np.zeros((len(rows), self.states), self.number)
        return slopes, self.outputs_at(rows, x, slopes)

    def stepped(self, rows):
        """These rows a step later."""
        rows = rows.copy()
        self.library.rig_step(rows.ctypes, ctypes.c_size_t(len(rows)))
        return rows
