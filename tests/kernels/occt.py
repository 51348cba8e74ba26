"""STEP and IGES as Open CASCADE reads them."""

from OCP.BRep import BRep_Tool
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.Geom import Geom_BSplineCurve, Geom_BSplineSurface
from OCP.IFSelect import IFSelect_RetDone
from OCP.IGESControl import IGESControl_Reader
from OCP.Interface import Interface_Static
from OCP.Message import Message
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SHELL
from OCP.TopExp import TopExp
from OCP.TopoDS import TopoDS
from OCP.collections import IndexedMap_TopoDS_Shape_TopTools_ShapeMapHasher as ShapeMap
from OCP.gp import gp_Pnt

from patch import Patch

UNITS = {"mm": "MM", "cm": "CM", "m": "M", "inch": "INCH"}


class Shape:
    """What a file holds."""

    def __init__(self, reader, path, unit):
        Message.DefaultMessenger_s().ChangePrinters().Clear()
        # Lengths in the unit of the file: then nothing is scaled, and no double changes.
        Interface_Static.SetCVal_s("xstep.cascade.unit", UNITS[unit])
        assert reader.ReadFile(str(path)) == IFSelect_RetDone, "it cannot be read"
        reader.TransferRoots()
        self.shape = reader.OneShape()
        assert not self.shape.IsNull(), "it is empty"

    def parts(self, kind):
        """Its different parts of a kind."""
        found = ShapeMap()
        TopExp.MapShapes_s(self.shape, kind, found)
        return [found.FindKey(index + 1) for index in range(found.Extent())]

    def is_valid(self):
        """Whether the kernel finds nothing wrong."""
        return BRepCheck_Analyzer(self.shape).IsValid()

    def counts(self):
        """The numbers of shells, faces, and edges that are not collapsed."""
        edges = [TopoDS.Edge(own) for own in self.parts(TopAbs_EDGE)]
        edges = [own for own in edges if not BRep_Tool.Degenerated_s(own)]
        return len(self.parts(TopAbs_SHELL)), len(self.parts(TopAbs_FACE)), len(edges)

    def tolerance(self):
        """The largest distance of an edge from its faces that the kernel had to allow."""
        edges = map(TopoDS.Edge, self.parts(TopAbs_EDGE))
        return max(BRep_Tool.Tolerance_s(own) for own in edges)

    def curves(self):
        """The weights and points of its edges that are not collapsed."""
        edges = [TopoDS.Edge(own) for own in self.parts(TopAbs_EDGE)]
        curves = [BRep_Tool.Curve_s(own, 0, 0) for own in edges if not BRep_Tool.Degenerated_s(own)]
        return [controls(own) for own in curves]

    def patches(self):
        """Its faces as patches."""
        return [patch(TopoDS.Face(own)) for own in self.parts(TopAbs_FACE)]


def read_step(path, unit):
    """A STEP file."""
    return Shape(STEPControl_Reader(), path, unit)


def read_iges(path, unit):
    """An IGES file."""
    return Shape(IGESControl_Reader(), path, unit)


def coordinates(point):
    """x, y and z."""
    return [point.X(), point.Y(), point.Z()]


def controls(curve):
    """The weights and points of a curve."""
    assert isinstance(curve, Geom_BSplineCurve), type(curve)
    places = range(1, curve.NbPoles() + 1)
    return [curve.Weight(own) for own in places], [coordinates(curve.Pole(own)) for own in places]


def patch(face):
    """The surface of a face."""
    surface = BRep_Tool.Surface_s(face)
    assert isinstance(surface, Geom_BSplineSurface), type(surface)
    assert not surface.IsUPeriodic() and not surface.IsVPeriodic(), "it was made periodic"
    rows = range(1, surface.NbUPoles() + 1)
    columns = range(1, surface.NbVPoles() + 1)

    def evaluate(u, v):
        point = gp_Pnt()
        surface.D0(u, v, point)
        return coordinates(point)

    return Patch(
        degree=(surface.UDegree(), surface.VDegree()),
        domain=[
            (surface.UKnot(1), surface.UKnot(surface.NbUKnots())),
            (surface.VKnot(1), surface.VKnot(surface.NbVKnots())),
        ],
        weights=[[surface.Weight(i, j) for j in columns] for i in rows],
        points=[[coordinates(surface.Pole(i, j)) for j in columns] for i in rows],
        evaluate=evaluate,
    )
