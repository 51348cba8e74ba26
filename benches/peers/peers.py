"""Times python-flint, FLINT in C and sympy on the workloads: from rationals in memory to doubles in memory.

The work is that of `cargo bench --bench workloads`: the curve from its preimage, the formula over a
common denominator, the common factor out, the Bernstein net at the exact bidegree, and the doubles
nearest to its exact values. Reading the data is not timed.
"""

import argparse
import gc
import json
import statistics
import struct
import sys
import time
from functools import partial
from pathlib import Path

import bivariate_flint
import bivariate_sympy
import flint_in_c
import separable_flint

PROGRAMS = {
    "flint-separable": separable_flint,
    "flint-bivariate": bivariate_flint,
    "sympy-ring": bivariate_sympy,
}
IN_C = {"c-separable": "separable", "c-bivariate": "bivariate"}
WORKLOADS = Path(__file__).resolve().parent.parent / "workloads"


def fnv(points):
    """FNV-1a 64 over the little-endian bytes of x y z w, point by point, u outside, v inside."""
    value = 0xCBF29CE484222325
    for byte in struct.pack(f"<{4 * len(points)}d", *(own for point in points for own in point)):
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{value:016x}"


def measure(program, record, samples, patience):
    """The hash, the bidegree, and the median of so many runs, or of as many as fit in a time."""
    data = program.read(record)
    bidegree, points = program.compile(data)
    times, begin = [], time.perf_counter()
    gc.disable()
    while len(times) < samples and (not times or time.perf_counter() - begin < patience):
        start = time.perf_counter()
        program.compile(data)
        times.append(time.perf_counter() - start)
    gc.enable()
    return fnv(points), bidegree, statistics.median(times)


def measures(names, samples, patience):
    """The function of a record for each program; those in C that cannot be built are left out."""
    made = {}
    for name in names or [*PROGRAMS, *IN_C]:
        if name in PROGRAMS:
            made[name] = partial(measure, PROGRAMS[name], samples=samples, patience=patience)
            continue
        try:
            made[name] = flint_in_c.Process(IN_C[name], samples, patience).measure
        except flint_in_c.Absent as reason:
            if names:
                sys.exit(str(reason))
            print(f"{name} is left out: {reason}", file=sys.stderr)
    return made


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--program", choices=[*PROGRAMS, *IN_C], action="append")
    arguments.add_argument("--set", default="W1")
    arguments.add_argument("--data", type=Path, help="a file of records instead of a set")
    arguments.add_argument("--samples", type=int, default=9)
    arguments.add_argument("--patience", type=float, default=2.0, help="seconds for a case")
    arguments.add_argument("--only", default="", help="only cases whose names contain this")
    arguments.add_argument("--first", type=int, help="only so many cases")
    arguments.add_argument("--greatest", type=int, help="only preimages up to this degree")
    arguments.add_argument("--json", action="store_true", help="one JSON object a line")
    arguments = arguments.parse_args()
    data = arguments.data or WORKLOADS / f"{arguments.set}.json"
    records = [own for own in json.loads(data.read_text())["cases"] if arguments.only in own["id"]]
    programs = measures(arguments.program, arguments.samples, arguments.patience)
    different = 0
    for record in records[: arguments.first]:
        if record.get("field"):
            sys.exit("numbers with square roots are beyond these programs")
        if arguments.greatest is not None and record["m"] > arguments.greatest:
            continue
        for name, program in programs.items():
            value, bidegree, seconds = program(record)
            expected = record.get("expected")
            agrees = expected and [value, [*bidegree]] == [expected["hash"], expected["bidegree"]]
            different += agrees is False
            line = {"program": name, "id": record["id"], "hash": value, "agrees": agrees}
            line |= {"bidegree": bidegree, "seconds": seconds}
            if arguments.json:
                print(json.dumps(line), flush=True)
            else:
                verdict = {True: "equal", False: "DIFFERENT", None: ""}[agrees]
                case = f"{record['id']:<28} {name:<16} {value} {verdict:<9} {bidegree}"
                print(f"{case} {seconds * 1e6:.1f} µs")
    if different:
        sys.exit(f"{different} cases differ from what is expected")


if __name__ == "__main__":
    main()
