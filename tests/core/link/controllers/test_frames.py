"""The tables of core/link/README.md name the fields of core/wire/protocol.h: the types of each payload, in their
order."""
import collections
import re

import pytest

from harness.project import ROOT

README = (ROOT / 'core/link/README.md').read_text()
HEADER = (ROOT / 'core/wire/protocol.h').read_text()


def lists():
    """Of each list of the header its fields as the text names their types; frames by letter and commands by number."""
    fields, frames, commands = collections.defaultdict(list), {}, {}
    for name, body in re.findall(r'#define (\w+)(?:\(X\))?((?:.*\\\n)*.*)', HEADER):
        for kind, count in re.findall(r'X\([a-z_]*, ([A-Z0-9]*), ([A-Z0-9]*)\)', body):
            fields[name].append(kind.lower() if count == '1' else {'REAL': 'reals', 'U64': '64 bits'}.get(kind, 'bytes'))
        for frame, letter in re.findall(r"X\(([A-Z]*), '(\w)'\)", body):
            frames[frame] = letter
        for command, number in re.findall(r'X\(([A-Z]*), (\d+)\)', body):
            commands[command] = number
    return fields, frames, commands


def types(text):
    """The types that a cell names, such as `u8 version, u16 inputs`."""
    return [' '.join(found.split()) for found in re.findall(r'u\d+ |reals|64 bits', text)]


def taken(text):
    """What a command takes, by a cell: of each field with a type the type alone."""
    text = re.sub(r'(u\d*) [^,]*', r'\1', text.replace(', 0 without an end', ''), count=0)
    return re.sub(', real', ' reals', re.sub(r', \d* to \d* bytes', ' bytes', text)).replace(',', '').strip()


def differing(text):
    """What the tables of the text have otherwise than the header; and how many frames and commands that has."""
    fields, frames, commands = lists()
    rows = [[cell.strip() for cell in line.split('|')] for line in text.splitlines() if line.startswith('|')]
    wrong = []
    for frame, letter in frames.items():
        senders = ['controller' if letter in 'hsuec' else 'plant'] + (['plant'] if frame == 'END' else [])
        for place, sender in enumerate(senders):
            wanted = [] if frame == 'END' and sender == 'controller' else fields[f'ISO_LINK_{frame}_FIELDS']
            said = [types(row[3]) for row in rows if row[1].startswith(f'`{letter}`') and row[2] == sender]
            wrong += [frame] if said != [wanted] else []
    takes = [(row[2], taken(row[3])) for row in rows if re.fullmatch(r'\d+', row[2])]
    names = {'WRITE': 'ISO_COMMAND_PIECE_FIELDS', 'SET': 'ISO_COMMAND_VALUE_FIELDS'}
    wanted = [(number, ' '.join(fields[names.get(name, f'ISO_COMMAND_{name}_TAKES')])) for name, number in commands.items()]
    wrong += [f'command {name}' for name, said, want in zip(commands, takes, wanted) if said != want]
    wrong += ['commands'] if len(takes) != len(wanted) else []
    state = re.search(r'any other one with [^.]*', ' '.join(text.split()))[0]
    wrong += ['state'] if types(state) != fields['ISO_COMMAND_STATE_FIELDS'] else []
    return wrong


def test_the_tables_have_the_fields_of_the_header():
    fields, frames, commands = lists()
    assert (len(frames), len(commands), fields['ISO_LINK_START_FIELDS']) == (9, 11, ['u64', 'u8', 'u64'])
    assert differing(README) == []


@pytest.mark.parametrize('name, line, old, new', (
    ('START', r'\| `s` start.*', 'u8 mode', 'u16 mode'), ('REFUSAL', r'\| `n` refusal.*', 'u8 reason, ', ''),
    ('command WRITE', '.*u32 offset, 1 to.*', 'u32 offset', 'u16 offset'),
    ('state', '.*any other one with u8 state.*', 'with u8 state', 'with state')))
def test_found_in_a_table(name, line, old, new):
    changed = re.sub(f'^{line}$', lambda found: found[0].replace(old, new), README, flags=re.M)
    assert changed != README and differing(changed) == [name]
