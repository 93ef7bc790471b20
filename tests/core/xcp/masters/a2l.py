"""Reads an A2L, and checks it by the grammar of ASAP2 1.6 as far as isoc writes it: every block has its parameters, of their types,
and names only what there is. What it does not know is an error."""
import re
import sys

TYPES = {"FLOAT32_IEEE": "f", "FLOAT64_IEEE": "d", "A_UINT64": "Q", "A_INT64": "q", "ULONG": "I", "SLONG": "i"}
SIZES = {"f": 4, "d": 8, "Q": 8, "q": 8, "I": 4, "i": 4}
NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.\[\]]*$")

# The parameters of a block: n a name, s a text in quotes, f a number, i a whole number, and words as they are; then the
# keywords that may follow, with theirs.
BLOCKS = {
    "PROJECT": ("ns", {}),
    "MODULE": ("ns", {}),
    "MOD_PAR": ("s", {"EPK": "s", "ADDR_EPK": "i"}),
    "MEMORY_SEGMENT": ("nsnnniiiiiii", {}),
    "MOD_COMMON": ("s", {"BYTE_ORDER": "n", "ALIGNMENT_BYTE": "i", "ALIGNMENT_WORD": "i", "ALIGNMENT_LONG": "i",
                         "ALIGNMENT_INT64": "i", "ALIGNMENT_FLOAT32_IEEE": "i", "ALIGNMENT_FLOAT64_IEEE": "i"}),
    "RECORD_LAYOUT": ("n", {"FNC_VALUES": "innn"}),
    "COMPU_METHOD": ("nsnss", {}),
    "MEASUREMENT": ("nsnnffff", {"ECU_ADDRESS": "i", "READ_WRITE": ""}),
    "CHARACTERISTIC": ("nsninfnff", {}),
    "GROUP": ("ns", {"ROOT": ""}),
}
INSIDE = {
    None: {"PROJECT"},
    "PROJECT": {"MODULE"},
    "MOD_PAR": {"MEMORY_SEGMENT"},
    "MODULE": {"MOD_PAR", "MOD_COMMON", "RECORD_LAYOUT", "COMPU_METHOD", "MEASUREMENT", "CHARACTERISTIC", "GROUP"},
}


class Bad(Exception):
    """The file is no A2L."""


class Tokens:
    def __init__(self, text):
        self.all = [m for m in re.finditer(r'"[^"\n]*"|[^\s"]+|"', re.sub(r"/\*.*?\*/", " ", text, flags=re.S))]
        self.at = 0

    def peek(self):
        return self.all[self.at].group() if self.at < len(self.all) else None

    def next(self, want=None):
        if self.at == len(self.all):
            raise Bad("ends too early")
        word = self.all[self.at].group()
        self.at += 1
        if want is not None and word != want:
            raise Bad("%r where %r is due" % (word, want))
        return word

    def parameter(self, kind):
        word = self.next()
        if kind == "s":
            if len(word) < 2 or word[0] != '"':
                raise Bad("%r is no text" % word)
            return word[1:-1]
        if kind == "n":
            if not NAME.match(word):
                raise Bad("%r is no name" % word)
            return word
        try:
            return int(word, 0) if kind == "i" else float(word)
        except ValueError:
            raise Bad("%r is no number" % word) from None


