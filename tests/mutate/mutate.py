"""The work of tests/mutate.sh: lists the mutations of a C file, tries each in a copy of the project, and tells what survives.

A mutation changes one line: a sign, a comparison or another operator, a constant, two arguments, a statement that is left
out, or one that changes places with the next. Of a header or a source of core the tests are the unit tests whose program is
compiled from it, by the list of files that the compiler prints, first that of its name; of any file also the scripts of tests/ that name it, with its
folder, the shortest by tests/times first and none of more than SCRIPT_SECONDS. A mutation that does not compile is none, and one
that leaves the code of every function in the objects of its tests as it was is equivalent.
"""
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path.cwd()
WORK = ROOT / "build/tests/mutations"
COPY = WORK / "project"
RESULTS = WORK / "results"
KNOWN = ROOT / "tests/mutate/equivalent.txt"
SCRIPT_SECONDS = 5  # of processor time, by tests/times
PATIENCE = 60  # seconds that a test may take: a mutation that hangs is found
APART = "-O2 -fno-inline -fno-ipa-cp -fno-ipa-sra -fno-ipa-vrp -fkeep-static-functions -fkeep-inline-functions".split()
FLAGS = ["-std=c11", "-w", *(ROOT / "tools/build/numerics").read_text().split(), "-DISO_UNROLL=", "-I."]

OPERATORS = {
    " + ": [" - "], " - ": [" + "], " * ": [" + "], " / ": [" * "], " % ": [" / "], " += ": [" -= "], " -= ": [" += "],
    "++": ["--"], "--": ["++"], " < ": [" <= ", " > "], " <= ": [" < ", " > "], " > ": [" >= ", " < "],
    " >= ": [" > ", " < "], " == ": [" != "], " != ": [" == "], " && ": [" || "], " || ": [" && "], " & ": [" | "],
    " | ": [" & "], " ^ ": [" | "], " << ": [" >> "], " >> ": [" << "], " |= ": [" &= "], " ^= ": [" |= "],
    "true": ["false"], "false": ["true"],
}
TOKENS = re.compile("|".join(sorted((re.escape(o) for o in OPERATORS), key=len, reverse=True)))
NUMBER = re.compile(r"(?<![\w.])(0x[0-9A-Fa-f]+|\d+\.\d+(?:e[-+]?\d+)?|\d+)(?![\w.]*\")(?=[\s,;)\]}UuLl*/+:-]|$)")
PREFIX = re.compile(r"(?<=[(,=&|] )[!~-](?=[\w(])|(?<=\()[!~-](?=[\w(])")
PAIR = re.compile(r"(?<=\()([\w.\[\]>-]+), ([\w.\[\]>-]+)(?=\))")
STATEMENT = re.compile(r"^\s+(?!return|const|static|typedef|enum|struct|else|if|for|while|do\b|goto|break|continue|case)"
                       r"[\w*(].*;$")


