"""The table of commands: from it come parsing, help, completion and the man page. A command is a row.

`run` names its function, lab.MODULE:FUNCTION, which has the options as an argparse.Namespace and returns nothing or an
exit status. `scene` is what it is about: SCENE, [SCENE] where it has a meaning without one, or other words.
"""
import dataclasses

PLANT = 'method step tolerance set without inputs'
IN_C = ' checked compensated'
WHERE = ' target board real seconds out'


@dataclasses.dataclass
class Command:
    name: str
    help: str
    options: str
    arguments: str = 'SCENE'
    run: str = ''
    defaults: dict = dataclasses.field(default_factory=dict)
    group: str = ''
    # Whether it is of scenes alone, with the reason; a plant in C is refused.
    scenes_alone: str = ''


MEASURES = 'Measure Isochron itself'
ON_M4F = {'target': 'cortex-m4f'}


def group(name, *commands):
    for command in commands:
        command.group = name
        command.run = command.run or f'lab.{command.name}:run'
    return commands


COMMANDS = [
    *group(
        'Run and look',
        Command('run', 'run a scene: write trace.csv, and print a summary',
                PLANT + IN_C + WHERE + ' script keep snapshot restore', defaults={'seconds': '10'}),
        Command('plot', 'run a scene and draw its outputs, the path of a point and a histogram with gnuplot',
                PLANT + IN_C + WHERE + ' script outputs', defaults={'seconds': '10'}),
        Command('show', 'run a scene and write show.html: a page with the mechanism in motion',
                PLANT + ' real seconds out against still film', defaults={'seconds': '10'},
                scenes_alone='of the bodies of a plant in C nothing is known'),
        Command('compare', 'draw two runs that --keep kept, one over the other, and print their differences', '',
                arguments='RUN RUN'),
        Command('new', 'write a first scene, NAME.scene', '', arguments='NAME', run='lab.first:run'),
        Command('targets', 'list where plants run', '', arguments='', run='lab.lists:targets'),
        Command('methods', 'list the methods, and what each costs', '', arguments='', run='lab.lists:methods'),
        Command('effects', 'list the effects that scenes have; of KIND: operands, units, equations, price', '',
                arguments='[KIND]', run='lab.lists:effects')),
    *group(
        'Choose a method, and see what it costs',
        Command('choose', 'advise the cheapest method, step and sub-steps for an --error on a --target',
                'step inputs recorded set without methods seconds error load write target core clock board',
                defaults={**ON_M4F, 'load': '50%', 'seconds': '10'}, scenes_alone='its choices are statements of a scene'),
        Command('report', 'measure the error of every method over its cost and its step: a page, in build/report/NAME',
                'methods step seconds recorded out', defaults={'seconds': '5'}),
        Command('bench', 'compare the methods at equal step and at equal error, as a table',
                'methods step seconds recorded out', defaults={'seconds': '5'}),
        Command('cost', 'print what each effect of a scene costs and changes; without one tables: --parts',
                'method step inputs set seconds target real parts methods', arguments='[SCENE]', defaults=ON_M4F,
                scenes_alone='a plant in C has no effects'),
        Command('cycles', 'count the cycles of the dearest tick on a board, by published timings; without a scene a table',
                'method step inputs set without target core clock board out', arguments='[SCENE]', defaults=ON_M4F,
                scenes_alone='a plant in C has no scene to count'),
        Command('ticks', 'count what a tick takes beside the step and the equations', PLANT + ' target real',
                defaults=ON_M4F, scenes_alone='the parts of a plant in C have no names'),
        Command('size', 'print the memory of the firmware and of its parts', PLANT + IN_C + ' target real out',
                defaults=ON_M4F),
        Command('stack', 'print the deepest stack of a step; fail if it has no bound', PLANT + IN_C + ' target real out')),
    *group(
        'Study a mechanism',
        Command('linear', 'the linear model: A, B, C, D, equilibria (--trim), modes in words, Bode plots',
                PLANT.replace(' inputs', '') + ' at trim bode out', scenes_alone='a plant in C has no linear model'),
        Command('sweep', 'make many runs, with the values of --set: a table of what --of says; goes on where it was ended',
                PLANT + ' seconds real of runs seed engine hosts lanes out',
                defaults={'seconds': '10', 'of': 'hash', 'engine': 'local'}, scenes_alone='a plant in C has no sweep'),
        Command('batch', 'measure how many steps in a second a core makes, of 8, 16 and 32 plants side by side',
                'method step inputs set without real', scenes_alone='a plant in C has no lanes'),
        Command('equations', 'write the equations for a reader, as text or LaTeX', PLANT + ' real format out',
                defaults={'format': 'text'}, scenes_alone='a plant in C is its own equations'),
        Command('drift', 'measure the drift of closed loops with every stabilisation', 'step seconds out',
                defaults={'seconds': '600'})),
    *group(
        'Connect a plant',
        Command('link', 'connect a scene with a --controller: trace.csv with inputs and outputs, and a summary',
                PLANT + WHERE + ' script keep xcp controller mode', defaults={'seconds': '10'},
                scenes_alone='a plant in C has no link'),
        Command('hil', 'the worked example: a cart with its pole on the board, balanced by another process',
                PLANT + ' target board real seconds keep controller mode', arguments='',
                defaults={**ON_M4F, 'seconds': '60'}),
        Command('a2l', 'build a plant with measurement and calibration over XCP, and write its A2L',
                PLANT + ' target board real out xcp', defaults={'xcp': 'open'}, scenes_alone='a plant in C has no link'),
        Command('monitor', 'a terminal of measurement and calibration: isochron monitor FILE.a2l tcp:127.0.0.1:5555', '',
                arguments='WORD ...'),
        Command('python', 'make a package of Python with the plant in it; with --lanes a library of many side by side',
                PLANT + ' real out lanes',
                scenes_alone='a plant in C is no package'),
        Command('fmu', 'write the scene as an FMU for co-simulation and model exchange', PLANT + ' real fmi exchange out',
                defaults={'fmi': '3'}, scenes_alone='of the quantities of a plant in C too little is known'),
        Command('import', 'turn a robot of URDF or MJCF into a scene: isochron import ROBOT.urdf -o ROBOT.scene', '',
                arguments='WORD ...', run='lab.robot:run'),
        Command('flash', 'write the program into a real board and start it there',
                PLANT + IN_C + ' target board real seconds out', defaults={'target': 'stm32f407'}),
        Command('conform', 'check a port: a line for each of its duties', 'target board real seconds', arguments='',
                defaults={'seconds': '0.02'})),
    *group(
        MEASURES,
        Command('determinism', 'compare hashes of models with methods on targets with those of the host',
                'models methods on ticks real', arguments='', defaults={'ticks': '100000'}),
        Command('chains', 'print a table of costs of chains of rods', 'lengths', arguments=''),
        Command('flags', 'measure a step with each optimisation of the compiler', 'target real models', arguments=''),
        Command('functions', 'print a table of the functions of core: domain, error, instructions', '', arguments=''),
        Command('digits', 'print a table of errors against reference solutions', '', arguments=''),
        Command('tables', 'write the generated tables again, in Markdown files', '', arguments='[FILE ...]'),
        Command('pictures', 'draw the pictures of models/README.md again', '', arguments='')),
]
BY_NAME = {command.name: command for command in COMMANDS}
GROUPS = list(dict.fromkeys(command.group for command in COMMANDS))
