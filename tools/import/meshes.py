"""Meshes of MJCF, where a body has its mass from one: STL, OBJ, or vertices and faces in the file; volume, centre and inertia
by exact integrals over its triangles.

https://mujoco.readthedocs.io/en/stable/XMLreference.html, asset/mesh."""
import math
import os
import struct
from collections import Counter
from dataclasses import dataclass

from place import Place, add, apply, cross, dot, minus, norm, of_quaternion, scale, transpose

LEAST = 1e-15  # m^3 or m^2
CONVEX = 1e-6  # of the volume: what MuJoCo's own sum may differ by, which is of the sizes of parts
OF_PICTURES = """normal texcoord facenormal facetexcoord smoothnormal maxhullvert material octree_maxdepth
needsdf""".split()


class Unread(Exception):
    """The mesh cannot be read: why."""


@dataclass
class Integrals:
    size: float  # volume in m^3, or of a shell the area in m^2
    centre: tuple
    inertia: tuple  # xx, yy, zz, xy, xz, yz of a density of 1
    parts: float  # the sum of the sizes of all parts, without signs
    open_edges: int


def collect(reader):
    """The meshes of the file by their names, and the reasons why the other assets are not taken."""
    for child in reader.parts_of("asset"):
        if child.tag != "mesh":
            child.leave("pictures")
            continue
        found = reader.found(child)
        name = found.get("name") or os.path.splitext(os.path.basename(found.get("file", "")))[0]
        reader.meshes[name] = found


def finish(reader):
    """Names the meshes that no mass was read of."""
    for name, found in reader.meshes.items():
        if name not in reader.integrals:
            found.leave("no mass is that of this mesh, and contact is of points and balls with the ground")
        else:
            found.leave("only seen", *OF_PICTURES)


def integrals(reader, name, is_shell):
    """Of a mesh, read once."""
    found = reader.meshes.get(name)
    if found is None:
        raise Unread(f"there is no mesh '{name}'")
    known = reader.integrals.setdefault(name, {})
    kind = found.get("inertia", "exact" if reader.settings.exact_meshes else "legacy")
    is_shell = is_shell or kind == "shell"
    if is_shell not in known:
        whole = integrate(triangles(reader, found), is_shell)
        if abs(whole.size) < LEAST:
            raise Unread(f"the mesh '{name}' has no {'area' if is_shell else 'volume'}")
        note(reader.model, name, whole, kind, is_shell)
        known[is_shell] = whole
    return known[is_shell]


def note(model, name, found, kind, is_shell):
    """What is to be said of a mesh that was read."""
    size = f"an area of {found.size:.6g} m^2" if is_shell else f"a volume of {found.size:.6g} m^3"
    model.notes.append(f"the mesh {name} has {size}, of which masses follow")
    if not is_shell and found.open_edges:
        model.notes.append(
            f"warning: the mesh {name} is not closed: {found.open_edges} edges have no neighbour that goes on beyond them; what "
            "is open is closed from its middle"
        )
    elif not is_shell and kind != "exact" and found.parts > found.size * (1 + CONVEX):
        more = "its hull, which is larger" if kind == "convex" else f"{100 * (found.parts / found.size - 1):.3g} % more"
        model.notes.append(f"the mesh {name} is not convex: its own volume counts, where MuJoCo counts {more} (inertia {kind})")


# --- files ---


def triangles(reader, found):
    """Of a mesh in its place, in m."""
    if found.has("file"):
        corners = of_file(path_of(reader, found.get("file")))
    elif found.has("vertex") and found.has("face"):
        numbers = found.numbers("vertex", (9, 10**9), [0.0] * 9)
        faces = found.numbers("face", (3, 10**9), [0, 0, 0])
        if len(numbers) % 3 or len(faces) % 3:
            raise Unread("each vertex and each face is three numbers")
        points = [tuple(numbers[k : k + 3]) for k in range(0, len(numbers), 3)]
        if not all(k in range(len(points)) for k in faces):
            raise Unread("a face has a vertex that is not there")
        corners = [tuple(points[int(k)] for k in faces[n : n + 3]) for n in range(0, len(faces), 3)]
    else:
        raise Unread("a mesh without faces, as a hull of points, is not taken")
    at = found.numbers("refpos", 3, [0.0, 0.0, 0.0])
    quaternion = found.numbers("refquat", 4, [1.0, 0.0, 0.0, 0.0])
    back = transpose(of_quaternion(quaternion)) if norm(quaternion) > 0 else Place().turn
    factors = found.numbers("scale", 3, [1.0, 1.0, 1.0])
    placed = {
        point: tuple(f * x for f, x in zip(factors, apply(back, minus(point, at))))
        for point in {point for corner in corners for point in corner}
    }
    return [tuple(placed[point] for point in corner) for corner in corners]