def code_lines(text):
    """The lines with comments, strings and lines of the preprocessor as blanks of the same length."""
    blank = re.sub(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"', lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)
    return ["" if line.lstrip().startswith("#") else line for line in blank.split("\n")]


def changed_number(word):
    if word.startswith("0x"):
        return hex(int(word, 16) ^ 1)
    return str(int(word) + 1) if word.isdigit() else f"(1.0009765625 * {word})" if "e" in word else word + "9" \
        if float(word) == 0 else re.sub(r"\d\.", lambda m: str((int(m.group()[0]) + 1) % 10) + ".", word, count=1)


def are_bound(one, other):
    """Whether one of two assignments writes what the other reads or writes."""
    def written(text):
        place = re.split(r"(?:[-+*/&|^]|<<|>>)?= ", text, maxsplit=1)[0].strip(" *+-;")
        return re.escape(place)
    return any(re.search(rf"(?<![\w.>]){written(a)}(?!\w)", b) for a, b in ((one, other), (other, one)))


def mutations(path):
    """(line, column, old text, new text) of all; the line that follows one that changes places with it is part of both."""
    lines = (ROOT / path).read_text().split("\n")
    code = code_lines("\n".join(lines))
    for i, (line, seen) in enumerate(zip(lines, code)):
        def with_text(begin, end, new):
            return (i + 1, begin + 1, line, line[:begin] + new + line[end:])

        for m in TOKENS.finditer(seen):
            for new in OPERATORS[m.group()]:
                yield with_text(m.start(), m.end(), new)
        for m in NUMBER.finditer(seen):
            yield with_text(m.start(), m.end(), changed_number(m.group()))
        for m in PREFIX.finditer(seen):
            yield with_text(m.start(), m.end(), "")
        for m in PAIR.finditer(seen):
            yield with_text(m.start(), m.end(), f"{m.group(2)}, {m.group(1)}")
        if STATEMENT.match(seen) and not re.match(r"\s+\w+ (\*?\w+)( =|;|\[)", seen):
            yield (i + 1, 1, line, "")
            if i + 1 < len(lines) and STATEMENT.match(code[i + 1]) and are_bound(seen, code[i + 1]) and \
                    len(line) - len(line.lstrip()) == len(lines[i + 1]) - len(lines[i + 1].lstrip()):
                yield (i + 1, 1, line + "\n" + lines[i + 1], lines[i + 1] + "\n" + line)


def run(command, folder, seconds=PATIENCE):
    try:
        return subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds,
                              env={**os.environ, "MAKEFLAGS": "", "MAKELEVEL": ""}).returncode
    except subprocess.TimeoutExpired:
        return -1


def unit_programs(path):
    """The unit tests that the compiler reads this file for, with the sources of each."""
    found = []
    for test in sorted((ROOT / "tests/core").glob("*/*.c")):
        sources = [test] + sorted(test.with_suffix("").glob("*.c"))
        if '"tests/general.h"' in test.read_text():
            sources.append(ROOT / "tests/general.c")
        read = subprocess.run(["gcc", *FLAGS, "-MM", *map(str, sources)], capture_output=True, text=True).stdout
        if path in read.replace("\\\n", " ").split():
            found.append([str(s.relative_to(ROOT)) for s in sources])
    stem = pathlib.Path(path).stem
    return sorted(found, key=lambda s: (pathlib.Path(s[0]).stem != stem, sum((ROOT / part).stat().st_size for part in s)))


def scripts(path):
    """Those that name the file, the shortest first."""
    took = {}
    for line in (ROOT / "tests/times").read_text().split("\n"):
        if line.strip():
            took[line.split()[1]] = float(line.split()[0])
    named = [str(s.relative_to(ROOT)) for pattern in ("*.t", "test_*.py") for s in (ROOT / "tests").rglob(pattern)
             if re.search(rf"\b{re.escape(path)}\b", s.read_text())]
    return sorted((s for s in named if took.get(s, 0) <= SCRIPT_SECONDS), key=lambda s: took.get(s, 0))


class Tests:
    """What is run for a file: programs first, then scripts."""

    def __init__(self, path):
        given = os.environ.get("TESTS", "").split()
        self.programs = [] if given else unit_programs(path) if path.startswith("core/") else []
        self.scripts = given or scripts(path)
        self.tools = path.startswith("tools/") or "build/isoc" in "".join((ROOT / s).read_text() for s in self.scripts)

    def names(self):
        return [sources[0] for sources in self.programs] + self.scripts

    def objects(self):
        """The bytes of all programs, optimised, each function by itself: not as its callers' constants leave it."""
        made = []
        for sources in self.programs:
            for real in ([], ["-DISO_REAL_DOUBLE"]):
                for source in sources:
                    run(["gcc", *FLAGS, *real, *APART, "-c", source, "-o", str(WORK / "object.o")], COPY)
                    made.append((WORK / "object.o").read_bytes())
        return made

    def find(self):
        """The test that fails, None if none does; 'compiler' if one does not compile."""
        for sources in self.programs:
            for real in ([], ["-DISO_REAL_DOUBLE"]):
                program = WORK / "program"
                ports = [str(p.relative_to(COPY)) for p in [*(COPY / "port/host").glob("*.c"), COPY / "port/unix/console.c"]]
                if run(["gcc", *FLAGS, *real, "-O1", *sources, "tests/tap.c", *ports, "-lm", "-o", str(program)], COPY):
                    return "compiler"
                if run([str(program)], COPY):
                    return sources[0]
        if self.tools and self.scripts and run(["make", "build/isoc", "build/trace"], COPY, 300):
            return "compiler"
        for script in self.scripts:
            if run(["pytest-3", script], COPY, 600):
                return script
        return None


