"""python-flint, by the structure: polynomials in one variable, W = α(v) β(u).

With w = a + ib let P = a² − b², Q = 2ab, N = a² + b²; the hodograph is h (P, Q), n = (Q, −P)/N,
t = (P, Q)/N. The factor h is never multiplied into a denominator. Each coordinate is
β(u) A(v) + X(u) B(v), or Z(u) C(v).
"""

from math import comb

from flint import fmpq, fmpq_poly, fmpz_mat, fmpz_poly

ONE_AND_T = fmpz_poly([1, 1])


def read(record, rational=fmpq):
    """The numbers of a record, as those of a library."""

    def numbers(own):
        return [rational(*map(int, number.split("/"))) for number in own]

    return {
        "kind": record["kind"],
        "re": numbers(pair[0] for pair in record["w"]),
        "im": numbers(pair[1] for pair in record["w"]),
        "h": numbers(record["h"]),
        "start": numbers(record["s0"]),
        "profile": [numbers(record["profile"][name]) for name in "XZD"],
        "d": numbers([record["d"]])[0],
        "c": numbers([record["c"]])[0],
    }


def from_bernstein(values):
    """Σ bᵢ C(n,i) vⁱ (1−v)ⁿ⁻ⁱ"""
    n = len(values) - 1
    differences, power, binomial = list(values), [], 1
    for i in range(n + 1):
        power.append(differences[0] * binomial)
        differences = [b - a for a, b in zip(differences, differences[1:])]
        binomial = binomial * (n - i) // (i + 1)
    return fmpq_poly(power)


def over_common_denominator(polynomials):
    """Integer polynomials in the same proportion."""
    common = 1
    for own in polynomials:
        denominator = own.denom()
        common = common * denominator // denominator.gcd(common) if common != 1 else denominator
    return [own.numer() * (common // own.denom()) for own in polynomials]


def formula(data):
    """α, (A, B) of x and of y, C, all in v, over β, X, Z in u."""
    a, b = from_bernstein(data["re"]), from_bernstein(data["im"])
    aa, bb, ab = a * a, b * b, a * b
    p, q, n = aa - bb, ab + ab, aa + bb
    h = data["h"]
    h = fmpq_poly(h) if h else None
    x, y = (p.integral(), q.integral()) if h is None else ((h * p).integral(), (h * q).integral())
    x, y = x + data["start"][0], y + data["start"][1]
    kind = data["kind"]
    if kind == "oriented":
        return n, (x * n, q), (y * n, -p), n
    if kind == "offset":
        d = data["d"]
        # here X(u) stands only in the first coordinate
        return n, (x * n + d * q, n), (y * n - d * p, fmpq_poly()), n
    s = (n if h is None else h * n).integral()
    if kind == "conical":
        s = s / s(fmpq(1))
        return n, (x * n, s * q), (y * n, -(s * p)), s * n
    if kind == "conical_inv":
        c = data["c"]
        s = s + c
        alpha = n * s
        return alpha, (x * alpha, c * q), (y * alpha, -(c * p)), c * n
    return n, (x * n - s * p, p), (y * n - s * q, q), n


def gcd(first, others):
    for own in others:
        if first.degree() == 0:
            break
        first = first.gcd(own)
    return first


def dependence(beta, x):
    """λ with X = λ β, if there is one."""
    if x.degree() != beta.degree():
        return None
    return (x.leading_coefficient(), beta.leading_coefficient()) if (
        x * beta.leading_coefficient() == beta * x.leading_coefficient()
    ) else None


def reduced(data):
    x, z, beta = over_common_denominator([fmpq_poly(own) for own in data["profile"]])
    alpha, (ax, bx), (ay, by), c = formula(data)
    alpha, ax, bx, ay, by, c = over_common_denominator([alpha, ax, bx, ay, by, c])
    common_u = gcd(beta, [x, z])
    if common_u.degree() > 0:
        x, z, beta = x // common_u, z // common_u, beta // common_u
    ratio = dependence(beta, x)
    if ratio:
        # X = λ β: the coordinates are products
        top, bottom = ratio
        ax, ay = ax * bottom + bx * top, ay * bottom + by * top
        alpha, c, bx, by, x = alpha * bottom, c * bottom, bx * 0, by * 0, x * 0
    parts = [ax, ay] + ([bx, by] if x else []) + ([c] if z else [])
    common_v = gcd(alpha, parts)
    if common_v.degree() > 0:
        alpha, ax, bx, ay, by, c = (own // common_v for own in (alpha, ax, bx, ay, by, c))
    return (beta, x, z), (alpha, ax, bx, ay, by, c)


def scaled_bernstein(polynomial, n):
    """C(n,j) bⱼ: the coefficients of tⁿ⁻ʲ in q(1 + t), where q(y) = yⁿ p(1/y)."""
    coefficients = polynomial.coeffs()
    reverse = fmpz_poly([0] * (n + 1 - len(coefficients)) + coefficients[::-1])
    shifted = reverse(ONE_AND_T).coeffs()
    return ([0] * (n + 1 - len(shifted))) + shifted[::-1]


def compile(data):
    (beta, x, z), (alpha, ax, bx, ay, by, c) = reduced(data)
    du = max(beta.degree(), x.degree(), z.degree())
    dv = max(alpha.degree(), ax.degree(), ay.degree())
    dv = max([dv] + ([bx.degree(), by.degree()] if x else []) + ([c.degree()] if z else []))
    beta, x, z = (scaled_bernstein(own, du) for own in (beta, x, z))
    alpha, ax, bx, ay, by, c = (scaled_bernstein(own, dv) for own in (alpha, ax, bx, ay, by, c))
    rows, columns = du + 1, dv + 1
    single, double = fmpz_mat(rows, 1, beta), fmpz_mat(rows, 2, [own for pair in zip(beta, x) for own in pair])
    w = (single * fmpz_mat(1, columns, alpha)).entries()
    xs = (double * fmpz_mat(2, columns, ax + bx)).entries()
    ys = (double * fmpz_mat(2, columns, ay + by)).entries()
    zs = (fmpz_mat(rows, 1, z) * fmpz_mat(1, columns, c)).entries()
    return (du, dv), rounded(du, dv, *(list(map(int, own)) for own in (w, xs, ys, zs)))


def rounded(du, dv, ws, xs, ys, zs):
    """The doubles; the quotient of two Python integers is the nearest one."""
    first = ws[0]
    along_v = [comb(dv, j) * first for j in range(dv + 1)]
    points, at = [], 0
    for i in range(du + 1):
        own = comb(du, i)
        for unit in along_v:
            unit, w = own * unit, ws[at]
            below = w or unit
            points.append((xs[at] / below + 0.0, ys[at] / below + 0.0, zs[at] / below + 0.0, w / unit + 0.0))
            at += 1
    return points
