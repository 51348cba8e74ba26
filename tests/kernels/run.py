"""Compiles every example and holds what kernels read against the exact nets.

usage: run.py SWEEPC FOLDER [WORD…]

FOLDER takes the files; with words, only what has all of them in its name is read.
"""

import functools
import itertools
import re
import subprocess
import sys
import unittest
from dataclasses import dataclass
from pathlib import Path

import geomdl_json
import gmsh_step
import occt
import rhino
import web
from boundary import Boundary
from patch import Nets, check

HERE = Path(__file__).resolve().parent
SOURCES = [HERE.parent.parent / "examples", HERE / "surfaces"]
EMIT = "json,step,iges,3dm,geomdl,three,verb,truck,obj"
# The surface in whose files a number is changed, to see that it is found.
SPOILED = "example_2-R."
# How far points are off in each kernel, in units of the last place of the range of coordinates.
WORST = {}
# An edge may be off its faces by so much before a kernel calls them apart.
TOLERANCE = 1e-7


@dataclass
class Written:
    """A file with the exact nets of the surfaces in it."""

    path: Path
    unit: str
    nets: Nets


def compile_all(compiler, folder):
    """The files of every source, by format."""
    formats = {}
    for source in sorted(own for root in SOURCES for own in root.rglob("*.sweep")):
        name = "-".join(source.with_suffix("").relative_to(HERE.parent.parent).parts[1:])
        text = source.read_text(encoding="utf-8").splitlines()
        unit = next((own.split()[1] for own in text if own.startswith("unit ")), "mm")
        plain = compile_one(compiler, source, folder / name, EMIT)
        trimmed = compile_one(compiler, source, folder / f"{name}.trimmed", "iges", "--iges-trimmed")
        for schema in ("ap203", "ap242"):
            place = folder / f"{name}.{schema}"
            plain += compile_one(compiler, source, place, "step", "--step-schema", schema)
        exact = {own.stem: Nets([own]) for own in plain if own.name.count(".") == 1 and own.suffix == ".json"}
        exact[source.stem] = Nets(own for own in plain if own.stem in exact and own.suffix == ".json")
        for written in plain + trimmed:
            stem, form = written.name.split(".", 1)
            form = "trimmed.igs" if written in trimmed else form
            if form != "json":
                formats.setdefault(form, []).append(Written(written, unit, exact[stem]))
    return formats


