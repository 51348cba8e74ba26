//! Rows 1 to 21: the text itself.

use crate::Input::{Bytes, Made, Text};
use crate::{Row, row, run};

fn digits(count: usize) -> String {
    "7".repeat(count)
}

fn slips(count: usize) -> String {
    let lines = (1..=count).map(|index| format!("let a{index} = = 1\n"));
    lines.collect()
}

pub(crate) const ROWS: &[Row] = &[
    // an empty file, or only comments
    row(1, Text(""), 0, &["W1007"], &["declares no surface"]),
    row(1, Text("# only this\n"), 0, &["W1007"], &[]),
    run(
        1,
        "",
        &["compile", "x.sweep"],
        1,
        &["E0303"],
        &["nothing to build"],
    ),
    run(
        1,
        "",
        &["report", "x.sweep"],
        1,
        &["E0303"],
        &["nothing to build"],
    ),
    // random bytes, not UTF-8
    row(
        2,
        Bytes(b"\x00\xff\x13\x80"),
        1,
        &["E0001"],
        &["invalid at byte 1\n"],
    ),
    row(
        2,
        Bytes(b"let a = 1\nlet b = \xff\n"),
        1,
        &["E0001"],
        &["invalid at byte 18\n", "in line 2"],
    ),
    // a zero byte
    row(
        3,
        Text("let a\0 = 1"),
        1,
        &["E0002"],
        &["x.sweep:1:6", "at byte 5"],
    ),
    // edits without words of their own
    row(
        3,
        Text("surface R = (u, v, ½)\nsurface S on [0, 2] * [0, 1] = (u, v, 0)"),
        1,
        &["E0002", "E0006"],
        &["help: write `(1/2)`\n", "help: write `x`\n"],
    ),
    // an angle in degrees
    row(
        3,
        Text("let a = 30°"),
        1,
        &["E0002"],
        &["x.sweep:1:11\n", "`turn(h)` is those of 2 arctan h"],
    ),
    row(
        3,
        Text("let a = turn(1)\nsurface R = (u, v, 0)\nexpect a == (0, 1)"),
        0,
        &[],
        &[],
    ),
    // a byte-order mark at the start, and elsewhere
    row(4, Text("\u{feff}surface R = (u, v, 0)\n"), 0, &[], &[]),
    run(
        4,
        "\u{feff}unit mm\n",
        &["fmt", "--check", "x.sweep"],
        1,
        &[],
        &["-\u{feff}unit mm\n+unit mm\n"],
    ),
    row(
        4,
        Text("let a = 1\n\u{feff}let b = 2\n"),
        1,
        &["E0003"],
        &["U+FEFF", "x.sweep:2:1"],
    ),
    // CRLF and lone CR
    row(
        5,
        Text("let a = 1\r\nlet b = zz\rlet c = 1"),
        1,
        &["E0101"],
        &["x.sweep:2:9\n"],
    ),
    row(
        5,
        Text("let a = 1\r\rlet b = zz"),
        1,
        &["E0101"],
        &["x.sweep:3:9\n"],
    ),
    run(
        5,
        "unit mm\r\n",
        &["fmt", "--check", "x.sweep"],
        1,
        &[],
        &["-unit mm\r\n+unit mm\n"],
    ),
    // UTF-16
    row(
        6,
        Bytes(b"\xff\xfeu\0n\0i\0t\0"),
        1,
        &["E0001"],
        &["looks like UTF-16"],
    ),
    row(
        6,
        Bytes(b"\xfe\xff\0u\0n\0i\0t"),
        1,
        &["E0001"],
        &["looks like UTF-16"],
    ),
    row(
        6,
        Bytes(b"u\0n\0i\0t\0 \0m\0m\0"),
        1,
        &["E0001"],
        &["looks like UTF-16"],
    ),
    // an unclosed bracket or string
    row(
        7,
        Text("let a = (1 + 2\nlet b = 1"),
        1,
        &["E0005"],
        &["x.sweep:1:9\n", "`(` is not closed"],
    ),
    row(
        7,
        Text("let a = g(b, [2"),
        1,
        &["E0005"],
        &["the file ends here"],
    ),
    row(
        7,
        Text("import \"abc"),
        1,
        &["E0005"],
        &["x.sweep:1:8\n", "the string is not closed"],
    ),
    // 20 errors of syntax, and more than are shown
    row(
        8,
        Made(|| slips(20)),
        1,
        &["E0006"; 20],
        &["x.sweep:20:11\n"],
    ),
    row(
        8,
        Made(|| slips(80)),
        1,
        &["E0006"; 50],
        &["x.sweep:50:11\n"],
    ),
    // brackets without end
    row(
        9,
        Made(|| "let a = ".to_owned() + &"(".repeat(100_000)),
        4,
        &["E0502"],
        &["`--max-nesting`"],
    ),
    // definitions that stand on one another without end
    row(
        9,
        Made(|| {
            let next = |own| format!("let f{}(u) = 1/(2 + f{own}(u))\n", own + 1);
            "let f0(u) = u\n".to_owned() + &(0..2_100).map(next).collect::<String>()
        }),
        4,
        &["E0502"],
        &["4096 levels", "no flag raises this limit"],
    ),
    // a million terms
    row(
        10,
        Made(|| "let a = 1".to_owned() + &"+1".repeat(1_000_000)),
        0,
        &["W1007"],
        &[],
    ),
    // signs without end
    row(
        11,
        Made(|| format!("let a = {}1", "-".repeat(100_000))),
        4,
        &["E0502"],
        &["x.sweep:1:266\n"],
    ),
    // one line of 100 MB, and a name of 1 MB
    row(
        12,
        Made(|| "#".repeat(100_000_000)),
        4,
        &["E0501"],
        &["the limit is 16777216", "`--max-source`"],
    ),
    row(
        12,
        Made(|| "let a = ".to_owned() + &"b".repeat(1_000_000)),
        1,
        &["E0101"],
        &["bbb … bbb"],
    ),
    // powers
    row(
        13,
        Text("surface R = (u, v, u^999999999)"),
        4,
        &["E0504"],
        &["x.sweep:1:22\n", "`--max-exponent`"],
    ),
    row(
        13,
        Text("surface R = (u, v, u^501)"),
        4,
        &["E0505"],
        &["degree 501", "`--max-degree`"],
    ),
    row(
        13,
        Text("surface R = (u, v, sqrt(u^600))"),
        4,
        &["E0505"],
        &["degree 600", "x.sweep:1:25\n"],
    ),
    row(
        14,
        Text("surface R = (u, v, (u+v)^4096)"),
        4,
        &["E0505"],
        &["degree 4096"],
    ),
    run(
        14,
        "surface R = (u, v, (u+v)^4096)",
        &["check", "x.sweep", "--max-degree", "5000"],
        4,
        &["E0505"],
        &["16785409 terms", "`--max-terms`"],
    ),
    row(
        15,
        Text("let a = 2^2^2^2^2^2"),
        4,
        &["E0504"],
        &["`--max-exponent`"],
    ),
    row(
        16,
        Text("surface R = (u, v, u^-1)"),
        1,
        &["E0301"],
        &["W = 0 at u = 0\n"],
    ),
    row(
        16,
        Text("surface R on [1, 2] x [0, 1] = (u, v, u^-1)"),
        0,
        &[],
        &[],
    ),
    row(
        16,
        Text("surface R = (u, v, u^(1/2))"),
        1,
        &["E0009"],
        &["1/2 is not an integer"],
    ),
    // numbers
    row(
        17,
        Made(|| "let a = ".to_owned() + &digits(1_000_000)),
        4,
        &["E0503"],
        &["1000000 digits", "`--max-digits`"],
    ),
    row(
        18,
        Text("let a = 1e999999999"),
        4,
        &["E0504"],
        &["`--max-exponent`"],
    ),
    row(
        19,
        Text("surface R = (u, v, 0)\nexpect 0.1 == 1/10"),
        0,
        &[],
        &[],
    ),
    row(20, Text("let a = 1,5"), 1, &["E0007"], &["write `1.5`"]),
    row(20, Text("surface R = (1,5 u,v)"), 0, &[], &[]),
    row(
        20,
        Text("surface R = (u, v, 1,5)"),
        1,
        &["E0106"],
        &["4 entries", "a decimal fraction is written `1.5`"],
    ),
    row(
        20,
        Text("surface R = (1,25, 2,75 u, v, 0)"),
        1,
        &["E0106"],
        &["6 entries", "a decimal fraction is written `1.25`"],
    ),
    // division by zero, with the divisor and the quotient
    row(
        21,
        Text("let a = 3/0"),
        1,
        &["E0207"],
        &["x.sweep:1:11\n", "this is zero", "in this quotient"],
    ),
    row(
        21,
        Text("let q(u) = u^2\nsurface R = (u, v, 2 v/(q(u)-q(u)))"),
        1,
        &["E0207"],
        &[
            "x.sweep:2:25\n",
            "this is zero for all parameters",
            "in this quotient",
        ],
    ),
];
