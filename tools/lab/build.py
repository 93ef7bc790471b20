"""Plants as programs: the tools of the host, the folder of a scene, its program, and its runs. Every command of
`isochron` that runs a plant does so here, and none calls make or isoc by itself.

    bench = plant(options)                  # or plant('arm.scene', target='cortex-m4f', method='rk4', set='mass = 2 kg')
    run = bench.run('10 s')
    run.summary['hash'], run.trace

Paths of scenes and folders are of any characters. Whatever is wrong is a `Wrong`, which front.main prints as one line.
"""
import contextlib
import decimal
import difflib
import fcntl
import functools
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]     # the sources: a checkout, or what was installed
HOST_TOOLS = ROOT / 'build'
# Of the options of a command, those that isoc has by the same names.
ISOC_OPTIONS = 'method step tolerance inputs set without'.split()
REAL_FLAGS = {'float': [], 'double': ['-DISO_REAL_DOUBLE']}
KINDS = 'run linked calibrated recorded conform sweep python none'.split()


class Wrong(Exception):
    """What a user can put right: one line, or the lines of another program that said it already (no text)."""


# --- Programs --------------------------------------------------------------------------------------------------------

@contextlib.contextmanager
def progress(text, after=2.0):
    """What takes longer than some seconds says what it is, on the standard error."""
    timer = threading.Timer(after, lambda: print(f'  {text} ...', file=sys.stderr, flush=True))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


@contextlib.contextmanager
def overheard():
    """What this process and its programs say on the standard error goes to the file that this gives."""
    with tempfile.TemporaryFile('w+') as file:
        before = os.dup(2)
        os.dup2(file.fileno(), 2)
        try:
            yield file
        finally:
            os.dup2(before, 2)
            os.close(before)


def call(command, **how):
    """What a command prints, as text; it says itself what is wrong, and then the command of isochron ends. With
    stderr=PIPE a Wrong has that."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, text=True, **how)
    if done.returncode:
        if done.stderr:
            raise Wrong(done.stderr.strip())
        raise Wrong(done.stdout.strip().splitlines()[-1] if done.stdout and how.get('stderr') else '')
    return done.stdout


def need(names, install):
    """Ends with a message if a program is missing; PROGRAM:FILE is a file that this compiler must find."""
    for name in names:
        program, _, file = name.partition(':')
        found = shutil.which(program)
        if found and file:
            found = call([program, f'-print-file-name={file}']).strip() != file
        if not found:
            raise Wrong(f'{file or program} is missing. Install it with: {install}')


def processors():
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, 'sched_getaffinity') else os.cpu_count() or 1


def make(goals, makefile='Makefile', quiet=False, without=(), **variables):
    """Calls make in the root of the project with a goal or more; what it prints goes to the standard error, but for the
    value of this function where the goal is `print`. If it is `quiet`, an error has all that it said. Variables of the
    environment may be left out."""
    need(['make'], 'apt-get install make')
    without = ('MAKEFLAGS', 'MFLAGS', 'MAKELEVEL', *without)
    environment = {name: value for name, value in os.environ.items() if name not in without}
    if '-include ' in environment.get('CFLAGS', ''):      # of a file in the folder of the user
        environment['CFLAGS'] += f' -I{for_make(pathlib.Path.cwd())}'
    command = ['make', '-s', '--no-print-directory', '-C', ROOT, '-f', makefile, *goals.split(),
               *(f'{name}={value}' for name, value in variables.items())]
    if goals == 'print':
        return call(command, env=environment)
    done = subprocess.run([*map(str, command), f'-j{processors()}'], env=environment, text=True,
                          **({'capture_output': True} if quiet else {'stdout': sys.stderr}))
    if done.returncode:
        raise Wrong(done.stdout + done.stderr if quiet else '')
    return ''


@functools.cache
def tools(*names):
    """The paths of tools of the host (isoc, trace, link, show, cycles ...), which make makes if they are missing or
    older than their sources. An installed isochron has them."""
    if (ROOT / 'Makefile').exists() and not os.environ.get('TEST_BUILT'):
        with held(HOST_TOOLS, 'the tools'):
            make(' '.join(f'build/{name}' for name in names), without=['CFLAGS'])       # which are of plants
    paths = [HOST_TOOLS / name for name in names]
    for path in paths:
        if not path.exists():
            raise Wrong(f'{path} is missing')
    return paths[0] if len(paths) == 1 else paths


# --- Folders ---------------------------------------------------------------------------------------------------------

_held = {}     # by path: the file that is locked, and how many parts of this process have it
_asked = threading.Lock()


@contextlib.contextmanager
def held(folder, what=None):
    """Locks a folder for this process, its threads together: another one waits until it is done there."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    path = folder.resolve() / 'lock'
    with _asked:
        if path not in _held:
            file = open(path, 'a')
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                print(f'  waits until another command is done with {what or folder}', file=sys.stderr, flush=True)
                fcntl.flock(file, fcntl.LOCK_EX)
            _held[path] = [file, 0]
        _held[path][1] += 1
    try:
        yield
    finally:
        with _asked:
            _held[path][1] -= 1
            if not _held[path][1]:
                _held.pop(path)[0].close()


