"""Runs FMUs for model exchange, with integrators of its own, against their own co-simulation:

    exchange.py FMU MATRICES [FMU MATRICES ...]

MATRICES is the matrices.tsv that isoc --linear writes of the scene; - where there are none. Prints TAP.

A step of the importer from the states of a tick ends at those of the next: to the last bit by euler, and by rk4 where the
plant computes no sines; else up to the rounding of the stages, of which the plant takes the sines by the theorem of addition.
"""
import ctypes
import math
import os
import random
import re
import struct
import sys

import check
from check import result
from importer import ERROR, NUMBER, OK, POINTER, REFERENCE, Fmu, Instance

TICKS = 200


class Solved(Instance):
    """An instance for model exchange, by version 3."""

    def instantiate(self, name, token, logs):
        self.log = ctypes.CFUNCTYPE(None, POINTER, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)(
            lambda environment, status, category, message: self.messages.append((status, message.decode())))
        call = self.fmu.library.fmi3InstantiateModelExchange
        call.restype = POINTER
        call.argtypes = [ctypes.c_char_p] * 3 + [ctypes.c_bool] * 2 + [POINTER, POINTER]
        return call(name.encode(), token.encode(), None, False, logs, None, ctypes.cast(self.log, POINTER))

    def count(self):
        number = ctypes.c_size_t()
        return number.value if self.call("GetNumberOfContinuousStates", ctypes.byref(number)) == OK else None

    def numbers(self, name, count):
        values = (NUMBER * count)()
        return list(values) if self.call(name, values, ctypes.c_size_t(count)) == OK else None

    def rates(self, states):
        """The derivatives at these states."""
        self.set_states(states)
        return self.numbers("GetContinuousStateDerivatives", len(states))

    def set_states(self, states):
        return self.call("SetContinuousStates", (NUMBER * len(states))(*states), ctypes.c_size_t(len(states)))

    def set_time(self, time):
        return self.call("SetTime", NUMBER(time))

    def slopes(self, unknowns, knowns, seed):
        m, n = len(unknowns), len(knowns)
        changes = (NUMBER * m)()
        status = self.call("GetDirectionalDerivative", (REFERENCE * m)(*unknowns), ctypes.c_size_t(m),
                           (REFERENCE * n)(*knowns), ctypes.c_size_t(n), (NUMBER * n)(*seed), ctypes.c_size_t(n), changes,
                           ctypes.c_size_t(m))
        return list(changes) if status == OK else None

    def update(self):
        """The next event; None where there is none."""
        flags = [ctypes.c_bool() for _ in range(5)]
        following = NUMBER()
        status = self.call("UpdateDiscreteStates", *[ctypes.byref(f) for f in flags], ctypes.byref(following))
        assert status == OK and not any(f.value for f in flags[:3]), self.messages[-1:]
        self.has_moved = flags[3].value
        return following.value if flags[4].value else None

    def event(self, time):
        """From continuous time to an event at this time, and back."""
        assert self.set_time(time) == OK and self.call("EnterEventMode") == OK
        following = self.update()
        assert self.call("EnterContinuousTimeMode") == OK
        return following

    def complete(self):
        """After a step; self.wants_event says whether the plant wants one."""
        flags = [ctypes.c_bool(), ctypes.c_bool()]
        status = self.call("CompletedIntegratorStep", True, *[ctypes.byref(f) for f in flags])
        self.wants_event = flags[0].value
        return status


def source_of(fmu, name):
    with open(os.path.join(fmu.folder.name, "sources", name), encoding="utf-8") as file:
        return file.read()