def path_of(reader, file):
    settings = reader.settings
    name = os.path.basename(file) if settings.strips_paths else file
    return os.path.join(os.path.dirname(os.path.abspath(reader.document.path)), settings.mesh_folder, name)


def of_file(path):
    readers = {".stl": of_stl, ".obj": of_obj}
    ending = os.path.splitext(path)[1].lower()
    if ending not in readers:
        raise Unread(f"a mesh in {ending or 'a file without an ending'} is not read, .stl and .obj are")
    try:
        with open(path, "rb") as file:
            return readers[ending](file.read())
    except OSError as error:
        raise Unread(f"the file '{path}' cannot be read: {error.strerror}") from error
    except (ValueError, IndexError, struct.error) as error:
        raise Unread(f"the file '{path}' is no {ending[1:].upper()}: {error}") from error


def of_stl(data):
    """A binary file has 80 bytes, the number of triangles, and 50 bytes for each: normal, corners, attribute."""
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else 0
    if len(data) == 84 + 50 * count and count > 0:
        rows = (struct.unpack_from("<9f", data, 84 + 50 * k + 12) for k in range(count))
        return [finite((row[:3], row[3:6], row[6:])) for row in rows]
    words = data.decode("ascii", "replace").split()
    if words[:1] != ["solid"] or "vertex" not in words:
        raise ValueError("neither the text nor the length of a binary file")
    points = [tuple(map(float, words[k + 1 : k + 4])) for k, word in enumerate(words) if word == "vertex"]
    if len(points) % 3 or not points:
        raise ValueError("its vertices are no triangles")
    return [finite(points[k : k + 3]) for k in range(0, len(points), 3)]


def of_obj(data):
    """Lines `v x y z`, and `f 1 2 3` or `f 1/2/3 -1 ...`, whose polygons are fans of triangles."""
    points, found = [], []
    for line in data.decode("utf-8", "replace").replace("\\\n", " ").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            numbers = [int(word.split("/")[0]) for word in words[1:]]
            if 0 in numbers or any(n > len(points) or n < -len(points) for n in numbers):
                raise ValueError(f"a face has a vertex that is not there: {line.strip()}")
            corners = [points[n - 1 if n > 0 else n] for n in numbers]
            found += [finite((corners[0], corners[k], corners[k + 1])) for k in range(1, len(corners) - 1)]
    if not found:
        raise ValueError("it has no face")
    return found


def finite(corners):
    if not all(len(point) == 3 and all(map(math.isfinite, point)) for point in corners):
        raise ValueError("a corner is not three finite numbers")
    return tuple(map(tuple, corners))


# --- integrals ---


def integrate(corners, is_shell):
    """Sums over the pyramids between the middle of the surface and each triangle, with signs, or over the triangles: of a
    closed mesh exact, whichever point is the middle. A simplex of n corners v has the mean of x x' of (sum of v v' + s s')
    / (n (n + 1)), with s the sum of its corners."""
    middle, areas = (0.0, 0.0, 0.0), 0.0
    for a, b, c in corners:
        area = norm(cross(minus(b, a), minus(c, a))) / 2
        middle, areas = add(middle, scale(area / 3, add(add(a, b), c))), areas + area
    middle = scale(1 / areas, middle) if areas > 0 else middle
    n = 3 if is_shell else 4
    size, parts, first, second = 0.0, 0.0, [0.0] * 3, [[0.0] * 3 for _ in range(3)]
    for corner in corners:
        a, b, c = (minus(point, middle) for point in corner)
        across = cross(minus(b, a), minus(c, a))
        part = norm(across) / 2 if is_shell else dot(a, across) / 6
        size, parts = size + part, parts + abs(part)
        s = add(add(a, b), c)
        for i in range(3):
            first[i] += part * s[i] / n
            for j in range(3):
                second[i][j] += part * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]) / (n * (n + 1))
    if abs(size) < LEAST:
        return Integrals(0.0, middle, (0.0,) * 6, parts, 0)
    away = [x / size for x in first]
    sign = math.copysign(1.0, size)  # of a mesh that is turned inside out
    about = [[sign * (second[i][j] - size * away[i] * away[j]) for j in range(3)] for i in range(3)]
    trace = about[0][0] + about[1][1] + about[2][2]
    inertia = (*(trace - about[i][i] for i in range(3)), -about[0][1], -about[0][2], -about[1][2])
    return Integrals(sign * size, add(middle, away), inertia, parts, open_edges(corners))


def open_edges(corners):
    """Edges that the triangles do not go along as often to the one side as to the other."""
    ways = Counter()
    for a, b, c in corners:
        for edge in ((a, b), (b, c), (c, a)):
            ways[edge] += 1
    return sum(count > ways.get((b, a), 0) for (a, b), count in ways.items() if a != b)