def copy_project():
    """The sources, and the tools with their dates, so that what is built is not built again."""
    shutil.rmtree(COPY, ignore_errors=True)
    COPY.mkdir(parents=True)
    tar = "{ find . ! -type d ! -path './build/*' ! -path './.git/*'; find build -maxdepth 1 -type f ! -name lock; " \
        "find build/obj/tools -type f; } 2>/dev/null | tar -cf - -T - | tar -xf - -C " + str(COPY)
    subprocess.run(["sh", "-c", tar], check=True)


def known():
    """FILE | old | new | reason, of lines without their indentation."""
    rows = [row.split(" | ", 3) for row in KNOWN.read_text().split("\n") if row and not row.startswith("#")]
    return {(r[0], r[1], r[2]) for r in rows if len(r) == 4}


def flat(text):
    return " / ".join(part.strip() for part in text.split("\n"))


def try_file(path, tests, tried, equivalent, until):
    """Counts and survivors of one file."""
    counts = dict.fromkeys(("killed", "survived", "equivalent", "no mutation"), 0)
    survivors, left = [], 0
    every = list(dict.fromkeys(mutations(path)))
    chosen = every
    if os.environ.get("MUTATIONS"):
        drawn = random.Random(int(os.environ.get("SEED", "1"))).sample(every, min(len(every), int(os.environ["MUTATIONS"])))
        chosen = sorted(drawn)
    before = None
    original = (ROOT / path).read_text()
    for line, column, old, new in chosen:
        key = "\t".join((path, flat(old), flat(new), " ".join(tests.names())))
        if key not in tried:
            if time.time() > until:
                left += 1
                continue
            lines = original.split("\n")
            lines[line - 1:line + old.count("\n")] = new.split("\n")
            (COPY / path).write_text("\n".join(lines))
            found = tests.find()
            if found is None and tests.programs and not tests.scripts:
                after = tests.objects()
                (COPY / path).write_text(original)
                before = before or tests.objects()
                found = "same code" if after == before else None
            (COPY / path).write_text(original)
            tried[key] = found or "survived"
            with RESULTS.open("a") as file:
                file.write(f"{key}\t{tried[key]}\n")
        result = tried[key]
        is_equivalent = result == "same code" or (path, flat(old), flat(new)) in equivalent
        kind = "no mutation" if result == "compiler" else "equivalent" if is_equivalent else \
            "survived" if result == "survived" else "killed"
        counts[kind] += 1
        if kind == "survived":
            survivors.append(f"{path}:{line}:{column}: {flat(old)}  ->  {flat(new) or '(left out)'}")
    return counts, survivors, left, len(every)


def main():
    tried = {}
    if RESULTS.exists() and os.environ.get("AGAIN") != "yes":
        tried = dict(row.rsplit("\t", 1) for row in RESULTS.read_text().split("\n") if row)
    copy_project()
    until = time.time() + float(os.environ.get("SECONDS") or "inf")
    equivalent = known()
    any_survivor = False
    for path in sys.argv[1:]:
        tests = Tests(path)
        print(f"{path}: {' '.join(tests.names()) or 'no test names it or is compiled from it'}", flush=True)
        if not tests.names():
            continue
        fails = tests.find()
        if fails is not None:
            sys.exit(f"{path}: a test fails without a mutation: {fails}")
        counts, survivors, left, all_of_it = try_file(path, tests, tried, equivalent, until)
        for survivor in survivors:
            print(survivor)
        any_survivor = any_survivor or survivors
        total = counts["killed"] + counts["survived"] + counts["equivalent"]
        print(f"{path}: {total} mutations of {all_of_it}: {counts['killed']} killed, {counts['survived']} survived, "
              f"{counts['equivalent']} equivalent; {counts['no mutation']} did not compile"
              + (f"; {left} left for lack of time" if left else ""), flush=True)
    sys.exit(1 if any_survivor else 0)


main()