class Model:
    """What the description says of states, derivatives and inputs."""

    def __init__(self, fmu):
        self.fmu = fmu
        self.by_reference = {v.reference: v for v in fmu.variables}
        listed = fmu.root.find("ModelStructure").findall("ContinuousStateDerivative")
        self.rates = [int(e.get("valueReference")) for e in listed]
        self.states = [int(self.by_reference[r].element.get("derivative")) for r in self.rates]
        self.names = [self.by_reference[r].name[len("states."):] for r in self.states]
        self.inputs = [v for v in fmu.variables if v.causality == "input"]
        self.outputs = [v.reference for v in fmu.variables if v.causality == "output"]
        words = fmu.root.get("description").split()
        self.method = words[words.index("method") + 1].rstrip(",")
        self.step = float(fmu.root.find("CoSimulation").get("fixedInternalStepSize"))
        kinds = re.search(r"fmu_kinds\[FMU_STATES\] = \{(.*)\}", source_of(fmu, "fmu_model.h")).group(1).split(", ")
        self.turns = [i for i, kind in enumerate(kinds) if kind == "FMU_TURN"]
        self.quaternions = [i for i, name in enumerate(self.names) if name.endswith("_w") and
                            [n[-2:] for n in self.names[i:i + 4]] == ["_w", "_x", "_y", "_z"]]

    def draw(self, r):
        """Values of the inputs, within their limits."""
        return {v.reference: min(max(rounded(r.uniform(-1, 1), "<f"), float(v.element.get("min") or "-inf")),
                                 float(v.element.get("max") or "inf")) for v in self.inputs}


def rounded(x, kind):
    return struct.unpack(kind, struct.pack(kind, x))[0]


def bits(numbers):
    return [struct.pack("<d", x + 0.0) for x in numbers]


# --- steps -----------------------------------------------------------------------------------------------------------


def step_of(method, f, x, h, kind):
    """The states a step on, each operation rounded to the plant's type."""
    one = lambda a: rounded(a, kind)
    moved = lambda k, over: [one(a + one(over * b)) for a, b in zip(x, k)]
    h = one(h)
    k = [f(x)]
    if method == "euler":
        return moved(k[0], h)
    half = one(h / 2)
    k.append(f(moved(k[0], half)))
    k.append(f(moved(k[1], half)))
    k.append(f(moved(k[2], h)))
    return moved([one(one(a + one(2 * one(b + c))) + d) for a, b, c, d in zip(*k)], one(h / 6))


def normalised(model, x):
    """Quaternions of length one, by a step of Newton's method."""
    x = list(x)
    for i in model.quaternions:
        scale = 1.5 - 0.5 * sum(a * a for a in x[i:i + 4])
        x[i:i + 4] = [a * scale for a in x[i:i + 4]]
    return x


def matrix(model, instance, unknowns, knowns):
    """Columns by the knowns, a call for each."""
    return [instance.slopes(unknowns, [k], [1.0]) for k in knowns]


def move(model, instances, r):
    """Starts elsewhere, all of them at the same place; quaternions stay of length one."""
    fixed = {i + k for i in model.quaternions for k in range(4)}
    for i, reference in enumerate(model.states):
        if i not in fixed:
            by = rounded(r.uniform(-0.1, 0.1), "<f")
            for instance in instances:
                instance.set(reference, float(model.by_reference[reference].start) + by)


def bounds(model, instance, x, f, epsilon):
    """What a step by rk4 may be off where each state in its stages is off by 64 roundings, of an angle by as much as those of
    its sine."""
    columns = matrix(model, instance, model.rates, model.states)
    reach = [sum(abs(c[i]) * max(1.0, abs(a)) for c, a in zip(columns, x)) + abs(f[i]) for i in range(len(x))]
    most = max(reach)
    return [64 * epsilon * (model.step * most + abs(a)) for a in x]


