"""A controller over a link: 15 lines. Prints the hash of the run and the last angle of the pole."""
import struct
import sys

sys.path.insert(0, sys.argv[1])
import cart_pole_link as plant

ticks = int(sys.argv[2])
plant.PATIENCE = float(sys.argv[3]) / 1000 if len(sys.argv) > 3 else plant.PATIENCE


def rounded(x):
    return struct.unpack(plant.REAL, struct.pack(plant.REAL, x))[0]  # as a controller in C computes with floats


with plant.Link() as link:
    y = link.start("lockstep", ticks)
    while y:
        terms = [rounded(30 * y.pole), rounded(6 * y.pole_speed), rounded(2 * y.cart_position), rounded(4 * y.cart_speed)]
        y = link.exchange(force=rounded(rounded(rounded(terms[0] + terms[1]) + terms[2]) + terms[3]))
    print("hash %016x pole %.6g" % (link.end["hash"], link.outputs.pole))
