"""Results that are kept by what they follow from: what was measured once is not measured again."""
import functools
import hashlib
import os
import pathlib
import pickle
import threading

from lab import build
from lab.build import ROOT

FOLDER = pathlib.Path('build/kept')


@functools.cache
def sources():
    """A hash of all that plants, and what is measured of them, are made by."""
    files = [build.tools('isoc')]
    for folder in ('core', 'port', 'tools/lab', 'tools/measure/cycles'):
        files += sorted(path for path in (ROOT / folder).rglob('*') if path.suffix in
                        {'.c', '.h', '.S', '.mk', '.ld', '.py', '.txt'})
    return hashlib.sha256(b''.join(hashlib.sha256(path.read_bytes()).digest() for path in files)).hexdigest()


def kept(make, *facts):
    """What `make()` returns; it is called where nothing is kept for these facts, whose text says all that it follows
    from besides the sources. The file is there when it is whole."""
    text = repr((sources(), os.environ.get('CC'), os.environ.get('CFLAGS'), facts))
    path = FOLDER / hashlib.sha256(text.encode()).hexdigest()[:32]
    try:
        return pickle.loads(path.read_bytes())
    except (OSError, EOFError, pickle.UnpicklingError):
        pass
    result = make()
    FOLDER.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_suffix(f'.{os.getpid()}.{threading.get_ident()}')
    unfinished.write_bytes(pickle.dumps(result))
    unfinished.replace(path)
    return result