def steps_differ(model, kind, exact, planted=0.0):
    """One step of the importer from each tick of co-simulation. What is wrong, else an empty text; and the worst share of the
    bound."""
    r = random.Random(7)
    epsilon = 2.0 ** (-24 if kind == "<f" else -53)
    driver, solved = Instance(model.fmu), Solved(model.fmu)
    solved.enter()
    driver.enter()
    references = (REFERENCE * len(model.states))(*model.states)
    outputs = (REFERENCE * len(model.outputs))(*model.outputs)
    move(model, [driver, solved], r)
    driver.leave()
    solved.leave()
    following, worst = solved.update(), 0.0
    assert solved.call("EnterContinuousTimeMode") == OK
    x = driver.get(references)
    if bits(x) != bits(solved.numbers("GetContinuousStates", len(x))):
        return "the start", 0.0
    for tick in range(TICKS):
        now = tick * model.step
        changed = model.draw(r) if tick % 10 == 0 else {}
        for reference, value in changed.items():
            driver.set(reference, value)
            solved.set(reference, value)
        if following is not None and now >= following - 1e-3 * model.step:
            following = solved.event(following)
        solved.set_time(now)
        f = solved.rates(x)
        if not changed and bits(solved.get(outputs)) != bits(driver.get(outputs)):
            return "tick %d: the outputs %s" % (tick, solved.get(outputs)), worst
        allowed = bounds(model, solved, x, f, epsilon)
        mine = normalised(model, step_of(model.method, solved.rates, x, model.step, kind))
        mine[-1] += planted
        driver.step(model.step, now)
        x = driver.get(references)
        off = [abs(math.remainder(a - b, 2 * math.pi) if i in model.turns else a - b) for i, (a, b) in enumerate(zip(mine, x))]
        worst = max(worst, max(a / b for a, b in zip(off, allowed)))
        if (bits(mine) != bits(x)) if exact else any(a > b for a, b in zip(off, allowed)):
            return "tick %d: %s for %s" % (tick, mine, x), worst
        solved.set_time(now + model.step)
        solved.set_states(x)
        if solved.complete() != OK or solved.wants_event:
            return "tick %d: CompletedIntegratorStep" % tick, worst
    driver.free()
    solved.free()
    return "", worst


# --- directional derivatives -----------------------------------------------------------------------------------------


def value_at(model, solved, x, u, unknowns):
    solved.set_states(x)
    for v, value in zip(model.inputs, u):
        solved.set(v.reference, value)
    return solved.get((REFERENCE * len(unknowns))(*unknowns))


def differences(model, solved, x, u, unknowns, which, by):
    """Differences by one of the states and inputs: to both sides, above, and below."""
    at = []
    for sign in (1, 0, -1):
        moved = list(x) + list(u)
        moved[which] += sign * by
        at.append((moved[which], value_at(model, solved, moved[:len(x)], moved[len(x):], unknowns)))
    pairs = (at[0], at[2]), (at[0], at[1]), (at[1], at[2])
    return [[(a - b) / (to - low) for a, b in zip(high, below)] for (to, high), (low, below) in pairs]


def slopes_differ(model, solved, x, u, columns):
    """Columns against central differences, in double: what is apart by more than their own errors; else an empty text.

    Two widths tell the error of the series, and 2^-40 of the values' own size over the width is what rounding leaves. By a
    corner, where the differences of both sides are others by more than a thousandth, it is between these."""
    unknowns, wrong = model.rates + model.outputs, ""
    size = max(1.0, max(abs(v) for v in value_at(model, solved, x, u, unknowns)))
    for which, column in enumerate(columns):
        width = 2.0 ** -17 * max(1.0, abs((list(x) + list(u))[which]))
        narrow = differences(model, solved, x, u, unknowns, which, width)
        wide = differences(model, solved, x, u, unknowns, which, 2 * width)
        for i, a in enumerate(column):
            good = abs(a - narrow[0][i]) <= 2 * abs(narrow[0][i] - wide[0][i]) + 2.0 ** -40 * size / width
            below, above = sorted([narrow[1][i], narrow[2][i]])
            slack = 1e-3 * max(abs(below), abs(above))
            if not good and not (above - below > slack and below - slack <= a <= above + slack):
                wrong = "%s by number %d: %.17g for %.17g" % (model.by_reference[unknowns[i]].name, which, a, narrow[0][i])
    value_at(model, solved, x, u, unknowns)
    return wrong


def points(model, solved):
    """The start, and others on the way of co-simulation, with inputs."""
    r = random.Random(5)
    references = (REFERENCE * len(model.states))(*model.states)
    driver = Instance(model.fmu)
    driver.begin()
    for k in range(3):
        yield driver.get(references), [rounded(r.uniform(-1, 1), "<f") for _ in model.inputs]
        driver.step((1 + 20 * k) * model.step)
    driver.free()


def begun(model):
    solved = Solved(model.fmu)
    solved.begin()
    solved.update()
    assert solved.call("EnterContinuousTimeMode") == OK
    return solved


