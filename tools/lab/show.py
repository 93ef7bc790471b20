"""`isochron show`: the page of a scene in motion, show.html, or a picture of one time, show.svg
(tools/show/README.md)."""
import argparse
import os
import pathlib
import shlex

from front import parse
from front.commands import BY_NAME
from lab import build
from lab.build import ROOT, Wrong


FRAMES_OF_SECOND = 12


class Shown:
    """A run that is shown: its shape, and the command that makes it. Its program stands apart from that of `run`: it
    has the poses of all bodies among its outputs."""

    def __init__(self, options, folder, label):
        self.label, self.folder = label, folder
        isoc, show = build.tools('isoc', 'show')
        folder.mkdir(parents=True, exist_ok=True)
        shape, scene = folder / 'shape', folder / pathlib.Path(options.scene).name
        choices = build.isoc_options(options)
        shape.write_text(build.call([isoc, options.scene, '--shape', *choices]))
        scene.write_text(build.call([show, 'scene', os.path.relpath(options.scene, folder), shape]))
        # Without optimisation a run has the same bits, and the compiler is done ten times sooner.
        plant = build.plant(argparse.Namespace(**{**vars(options), 'scene': scene}), folder=folder, flags='-O0')
        self.words = [label, shape, f'{shlex.quote(str(plant.program))} {build.nanoseconds(options.seconds)}']


def against(options, folder):
    """The words of build/show for the further runs: what is other in each, as options of `show`, or the name of a run
    that was kept."""
    words, number = [], 1
    for one in filter(None, map(str.strip, (options.against or '').split('|'))):
        kept = pathlib.Path('build/runs', one)
        if (kept / 'trace.csv').exists():
            words += [one, '-', kept]
            continue
        if not one.startswith('--'):
            raise Wrong(f"--against: '{one}' is no option of a run, and no run is kept as that; it could be --against "
                        f"'--real double | --without rub', or --against {one} after isochron run --keep {one}")
        other = parse.options_of(BY_NAME['show'], [options.scene, *shlex.split(one)])
        number += 1
        changed = argparse.Namespace(**{**vars(options), **{name: getattr(other, name) for name in other.given}})
        words += Shown(changed, folder / str(number), one.replace('--', '')).words
    return words


def still(shown, time):
    """The picture of the mechanism at a time."""
    return build.call([build.tools('show'), 'still', f'{time:.12g}', *shown.words[1:]])


def film(shown, seconds):
    """A picture that moves: the stills of a run, each shown for its part of it. What all have in common, the way of a
    point and the frame, stands there once."""
    count = round(FRAMES_OF_SECOND * seconds)
    frames = [still(shown, seconds * i / count).splitlines() for i in range(count)]
    head = next(i for i, lines in enumerate(zip(*frames)) if len(set(lines)) > 1 and not lines[0].startswith('<title>'))
    tail = next(i for i, lines in enumerate(zip(*map(reversed, frames))) if len(set(lines)) > 1)
    style = (f'<style>.f{{visibility:hidden;animation:f {seconds:g}s steps(1) infinite}}.f:first-of-type{{visibility:visible}}'
             f'@keyframes f{{0%{{visibility:visible}}{100 / count:.4g}%{{visibility:hidden}}}}</style>')
    text = [*frames[0][:head], style]
    for i, lines in enumerate(frames):
        text += [f'<g class="f" style="animation-delay:{seconds * (i / count - 1):.4g}s">',
                 *lines[head:len(lines) - tail], '</g>']
    return '\n'.join(text + frames[0][len(frames[0]) - tail:]) + '\n'


def run(options):
    place = pathlib.Path(options.out
                         or pathlib.Path('build/host', options.real or 'float', build.name_of(options.scene)))
    folder = place / 'show'
    with build.held(folder):
        first = Shown(options, folder / '1', pathlib.Path(options.scene).stem)
        is_picture = options.still or options.film
        path = place / ('show.svg' if is_picture else 'show.html')
        with build.progress(f'runs {options.scene}'):
            if options.film:
                text = film(first, build.nanoseconds(options.seconds) / 1e9)
            elif options.still:
                text = still(first, build.nanoseconds(options.still) / 1e9)
            else:
                text = build.call([build.tools('show'), 'page', ROOT / 'tools/show', *first.words,
                                   *against(options, folder)])
            build.write(path, text)
    print(f'{"picture" if is_picture else "page"} {path}')
