"""The words of a command as an argparse.Namespace, and what is wrong with them."""
import argparse
import difflib
import os

from lab.build import Wrong

from .commands import BY_NAME, COMMANDS
from .options import OPTIONS


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Wrong(message)


def command_of(name):
    """The command of this name; an error names the nearest one."""
    if name not in BY_NAME:
        near = difflib.get_close_matches(name, BY_NAME, 1)
        raise Wrong(f'there is no command {name}' + (f' (did you mean {near[0]}?)' if near else '') +
                    '; `isochron --help` lists them')
    return BY_NAME[name]


def options_of(command, words):
    """All options of the command: those that were not given are None, or their default."""
    if command.arguments.startswith('WORD'):
        return argparse.Namespace(command=command.name, words=words, given=set())
    parser = Parser(prog=f'isochron {command.name}', add_help=False, allow_abbrev=False)
    names = command.options.split()
    for name in names:
        if OPTIONS[name].value:
            parser.add_argument(f'--{name}', action='append')
        else:
            parser.add_argument(f'--{name}', action='store_true', default=None)
    options, rest = parser.parse_known_args(words)
    for word in rest:
        if word.startswith('-') and word != '-':
            raise Wrong(unknown(command, word.split('=')[0]))
    options.given = {name for name in names if getattr(options, name) is not None}
    for name in names:
        setattr(options, name, value_of(name, getattr(options, name), command.defaults.get(name)))
    options.command = command.name
    take_arguments(command, options, rest)
    return options


def value_of(name, values, default):
    """The value of an option: the last that was given, of --set and --without all."""
    option = OPTIONS[name]
    if values is None or not option.value:
        return default if values is None else values
    value = '; '.join(values) if name in ('set', 'without') else values[-1]
    if option.choices and value not in option.choices:
        near = difflib.get_close_matches(value, option.choices, 1)
        raise Wrong(f'--{name} {value} is unknown; it can be {", ".join(option.choices[:-1])} or {option.choices[-1]}' +
                    (f' (did you mean {near[0]}?)' if near else ''))
    if option.check and not option.check(value):
        raise Wrong(f'--{name} {value} is no {option.value}; it could be {option.example}')
    return value


def unknown(command, word):
    """Why an option is refused: it has an effect on other commands alone, or there is none."""
    name = word.removeprefix('--')
    where = [other.name for other in COMMANDS if name in other.options.split()]
    if where:
        return f'{word} has no effect on {command.name}; it has one on: {" ".join(where)}'
    near = difflib.get_close_matches(name, command.options.split(), 1) or difflib.get_close_matches(name, OPTIONS, 1)
    return f'{word} is no option' + (f' (did you mean --{near[0]}?)' if near else '') + \
        f'; `isochron help {command.name}` lists those of {command.name}'


def take_arguments(command, options, words):
    """The scene, or what else a command is about."""
    wanted = command.arguments.split()
    if 'SCENE' in command.arguments:
        options.scene = words[0] if words else None
        if options.scene and options.scene.endswith('.c') and command.scenes_alone:
            raise Wrong(f'{command.name} is for scenes: {command.scenes_alone}')
    elif wanted:
        options.words = words
    many = wanted[-1:] == ['...]']
    least = sum(not word.startswith(('[', '...')) for word in wanted)
    if len(words) < least:
        raise Wrong(f'{command.name} needs {command.arguments}' +
                    (', such as isochron run models/pendulum.scene' if command.name == 'run' else ''))
    if len(words) > len(wanted) and not many:
        raise Wrong(f'{words[len(wanted)]} is one word too many: isochron {command.name} {command.arguments}'.strip())
    if getattr(options, 'scene', None) and not os.path.exists(options.scene):
        raise Wrong(missing(options.scene))


def missing(scene):
    """What there is instead of a scene that is not there."""
    folder = os.path.dirname(scene) or '.'
    near = []
    if os.path.isdir(folder):
        names = [name for name in os.listdir(folder) if name.endswith(('.scene', '.c'))]
        near = difflib.get_close_matches(os.path.basename(scene), names, 1)
    return f'there is no scene {scene}' + (f' (did you mean {os.path.join(os.path.dirname(scene), near[0])}?)' if near else '')
