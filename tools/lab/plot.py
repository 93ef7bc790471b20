"""`isochron plot`: runs a scene and draws the run: trace.svg, all outputs over time, or those of --outputs; path.svg, the
way of a point of the mechanism, if an output is one; histogram.svg, the execution times, if the scene asks for them; and
all as png."""
from lab import build, draw, trace
from lab.picture import run as picture


def run(options):
    build.need(['gnuplot'], 'apt-get install gnuplot-nox')
    for file in plotted(options):
        print(file)


def plotted(options, png=True):
    """The files that are drawn."""
    plant = build.plant(options)
    plant.run(options.seconds, options.script)
    plant.ended()
    return drawn(plant.folder, options.outputs.split(',') if options.outputs else (), png)


def drawn(folder, outputs=(), png=True):
    """Draws the run in a folder."""
    run_of_it = trace.Run(folder)
    return draw.draw({folder / 'trace': picture.trace(run_of_it, outputs), folder / 'path': picture.path(run_of_it),
                      folder / 'histogram': picture.histogram(run_of_it)}, png)
