"""`isochron report`: the error of every method on one scene over its cost and its step, and more: a page, tables and
pictures in build/report/NAME/.
 report.html is the page (lab/page.py); report.txt and report.tsv are the tables; work_precision.svg and .png the
picture. Of a scene with inputs, which keep their values there, also in a loop, where they change at every tick:
loop.tsv, loop.svg and loop.png. """
import os
import re
import subprocess
import sys

from lab import build, draw, table, trace
from lab.methods import HEAD, Subject, any_step, as_text, errors, known_methods
from lab.page import page
from lab.picture import curves, run as pictures_of_run
from lab.picture.work_precision import work_precision
from lab.scene import edited, elsewhere, with_values

# The targets whose ticks are shown, by published timings.
TICK_TARGETS = 'cortex-m4f', 'cortex-m7'
# In float rounding would be taken for an error below the last one.
TOLERANCES = {'double': ('1e-3', '1e-5', '1e-7', '1e-9', '1e-11', '1e-13')}
TOLERANCES_OF_FLOAT = '1e-3', '1e-4', '1e-5', '1e-6', '1e-7', '1e-8'
# Of the page, unless the environment names others; each is a function below.
PARTS = 'cycles growth local_error account nearness tick regions effects motion'
DOUBLINGS = [2 ** i for i in range(6)]


def run(options):
    Report(options).make()


