"""The options of all commands: each has one meaning, whichever command takes it."""
import dataclasses
import re

from lab.build import TIME


@dataclasses.dataclass
class Option:
    """`value` stands for the value in help; without it the option is a flag. `choices` are all values; `check` says
    whether a text is a value, and `example` what could be one."""
    value: str
    help: str
    choices: tuple = ()
    check: object = None
    example: str = ''


def one_of(*choices):
    return {'choices': choices}


def time(example):
    return {'check': lambda text: TIME.fullmatch(text.strip()), 'example': example}


def number(example, least=0):
    return {'check': lambda text: text.isascii() and text.isdigit() and int(text) >= least, 'example': example}


def name(text):
    return re.fullmatch(r'[\w.-]{1,255}', text, re.ASCII) and text not in ('.', '..')


def is_tolerance(text):
    return re.fullmatch(r'(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?', text, re.ASCII) and 1e-30 < float(text) < 1e30


OPTIONS = {
    # What the plant is.
    'method': Option('NAME', 'the method, instead of that of the scene; `isochron methods` lists them'),
    'step': Option('TIME', 'the step, instead of that of the scene', **time('1ms')),
    'tolerance': Option('T', 'largest local error of adams in a state x: T (1 + |x|)', check=is_tolerance, example='1e-9'),
    'set': Option("'NAME = VALUE; ...'", 'values of constants and tunables, instead of those of the scene'),
    'without': Option("'EFFECT; ...'", 'effects of the scene that are left out'),
    'inputs': Option('READING', 'the reading of all inputs, instead of that of the scene', **one_of('held', 'smooth')),
    'checked': Option('', 'checks the local error of each step, of a plant in C; a scene has a statement for it'),
    'compensated': Option('', 'compensated sums, of a plant in C; a scene has a statement for them'),
    # Where and how long it runs.
    'target': Option('TARGET', 'where it runs: this machine in virtual or in real time, or a board; `isochron targets`'),
    'real': Option('TYPE', 'the type of the numbers', **one_of('float', 'double')),
    'seconds': Option('TIME', 'simulated time; of link 0 is without an end', **time('10')),
    'board': Option('BOARD', 'the serial line of a real board, to run there; of cycles and choose the board, as stm32f405'),
    'script': Option('FILE', 'late, lost and slow ticks, on the host, and what stands at pins, there and on rp2040 (port/host/script.h)'),
    'out': Option('FOLDER', 'where what belongs to this scene is made, instead of build/TARGET/TYPE/NAME'),
    'keep': Option('NAME', 'keeps the run as build/runs/NAME', check=name, example='before'),
    'write': Option('', 'writes the choice into the scene'),
    'snapshot': Option('TICK', 'takes a snapshot of this tick: snapshot.bin beside the trace', **number('12345')),
    'restore': Option('FILE', 'goes on from a snapshot, of any target; --seconds is of the whole run'),
    # What is shown.
    'outputs': Option('NAME,...', 'what to draw over time, instead of all'),
    'against': Option("'CHOICE | ...'", 'further runs beside the first: what is other in each, or the name of a kept run'),
    'still': Option('TIME', 'a picture of this time, show.svg, instead of the page', **time('1.5')),
    'film': Option('', 'a picture that moves, show.svg, instead of the page'),
    # With a controller.
    'controller': Option('COMMAND', 'a command; it connects where ISOCHRON_LINK says'),
    'mode': Option('MODE', 'whether the plant waits for the controller', **one_of('lockstep', 'free')),
    'xcp': Option('open|LOCK', 'who may write and measure over XCP: all, or who has the key of an iso_xcp_lock'),
    # Costs.
    'core': Option('TABLE', 'another table of timings of the target, as cortex-m0-small'),
    'clock': Option('FREQUENCY', 'the clock of the board, as 168MHz'),
    'error': Option("'1 mm of tip; ...'", 'how far outputs may be from the exact motion'),
    'load': Option('PERCENT', 'what a tick may take of the chip'),
    'recorded': Option('FILE', 'inputs of a controller, a line for each tick'),
    'methods': Option("'NAME ...'", 'the methods that are compared, instead of all'),
    'parts': Option("'PART ...'", 'the tables: models methods restarts effects library'),
    'models': Option("'SCENE ...'", 'the scenes that are measured, instead of those of models/'),
    'lengths': Option("'N ...'", 'the numbers of joints'),
    # Linear models, sweeps, exports.
    'at': Option('TIME', 'about the state that the run has then, instead of the start', **time('2s')),
    'trim': Option("'NAME = VALUE; free INPUT'", 'about the equilibrium with these values, or `rest`, the nearest'),
    'bode': Option("'INPUT to OUTPUT'", 'draws the frequency response, and measures it on the plant'),
    'of': Option("'max OUTPUT; hash'", 'what the table shows of each run'),
    'runs': Option('N', 'how many random values', **number('1000', 1)),
    'seed': Option('N', 'which random values', **number('1')),
    'engine': Option('ENGINE', 'where the runs are made: here, by GNU parallel over ssh, or by Slurm',
                     **one_of('local', 'parallel', 'slurm')),
    'hosts': Option("'a 4/b'", 'the machines of --engine parallel, with their numbers of jobs'),
    'lanes': Option('N', 'so many runs side by side in a process', **one_of('1', '2', '4', '8', '16', '32')),
    'fmi': Option('VERSION', 'the version of the standard, 3.0 or 2.0', **one_of('3', '2')),
    'exchange': Option('', 'not without model exchange'),
    'format': Option('FORMAT', 'as text, or as LaTeX', **one_of('text', 'latex')),
    'on': Option("'TARGET ...'", 'the targets; clang is the host by clang'),
    'ticks': Option('N', 'how many ticks of each', **number('100000', 1)),
}
