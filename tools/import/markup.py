"""XML with places: elements that know where they stand, and which of their attributes were read.

Attributes and elements that are not read are not taken: `Document.not_taken` lists them.
"""
import math
import re
import xml.parsers.expat


class Stop(Exception):
    """The file cannot be read on; the problems are noted in the document."""


class Attributes:
    """An object with attributes: `get` reads one, and `holder` is the element that contains it."""

    def numbers(self, name, count, default=None):
        """A list of numbers: as many, or from `count[0]` to `count[1]`."""
        text = self.get(name)
        return default if text is None else numbers_of(self.holder(name), name, text, count)

    def number(self, name, default=None):
        found = self.numbers(name, 1)
        return default if found is None else found[0]


class Element(Attributes):
    """An element, with its attributes as text."""

    def __init__(self, document, parent, tag, attributes, offset):
        self.document = document
        self.parent = parent
        self.tag = tag
        self.attributes = attributes
        self.offset = offset  # of its '<' in the file, in bytes
        self.children = []
        self.text = ""
        self.taken = False  # the element itself; each attribute apart
        self.read = set()  # attributes that were read
        self.left = {}  # attributes that are not taken: why; of the element under ""
        self.reasons = {}  # of an element of defaults: why an attribute is not taken that nothing reads

    def where(self, attribute=None):
        """file:line:column of the element, or of one of its attributes."""
        source = self.document.source
        offset = self.offset
        if attribute is not None:
            found = re.compile(rb"\s" + re.escape(attribute.encode()) + rb"\s*=").search(source, offset)
            offset = found.start() + 1 if found else offset
        line = source.count(b"\n", 0, offset) + 1
        column = len(source[source.rfind(b"\n", 0, offset) + 1 : offset].decode("utf-8", "replace")) + 1
        return f"{self.document.path}:{line}:{column}"

    def line(self):
        return self.document.source.count(b"\n", 0, self.offset) + 1

    def problem(self, text, attribute=None):
        """Notes an error, and its correction."""
        self.document.problems.append(f"{self.where(attribute)}: error: {text}")

    def take(self, *attributes):
        """Takes the element, and attributes that add nothing."""
        self.taken = True
        self.read.update(attributes)
        return self

    def leave(self, why, *attributes):
        """Names the element with all in it, or attributes, as not taken."""
        for attribute in attributes or ("",):
            self.left[attribute] = why
            self.read.add(attribute)

    def leave_all(self, why, *tags):
        """Names the children of these tags, or all, as not taken."""
        for child in self.all(*tags) if tags else self.children:
            child.leave(why)

    def all(self, *tags):
        return [child for child in self.children if child.tag in tags]

    def one(self, tag):
        """The only child of a tag, or None."""
        found = self.all(tag)
        for other in found[1:]:
            other.problem(f"a second <{tag}> in <{self.tag}>: one is right")
        return found[0].take() if found else None

    def holder(self, _name):
        return self

    def get(self, name, default=None):
        self.read.add(name)
        return self.attributes.get(name, default)

    def name(self, what="name"):
        """An attribute that must be there."""
        text = self.get(what)
        if not text:
            self.problem(f"<{self.tag}> has no {what}: <{self.tag} {what}=\"...\">")
            return "unnamed"
        return text


def numbers_of(element, name, text, count):
    least, most = count if isinstance(count, tuple) else (count, count)
    words = text.split()
    values = []
    for word in words:
        try:
            value = float(word)
        except ValueError:
            value = math.nan
        if not math.isfinite(value) or "_" in word:
            element.problem(f"'{word}' is no number: {name}=\"{' '.join(['0.5'] * max(least, 1))}\"", name)
            return [0.0] * max(least, 1)
        values.append(value)
    if not least <= len(values) <= most:
        right = f"{least}" if least == most else f"{least} to {most}"
        element.problem(f"{len(values)} numbers in {name}: {right} are right", name)
        return ([*values, *[0.0] * least])[:most]
    return values


class Document:
    """A file as a tree of elements."""

    def __init__(self, path, problems=None):
        self.path = path
        self.problems = [] if problems is None else problems
        self.root = None
        self.parts = []  # documents that it includes
        try:
            with open(path, "rb") as file:
                self.source = file.read()
        except OSError as error:
            self.problems.append(f"{path}:1:1: error: it cannot be read: {error.strerror}")
            raise Stop from error
        self.parse()

    def parse(self):
        parser = xml.parsers.expat.ParserCreate()
        open_elements = []

        def begin(tag, attributes):
            parent = open_elements[-1] if open_elements else None
            element = Element(self, parent, tag, attributes, parser.CurrentByteIndex)
            if parent is None:
                self.root = element
            else:
                parent.children.append(element)
            open_elements.append(element)

        def text(data):
            if open_elements:
                open_elements[-1].text += data

        parser.StartElementHandler = begin
        parser.EndElementHandler = lambda tag: open_elements.pop()
        parser.CharacterDataHandler = text
        try:
            parser.Parse(self.source, True)
        except xml.parsers.expat.ExpatError as error:
            reason = xml.parsers.expat.errors.messages[error.code]
            self.problems.append(f"{self.path}:{error.lineno}:{error.offset + 1}: error: it is no XML: {reason}")
            raise Stop from error
        except LookupError as error:
            self.problems.append(f"{self.path}:1:1: error: it is no XML: {error}; UTF-8 is right")
            raise Stop from error
        if self.source.startswith((b"\xff\xfe", b"\xfe\xff")):
            self.problems.append(f"{self.path}:1:1: error: it is UTF-16: UTF-8 is right")
            raise Stop

    def not_taken(self, has_ended=True):
        """The parts that were not taken: (name, reason, lines), once for each kind. Before the reading has ended: only
        elements that were named so far."""
        kinds = {}

        def note(what, why, element):
            lines = kinds.setdefault((what, why), [])
            lines.append(element.line() if element.document is self else element.where())

        def walk(element):
            if "" in element.left:
                note(f"<{element.tag}>", element.left[""], element)
                return
            if has_ended and not element.taken:
                note(f"<{element.tag}>", "not known here", element)
                return
            for attribute in element.attributes if has_ended else ():
                if attribute in element.left:
                    note(f"{attribute} of <{element.tag}>", element.left[attribute], element)
                elif attribute not in element.read:
                    note(f"{attribute} of <{element.tag}>", "not known here", element)
            for child in element.children:
                walk(child)

        walk(self.root)
        return [(what, why, lines) for (what, why), lines in kinds.items()]
