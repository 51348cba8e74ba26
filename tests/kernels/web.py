"""JSON for three.js and verb, as these libraries evaluate it."""

import json
import subprocess
from fractions import Fraction
from pathlib import Path

from patch import SHARES, Patch

READER = Path(__file__).with_name("web.mjs")

ANSWERS = {}


def parameters(text):
    """The ends of the domain, and the samples in it."""
    knots = [text.get("knots1") or text["knotsU"], text.get("knots2") or text["knotsV"]]
    domain = [(own[0], own[-1]) for own in knots]
    ends = [tuple(map(Fraction, own)) for own in domain]
    samples = [[float(start + share * (end - start)) for share in SHARES] for start, end in ends]
    return domain, samples


def start(paths):
    """Evaluates all surfaces in one run of Node."""
    questions = []
    for path in paths:
        _, samples = parameters(json.loads(path.read_text(encoding="utf-8")))
        questions.append({"path": str(path), "u": samples[0], "v": samples[1]})
    run = subprocess.run(
        ["node", READER], input=json.dumps(questions), capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    for question, answer in zip(questions, json.loads(run.stdout), strict=True):
        ANSWERS[question["path"]] = answer


def read(path):
    """The surface of a file, with the points that were evaluated."""
    text = json.loads(path.read_text(encoding="utf-8"))
    answer = ANSWERS[str(path)]
    domain, (along_u, along_v) = parameters(text)

    def evaluate(u, v):
        return answer["points"][along_u.index(u)][along_v.index(v)]

    controls = answer["controls"]
    read = Patch(degree=tuple(answer["degree"]), domain=domain, evaluate=evaluate)
    if path.name.endswith(".verb.json"):
        read.premultiplied = controls
    else:
        read.weights = [[own[3] for own in row] for row in controls]
        read.points = [[own[:3] for own in row] for row in controls]
    return read
