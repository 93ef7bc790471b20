"""<equality> of MJCF: closures and gears. They hold the relations of the bodies as the file draws them."""
import effects
from place import UNTURNED as AXES
from place import Place, cross, minus, norm, of_quaternion, scale, turned
from scene import axis_of, number, where
from settings import SWITCHED_OFF

SOFT = "a closure is hard"
ROWS = {"spherical": 3, "fixed": 6, "revolute": 5, "distance": 1, "gear": 1}


def read(reader):
    reader.connects = {}  # by both carriers: (name, place on the one, place on the other)
    reader.held = []  # of closures: kind, both carriers and places, axis, length; of a gear: kind, joints with factors
    for element in reader.parts_of("equality"):
        maker = {"connect": connect, "weld": weld, "joint": joint, "tendon": tendon}.get(element.tag)
        if "equality" in reader.settings.off:
            element.leave(SWITCHED_OFF)
            continue
        if maker is None:
            element.leave("only connect, weld, joint and tendon are closures")
            continue
        found = reader.found(element, "", ["equality"])
        found.leave(SOFT, "solref", "solimp")
        if found.get("active", "true") == "false":
            found.leave("it is not active")
            continue
        maker(reader, found)
    for points in reader.connects.values():
        connected(reader, points)
    if reader.model.closures:
        reader.model.notes.append("an equality is a closure, which is hard; MuJoCo's is soft")
        for made, _ in reader.joints.values():
            made.is_given = True
        check_rank(reader)


def globals_of(model, at_start=False, moved=None, places=None):
    """The place of each body where all coordinates are zero, or at their start. With `places`, and a joint that is moved
    by a place, those of the bodies that it carries differ."""
    found = dict(places or {"ground": Place()})
    carried = set()
    for made in model.joints.values():
        is_moved = moved is not None and moved[0] is made
        if places is not None and not is_moved and made.parent not in carried:
            continue
        carried.add(made.child)
        start = made.place_at_start() if at_start else made.start_place or Place()
        start = start * moved[1] if is_moved else start
        found[made.child] = found[made.parent] * made.parent_place * start * made.child_place.inverse()
    return found


def distance(reader, points):
    """Of two points of bodies where the file draws them."""
    places = globals_of(reader.model)
    (one, at_one), (other, at_other) = points
    return norm(minus(places[one].point(at_one.at), places[other].point(at_other.at)))


def body(reader, found, name, default=None):
    text = found.get(name, default)
    if text is None:
        found.problem(f"<{found.element.tag}> has no {name}")
    elif text not in reader.carrier:
        found.problem(f"there is no body '{text}'", name)
    return reader.carrier.get(text, ("ground", Place()))


def named(reader, found, one, other):
    return reader.model.name(found.get("name") or f"{one}_to_{other}", "closure", not found.get("name"))


def ends(reader, found):
    """The two sides of a connect or a weld: carriers and places."""
    if found.has("site1") or found.has("site2"):
        sides = []
        for name in ("site1", "site2"):
            site = found.get(name)
            if site not in reader.sites:
                found.problem(f"there is no site '{site}'", name)
                return None
            sides.append(reader.sites[site])
        return sides
    return [body(reader, found, "body1"), body(reader, found, "body2", "world")]


def close(reader, name, kind, first, second, more=(), axis=AXES[2], size=0.0):
    (one, at_one), (other, at_other) = first, second
    reader.held.append((kind, first, second, axis, size))
    reader.model.close(name, kind, f"parent {one}{where(at_one)}", f"child {other}{where(at_other)}", *more)


def connect(reader, found):
    sides = ends(reader, found)
    if sides is None:
        return
    (one, at_one), (other, at_other) = sides
    if not found.has("site1"):
        anchor = found.numbers("anchor", 3)
        if anchor is None:
            found.problem("a connect has an anchor: anchor=\"0 0 0\"")
            return
        places = globals_of(reader.model)
        at_one = Place(at_one.point(anchor))
        at_other = Place(places[other].inverse().point(places[one].point(at_one.at)))
    if one == other:
        found.leave("both sides are one body of the scene")
        return
    name = named(reader, found, one, other)
    reader.connects.setdefault((one, other), []).append((name, (one, Place(at_one.at)), (other, Place(at_other.at))))


