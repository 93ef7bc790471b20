"""`isochron sweep`: many runs of a scene (tools/sweep/README.md). FOLDER/SUM/ has the plan, the plants, the program and
the parts; SUM is a checksum of all that the parts follow from, so that only those of this sweep are used again."""
import concurrent.futures
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time

from lab import build, table
from lab.build import ROOT, Wrong

# A step in so many lanes takes as long as two of one plant.
LANES, RUNS_THAT_PAY = 16, 4
ENGINES = {'parallel': ('parallel', 'parallel'), 'slurm': ('sbatch squeue sinfo', 'slurm-wlm')}


def refused(said):
    """The first error in what isoc said."""
    found = re.search(r'^[^ ]*: error: .*', said, re.M)
    return found[0] if found else ''


def isoc(*words):
    return subprocess.run([build.tools('isoc'), *words], capture_output=True, text=True)


def said(text):
    """Ends with what isoc said."""
    print(text.rstrip(), file=sys.stderr)
    raise Wrong('')


class Variation:
    """A plant of the sweep: what isoc makes of the scene with the options of its line."""

    def __init__(self, line, scene, folder, choices, with_lanes):
        self.number, *words = line.split('\t')
        self.folder, self.alone, self.start, self.first = folder / self.number, '', None, self
        self.folder.mkdir(parents=True)
        for lanes in (['--lanes'], []) if with_lanes else ([],):
            done = isoc(scene, '-o', self.folder, *choices, *lanes, *words)
            if done.returncode == 0:
                break
            if lanes:
                self.alone = refused(done.stderr)
        self.said, self.refused = done.stderr, refused(done.stderr) if done.returncode else ''
        if done.returncode and not self.refused:
            said(done.stderr)
        self.text = '' if self.refused else (self.folder / 'plant.c').read_text()

    def split(self):
        """The text without the numbers of the start; these are `start`."""
        found = re.search(r'^static const (?:real|iso_scalar) start\[.*?^};\n', self.text, re.M | re.S)
        self.start = ' '.join(line.rpartition(' = ')[2] for line in found[0].splitlines()[1:-1]) if found else None
        return self.text.replace(found[0], '') if found else self.text

    def source(self, real, has_lanes):
        """The plant as a part of the program: the names that plants have in common become its own."""
        kind = f'lanes_{real}' if has_lanes else real
        names = {f'iso_the_plant_{kind}': 'plant', f'iso_the_derivative_{kind}': 'own_derivative',
                 'plant_model': 'model', 'plant_derivative': 'derivative'}
        return ''.join(f'#define {name} sweep_{own}_{self.number}\n' for name, own in names.items()) + \
            f'#include "plants/{self.number}/plant.c"\n'

    def row(self):
        """Of the table sweep_plants."""
        if self.refused:
            text = re.sub(r'([\\"])', r'\\\1', self.refused).replace('\t', ' ')
            return f'    {{NULL, "{text}", NULL}},'
        start = 'NULL' if self.first is self else f'sweep_start_{self.number}'
        return f'    {{&sweep_plant_{self.first.number}, NULL, {start}}},'

    def declared(self):
        if self.refused:
            return ''
        if self.first is self:
            return f'extern const struct iso_plant sweep_plant_{self.number};\n'
        return f'static const iso_scalar sweep_start_{self.number}[] = {{{self.start}}};\n'