def check_slopes(model, name):
    solved = begun(model)
    knowns, unknowns = model.states + [v.reference for v in model.inputs], model.rates + model.outputs
    wrong, found = [], True
    for x, u in points(model, solved):
        value_at(model, solved, x, u, unknowns)
        columns = matrix(model, solved, unknowns, knowns)
        wrong.append(slopes_differ(model, solved, x, u, columns))
        together = solved.slopes(unknowns, knowns, [0.5] * len(knowns))
        sums = [0.5 * sum(c[i] for c in columns) for i in range(len(unknowns))]
        size = [0.5 * sum(abs(c[i]) for c in columns) for i in range(len(unknowns))]
        if any(abs(a - b) > 2.0 ** -40 * (1.0 + c) for a, b, c in zip(together, sums, size)):
            wrong.append("the sum of all columns")
        broken = max(range(len(columns)), key=lambda i: max(abs(a) for a in columns[i]))
        columns[broken] = [1.01 * a for a in columns[broken]]
        found = found and slopes_differ(model, solved, x, u, columns) != ""
    result(not any(wrong), "%s: directional derivatives are central differences %s" % (name, "; ".join(w for w in wrong if w)))
    result(found, "%s: found: a column that is broken" % name)
    solved.free()


def check_matrices(model, path, name):
    """The columns at the start against those of isoc --linear."""
    with open(path, encoding="ascii") as file:
        rows = [line.rstrip("\n").split("\t") for line in file][1:]
    solved = begun(model)
    unknown = dict(zip(["A " + n for n in model.names], model.rates))
    unknown.update(zip(["B " + n for n in model.names], model.rates))
    for v in model.fmu.variables:
        if v.causality == "output":
            unknown["C " + v.name] = unknown["D " + v.name] = v.reference
    known = dict(zip(model.names, model.states))
    known.update((v.name, v.reference) for v in model.inputs)
    wrong, compared = "", 0
    for kind, row, column, value, _ in rows:
        if column in known:
            found = solved.slopes([unknown[kind + " " + row]], [known[column]], [1.0])[0]
            compared += 1
            if not abs(found - float(value)) <= 1e-9 * max(1.0, abs(float(value))):
                wrong = "%s %s %s: %.17g for %s" % (kind, row, column, found, value)
    result(not wrong and compared >= len(model.states) ** 2, "%s: %d slopes are those of isoc --linear %s" % (name, compared, wrong))
    solved.free()


# --- calls -----------------------------------------------------------------------------------------------------------

MODES = ["instantiated", "initialization", "event", "continuous", "terminated"]


def in_mode(model, mode):
    solved = Solved(model.fmu)
    way = [lambda: solved.enter(stop=1.0), solved.leave, lambda: solved.call("EnterContinuousTimeMode"),
           lambda: solved.call("Terminate")]
    for call in way[:MODES.index(mode)]:
        assert call() == OK
    return solved


