"""Sets tunables of an FMU between steps, as a scene does at times: tunables.py FMU TRACE SUMMARY TIME:NAME:VALUE..."""
import sys

import check
import importer


def run(path, trace, summary, changes):
    fmu, reference = importer.Fmu(path), check.Reference(trace, summary)
    at = {round(float(t) / reference.step): (name, float(value)) for t, name, value in (c.split(":") for c in changes)}
    instance = importer.Instance(fmu)
    references = fmu.references(reference.names)
    instance.begin()
    wrong = []
    for tick, row in enumerate(reference.rows):
        if tick > 0:
            instance.step(reference.step, (tick - 1) * reference.step)
        if tick in at:
            instance.set_name(*at[tick])
        if check.bits(instance.get(references)) != check.bits(row):
            wrong.append(tick)
    check.result(not wrong and instance.hash() == reference.hash, "rows and hash %s" % wrong[:3])
    instance.free()


if __name__ == "__main__":
    run(*sys.argv[1:4], sys.argv[4:])
    print("1..%d" % check.results)