class Report:
    def __init__(self, options):
        build.need(['gnuplot', 'valgrind'], 'apt-get install gnuplot-nox valgrind')
        self.folder = build.outputs('report', options.scene, options)
        self.subject = Subject('report', self.folder, options)
        self.options, self.scene, self.name = options, self.subject.scene, self.subject.name
        self.pictures, self.known = {}, known_methods()
        self.has_no_loop = False

    def picture(self, name, picture):
        if picture:
            self.pictures[self.folder / name] = picture

    def table(self, name, head, rows):
        """Writes a table and returns its rows as texts."""
        rows = [[str(cell) for cell in row] for row in rows]
        table.write(self.folder / f'{name}.tsv', [head, *rows])
        return rows

    def make(self):
        subject, folder = self.subject, self.folder
        for old in 'loop cycles growth local_error account nearness singular tick regions effects'.split():
            for ending in '.tsv', '.svg', '.png':
                (folder / (old + ending)).unlink(missing_ok=True)
        # A program for the board, so that those that are made at once find the objects that they share.
        subject.instructions_m4f('float', 'rk4')
        jobs = [(kind, method) for kind in ('float', 'compensated', 'double') for method in subject.methods]
        measured = [line for lines in subject.each(self.points, jobs).values() for line in lines]
        reference = subject.reference(sorted({line[4][1] for line in measured}))
        self.rows = self.table('report', HEAD, errors(reference, measured))
        self.resting = subject.resting or 'Inputs keep their values at the start.'
        text = [f'{self.name} after {subject.time} s: error of the state, 2-norm over all states in SI units (m, rad, '
                's)',
                f'{self.resting} The time of a float is the sum of its steps as float has them.',
                *(f'Reference after {time} s: rk4 and abm4_pecece in double with compensated sums; they differ by '
                  f'{apart}'
                  for time, (apart, _) in reference.items()), '', *as_text(self.rows)]
        self.picture('work_precision', work_precision(self.name, subject.time, self.rows, self.known))
        if subject.inputs:
            text += self.loop()
        text = '\n'.join(text) + '\n'
        build.write(folder / 'report.txt', text)
        self.parts()
        drawn = draw.draw(self.pictures)
        print('report: the page', file=sys.stderr)
        build.write(folder / 'report.html', page(folder, self.name, self.resting, self.has_no_loop))
        print(text)
        for name in 'report.html', 'report.txt', 'report.tsv', 'loop.tsv':
            if (folder / name).exists():
                print(folder / name)
        for path in drawn:
            if path.stem in ('loop', 'work_precision'):
                print(path)

    def points(self, kind, method):
        """What the method reaches with six steps, each half of the one before, or adams with six tolerances."""
        subject = self.subject
        subject.drive(kind, method)
        if method == 'adams':
            words = tolerances = TOLERANCES.get(kind, TOLERANCES_OF_FLOAT)
            costs = [subject.instructions(kind, method, tolerance) for tolerance in tolerances]
        else:
            words, tolerances = [subject.coarsest * n for n in DOUBLINGS], '-' * len(DOUBLINGS)
            costs = [subject.instructions(kind, method)] * len(DOUBLINGS)
        lines = subject.run(kind, method, subject.time, *words)
        return [(kind, method, cost, tolerance, line) for cost, tolerance, line in zip(costs, tolerances, lines)]

    # --- In a loop ---

    def loop(self):
        """The lines of its text. Where the methods do not agree on the motion in the loop, the report has none."""
        subject = self.subject
        restarted, smooth = subject.loop_references()
        if subject.unlike:
            self.has_no_loop = True
            return ['In a loop: ' + subject.unlike]
        jobs = [(kind, method) for kind in ('held', *(['smooth'] if smooth else [])) for method in subject.fixed]
        measured = subject.each(self.points_in_loop, jobs)
        rows = self.table('loop', HEAD, (row for kind, reference in (('smooth', smooth), ('held', restarted))
                                         for row in errors(
            reference, [line for job, lines in measured.items() if job[0] == kind for line in lines])))
        self.picture('loop', work_precision(f'{self.name} in a loop', subject.time, rows, self.known))
        return ['', 'In a loop: inputs change at every tick (tools/measure/signals.h, or recorded). Held inputs '
                    'against the staircase with ticks\n'
                    f'of {subject.step_text} s, smooth ones, sampled at every step, against the continuous '
                    'signal', '', *as_text(rows)]

    def points_in_loop(self, kind, method):
        """Six steps; the longest with held inputs is the tick, with smooth ones four times that."""
        subject = self.subject
        of, first = ('double', 4 * subject.coarsest) if kind == 'held' else ('smooth', subject.coarsest)
        cost = subject.instructions_host(of, method)
        lines = subject.run(of, method, kind, subject.time, *(first * n for n in DOUBLINGS))
        return [(kind, method, cost, '-', line) for line in lines]

    # --- The parts of the page besides the tables of methods; one that a scene cannot have is left out ---

    def parts(self):
        self.own_method, self.is_closed = 'rk4', False
        parts = ['growth']
        if self.subject.is_scene:
            parts = os.environ.get('REPORT_PARTS', PARTS).split()
            for line in build.call([build.tools('isoc'), self.scene, '--shape']).splitlines():
                word, _, value = line.partition('\t' if '\t' in line else ' ')
                if word == 'method':
                    self.own_method = value.split()[0] if value.split()[0] != 'adams' else None
                self.is_closed |= word == 'closure'
        for part in parts:
            print(f'report: the page: {part}', file=sys.stderr)
            getattr(self, part)()

    def isochron(self, command, *words):
        """Another command about the scene with its own method; whether it succeeds."""
        step = ['--step', self.options.step] if self.options.step else []
        with open(self.folder / f'{command}.txt', 'w') as said:
            return not subprocess.run([sys.executable, build.ROOT / 'tools/isochron', command, self.scene, *step,
                                       *words],
                                      stdin=subprocess.DEVNULL, stdout=said, stderr=said).returncode

    def growth(self):
        """The error of the scene's method at its step after parts of the time."""
        subject, method = self.subject, self.own_method
        if not method:
            return
        counts = [4 * subject.coarsest // part for part in (32, 16, 8, 4, 2, 1)]
        words = [word for count in counts if count for word in (count, f'{count * subject.step:.17g}')]
        grown = [(kind, method, '0', '-', line) for kind in ('float', 'compensated', 'double')
                 for line in subject.run(kind, method, 'pairs', *words)]
        reference = subject.reference(sorted({line[4][1] for line in grown}))
        rows = self.table('growth', ('kind', 'method', 'step_s', 'time_s', 'error'), (
            (row[0], row[1], row[2], f'{float(row[2]) * int(row[3]):.9g}', row[4]) for row in errors(reference, grown)))
        self.picture('growth', curves.growth(self.name, rows))

    def local_error(self):
        """The estimate of the error of a step by the scene's method, in double, and the error. With substeps the
        estimate is that of one of them: such a scene has none."""
        subject, method = self.subject, self.own_method
        if not method or re.search('^ *substeps ', self.scene.read_text(), re.M):
            return
        source = subject.source('checked')
        source.parent.mkdir(exist_ok=True)
        source.write_text(edited(with_values(elsewhere(self.scene), subject.own), {'checked': 'yes'}))
        program = subject.program('checked', method, f'checked-{method}', any_step(method), is_told=False)
        told = program and subprocess.run([program, 'told', subject.time, str(4 * subject.coarsest)],
                                          env=subject.environment,
                                          stdout=subprocess.PIPE, text=True)
        if not told or told.returncode:
            return
        lines = subject.run('reference', 'rk4', 'true', subject.time, given=told.stdout)
        rows = self.table('local_error', ('time_s', 'told', 'error', 'ratio', 'step_s', 'method'), (
            (time, estimate, error, f'{float(estimate) / float(error):.3g}' if float(error) > 0 else '-',
             subject.step_text, method)
            for time, estimate, error in lines))
        self.picture('local_error', curves.local_error(self.name, rows))

    def account(self):
        """Of a run in float: energy, residual of its balance, and violation of closed loops."""
        outputs = ['energy', 'balance', *(['violation'] if self.is_closed else [])]
        folder = self.folder / 'account'
        folder.mkdir(exist_ok=True)
        source = folder / self.scene.name
        source.write_text(elsewhere(self.scene) + '\n'
                          + ''.join(f'output report_{name} = {name}\n' for name in outputs))
        try:
            run_of_it = build.plant(source, folder=folder, step=self.options.step).run(self.options.seconds)
        except build.Wrong:
            return
        its = trace.Run(folder)
        self.picture('account', pictures_of_run.trace(its, [f'report_{name}' for name in outputs]))
        self.table('account', ('quantity', 'unit', 'first', 'last', 'least', 'most'), (
            (name.removeprefix('report_'), its.units[c], its.texts[c][0], its.texts[c][-1], f'{its.least[c]:.9g}',
             f'{its.most[c]:.9g}')
            for c, name in enumerate(its.names) if name.startswith('report_')))
        self.ticks, self.near = run_of_it.summary['ticks'], run_of_it.summary.get('near_singular')

    def nearness(self):
        """Where closures are watched: the ticks of the account's run, and those near a singular position; and over the
        time the pivots in it, by tools/measure/nearness.c, and the largest violation in the same ticks."""
        folder = self.folder / 'account'
        if not (self.folder / 'account.tsv').exists() or 'iso_watch_pivots' not in (folder / 'plant.c').read_text():
            return
        near, _, first, _, _, closure = self.near.split() if self.near else ('0', '', '-', '', '', '-')
        self.table('nearness', ('ticks', 'near', 'first_s', 'closure'), [(self.ticks, near, first, closure)])
        program = folder / 'nearness'
        build.host_program(program, [folder / 'plant.c', *(build.ROOT / 'tools' / file for file in (
            'measure/nearness.c', 'file/file.c', 'trace/decimal.c'))], ['-include', 'tools/measure/pivots.h'])
        head, *rows = (line.split('\t') for line in build.call([program, self.ticks, '400']).splitlines())
        self.picture('singular', curves.singular(self.name, self.table('singular', head, rows)))

    def cycles(self):
        """In the columns of report.tsv: the errors in float over the cycles of steps without a restart on the
        Cortex-M4F, by published timings, the most of them. Of adams, whose steps vary, there are none."""
        jobs = [(kind, method) for kind in ('float', 'compensated') for method in self.subject.fixed]
        counted = self.subject.each(self.subject.cycles_m4f, jobs)
        rows = self.table('cycles', [name.replace('instructions', 'cycles') for name in HEAD], (
            ('cycles_' + row[0], *row[1:6], f'{counted[row[0], row[1]]:.12g}',
             f'{counted[row[0], row[1]] / float(row[2]):.6g}', row[8])
            for row in self.rows if counted.get((row[0], row[1]))))
        self.picture('cycles', work_precision(self.name, self.subject.time, rows, self.known))

    def tick(self):
        """The parts of the dearest tick on each target."""
        rows = []
        for target in os.environ.get('TICK_TARGETS', ' '.join(TICK_TARGETS)).split():
            folder = self.folder / f'cycles-{target}'
            if self.isochron('cycles', '--target', target, '--out', folder):
                rows += [[target, *row[1:]] for row in table.read(folder / 'cycles.tsv') if row[0] == 'part']
        if rows:
            self.table('tick', ('target', 'part', 'instructions', 'cycles_least', 'cycles_most', 'us'), rows)

    def effects(self):
        """What each effect costs and changes, of a scene that has effects."""
        if build.call([build.tools('isoc'), self.scene, '--effects']).strip():
            folder = self.folder / 'cost'
            if self.isochron('cost', '--seconds', '1', '--out', folder):
                for ending in 'tsv', 'svg':
                    (self.folder / f'effects.{ending}').write_bytes((folder / f'effects.{ending}').read_bytes())

    def regions(self):
        """The regions of stability of all methods (tools/measure/regions.c) and the step times the eigenvalues of the
        scene: at its start, piece 1, and at the end of the time, piece 2."""
        head, *rows = (line.split('\t') for line in build.tools('regions.tsv').read_text().splitlines())
        points = []
        for piece, at in enumerate(([], ['--at', f'{self.subject.time}s']), 1):
            folder = self.folder / 'linear'
            if self.isochron('linear', '--out', folder, *at):
                points += [['eigenvalue', *(f'{self.subject.step * float(part):.6g}' for part in row[:2]), piece]
                           for row in table.read(folder / 'modes.tsv')[1:]]
        if points:
            rows = self.table('regions', head, rows + points)
            self.picture('regions', curves.regions(self.name, self.own_method, rows))

    def motion(self):
        """The page of `isochron show`, in this page."""
        self.isochron('show', '--seconds', str(self.options.seconds), '--out', self.folder / 'motion')
