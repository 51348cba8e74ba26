"""Runs sweepc and its peers in turn on one machine and prints how many times faster sweepc is.

A round is one run of `cargo bench --bench workloads -- --set SET` and one of `peers.py` on the same
data; of each case and program the quietest round counts. All doubles must be equal.
"""

import argparse
import json
import math
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import flint_in_c

HERE = Path(__file__).resolve().parent
BENCH = ["cargo", "bench", "--quiet", "--bench", "workloads", "--"]


def lines(command):
    """The objects that a program prints, one a line."""
    run = subprocess.run(command, cwd=HERE.parent.parent, stdout=subprocess.PIPE, text=True)
    if run.returncode:
        sys.exit(f"failed: {' '.join(map(str, command))}")
    return [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]


class Times:
    """Seconds by case and program, and the doubles of each case."""

    def __init__(self):
        self.seconds, self.hashes = defaultdict(dict), {}

    def add(self, case, program, seconds, value):
        if self.hashes.setdefault(case, value) != value:
            sys.exit(f"{case}: the doubles of {program} differ")
        known = self.seconds[case].get(program, math.inf)
        self.seconds[case][program] = min(known, seconds)


def measured(name, arguments, in_c):
    times = Times()
    choice = ["--set", name, "--only", arguments.only, "--samples", str(arguments.samples)]
    if arguments.first is not None:
        choice += ["--first", str(arguments.first)]
    if arguments.data:
        choice += ["--data", str(arguments.data.resolve())]
    peers = [sys.executable, HERE / "peers.py", *choice, "--json"]
    peers += ["--patience", str(arguments.patience)]
    sympy = ["--program", "sympy-ring", "--greatest", str(arguments.sympy_up_to)]
    flint = ["--program", "flint-separable", "--program", "flint-bivariate"]
    for _ in range(arguments.rounds):
        for own in lines([*BENCH, *choice, "--json"]):
            if "id" in own:
                if own["agrees"] is False:
                    sys.exit(f"{own['id']}: not what is expected")
                times.add(own["id"], "sweepc", own["total_us"] / 1e6, own["hash"])
                for program in ("same work", "without lower"):
                    seconds = own[program.replace(" ", "_") + "_us"] / 1e6
                    times.add(own["id"], program, seconds, own["hash"])
        for own in lines([*peers, *flint, *in_c]) + lines([*peers, *sympy]):
            times.add(own["id"], own["program"], own["seconds"], own["hash"])
    for own in times.seconds.values():
        own["flint"] = min(own["flint-separable"], own["flint-bivariate"])
    return times.seconds


PEERS = {
    "flint": "flint",
    "flint-separable": "flint-separable",
    "flint-bivariate": "flint-bivariate",
    "c-separable": "FLINT in C, one parameter",
    "c-bivariate": "FLINT in C, u and v",
    "sympy-ring": "sympy-ring",
}


def programs_in_c():
    """The arguments for the programs in C, or none with the reason told."""
    try:
        flint_in_c.build()
    except flint_in_c.Absent as reason:
        print(f"FLINT in C is left out: {reason}", file=sys.stderr)
        return []
    return ["--program", "c-separable", "--program", "c-bivariate"]


def mean(values):
    return math.exp(math.fsum(map(math.log, values)) / len(values)) if values else math.nan


def report(name, seconds, quiet):
    """The ratios: for each peer of the same work, from the text's tree, and from the surface."""
    print(f"{name}: time of a peer / time of sweepc from numbers (from the text; from the surface)")
    print(f"{'':<28}" + "".join(f"{title:>26}" for title in PEERS.values()))
    ratios = {peer: ([], [], []) for peer in PEERS}
    for case, own in seconds.items():
        cells = []
        for peer in PEERS:
            times = [own[base] for base in ("same work", "sweepc", "without lower")]
            three = [own[peer] / time for time in times] if peer in own else []
            for values, ratio in zip(ratios[peer], three):
                values.append(ratio)
            cells.append("{:.2f} ({:.2f}; {:.2f})".format(*three) if three else "–")
        if not quiet:
            print(f"{case:<28}" + "".join(f"{cell:>26}" for cell in cells))
    means = {peer: [mean(values) for values in own] for peer, own in ratios.items()}
    cells = ["{:.2f} ({:.2f}; {:.2f})".format(*own) if ratios[peer][0] else "–" for peer, own in means.items()]
    print(f"{f'geometric mean of {len(seconds)}':<28}" + "".join(f"{cell:>26}" for cell in cells))
    counts = "; ".join(f"{PEERS[peer]} {len(own[0])}" for peer, own in ratios.items())
    print(f"cases: {counts}. All doubles equal\n", flush=True)


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--set", action="append", help="a set, several times for several")
    arguments.add_argument("--data", type=Path, help="a file of records instead of a set")
    arguments.add_argument("--rounds", type=int, default=3)
    arguments.add_argument("--samples", type=int, default=9)
    arguments.add_argument("--patience", type=float, default=2.0, help="seconds of a peer for a case")
    arguments.add_argument("--only", default="", help="only cases whose names contain this")
    arguments.add_argument("--first", type=int, help="only so many cases")
    arguments.add_argument("--sympy-up-to", type=int, default=8, help="greatest m for sympy")
    arguments.add_argument("--quiet", action="store_true", help="only the geometric means")
    arguments = arguments.parse_args()
    subprocess.run([*BENCH[:-1], "--no-run"], cwd=HERE.parent.parent, check=True)
    in_c = programs_in_c()
    for name in arguments.set or ["W1", "W2s", "W3"]:
        report(name, measured(name, arguments, in_c), arguments.quiet)


if __name__ == "__main__":
    main()
