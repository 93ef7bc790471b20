"""What is printed of the table: help, the completion of bash, the man page."""
import textwrap

from .commands import COMMANDS, GROUPS
from .options import OPTIONS

ABOUT = 'Isochron compiles a mechanism, a scene, into C that steps it in real time on a microcontroller.'


def wrapped(text, indent, first=''):
    lines = textwrap.wrap(text, 118 - indent) or ['']
    return first.ljust(indent) + ('\n' + ' ' * indent).join(lines)


def overview():
    text = [ABOUT, '', 'usage: isochron COMMAND [SCENE] [--option value ...]']
    for group in GROUPS:
        text += ['', f'{group}:']
        text += [wrapped(command.help, 15, f'  {command.name}') for command in COMMANDS if command.group == group]
    return '\n'.join([*text, '', '`isochron help COMMAND` has its options. What is made stands in ./build.'])


def of_option(name, command):
    option = OPTIONS[name]
    text = option.help
    if option.choices:
        text += ': ' + ', '.join(option.choices)
    if name in command.defaults:
        text += f'; {command.defaults[name]} unless given'
    return f'--{name} {option.value}'.strip(), text


def command(command):
    """The help of a command."""
    text = [f'usage: isochron {command.name} {command.arguments} {"[--option value ...]" if command.options else ""}'.strip(),
            '', wrapped(command.help, 0)]
    rows = [of_option(name, command) for name in command.options.split()]
    if rows:
        text += ['', *(wrapped(said, 34, f'  {words}  ') for words, said in rows)]
    return '\n'.join(text)


def completion():
    """A script for bash: `eval "$(isochron --completion)"`."""
    cases = '\n'.join(f"        {command.name}) words='{' '.join('--' + name for name in command.options.split())}' ;;"
                      for command in COMMANDS)
    values = '\n'.join(f"        --{name}) words='{' '.join(option.choices)}' ;;"
                       for name, option in OPTIONS.items() if option.choices)
    return f'''_isochron()
{{
    local words='' word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
    if [ "$COMP_CWORD" -eq 1 ]; then
        words='help {' '.join(command.name for command in COMMANDS)}'
    else
        case ${{COMP_WORDS[1]}} in
{cases}
        esac
        case $before in
{values}
        esac
    fi
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _isochron isochron'''


def man():
    """The man page, isochron(1)."""
    def plain(text):
        return text.replace('\\', '\\e').replace('-', '\\-').replace("'", '\\(aq')
    text = ['.TH ISOCHRON 1', '.SH NAME', 'isochron \\- real\\-time simulation of mechanisms on microcontrollers',
            '.SH SYNOPSIS', '.B isochron', 'COMMAND [SCENE] [\\-\\-option value ...]', '.SH DESCRIPTION', plain(ABOUT)]
    for group in GROUPS:
        text.append(f'.SH {group.upper()}')
        for command in COMMANDS:
            if command.group == group:
                text += ['.TP', f'.B {command.name} {command.arguments}', plain(command.help)]
                if command.options:
                    text.append(plain('Options: ' + ' '.join('--' + name for name in command.options.split()) + '.'))
    text.append('.SH OPTIONS')
    for name, option in OPTIONS.items():
        choices = f': {", ".join(option.choices)}' if option.choices else ''
        text += ['.TP', f'.B {plain("--" + name)}', *([f'.I {plain(option.value)}'] if option.value else []),
                 plain(option.help + choices)]
    return '\n'.join(text)
