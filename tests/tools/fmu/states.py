"""Every call in every state of an FMU for co-simulation: states.py FMU SUMMARY [FMU SUMMARY ...]

The tables say by the text of the standard (2.0.4: section 4.2.4; 3.0.2: sections 2.3 and 4.2) which call is of which
state. A call that is none of its state is an error, with a message, and changes nothing: the bytes of the FMU state
stay, and the run ends with the hash of a run that saw none of these calls. SUMMARY is what a run of the same plant
printed, of as many ticks. With --find, of an FMU with planted faults, it prints what it finds, as no test; else TAP.
"""
import ctypes
import sys

import check
import importer
from importer import DISCARD, ERROR, NUMBER, OK, POINTER, REFERENCE, SIZE, TEXT

# The states: N instantiated; T the same once the experiment is set up, in 2.0; I initialization mode; S between steps;
# E terminated; F after a step that was an error.
STATES = {2: "NTISEF", 3: "NISEF"}

# The states of each call, in 2.0 ...
CALLS_2 = """
SetDebugLogging NTISEF, Reset NTISEF, SetupExperiment NT, EnterInitializationMode T, ExitInitializationMode I
Terminate S, GetReal ISEF, GetInteger ISEF, GetBoolean ISEF, GetString ISEF, SetReal NTIS, SetInteger NTIS
SetBoolean NTIS, SetString NTIS, GetFMUstate NTISEF, SetFMUstate NTISEF, FreeFMUstate NTISEF
SerializedFMUstateSize NTISEF, SerializeFMUstate NTISEF, DeSerializeFMUstate NTISEF, DoStep S, GetRealStatus SE
GetBooleanStatus SE, GetStatus SE, GetIntegerStatus SE, GetStringStatus SE
"""
# Those whose answer, about a step that goes on, an FMU without such steps discards.
DISCARDED_2 = "GetStatus GetIntegerStatus GetStringStatus"
# ... of which those are errors everywhere that need what the description does not offer, or a state that never is.
LACKING_2 = """GetDirectionalDerivative SetRealInputDerivatives GetRealOutputDerivatives CancelStep"""

# The same in 3.0.
CALLS_3 = """
SetDebugLogging NISEF, Reset NISEF, EnterInitializationMode N, ExitInitializationMode I, Terminate S
GetFMUState NISEF, SetFMUState NISEF, FreeFMUState NISEF, SerializedFMUStateSize NISEF, SerializeFMUState NISEF
DeserializeFMUState NISEF, DoStep S, GetFloat32 NISEF, GetFloat64 NISEF, GetInt8 NISEF, GetUInt8 NISEF
GetInt16 NISEF, GetUInt16 NISEF, GetInt32 NISEF, GetUInt32 NISEF, GetInt64 NISEF, GetUInt64 NISEF, GetBoolean NISEF
GetString NISEF, GetBinary NISEF, SetFloat32 NIS, SetFloat64 NIS, SetInt8 NIS, SetUInt8 NIS, SetInt16 NIS
SetUInt16 NIS, SetInt32 NIS, SetUInt32 NIS, SetInt64 NIS, SetUInt64 NIS, SetBoolean NIS, SetString NIS, SetBinary NIS
"""
LACKING_3 = """
EnterConfigurationMode ExitConfigurationMode EnterEventMode EnterStepMode EnterContinuousTimeMode
EvaluateDiscreteStates UpdateDiscreteStates GetNumberOfVariableDependencies GetVariableDependencies
GetDirectionalDerivative GetAdjointDerivative GetOutputDerivatives GetClock SetClock GetIntervalDecimal
GetIntervalFraction GetShiftDecimal GetShiftFraction SetIntervalDecimal SetIntervalFraction SetShiftDecimal
SetShiftFraction ActivateModelPartition CompletedIntegratorStep SetTime SetContinuousStates
GetContinuousStateDerivatives GetEventIndicators GetContinuousStates GetNominalsOfContinuousStates
GetNumberOfEventIndicators GetNumberOfContinuousStates
"""


def table_of(calls, lacking):
    """The states of each call."""
    table = dict(row.split() for row in calls.replace("\n", ",").split(",") if row.strip())
    table.update({name: "" for name in lacking.split()})
    return table


def may_set(variable, version, state):
    """Whether a variable may be set: by its attributes, which the description has."""
    exact = variable.element.get("initial") == "exact" or (version == 3 and variable.causality == "input")
    if state in "NT":
        return exact
    if state == "I":
        return exact or variable.causality == "input"
    return state == "S" and (variable.causality == "input" or variable.causality == "parameter")


