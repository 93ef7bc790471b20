"""An importer of FMUs for co-simulation: reads the description, loads the library, and calls it through ctypes."""
import ctypes
import os
import platform
import tempfile
import xml.etree.ElementTree as xml
import zipfile

OK, WARNING, DISCARD, ERROR = 0, 1, 2, 3
REFERENCE = ctypes.c_uint32
NUMBER = ctypes.c_double
POINTER = ctypes.c_void_p
SIZE, TEXT = ctypes.c_size_t, ctypes.c_char_p


class Variable:
    """A variable of the description; `element` has its attributes."""

    def __init__(self, element, kind, index):
        self.element = element
        self.kind = kind
        self.index = index
        self.name = element.get("name")
        self.reference = int(element.get("valueReference"))
        self.causality = element.get("causality", "local")
        self.start = element.get("start")


class Fmu:
    """An archive, unpacked into a folder of its own."""

    def __init__(self, path):
        self.folder = tempfile.TemporaryDirectory()
        with zipfile.ZipFile(path) as archive:
            self.names = archive.namelist()
            archive.extractall(self.folder.name)
        self.root = xml.parse(os.path.join(self.folder.name, "modelDescription.xml")).getroot()
        self.version = int(self.root.get("fmiVersion")[0])
        self.token = self.root.get("instantiationToken" if self.version == 3 else "guid")
        self.identifier = self.root.find("CoSimulation").get("modelIdentifier")
        self.variables = self.read_variables()
        self.by_name = {v.name: v for v in self.variables}
        self.library = ctypes.CDLL(os.path.join(self.folder.name, "binaries", self.platform_of(self.version), self.identifier + ".so"))

    @staticmethod
    def platform_of(version):
        host = platform.machine() + "-linux"
        return "linux64" if version == 2 and host == "x86_64-linux" else host

    def read_variables(self):
        found = []
        for element in self.root.find("ModelVariables"):
            typed = element if self.version == 3 else element[0]
            if typed is not element:
                element.attrib.update(typed.attrib)
            found.append(Variable(element, typed.tag, len(found) + 1))
        return found

    def references(self, names):
        return (REFERENCE * len(names))(*[self.by_name[name].reference for name in names])

    def outputs(self):
        return [v.name for v in self.variables if v.causality == "output"]


class Instance:
    """An instance for co-simulation. Calls return their status; messages are kept."""

    def __init__(self, fmu, token=None, name="plant", logs=False):
        self.fmu = fmu
        self.version = fmu.version
        self.prefix = "fmi%d" % self.version
        self.messages = []
        self.time = 0.0
        self.handle = self.instantiate(name, fmu.token if token is None else token, logs)

    def instantiate(self, name, token, logs):
        texts = name.encode(), token.encode()
        if self.version == 3:
            self.log = ctypes.CFUNCTYPE(None, POINTER, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)(
                lambda environment, status, category, message: self.messages.append((status, message.decode())))
            call = self.fmu.library.fmi3InstantiateCoSimulation
            call.restype = POINTER
            call.argtypes = [ctypes.c_char_p] * 3 + [ctypes.c_bool] * 4 + [POINTER, ctypes.c_size_t, POINTER, POINTER,
                                                                           POINTER]
            return call(*texts, None, False, logs, False, False, None, 0, None, ctypes.cast(self.log, POINTER), None)
        self.log = ctypes.CFUNCTYPE(None, POINTER, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p,
                                    ctypes.c_char_p)(
            lambda environment, who, status, category, form, text: self.messages.append((status, text.decode())))
        libc = ctypes.CDLL(None)
        functions = self.log, libc.calloc, libc.free
        self.callbacks = (POINTER * 5)(*[ctypes.cast(f, POINTER) for f in functions], None, None)
        call = self.fmu.library.fmi2Instantiate
        call.restype = POINTER
        call.argtypes = [TEXT, ctypes.c_int, TEXT, TEXT, POINTER, ctypes.c_int, ctypes.c_int]
        return call(texts[0], 1, texts[1], None, self.callbacks, False, logs)

    def call(self, name, *arguments):
        return getattr(self.fmu.library, self.prefix + name)(POINTER(self.handle), *arguments)

    def free(self):
        self.call("FreeInstance")

    def enter(self, start=0.0, stop=None):
        times = NUMBER(0.0), NUMBER(start), stop is not None, NUMBER(stop or 0.0)
        if self.version == 3:
            return self.call("EnterInitializationMode", False, *times)
        status = self.call("SetupExperiment", False, *times)
        return status if status != OK else self.call("EnterInitializationMode")

    def leave(self):
        return self.call("ExitInitializationMode")

    def begin(self, stop=None):
        return max(self.enter(stop=stop), self.leave())

    def step(self, length, time=None):
        time = self.time if time is None else time
        if self.version == 3:
            flags = [ctypes.c_bool() for _ in range(3)]
            reached = NUMBER()
            status = self.call("DoStep", NUMBER(time), NUMBER(length), True, *[ctypes.byref(f) for f in flags],
                               ctypes.byref(reached))
        else:
            status = self.call("DoStep", NUMBER(time), NUMBER(length), True)
        if status == OK:
            self.time = time + length
        return status

    def get(self, references):
        """The numbers of references; None where they are refused."""
        values = (NUMBER * len(references))()
        count = ctypes.c_size_t(len(references))
        status = (self.call("GetFloat64", references, count, values, count) if self.version == 3 else
                  self.call("GetReal", references, count, values))
        return list(values) if status == OK else None

    def set(self, reference, value):
        references, values, count = (REFERENCE * 1)(reference), (NUMBER * 1)(value), ctypes.c_size_t(1)
        return (self.call("SetFloat64", references, count, values, count) if self.version == 3 else
                self.call("SetReal", references, count, values))

    def set_name(self, name, value):
        return self.set(self.fmu.by_name[name].reference, value)

    def hash(self):
        values, count = (ctypes.c_char_p * 1)(), ctypes.c_size_t(1)
        references = self.fmu.references(["run.hash"])
        status = (self.call("GetString", references, count, values, count) if self.version == 3 else
                  self.call("GetString", references, count, values))
        return values[0].decode() if status == OK else None

    def state_call(self, name):
        """What the two versions spell in their own ways."""
        words = {"Deserialize": "DeserializeFMUState", "Serialize": "SerializeFMUState", "Get": "GetFMUState",
                 "Set": "SetFMUState", "Free": "FreeFMUState", "Size": "SerializedFMUStateSize"}
        word = words[name]
        return word if self.version == 3 else word.replace("FMUState", "FMUstate").replace("Deserialize", "DeSerialize")

    def take(self):
        """The FMU state as bytes."""
        state, size = POINTER(), ctypes.c_size_t()
        assert self.call(self.state_call("Get"), ctypes.byref(state)) == OK
        assert self.call(self.state_call("Size"), state, ctypes.byref(size)) == OK
        record = (ctypes.c_ubyte * size.value)()
        assert self.call(self.state_call("Serialize"), state, record, size) == OK
        assert self.call(self.state_call("Free"), ctypes.byref(state)) == OK and not state.value
        return bytes(record)

    def restore(self, record):
        state = POINTER()
        data = (ctypes.c_ubyte * len(record))(*record)
        status = self.call(self.state_call("Deserialize"), data, ctypes.c_size_t(len(record)), ctypes.byref(state))
        if status == OK:
            status = self.call(self.state_call("Set"), state)
            self.call(self.state_call("Free"), ctypes.byref(state))
        return status
