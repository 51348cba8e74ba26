"""The exchange format of geomdl, as geomdl reads it."""

import json

from geomdl import exchange

from patch import Patch


def read(path):
    """The surfaces of a file."""
    files = json.loads(path.read_text(encoding="utf-8"))["shape"]["data"]
    surfaces = exchange.import_json(str(path))
    assert len(files) == len(surfaces)
    return [patch(surface, own) for surface, own in zip(surfaces, files)]


def patch(surface, file):
    """A surface. Its parameters run from 0 to 1, and its points are multiplied by the weights."""
    rows, columns = surface.ctrlpts_size_u, surface.ctrlpts_size_v

    def matrix(items):
        return [items[i * columns : (i + 1) * columns] for i in range(rows)]

    weights = list(surface.weights)
    points = file["control_points"]["points"]
    # What it keeps is made of the numbers of the file by one multiplication each.
    products = [[own * weight for own in point] + [weight] for point, weight in zip(points, weights)]
    assert products == [list(own) for own in surface.ctrlptsw]
    return Patch(
        degree=(surface.degree_u, surface.degree_v),
        domain=[(0.0, 1.0), (0.0, 1.0)],
        weights=matrix(weights),
        points=matrix(points),
        evaluate=lambda u, v: surface.evaluate_single((u, v)),
        loses_more=True,
        names=[surface.name],
    )
