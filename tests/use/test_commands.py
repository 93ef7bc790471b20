"""What the front door says of words that are wrong, as a table; its help, completion and man page; and that the table of
commands is whole."""
# Depends on: *.md core port models tools Makefile
import importlib
import re
import subprocess

import pytest

from harness.project import ROOT

SCENE, IN_C = ROOT / 'models/pendulum.scene', ROOT / 'models/oscillator.c'

# Words, and what is said of them: one line, status 1, and nothing is made. `S` is a scene, `C` a plant in C.
WRONG = [
    ('runn S', 'there is no command runn (did you mean run?)'),
    ('tea', 'there is no command tea; `isochron --help` lists them'),
    ('run', 'run needs SCENE'),
    ('run S S', 'one word too many'),
    ('run models/absent.scene', 'there is no scene models/absent.scene'),
    ('run S --metod rk4', '--metod is no option (did you mean --method?)'),
    ('run S --weather fair', '--weather is no option; `isochron help run` lists those of run'),
    ('run S --method', '--method'),
    ('run S --method rk5', "no method is called 'rk5' (did you mean 'rk4'?)"),
    ('run C --method rk5', '--method rk5 is unknown (did you mean rk4?)'),
    ('run S --target abacus', '--target abacus is unknown; it can be one of: aarch64'),
    ('run S --target cortex-m4', 'did you mean cortex-m4f'),
    ('run S --real decimal', '--real decimal is unknown; it can be float or double'),
    ('run S --target atmega1284p --real double', '--real double is refused on atmega1284p: its compiler has no double'),
    ('run S --inputs some', '--inputs some is unknown; it can be held or smooth'),
    ('run C --inputs held', '--inputs has no effect on a plant in C'),
    ('run C --set mass=1', '--set has no effect on a plant in C'),
    ('run C --without rub', '--without has no effect on a plant in C'),
    ('run S --tolerance 0', '--tolerance 0 is no T; it could be 1e-9'),
    ('run S --tolerance fine', '--tolerance fine is no T; it could be 1e-9'),
    ('run S --tolerance 1e-6', '--tolerance is for adams; it has no effect on rk4'),
    ('run C --tolerance 1e-6', '--tolerance has no effect on --method rk4; it is of adams'),
    ('run S --checked', '--checked is of a plant in C; a scene says it itself: checked yes'),
    ('run S --compensated', '--compensated is of a plant in C; a scene says it itself: compensated yes'),
    ('run S --target cortex-m4f --script x', '--script has no effect on cortex-m4f, which has ticks of its own'),
    *((f'run S --seconds {text}', f'--seconds {text} is no TIME; it could be 10') for text in ('-1', '0x10', 'inf', 'nan', '1h')),
    *((f'run S --seconds {text}', f'{text} is no time to run') for text in ('0', '0.0', '1e-10', '1e300')),
    *((f'run C --step {text}', f'{text} is no step; it could be 1ms') for text in ('0', '0.1us', '2s', '1.5ns')),
    ('run S --step fast', '--step fast is no TIME; it could be 1ms'),
    ('run S --keep ../a', '--keep ../a is no NAME; it could be before'),
    ('run S --keep ..', '--keep .. is no NAME'),
    ('run S --snapshot 1e3', '--snapshot 1e3 is no TICK; it could be 12345'),
    ('run S --restore absent', '--restore absent is no snapshot; isochron run --snapshot TICK writes one'),
    ('run C --snapshot 1', 'a plant in C has no snapshots'),
    ('size S --seconds 3', '--seconds has no effect on size; it has one on: run plot'),
    ('report S --method heun', '--method has no effect on report; it has one on: run'),
    ('size S --snapshot 3', '--snapshot has no effect on size; it has one on: run'),
    ("chains --lengths x", "--lengths 'x' are no numbers of joints; it could be '8 16'"),
    ('flags --models absent.scene', '--models: there is no scene absent.scene'),
    ('ticks S --target host', 'ticks is of the cortex-m4f in float'),
    ('compare a', 'compare needs RUN RUN'),
    ('compare a absent', 'there is no run a'),
    ('link S --mode slow', '--mode slow is unknown; it can be lockstep or free'),
    ('link S --mode free', '--mode free needs time that is real; --target host has none'),
    ('link S --target atmega1284p', 'link needs channels (port/channel.h), and --target atmega1284p has none'),
    ('link S --target rv32imac --xcp open', 'has one channel, that of a controller, and none for measurement and calibration'),
    ('a2l S --target rv32imac', 'has one channel, that of a controller, and none for measurement and calibration'),
    ('link C', 'link is for scenes: a plant in C has no link'),
    ('show C', 'show is for scenes: of the bodies of a plant in C nothing is known'),
    ('python C', 'python is for scenes'), ('fmu C', 'fmu is for scenes'), ('linear C', 'linear is for scenes'),
    ('sweep C', 'sweep is for scenes'), ('batch C', 'batch is for scenes'), ('equations C', 'equations is for scenes'),
    ('choose C', 'choose is for scenes'), ('ticks C', 'ticks is for scenes'), ('cost C', 'cost is for scenes'),
    ('cycles C', 'cycles is for scenes'),
    ('fmu S --fmi 4', '--fmi 4 is unknown; it can be 3 or 2'),
    ('show S --still x', '--still x is no TIME; it could be 1.5'),
    ('linear S --at x', '--at x is no TIME; it could be 2s'),
    ('sweep S --runs 0', '--runs 0 is no N; it could be 1000'),
    ('sweep S --engine fast', '--engine fast is unknown; it can be local, parallel or slurm'),
    ('equations S --format pdf', '--format pdf is unknown; it can be text or latex'),
    ('flash S --target host', '--target host is no real board; these are: rp2040 stm32f407 stm32f446'),
    ('effects frictio', 'there is no effect frictio (did you mean friction?)'),
    ('new models', 'models.scene is there already'),
]