def may_get(variable, version, state):
    """The same of reading; in initialization mode 2.0 has what is unknown alone."""
    if state in "NT":
        return version == 3 and variable.start is not None
    return version == 3 or state != "I" or variable.causality == "output"


# --- instances in a state --------------------------------------------------------------------------------------------


class Plant:
    """An FMU, with its run outside where that counts."""

    def __init__(self, path, summary=None):
        self.fmu = importer.Fmu(path)
        is_old = self.fmu.version == 2
        self.states = STATES[self.fmu.version]
        self.table = table_of(CALLS_2, LACKING_2) if is_old else table_of(CALLS_3, LACKING_3)
        self.step = float(self.fmu.root.find("DefaultExperiment").get("stepSize"))
        if summary is not None:
            with open(summary, encoding="ascii") as file:
                told = dict(line.rstrip("\n").split(" ", 1) for line in file if " " in line)
            self.ticks, self.good_end = int(told["ticks"]), told["hash"]
        self.output = self.fmu.references(self.fmu.outputs()[:1])
        exact = next(v for v in self.fmu.variables if v.element.get("initial") == "exact")
        self.exact = self.fmu.references([exact.name])

    def may_set(self, variable, state):
        return may_set(variable, self.fmu.version, state)

    def may_get(self, variable, state):
        return may_get(variable, self.fmu.version, state)

    def arguments(self, name):
        """Arguments of calls of its own; None of those of all plants."""
        del name

    def enter(self, state):
        """An instance in a state; an FMU that is as it should be gets there by calls that are tried before."""
        instance = importer.Instance(self.fmu)
        if state == "F":
            for v in self.fmu.variables:
                if v.name.startswith("states."):
                    instance.set(v.reference, 1e30)
        if state == "T":
            instance.call("SetupExperiment", False, NUMBER(0), NUMBER(0), False, NUMBER(0))
        elif state != "N":
            instance.enter()
        if state in "SEF":
            instance.leave()
            status = instance.step(3 * self.step)
            assert (status == OK) == (state != "F"), "the state is not reached"
        if state == "E":
            instance.call("Terminate")
        return instance

    def finish(self, instance, state):
        """The hash at the end of the run, of an instance that is in a state."""
        if state in "EF":
            instance.call("Reset")
        if state in "EFN":
            instance.enter()
        elif state == "T":
            instance.call("EnterInitializationMode")
        if state != "S":
            instance.leave()
        done = 3 if state == "S" else 0
        instance.step((self.ticks - done) * self.step, done * self.step)
        return instance.hash()


# --- calls with their arguments --------------------------------------------------------------------------------------


def settable(plant, state):
    """A variable that may be set in a state, with a value; else none of them."""
    found = [v for v in plant.fmu.variables if v.start is not None and plant.may_set(v, state)][:1]
    return (plant.fmu.references([v.name for v in found]), SIZE(len(found)),
            (NUMBER * len(found))(*[float(v.start) for v in found]))


def arguments(plant, instance, name, state):
    """Arguments with which a call is well where its state is; also of calls that are never."""
    version, one = plant.fmu.version, SIZE(1)
    is_list = version == 3 and (name.startswith(("Get", "Set")))
    numbers, flag = (NUMBER * 1)(), ctypes.byref(ctypes.c_int())
    kept, value = instance.kept, settable(plant, state)
    told = (plant.output if version == 2 else plant.exact), one, numbers
    special = {
        "SetDebugLogging": (True, SIZE(0), None), "Reset": (), "Terminate": (), "ExitInitializationMode": (),
        "SetupExperiment": (False, NUMBER(0), NUMBER(0), False, NUMBER(0)),
        "EnterInitializationMode": () if version == 2 else (False, NUMBER(0), NUMBER(0), False, NUMBER(0)),
        "DoStep": (NUMBER(instance.time), NUMBER(plant.step), False) + (flag, flag, flag, numbers) * (version == 3),
        "GetReal": told, "GetFloat64": told + (one,), "SetReal": value, "SetFloat64": value + (value[1],),
        "GetRealStatus": (2, numbers), "GetBooleanStatus": (3, flag), "GetStatus": (0, flag),
        "GetIntegerStatus": (0, flag), "GetStringStatus": (1, (TEXT * 1)()),
        "SetTime": (NUMBER(0),), "ActivateModelPartition": (REFERENCE(0), NUMBER(0)),
        "GetBinary": (None, SIZE(0), None, None, SIZE(0)), "SetBinary": (None, SIZE(0), None, None, SIZE(0)),
        "UpdateDiscreteStates": (flag,) * 5 + (numbers,), "CompletedIntegratorStep": (False, flag, flag),
        "GetNumberOfVariableDependencies": (REFERENCE(0), ctypes.byref(SIZE())),
    }
    if plant.arguments(name) is not None:
        return plant.arguments(name)
    kind = name.replace("FMUState", "FMUstate").lower()
    of_state = {"getfmustate": (ctypes.byref(POINTER()),), "setfmustate": (kept,),
                "freefmustate": (ctypes.byref(POINTER()),), "serializedfmustatesize": (kept, ctypes.byref(SIZE()))}
    if kind in of_state:
        return of_state[kind]
    if "serialize" in kind:
        data = (ctypes.c_ubyte * len(instance.record))(*instance.record)
        size = SIZE(len(instance.record))
        return (kept, data, size) if kind == "serializefmustate" else (data, size, ctypes.byref(POINTER()))
    if name in special:
        return special[name]
    return (None, SIZE(0), None) + (SIZE(0),) * is_list  # an empty list of what there is not, or places for nothing


