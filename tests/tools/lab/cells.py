"""Whether a page of a report has no number but those of its tables, and these are the files of a folder."""
import html.parser
import re

# Words with digits that are no measurements: names of methods, of cores and of number types.
NAMES = r"\b(rk4|ab4|abm4\w*|bdf4|cortex-m\w+|i\d+|rv32\w+|stm32\w+|2-norm)\b"


class Page(html.parser.HTMLParser):
    """Tables by file, and numbers in the text, each with the cell that it is of."""

    def __init__(self):
        super().__init__()
        self.tables, self.numbers, self.text = {}, [], []
        self.file = self.row = self.cell = self.datum = self.skipped = None

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        if tag in ("script", "style", "summary", "h1", "title"):
            self.skipped = tag
        elif tag == "table":
            self.file = given["data-file"]
            self.tables[self.file] = []
        elif tag == "tr":
            self.tables[self.file].append([])
        elif tag in ("td", "th"):
            self.cell = ""
        elif tag == "data":
            self.datum = [given["value"], given["data-cell"], ""]

    def handle_endtag(self, tag):
        if tag == self.skipped:
            self.skipped = None
        elif tag == "table":
            self.file = None
        elif tag in ("td", "th"):
            self.tables[self.file][-1].append(self.cell)
            self.cell = None
        elif tag == "data":
            self.numbers.append(self.datum)
            self.datum = None

    def handle_data(self, data):
        if self.cell is not None:
            self.cell += data
        elif self.datum is not None:
            self.datum[2] += data
        elif self.skipped is None and self.file is None:
            self.text.append(data)


def faults(text, folder):
    """Of the text of a page, whose tables are files of the folder: what is wrong; an error where it has no number."""
    page, found, files = Page(), [], {}
    page.feed(text)
    assert page.numbers and page.tables
    for name, table in page.tables.items():
        files[name] = [line.split("\t") for line in (folder / name).read_text().splitlines()]
        if files[name] != table:
            found.append(f"the table of {name} is another")
    for value, place, shown in page.numbers:
        name, row, column = place.split(":")
        cell = files[name][int(row) - 1][int(column) - 1] if name in files else None
        if cell != value or not abs(float(shown) - float(value)) <= 0.0051 * abs(float(value)):
            found.append(f"{shown} is not {cell}, {place}")
    for text in page.text:
        if re.search(r"\d", re.sub(NAMES, "", text)):
            found.append(f"a number of no cell: {text.strip()[:80]}")
    return found