def name_of(scene):
    """The name of a scene's own folder: its path from here, with + for /; without models/ and the ending. Of an unusual
    or long path, the name of the file with a checksum of the path."""
    path = os.path.relpath(scene)
    if pathlib.Path(scene).resolve().is_relative_to(ROOT / 'models'):
        path = os.path.relpath(pathlib.Path(scene).resolve(), ROOT / 'models')
    stem = os.path.splitext(path)[0]
    if re.fullmatch(r'[\w.+/-]{1,160}', stem, re.ASCII):
        return stem.replace('/', '+')
    return re.sub(r'[^\w.-]', '_', os.path.basename(stem), flags=re.ASCII)[:64] + f'-{zlib.crc32(path.encode())}'


def outputs(command, scene, options=None):
    """The folder of what a command writes about a scene: --out, or build/COMMAND/NAME. It is made."""
    folder = pathlib.Path(getattr(options, 'out', None) or pathlib.Path('build', command, name_of(scene)))
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def for_make(path):
    """A path as make can read it from the root: relative, if it is there; through a link, if it has characters that
    make would take for something else."""
    path = pathlib.Path(path).absolute()
    text = os.path.relpath(path, ROOT) if path.is_relative_to(ROOT) else str(path)
    if re.fullmatch(r'[\w.+/@-]+', text, re.ASCII):
        return text
    link = pathlib.Path(tempfile.gettempdir(), f'isochron-{os.getuid()}', f'{zlib.crc32(str(path).encode())}')
    link.parent.mkdir(exist_ok=True)
    if not (link.is_symlink() and os.readlink(link) == str(path)):
        link.unlink(missing_ok=True)
        link.symlink_to(path)
    return str(link)


