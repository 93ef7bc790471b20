"""Tables: in Markdown, as the READMEs have them, and of cells with tabs between them, for programs."""
import os
import pathlib

from lab import build


def row(cells):
    """A line of a table in Markdown."""
    return '|' + ''.join(f' {cell} |' if str(cell) else ' |' for cell in cells)


def head(names, align=None):
    """The names of the columns and the line below them; `align` has an `l` or an `r` for each, by default one on the
    left, and numbers on the right."""
    align = align or 'l' + 'r' * (len(names) - 1)
    return row(names) + '\n|' + ''.join('---|' if side == 'l' else '--:|' for side in align)


def show(names, rows, align=None):
    """Prints a table, each row as soon as it is known. `rows` may be a generator that measures."""
    print(head(names, align), flush=True)
    for cells in rows:
        print(row(cells), flush=True)


def due(items):
    """Those of the items of a long table that are measured: all, or with TURN=PART/PARTS in the environment every
    PARTS-th, from PART on, from 0 (tests/use/test_tables.py)."""
    part, parts = map(int, os.environ.get('TURN', '0/1').split('/'))
    return list(items)[part::parts]


def read(path, separator='\t'):
    """The rows of a file of cells, each a list of texts without the spaces around them; no comment, no empty line."""
    return [[cell.strip() for cell in line.split(separator)]
            for line in pathlib.Path(path).read_text().splitlines() if line and not line.startswith('#')]


def write(path, rows):
    """Writes cells with tabs between them; the file is there when it is whole."""
    build.write(path, ''.join('\t'.join(map(str, cells)) + '\n' for cells in rows))
