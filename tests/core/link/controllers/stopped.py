# A controller in lockstep, until the run is over: prints the last tick of its outputs, and what the plant says of its
# end.
import plant_link as plant

with plant.Link() as link:
    y = link.start("lockstep", 0)
    while y:
        y = link.exchange()
    print("tick %d ticks %d hash %016x" % (link.tick, link.end["ticks"], link.end["hash"]))