class A2l:
    """measurements and characteristics: name -> (address, type as of struct, unit, least, most); if_data: the words of each block
    of IF_DATA XCP."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            t = self.tokens = Tokens(file.read())
        self.blocks = {kind: {} for kind in BLOCKS}
        self.groups, self.if_data, self.events = {}, {}, []
        t.next("ASAP2_VERSION")
        t.parameter("i"), t.parameter("i")
        self.block(None)
        if t.peek() is not None:
            raise Bad("%r behind the end" % t.peek())
        self.resolve()

    def block(self, outer):
        t = self.tokens
        t.next("/begin")
        kind = t.next()
        if kind == "A2ML" or kind == "IF_DATA":
            words = self.skip(kind)
            if outer == "MEASUREMENT":
                self.events.append(words.get("DAQ_EVENT"))
            else:
                self.if_data.update(words)
            return
        if kind not in INSIDE.get(outer, set()):
            raise Bad("a %s in a %s" % (kind, outer))
        parameters, keywords = BLOCKS[kind]
        values = [t.parameter(k) for k in parameters]
        if values[0] in self.blocks[kind]:
            raise Bad("two of %s %s" % (kind, values[0]))
        content = {}
        while t.peek() != "/end":
            if t.peek() == "/begin" and kind == "GROUP":
                self.references(values[0])
            elif t.peek() == "/begin":
                self.block(kind)
            else:
                word = t.next()
                if word not in keywords:
                    raise Bad("%s in a %s" % (word, kind))
                content[word] = [t.parameter(k) for k in keywords[word]]
        t.next("/end")
        t.next(kind)
        self.blocks[kind][values[0]] = (values, content)

    def skip(self, kind):
        """The words of all blocks within, by the way to them."""
        t, way, words = self.tokens, [kind], {}
        while way:
            word = t.next()
            if word == "/begin":
                way.append(t.next())
            elif word == "/end":
                t.next(way.pop())
            else:
                words.setdefault(way[-1], []).append(word)
        return words if kind == "IF_DATA" else {}

    def references(self, group):
        t = self.tokens
        t.next("/begin")
        kind = t.next()
        if kind not in ("REF_MEASUREMENT", "REF_CHARACTERISTIC"):
            raise Bad("%s in a GROUP" % kind)
        self.groups[group] = (kind[4:], [])
        while t.peek() != "/end":
            self.groups[group][1].append(t.parameter("n"))
        t.next("/end")
        t.next(kind)

    def unit(self, method):
        if method == "NO_COMPU_METHOD":
            return ""
        if method not in self.blocks["COMPU_METHOD"]:
            raise Bad("no COMPU_METHOD %s" % method)
        values = self.blocks["COMPU_METHOD"][method][0]
        if values[2] != "IDENTICAL" or not re.match(r"%\d*\.\d+$", values[3]):
            raise Bad("COMPU_METHOD %s" % method)
        return values[4]

    def resolve(self):
        self.measurements, self.characteristics, self.inputs = {}, {}, []
        for name, (v, content) in self.blocks["MEASUREMENT"].items():
            if v[2] not in TYPES or ("READ_WRITE" in content and name[:2] != "u.") or "ECU_ADDRESS" not in content or v[6] > v[7]:
                raise Bad("MEASUREMENT %s" % name)
            self.inputs += [name] if "READ_WRITE" in content else []
            self.measurements[name] = (content["ECU_ADDRESS"][0], TYPES[v[2]], self.unit(v[3]), v[6], v[7])
        for name, (v, _) in self.blocks["CHARACTERISTIC"].items():
            if v[2] != "VALUE" or v[4] not in self.blocks["RECORD_LAYOUT"] or v[7] > v[8] or name in self.measurements:
                raise Bad("CHARACTERISTIC %s" % name)
            layout = self.blocks["RECORD_LAYOUT"][v[4]][1]["FNC_VALUES"]
            self.characteristics[name] = (v[3], TYPES[layout[1]], self.unit(v[6]), v[7], v[8])
        for kind, names in self.groups.values():
            for name in names:
                if name not in (self.measurements if kind == "MEASUREMENT" else self.characteristics):
                    raise Bad("a GROUP names %s" % name)
        parameters = next(iter(self.blocks["MOD_PAR"].values()))[1]
        self.epk_at = parameters["ADDR_EPK"][0]
        segment = self.blocks["MEMORY_SEGMENT"]["plant"][0]
        if segment[2:5] != ["VARIABLES", "RAM", "INTERN"] or segment[7:] != [-1] * 5:
            raise Bad("MEMORY_SEGMENT plant")
        self.segment = range(segment[5], segment[5] + segment[6])
        for name, (at, type_of, _, _, _) in {**self.measurements, **self.characteristics}.items():
            if not name.startswith("statistics.") and not (at in self.segment and at + SIZES[type_of] - 1 in self.segment):
                raise Bad("%s is beyond the MEMORY_SEGMENT" % name)
        if self.events != [["FIXED_EVENT_LIST", "EVENT", "0"]] * len(self.measurements):
            raise Bad("a MEASUREMENT without its DAQ_EVENT")
        self.epk = next(iter(self.blocks["MOD_PAR"].values()))[1]["EPK"][0]
        self.all = {**self.measurements, **self.characteristics}


if __name__ == "__main__":
    A2l(sys.argv[1])
