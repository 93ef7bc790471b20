"""The text of a scene, with other statements at its top, and in another folder."""
import pathlib
import re


def elsewhere(path):
    """The scene so that it can stand in any folder: paths of its includes are from the root."""
    path = pathlib.Path(path)
    folder = path.resolve().parent
    return re.sub(r'(include *")([^/"])', lambda found: f'{found[1]}{folder}/{found[2]}', path.read_text())


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
