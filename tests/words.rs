//! A slip of one word or sign: one finding, which says what is true, and an edit where it is
//! certain.

#![allow(clippy::unwrap_used, reason = "shared modules of the tests need it")]

mod support;

use sweepc::diag::Code;

use support::compile;

/// The code of the only finding, the text, words that are printed, and the text that the edit makes
/// of it, without findings; nothing where no edit is certain.
type Slip = (Code, &'static str, &'static str, &'static str);

/// The slips that are not as promised.
fn wrong(slips: &[Slip]) -> Vec<String> {
    let mut wrong = Vec::new();
    for (code, text, words, repaired) in slips {
        let compiled = compile(text);
        let printed = compiled.all();
        if compiled.codes() != [*code] || !printed.contains(words) {
            wrong.push(format!("{text}\nnot only {code}, `{words}`:\n{printed}"));
            continue;
        }
        let fix = compiled.compilation.diagnostics.iter().next();
        let fix = fix.and_then(|own| own.fix.clone());
        let fixed = fix.map_or_else(String::new, |fix| {
            let mut fixed = (*text).to_owned();
            fixed.replace_range(fix.span.range(), &fix.text);
            fixed
        });
        if fixed != *repaired {
            wrong.push(format!("{text}\nbecomes\n{fixed}\n{printed}"));
        } else if !fixed.is_empty() && !compile(&fixed).codes().is_empty() {
            wrong.push(format!("{fixed}\n{}", compile(&fixed).all()));
        }
    }
    wrong
}

#[track_caller]
fn hold(slips: &[Slip]) {
    let wrong = wrong(slips);
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn what_a_broken_declaration_declares_is_not_reported() {
    hold(&[
        (
            Code::E0006,
            "profle p(u) in xz = (u, u^2)\nsurface R = p(u) + v j",
            "write `profile`",
            "profile p(u) in xz = (u, u^2)\nsurface R = p(u) + v j",
        ),
        (
            Code::E0006,
            "profle p(u) in xz = (u, u^2)\nsurface R = x(u) i + z(u) k + p.x(u) v j",
            "write `profile`",
            "profile p(u) in xz = (u, u^2)\nsurface R = x(u) i + z(u) k + p.x(u) v j",
        ),
        (
            Code::E0006,
            "unit mm\nswep c(v) in xy = line((0, 0), (3, 4))\nsurface R = c(v) + u n(v) + κ(v) k",
            "write `sweep`",
            "unit mm\nsweep c(v) in xy = line((0, 0), (3, 4))\nsurface R = c(v) + u n(v) + κ(v) k",
        ),
        (
            Code::E0005,
            "profile p(u) in xz = (u, u^2\nsurface R = (x(u), v, z(u))",
            "`(` is not closed",
            "",
        ),
        (
            Code::E0006,
            "q(v) in xy = (v, v^2)\nsurface R = (u, x(v), y(v))",
            "begins with a keyword",
            "",
        ),
        (
            Code::E0006,
            "surfce R = (u, v, 0)\nexpect regular(R)",
            "write `surface`",
            "surface R = (u, v, 0)\nexpect regular(R)",
        ),
    ]);
}

#[test]
fn names_without_a_blank_between_them_are_a_product() {
    hold(&[
        (
            Code::E0101,
            "surface R = (u, v, uv)",
            "did you mean `u v`?",
            "surface R = (u, v, u v)",
        ),
        (
            Code::E0101,
            "let a = 2\nlet b = 3\nsurface R = (u, v, ab^2 u)",
            "did you mean `a b`?",
            "let a = 2\nlet b = 3\nsurface R = (u, v, a b^2 u)",
        ),
        (
            Code::E0101,
            "let a = 2\nlet r_1 = 3\nsurface R = (u, v, 5u / ar_1)",
            "did you mean `a r_1`?",
            "let a = 2\nlet r_1 = 3\nsurface R = (u, v, 5u / (a r_1))",
        ),
        (
            Code::E0101,
            "let a = 2\nlet b = 3\nsurface R = (u, v, u^ab)",
            "did you mean `a b`?",
            "",
        ),
        (
            Code::E0101,
            "profile p(u) in xz = (u, u^2)\nsurface R = (u, v, vx(u))",
            "did you mean `v x`?",
            "profile p(u) in xz = (u, u^2)\nsurface R = (u, v, v x(u))",
        ),
        (
            Code::E0101,
            "construction f(q) = q(v) + uk + q.x(v) j\ncurve c(v) in xy = (v, 0)\nsurface R = f(c)",
            "did you mean `u k`?",
            "construction f(q) = q(v) + u k + q.x(v) j\ncurve c(v) in xy = (v, 0)\nsurface R = f(c)",
        ),
        // in two ways, `a b c` and `ab c`; two vectors; `v` is no parameter here
        (
            Code::E0101,
            "let a = 2\nlet ab = 2\nlet b = 3\nlet c = 3\nsurface R = (u, v, abc)",
            "did you mean `ab`?",
            "let a = 2\nlet ab = 2\nlet b = 3\nlet c = 3\nsurface R = (u, v, ab)",
        ),
        (
            Code::E0101,
            "surface R = (u, v, 0) + jk",
            "`jk` is not declared\n",
            "",
        ),
        (
            Code::E0101,
            "let f(u) = uv\nsurface R = (u, v, f(u))",
            "`uv` is not declared\n",
            "",
        ),
    ]);
}

#[test]
fn a_letter_that_is_written_twice_is_that_letter() {
    hold(&[
        (
            Code::E0101,
            "profile p(u) in xz = (u, u^2)\nsurface R = (u, v, zz(u))",
            "did you mean `z`?",
            "profile p(u) in xz = (u, u^2)\nsurface R = (u, v, z(u))",
        ),
        (
            Code::E0101,
            "profile p(u) in xz = (u, u^2)\nsurface R = pp(u) + v j",
            "did you mean `p`?",
            "profile p(u) in xz = (u, u^2)\nsurface R = p(u) + v j",
        ),
        (
            Code::E0101,
            "let a = (1, 2, 3)\nsurface R = (u, v, 0) + aa",
            "did you mean `a`?",
            "let a = (1, 2, 3)\nsurface R = (u, v, 0) + a",
        ),
    ]);
}

#[test]
fn relations_are_written_in_their_order() {
    hold(&[
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect 3 => 2",
            "write `>=`",
            "surface R = (u, v, 0)\nexpect 3 >= 2",
        ),
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect 1 =< 2",
            "write `<=`",
            "surface R = (u, v, 0)\nexpect 1 <= 2",
        ),
    ]);
}

