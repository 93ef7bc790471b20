#!/usr/bin/env python3
"""Files of robots with a few attributes and elements changed: mutated.py FOLDER SEED COUNT. Each is taken or refused;
none ends the program, or keeps it for ever. TAP."""
import os
import random
import re
import signal
import sys
import traceback

from write_robots import ROOT, load_import, made_of

NUMBERS = ["0", "-1", "1e-50", "1e400", "nan", "inf", "0 0", "-1 1", "1 2", "0 0 0", "0 0 0 0"]
WORDS = ["", "a", "..", *"true false auto free ball hinge slide fixed world main".split()]
ATTRIBUTE = re.compile(r'(\w+)="([^"]*)"')
ELEMENT = re.compile(r"<\w+[^<>]*/>")


def mutated(r, text):
    """With one change: a value, an attribute or an element of others, twice, or absent."""
    found = list((ELEMENT if r.random() < 0.3 else ATTRIBUTE).finditer(text))
    if not found:
        return text
    one, other = r.choice(found), r.choice(found)
    by = r.choice(["", one.group() + " " + one.group(), other.group()])
    start, end = one.span()
    if one.re is ATTRIBUTE and r.random() < 0.6:
        by, (start, end) = r.choice([*NUMBERS, *WORDS, other.group(2)]), one.span(2)
    return text[:start] + by + text[end:]


def too_long(*_):
    raise TimeoutError


def main():
    folder, seed, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    r, program = random.Random(seed), load_import()
    sources = [made_of(family, seed + k, folder).text() for k in range(12) for family in ("usual", "odd")]
    for name in ("arm.urdf", "rig.xml", "rig_classes.xml"):
        with open(os.path.join(ROOT, "tests", "tools", "import", name), encoding="utf-8") as file:
            sources.append(file.read())
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:  # the rig includes its classes
            file.write(sources[-1])
    path = os.path.join(folder, "mutated.xml")
    signal.signal(signal.SIGALRM, too_long)
    failed = 0
    for _ in range(count):
        text = r.choice(sources)
        for _ in range(r.randrange(1, 5)):
            text = mutated(r, text)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        options = program.parser().parse_args([path, *["--floating"] * (r.random() < 0.3), *["--repair-inertia"] * (r.random() < 0.3)])
        signal.alarm(60)  # what takes so long does not end
        try:
            program.imported(path, options)
        except Exception:
            failed += 1
            print("".join(f"# {line}\n" for line in (traceback.format_exc() + text).split("\n")), end="")
            break
    signal.alarm(0)
    print(f"{'not ' if failed else ''}ok 1 - of {count} mutated files, from seed {seed}, each is taken or refused")
    print("1..1")
    return failed


if __name__ == "__main__":
    sys.exit(main())
