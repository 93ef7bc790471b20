"""`isochron plot`: runs a scene and draws the run: trace.svg, all outputs over time, or those of --outputs; path.svg,
the way of a point of the mechanism, if an output is one; histogram.svg, the execution times, if the scene asks for
them; and all as png."""
from lab import build, draw, trace
from lab.picture import run as picture


def run(options):
    build.need(['gnuplot'], 'apt-get install gnuplot-nox')
    show(*made(options))


def made(options, **how):
    """Makes the run: its folder, and the outputs that are to be drawn."""
    plant = build.plant(options, **how)
    plant.run(options.seconds, options.script)
    plant.ended()
    return plant.folder, options.outputs.split(',') if options.outputs else ()


def drawn(folder, outputs=(), png=True):
    """Draws the run in a folder; the files."""
    its = trace.Run(folder)
    return draw.draw({folder / 'trace': picture.trace(its, outputs), folder / 'path': picture.path(its),
                      folder / 'histogram': picture.histogram(its)}, png)


def show(folder, outputs=()):
    """Draws the run in a folder, and names the files."""
    for file in drawn(folder, outputs):
        print(file)
