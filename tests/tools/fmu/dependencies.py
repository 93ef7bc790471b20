"""What outputs and derivatives of an FMU depend on, against its description: dependencies.py FMU [FMU ...]

In initialization mode each variable that can be set is moved, at points by chance: what follows is what lists it.
Between steps inputs move no output, and a tunable those that list it; where one is listed that moves nothing at the
start, such as a fault of what has not moved yet, it does so then. Prints TAP.
"""
import random
import sys

import check
import importer
from importer import OK

POINTS = 12


def listed_in(fmu, element):
    """The names that each unknown lists."""
    structure, version = fmu.root.find("ModelStructure"), fmu.version
    place, number = (structure, "valueReference") if version == 3 else (structure.find(element + "s"), "index")
    known = {v.reference if version == 3 else v.index: v.name for v in fmu.variables}
    found = {}
    for unknown in place.findall(element if version == 3 else "Unknown"):
        name = known[int(unknown.get(number))]
        assert name not in found
        found[name] = [known[int(word)] for word in unknown.get("dependencies").split()]
    return found


def number_for(variable, chance):
    """A value within limits."""
    least, most = (float(variable.element.get(end) or "nan") for end in ("min", "max"))
    around = float(variable.start)
    least = least if least == least else around - 2.0
    most = most if most == most else max(around, least) + 2.0
    return chance.uniform(least, most)


def unknowns_at(fmu, values, names):
    """What is unknown in initialization mode; None where the start is refused."""
    instance = importer.Instance(fmu)
    instance.enter()
    settings = [instance.set_name(name, value) for name, value in values.items()]
    numbers = instance.get(fmu.references(names)) if set(settings) <= {OK} else None
    instance.free()
    return numbers


def moved(before, after, names):
    return {n for n, a, b in zip(names, before, after) if check.bits([a]) != check.bits([b])}


def at_start(fmu, chance, names):
    """What moves each unknown in initialization mode, at any of the points."""
    free = [v for v in fmu.variables if v.causality == "input" or v.element.get("initial") == "exact"]
    found = {name: set() for name in names}
    for _ in range(POINTS):
        values = {v.name: number_for(v, chance) for v in free}
        before = unknowns_at(fmu, values, names)
        for v in free:
            after = unknowns_at(fmu, {**values, v.name: number_for(v, chance)}, names)
            for name in moved(before, after, names) if before and after else ():
                found[name].add(v.name)
    return found


def between_steps(fmu, chance):
    """The same between steps, of inputs and tunables."""
    names, step = fmu.outputs(), float(fmu.root.find("DefaultExperiment").get("stepSize"))
    references = fmu.references(names)
    found = {name: set() for name in names}
    instance = importer.Instance(fmu)
    instance.begin()
    for tick in range(0, 2000, 40):
        instance.step(40 * step, tick * step)
        for v in fmu.variables:
            if v.causality in ("input", "parameter"):
                before = instance.get(references)
                instance.set(v.reference, number_for(v, chance))
                for name in moved(before, instance.get(references), names):
                    found[name].add(v.name)
    instance.free()
    return found


def unlisted(found, listed):
    return ["%s of %s" % (of, name) for name in found for of in sorted(found[name] - set(listed[name]))]


def idle(found, listed, names):
    """What is listed and moves nothing."""
    return ["%s of %s" % (of, name) for name in found for of in listed[name] if of in names and of not in found[name]]


def test(path):
    fmu, chance = importer.Fmu(path), random.Random(path.rsplit("/", 1)[-1])
    name = "%s, FMI %d" % (fmu.identifier, fmu.version)
    listed, later = listed_in(fmu, "InitialUnknown"), listed_in(fmu, "Output")
    found, found_later = at_start(fmu, chance, list(listed)), between_steps(fmu, chance)
    settable = [v.name for v in fmu.variables if v.start is not None]
    ever = {n: found[n] | found_later.get(n, set()) for n in found}
    wrong = unlisted(found, listed) + idle(ever, listed, settable)
    check.result(not wrong, "%s: %d dependencies at the start %s" %
                 (name, sum(map(len, listed.values())), "; ".join(wrong)))
    wrong = unlisted(found_later, later) if fmu.version == 3 else []
    wrong += [v.name for v in fmu.variables if v.causality == "input" for of in later.values() if v.name in of]
    wrong += [v for of in found_later.values() for v in of if fmu.by_name[v].causality == "input"]
    check.result(not wrong, "%s: dependencies between steps %s" % (name, "; ".join(wrong)))
    one = next(n for n in listed if listed[n])
    less, more = {**listed, one: listed[one][1:]}, {**listed, one: settable}
    check.result(unlisted(found, less) == ["%s of %s" % (listed[one][0], one)] and idle(ever, more, settable),
                 "%s: found: one that is not listed, and one that is and has no part" % name)


if __name__ == "__main__":
    for archive in sys.argv[1:]:
        test(archive)
    print("1..%d" % check.results)
