"""3DM as rhino3dm reads it, which is openNURBS."""

import rhino3dm

from patch import Patch

UNITS = {
    "mm": rhino3dm.UnitSystem.Millimeters,
    "cm": rhino3dm.UnitSystem.Centimeters,
    "m": rhino3dm.UnitSystem.Meters,
    "inch": rhino3dm.UnitSystem.Inches,
}


def read(path, unit):
    """The surfaces of a file."""
    file = rhino3dm.File3dm.Read(str(path))
    assert file is not None, "it cannot be read"
    assert file.Settings.ModelUnitSystem == UNITS[unit]
    found = []
    for own in file.Objects:
        assert own.Geometry.IsValid, own.Geometry.IsValidWithLog
        found.append(patch(own.Geometry, own.Attributes.Name))
    return found


def patch(surface, name):
    """A surface; openNURBS leaves out the first knot and the last."""
    rows, columns = range(surface.Points.CountU), range(surface.Points.CountV)
    points = [[surface.Points[i, j] for j in columns] for i in rows]

    def evaluate(u, v):
        point = surface.PointAt(u, v)
        return [point.X, point.Y, point.Z]

    return Patch(
        degree=(surface.Degree(0), surface.Degree(1)),
        domain=[(surface.Domain(own).T0, surface.Domain(own).T1) for own in (0, 1)],
        premultiplied=[[[own.X, own.Y, own.Z, own.W] for own in row] for row in points],
        evaluate=evaluate,
        loses_more=True,
        names=[name],
    )
