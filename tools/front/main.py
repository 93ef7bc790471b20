"""isochron COMMAND [SCENE] [--option value]: finds the command, reads its options, and calls its function."""
import importlib
import os
import signal
import sys

from . import help, parse
from .commands import MEASURES
from lab.build import ROOT, Wrong


def main(words):
    """Returns the exit status. What is wrong is one line on the standard error."""
    os.environ['LC_ALL'] = 'C'       # numbers have a point in every program that is called
    try:
        return act(words)
    except Wrong as wrong:
        if str(wrong):
            print(f'isochron: {wrong}', file=sys.stderr)
        return 1
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except KeyboardInterrupt:
        return 128 + signal.SIGINT


def act(words):
    if not words or words[0] in ('-h', '--help'):
        print(help.overview())
        return 0
    if words[0] == 'help':
        print(help.command(parse.command_of(words[1])) if words[1:] else help.overview())
        return 0
    if words[0] in ('--completion', '--man'):
        print(help.completion() if words[0] == '--completion' else help.man())
        return 0
    command = parse.command_of(words[0])
    if not command.arguments.startswith('WORD') and words[1:2] and words[1] in ('-h', '--help'):
        print(help.command(command))
        return 0
    if command.group == MEASURES and not (ROOT / 'Makefile').exists():
        raise Wrong(f'{command.name} measures Isochron itself, and needs its sources: a checkout')
    options = parse.options_of(command, words[1:])
    module, function = command.run.split(':')
    return getattr(importlib.import_module(module), function)(options) or 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
