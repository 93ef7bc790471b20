"""Masses of geoms: MuJoCo's solids of one density."""
import math

import meshes
from model import Solid
from place import Place, add, minus, norm, scale, to_axis
from scene import number, vector

SEEN = "only seen"
OF_CONTACT = "contype conaffinity condim priority friction solmix solref solimp margin gap".split()
OF_SIGHT = "pos quat axisangle euler xyaxes zaxis size fromto mesh mass density type shellinertia".split()
MASSLESS = ("plane", "hfield")
SIZES = {"sphere": 1, "capsule": 2, "cylinder": 2, "ellipsoid": 3, "box": 3}


def read(reader, element, carrier, childclass, solids):
    """Adds the mass of a geom to `solids`, in the axes of its body."""
    found = reader.found(element, childclass)
    kind = found.get("type", "sphere")
    found.leave("contact is of points and balls with the ground", *OF_CONTACT)
    found.leave(SEEN, "material", "rgba", "hfield", "fitscale")
    found.leave("no fluid", "fluidshape", "fluidcoef")
    found.get("name")
    found.get("user")
    group = found.number("group", 0.0)
    mass, density = found.number("mass"), found.number("density", 1000.0)
    if carrier == "ground" or kind in MASSLESS or mass == 0 or (mass is None and density == 0):
        found.leave("it weighs nothing, and contact is of points and balls with the ground")
        return
    reader.model.unique_note("geoms count for what they weigh; contact is of points and balls with the ground")
    if not reader.settings.groups[0] <= group <= reader.settings.groups[1]:
        see(found)
        return
    if kind == "mesh" or found.has("mesh"):
        see(found)
        body, place = body_of(reader, element)
        if not reader.settings.takes_inertial(bool(body.all("inertial"))):
            try:
                solids.append(of_mesh(reader, found, kind, mass, density, place))
            except meshes.Unread as why:
                reader.model.mesh_bodies.add(carrier)
                found.leave(lost_mass(body, why))
        return
    if found.get("shellinertia") == "true":
        found.leave("a shell is taken as a solid", "shellinertia")
    if kind not in SIZES:
        found.problem(f"the type '{kind}' is not known: plane, hfield, mesh, {', '.join(SIZES)}", "type")
        return
    solid = of_kind(reader, found, kind, mass, density)
    if solid is not None:
        solid.place = body_of(reader, element)[1] * solid.place
        solids.append(solid)


def body_of(reader, element):
    """The <body> in which a geom stands, in frames or not; and the place of these there."""
    place, body = Place(), element.parent
    while body is not None and body.tag == "frame":
        place = reader.place(reader.found(body)) * place
        body = body.parent
    return body, place


def of_mesh(reader, found, kind, mass, density, place):
    """A mesh of one density, in the body."""
    if kind != "mesh":
        raise meshes.Unread(f"a {kind} that is fitted to a mesh is not taken")
    name = found.get("mesh")
    if not name:
        raise meshes.Unread("it names no mesh")
    known = meshes.integrals(reader, name, found.get("shellinertia") == "true")
    mass = density * known.size if mass is None else mass
    inertia = tuple(mass / known.size * x for x in known.inertia)
    return Solid(mass, place * reader.place(found) * Place(known.centre), inertia, of=found.element.attributes.get("name", name))


def lost_mass(body, why):
    """The message about a body that loses the mass of a mesh."""
    name = body.attributes.get("name")
    of = f"the body '{name}'" if name else f"the body of line {body.line()}"
    given = "inertiafromgeom leaves its <inertial> out" if body.all("inertial") else "the file gives no inertia for it"
    write = "write inertiafromgeom=\"auto\"" if body.all("inertial") else "write an <inertial> into it"
    return f"{of} loses the mass of this mesh, and {given}: {write}; {why}"


def see(found):
    """A geom without mass: its place and size are for display only."""
    for name in OF_SIGHT:
        found.get(name)


def of_kind(reader, found, kind, mass, density):
    sizes = found.numbers("size", (1, 3), [0.0, 0.0, 0.0])
    ends = found.numbers("fromto", 6) if kind != "sphere" else None
    if ends is not None:
        along = minus(ends[3:], ends[:3])
        if norm(along) == 0:
            found.problem("the ends of fromto are one point", "fromto")
            return None
        place = Place(scale(0.5, add(ends[3:], ends[:3])), to_axis(along))
        half = norm(along) / 2
        sizes = [sizes[0], half] if kind in ("capsule", "cylinder") else [sizes[0], sizes[0], half]
    else:
        place = reader.place(found)
    if len(sizes) < SIZES[kind] or min(sizes[: SIZES[kind]]) <= 0:
        found.problem(f"a {kind} has {SIZES[kind]} sizes above zero", "size")
        return None
    volume, moments, text = SHAPES[kind](*sizes[: SIZES[kind]])
    mass = density * volume if mass is None else mass
    if mass < 0:
        found.problem("a mass is not below zero", "mass")
        return None
    return Solid(
        mass, place, (*(mass * x for x in moments), 0.0, 0.0, 0.0), text, found.element.attributes.get("name", "")
    )


def sphere(r):
    return 4 / 3 * math.pi * r**3, [0.4 * r * r] * 3, f"sphere {number(r)} m"


def box(x, y, z):
    moments = [(y * y + z * z) / 3, (x * x + z * z) / 3, (x * x + y * y) / 3]
    return 8 * x * y * z, moments, f"box {vector((2 * x, 2 * y, 2 * z))} m"


def cylinder(r, h):
    across = r * r / 4 + h * h / 3
    return 2 * math.pi * r * r * h, [across, across, r * r / 2], f"cylinder {vector((r, 2 * h))} m"


def ellipsoid(x, y, z):
    moments = [(y * y + z * z) / 5, (x * x + z * z) / 5, (x * x + y * y) / 5]
    return 4 / 3 * math.pi * x * y * z, moments, ""


def capsule(r, h):
    """A cylinder with two half spheres: the centre of one is 3/8 of its radius beyond its plane."""
    rod, ball = 2 * math.pi * r * r * h, 4 / 3 * math.pi * r**3
    share, rest = rod / (rod + ball), ball / (rod + ball)
    across = share * (r * r / 4 + h * h / 3) + rest * (0.4 * r * r + h * h + 0.75 * h * r)
    return rod + ball, [across, across, share * r * r / 2 + rest * 0.4 * r * r], ""


SHAPES = {"sphere": sphere, "box": box, "cylinder": cylinder, "ellipsoid": ellipsoid, "capsule": capsule}
