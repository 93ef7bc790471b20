"""Reads what `isoc --equations` writes, as text and as LaTeX, into the same trees. Knows nothing of isoc but these documents.

A tree is a tuple: ("number", TEXT), ("name", NAME), ("call", FUNCTION, ARGUMENTS), ("sum", [(SIGN, TREE)]) with signs 1 and -1,
("product", [(POWER, TREE)]) with powers of whole numbers, ("compare", SIGN, LEFT, RIGHT).
"""
import re

GREEK = "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau upsilon phi chi psi omega pi Phi"
NUMBER = r"\d+(?:\.\d+)?(?:e[-+]?\d+)?"


def words_of_text(line):
    words, rest = [], line
    while rest.strip():
        found = re.match(rf"\s*({NUMBER}|[A-Za-z_]\w*|>=|[-+*/^(),\[\]>=])", rest)
        if not found:
            raise ValueError("no word: " + rest)
        words.append(found[1])
        rest = rest[found.end() :]
    return words


def group(text, at):
    """The end of the group of braces that begins there."""
    depth = 0
    for i in range(at, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return i + 1
    raise ValueError("an open brace: " + text[at:])


def name_of_latex(text, at):
    """The end of a symbol with its subscript, or `at` where none begins there."""
    head = re.match(r"\\(?:overline|ddot|dot|mathrm)(?=\{)|\\(?:%s)(?![a-zA-Z])|[A-Za-z]|(?=\{D)" % GREEK.replace(" ", "|"), text[at:])
    if not head:
        return at
    end = at + head.end()
    if text[end : end + 1] == "{":
        end = group(text, end)
    return group(text, end + 1) if text[end : end + 2] == "_{" else end


PLAIN = [(r"\displaystyle", ""), (r"\left|", " abs( "), (r"\right|", " ) "), (r"\left(", "("), (r"\right)", ")"), (r"\lfloor", " floor("),
         (r"\rfloor", ")"), (r"\ge", ">="), (r"\,", " * "), (r"\tfrac{\mathrm{d}}{\mathrm{d}t}", " der ")]  # fmt: skip


def words_of_latex(line):
    """The words of a text that says the same, with symbols as they are spelled."""
    line = re.sub(rf"({NUMBER}) \\cdot 10\^\{{(-?\d+)\}}", r"\1e\2", line)
    for spelling, plain in PLAIN:
        line = line.replace(spelling, plain)
    line = line.replace(r"\cdot", " * ")
    words, at = [], 0
    while at < len(line):
        rest = line[at:]
        call = re.match(r"\\operatorname\{(\w+)\}(?:_\{(\d+)\})?|\\(min|max|sin|cos|exp|ln|tanh)(?![a-z])", rest)
        plain = re.match(rf"\s+|{NUMBER}|>=|der|abs|floor|[-+*/(),\[\]>=]", rest)
        end = name_of_latex(line, at)
        if rest.startswith("\\frac{") or rest.startswith("\\sqrt{"):
            first = at + 5
            middle = group(line, first)
            end = group(line, middle) if rest[1] == "f" else middle
            words += ["sqrt"] * (rest[1] == "s") + ["("] * 2 + words_of_latex(line[first + 1 : middle - 1]) + [")"]
            words += (["/", "("] + words_of_latex(line[middle + 1 : end - 1]) + [")"]) * (rest[1] == "f") + [")"]
            at = end
        elif call:
            words.append({"ln": "log"}.get(call[3], call[3]) or call[1] + ("_" + call[2] if call[2] else ""))
            if call[1]:
                words[-1] = words[-1].replace("\\_", "_")
            at += call.end()
        elif rest.startswith("^{"):
            words += ["^", line[at + 2 : group(line, at + 1) - 1]]
            at = group(line, at + 1)
        elif plain:
            words += [plain[0]] * bool(plain[0].strip())
            at += plain.end()
        elif end > at:
            words.append("$" + line[at:end])
            at = end
        else:
            raise ValueError("no word: " + rest)
    return words


MINUS_ONE = (1, ("number", "-1"))


def signed(sign, tree):
    """A term: the sign of a factor in parentheses, as of (-a b) / c, is that of the term."""
    if tree[0] != "product" or MINUS_ONE not in tree[1]:
        return sign, tree
    factors = [factor for factor in tree[1] if factor != MINUS_ONE]
    sign *= (-1) ** (len(tree[1]) - len(factors))
    return sign, factors[0][1] if len(factors) == 1 and factors[0][0] == 1 else ("product", factors)


class Reader:
    def __init__(self, words):
        self.words, self.at = words, 0

    def next(self):
        return self.words[self.at] if self.at < len(self.words) else ""

    def take(self, wanted=None):
        word = self.next()
        if wanted is not None and word != wanted:
            raise ValueError(f"{wanted} is missing before {' '.join(self.words[self.at:])}")
        self.at += 1
        return word

    def sum(self):
        sign = -1 if self.next() == "-" else 1
        self.at += sign < 0
        terms = [signed(sign, self.product())]
        while self.next() in ("+", "-"):
            sign = 1 if self.take() == "+" else -1
            terms.append(signed(sign, self.product()))
        return terms[0][1] if terms == [(1, terms[0][1])] else ("sum", terms)

    def product(self):
        factors = self.power(1)
        while self.next() in ("*", "/"):
            factors += self.power(1 if self.take() == "*" else -1)
        return factors[0][1] if factors[0][0] == 1 and len(factors) == 1 else ("product", factors)

    def power(self, side):
        """Factors: those of a product in parentheses are factors of the product around it."""
        base = self.atom()
        exponent = 1
        if self.next() == "^":
            self.take()
            exponent = int(self.take())
        if base[0] == "sum" and len(base[1]) == 1 and exponent == 1:
            inner = base[1][0][1]
            factors = inner[1] if inner[0] == "product" else [(1, inner)]
            return [(side * power, tree) for power, tree in factors] + [MINUS_ONE]
        if base[0] == "product" and exponent == 1:
            return [(side * power, tree) for power, tree in base[1]]
        return [(side * exponent, base)]

    def arguments(self):
        self.take("(")
        found = [self.sum()]
        while self.next() == ",":
            self.take()
            found.append(self.sum())
        self.take(")")
        return found

    def atom(self):
        word = self.take()
        if word == "(":
            inner = self.sum()
            self.take(")")
            return inner
        if word == "[":
            left = self.sum()
            sign = self.take()
            right = self.sum()
            self.take("]")
            return ("compare", sign, left, right)
        if re.fullmatch(NUMBER, word):
            return ("number", word)
        if word == "der" and self.next() != "(":
            return ("call", "der", [self.atom()])
        if self.next() == "(":
            return ("call", word, self.arguments())
        if not re.match(r"[A-Za-z$]", word):
            raise ValueError("no beginning: " + word)
        return ("name", word)


def equation(words):
    reader = Reader(words)
    left = reader.atom()
    reader.take("=")
    right = reader.sum()
    if reader.at < len(words):
        raise ValueError("too long: " + " ".join(words))
    return left, right


def text(document):
    """The lists by their first word, each of symbols; and the parts by their titles, each of equations."""
    lists, parts, now, rows = {}, {}, None, None
    for line in document.splitlines():
        if line.startswith("## "):
            now = parts.setdefault(line[3:], [])
        elif line.startswith("#   "):
            rows.append(line.split()[1])
        elif line.startswith("# "):
            rows = lists.setdefault(line[2:].split(":")[0], []) if ": symbol" in line else rows
        elif line:
            now.append(equation(words_of_text(line)))
    return lists, parts


def latex(document):
    """The same: symbols as they are spelled, behind a dollar sign."""
    lists, parts, now, rows = {}, {}, None, None
    for line in document.splitlines():
        title = re.fullmatch(r"\\section\*\{(.*)\}", line)
        heading = re.fullmatch(r"\\subsubsection\*\{(.*)\}", line)
        if title:
            now = parts.setdefault(title[1], [])
        elif heading and ": symbol" in line:
            rows = lists.setdefault(heading[1].split(":")[0], [])
        elif line.startswith("$\\displaystyle"):
            now.append(equation(words_of_latex(re.fullmatch(r"\$(.*)\$\\par", line)[1])))
        elif re.match(r"\$.* & \$", line):
            rows.append("$" + line[1 : line.index("$", 1)])
    return lists, parts


def is_closed(document):
    """Whether braces, dollars, \\left and environments are closed."""
    plain = re.sub(r"\\[\\{}#$%&_]", "", document)
    depth = open_left = 0
    for sign in re.findall(r"[{}]|\\left(?![a-z])|\\right(?![a-z])", plain):
        depth += {"{": 1, "}": -1}.get(sign, 0)
        open_left += {"\\left": 1, "\\right": -1}.get(sign, 0)
        if depth < 0 or open_left < 0:
            return False
    begun = []
    for begin, end in re.findall(r"\\begin\{(\w+)\}|\\end\{(\w+)\}", plain):
        if begin:
            begun.append(begin)
        elif not begun or begun.pop() != end:
            return False
    return depth == 0 and open_left == 0 and not begun and all(line.count("$") % 2 == 0 for line in plain.splitlines())


def same(a, b, names):
    """Whether two trees differ in the spelling of names alone, each name in one way; `names` has both directions."""
    if a[0] != b[0]:
        return False
    if a[0] == "number":
        return float(a[1]) == float(b[1])
    if a[0] == "name":
        return names.setdefault(("text", a[1]), b[1]) == b[1] and names.setdefault(("latex", b[1]), a[1]) == a[1]
    if a[0] == "call":
        return a[1] == b[1] and len(a[2]) == len(b[2]) and all(same(x, y, names) for x, y in zip(a[2], b[2]))
    if a[0] == "compare":
        return a[1] == b[1] and same(a[2], b[2], names) and same(a[3], b[3], names)
    return len(a[1]) == len(b[1]) and all(m == n and same(x, y, names) for (m, x), (n, y) in zip(a[1], b[1]))
