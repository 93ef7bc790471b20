"""Programs of the host that are compiled with a plant, beside those of build/: what steps plants to measure them."""
import os
import pathlib
import re
import shlex
import subprocess

from lab import build


def compiler(real='float', optimise='-O2'):
    """The beginning of a command."""
    facts = build.port('host', real).facts
    return [*shlex.split(facts['CC']), *shlex.split(facts['WARNINGS']), optimise, *shlex.split(facts['NUMERICS']),
            *(['-DISO_REAL_DOUBLE'] if real == 'double' else []), '-D_POSIX_C_SOURCE=200809L', '-I', build.ROOT,
            *(['-Wno-error', *shlex.split(os.environ['CFLAGS'])] if os.environ.get('CFLAGS') else [])]


def path(source):
    """A source by its path from the root, or of any folder."""
    return source if isinstance(source, pathlib.Path) else build.ROOT / source


def compiled(source, made, real='float', flags=()):
    """The object of a source in a folder, `made`."""
    made = made / (pathlib.Path(source).stem + f'_{real}.o')
    build.call([*compiler(real), *flags, '-c', path(source), '-o', made])
    return made


def program(made, sources, real='float', flags=()):
    """Compiles and links sources and objects into the program `made`."""
    build.call([*compiler(real), *flags, *map(path, sources), '-o', made, '-lm'])
    return made


def counted(function, command, environment=None):
    """The instructions of the function in a run of the command on this machine; and what that prints."""
    done = subprocess.run(['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', f'--toggle-collect={function}',
                           *map(str, command)], env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    found = re.search(r'Collected : (\d+)', done.stderr)
    if done.returncode or not found or found[1] == '0':
        raise build.Wrong(f'callgrind does not count {function} of {command[0]}')
    return int(found[1]), done.stdout
