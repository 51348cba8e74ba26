"""Exact numbers of the net files, and the doubles nearest to their quotients."""

from fractions import Fraction
from math import isqrt

# Binary digits behind the point in the first enclosure, and in the last one that is tried.
FIRST_PRECISION = 128
LAST_PRECISION = 1 << 16


class Field:
    """Q(r1)(r2)…: each generator is the positive root of a number of the field before it."""

    def __init__(self, definitions=()):
        self.places = {own["name"]: index for index, own in enumerate(definitions)}
        self.squares = []
        self.known = {}
        for own in definitions:
            self.squares.append(self.number(own["square"]))

    def number(self, text):
        """The number of a text such as `3/2 + 1/4*r1 - r1*r2`."""
        terms = {}
        for term in text.replace(" - ", " + -").split(" + "):
            sign, term = (-1, term[1:]) if term.startswith("-") else (1, term)
            factor, roots = Fraction(sign), 0
            for word in term.split("*"):
                if word in self.places:
                    roots |= 1 << self.places[word]
                else:
                    factor *= Fraction(word)
            terms[roots] = terms.get(roots, 0) + factor
        return Number(self, terms)

    def whole(self, value):
        """A rational number as one of the field."""
        return Number(self, {0: Fraction(value)})

    def roots(self, precision):
        """Enclosures of the generators, in steps of 2^-precision."""
        if precision not in self.known:
            found = []
            for square in self.squares:
                low, high = square.enclosure(precision, found)
                assert low > 0, "a generator is the root of a positive number"
                found.append((isqrt(low << precision), isqrt(high << precision) + 1))
            self.known[precision] = found
        return self.known[precision]


class Number:
    """Σ of rational multiples of products of different generators, each product a set of bits."""

    def __init__(self, field, terms):
        self.field = field
        self.terms = {roots: factor for roots, factor in terms.items() if factor}

    def plus(self, other):
        terms = dict(self.terms)
        for roots, factor in other.terms.items():
            terms[roots] = terms.get(roots, 0) + factor
        return Number(self.field, terms)

    def scaled(self, factor):
        return Number(self.field, {roots: own * factor for roots, own in self.terms.items()})

    def minus(self, other):
        return self.plus(other.scaled(-1))

    def times(self, other):
        result = Number(self.field, {})
        for left, factor in self.terms.items():
            for right, own in other.terms.items():
                product = Number(self.field, {left ^ right: factor * own})
                for index, square in enumerate(self.field.squares):
                    if left & right & (1 << index):
                        product = product.times(square)
                result = result.plus(product)
        return result

    def is_zero(self):
        """Whether it is 0: products of generators are independent over the rationals."""
        return not self.terms

    def rational(self):
        """Itself as a fraction; none if it is irrational."""
        if set(self.terms) <= {0}:
            return self.terms.get(0, Fraction(0))
        return None

    def enclosure(self, precision, roots=None):
        """Two integers with the number between them, in steps of 2^-precision."""
        roots = self.field.roots(precision) if roots is None else roots
        total_low = total_high = 0
        for own, factor in self.terms.items():
            low = high = 1 << precision
            for index, (root_low, root_high) in enumerate(roots):
                if own & (1 << index):
                    low = low * root_low >> precision
                    high = -(-high * root_high >> precision)
            low, high = low * factor.numerator, high * factor.numerator
            if factor < 0:
                low, high = high, low
            total_low += low // factor.denominator
            total_high += -(-high // factor.denominator)
        return total_low, total_high

    def sign(self):
        """-1, 0 or 1."""
        if self.is_zero():
            return 0
        precision = FIRST_PRECISION
        while precision <= LAST_PRECISION:
            low, high = self.enclosure(precision)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            precision *= 2
        raise ArithmeticError("no enclosure shows the sign")

    def double(self):
        """The double nearest to it."""
        return quotient(self, self.field.whole(1))


def quotient(above, below):
    """The double nearest to a quotient, ties to even; 0 is never negative."""
    if above.is_zero():
        return 0.0
    one, other = above.rational(), below.rational()
    if one is not None and other is not None:
        return float(one / other) + 0.0
    precision = FIRST_PRECISION
    while precision <= LAST_PRECISION:
        ends, divisors = above.enclosure(precision), below.enclosure(precision)
        if divisors[0] > 0 or divisors[1] < 0:
            values = [Fraction(end, divisor) for end in ends for divisor in divisors]
            low, high = float(min(values)), float(max(values))
            if low == high:
                return low + 0.0
        precision *= 2
    raise ArithmeticError("no enclosure shows the double")