def commands():
    return importlib.import_module('front.commands')


@pytest.mark.parametrize('words, text', WRONG, ids=[words for words, _ in WRONG])
def test_told(isochron, laboratory, words, text):
    (laboratory / 'models.scene').write_text('')
    before = {path for path in laboratory.rglob('trace.csv')}
    said = isochron(*[{'S': SCENE, 'C': IN_C}.get(word, word) for word in words.split()])
    assert said.status == 1 and text in said.errors and 'Traceback' not in said.errors
    assert said.printed == '' and before == {path for path in laboratory.rglob('trace.csv')}


def test_every_option_has_an_effect_somewhere_and_every_command_its_function():
    table, options = commands(), importlib.import_module('front.options').OPTIONS
    used = {name for command in table.COMMANDS for name in command.options.split()}
    assert used == set(options)
    for command in table.COMMANDS:
        module, function = command.run.split(':')
        assert callable(getattr(importlib.import_module(module), function)), command.name
        assert set(command.defaults) <= set(command.options.split()), command.name


def test_help_lists_every_command_that_a_text_names(isochron):
    told = isochron('--help').printed
    texts = [path.read_text() for path in ROOT.rglob('*.md') if 'build' not in path.relative_to(ROOT).parts]
    named = {name for text in texts for name in re.findall(r'`isochron ([a-z0-9]+)', text)} - {'help'}
    assert len(named) > 20 and all(re.search(rf'^  {name} ', told, re.M) for name in named)
    assert not re.search(r'^  tea ', told, re.M)


def test_help_of_a_command_has_its_options(isochron):
    for command in commands().COMMANDS:
        told = isochron('help', command.name)
        assert told.status == 0 and re.findall(r'^  (--\w+)', told.printed, re.M) == [f'--{name}' for name in command.options.split()]


def test_completion_and_man_page(isochron):
    script = isochron('--completion').printed
    asked = "COMP_WORDS=(isochron run --me); COMP_CWORD=2; _isochron; echo ${COMPREPLY[*]}"
    assert subprocess.run(['bash', '-c', f'{script}\n{asked}'], capture_output=True, text=True).stdout == '--method\n'
    page = isochron('--man').printed
    assert all(f'.B {command.name} ' in page for command in commands().COMMANDS)


def test_the_old_words_of_make_are_told_with_the_new_ones(laboratory):
    for words, text in (('plot', 'tools/isochron plot'), ('run METHOD=rk4', "tools/isochron run models/double_pendulum.scene --method 'rk4'"),
                        ('run SCENE=models/arm6.scene TARGET=cortex-m4f', "--target 'cortex-m4f'")):
        done = subprocess.run(['make', '-C', ROOT, *words.split()], capture_output=True, text=True)
        assert done.returncode and text in done.stderr


