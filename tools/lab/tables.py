"""`isochron tables`: writes the generated tables in Markdown files again. A table is between the lines

    <!-- isochron cost --parts models -->
    <!-- end -->

the first of which names the command that prints it; tables and lists of its output are kept."""
import pathlib
import re
import shlex
import subprocess
import sys

from lab import build
from lab.build import ROOT, Wrong

FILES = ['models/costs.md', 'models/cycles.md', 'models/README.md', 'models/chains.md', 'models/drift.md',
         'core/methods.md',
         'core/README.md', 'tests/digits.md']
TABLE = re.compile(r'^<!-- (isochron .*?) -->\n(.*?)(^<!-- end -->|\Z)', re.M | re.S)


def printed(command):
    """The table that a command prints."""
    print(f'  {command}', file=sys.stderr, flush=True)
    done = subprocess.run([sys.executable, ROOT / 'tools/isochron', *shlex.split(command)[1:]], cwd=ROOT,
                          stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True)
    if done.returncode:
        raise Wrong(f'failed: {command}')
    return ''.join(line + '\n' for line in done.stdout.splitlines() if re.match(r'[|-]|$', line)).rstrip('\n')


def rewritten(text):
    """The text of a file with the output of its commands."""
    def table(found):
        if not found[3]:
            raise Wrong('a table without an end')
        return f'<!-- {found[1]} -->\n\n{printed(found[1])}\n\n<!-- end -->'
    return TABLE.sub(table, text)


def run(options):
    build.tools('isoc')
    for file in options.words or FILES:
        path = pathlib.Path(file) if options.words else ROOT / file
        try:
            text = path.read_text()
            new = rewritten(text)
        except Wrong as wrong:
            raise Wrong(f'{wrong}; {file} stays as it is')
        if new != text:
            build.write(path, new)
        print(f'{file} is {"unchanged" if new == text else "rewritten"}')
