"""What again.c does; and what is wrong is an error with a reason."""
import sys

sys.path.insert(0, sys.argv[1])
import cart_pole_link as plant


def run(link, exchanges):
    y = link.start("lockstep")
    for _ in range(exchanges):
        y = link.exchange(force=30 * y.pole + 6 * y.pole_speed + 2 * y.cart_position + 4 * y.cart_speed)
    end = link.stop()
    assert end["ticks"] == exchanges and link.stop() is end
    return end["hash"]


def reason(call, *arguments, **named):
    try:
        call(*arguments, **named)
    except plant.LinkError as error:
        return str(error)
    return ""


with plant.Link() as link:
    assert run(link, 100) == run(link, 100)
    y, last = link.start("free", 20000), -1
    while y:
        assert link.tick > last
        last = link.tick
        y = link.exchange(force=0.0)
    assert link.end["ticks"] == 20000 and link.end["link_inputs"] > 0 and link.end["margin"] > 0
    assert link.end["link_inputs"] + link.end["link_missing"] >= 20000
    link.start("lockstep", 10)
    assert reason(link.exchange, push=1.0) == "no input is called push; there are: force"
    plant.IDENTITY ^= 1
    assert reason(link.start, "lockstep", 10).startswith("refused: another plant")
assert plant.INPUTS == {"force": ("N", -20, 20)} and plant.OUTPUTS["pole_speed"][0] == "rad/s"
print("good")
