"""FLINT called from C: the programs of `in_c`, built when first wanted."""

import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCES = HERE / "in_c"
BUILT = HERE.parent.parent / "target" / "peers" / "flint-in-c"
INSTALL = "apt-get install gcc libflint-dev libgmp-dev"


class Absent(Exception):
    """What is missing for the programs in C."""


def build():
    """The path of the program, which is made anew when it is older than its sources."""
    sources = sorted(SOURCES.glob("*.[ch]"))
    if BUILT.exists() and BUILT.stat().st_mtime > max(own.stat().st_mtime for own in sources):
        return BUILT
    if not shutil.which("gcc"):
        raise Absent(f"no gcc ({INSTALL})")
    BUILT.parent.mkdir(parents=True, exist_ok=True)
    command = ["gcc", "-O3", "-march=native", "-o", BUILT, *(own for own in sources if own.suffix == ".c")]
    run = subprocess.run([*command, "-lflint", "-lgmp", "-lm"], capture_output=True, text=True)
    if run.returncode:
        errors = [line for line in run.stderr.splitlines() if "error" in line or "cannot find" in line]
        raise Absent(f"gcc fails ({INSTALL}): {'; '.join(errors[:1])}")
    return BUILT


def text(record):
    """The words of a record: name, kind, and lists with their lengths."""
    lists = [[pair[0] for pair in record["w"]], [pair[1] for pair in record["w"]], record["h"], record["s0"]]
    lists += [record["profile"][name] for name in "XZD"] + [[record["d"]], [record["c"]]]
    return " ".join([record["id"], record["kind"], *(f"{len(own)} {' '.join(own)}" for own in lists)])


class Process:
    """One of the programs, which answers record by record."""

    def __init__(self, program, samples, patience):
        command = [build(), program, str(samples), str(patience)]
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True)

    def measure(self, record):
        """The hash, the bidegree and the median time in seconds."""
        self.process.stdin.write(text(record) + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline().split()
        if len(answer) != 5 or answer[0] != record["id"]:
            raise RuntimeError(f"{record['id']}: no answer of the program in C")
        _, du, dv, seconds, value = answer
        return value, (int(du), int(dv)), float(seconds)