def connected(reader, points):
    """Connects two bodies at common points: a point, an axis of two, or fixed if three are not on a line."""
    (name, (one, at_one), (other, at_other)), *more = points
    away = [minus(first[1].at, at_one.at) for _, first, _ in more]
    longest = max(away, key=norm, default=(0.0, 0.0, 0.0))
    if norm(longest) < 1e-6:
        close(reader, name, "spherical", (one, at_one), (other, at_other))
        return
    places = globals_of(reader.model)
    turn = (places[other].inverse() * places[one]).turn
    ends_of_it = (one, at_one), (other, Place(at_other.at, turn))
    if any(norm(cross(longest, v)) > 1e-6 * norm(longest) for v in away):
        close(reader, name, "fixed", *ends_of_it)
    else:
        axis = scale(1 / norm(longest), longest)
        close(reader, name, "revolute", *ends_of_it, [f"axis {axis_of(axis)}"], axis)


def tendon(reader, found):
    """A straight tendon that keeps its length is a rod; one of two joints a gear."""
    text = found.get("tendon1")
    if text not in reader.tendons:
        found.problem(f"there is no tendon '{text}'", "tendon1")
        return
    length = reader.tendons[text]
    more = found.numbers("polycoef", (1, 5), [0.0])[0]
    if found.has("tendon2") or length is None or (length.points is None and len(length.joints) != 2):
        found.leave("one tendon between two sites, or of two joints, is a closure")
        return
    if length.points is None:
        (first, one), (second, other) = length.joints
        gear(reader, named(reader, found, first.name, second.name), first, second, -other / one, more / one)
        return
    (one, at_one), (other, at_other) = length.points
    size = distance(reader, length.points) + more
    first, second = (one, Place(at_one.at)), (other, Place(at_other.at))
    close(reader, named(reader, found, one, other), "distance", first, second, [f"length {number(size)} m"], size=size)


def weld(reader, found):
    sides = ends(reader, found)
    if sides is None:
        return
    (one, at_one), (other, at_other) = sides
    found.leave(SOFT, "torquescale")
    found.leave("a weld holds all of a body, wherever its anchor is", "anchor")
    pose = found.numbers("relpose", 7)
    if not found.has("site1"):
        places = globals_of(reader.model)
        if pose is not None and any(pose[3:]):
            at_one = at_one * Place(pose[:3], of_quaternion(pose[3:]))
        else:
            at_one = places[one].inverse() * places[other] * at_other
    if one == other:
        found.leave("both sides are one body of the scene")
        return
    close(reader, named(reader, found, one, other), "fixed", (one, at_one), (other, at_other))


def joint(reader, found):
    """joint1 = a + b joint2, each from where the file draws it; higher powers are no gear."""
    name, other = found.get("joint1"), found.get("joint2")
    for which, text in (("joint1", name), ("joint2", other)):
        if text not in reader.joints and not (which == "joint2" and text is None):
            found.problem(f"there is no joint '{text}'", which)
            return
    coefficients = [*found.numbers("polycoef", (1, 5), [0.0, 1.0, 0.0, 0.0, 0.0]), 0.0, 0.0, 0.0, 0.0][:5]
    if any(coefficients[2:]):
        found.leave("a polynomial is no gear: polycoef with two numbers is")
        return
    first = reader.joints[name][0]
    second = reader.joints[other][0] if other is not None else None
    if not first.has_one_coordinate() or (second is not None and not second.has_one_coordinate()):
        found.leave("of joints of one coordinate that move")
        return
    if second is None:
        closure = named(reader, found, first.name, "place")
        first.start = coefficients[0]
        motion = f"motion {number(coefficients[0])} {first.unit()}"
        reader.model.close(closure, "motion", f"first {first.name}", motion)
        return
    gear(reader, named(reader, found, first.name, second.name), first, second, coefficients[1], coefficients[0])


def gear(reader, name, first, second, ratio, offset):
    first.start = offset + ratio * second.start
    reader.held.append(("gear", (first, 1.0), (second, -ratio)))
    effects.gear(reader.model, name, first, second, ratio)


# --- starts that closures hold ---


def hold_at_start(reader):
    """Whether all closures hold at the starts; gears do."""
    return max(map(abs, all_rows(reader, globals_of(reader.model, True))), default=0.0) < 1e-9


