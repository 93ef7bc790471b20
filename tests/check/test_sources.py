"""Of all sources: C is formatted, no file is too long, comments end at column 120, and names that core has for all begin
with iso_."""
import re
import subprocess

from harness.project import ROOT

KINDS = ('.c', '.h', '.S', '.in', '.sh', '.t', '.py', '.mk', '.scene', '.ld')
# Lines of a file.
MOST = 600


def sources():
    return [path for room in ('core', 'port', 'models', 'tools', 'tests') for path in (ROOT / room).rglob('*')
            if path.suffix in KINDS or path.name == 'Makefile']


def unformatted(*files):
    return subprocess.run(['clang-format', '-n', '--Werror', *files], capture_output=True, text=True, cwd=ROOT).stderr


def test_clang_format_has_nothing_to_change(tmp_path):
    files = [path for path in sources() if path.suffix in ('.c', '.h')]
    assert len(files) > 400 and not unformatted(*files)
    (tmp_path / 'planted.c').write_text('int  f(void){return 1;}\n')
    assert 'clang-format-violations' in unformatted(tmp_path / 'planted.c')


def too_wide(text):
    """Comments of scripts and makefiles; indented ones show a call."""
    return [line for line in text.splitlines() if len(line) > 120 and re.match(r' *# [^ ]', line) and '# shellcheck ' not in line]


def test_files_are_short_and_comments_are_narrow():
    texts = {str(path.relative_to(ROOT)): path.read_text() for path in [*sources(), ROOT / 'Makefile']}
    assert not [name for name, text in texts.items() if text.count('\n') > MOST]
    assert not [(name, found) for name, text in texts.items()
                if name.endswith(('.sh', '.t', '.mk', 'Makefile')) and (found := too_wide(text))]


def test_found_a_comment_that_is_wider():
    assert too_wide('# ' + 'a' * 119) and not too_wide('# ' + 'a' * 118)


def strange(folder, *files):
    """What these files define for all and is not called iso_; a program's main aside."""
    for number, file in enumerate(files):
        subprocess.run(['tcc', '-std=c11', '-include', ROOT / 'tools/lab/tcc.h', '-I', ROOT, '-c', file, '-o', folder / f'{number}.o'],
                       check=True)
    named = subprocess.run(['nm', '-g', '-P', '--defined-only', *folder.glob('*.o')], capture_output=True, text=True, check=True)
    names = {line.split()[0] for line in named.stdout.splitlines() if len(line.split()) > 1}
    return {name for name in names if not name.startswith('iso_')} - {'main'}, len(names)


def test_names_that_core_has_for_all_begin_with_iso(tmp_path):
    found, count = strange(tmp_path, *(path for path in (ROOT / 'core').glob('*/*.c') if path.parent.name != 'conform'))
    assert count > 40 and not found
    (tmp_path / 'planted.c').write_text('int step(void);\nint step(void)\n{\n    return 1;\n}\n')
    assert strange(tmp_path, tmp_path / 'planted.c')[0] == {'step'}