#[test]
fn claims_are_not_negated() {
    hold(&[
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect regular(R) == false",
            "help: a claim cannot be negated\n",
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect not regular(R)",
            "help: a claim cannot be negated\n",
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect 1 != positive_weights(R)",
            "help: a claim cannot be negated\n",
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect regular(R) != false",
            "write `expect regular(R)`",
            "surface R = (u, v, 0)\nexpect regular(R)",
        ),
    ]);
}

#[test]
fn expectations_are_not_joined() {
    hold(&[
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect 1 == 1 and 2 == 2",
            "two expectations",
            "surface R = (u, v, 0)\nexpect 1 == 1\nexpect 2 == 2",
        ),
        (
            Code::E0006,
            "let a = 2\nsurface R = (u, v, 0)\nexpect a <= 3 # first\n  and a > 1",
            "write an `expect` for each",
            "let a = 2\nsurface R = (u, v, 0)\nexpect a <= 3 # first\n  expect a > 1",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect regular(R) and positive_weights(R)",
            "two expectations",
            "surface R = (u, v, 0)\nexpect regular(R)\nexpect positive_weights(R)",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect bidegree(R) == (1, 1) and regular(R)",
            "two expectations",
            "surface R = (u, v, 0)\nexpect bidegree(R) == (1, 1)\nexpect regular(R)",
        ),
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect 1 == 1 or 2 == 2",
            "one relation stands in an `expect`",
            "",
        ),
    ]);
}

