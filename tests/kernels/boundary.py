"""How many edges and shells patches have that share their exact boundaries."""

from net import affine, elevated
from patch import bits, owner


class Boundary:
    """The sides of some patches; equal curves are one edge, in either direction."""

    def __init__(self, nets, patches):
        self.sides, self.curves = [], set()
        for patch in patches:
            index, rectangle = owner(nets, patch)
            rows = nets.nets[index].patch(*rectangle, patch.degree)
            columns = list(zip(*rows))
            self.sides.append([rows[0], rows[-1], list(columns[0]), list(columns[-1])])
        degree = max(len(side) - 1 for own in self.sides for side in own)
        self.keys = [
            [key(elevated(side, degree)) for side in own if not is_point(side)] for own in self.sides
        ]

    def has(self, weights, points):
        """Whether doubles are those of a side, in either direction."""
        if not self.curves:
            sides = (side for own in self.sides for side in own if not is_point(side))
            both = (own for side in sides for own in (side, list(reversed(side))))
            self.curves = {str(bits(affine([own]))) for own in both}
        return str(bits(([weights], [points]))) in self.curves

    def collapsed(self):
        """The number of sides that are points."""
        return sum(is_point(side) for own in self.sides for side in own)

    def edges(self):
        """The number of different edges."""
        return len({side for own in self.keys for side in own})

    def edges_apart(self):
        """The number of edges if no two patches share one."""
        return sum(map(len, self.keys))

    def shells(self):
        """The number of shells. At an edge of three faces or more, every face is its own."""
        uses = [side for own in self.keys for side in own]
        groups = []
        for own in map(set, self.keys):
            joined = [group for group in groups if group & own]
            groups = [group for group in groups if not group & own]
            groups.append(own.union(*joined))
        total = 0
        for group in groups:
            faces = [own for own in self.keys if group.intersection(own)]
            crowded = any(uses.count(side) > 2 for side in group)
            total += len(faces) if crowded else 1
        return total


def is_point(side):
    """Whether all its points are one."""
    _, [points] = affine([side])
    return len(set(map(str, bits(points)))) == 1


def key(side):
    """The same for equal curves."""
    return min(str(bits(affine([own]))) for own in (side, list(reversed(side))))