def calls(model, solved):
    """Each call with the modes that it is of, as initials."""
    n = len(model.states)
    x = [float(model.by_reference[s].start) for s in model.states]
    wrong = (NUMBER * (n + 1))()
    yield "EnterInitializationMode", "i", solved.enter
    yield "ExitInitializationMode", "n", solved.leave
    yield "UpdateDiscreteStates", "e", lambda: solved.call("UpdateDiscreteStates", *[
        ctypes.byref(f) for f in [ctypes.c_bool() for _ in range(5)]], ctypes.byref(NUMBER()))
    yield "EnterContinuousTimeMode", "e", lambda: solved.call("EnterContinuousTimeMode")
    yield "EnterEventMode", "c", lambda: solved.call("EnterEventMode")
    yield "EnterStepMode", "", lambda: solved.call("EnterStepMode")
    yield "DoStep", "", lambda: solved.step(model.step)
    yield "CompletedIntegratorStep", "c", solved.complete
    yield "SetTime", "c", lambda: solved.set_time(0.5)
    yield "SetTime beyond the end", "", lambda: solved.set_time(1.1)
    yield "SetTime to no number", "", lambda: solved.set_time(float("nan"))
    yield "SetContinuousStates", "c", lambda: solved.set_states(x)
    yield "SetContinuousStates, one too few", "", lambda: solved.set_states(x[1:])
    yield "SetContinuousStates, no number", "", lambda: solved.set_states([float("nan")] + x[1:])
    for get in ("GetContinuousStates", "GetContinuousStateDerivatives", "GetNominalsOfContinuousStates"):
        yield get, "nect", lambda get=get: OK if solved.numbers(get, n) is not None else ERROR
        yield get + ", one too many", "", lambda get=get: solved.call(get, wrong, ctypes.c_size_t(n + 1))
        yield get + ", no place", "", lambda get=get: solved.call(get, None, ctypes.c_size_t(n))
    yield "GetDirectionalDerivative", "nect", lambda: OK if solved.slopes(model.rates, model.states, [1.0] * n) else ERROR
    yield "GetDirectionalDerivative of a state", "", lambda: OK if solved.slopes(model.states, model.states, x) else ERROR
    yield "GetDirectionalDerivative by time", "", lambda: OK if solved.slopes(model.rates, [0], [1.0]) else ERROR
    is_plain = model.by_reference[model.states[0]].element.get("reinit") != "true"
    yield "SetFloat64 of a state", "inec" if is_plain else "inc", lambda: solved.set(model.states[0], x[0])
    for v in model.fmu.variables:
        if v.causality in ("input", "parameter"):
            modes = "inec" if v.causality == "input" else "ine"
            yield "SetFloat64 of " + v.name, modes, lambda v=v: solved.set(v.reference, float(v.start))
            yield v.name + " is no number", "", lambda v=v: solved.set(v.reference, float("nan"))
    yield "SetFloat64 of an output", "", lambda: solved.set(model.outputs[0], 0.0)
    yield "SetFloat64 of a derivative", "", lambda: solved.set(model.rates[0], 0.0)
    yield "GetFloat64 of a derivative", "nect", lambda: OK if solved.get((REFERENCE * 1)(model.rates[0])) else ERROR
    yield "GetAdjointDerivative", "", lambda: solved.call("GetAdjointDerivative", None, 0, None, 0, None, 0, None, 0)
    yield "Terminate", "ec", lambda: solved.call("Terminate")
    yield "Reset", "inect", lambda: solved.call("Reset")


def check_calls(model, name):
    wrong = []
    for mode in MODES:
        initial = {"initialization": "n"}.get(mode, mode[0])
        for number, (what, modes, _) in enumerate(calls(model, in_mode(model, mode))):
            solved = in_mode(model, mode)
            before, told = solved.take(), len(solved.messages)
            status = list(calls(model, solved))[number][2]()
            refused = status == ERROR and solved.take() == before and len(solved.messages) > told
            if (status != OK) if initial in modes else not refused:
                wrong.append("%s in mode %s" % (what, mode))
            solved.free()
    driver = Instance(model.fmu)
    driver.begin()
    told = len(driver.messages)
    if driver.call("SetTime", NUMBER(0.0)) != ERROR or driver.call("EnterContinuousTimeMode") != ERROR or \
            len(driver.messages) != told + 2:
        wrong.append("a call of model exchange in co-simulation")
    if in_mode(model, "continuous").restore(driver.take()) != ERROR:
        wrong.append("an FMU state of co-simulation")
    result(not wrong, "%s: each call in its modes alone: %s" % (name, ", ".join(wrong)))


def check_state(model, name):
    """An FMU state as bytes has all: another instance goes on from it."""
    one, other = begun(model), Solved(model.fmu)
    x = [a + 1e-3 for a in one.numbers("GetContinuousStates", len(model.states))]
    one.set_time(0.25)
    one.set_states(x)
    record = one.take()
    good = other.restore(record) == OK and other.take() == record
    rates = other.numbers("GetContinuousStateDerivatives", len(x))
    time = other.get((REFERENCE * 1)(0))
    result(good and time == [0.25] and bits(rates) == bits(one.rates(x)), "%s: another instance goes on from the bytes" % name)
    nominals = one.numbers("GetNominalsOfContinuousStates", len(x))
    result(min(nominals) > 0 and Solved(model.fmu).count() == len(x), "%s: nominals" % name)


