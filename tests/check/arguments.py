"""The calls in which more than one argument makes nodes of isoc's graph, and the initialisers of which more than one
does: C leaves open which of them comes first (tools/isoc/graph/graph.h).

A line is `FILE:LINE: FUNCTION: WHAT: ARGUMENT and ARGUMENT`, an argument by the functions that it calls.
"""
import pathlib
import re

TOKEN = re.compile(
    r"""(?P<comment>/\*.*?\*/|^[ \t]*\#(?:\\\n|[^\n])*)|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|->|\w+|\S""", re.S | re.M
)
WORD = re.compile(r"[A-Za-z_]\w*")
STATEMENTS = {"if", "for", "while", "switch", "FOR_EACH", "FOR_ALL"}
CLOSING = {"(": ")", "{": "}", "[": "]"}
CONSTANTS = {"constant"}  # their places in the order of nodes do not matter


class Source:
    """The tokens of a file, and what each bracket belongs to."""

    def __init__(self, path):
        text = path.read_text(encoding="utf-8")
        found = [m for m in TOKEN.finditer(text) if not m.group("comment")]
        self.path = path
        self.tokens = [m.group() for m in found]
        self.lines = [text.count("\n", 0, m.start()) + 1 for m in found]
        self.ends, opened = {}, []
        for i, token in enumerate(self.tokens):
            if token in CLOSING:
                opened.append(i)
            elif token in CLOSING.values():
                self.ends[opened.pop()] = i

    def before(self, i):
        return self.tokens[i - 1] if i > 0 else ""

    def functions(self):
        """The name, and the brackets of the body, of each function that is defined here."""
        i = 0
        while i < len(self.tokens):
            end = self.ends.get(i, i)
            is_call = self.tokens[i] == "(" and WORD.fullmatch(self.before(i))
            if is_call and self.tokens[end + 1 : end + 2] == ["{"]:
                yield self.before(i), end + 1, self.ends[end + 1]
                end = self.ends[end + 1]
            i = end + 1

    def is_call(self, i):
        return self.tokens[i] == "(" and WORD.fullmatch(self.before(i)) and self.before(i) not in STATEMENTS | {"sizeof"}

    def calls(self, start, end):
        return {self.before(i) for i in range(start, end) if self.is_call(i)}

    def is_list(self, i):
        """Whether a brace begins an initialiser: behind `=`, in another one, or behind the type of a literal."""
        before = self.before(i)
        if before != ")":
            return before in ("=", ",", "{", "]")
        start = next(k for k, end in self.ends.items() if end == i - 1)
        return not WORD.fullmatch(self.before(start)) or self.before(start) == "return"

    def arguments(self, i):
        """Start and end of each, between commas that are in no other brackets."""
        start, k = i + 1, i + 1
        while k < self.ends[i]:
            if self.tokens[k] == ",":
                yield start, k
                start = k + 1
            k = self.ends.get(k, k) + 1
        yield start, k


def makers(sources):
    """The functions that make nodes: those that call `intern`, and those that call one of them."""
    calls = {}  # by the file of a static function, or by None, and the name
    for source in sources:
        for name, start, end in source.functions():
            calls[source.path, name] = source.calls(start, end)
    names = {}
    for path, name in calls:
        names.setdefault(name, []).append(path)

    def meant(path, name):
        return [(path, name)] if (path, name) in calls else [(other, name) for other in names.get(name, [])]

    found, before = {key for key in calls if key[1] == "intern"}, 0
    while len(found) > before:
        before = len(found)
        found |= {
            key
            for key, own in calls.items()
            if key[1] not in CONSTANTS and any(callee in found for name in own for callee in meant(key[0], name))
        }
    return found, meant


def found(folder):
    """The lines of all sources of C below the folder, and how many functions make nodes."""
    sources = [Source(path) for path in sorted(pathlib.Path(folder).rglob("*.[ch]"))]
    made, meant = makers(sources)
    lines = []
    for source in sources:
        for name, start, end in source.functions():
            for i in range(start + 1, end):
                if not (source.is_call(i) or (source.tokens[i] == "{" and source.is_list(i))):
                    continue
                making = []
                for first, last in source.arguments(i):
                    calls = source.calls(first, last)
                    own = sorted(call for call in calls if any(key in made for key in meant(source.path, call)))
                    making += [", ".join(own)] if own else []
                if len(making) > 1:
                    what = source.before(i) if source.tokens[i] == "(" else "initialiser"
                    lines.append(f"{source.path}:{source.lines[i]}: {name}: {what}: {' and '.join(making)}")
    return lines, len(made)
