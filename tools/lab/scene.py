"""Scenes as text: with other statements, in other folders."""
import collections
import pathlib
import re


def elsewhere(path):
    """The text of a scene so that it can stand in any folder: paths of its includes are absolute."""
    folder = str(path.parent.resolve())
    return re.sub(r'(\binclude *")(?!/)', lambda word: word[1] + folder + '/', path.read_text())


def with_values(text, summary):
    """The text in which values of effects that follow from step and method are written, so that they are the same for
    all methods: by isoc's lines `stable EFFECT.VALUE NUMBER UNIT`. An included file takes the place of its statement if
    that has its own line."""
    values = collections.defaultdict(str)
    for line in summary.splitlines():
        words = line.split()
        if words[:1] == ['stable'] and words[1].count('.') == 1:
            effect, value = words[1].split('.')
            values[effect] += f" {value} {words[2]} {' '.join(words[3:4])};"

    def lines(text, folder):
        for line in text.splitlines():
            include = re.fullmatch(r' *include *"([^"]*)" *(#.*)?', line)
            if include:
                path = folder / include[1]
                yield from lines(path.read_text(), path.parent)
                continue
            words = line.split()
            if words[:1] == ['effect'] and words[1:2] and words[1] in values:
                line = line.replace('{', '{' + values[words[1]], 1)
            yield line

    return '\n'.join(lines(text, pathlib.Path())) + '\n'


def edited(text, statements, must=None):
    """The text with these values of statements, by their words: each stands in the place of the one that the scene has at
    its top, or at the end; None takes it away. None, where the word `must` has no place of its own in this text."""
    seen = set()

    def of_piece(piece):
        blanks, words, behind = re.fullmatch(r'(\s*)(.*?)(\s*)', piece, re.S).groups()
        word = words.split(None, 1)[0] if words else ''
        if word not in statements:
            return piece
        seen.add(word)
        return '' if statements[word] is None else f'{blanks}{word} {statements[word]}{behind}'

    lines, depth = [], 0
    for line in text.splitlines():
        # Text in braces, in quotes or behind # stays.
        out, piece, quoted, nested, rest = '', '', False, depth > 0, ''
        for place, letter in enumerate(line):
            if quoted or letter == '"':
                quoted = quoted != (letter == '"')
                piece += letter
            elif letter == '#':
                rest = line[place:]
                break
            elif letter == ';' and depth == 0:
                out += (piece if nested else of_piece(piece)) + ';'
                piece, nested = '', False
            else:
                depth += (letter == '{') - (letter == '}')
                nested = nested or letter in '{}'
                piece += letter
        out = re.sub(r'^[ \t]*;[ \t]*', '', out + (piece if nested else of_piece(piece)) + rest)
        if out.strip(' \t') or not line.strip(' \t'):
            lines.append(out)
    if must and must not in seen:
        return None
    lines += [f'{word} {value}' for word, value in statements.items() if word not in seen and value is not None]
    return '\n'.join(lines) + '\n'