def compile_one(compiler, source, folder, *emit):
    """The files of one source."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        old.unlink()
    command = [compiler, "compile", source, "-o", folder, "--quiet", "--emit", *emit]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    refused = set(re.findall(r"#~ (E\d+)", source.read_text(encoding="utf-8")))
    found = set(re.findall(r"^error\[(E\d+)\]", run.stderr, re.MULTILINE))
    assert found == refused, f"{source}: {run.stderr}"
    return sorted(folder.iterdir())


def check_solid(shape, written, shelled, own_edges=True):
    """Validity, faces, edges and shells of what Open CASCADE has read.

    Like every check it returns how far points are off, in units of the last place."""
    patches = shape.patches()
    worst = check(written.nets, patches)
    assert shape.is_valid(), "it is not valid"
    assert shape.tolerance() <= TOLERANCE, f"an edge is off by {shape.tolerance()}"
    shells, faces, edges = shape.counts()
    boundary = Boundary(written.nets, patches)
    # Where a file has no edges, the kernel computes them.
    for weights, points in shape.curves() if own_edges else []:
        assert boundary.has(weights, points), f"no side of a patch: {weights}, {points}"
    assert faces == len(patches)
    if shelled:
        assert edges == boundary.edges(), f"{edges} edges, not {boundary.edges()}"
        assert shells == boundary.shells(), f"{shells} shells, not {boundary.shells()}"
    else:
        assert edges == boundary.edges_apart(), f"{edges} edges, not {boundary.edges_apart()}"
    return worst


def check_step(written):
    """STEP in Open CASCADE."""
    return check_solid(occt.read_step(written.path, written.unit), written, shelled=True)


def check_iges(written):
    """IGES in Open CASCADE."""
    trimmed = written.path.parent.suffix == ".trimmed"
    shape = occt.read_iges(written.path, written.unit)
    return check_solid(shape, written, shelled=False, own_edges=trimmed)


def check_gmsh(written):
    """STEP in Gmsh."""
    patches, edges = gmsh_step.read(written.path, written.unit)
    worst = check(written.nets, patches)
    solid = occt.read_step(written.path, written.unit)
    boundary = Boundary(written.nets, solid.patches())
    assert len(patches) == solid.counts()[1]
    # Gmsh counts a collapsed edge as well.
    assert edges == boundary.edges() + boundary.collapsed(), f"{edges} edges"
    return worst


def check_rhino(written):
    """3DM in openNURBS."""
    patches = rhino.read(written.path, written.unit)
    worst = check(written.nets, patches)
    names = {name for own in patches for name in own.names}
    assert names == {own.name for own in written.nets.nets}, names
    return worst


def check_geomdl(written):
    """JSON in geomdl."""
    patches = geomdl_json.read(written.path)
    worst = check(written.nets, patches)
    names = sorted(name for own in patches for name in own.names)
    assert names == [own.name for own in written.nets.nets], names
    return worst


def check_web(written):
    """JSON in three.js or verb."""
    return check(written.nets, [web.read(written.path)])


CHECKS = {
    "step": [("occt", check_step), ("gmsh", check_gmsh)],
    "igs": [("occt", check_iges)],
    "trimmed.igs": [("occt", check_iges)],
    "3dm": [("rhino3dm", check_rhino)],
    "geomdl.json": [("geomdl", check_geomdl)],
    "three.json": [("three", check_web)],
    "verb.json": [("verb", check_web)],
}


def spoiled(path):
    """Copies of a file in which one number is off by about a billionth."""
    content = path.read_bytes()
    if path.suffix == ".3dm":
        # In the last point: 32 bytes before the checksum and the end of the class.
        places = {content.rindex(b"\x72\x80\x00\x02") - 8 - 4 - 32 + 3}
    else:
        # The first long number and the last one: of a surface, and of an edge if there are any.
        numbers = list(re.finditer(rb"\d\.\d{12,}", content))
        places = {own.start() + 10 for own in (numbers[0], numbers[-1])}
    for index, place in enumerate(sorted(places)):
        digit = bytes([content[place] ^ 1])
        copy = path.with_name(f"spoiled-{index}-{path.name}")
        copy.write_bytes(content[:place] + digit + content[place + 1 :])
        yield copy


def check_spoiled(own, written):
    """A check that can fail: it does not pass a file in which a number is wrong."""
    copies = spoiled(written.path)
    # Gmsh shows no curves.
    for copy in itertools.islice(copies, 1) if own is check_gmsh else copies:
        if copy.name.endswith((".three.json", ".verb.json")):
            web.start([copy])
        try:
            own(Written(copy, written.unit, written.nets))
        except AssertionError:
            continue
        raise AssertionError(f"{copy}: a wrong number went unnoticed")


class Reading(unittest.TestCase):
    """One file in one kernel."""

    def __init__(self, kernel, own, written):
        super().__init__("runTest")
        self.kernel, self.own, self.written = kernel, own, written

    def __str__(self):
        return f"{self.written.path.parent.name}/{self.written.path.name} in {self.kernel}"

    def runTest(self):
        worst = self.own(self.written)
        if worst is not None:
            WORST[self.kernel] = max(worst, WORST.get(self.kernel, 0))


def main(compiler, folder, *words):
    """Runs all checks and tells how many."""
    formats = compile_all(Path(compiler).resolve(), Path(folder).resolve())
    missing = [form for form in CHECKS if not formats.get(form)]
    assert not missing, f"no file of {missing} was written"
    gmsh_step.start()
    web.start(own.path for form in ("three.json", "verb.json") for own in formats[form])
    suite = unittest.TestSuite()
    for form, checks in CHECKS.items():
        for kernel, own in checks:
            for written in formats[form]:
                readings = [Reading(kernel, own, written)]
                if written.path.name.startswith(SPOILED):
                    check_copy = functools.partial(check_spoiled, own)
                    readings.append(Reading(f"{kernel}, spoiled", check_copy, written))
                wanted = (own for own in readings if all(word in str(own) for word in words))
                suite.addTests(wanted)
    result = unittest.TextTestRunner(verbosity=0).run(suite)
    for kernel, worst in WORST.items():
        print(f"{kernel}: the largest deviation is {worst:.2f} units in the last place")
    wrong, skipped = len(result.failures) + len(result.errors), len(result.skipped)
    print(f"kernels: {result.testsRun - wrong - skipped} passed, {wrong} failed, {skipped} skipped")
    return 0 if result.wasSuccessful() and result.testsRun and not skipped else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