def close_starts(reader):
    """Moves the starts a little until closures hold, as soft ones of MuJoCo do not; returns whether it converges."""
    for _ in range(30):
        wrong = all_rows(reader, globals_of(reader.model, True))
        if max(map(abs, wrong), default=0.0) < 1e-12:
            return True
        changes = list(columns(reader, True))
        wrong += [0.0] * (len(changes[0]) - len(wrong))  # gears hold, and go on to
        count = range(len(wrong))
        square = [[sum(change[i] * change[k] for change in changes) + 1e-10 * (i == k) for k in count] for i in count]
        factors = solution(square, wrong)
        steps = [-sum(x * y for x, y in zip(change, factors)) for change in changes]
        for made in reader.model.joints.values():
            own = [steps.pop(0) for _ in motions(made)]
            if made.has_one_coordinate():
                made.start += own[0]
            elif own:
                slide = Place(own[:-3]) if made.kind == "free" else Place()
                made.key_place = made.place_at_start() * slide * turned(list(zip(own[-3:], AXES)))
    return hold_at_start(reader)


def eliminate(rows, column):
    """Gauss: takes the first row from the others, so that they have zeros in this column."""
    first, *others = rows
    for row in others:
        factor = row[column] / first[column]
        for j in range(column, len(row)):
            row[j] -= factor * first[j]


def solution(matrix, right):
    """Of a positive definite matrix."""
    rows = [[*row, x] for row, x in zip(matrix, right)]
    for k in range(len(rows)):
        eliminate(rows[k:], k)
    found = [0.0] * len(rows)
    for k in reversed(range(len(rows))):
        found[k] = (rows[k][-1] - sum(rows[k][j] * found[j] for j in range(k + 1, len(rows)))) / rows[k][k]
    return found


# --- redundant closures ---

STEP = 1e-5  # m and rad, of a difference


def rows_of(kind, relative, axis, size):
    """The residuals of a closure, which it holds at zero: of its second frame in its first."""
    turn = (relative.turn[2][1], relative.turn[0][2], relative.turn[1][0])
    return {
        "distance": (norm(relative.at) - size,),
        "spherical": relative.at,
        "revolute": (*relative.at, *cross(axis, turn)),
        "fixed": (*relative.at, *turn),
    }[kind]


def motions(made):
    """The ways of a joint to move, as places a step away and back."""
    axes = [scale(1 / norm(made.axis), made.axis)] if made.has_one_coordinate() else AXES
    turns = [(turned([(STEP, axis)]), turned([(-STEP, axis)])) for axis in axes]
    slides = [(Place(scale(STEP, axis)), Place(scale(-STEP, axis))) for axis in axes]
    ways = {"revolute": turns, "prismatic": slides, "spherical": turns, "free": slides + turns}
    return ways.get(made.kind, [])


def all_rows(reader, places):
    """The residuals of all closures but gears."""
    rows = []
    for kind, (one, at_one), (other, at_other), *more in (held for held in reader.held if held[0] != "gear"):
        relative = (places[one] * at_one).inverse() * places[other] * at_other
        rows += rows_of(kind, relative, *more)
    return rows


def columns(reader, at_start=False):
    """The derivatives of all residuals by each way to move."""
    gears = [held for held in reader.held if held[0] == "gear"]
    places = globals_of(reader.model, at_start)
    for made in reader.model.joints.values():
        for way in motions(made):
            ends_of_it = (all_rows(reader, globals_of(reader.model, at_start, (made, step), places)) for step in way)
            yield [(x - y) / (2 * STEP) for x, y in zip(*ends_of_it)] + [
                (first[0] is made) * first[1] + (second[0] is made) * second[1] for _, first, second in gears
            ]


def rank(rows):
    """With pivots, of rows of about one size."""
    rows, found = [list(row) for row in rows], 0
    for k in range(len(rows[0]) if rows else 0):
        best = max(range(found, len(rows)), key=lambda i: abs(rows[i][k]), default=None)
        if best is None or abs(rows[best][k]) < 1e-7:
            continue
        rows[found], rows[best] = rows[best], rows[found]
        eliminate(rows[found:], k)
        found += 1
    return found


def check_rank(reader):
    """Redundant closures, as a connect in a plane, need another stabilisation."""
    count = sum(ROWS[kind] for kind, *_ in reader.held)
    found = rank(list(columns(reader)))
    if found < count:
        reader.model.stabilisation = "lagrangian"
        reader.model.notes.append(
            f"the closures are redundant: of {count} constraints {found} count, which stabilisation lagrangian takes"
        )