def check_astray(model, name):
    """An angle of many turns, and a quaternion too long, are put back by an event: the derivatives stay."""
    solved, wrong = begun(model), []
    x = solved.numbers("GetContinuousStates", len(model.states))
    turn = 2 * math.pi
    for i in model.turns + model.quaternions:
        there = list(x)
        if i in model.quaternions:
            there[i:i + 4] = [1.001 * a for a in x[i:i + 4]]
        else:
            there[i] = x[i] + 200 * turn
        solved.set_states(there)
        good = solved.complete() == OK and solved.wants_event and solved.event(0.0) is None and solved.has_moved
        back = solved.numbers("GetContinuousStates", len(x))
        good = good and solved.complete() == OK and not solved.wants_event and max(abs(a - b) for a, b in zip(x, back)) < 1e-3
        if not good:
            wrong.append(model.names[i])
    result(not wrong, "%s: %d states are put back by an event %s" % (name, len(model.turns + model.quaternions), wrong))
    solved.free()


def check_smooth(model, name):
    """Between two ticks a smooth function of time is on the straight line from its value at the one to that at the other."""
    words = re.search(r"fmu_smooth\[FMU_INPUTS \+ 1\] = \{(.*)\}", source_of(model.fmu, "fmu_model.h")).group(1).split(", ")
    references = [1 + i for i, word in enumerate(words) if word == "true"]
    solved = begun(model)
    off, moved = 0, 0

    def at(ticks):
        assert solved.set_time(ticks * model.step) == OK
        return solved.get((REFERENCE * len(references))(*references))

    for k in range(900, 5000, 37) if references else []:
        solved.event(k * model.step)
        for a, b, c, d, e in zip(at(k), at(k + 0.25), at(k + 0.5), at(k + 1), at(k)):
            moved += a != d
            off += abs(b - (0.75 * a + 0.25 * d)) + abs(c - 0.5 * (a + d)) + abs(e - a) > 2.0 ** -20 * (abs(a - d) + 2.0 ** -3 * abs(a))
    solved.free()
    if references:
        result(off == 0 and moved > 9, "%s: smooth functions of time go straight from tick to tick, %d moved, %d off" % (name, moved, off))


def run(path, matrices):
    fmu = Fmu(path)
    model = Model(fmu)
    kind = "<d" if "compile all with -DISO_REAL_DOUBLE" in source_of(fmu, fmu.identifier + ".h") else "<f"
    name = "%s, %s, %s" % (fmu.identifier, model.method, "double" if kind == "<d" else "float")
    wrong = check.wrong_in_variables(fmu) + check.wrong_in_structure(fmu)
    result(not wrong and len(model.states) > 0, "%s: the description is in order %s" % (name, wrong))
    exact = not model.quaternions + model.turns and (model.method == "euler" or "by_sines" not in source_of(fmu, fmu.identifier + ".c"))
    wrong, worst = steps_differ(model, kind, exact)
    result(not wrong, "%s: steps end where those of the plant end, %s %s" %
           (name, "to the last bit" if exact else "%.2g of the bound apart" % worst, wrong))
    result(steps_differ(model, kind, exact, 1e-3 * model.step)[0] != "", "%s: found: a step that ends elsewhere" % name)
    if kind == "<d":
        check_slopes(model, name)
    if matrices != "-":
        check_matrices(model, matrices, name)
    check_calls(model, name)
    check_state(model, name)
    check_smooth(model, name)
    if model.turns + model.quaternions:
        check_astray(model, name)


def run_alone(path):
    fmu = Fmu(path)
    solved = Solved(fmu)
    result(fmu.root.find("ModelExchange") is None and not solved.handle and solved.messages == [(ERROR, "this FMU has co-simulation alone")], "no instance %s" % solved.messages)


if __name__ == "__main__":
    given = sys.argv[1:]
    if given[0] == "--alone":
        run_alone(given[1])
        given = []
    for k in range(0, len(given), 2):
        run(given[k], given[k + 1])
    print("1..%d" % check.results)