def write(path, text):
    """Writes a file, which gets its name when it is whole, and its folder."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_name(f'{path.name}.{os.getpid()}')
    unfinished.write_text(text)
    unfinished.replace(path)


def replace_changed(new, folder):
    """Moves the files of a folder into another, but for those that it has already with the same bytes."""
    for source in sorted(new.rglob('*')):
        place = folder / source.relative_to(new)
        if source.is_dir():
            place.mkdir(exist_ok=True)
        elif not (place.exists() and place.read_bytes() == source.read_bytes()):
            source.replace(place)


# --- Values of options -----------------------------------------------------------------------------------------------

WITHOUT_END = 2 ** 63 - 1      # ns: 292 years
# A number, and its unit.
TIME = re.compile(r'((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?) *(s|ms|us|ns|)', re.ASCII)
UNITS = {'': 10 ** 9, 's': 10 ** 9, 'ms': 10 ** 6, 'us': 10 ** 3, 'ns': 1}


def nanoseconds(text, what='a time', example='10 or 0.5', least=1, most=10 ** 18):
    """The nanoseconds of a time such as 1ms, 500 us or 0.5; a number alone is seconds."""
    found = TIME.fullmatch(str(text).strip())
    whole = decimal.Decimal(found[1]) * UNITS[found[2]] if found else decimal.Decimal('0.1')
    if whole != int(whole) or not least <= whole <= most:
        raise Wrong(f'{text} is no {what.removeprefix("a ")}; it could be {example}')
    return int(whole)


def methods():
    """The names of all methods. The step of the last, adams, varies; that of the others is fixed."""
    return re.findall(r'"core/methods/(\w+)\.h"', (ROOT / 'core/methods/all.h').read_text())


def check(words):
    """What is no choice for this plant or this target; isoc knows the others."""
    target = words.get('target') or 'host'
    if words.get('script') and target not in ('host', 'rp2040'):
        raise Wrong(f'--script has no effect on {target}, which has ticks of its own; it is for --target host, or rp2040')
    if words.get('mode') == 'free' and target == 'host':
        raise Wrong('--mode free needs time that is real; --target host has none, the others have')
    for word in ('checked', 'compensated'):
        if words.get(word) and not str(words['scene']).endswith('.c'):
            raise Wrong(f'--{word} is of a plant in C; a scene says it itself: {word} yes')


def plant_flags(words):
    """The choices of a plant in C, as flags of its compiler."""
    flags = []
    for word in ('set', 'without', 'inputs'):
        if words.get(word):
            raise Wrong(f'--{word} has no effect on a plant in C, which has no scene')
    if words.get('method') and words['method'] not in methods():
        near = difflib.get_close_matches(words['method'], methods(), 1)
        raise Wrong(f'--method {words["method"]} is unknown' + (f' (did you mean {near[0]}?)' if near else '') +
                    f'; it can be one of: {" ".join(methods())}')
    if words.get('tolerance') and words.get('method') != 'adams':
        raise Wrong(f'--tolerance has no effect on --method {words.get("method") or "rk4"}; it is of adams')
    if words.get('method'):
        flags += [f'-DISO_METHOD=ISO_{words["method"].upper()}', f'-DISO_METHOD_NAME={words["method"]}']
    if words.get('step'):
        step = nanoseconds(words['step'], 'step', '1ms, 500us or 0.001, from 1us to 1s in whole nanoseconds', 1000, 10 ** 9)
        flags.append(f'-DISO_STEP={step / 1e9!r}')
    if words.get('tolerance'):
        flags.append(f'-DISO_TOLERANCE={float(words["tolerance"]):.16e}')
    return flags + [flag for word, flag in (('checked', '-DISO_CHECK'), ('compensated', '-DISO_COMPENSATE'))
                    if words.get(word) in ('yes', True)]


def isoc_options(options=None, **more):
    """The options of isoc for the choices of a command: --method, --step ... --real."""
    words = {**vars(options or object_of()), **more}
    return [word for name in ISOC_OPTIONS if words.get(name) for word in (f'--{name}', str(words[name]))] + [
        '--real', words.get('real') or 'float']


def object_of(**words):
    """Options, as argparse has them."""
    import argparse
    return argparse.Namespace(**words)


# --- Ports -----------------------------------------------------------------------------------------------------------

def targets():
    """The names of all targets: the folders of port/ with a port.mk."""
    return sorted(path.parent.name for path in ROOT.glob('port/*/port.mk'))


class Port:
    """What a port.mk says for a number type, by the names that it has there without PORT_, in lower case: cc, flags,
    clock, nm, size ... `compile` and `link` are the beginnings of commands, `libraries` ends a link. `sources` and
    `objects` are those of the kind of program. Paths are from ROOT."""

    def __init__(self, text):
        self.facts = dict(line.split('=', 1) for line in text.splitlines() if '=' in line)

    def __getattr__(self, name):
        return self.facts.get(f'PORT_{name.upper()}', '')

    @property
    def compile(self):
        return shlex.split(self.facts['COMPILE'])

    @property
    def link(self):
        return shlex.split(self.facts['LINK'])

    @property
    def objdump(self):
        return self.size.replace('size', 'objdump')

    def need_compiler(self):
        need(self.tools.split(), self.install)

    def need_runner(self):
        need(self.exec_tools.split(), self.install)


@functools.cache
def port(target='host', real='float', kind='run', nanoseconds='"$$NANOSECONDS"', **variables):
    """The port of a target. PORT_EXEC and PORT_TRACE are texts for a shell that has $PROGRAM and $NANOSECONDS in its
    environment, and in $FROM the root of the project, with a /. `variables` are of make: BOARD, MODE, XCP, SCRIPT, KIND ..."""
    if target not in targets():
        near = difflib.get_close_matches(target, targets(), 1)
        raise Wrong(f'--target {target} is unknown' + (f' (did you mean {near[0]}?)' if near else '') +
                    f'; it can be one of: {" ".join(targets())}')
    if real not in ('float', 'double'):
        raise Wrong(f'--real {real} is unknown; it can be float or double')
    found = Port(make('print', 'tools/build/program.mk', TARGET=target, REAL=real, KIND=kind, PROGRAM='"$$PROGRAM"',
                      NANOSECONDS=nanoseconds, FROM='"$$FROM"', BUILD=for_make('build'), **variables))
    if real not in (found.reals or 'float double').split():
        raise Wrong(f'--real {real} is refused on {target}: its compiler has no double of 64 bits; take --real float there')
    return found


# --- Programs of this machine ---------------------------------------------------------------------------------------

def host_compiler():
    """The compiler of this machine, with the flags of all that is compiled."""
    facts, given = port().facts, os.environ.get('CFLAGS', '')
    return [*shlex.split(facts['CC']), *shlex.split(facts['WARNINGS']), '-O2', *shlex.split(facts['NUMERICS']),
            *(['-Wno-error'] if given else []), *shlex.split(given)]


def host_program(program, sources, flags=(), libraries=('-lm',), **how):
    """Compiles a program of this machine; -iquote FOLDER and the like are flags."""
    call([*host_compiler(), '-D_POSIX_C_SOURCE=200809L', f'-I{ROOT}', *flags, *sources, '-o', program, *libraries], **how)
    return program


def counted(function, command, environment=None):
    """The instructions that callgrind counts in the calls of a function, in a run of this command; and what that
    prints."""
    need(['valgrind'], 'apt-get install valgrind')
    words = ['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', f'--toggle-collect={function}']
    with progress(f'counts {function} of {command[0]}'):
        done = subprocess.run([*words, *map(str, command)], env=environment, capture_output=True, text=True, errors='replace')
    numbers = [int(line.split()[-1]) for line in done.stderr.splitlines() if 'Collected :' in line]
    if not numbers or not numbers[-1]:
        raise Wrong(f'callgrind has no count of {function} in {command[0]}')
    return numbers[-1], done.stdout


# --- Plants ----------------------------------------------------------------------------------------------------------

class Run:
    """A run: what it printed, as `text`, and as `summary`, a value for each word; its trace.csv and its status."""

    def __init__(self, folder, text, status=0):
        self.folder, self.text, self.status = folder, text, status
        self.trace = folder / 'trace.csv'
        self.summary = summary_of(text)


def summary_of(text):
    """A value for the first word of each line."""
    return dict(line.split(' ', 1) for line in text.splitlines() if ' ' in line)


class Plant:
    """The program of a plant, in its folder. `facts` is what isoc printed of the scene, by its words."""

    def __init__(self, scene, words, folder, kind):
        self.scene, self.words, self.folder, self.kind = scene, words, folder, kind
        self.target, self.real = words.get('target') or 'host', words.get('real') or 'float'
        self.is_in_c = pathlib.Path(scene).suffix == '.c'
        self.sources = folder if kind in ('run', 'none') else folder / kind
        self.facts, self.said = {}, ''
        self.port = port(self.target, self.real, kind, **self.of_port())

    @property
    def program(self):
        """The path of the program, or of the library of this kind."""
        return self.sources / ('plant.so' if self.kind == 'python' else f'program{self.port.suffix}')

    def of_port(self):
        given = {name.upper(): str(self.words[name]) for name in ('board', 'mode', 'xcp', 'run_ns') if self.words.get(name)}
        if 'BOARD' in given and self.words.get('seconds'):      # on silicon the program has no command line
            given.setdefault('RUN_NS', str(nanoseconds(self.words['seconds'], 'time to run')))
        return {**given, **(self.words.get('variables') or {})}

    def write(self, more=(), files=None, quiet=False):
        """Has isoc write the plant; `more` are further options of isoc, `files` further files. Only what is other changes."""
        if not os.path.exists(self.scene):
            raise Wrong(f'there is no scene {self.scene}')
        self.sources.mkdir(parents=True, exist_ok=True)
        if self.is_in_c:
            text = f'#include "{pathlib.Path(self.scene).resolve()}"\n'
            source = self.sources / 'plant.c'
            if not (source.exists() and source.read_text() == text):
                source.write_text(text)
            return self
        with tempfile.TemporaryDirectory(dir=self.sources, prefix='.isoc') as new:
            self.said = call([tools('isoc'), self.scene, '-o', new, *isoc_options(**self.words), *more],
                             **({'stderr': subprocess.PIPE} if quiet else {}))
            for name, text in (files or {}).items():
                pathlib.Path(new, name).write_text(text)
            replace_changed(pathlib.Path(new), self.sources)
        self.facts = summary_of(self.said)
        (self.sources / 'plant.txt').write_text(self.said)
        return self

    def make(self, **variables):
        """Makes the program, if something of it has changed."""
        self.port.need_compiler()
        flags = [*(plant_flags(self.words) if self.is_in_c else []), self.words.get('flags') or '']
        with held('build/obj', 'the objects of build/obj'), progress(f'compiles {self.scene} for {self.target}'):
            make('program', 'tools/build/program.mk', BUILD=for_make('build'), OUT=for_make(self.sources), KIND=self.kind,
                 TARGET=self.target, REAL=self.real, PLANT_FLAGS=' '.join(flags), **self.of_port(), **variables)
        return self

    def command(self, seconds=10, script=None, folder=None, clock=None, text=None, endless=False):
        """The command of a run of so many seconds: tools/trace around the program; and its environment."""
        self.port.need_runner()
        environment = {**os.environ, 'FROM': f'{ROOT}/', 'PROGRAM': str(self.program.absolute()), 'NANOSECONDS': str(WITHOUT_END if endless else nanoseconds(seconds, 'time to run'))}
        run = (text or self.port.exec) + (' "$SCRIPT"' if script else '')
        if script:
            environment['SCRIPT'] = os.path.abspath(script)
        return [tools('trace'), '-o', folder or self.folder, '--clock', clock or self.port.clock, '--',
                'sh', '-c', f'exec {run}'], environment

    def run(self, seconds=10, script=None, folder=None, quiet=True, check=True):
        """Runs the program for so many seconds (a number, or a text with a unit) and returns a `Run`. Its summary is
        printed unless `quiet`. With check=False a run that ends by itself is no error, but has a status."""
        folder = pathlib.Path(folder or self.folder)
        folder.mkdir(parents=True, exist_ok=True)
        command, environment = self.command(seconds, script, folder)
        with progress(f'runs {self.scene} on {self.target}') if quiet else contextlib.nullcontext():
            text, status = copied(command, environment, quiet)
        if status and check:
            raise Wrong('')
        (folder / 'summary.txt').write_text(text)
        return Run(folder, text, status)

    def ended(self, folder=None):
        """Says on the standard error what the end of a run tells: joints too fast for the step, a wrong energy."""
        if not self.is_in_c:
            last = (folder or self.folder) / 'last.txt'
            call([tools('isoc'), self.scene, '--ended', last, *isoc_options(**self.words)])


def copied(command, environment, quiet):
    """What a command prints, which is shown as it comes unless `quiet`; and its status."""
    lines = []
    process = subprocess.Popen([str(word) for word in command], env=environment, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, text=True)
    try:
        for line in process.stdout:
            lines.append(line)
            if not quiet:
                print(line, end='', flush=True)
        return ''.join(lines), process.wait()
    except BaseException:
        process.terminate()
        process.wait()
        raise


def plant(scene, kind='run', folder=None, isoc=(), files=None, quiet=False, **more):
    """The program of a scene, or of a plant in C, up to date. `scene` is a path or options that have one as `scene`;
    `more` go before the options: target, real, method, step, tolerance, set, without, inputs, checked, compensated,
    board, mode, xcp, run_ns, out, flags of the compiler, variables of make. `kind` is of tools/build/program.mk; `isoc`
    are further options of isoc, `files` texts that are compiled beside; `quiet` is of make. The folder is
    build/TARGET/REAL/NAME, or --out, or `folder`; it is locked until the process ends, or lets go."""
    options = scene if hasattr(scene, 'scene') else object_of(scene=scene)
    words = {**vars(options), **more}
    check(words)
    scene = str(words.pop('scene'))
    folder = pathlib.Path(folder or words.get('out') or
                          pathlib.Path('build', words.get('target') or 'host', words.get('real') or 'float', name_of(scene)))
    _locks.enter_context(held(folder))
    made = Plant(scene, words, folder, kind).write(isoc, files, quiet)
    return made if kind == 'none' else made.make(quiet=quiet)


_locks = contextlib.ExitStack()


def let_go():
    """Unlocks the folders of all plants: what this process has made there is done with."""
    _locks.close()
