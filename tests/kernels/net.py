"""The exact net of a `.json` file: any patch of it, in any degree, at any point."""

import json
from fractions import Fraction
from math import comb

from exact import Field, quotient


class Net:
    """One Bézier patch over its domain, as homogeneous points (W, X, Y, Z)."""

    def __init__(self, path):
        self.file = json.loads(path.read_text(encoding="utf-8"))
        assert self.file["format"] == "sweepc-net/1"
        self.name = self.file["name"]
        self.field = Field(self.file["field"])
        number = self.field.number
        self.degree = tuple(self.file["degree"])
        self.domain = []
        for along, degree in zip("uv", self.degree):
            knots = [number(own) for own in self.file["knots"][along]]
            assert len(knots) == 2 * degree + 2, "one span"
            self.domain.append((knots[0], knots[-1]))
        self.points = []
        for weights, points in zip(self.file["weights"], self.file["points"]):
            row = []
            for weight, point in zip(map(number, weights), points):
                scale = self.field.whole(1) if weight.is_zero() else weight
                row.append([weight] + [scale.times(number(own)) for own in point])
            self.points.append(row)

    def patch(self, u=(0, 1), v=(0, 1), degree=None):
        """The points over a rectangle of the domain, counted from 0 to 1, in a degree."""
        degree = degree or self.degree
        columns = [elevated(restricted(row, v), degree[1]) for row in self.points]
        rows = [elevated(restricted(list(row), u), degree[0]) for row in zip(*columns)]
        return [list(row) for row in zip(*rows)]

    def at(self, u, v):
        """The doubles nearest to the point at parameters that are counted from 0 to 1."""
        total = [self.field.whole(0) for _ in range(4)]
        for share, row in zip(bernstein(self.degree[0], u), self.points):
            for other, point in zip(bernstein(self.degree[1], v), row):
                if share * other:
                    total = [one.plus(own.scaled(share * other)) for one, own in zip(total, point)]
        weight, *point = total
        return [quotient(own, weight) for own in point]

    def range(self):
        """What the coordinates of the control points range over: the largest difference of two
        along an axis, or a coordinate itself where the net is far from the origin."""
        points = (own for row in self.points for own in row if not own[0].is_zero())
        points = [[quotient(own, weight) for own in point] for weight, *point in points]
        widths = [max(axis) - min(axis) for axis in zip(*points)]
        return max(widths + [abs(own) for point in points for own in point])


def affine(points):
    """The doubles that say (x, y, z) and the weights, the first of which is 1."""
    corner = points[0][0][0]
    weights = [[quotient(own[0], corner) for own in row] for row in points]
    places = [[[quotient(own, weight) for own in point] for weight, *point in row] for row in points]
    return weights, places


def premultiplied(points):
    """The doubles that say (wx, wy, wz, w), where the first weight is 1."""
    corner = points[0][0][0]
    order = (1, 2, 3, 0)
    return [[[quotient(own[axis], corner) for axis in order] for own in row] for row in points]


def combined(one, other, share):
    """(1 - share) one + share other"""
    return [left.scaled(1 - share).plus(right.scaled(share)) for left, right in zip(one, other)]


def bernstein(degree, share):
    """The values of the Bernstein polynomials at a share of the range."""
    share = Fraction(share)
    rest = 1 - share
    return [comb(degree, own) * share**own * rest ** (degree - own) for own in range(degree + 1)]


def restricted(points, ends):
    """The points over a part of the range, by blossoms."""
    start, end = map(Fraction, ends)
    if (start, end) == (0, 1):
        return points
    degree = len(points) - 1
    found = []
    for index in range(degree + 1):
        own = points
        for step in range(degree):
            share = end if step < index else start
            own = [combined(one, other, share) for one, other in zip(own, own[1:])]
        found.append(own[0])
    return found


def elevated(points, degree):
    """The points in a degree that is at least their own."""
    own = len(points) - 1
    gain = degree - own
    assert gain >= 0, "no degree falls"
    if gain == 0:
        return points
    found = []
    for index in range(degree + 1):
        total = [number.scaled(0) for number in points[0]]
        for place in range(max(0, index - gain), min(own, index) + 1):
            share = Fraction(comb(own, place) * comb(gain, index - place), comb(degree, index))
            total = [sum_.plus(number.scaled(share)) for sum_, number in zip(total, points[place])]
        found.append(total)
    return found
