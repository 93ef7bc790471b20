"""Masses of meshes in MJCF: of shapes whose volume and inertia are known, in each format; what is said of meshes that are
not closed, not convex or cannot be read; and no file of a mesh ends the program."""
import random
import re

import numpy as np
import pytest

import odd
from write_robots import load_import

PROGRAM = load_import()
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def prism(outline, height):
    """Points and faces of an upright prism, whose outline is a polygon seen from above, against the clock."""
    n = len(outline)
    points = [(x, y, 0.0) for x, y in outline] + [(x, y, height) for x, y in outline]
    return points, [(k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n)]


# An L of 3 x 3 less 2 x 2, high 1: its floor and roof are three squares and more, cut so that edges meet.
L_POINTS, L_SIDES = prism([(0, 0), (1, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3), (0, 1)], 1.0)
L_FLOOR = [(7, 4, 1, 0), (4, 3, 2, 1), (6, 5, 4, 7)]
L_SHAPE = L_POINTS, L_SIDES + L_FLOOR + [tuple(8 + k for k in reversed(face)) for face in L_FLOOR]


def boxes(*parts):
    """Mass, centre and tensor of boxes of density 1: (sizes, centre of each)."""
    mass = sum(np.prod(size) for size, _ in parts)
    centre = sum(np.prod(size) * np.array(at) for size, at in parts) / mass
    tensor = np.zeros((3, 3))
    for size, at in parts:
        own, away = np.prod(size), np.array(at) - centre
        square = np.diag(np.array(size) ** 2) / 12 + np.outer(away, away)
        tensor += own * (np.trace(square) * np.eye(3) - square)
    return mass, centre, tensor


def taken(folder, mesh, geom='', compiler='', density=1.0):
    """Mass, centre and tensor of a body with this mesh, and what is said."""
    path = folder / 'robot.xml'
    path.write_text(f'<mujoco><compiler angle="radian" {compiler}/><asset><mesh name="m" {mesh}/></asset><worldbody><body name="b">'
                    f'<freejoint/><geom type="mesh" mesh="m" density="{density}" {geom}/></body></worldbody></mujoco>')
    text, said = PROGRAM.imported(str(path), PROGRAM.parser().parse_args([str(path)]))
    said = '\n'.join(said)
    if text is None:
        return None, said
    assert 'rotate' not in text
    mass = float(re.search(r'mass (\S+) kg', text)[1])
    found = re.search(r'com \((.*)\) m', text)
    centre = np.array([float(x) for x in found[1].split(',')]) if found else np.zeros(3)
    xx, yy, zz, xy, xz, yz = ([float(x) for x in re.split('[,;]', re.search(r'inertia \((.*)\) kg', text)[1])] + [0.0] * 3)[:6]
    return (mass, centre, np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])), said


def assert_same(found, right, tolerance=1e-12):
    for one, other in zip(found, right):
        assert np.abs(np.asarray(one) - other).max() <= tolerance * max(np.abs(other).max(), 1)


@pytest.mark.parametrize('ending', ['stl', 'text.stl', 'obj'])
def test_a_box_in_each_format(tmp_path, ending):
    points, faces, *_ = odd.cube()
    points = [(0.5 * x + 1, 0.25 * y, z - 2) for x, y, z in points]
    odd.write_mesh(str(tmp_path / f'box.{ending}'), points, faces)
    right = boxes(((1.0, 0.5, 2.0), (1.0, 0.0, -2.0)))
    found, said = taken(tmp_path, f'file="box.{ending}"')
    assert_same(found, right)
    assert 'the mesh m has a volume of 1 m^3, of which masses follow' in said
    # Of a geom with a mass, of a scale that turns it inside out, and of one that is inside out in its file.
    found, _ = taken(tmp_path, f'file="box.{ending}"', 'mass="3"')
    assert_same(found, (3.0, right[1], 3.0 * right[2]))
    found, _ = taken(tmp_path, f'file="box.{ending}" scale="-2 1 1"')
    assert_same(found, boxes(((2.0, 0.5, 2.0), (-2.0, 0.0, -2.0))))
    odd.write_mesh(str(tmp_path / f'box.{ending}'), points, [face[::-1] for face in faces])
    assert_same(taken(tmp_path, f'file="box.{ending}"')[0], right)


def test_vertices_in_the_file(tmp_path):
    points, faces, *_ = odd.cube()
    fans = [(face[0], face[k], face[k + 1]) for face in faces for k in (1, 2)]
    vertex, face = (' '.join(str(x) for row in rows for x in row) for rows in (points, fans))
    assert_same(taken(tmp_path, f'vertex="{vertex}" face="{face}" refpos="1 0 0"')[0], boxes(((2, 2, 2), (-1, 0, 0))))
    found, said = taken(tmp_path, f'vertex="{vertex}"')
    assert found is None and 'a mesh without faces, as a hull of points, is not taken' in said
    for words, why in ((f'vertex="{vertex} 1" face="{face}"', 'each vertex and each face is three numbers'),
                       (f'vertex="{vertex}" face="{face} 0 1"', 'each vertex and each face is three numbers'),
                       (f'vertex="{vertex}" face="{face} 0 1 8"', 'a face has a vertex that is not there'),
                       (f'vertex="{vertex}" face="{face} 0 1 1.5"', 'a face has a vertex that is not there')):
        found, said = taken(tmp_path, words)
        assert found is None and why in said


