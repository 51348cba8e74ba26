"""python-flint, without the structure: polynomials in u and v, their gcd, exact division.

W = D σ, X = D x σ + X h Q, …, with σ = h N; see `separable_flint` for the letters.
"""

from functools import cache
from math import comb

from flint import Ordering, fmpq, fmpq_poly, fmpz_mat, fmpz_mpoly_ctx

from separable_flint import from_bernstein, over_common_denominator, read, rounded

RING = fmpz_mpoly_ctx.get(("u", "v"), Ordering.lex)


def in_u(polynomial):
    coefficients = enumerate(polynomial.coeffs())
    return RING.from_dict({(i, 0): own for i, own in coefficients if own})


def in_v(polynomial):
    coefficients = enumerate(polynomial.coeffs())
    return RING.from_dict({(0, j): own for j, own in coefficients if own})


def constructed(data):
    """W, X, Y, Z"""
    px, pz, d = map(in_u, over_common_denominator([fmpq_poly(own) for own in data["profile"]]))
    a, b = from_bernstein(data["re"]), from_bernstein(data["im"])
    h = fmpq_poly(data["h"] or [1])
    p, q, n = h * (a * a - b * b), h * (2 * a * b), h * (a * a + b * b)
    x, y = p.integral() + data["start"][0], q.integral() + data["start"][1]
    s = n.integral()
    kind = data["kind"]
    if kind == "offset":
        parts = [n, x * n + data["d"] * q, y * n - data["d"] * p]
        n, ax, ay = map(in_v, over_common_denominator(parts))
        return d * n, d * ax + px * n, d * ay, pz * n
    if kind == "involute":
        parts = [n, x * n - s * p, y * n - s * q, p, q]
        n, ax, ay, p, q = map(in_v, over_common_denominator(parts))
        return d * n, d * ax + px * p, d * ay + px * q, pz * n
    # c + f ((X/D) n + (Z/D) k), f = top / bottom
    top, bottom = fmpq_poly([1]), fmpq_poly([1])
    if kind == "conical":
        top, bottom = s, fmpq_poly([s(fmpq(1))])
    if kind == "conical_inv":
        top, bottom = fmpq_poly([data["c"]]), s + data["c"]
    w = n * bottom
    w, ax, ay, bx, by, c = map(
        in_v, over_common_denominator([w, x * w, y * w, top * q, -top * p, top * n])
    )
    return d * w, d * ax + px * bx, d * ay + px * by, pz * c


@cache
def conversion(n):
    """From power coefficients aᵢ to scaled Bernstein coefficients: Σ C(n−i, j−i) aᵢ."""
    return fmpz_mat([[comb(n - i, j - i) if j >= i else 0 for i in range(n + 1)] for j in range(n + 1)])


def compile(data):
    coordinates = constructed(data)
    common = coordinates[0]
    for own in coordinates[1:]:
        if own:
            common = common.gcd(own)
    if not common.is_constant():
        coordinates = [own // common for own in coordinates]
    degrees = [own.degrees() for own in coordinates if own]
    du, dv = (int(max(own[k] for own in degrees)) for k in (0, 1))
    rows, columns = conversion(du), conversion(dv).transpose()
    nets = []
    for own in coordinates:
        entries = [0] * ((du + 1) * (dv + 1))
        for (i, j), coefficient in zip(own.monoms(), own.coeffs()):
            entries[i * (dv + 1) + j] = coefficient
        net = rows * fmpz_mat(du + 1, dv + 1, entries) * columns
        nets.append(list(map(int, net.entries())))
    return (du, dv), rounded(du, dv, *nets)
