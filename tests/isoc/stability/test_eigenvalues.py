"""tools/isoc/base/eigenvalues.c against closed forms. The QR iteration is backward stable: what it finds are eigenvalues of a matrix that is
off by some n epsilon of the norm. Those of a normal matrix are then off by as much (Bauer and Fike 1960); the roots of a polynomial, from
its companion matrix, are those of one whose coefficients are off by some n epsilon of the square of the norm (Edelman and Murakami 1995)."""
import ctypes
import subprocess

import numpy as np
import pytest
from harness.plants import STRICT
from harness.project import ROOT

ULP, ROUNDINGS = np.finfo(float).eps, 10


@pytest.fixture(scope='module')
def found(tmp_path_factory):
    """found(matrix): its eigenvalues; None where isoc finds none."""
    path = tmp_path_factory.mktemp('eigenvalues') / 'library.so'
    subprocess.run(['gcc', '-std=c11', *STRICT, '-shared', '-fPIC', '-I', ROOT, ROOT / 'tools/isoc/base/eigenvalues.c',
                    ROOT / 'tools/isoc/base/arena.c', '-lm', '-o', path], check=True)
    library = ctypes.CDLL(str(path))
    library.arena_new.restype = ctypes.c_void_p
    library.eigenvalues.restype = ctypes.c_bool

    def call(matrix):
        a = np.ascontiguousarray(matrix, float)
        re, im = np.zeros(len(a)), np.zeros(len(a))
        memory = ctypes.c_void_p(library.arena_new())
        good = library.eigenvalues(memory, a.ctypes, ctypes.c_int(len(a)), re.ctypes, im.ctypes)
        library.arena_free(memory)
        return re + 1j * im if good else None

    return call


def distance(found, wanted):
    """The largest distance of an eigenvalue that was expected from the nearest one found, each taken once."""
    left, worst = list(found), 0.0
    for value in wanted:
        nearest = min(left, key=lambda other: abs(other - value))
        left.remove(nearest)
        worst = max(worst, abs(nearest - value))
    return worst


def companion(coefficients):
    """Of z^n + c[n-1] z^(n-1) + ... + c[0]."""
    n = len(coefficients)
    made = np.eye(n, k=-1)
    made[:, -1] = -np.asarray(coefficients)
    return made


@pytest.mark.parametrize('n', [1, 2, 3, 5, 10, 30, 60])
def test_eigenvalues_of_normal_matrices(found, seed, n):
    """Blocks of rotations times sizes and real numbers, turned at random."""
    draw = np.random.default_rng(seed * 1000 + n)
    for _ in range(40):
        a, wanted = np.zeros((n, n)), []
        k = 0
        while k < n:
            x, y = draw.uniform(-1, 1, 2)
            if k + 1 < n and draw.random() < 0.6:
                a[k:k + 2, k:k + 2] = [[x, -y], [y, x]]
                wanted += [complex(x, y), complex(x, -y)]
            else:
                a[k, k] = x
                wanted.append(x)
            k = len(wanted)
        q, _ = np.linalg.qr(draw.normal(size=(n, n)))
        assert distance(found(q @ a @ q.T), wanted) <= ROUNDINGS * n * ULP * 2**0.5


@pytest.mark.parametrize('n', [2, 4, 8, 16, 24])
def test_roots_of_polynomials(found, seed, n):
    """Each root leaves the polynomial nearly zero, over the square of the norm of its matrix and the sum of its terms."""
    draw = np.random.default_rng(seed * 1000 + n)
    for _ in range(40):
        c = draw.uniform(-1, 1, n) * 10.0**draw.uniform(-2, 2)
        z = found(companion(c))
        powers = z[:, None]**np.arange(n)
        value, size = (powers * c).sum(1) + z**n, np.abs(powers).sum(1) + np.abs(z)**n
        norm = np.linalg.norm(companion(c))
        assert (np.abs(value) <= ROUNDINGS * n * ULP * norm**2 * size).all()


@pytest.mark.parametrize('n', [2, 3, 8, 20])
def test_the_roots_of_one(found, n):
    z = found(companion([-1] + [0] * (n - 1)))
    wanted = np.exp(2j * np.pi * np.arange(n) / n)
    assert distance(z, wanted) <= ROUNDINGS * n * ULP
    wanted[0] += 2 * ROUNDINGS * n * ULP
    assert distance(z, wanted) > ROUNDINGS * n * ULP, 'found: another root'


def test_corners(found):
    assert np.abs(found([[0, 1], [0, 0]])).max() <= 2 * ULP**0.5, 'z^2 = 0'
    assert found([[np.nan, 0], [0, 1]]) is None, 'a matrix that is not finite has none'


def test_matrices_of_any_scale_end(found, seed):
    """Rows and columns of sizes from 1e-8 to 1e8, which are those of a matrix with the roots of another."""
    draw = np.random.default_rng(seed)
    n = 12
    for _ in range(40):
        a, scale = draw.uniform(-1, 1, (n, n)), 10.0**draw.uniform(-8, 8, n)
        wanted = np.linalg.eigvals(a)
        assert distance(found(a * scale[:, None] / scale), wanted) <= 1e4 * (ROUNDINGS * n * ULP)**0.5