def test_an_obj_of_polygons_with_numbers_from_the_end(tmp_path):
    lines = [f'v {x} {y} {z}' for x, y, z in odd.cube()[0]] + ['f ' + ' '.join(f'{k - 8}/1/1' for k in face) for face in FACES]
    (tmp_path / 'box.obj').write_text('\n'.join(lines))
    assert_same(taken(tmp_path, 'file="box.obj"')[0], boxes(((2, 2, 2), (0, 0, 0))))


@pytest.mark.parametrize('words, exact', [('', False), ('inertia="exact"', True), ('inertia="convex"', False)])
def test_one_that_is_not_convex(tmp_path, words, exact):
    odd.write_mesh(str(tmp_path / 'l.stl'), *L_SHAPE)
    found, said = taken(tmp_path, f'file="l.stl" {words}')
    assert_same(found, boxes(((1, 3, 1), (0.5, 1.5, 0.5)), ((2, 1, 1), (2, 0.5, 0.5))))
    assert ('the mesh m is not convex: its own volume counts, where MuJoCo counts' in said) == (not exact)
    assert 'not closed' not in said


def test_a_shell(tmp_path):
    """A cube of six squares: each has a twelfth of its mass times the square of its side, and its distance."""
    points, faces, *_ = odd.cube()
    odd.write_mesh(str(tmp_path / 'box.stl'), points, faces)
    right = (24.0, np.zeros(3), 24.0 * 2 * (2 / 3 * 1 / 3 + 1 / 3) * np.eye(3))
    for found, said in (taken(tmp_path, 'file="box.stl"', 'shellinertia="true"'), taken(tmp_path, 'file="box.stl" inertia="shell"')):
        assert_same(found, right)
        assert 'an area of 24 m^2' in said


def test_one_that_is_open_is_closed_from_its_middle(tmp_path):
    points, faces, *_ = odd.cube()
    odd.write_mesh(str(tmp_path / 'box.stl'), points, faces[1:])
    found, said = taken(tmp_path, 'file="box.stl"')
    middle = 1 / 5  # of the five squares along x, to which the sixth is 1 + 1/5 away: its pyramid is missing
    assert abs(found[0] - (8 - 4 * (1 + middle) / 3)) < 1e-12
    assert '- warning: the mesh m is not closed: 4 edges have no neighbour' in said


@pytest.mark.parametrize('file, data, why', [
    ('none.stl', None, "none.stl' cannot be read: No such file or directory"),
    ('m.dae', b'', 'a mesh in .dae is not read, .stl and .obj are'),
    ('m.stl', b'', "m.stl' is no STL: neither the text nor the length of a binary file"),
    ('m.stl', b'x' * 80 + b'\x02\0\0\0' + b'x' * 50, "m.stl' is no STL: neither the text nor the length"),
    ('m.stl', b'solid'.ljust(80) + b'\x02\0\0\0' + b'\0' * 50, "m.stl' is no STL: neither the text nor the length"),
    ('m.stl', b'solid x vertex 1 2 3 endsolid', "m.stl' is no STL: its vertices are no triangles"),
    ('m.stl', b'solid x' + b' vertex 1 2 z' * 3, "m.stl' is no STL: could not convert string to float"),
    ('m.obj', b'v 1 2 3\nf 1 2 3', "m.obj' is no OBJ: a face has a vertex that is not there: f 1 2 3"),
    ('m.obj', b'v 1 2 3', "m.obj' is no OBJ: it has no face"),
    ('m.obj', b'v 1 2 nan\nv 1 0 0\nv 0 0 0\nf 1 2 3', "m.obj' is no OBJ: a corner is not three finite numbers"),
    ('m.obj', b'v 1 2 3\nv 1 0 0\nv 0 0 0\nf 1 2 3', "the mesh 'm' has no volume"),
])
def test_what_cannot_be_read_is_said(tmp_path, file, data, why):
    if data is not None:
        (tmp_path / file).write_bytes(data)
    found, said = taken(tmp_path, f'file="{file}"')
    assert found is None and why in said and "the body 'b' loses the mass of this mesh" in said
    assert 'nothing moves in this file: the masses are those of meshes that are not taken' in said


def test_folders_of_meshes(tmp_path):
    (tmp_path / 'parts').mkdir()
    odd.write_mesh(str(tmp_path / 'parts' / 'box.stl'), *odd.cube()[:2])
    right = boxes(((2, 2, 2), (0, 0, 0)))
    assert_same(taken(tmp_path, 'file="box.stl"', compiler='meshdir="parts"')[0], right)
    assert_same(taken(tmp_path, 'file="box.stl"', compiler='assetdir="parts"')[0], right)
    assert_same(taken(tmp_path, 'file="/away/box.stl"', compiler='meshdir="parts" strippath="true"')[0], right)


@pytest.mark.seeds(5)
def test_no_file_of_a_mesh_ends_the_program(tmp_path, seed):
    r = random.Random(seed)
    for ending in ('stl', 'text.stl', 'obj'):
        path = tmp_path / f'm.{ending}'
        odd.write_mesh(str(path), *r.choice([odd.cube, odd.octahedron])()[:2])
        sound = path.read_bytes()
        for _ in range(40):
            data = bytearray(sound)
            for _ in range(r.randrange(1, 6)):
                data[r.randrange(len(data))] = r.choice(b'0 9-.ef/\n\xff')
            path.write_bytes(data[: r.choice([len(data), r.randrange(len(data))])])
            taken_or_said = taken(tmp_path, f'file="{path.name}"')
            assert taken_or_said[1]