class Sweep:
    def __init__(self, options):
        self.options, self.folder = options, build.outputs('sweep', options.scene, options)
        self.made, self.real = self.folder / 'made', options.real or 'float'
        self.nanoseconds = build.nanoseconds(options.seconds)
        if options.hosts and options.engine != 'parallel':
            raise Wrong(f'--hosts has no effect on --engine {options.engine}; it is of --engine parallel')
        for tool in ENGINES.get(options.engine, ('', ''))[0].split():
            build.need([tool], f'apt-get install {ENGINES[options.engine][1]}')
        if options.engine == 'parallel' and 'GNU parallel' not in build.call(['parallel', '--version']):
            raise Wrong('--engine parallel is GNU parallel, which is missing. Install it with: '
                        'apt-get install parallel')

    # --- Plan and plants ----------------------------------------------------------------------------------------------

    def plan(self):
        """The plan in `made`, and its plants; nothing else is touched if something is wrong."""
        options = self.options
        shutil.rmtree(self.made, ignore_errors=True)
        choices = build.isoc_options(options, set=None)
        done = isoc(options.scene, '-o', self.made, *choices, '--sweep', options.set or '', '--of', options.of,
                    *(['--runs', options.runs] if options.runs else []),
                    *(['--seed', options.seed] if options.seed else []))
        if done.returncode:
            said(done.stderr)
        self.text = (self.made / 'plan').read_text()
        self.runs = int(re.search(r'^runs (\d+)', self.text, re.M)[1])
        for name in 'method', 'step':
            if getattr(options, name) and re.search(rf'^{name}\t.*\t{name}\t', self.text, re.M):
                raise Wrong(f'--{name} {getattr(options, name)}, and --set varies the {name}: leave out one of them')
        lines = (self.made / 'variations').read_text().splitlines()
        with build.progress(f'isoc makes {len(lines)} plants of {options.scene}'), \
                concurrent.futures.ThreadPoolExecutor(build.processors()) as pool:
            self.plants = list(pool.map(lambda line: Variation(line, options.scene, self.made / 'plants', choices,
                                                               options.lanes != '1'), lines))
        without = sum(bool(plant.refused) for plant in self.plants)
        if without == len(self.plants):
            said(self.plants[0].said)
        if self.plants[0].said:
            print(self.plants[0].said.rstrip(), file=sys.stderr)
        if without:
            print(f'  isoc refuses {without} of {len(self.plants)} plants; their runs fail', file=sys.stderr)

    def group(self):
        """Of plants that differ in their start alone the first is compiled, and the starts of the others are data."""
        firsts = {}
        for plant in self.plants if len(self.plants) > 1 else []:
            if not plant.refused:
                plant.first = firsts.setdefault(plant.split(), plant)
        self.compiled = [plant for plant in self.plants if plant.first is plant and not plant.refused]

    def lay(self):
        """`side` are the flags of the compiler for plants side by side; empty: one by one. Unless --lanes asks for a
        number, there are LANES where a plant has RUNS_THAT_PAY runs on average."""
        asked, self.side = self.options.lanes, ''
        alone = next((plant.alone for plant in self.plants if plant.alone and not plant.refused), '')
        if alone:
            print(f'  the runs are made one by one: {alone.partition("error: ")[2]}', file=sys.stderr)
        if alone or asked == '1' or not asked and self.runs < RUNS_THAT_PAY * len(self.compiled):
            return
        side = f'-march=native -Wno-psabi -DISO_LANES={asked or LANES}'
        compiler = build.port('host', self.real, 'sweep').compile
        if subprocess.run([*compiler, *side.split(), '-fsyntax-only', ROOT / 'core/numbers/self_check.c'], cwd=ROOT,
                          capture_output=True).returncode == 0:
            self.side = side
        elif asked:
            raise Wrong(f'{compiler[0]} has no vectors')

    def write_sources(self):
        sources = {f'plant_{plant.number}.c': plant.source(self.real, self.side) for plant in self.compiled}
        sources['steps.c'] = f'#include "tools/sweep/{"side" if self.side else "alone"}.c"\n'
        sources['plants.c'] = ('#include "tools/sweep/steps.h"\n\n'
                               f'const uint64_t sweep_duration_ns = UINT64_C({self.nanoseconds});\n'
                               + ''.join(plant.declared() for plant in self.plants)
                               + 'const sweep_plant sweep_plants[] = {\n'
                               + '\n'.join(plant.row() for plant in self.plants) + '\n};\n')
        for name, text in sources.items():
            (self.made / name).write_text(text)
        port = build.port('host', self.real, 'sweep')
        parts = [' '.join(port.compile + port.link), self.side, self.text, *sources.values(),
                 *(plant.text for plant in self.plants)]
        for pattern in 'core/*/*.[ch]', 'tools/sweep/*.[ch]', 'tools/trace/decimal.[ch]':
            parts += [path.read_text() for path in sorted(ROOT.glob(pattern))]
        return hashlib.sha256('\0'.join(parts).encode()).hexdigest()[:16]

    def prepare(self):
        """`at` is the folder of this plan, with its parts that exist; folders of other plans are removed."""
        self.plan()
        self.group()
        self.lay()
        self.at = self.folder / self.write_sources()
        for other in self.folder.iterdir():
            if other not in (self.made, self.at) and (other / 'plan').is_file():
                if (other / 'slurm_job').exists():
                    subprocess.run(['scancel', (other / 'slurm_job').read_text().strip()], stderr=subprocess.DEVNULL)
                shutil.rmtree(other)
        if (self.at / 'program').is_file():
            shutil.rmtree(self.made)
            return
        shutil.rmtree(self.at, ignore_errors=True)
        for pattern in 'sweep.tsv', 'columns.tsv', 'failures.txt', '*.svg', '*.png':
            for old in self.folder.glob(pattern):
                old.unlink()
        with build.held('build/obj', 'the objects of build/obj'), \
                build.progress(f'compiles {len(self.compiled)} plants'):
            build.make('program', 'tools/build/program.mk', BUILD=build.for_make('build'),
                       OUT=build.for_make(self.made), KIND='sweep', TARGET='host', REAL=self.real,
                       PLANT_FLAGS=self.side)
        (self.made / 'parts').mkdir()
        self.made.rename(self.at)

    # --- Runs ---------------------------------------------------------------------------------------------------------

    def program(self, *words, **how):
        return subprocess.run([self.at / 'program', self.at, *map(str, words)], **how)

    def absent(self):
        return self.program('absent', stdout=subprocess.PIPE, text=True).stdout.split()

    def make_parts(self):
        """Makes the parts that are absent; whether all are there."""
        if not self.absent():
            return True
        engine = {'local': lambda: self.program('make', build.processors()).returncode,
                  'parallel': self.by_parallel, 'slurm': self.by_slurm}[self.options.engine]
        return engine() == 0

    def watched(self, process):
        """Shows the progress until the process has ended, which may have to tidy up when all parts are there; when this
        command ends, so does the process."""
        watch = subprocess.Popen([self.at / 'program', self.at, 'watch', str(process.pid)])
        try:
            process.wait()
        finally:
            process.terminate()
            process.wait()
        return watch.wait()

    def by_parallel(self):
        """GNU parallel, on this machine, where a job makes several parts; or on --hosts over ssh, which get the program
        and the plan, and give back a part."""
        words = ['-n', '8']
        if self.options.hosts:
            words = ['--sshlogin', ','.join(self.options.hosts.split()), '--workdir', f'.isochron/sweep-{self.at.name}',
                     '--basefile', 'plan', '--basefile', 'program', '--return', 'parts/{}.tsv', '--cleanup',
                     '--retries', '3']
        job = shlex.quote('mkdir -p parts && ./program . part {}')
        command = f'./program . absent | exec parallel {shlex.join(words)} {job}'
        return self.watched(subprocess.Popen(['sh', '-c', command], cwd=self.at))

    def is_queued(self):
        """Whether Slurm has the job of before."""
        job = self.at / 'slurm_job'
        return job.is_file() and bool(subprocess.run(['squeue', '-h', '-j', job.read_text().strip()],
                                                     capture_output=True).stdout)

    def by_slurm(self):
        """An array of jobs, two shares for each processor; where one of before is still there, that."""
        at, job = self.at, self.at / 'slurm_job'
        if not self.is_queued():
            processors = sum(int(line.split('/')[3]) for line in build.call(['sinfo', '-h', '-o', '%C']).split())
            shares = min(max(2, min(2 * processors, 1000)), len(self.absent()))
            (at / 'log').mkdir(exist_ok=True)
            place = at.absolute()
            said = build.call(['sbatch', '--parsable', f'--job-name=sweep_{pathlib.Path(self.options.scene).stem}',
                               f'--array=0-{shares - 1}', f'--chdir={os.getcwd()}', f'--output={at}/log/%a.txt',
                               f'--wrap=exec {shlex.quote(f"{place}/program")} {shlex.quote(str(place))} share '
                               f'$SLURM_ARRAY_TASK_ID {shares}'])
            unfinished = at / 'slurm_job.new'
            unfinished.write_text(said)
            unfinished.rename(job)
        print(f'  Slurm job {job.read_text().strip()}, whose output is in {at}/log', file=sys.stderr)
        return self.watched(subprocess.Popen(
            ['sh', '-c', 'while squeue -h -j "$0" 2>/dev/null | grep -q .; do sleep 1; done', job.read_text().strip()]))

    # --- The table ----------------------------------------------------------------------------------------------------

    def again(self):
        """The beginning of the command that makes a run alone."""
        options = self.options
        words = ['isochron', 'run', options.scene, '--seconds', options.seconds]
        if self.real != 'float':
            words += ['--real', self.real]
        for name in 'method', 'step', 'tolerance', 'inputs', 'without':
            if getattr(options, name):
                words += [f'--{name}', getattr(options, name)]
        return shlex.join(map(str, words))

    def tables(self):
        return [path.read_bytes() if path.exists() else None
                for path in (self.folder / 'columns.tsv', self.folder / 'sweep.tsv')]

    def draw(self, before):
        """The table as a picture, where gnuplot is there, and it is not that of this table already."""
        pictures = [self.folder / f'sweep.{ending}' for ending in ('svg', 'png')]
        newest = max(path.stat().st_mtime for path in (ROOT / 'tools/lab').rglob('*.py'))
        if before != self.tables() or not all(path.exists() and path.stat().st_mtime > newest for path in pictures):
            for old in pictures:
                old.unlink(missing_ok=True)
            if not shutil.which('gnuplot'):
                print('no picture: gnuplot is missing. Install it with: apt-get install gnuplot-nox', file=sys.stderr)
                return
            from lab.draw import draw
            from lab.picture.sweep import sweep
            about = {name: (unit, sort) for name, unit, sort in table.read(self.folder / 'columns.tsv')[1:]}
            head, *rows = table.read(self.folder / 'sweep.tsv')
            is_random = re.search(r'uniform\(|normal\(', self.options.set) is not None
            pictures = draw({self.folder / 'sweep': sweep(pathlib.Path(self.options.scene).stem, is_random, about, head,
                                                          rows)})
        for path in pictures:
            print(f'picture {path}')


def run(options):
    if not options.set:
        raise Wrong("--set says what varies, such as --set 'mass = 0.1 .. 0.3 kg by 21'")
    sweep = Sweep(options)
    with build.held(sweep.folder):
        sweep.prepare()
        if not sweep.make_parts():
            return 1
        for left in sweep.at.glob('parts/*.tsv.*'):
            left.unlink()
        before = sweep.tables()
        if sweep.program('table', sweep.folder, sweep.again()).returncode:
            return 1
        sweep.draw(before)
    return 0
