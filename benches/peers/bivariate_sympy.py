"""sympy, in its ring of polynomials in u and v, which is far faster than its expressions.

W = D σ, X = D x σ + X h Q, …, with σ = h N; see `separable_flint` for the letters.
"""

from math import comb

from sympy import QQ, ZZ, ring

from separable_flint import read as parsed, rounded

RATIONAL, U, V = ring("u,v", QQ)
INTEGRAL = RATIONAL.clone(domain=ZZ)


def read(record):
    return parsed(record, QQ)


def in_u(values):
    return RATIONAL.from_dict({(i, 0): own for i, own in enumerate(values) if own})


def in_v(values):
    return RATIONAL.from_dict({(0, j): own for j, own in enumerate(values) if own})


def from_bernstein(values):
    n = len(values) - 1
    differences, power = list(values), []
    for i in range(n + 1):
        power.append(differences[0] * comb(n, i))
        differences = [b - a for a, b in zip(differences, differences[1:])]
    return in_v(power)


def integral(polynomial):
    return RATIONAL.from_dict({(0, j + 1): own / (j + 1) for (_, j), own in polynomial.terms()})


def constructed(data):
    """W, X, Y, Z"""
    px, pz, d = map(in_u, data["profile"])
    a, b = from_bernstein(data["re"]), from_bernstein(data["im"])
    h = in_v(data["h"] or [QQ(1)])
    p, q, n = h * (a**2 - b**2), h * (2 * a * b), h * (a**2 + b**2)
    x, y = integral(p) + data["start"][0], integral(q) + data["start"][1]
    s = integral(n)
    kind = data["kind"]
    if kind == "offset":
        ax, ay = x * n + data["d"] * q, y * n - data["d"] * p
        return d * n, d * ax + px * n, d * ay, pz * n
    if kind == "involute":
        ax, ay = x * n - s * p, y * n - s * q
        return d * n, d * ax + px * p, d * ay + px * q, pz * n
    # c + f ((X/D) n + (Z/D) k), f = top / bottom
    top, bottom = RATIONAL.one, RATIONAL.one
    if kind == "conical":
        top = s * (1 / sum(own for _, own in s.terms()))
    if kind == "conical_inv":
        top, bottom = RATIONAL(data["c"]), s + data["c"]
    w = n * bottom
    return d * w, d * x * w + px * (top * q), d * y * w - px * (top * p), pz * (top * n)


def scaled_bernstein(rows, n):
    """Rows of power coefficients aᵢ to rows of Σ C(n−i, j−i) aᵢ."""
    table = [[comb(n - i, j - i) for j in range(i, n + 1)] for i in range(n + 1)]
    converted = []
    for row in rows:
        own = [0] * (n + 1)
        for i, coefficient in enumerate(row):
            if coefficient:
                for j, binomial in enumerate(table[i], i):
                    own[j] += coefficient * binomial
        converted.append(own)
    return converted


def compile(data):
    coordinates = constructed(data)
    common = ZZ(1)
    for own in coordinates:
        for coefficient in own.itercoeffs():
            common = ZZ.lcm(common, coefficient.denominator)
    coordinates = [(own * common).set_ring(INTEGRAL) for own in coordinates]
    divisor = coordinates[0]
    for own in coordinates[1:]:
        if own:
            divisor = divisor.gcd(own)
    if not divisor.is_ground:
        coordinates = [own.exquo(divisor) for own in coordinates]
    degrees = [own.degrees() for own in coordinates if own]
    du, dv = max(own[0] for own in degrees), max(own[1] for own in degrees)
    nets = []
    for own in coordinates:
        rows = [[0] * (dv + 1) for _ in range(du + 1)]
        for (i, j), coefficient in own.terms():
            rows[i][j] = int(coefficient)
        along_u = zip(*scaled_bernstein(rows, dv))
        net = zip(*scaled_bernstein(along_u, du))
        nets.append([entry for row in net for entry in row])
    return (du, dv), rounded(du, dv, *nets)
