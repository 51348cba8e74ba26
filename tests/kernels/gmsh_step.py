"""STEP as Gmsh reads it."""

from fractions import Fraction

import gmsh

from patch import LARGEST_DENOMINATOR, Patch


def start():
    """Begins a silent session."""
    gmsh.initialize(["gmsh", "-nopopup"])
    gmsh.option.setNumber("General.Terminal", 0)


def read(path, unit):
    """The faces of a file with the number of its different edges."""
    gmsh.clear()
    gmsh.option.setString("Geometry.OCCTargetUnit", {"inch": "INCH"}.get(unit, unit.upper()))
    gmsh.model.occ.importShapes(str(path))
    gmsh.model.occ.synchronize()
    faces = [tag for _, tag in gmsh.model.getEntities(2)]
    return [patch(tag) for tag in faces], len(gmsh.model.getEntities(1))


def patch(tag):
    """A face; Gmsh shows its parameters and points, and hides its poles."""
    # It tells the bounds with an error of the last digits.
    bounds = gmsh.model.getParametrizationBounds(2, tag)
    exact = [[Fraction(own).limit_denominator(LARGEST_DENOMINATOR) for own in end] for end in bounds]
    (u0, v0), (u1, v1) = [[float(own) for own in end] for end in exact]
    return Patch(
        degree=(25, 25),
        domain=[(u0, u1), (v0, v1)],
        evaluate=lambda u, v: list(gmsh.model.getValue(2, tag, [u, v])),
    )
