"""The effects of the library against their written laws (of_signals.py, of_joints.py, of_bodies.py): a scene of all of them, and
what of its rows is off."""
import os
import re

import of_bodies
import of_joints
import of_signals
from law import LAWS, GRAVITY, ROUNDING, STEP

FACTOR = 1.001


def kinds(folder):
    """The effects and outputs of a folder that have no law, and the laws that have no effect."""
    texts = {name: open("%s/%s" % (folder, name)).read() for name in os.listdir(folder) if name.endswith(".scene")}
    # What happens between two rows has tests of its own (test_rigid.py, tests/isoc/events/test_holds.py).
    there = {name[: -len(".scene")] for name, text in texts.items() if not re.search('^ *(when|hold) ', text, re.M)}
    lines = ["no law of " + name for name in sorted(there - set(LAWS))]
    lines += ["no effect " + name for name in sorted(set(LAWS) - there)]
    for name in sorted(there & set(LAWS)):
        text, shown, _ = LAWS[name]
        lines += [] if " %s {" % name in text else ["not in its scene: " + name]
        # Of an output that is a vector the parts are shown.
        for output in re.findall(r"^\s*output (\w+)|; output (\w+)", open("%s/%s.scene" % (folder, name)).read(), re.M):
            output = "".join(output)
            if not any(re.search(r"\.%s(_[xyz])?$" % output, line) for _, line, _ in shown):
                lines.append("no law of %s.%s" % (name, output))
    return lines


def outputs():
    yield from ((name, name, 1) for name in of_signals.of_inputs(0))
    for _, shown, _ in LAWS.values():
        yield from shown


def scene():
    lines = ["step %g ms" % (STEP * 1e3), "method rk4", "gravity (0, 0, %g) m/s^2" % -GRAVITY, of_signals.shared()]
    lines += [text for text, _, _ in LAWS.values()]
    for name, text, _ in outputs():
        # The parts of a formula that is a vector are outputs each.
        axes = ("(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1)") if text.startswith("specific_force") else ()
        lines += ["output shown_%s_%d = dot(%s, %s)" % (name, i, text, axis) for i, axis in enumerate(axes)]
        lines += [] if axes else ["output shown_%s = %s" % (name, text)]
    return "\n".join(lines) + "\n"


def rows_of(numbers):
    """The rows of the scene's outputs by name, a vector as a list."""
    rows = []
    for k, numbers_of_row in enumerate(numbers.tolist()):
        row = {"row": k}
        for name, _, columns in outputs():
            row[name] = numbers_of_row[:columns] if columns > 1 else numbers_of_row[0]
            del numbers_of_row[:columns]
        assert not numbers_of_row, "%d columns too many" % len(numbers_of_row)
        rows.append(row)
    return rows


def off(kind, wanted, rows, planted):
    """What is off: a line for each output, by its name."""
    lines = {}
    late = int(planted == "late")
    for k, row in enumerate(rows[late:], late):
        for name, want in wanted[k - late].items():
            want, tolerance = want if isinstance(want, tuple) else (want, 0)
            pairs = zip(want, row[name]) if isinstance(want, list) else [(want, row[name])]
            for w, got in pairs:
                w *= FACTOR if planted == "factor" else 1
                if not abs(got - w) <= tolerance + ROUNDING * (1 + abs(w)):
                    lines.setdefault(name, "%s: %s in row %d is %.15g, wanted %.15g" % (kind, name, k, got, w))
    return lines


def compare(rows, planted=""):
    """What is off: for each kind its lines."""
    laws = {"inputs": [of_signals.of_inputs(k) for k in range(len(rows))]}
    laws.update((kind, function(rows)) for kind, (_, _, function) in LAWS.items())
    return laws, {kind: off(kind, wanted, rows, planted) for kind, wanted in laws.items()}


def not_found(rows, planted):
    """The outputs in which a defect planted in the laws is not found. What is constant is never late."""
    laws, found = compare(rows, planted)
    return [(kind, name) for kind, wanted in laws.items() for name in wanted[0]
            if name not in found[kind] and (planted == "factor" or any(row[name] != wanted[0][name] for row in wanted))]