#[test]
fn words_of_other_languages_and_in_capitals() {
    hold(&[
        (
            Code::E0101,
            "surface R = (U, v, 0)",
            "did you mean `u`?",
            "surface R = (u, v, 0)",
        ),
        (
            Code::E0101,
            "let width = 2\nsurface R = (u, v, WIDTH)",
            "did you mean `width`?",
            "let width = 2\nsurface R = (u, v, width)",
        ),
        (
            Code::E0101,
            "let r = 2\nsurface S = (u, v, R)",
            "`R` is not declared",
            "",
        ),
        (
            Code::E0101,
            "surface R = (u, v, 0)\nassert regular(R)",
            "write `expect`",
            "surface R = (u, v, 0)\nexpect regular(R)",
        ),
    ]);
}

#[test]
fn claims_stand_alone() {
    hold(&[
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect (1 == 1) and (2 == 2)",
            "write `expect A == B`, an `expect` for each claim",
            "",
        ),
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect 2 == 2 and (1 == 1)",
            "a claim stands without parentheses",
            "",
        ),
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect ((1) == (1)) # sure\nlet a = 2",
            "a claim stands without parentheses",
            "surface R = (u, v, 0)\nexpect (1) == (1) # sure\nlet a = 2",
        ),
        (
            Code::E0002,
            "surface R = (u, v, 0)\nexpect 1 == 1 && 2 == 2",
            "an `expect` holds one claim",
            "",
        ),
        (
            Code::E0002,
            "surface R = (u, v, 0)\nexpect 1 == 1 || 2 == 2",
            "there is no `or`",
            "",
        ),
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect 1 == 1, 2 == 2",
            "write an `expect` for each claim",
            "surface R = (u, v, 0)\nexpect 1 == 1\nexpect 2 == 2",
        ),
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect regular(R), positive_weights(R)",
            "write an `expect` for each claim",
            "surface R = (u, v, 0)\nexpect regular(R)\nexpect positive_weights(R)",
        ),
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect bidegree(R) == 1, 1",
            "a pair is written `(a, b)`",
            "",
        ),
        (
            Code::E0008,
            "let and = 2\nsurface R = (u, v, 0)\nexpect 4 == and 2",
            "write `* 2`",
            "let and = 2\nsurface R = (u, v, 0)\nexpect 4 == and * 2",
        ),
    ]);
}

#[test]
fn an_error_of_syntax_hides_what_the_rest_of_its_declaration_means() {
    hold(&[
        (
            Code::E0006,
            "profile p(u) in xz = (u, u)\nsurface R = (u, v, 0) + x(u)) k",
            "`)` closes nothing",
            "",
        ),
        (
            Code::E0006,
            "surface R = u, v, 3",
            "a point is written `(a, b)`",
            "surface R = (u, v, 3)",
        ),
        (
            Code::E0006,
            "profile p(u) in xz = u, (u - 1)^2 # a parabola\nsurface R = p(u) + v j",
            "a point is written `(a, b)`",
            "profile p(u) in xz = (u, (u - 1)^2) # a parabola\nsurface R = p(u) + v j",
        ),
        (
            Code::E0006,
            "let a = 1, 5\nsurface R = (u, v, 0)",
            "a point is written `(a, b)`",
            "",
        ),
        (
            Code::E0006,
            "surface R = (u, v, 0), k",
            "a point is written `(a, b)`",
            "",
        ),
        (
            Code::E0006,
            "surface R = (u, v, 0)\nexpect R == 1 # no\n  == R",
            "one relation",
            "",
        ),
    ]);
    let compiled = compile("let a = 2 + k\nlet b = 1 ]\nsurface R = (u, v, 0) + a\nlet c = b + k");
    let codes = compiled.codes();
    // the declarations beside it are read as ever
    assert_eq!(codes, [Code::E0106, Code::E0006, Code::E0106]);
}

