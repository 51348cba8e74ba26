"""Patches as a kernel has read them, held against the exact nets."""

from dataclasses import dataclass, field
from fractions import Fraction
from math import ulp
from typing import Callable

import net

# Shares of a patch whose parameters are doubles.
SHARES = [Fraction(own, 16) for own in (0, 1, 5, 8, 13, 16)]
# A patch ends at shares of the domain with denominators up to this one.
LARGEST_DENOMINATOR = 4096
# Coordinates of points may differ by so many units in the last place of their range: those of the
# numbers in a file, evaluated exactly, and what the arithmetic of a kernel adds. Some kernels lose
# a bit more at high degrees.
FILE_ULPS = 2
ULPS = 4
MORE_ULPS = 8
HIGH_DEGREE = 13


@dataclass
class Patch:
    """A surface as it was read."""

    degree: tuple
    domain: list
    """The first and the last knot along u, and along v."""
    weights: list | None = None
    points: list | None = None
    premultiplied: list | None = None
    """Either weights and points, or points (wx, wy, wz, w); nothing where a kernel hides them."""
    evaluate: Callable = None
    """The point at two parameters."""
    names: list = field(default_factory=list)
    loses_more: bool = False
    """Whether the kernel loses more at high degrees."""

    def allowed(self):
        """How far points may be off, in units of the last place."""
        high = self.loses_more and max(self.degree) >= HIGH_DEGREE
        return MORE_ULPS if high else ULPS


class Nets:
    """The exact nets of a file with what was computed of them."""

    def __init__(self, paths):
        self.nets = [net.Net(path) for path in paths]
        self.known = {}
        self.lost = {}

    def numbers(self, index, rectangle, degree, kind):
        """The doubles of a patch of one net."""
        key = (index, rectangle, degree, kind)
        if key not in self.known:
            self.known[key] = kind(self.nets[index].patch(*rectangle, degree))
        return self.known[key]

    def at(self, index, u, v):
        """The doubles of a point of one net."""
        key = (index, u, v)
        if key not in self.known:
            self.known[key] = self.nets[index].at(u, v)
        return self.known[key]

    def of_file(self, index, rectangle, patch):
        """How far the doubles of a patch are off at exact samples before a kernel computes, in
        units of the last place of the range."""
        products = patch.premultiplied is not None
        key = (index, rectangle, patch.degree, products)
        if key not in self.lost:
            if products:
                numbers = self.numbers(index, rectangle, patch.degree, net.premultiplied)
                points = [[list(map(Fraction, own[3:] + own[:3])) for own in row] for row in numbers]
            else:
                numbers = self.numbers(index, rectangle, patch.degree, net.affine)
                points = [list(map(homogeneous, *row)) for row in zip(*numbers)]
            self.lost[key] = max(
                abs(own - Fraction(exact)) / Fraction(self.unit(index))
                for u in SHARES
                for v in SHARES
                for own, exact in zip(value(points, u, v), self.at(index, *within(rectangle, u, v)))
            )
        return float(self.lost[key])

    def unit(self, index):
        """The unit in the last place of the range of the coordinates of one net."""
        if index not in self.known:
            self.known[index] = ulp(self.nets[index].range())
        return self.known[index]


def bits(numbers):
    """Numbers in nested lists, each with all its digits and the sign of a zero."""
    if isinstance(numbers, (list, tuple)):
        return [bits(own) for own in numbers]
    return float(numbers).hex()


def check(nets, patches):
    """Each patch is a part of a net, bit for bit, and all of them are all of the nets."""
    covered = [Fraction(0) for _ in nets.nets]
    largest = 0
    for patch in patches:
        index, rectangle = owner(nets, patch)
        (u0, u1), (v0, v1) = rectangle
        covered[index] += (u1 - u0) * (v1 - v0)
        lost = nets.of_file(index, rectangle, patch)
        assert lost <= FILE_ULPS, f"the file is off by {lost} units in the last place"
        worst = deviation(nets, index, rectangle, patch)
        assert worst <= patch.allowed(), f"a point is off by {worst} units in the last place"
        largest = max(largest, worst)
    assert covered == [1] * len(covered), f"the patches cover {covered} of the surfaces"
    return largest


