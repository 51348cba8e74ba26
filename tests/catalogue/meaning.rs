//! Rows 22 to 43, 48, 58 to 60 and 65: what the text means.

use crate::Input::{Made, Text};
use crate::{Row, row, run};

const COMPILE: &[&str] = &["compile", "x.sweep"];
const REPORT: &[&str] = &["report", "x.sweep"];

/// A sweep along a curve whose frame is used.
macro_rules! along {
    ($curve:literal) => {
        concat!(
            "profile p(u) in xz = (u, u^2)\nsweep c(v) ",
            $curve,
            "\nsurface R = c(v) + x(u) n(v) + z(u) k\n"
        )
    };
}

const CUSP: &str = along!("in xy = ph(start: (0, 0), preimage: [(1, 0), (-1, 0)])");
/// κ = −1 for the clockwise unit circle, so 1 + κ x = 0 at x = 1.
const FOLD: &str = "profile p(u) in xz = (2u, u)
sweep c(v) in xy = (2v / (1 + v^2), (1 - v^2) / (1 + v^2))
surface R = c(v) + x(u) n(v) + z(u) k";
/// W = 1 − 3u + 3u² > 0 has the Bernstein weights 1, −1/2, 1.
const SIGNS: &str = "surface R = (u / (1 - 3u + 3u^2), v / (1 - 3u + 3u^2), 1)";