#[test]
fn a_character_that_has_no_place_is_one_error() {
    hold(&[
        (
            Code::E0002,
            "surface R = (u, v, \0)",
            "U+0000 has no place",
            "",
        ),
        (Code::E0002, "surface R = (u, v, $)", "`$`", ""),
        (
            Code::E0002,
            "let a\u{1b} = 1\nsurface R = (u, v, a)",
            "U+001B has no place",
            "",
        ),
        (
            Code::E0002,
            "surface R =\u{c}(u, v, 0)",
            "U+000C has no place",
            "surface R = (u, v, 0)",
        ),
    ]);
}

#[test]
fn words_of_the_language_are_known_where_they_have_no_place() {
    let side = "stands only as a side of an `expect`";
    hold(&[
        (
            Code::E0107,
            "surface R = (u, v, 0)\nlet q = bidegree(R)",
            side,
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect bidegree(R).x == 1",
            side,
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect 2 common_factor(R) == 2",
            side,
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect bidegree == (1, 1)",
            side,
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nexpect regular(R) == regular(R)",
            "write an `expect` for each",
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nlet q = regular(R)",
            "stands only as an `expect` of its own",
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nlet b = bezier",
            "`bezier` makes a curve, it is no value",
            "",
        ),
        (
            Code::E0107,
            "surface R = (u, v, 0)\nlet b = sqrt + 1",
            "the function `sqrt` needs its arguments",
            "",
        ),
        (
            Code::E0110,
            "surface R = (u, v, 0)\nlet b = ph_spline",
            "not in this version",
            "",
        ),
    ]);
}

#[test]
fn a_property_is_given_to_a_curve_that_is_there() {
    hold(&[
        (
            Code::E0105,
            "curve g(u) in xy = line((0, 0), (3, 4))\nsurface R = g(u) + v n(u)",
            "name the curve: `g.n(…)`",
            "curve g(u) in xy = line((0, 0), (3, 4))\nsurface R = g(u) + v g.n(u)",
        ),
        (
            Code::E0105,
            "curve g(u) in xy = (u, u^2)\ncurve h(u) in xy = (u, u^3)\nsurface R = g(u) + v x(u) k",
            "name the curve: `g.x(…)` or `h.x(…)`",
            "",
        ),
        (
            Code::E0105,
            "surface R = (u, v, x(u))",
            "declare it: `profile p(u) in xz = …`",
            "",
        ),
        (
            Code::E0105,
            "sweep c(v) in xy = (v, v^2)\nsurface R = c(v) + x(u) k",
            "declare it: `profile p(u) in xz = …`",
            "",
        ),
        (
            Code::E0105,
            "curve g(u) in xy = (u, u^2)\nsurface R = g(u) + v k + x(1) k",
            "write `g.x(…)`",
            "curve g(u) in xy = (u, u^2)\nsurface R = g(u) + v k + g.x(1) k",
        ),
        (
            Code::E0105,
            "surface R = (u, v, x(u + v))",
            "declare it: `curve c(v) in xy = …`, and write `c.x(…)`",
            "",
        ),
    ]);
}

#[test]
fn names_of_constructions_are_checked_used_or_not() {
    hold(&[
        (
            Code::E0101,
            "construction f(p) = p(u) + nosuch(v) k\nsurface R = (u, v, 0)",
            "`nosuch` is not declared\n --> test.sweep:1:28",
            "",
        ),
        (
            Code::E0101,
            "construction f(factor) = q k\n  where q = factr u,\n        r = v\nsurface R = (u, v, 0)",
            "did you mean `factor`?",
            "construction f(factor) = q k\n  where q = factor u,\n        r = v\nsurface R = (u, v, 0)",
        ),
        // once, however often it is used
        (
            Code::E0101,
            "construction f(a) = (u, v, a no_such.x)\nsurface R = f(1)\nsurface S = f(2)",
            "`no_such` is not declared\n --> test.sweep:1:30",
            "",
        ),
    ]);
    let sound =
        "construction f(p, q) = turn(p).x k + p.x(u) i + q'(v) + r + length(p) a * dot(i, q(v)) k
  where r = q.n(v)
construction g(p) = f(p, p) + h(p)
construction h(p) = p(u)
let a = 2
surface R = (u, v, 0)";
    assert_eq!(compile(sound).codes(), []);
}