def wrong_arguments(plant, instance, state):
    """Calls in their state whose arguments are wrong."""
    version, one, two = plant.fmu.version, SIZE(1), SIZE(2)
    get, set_, many = ("GetReal", "SetReal", ()) if version == 2 else ("GetFloat64", "SetFloat64", (one,))
    known = settable(plant, state)[0] or plant.exact
    strange, mixed = (REFERENCE * 1)(99999), (REFERENCE * 2)(known[0], 99999)
    value, nan = (NUMBER * 2)(0.5, 0.5), (NUMBER * 1)(float("nan"))
    yield get, (None, one, value) + many
    yield get, (plant.output, one, None) + many
    yield get, (strange, one, value) + many
    yield set_, (None, one, value) + many
    yield set_, (known, one, None) + many
    yield set_, (known, one, nan) + many
    yield set_, (strange, one, value) + many
    yield set_, (mixed, two, value) + ((two,) if version == 3 else ())
    yield "GetString", (strange, one, (TEXT * 1)()) + many
    yield "SetString", (strange, one, (TEXT * 1)(b"?")) + many
    yield "SetDebugLogging", (True, one, (TEXT * 1)(b"no category"))
    yield "SetDebugLogging", (True, one, None)
    if version == 3:
        yield get, (plant.output, one, value, two)
        yield set_, (known, one, value, two)
        yield "EnterInitializationMode", (False, NUMBER(0), NUMBER(1), False, NUMBER(0))
        yield "EnterInitializationMode", (False, NUMBER(0), NUMBER(0), True, NUMBER(-1))
    else:
        yield "SetupExperiment", (False, NUMBER(0), NUMBER(1), False, NUMBER(0))
        yield "SetupExperiment", (False, NUMBER(0), NUMBER(0), True, NUMBER(-1))
        yield "GetRealStatus", (2, None)
    places = (ctypes.byref(ctypes.c_int()),) * 3 + (value,)
    for time, length in ((instance.time, 0.5), (instance.time, 0.0), (instance.time, -1.0), (instance.time, 1e300),
                         (instance.time + 1.0, 1.0)):
        yield "DoStep", (NUMBER(time), NUMBER(length * plant.step), False) + places * (version == 3)
    if version == 3:
        yield "DoStep", (NUMBER(instance.time), NUMBER(plant.step), False, None) + places[1:]
    yield instance.state_call("Get"), (None,)
    yield instance.state_call("Set"), (None,)
    yield instance.state_call("Free"), (None,)
    yield instance.state_call("Size"), (None, ctypes.byref(SIZE()))
    yield instance.state_call("Serialize"), (None, None, SIZE(0))
    damaged = bytearray(instance.record)
    damaged[len(damaged) // 3] ^= 16
    for data in (bytes(damaged), instance.record[:-1]):
        yield instance.state_call("Deserialize"), (data, SIZE(len(data)), ctypes.byref(POINTER()))


# --- what is found ---------------------------------------------------------------------------------------------------

READS = ("Get", "Serialize", "SerializedFMU", "Deserialize", "DeSerialize", "SetDebugLogging", "Free")


def prepare(plant, state):
    """An instance in a state, with a copy of its FMU state and the bytes of it."""
    instance = plant.enter(state)
    instance.record = instance.take()
    instance.kept = POINTER()
    instance.call(instance.state_call("Get"), ctypes.byref(instance.kept))
    return instance


def refusal(instance, name, values, what):
    """What is wrong with a call that is to be refused; nothing where it is."""
    told = len(instance.messages)
    status = instance.call(name, *values)
    if status != ERROR:
        return [what + ": not refused"]
    if len(instance.messages) == told:
        return [what + ": no message"]
    return [] if instance.take() == instance.record else [what + ": changes something"]


def wrong_calls(plant, table, state):
    """Each call in a state: those that are none of it on one instance, the others on one each."""
    wrong, victim = [], prepare(plant, state)
    for name, states in table.items():
        what = "%s in %s" % (name, state)
        if state not in states:
            wrong += refusal(victim, name, arguments(plant, victim, name, state), what)
            continue
        instance = prepare(plant, state)
        good = DISCARD if name in DISCARDED_2.split() else OK
        if instance.call(name, *arguments(plant, instance, name, state)) != good:
            wrong.append(what + ": refused")
        elif name.startswith(READS) and instance.take() != instance.record:
            wrong.append(what + ": changes something")
        instance.free()
    return wrong, victim


def wrong_variables(plant, state, victim):
    """Each variable read and set in a state."""
    wrong = []
    for v in plant.fmu.variables:
        if v.kind == "String":
            told = victim.hash() is not None
            if told != plant.may_get(v, state):
                wrong.append("reading %s in %s" % (v.name, state))
            continue
        if (victim.get((REFERENCE * 1)(v.reference)) is not None) != plant.may_get(v, state):
            wrong.append("reading %s in %s" % (v.name, state))
        if victim.take() != victim.record:
            wrong.append("reading %s in %s changes something" % (v.name, state))
        value, told = float(v.start or 0.0) + 0.25, len(victim.messages)
        if plant.may_set(v, state):
            instance = plant.enter(state)
            if instance.set(v.reference, value) != OK or instance.take() == victim.record:
                wrong.append("setting %s in %s: refused, or of no effect" % (v.name, state))
            instance.free()
        elif victim.set(v.reference, value) != ERROR or victim.take() != victim.record or len(victim.messages) == told:
            wrong.append("setting %s in %s: not refused, or changes something" % (v.name, state))
    return wrong


def find(plant, table):
    """All that is other than the table says, in three lists: calls, variables and arguments, what follows later."""
    calls, values, later = [], [], []
    for state in plant.states:
        found, victim = wrong_calls(plant, table, state)
        calls += found
        values += wrong_variables(plant, state, victim)
        for name, given in wrong_arguments(plant, victim, state):
            if state in table[name]:
                values += refusal(victim, name, given, "wrong arguments of %s in %s" % (name, state))
        if plant.finish(victim, state) != plant.good_end:
            later.append("the run after wrong calls in %s has another end" % state)
        victim.free()
    return calls, values, later


def wrong_without_instance(plant, table):
    """Calls of no instance, and instances that there are not."""
    instance = prepare(plant, "N")
    nobody = {name: getattr(plant.fmu.library, instance.prefix + name)(None, *arguments(plant, instance, name, "N"))
              for name in table}
    wrong = [name + " of no instance" for name, status in nobody.items() if status != ERROR]
    instance.call("FreeInstance")
    getattr(plant.fmu.library, instance.prefix + "FreeInstance")(None)
    for name, token in ((" \t", None), ("plant", "of another model")):
        other = importer.Instance(plant.fmu, token=token, name=name)
        if other.handle or not other.messages:
            wrong.append("an instance of the name %r and the token %s" % (name, token))
    return wrong


def test(plant, name):
    table = dict(plant.table)
    calls, values, later = find(plant, table)
    cells = len(table) * len(plant.states)
    check.result(not calls, "%s: %d calls in their states, and in others %s" % (name, cells, "; ".join(calls[:9])))
    check.result(not values, "%s: each variable in each state, wrong arguments %s" % (name, "; ".join(values[:9])))
    check.result(not later, "%s: refused calls leave the run as it is %s" % (name, "; ".join(later)))
    wrong = wrong_without_instance(plant, table)
    check.result(not wrong, "%s: no instance, instances of a wrong name or token %s" % (name, "; ".join(wrong)))
    allowed = table["Terminate"][0]
    table["Terminate"] = "E"
    planted = {"Terminate in %s: not refused" % allowed, "Terminate in E: refused"}
    check.result(planted <= set(find(plant, table)[0]), "%s: found: a wrong table" % name)


if __name__ == "__main__":
    if sys.argv[1] == "--find":
        faulty = Plant(*sys.argv[2:4])
        for line in sum(find(faulty, faulty.table), []):
            print(line)
    else:
        for k in range(1, len(sys.argv), 2):
            tried = Plant(*sys.argv[k:k + 2])
            test(tried, "%s, FMI %d" % (tried.fmu.identifier, tried.fmu.version))
        print("1..%d" % check.results)