def owner(nets, patch):
    """The net that a patch is a part of, and the part."""
    differences = []
    for index, own in enumerate(nets.nets):
        if any(one < other for one, other in zip(patch.degree, own.degree)):
            continue
        for rectangle in rectangles(own, patch):
            difference = changed(nets, index, rectangle, patch)
            if difference is None:
                return index, rectangle
            differences.append(difference)
    raise AssertionError(f"the patch is no part of a surface: {differences}")


def rectangles(own, patch):
    """What parts of the domain the knots of a patch may mean; knots from 0 to 1 may stand for all."""
    found = []
    for (start, end), knots in zip(own.domain, patch.domain):
        length = end.minus(start).rational()
        ends = []
        for knot in knots:
            share = (Fraction(knot) - start.rational()) / length
            ends.append(share.limit_denominator(LARGEST_DENOMINATOR))
        found.append(tuple(ends))
    inside = all(0 <= start < end <= 1 for start, end in found)
    whole = tuple((Fraction(0), Fraction(1)) for _ in found)
    return ([tuple(found)] if inside else []) + ([whole] if tuple(found) != whole else [])


def changed(nets, index, rectangle, patch):
    """What differs from the exact numbers, in words; none if nothing does."""
    if patch.premultiplied is not None:
        expected = nets.numbers(index, rectangle, patch.degree, net.premultiplied)
        return first_difference("point", patch.premultiplied, expected)
    if patch.points is None:
        worst = deviation(nets, index, rectangle, patch)
        return f"a point is off by {worst} units in the last place" if worst > patch.allowed() else None
    weights, points = nets.numbers(index, rectangle, patch.degree, net.affine)
    difference = first_difference("weight", patch.weights, weights)
    return difference or first_difference("point", patch.points, points)


def first_difference(what, read, expected):
    """The first row, column and numbers that differ, in words."""
    if (len(read), len(read[0])) != (len(expected), len(expected[0])):
        return f"{len(read)} by {len(read[0])} {what}s"
    for i, (row, other) in enumerate(zip(read, expected)):
        for j, (one, two) in enumerate(zip(row, other)):
            if bits(one) != bits(two):
                return f"{what} ({i}, {j}) is {one}, not {two}"
    return None


def within(rectangle, u, v):
    """The place of two shares of a rectangle."""
    return [start + share * (end - start) for share, (start, end) in zip((u, v), rectangle)]


def homogeneous(weight, point):
    """(w, wx, wy, wz), exactly."""
    weight = Fraction(weight)
    return [weight] + [weight * Fraction(own) for own in point]


def value(points, u, v):
    """The point of homogeneous points (W, X, Y, Z) at two shares."""
    shares = [net.bernstein(len(points) - 1, u), net.bernstein(len(points[0]) - 1, v)]
    total = [Fraction(0)] * 4
    for share, row in zip(shares[0], points):
        for other, point in zip(shares[1], row):
            total = [one + share * other * own for one, own in zip(total, point)]
    weight, *point = total
    return [own / weight for own in point]


def deviation(nets, index, rectangle, patch):
    """How far points at exact samples are off, in units of the last place of their range."""
    unit = nets.unit(index)
    worst = 0
    for u in SHARES:
        for v in SHARES:
            expected = nets.at(index, *within(rectangle, u, v))
            knots = [tuple(map(Fraction, own)) for own in patch.domain]
            at = [start + share * (end - start) for share, (start, end) in zip((u, v), knots)]
            read = patch.evaluate(*map(float, at))
            apart = max(abs(one - other) for one, other in zip(read, expected))
            worst = max(worst, apart / unit)
    return float(worst)
