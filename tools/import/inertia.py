"""Tensors of inertia: (xx, yy, zz, xy, xz, yz) about a centre of mass; those that no body has, and the nearest that one has."""
import itertools
import math

from place import UNTURNED, add, cross, dot, minus, norm, product, scale, transpose

ROUNDING = 1e-10  # of a written tensor, relative to the sum of its moments


def tensor(values):
    """The matrix of (xx, yy, zz, xy, xz, yz)."""
    xx, yy, zz, xy, xz, yz = values
    return ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))


def rotated(turn, values):
    """The matrix in axes in which those of the values are turned."""
    return product(product(turn, tensor(values)), transpose(turn))


def principal(values):
    """The principal moments, and the turn of their axes: Jacobi's rotations."""
    a = [list(row) for row in tensor(values)]
    axes = [list(row) for row in UNTURNED]
    for _ in range(60):
        p, q = max(((0, 1), (0, 2), (1, 2)), key=lambda at: abs(a[at[0]][at[1]]))
        if abs(a[p][q]) <= 1e-18 * (abs(a[0][0]) + abs(a[1][1]) + abs(a[2][2])):
            break
        angle = 0.5 * math.atan2(2 * a[p][q], a[q][q] - a[p][p])
        s, c = math.sin(angle), math.cos(angle)
        for row in a + axes:
            row[p], row[q] = c * row[p] - s * row[q], s * row[p] + c * row[q]
        for k in range(3):
            a[p][k], a[q][k] = c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]
    turn = tuple(tuple(row) for row in axes)
    if dot(cross(*transpose(turn)[:2]), transpose(turn)[2]) < 0:
        turn = tuple((row[0], row[1], -row[2]) for row in turn)
    return (a[0][0], a[1][1], a[2][2]), turn


def is_negative(values):
    """Whether a principal moment is below zero."""
    moments = principal(values)[0]
    return min(moments) < -ROUNDING * sum(map(abs, moments))


def excess(values):
    """By how much of their sum the largest principal moment is larger than the others; 0 where a body has such a tensor."""
    a, b, c = sorted(principal(values)[0])
    if c <= a + b + ROUNDING * (a + b + c):
        return 0.0
    return c / (a + b) - 1 if a + b > 0 else math.inf


def possible_moments(moments):
    """The nearest principal moments of a body, by the sum of the squares of the changes. Moments are sums of two of three
    second moments of mass, which are not below zero: so they are a cone of three edges, and the nearest point lies on the
    span of some of these."""
    edges = ((0.0, 1.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 0.0))
    found = (0.0, 0.0, 0.0)
    for count in (1, 2, 3):
        for some in itertools.combinations(edges, count):
            shares = shares_of(some, moments)
            point = (0.0, 0.0, 0.0)
            for share, edge in zip(shares, some):
                point = add(point, scale(share, edge))
            if min(shares) >= 0 and norm(minus(point, moments)) < norm(minus(found, moments)):
                found = point
    return found


def shares_of(edges, point):
    """The factors with which the sum of n of these edges is nearest to a point. The product of two edges is 1, and 2 of one
    with itself: so the normal equations are x_i + sum of x = edge_i . point."""
    along = [dot(edge, point) for edge in edges]
    common = sum(along) / (1 + len(edges))
    return [x - common for x in along]


def nearest_possible(values):
    """The nearest tensor that a body has: in Frobenius' norm, which is that of the moments about the same principal axes."""
    moments, turn = principal(values)
    diagonal = (*possible_moments(moments), 0.0, 0.0, 0.0)
    m = rotated(turn, diagonal)
    return (m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2])