pub(crate) const ROWS: &[Row] = &[
    // a denominator that is zero inside the domain, and at its end
    row(
        22,
        Text("surface R = (u, v, 1 / (2v^2 - 1))"),
        1,
        &["E0301"],
        &["W = 0 at v in [181/256, 725/1024]"],
    ),
    row(
        22,
        Text("surface R = (u, v, 1 / (3u - 1))"),
        1,
        &["E0301"],
        &["W = 0 at u = 1/3\n"],
    ),
    row(
        23,
        Text("surface R = (u, v, 1 / (1 - u))"),
        1,
        &["E0301"],
        &["W = 0 at u = 1\n", "end the domain before"],
    ),
    // numerator and denominator share the zero
    row(
        24,
        Text("surface R = (u, v, (3u - 1) v / (3u - 1))"),
        0,
        &["W1004"],
        &[
            "x.sweep:1:9\n",
            "of `R` are all zero on the line u = 1/3",
            "common factor",
        ],
    ),
    row(
        24,
        Text("surface R = (u, v, (u - 2) / (u - 2))"),
        0,
        &[],
        &[],
    ),
    row(
        24,
        Text("profile p(u) in xy = (u (2u - 1) / (2u - 1), u^2)\nsurface R = p(u) + v k"),
        0,
        &["W1004"],
        &["of `p` are all zero at u = 1/2"],
    ),
    // weights of both signs where W has one
    run(
        25,
        SIGNS,
        REPORT,
        0,
        &["W1011"],
        &["positive in 2 patches, cut at u = 1/2; in the one patch of the net from -1/2 to 1"],
    ),
    run(25, SIGNS, COMPILE, 0, &["W1011"], &[]),
    // negative weights only
    run(
        26,
        "surface R = (u, v, u / (-1 - u^2))",
        REPORT,
        0,
        &[],
        &["weights         positive, from 1 to 2\n"],
    ),
    // curves
    row(
        27,
        Text(along!("in xy = (1, 2)")),
        1,
        &["E0204"],
        &["its hodograph is zero"],
    ),
    row(
        27,
        Text(along!("in xy = bezier([])")),
        1,
        &["E0107"],
        &["`bezier`: the list is empty, two points or more are needed"],
    ),
    row(
        27,
        Text(along!("in xy = bezier([(0, 0), (1, 1)], weights: [])")),
        1,
        &["E0107"],
        &["the list is empty, a number for each point is needed"],
    ),
    row(
        27,
        Text(along!("in xy = ph(start: (0, 0), preimage: [])")),
        1,
        &["E0107"],
        &["the list is empty, one pair or more is needed"],
    ),
    row(
        28,
        Text(CUSP),
        0,
        &["W1003", "W1011"],
        &["σ vanishes at v = 1/2"],
    ),
    row(
        29,
        Text(along!("in xy = (v, v^2)")),
        1,
        &["E0201"],
        &["an odd number of times: 4 v^2 + 1"],
    ),
    row(
        30,
        Text(concat!(along!("in xy = (-v, 0)"), "expect c.σ(v) == 1")),
        0,
        &[],
        &[],
    ),
    row(
        30,
        Text(along!("in xy = (v^3 - v^2, 0)")),
        1,
        &["E0202"],
        &["3 v - 2 changes sign at v = 2/3"],
    ),
    // surfaces
    row(
        31,
        Text(FOLD),
        0,
        &["W1011"],
        &["R_u × R_v is zero at u = 1/2"],
    ),
    run(
        32,
        "surface R = (u, v, 0)",
        REPORT,
        0,
        &[],
        &["crosses itself  not decided\n"],
    ),
    row(
        33,
        Text("surface R = (u, u, u)"),
        1,
        &["E0302"],
        &["is a curve or a point"],
    ),
    row(
        33,
        Text("surface R = (1, 2, 3)"),
        1,
        &["E0302"],
        &["is a curve or a point"],
    ),
    row(33, Text("surface R = (u v, u (1 - v), 0)"), 0, &[], &[]),
    row(
        34,
        Text(along!("in xy on [1, 1] = (v, 0)")),
        1,
        &["E0205"],
        &["x.sweep:2:21\n", "[1, 1] is empty"],
    ),
    row(
        34,
        Text(along!("in xy on [2, 1/2] = (v, 0)")),
        1,
        &["E0205"],
        &["[2, 1/2] is reversed"],
    ),
    run(
        35,
        "surface R = (u, v, u^26)",
        COMPILE,
        1,
        &["E0305"],
        &["x-R.json", "degree 26 along u"],
    ),
    run(
        35,
        "surface R = (u, v, u^26)",
        &["compile", "x.sweep", "--emit", "report,json"],
        0,
        &[],
        &["x-R.json"],
    ),
    // names
    row(
        36,
        Text("let s = 1"),
        1,
        &["E0103"],
        &["the arc length of a curve"],
    ),
    row(
        37,
        Text("let x = 1"),
        1,
        &["E0103"],
        &["a coordinate of a curve"],
    ),
    row(
        37,
        Text("let σ = 1"),
        1,
        &["E0103"],
        &["the parametric speed of a curve"],
    ),
    row(
        38,
        Text("let aς = 1"),
        1,
        &["E0003"],
        &["`ς` (U+03C2) looks like `σ`"],
    ),
    row(
        38,
        Text("let 𝜎b = 1"),
        1,
        &["E0003"],
        &["(U+1D70E) looks like `σ`"],
    ),
    row(
        38,
        Text("let \u{445}b = 1"),
        1,
        &["E0003"],
        &["(U+0445) looks like `x`"],
    ),
    row(
        38,
        Text("let a = １"),
        1,
        &["E0003"],
        &["(U+FF11) looks like `1`"],
    ),
    row(39, Text("let a\u{202e}b = 1"), 1, &["E0003"], &["U+202E"]),
    row(39, Text("let a\u{200b}b = 1"), 1, &["E0003"], &["U+200B"]),
    // the two spellings are the name of a property, so that neither can be defined
    row(
        40,
        Text("let σ = 1\nlet sigma = 2"),
        1,
        &["E0103", "E0103"],
        &["the parametric speed"],
    ),
    row(
        41,
        Text("let width = 1\nlet b = widht"),
        1,
        &["E0101"],
        &["x.sweep:2:9\n", "did you mean `width`?"],
    ),
    row(
        41,
        Text("let a = sqrt(2) pi"),
        1,
        &["E0101"],
        &["made of rational numbers and square roots; `turn(h)` is the cosine and sine"],
    ),
    // words of a later version
    row(
        41,
        Text("sweep c(v) in xy = circle(center: (0, 0), radius: 1)"),
        1,
        &["E0110"],
        &["x.sweep:1:20\n", "write `arc(center: C, start: P, end: Q)`"],
    ),
    row(
        41,
        Text("sweep c(v) in xy = bspline(degree: 2, knots: [0, 1], points: [(0, 0)])"),
        1,
        &["E0110"],
        &["write a `bezier` for each span"],
    ),
    row(
        41,
        Text("curve a(v) = (v, 0, 0)\ncurve b(v) = (v, 1, 0)\nsweep c(v) = join(a, b)"),
        1,
        &["E0110"],
        &["declare each curve, and a surface for each"],
    ),
    row(
        42,
        Text("let a = 1\nlet a = 2"),
        1,
        &["E0102"],
        &["x.sweep:2:5\n", "first declared here", "again here"],
    ),
    row(
        43,
        Text("let a = b\nlet b = c\nlet c = a"),
        1,
        &["E0104"],
        &["a → b → c → a"],
    ),
    row(
        43,
        Text("construction foo(a,b) = a+v b where d = e, e = 2 d, f = d"),
        1,
        &["E0104"],
        &["x.sweep:1:37\n", "d → e → d", "`e` is defined here"],
    ),
    row(
        43,
        Text(
            "construction f(p) = q p(u) where q = 1 + q\nprofile p(u) in xy = (u, 1)\nsurface R = f(p)",
        ),
        1,
        &["E0104"],
        &["x.sweep:1:34\n", "`q` is defined by itself"],
    ),
    row(
        43,
        Text(
            "construction f(p) = q + p(u) where q = r k, r = v\nprofile p(u) in xy = (u, 1)\nsurface R = f(p)",
        ),
        0,
        &[],
        &[],
    ),
    // the parameters of a function
    row(
        40,
        Text("let f(v,u) = u - 2 v"),
        1,
        &["E0109"],
        &["x.sweep:1:7\n", "`u` stands before `v`", "write `(u, v)`"],
    ),
    row(
        40,
        Text("let f(u,u) = u"),
        1,
        &["E0109"],
        &["x.sweep:1:9\n", "the parameter `u` stands twice"],
    ),
    row(
        40,
        Text("let f(w) = 1"),
        1,
        &["E0109"],
        &["a function takes `u`, `v` or both, not `w`"],
    ),
    // parameters
    run(
        48,
        "param a = 1",
        &["check", "x.sweep", "-D", "b=1"],
        2,
        &[],
        &["`b` is not a parameter", "there are: a\n"],
    ),
    run(
        48,
        "param a = 1",
        &["check", "x.sweep", "-D", "a=1.2.3"],
        2,
        &[],
        &["`1.2.3` is not an exact number"],
    ),
    run(
        48,
        "param a = 1",
        &["check", "x.sweep", "-D", "a"],
        2,
        &[],
        &["not of the form NAME=VALUE"],
    ),
    run(
        48,
        "param a = 1",
        &["check", "x.sweep", "-D", "a=1", "-D", "a=2"],
        2,
        &[],
        &["sweepc: `a` is given its value twice"],
    ),
    run(
        48,
        "param μ = 1",
        &["check", "x.sweep", "-D", "μ=1", "--set", "\u{b5}=1"],
        2,
        &[],
        &["`μ` is given its value twice"],
    ),
    // numbers that no double is near to
    run(
        58,
        "surface R = (u, v, 10^400 u)",
        COMPILE,
        1,
        &["E0306"],
        &["z of control point (1, 0) is about 1e400"],
    ),
    run(
        59,
        "surface R = (u, v, 10^-320)",
        COMPILE,
        0,
        &["W1005"],
        &["4 numbers become zero or subnormal"],
    ),
    run(
        59,
        "surface R = (u, v, 10^-400)",
        COMPILE,
        0,
        &["W1005"],
        &["4 numbers become zero or subnormal"],
    ),
    run(
        60,
        "surface R = (1 + u / 10^30, v, 1)",
        COMPILE,
        0,
        &["W1008", "W1009"],
        &["(0, 0) and (1, 0) differ by about 1e-30"],
    ),
    // more variants than anybody can compile
    run(
        49,
        "param a = 1\nparam b = 1\nsurface R = (a u, b v, 0)",
        &[
            "compile",
            "x.sweep",
            "--grid",
            "a=1:1e5:1",
            "--grid",
            "b=1:1e4:1",
        ],
        4,
        &["E0510"],
        &["1000000000 variants", "`--max-variants`"],
    ),
    // time and memory
    run(
        65,
        "surface R = (u, v, (u + v)^400)",
        &["check", "x.sweep", "--max-seconds", "1"],
        4,
        &["E0508"],
        &[
            "error[E0508]: `x.sweep` takes more than 1 second\n",
            "`--max-seconds` raises the limit",
        ],
    ),
    run(
        65,
        "surface R = (u, v, (u + v)^400)",
        &["check", "x.sweep", "--max-memory", "1"],
        4,
        &["E0508"],
        &["more than 1 MiB", "`--max-memory` raises the limit"],
    ),
    row(
        65,
        Made(|| format!("let a = 3^4096\nlet b = a{}", " a".repeat(200))),
        4,
        &["E0507"],
        &["`--max-bits`"],
    ),
];
