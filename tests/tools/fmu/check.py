"""Runs FMUs for co-simulation against the plants that they are of:

    check.py FMU TRACE SUMMARY [FMU TRACE SUMMARY ...]

TRACE is the trace.csv of a run of the same scene, SUMMARY what it printed. Prints TAP.
"""
import csv
import math
import struct
import sys

import importer
from importer import ERROR, OK

results = 0


def result(good, name):
    global results
    results += 1
    print("%s %d - %s" % ("ok" if good else "not ok", results, name))


# --- the description -------------------------------------------------------------------------------------------------


def wrong_in_variables(fmu):
    """What is wrong with variables and units; an empty text if nothing is."""
    references = [v.reference for v in fmu.variables]
    units = {unit.get("name"): unit for unit in fmu.root.find("UnitDefinitions")}
    if len(set(references)) != len(references) or len(set(fmu.by_name)) != len(fmu.variables):
        return "a reference or a name stands twice"
    for v in fmu.variables:
        unit, shown = v.element.get("unit"), v.element.get("displayUnit")
        is_set = v.causality in ("input", "parameter") or v.element.get("initial") == "exact"
        if unit is not None and unit not in units:
            return "%s has the unit %s, which is not defined" % (v.name, unit)
        if shown is not None and shown not in [d.get("name") for d in units[unit].findall("DisplayUnit")]:
            return "%s is shown in %s, which is not defined" % (v.name, shown)
        if is_set != (v.start is not None) and v.causality != "independent":
            return "%s: its start" % v.name
        least, most = v.element.get("min"), v.element.get("max")
        if v.start is not None and not float(least or "-inf") <= float(v.start) <= float(most or "inf"):
            return "%s: its start is beyond its limits" % v.name
    return ""


def wrong_in_structure(fmu):
    """The same of ModelStructure: the outputs, and what is computed at the start."""
    structure = fmu.root.find("ModelStructure")
    if fmu.version == 3:
        known = {v.reference: v for v in fmu.variables}
        listed = {part: [known[int(e.get("valueReference"))].name for e in structure.findall(part)]
                  for part in ("Output", "InitialUnknown")}
    else:
        known = {v.index: v for v in fmu.variables}
        listed = {part: [known[int(e.get("index"))].name for e in structure.find(place) or []]
                  for part, place in (("Output", "Outputs"), ("InitialUnknown", "InitialUnknowns"))}
    if listed["Output"] != fmu.outputs():
        return "the outputs"
    if not set(fmu.outputs()) <= set(listed["InitialUnknown"]):
        return "the unknowns of the initialization"
    return ""


# --- runs ------------------------------------------------------------------------------------------------------------


class Reference:
    """A run of the plant: names and rows of its trace, and its summary. Numbers are those of the plant's type."""

    def __init__(self, trace, summary):
        with open(summary, encoding="ascii") as file:
            self.summary = dict(line.rstrip("\n").split(" ", 1) for line in file if " " in line)
        kind = "<f" if self.summary["real"] == "float" else "<d"
        with open(trace, encoding="ascii") as file:
            rows = list(csv.reader(file))
        self.names = rows[0][1:]
        self.rows = [[struct.unpack(kind, struct.pack(kind, float(cell)))[0] for cell in row[1:]] for row in rows[1:]]
        self.step = float(self.summary["step"])
        self.ticks = len(self.rows) - 1
        self.hash = self.summary["hash"]


def bits(numbers):
    return None if numbers is None else [struct.pack("<d", x) for x in numbers]


def differs(reference, instance, references, tick, ticks):
    """Runs in steps of so many ticks up to the end, or to what differs, which is told; else an empty text."""
    while True:
        found = instance.get(references)
        if bits(found) != bits(reference.rows[tick]):
            return "tick %d: %s for %s" % (tick, found, reference.rows[tick])
        if tick == reference.ticks:
            return "" if instance.hash() in (None, reference.hash) else "the hash"
        count = min(ticks, reference.ticks - tick)
        if instance.step(count * reference.step, tick * reference.step) != OK:
            return "tick %d: the step is refused: %s" % (tick, instance.messages[-1:])
        tick += count


def check_runs(fmu, reference, name):
    references = fmu.references(reference.names)
    first, second = importer.Instance(fmu), importer.Instance(fmu, name="second")
    result(first.begin() == OK and second.begin() == OK, "%s: two instances begin" % name)
    wrong = differs(reference, first, references, 0, 1)
    result(not wrong and first.hash() == reference.hash, "%s: rows and hash in steps of a tick %s" % (name, wrong))
    wrong = differs(reference, second, references, 0, 7)
    result(not wrong and second.hash() == reference.hash, "%s: in steps of 7 ticks %s" % (name, wrong))
    first.call("Reset")
    half = reference.ticks // 2
    first.begin()
    first.step(half * reference.step, 0.0)
    record = first.take()
    wrong = differs(reference, first, references, half, 3)
    result(not wrong and first.hash() == reference.hash,
           "%s: after a reset, in one long step, then of 3 ticks %s" % (name, wrong))
    third = importer.Instance(fmu)
    good = third.restore(third.take()) == OK and third.restore(record) == OK and third.take() == record
    wrong = differs(reference, third, references, half, 1)
    result(good and not wrong and third.hash() == reference.hash,
           "%s: another instance goes on from the bytes of an FMU state %s" % (name, wrong))
    for instance in (first, second, third):
        instance.free()


def refusals(fmu, instance, step):
    """Calls that are wrong between steps, each with what it is."""
    time = instance.time
    reference = {v.causality: v.reference for v in fmu.variables}
    yield "half a tick", lambda: instance.step(0.5 * step, time)
    yield "2.5 ticks", lambda: instance.step(2.5 * step, time)
    yield "no time", lambda: instance.step(0.0, time)
    yield "backwards", lambda: instance.step(-step, time)
    yield "no number", lambda: instance.step(math.nan, time)
    yield "for ever", lambda: instance.step(math.inf, time)
    yield "from another time", lambda: instance.step(step, time + step)
    yield "from no time", lambda: instance.step(step, math.nan)
    yield "beyond the end", lambda: instance.step(1000 * step, time)
    yield "an output is set", lambda: instance.set(reference["output"], 0.0)
    yield "a state is set", lambda: instance.set(reference["local"], 0.0)
    yield "what there is not is set", lambda: instance.set(99999, 0.0)
    yield "what there is not is read", lambda: OK if instance.get((importer.REFERENCE * 1)(99999)) else ERROR
    yield "the initialization", lambda: instance.enter()
    for v in fmu.variables:
        if v.causality in ("input", "parameter"):
            yield v.name + " is no number", lambda v=v: instance.set(v.reference, math.nan)
            yield v.name + " is infinite", lambda v=v: instance.set(v.reference, math.inf)
        if v.causality == "parameter" and v.element.get("max") is not None:
            yield v.name + " is too large", lambda v=v: instance.set(v.reference, float(v.element.get("max")) + 1.0)


def check_refusals(fmu, reference, name):
    instance = importer.Instance(fmu)
    instance.begin(stop=10 * reference.step)
    instance.step(3 * reference.step)
    before = instance.take()
    wrong = []
    for what, call in refusals(fmu, instance, reference.step):
        told = len(instance.messages)
        if call() != ERROR or instance.take() != before or len(instance.messages) == told:
            wrong.append(what)
    damaged = bytearray(before)
    damaged[len(damaged) // 2] ^= 1
    if instance.restore(bytes(damaged)) != ERROR or instance.restore(before[:-1]) != ERROR or instance.take() != before:
        wrong.append("a damaged FMU state")
    result(not wrong, "%s: what is wrong is refused, with a message, and changes nothing %s" % (name, ", ".join(wrong)))
    stranger = importer.Instance(fmu, token="of another model")
    late = importer.Instance(fmu)
    result(not stranger.handle and stranger.messages and late.enter(start=1.0) == ERROR and late.begin() == OK,
           "%s: another token, another begin than 0" % name)
    instance.free()
    late.free()


def check_messages(fmu, reference, name):
    """An input beyond its limits is told to who wants to hear it."""
    limited = [v for v in fmu.variables if v.causality == "input" and v.element.get("max") is not None]
    heard = []
    if not limited:
        return
    for logs, on in ((False, None), (True, None), (True, False), (False, True)):
        instance = importer.Instance(fmu, logs=logs)
        if on is not None:
            instance.call("SetDebugLogging", on, importer.SIZE(1), (importer.TEXT * 1)(b"logStatusWarning"))
        instance.begin()
        instance.set(limited[0].reference, 2.0 * float(limited[0].element.get("max")))
        instance.step(reference.step)
        heard.append([status for status, _ in instance.messages])
        instance.free()
    told = [importer.WARNING]
    result(heard == [[], told, [], told], "%s: messages about an input beyond its limits %s" % (name, heard))


def check(path, trace, summary):
    fmu = importer.Fmu(path)
    reference = Reference(trace, summary)
    name = "%s, FMI %d, %s" % (fmu.identifier, fmu.version, reference.summary["real"])
    result(fmu.outputs() == reference.names, "%s: the outputs are the columns of trace.csv" % name)
    wrong = wrong_in_variables(fmu) + wrong_in_structure(fmu)
    result(not wrong, "%s: the description is in order %s" % (name, wrong))
    check_runs(fmu, reference, name)
    check_refusals(fmu, reference, name)
    check_messages(fmu, reference, name)


if __name__ == "__main__":
    given = sys.argv[1:]
    for k in range(0, len(given), 3):
        check(*given[k:k + 3])
    print("1..%d" % results)
