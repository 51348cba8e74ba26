//! A fix is an edit that can be applied unread: what it repairs is gone, and nothing new is wrong.

#![allow(clippy::unwrap_used, reason = "shared modules of the tests need it")]

mod example_files;
mod support;

use std::collections::BTreeSet;
use std::fs;

use sweepc::diag::{Code, Diagnostic, Severity};

use support::{Compiled, Random, compile};

/// The code, a text with one error (or warning), and the text that its fix makes of it.
const CASES: &[(Code, &str, &str)] = &[
    // characters
    (
        Code::E0002,
        "surface R = (u, v, √2.25 u)",
        "surface R = (u, v, sqrt(2.25) u)",
    ),
    (
        Code::E0002,
        "surface R = (u, v, √((1 + u)^2))",
        "surface R = (u, v, sqrt((1 + u)^2))",
    ),
    (
        Code::E0002,
        "surface R = (u, v, ½ u)",
        "surface R = (u, v, (1/2) u)",
    ),
    (
        Code::E0003,
        "surface R = (u, v, (u + v)²)",
        "surface R = (u, v, (u + v)^2)",
    ),
    (
        Code::E0003,
        "surface R = (u, v, u\u{2010}v)",
        "surface R = (u, v, u-v)",
    ),
    (
        Code::E0003,
        "surface R = (\u{1d462}, v, 0)",
        "surface R = (u, v, 0)",
    ),
    (
        Code::E0003,
        "surface R = (u, v,\u{a0}0)",
        "surface R = (u, v, 0)",
    ),
    (
        Code::E0004,
        "surface R = (u, v, 2. u)",
        "surface R = (u, v, 2 u)",
    ),
    (
        Code::E0007,
        "surface R = (u, v, 0)\nlet a = 1,5",
        "surface R = (u, v, 0)\nlet a = 1.5",
    ),
    (
        Code::E0106,
        "surface R = (u, v, 1,5)",
        "surface R = (u, v, 1.5)",
    ),
    // two points without their parentheses, perhaps
    (
        Code::E0106,
        "curve c(v) in xy = bezier([(1,2, 3,4), (5, 6)])\nsurface R = (u, v, 0)",
        "",
    ),
    // brackets
    (
        Code::E0006,
        "sweep c(v) in xy = line[(0, 0), (3, 4))\nsurface R = c(v) + u k",
        "",
    ),
    (
        Code::E0006,
        "surface R = (u, v, 0]",
        "surface R = (u, v, 0)",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy = bezier([(0, 0), (3, 4))\nsurface R = c(v) + u k",
        "sweep c(v) in xy = bezier([(0, 0), (3, 4)])\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "surface R = (u, v, 0, )",
        "surface R = (u, v, 0 )",
    ),
    // separators
    (
        Code::E0006,
        "surface R = (u; v; 0)",
        "surface R = (u, v, 0)",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy on [0, 2] = bezier([(0, 0); (3; 4)], weights: [1; 2])\nsurface R = c(v) + u k",
        "sweep c(v) in xy on [0, 2] = bezier([(0, 0), (3, 4)], weights: [1, 2])\nsurface R = c(v) + u k",
    ),
    // signs
    (
        Code::E0006,
        "surface R == (u, v, 0)",
        "surface R = (u, v, 0)",
    ),
    (
        Code::E0006,
        "surface R = = (u, v, 0)",
        "surface R = (u, v, 0)",
    ),
    (
        Code::E0006,
        "surface R := (u, v, 0)",
        "surface R = (u, v, 0)",
    ),
    (Code::E0006, "surface R (u, v, 0)", ""),
    (
        Code::E0006,
        "surface R = (u, v, u**2)",
        "surface R = (u, v, u^2)",
    ),
    (
        Code::E0006,
        "surface R = (u, v, u * * 2)",
        "surface R = (u, v, u ^ 2)",
    ),
    (
        Code::E0006,
        "surface R = (u, v, .5 u)",
        "surface R = (u, v, 0.5 u)",
    ),
    (
        Code::E0006,
        "surface R = (+u, v, 0)",
        "surface R = (u, v, 0)",
    ),
    (
        Code::E0006,
        "surface R = (u, v, 0) // flat",
        "surface R = (u, v, 0) # flat",
    ),
    (
        Code::E0006,
        "// a flat surface\nsurface R = (u, v, 0)",
        "# a flat surface\nsurface R = (u, v, 0)",
    ),
    (
        Code::E0006,
        "surface R = (u, v, 0);",
        "surface R = (u, v, 0)",
    ),
    (
        Code::E0006,
        "surface R = (u, v, 0)\nexpect bidegree(R) = (1, 1)",
        "surface R = (u, v, 0)\nexpect bidegree(R) == (1, 1)",
    ),
    (
        Code::E0006,
        "sweep c(v) = (v, v^2, 0)\nsurface R = c(v)' + u k",
        "sweep c(v) = (v, v^2, 0)\nsurface R = c'(v) + u k",
    ),
    // keywords
    (Code::E0006, "surfce R = (u, v, 0)", "surface R = (u, v, 0)"),
    (
        Code::E0101,
        "let raduis = 2\nsurface R = (u, v, radius u + radius)",
        "let radius = 2\nsurface R = (u, v, radius u + radius)",
    ),
    (
        Code::E0101,
        "surface R = (u, v, 0)\nexpct regular(R)",
        "surface R = (u, v, 0)\nexpect regular(R)",
    ),
    (
        Code::E0006,
        "unitt mm\nsurface R = (u, v, 0)",
        "unit mm\nsurface R = (u, v, 0)",
    ),
    (
        Code::E0006,
        "construction f(p) = q p(u) whre q = v\nprofile p(u) in xy = (u, 1)\nsurface R = f(p) + v k",
        "construction f(p) = q p(u) where q = v\nprofile p(u) in xy = (u, 1)\nsurface R = f(p) + v k",
    ),
    (Code::E0006, "a = 1/2\nsurface R = (u, v, 0)", ""),
    (
        Code::E0006,
        "a = 2\nsurface R = (u, v, a)",
        "let a = 2\nsurface R = (u, v, a)",
    ),
    (
        Code::E0006,
        "surface R = (u, v, a)\nlet a = 2\nR(0, 0) == (0, 0, a)",
        "surface R = (u, v, a)\nlet a = 2\nexpect R(0, 0) == (0, 0, a)",
    ),
    // curves and their domains
    (
        Code::E0006,
        "sweep c(v) xy = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c(v) inn xy = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c(v) in XY = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy om [0, 2] = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy on [0, 2] = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c(v) on [0, 2] in xy = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy on [0, 2] = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy on (0, 2) = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy on [0, 2] = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy on [0, 2) = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy on [0, 2] = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy on [0, 2 = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy on [0, 2] = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c in xy = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "surface R(u, v) = (u, v, 0)",
        "surface R = (u, v, 0)",
    ),
    (
        Code::E0006,
        "surface R on [0, 1] * [0, 2] = (u, v, 0)",
        "surface R on [0, 1] x [0, 2] = (u, v, 0)",
    ),
    (
        Code::E0006,
        "surface R on [0, 1], [0, 2] = (u, v, 0)",
        "surface R on [0, 1] x [0, 2] = (u, v, 0)",
    ),
    (
        Code::E0205,
        "sweep c(v) in xy on [2, 1/2] = (v, 1)\nsurface R = c(v) + u k",
        "sweep c(v) in xy on [1/2, 2] = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy = ph_hermite((0, 0), (0, 4), (2, 2), (4, 0), branch: ++)\nsurface R = c(v) + u k",
        "sweep c(v) in xy = ph_hermite((0, 0), (0, 4), (2, 2), (4, 0), branch: \"++\")\nsurface R = c(v) + u k",
    ),
    // products and powers
    (
        Code::E0008,
        "surface R = (u, v, u 2)",
        "surface R = (u, v, u * 2)",
    ),
    (
        Code::E0008,
        "surface R = (u, v, 0x1F u)",
        "surface R = (u, v, 31 u)",
    ),
    (
        Code::E0008,
        "sweep c(v) in xy = bezier([(0, 0), (3, 4)], weights: [1 2])\nsurface R = c(v) + u k",
        "sweep c(v) in xy = bezier([(0, 0), (3, 4)], weights: [1, 2])\nsurface R = c(v) + u k",
    ),
    (
        Code::E0106,
        "sweep c(v) in xy = bezier([(0, 0) (3, 4)])\nsurface R = c(v) + u k",
        "sweep c(v) in xy = bezier([(0, 0), (3, 4)])\nsurface R = c(v) + u k",
    ),
    (
        Code::E0009,
        "surface R = (u, v, u^+2)",
        "surface R = (u, v, u^2)",
    ),
    // outside of a list nothing says that a comma is missing
    (
        Code::E0106,
        "let a = (1, 0, 0) (0, 1, 0)\nsurface R = (u, v, 0)",
        "",
    ),
    (
        Code::E0009,
        "let m = 2\nsurface R = (u, v, (1 + u)^-m)",
        "let m = 2\nsurface R = (u, v, (1 + u)^(-m))",
    ),
    (
        Code::E0009,
        "surface R = (u, v, (9/4)^(1/2))",
        "surface R = (u, v, sqrt(9/4))",
    ),
    (
        Code::E0009,
        "surface R = (u, v, ((1 + u)^2)^0.5)",
        "surface R = (u, v, sqrt(((1 + u)^2)))",
    ),
    (
        Code::W1001,
        "surface R = (u, v, u/(1 + u) v)",
        "surface R = (u, v, (u/(1 + u)) v)",
    ),
    // names
    (
        Code::E0101,
        "let radius = 2\nsurface R = (u, v, raduis)",
        "let radius = 2\nsurface R = (u, v, radius)",
    ),
    (
        Code::E0101,
        "sweep c(v) in xy = line((0, 0), (3, 4))\nsurface R = c(v) + u k\nexpect lenght(c) == 5",
        "sweep c(v) in xy = line((0, 0), (3, 4))\nsurface R = c(v) + u k\nexpect length(c) == 5",
    ),
    (
        Code::E0101,
        "sweep c(v) in xy = line((0, 0), (3, 4))\nsurface R = c(v) + u k\nexpect sigm(v) == 5",
        "sweep c(v) in xy = line((0, 0), (3, 4))\nsurface R = c(v) + u k\nexpect sigma(v) == 5",
    ),
    (
        Code::E0101,
        "surface R = (u, v, 0)\nexpect bidegre(R) == (1, 1)",
        "surface R = (u, v, 0)\nexpect bidegree(R) == (1, 1)",
    ),
    (
        Code::E0101,
        "unit millimetre\nsurface R = (u, v, 0)",
        "unit mm\nsurface R = (u, v, 0)",
    ),
    (
        Code::E0101,
        "unit MM\nsurface R = (u, v, 0)",
        "unit mm\nsurface R = (u, v, 0)",
    ),
    (
        Code::E0105,
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u n(0) + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u c.n(0) + u k",
    ),
    (
        Code::E0105,
        "sweep c(v) in xy = (v, 1)\nconstruction f(q) = q(v) + u n(v)\nsurface R = f(c)",
        "sweep c(v) in xy = (v, 1)\nconstruction f(q) = q(v) + u q.n(v)\nsurface R = f(c)",
    ),
    (
        Code::E0107,
        "surface R = (u, v, 0)\nexpect regular(R) == true",
        "surface R = (u, v, 0)\nexpect regular(R)",
    ),
    (
        Code::E0107,
        "surface R = (u, v, 0)\nexpect regulr(R)",
        "surface R = (u, v, 0)\nexpect regular(R)",
    ),
    (
        Code::E0107,
        "sweep c(v) in xy = ph(strat: (0, 0), preimage: [(1, 0)])\nsurface R = c(v) + u k",
        "sweep c(v) in xy = ph(start: (0, 0), preimage: [(1, 0)])\nsurface R = c(v) + u k",
    ),
    (
        Code::E0107,
        "sweep c(v) in xy = (v, 1)\nsurface R = c(at: v) + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u k",
    ),
    (
        Code::E0107,
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u c.n + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u c.n(v) + u k",
    ),
    (
        Code::E0109,
        "let f(v, u) = u - 2 v\nsurface R = (u, v, f(u, v))",
        "let f(u, v) = u - 2 v\nsurface R = (u, v, f(u, v))",
    ),
    (
        Code::E0111,
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u c.normal(v) + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u c.n(v) + u k",
    ),
    (
        Code::E0111,
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u c.kapa(v) k + u k",
        "sweep c(v) in xy = (v, 1)\nsurface R = c(v) + u c.kappa(v) k + u k",
    ),
    (
        Code::E0111,
        "surface R = (u, v, 0)\nexpect bidegree(R.w) == (0, 0)",
        "surface R = (u, v, 0)\nexpect bidegree(R.W) == (0, 0)",
    ),
    // exchanged arguments
    (
        Code::E0201,
        "profile p(u) in xz = (u, u^2)\nsweep c(v) in xy = (v, 1)\nsurface R = oriented_translation(c, p)",
        "profile p(u) in xz = (u, u^2)\nsweep c(v) in xy = (v, 1)\nsurface R = oriented_translation(p, c)",
    ),
];

/// Cases whose slip has no certain repair, so that no fix is offered; the texts above that are
/// followed by an empty one.
fn has_no_certain_repair(fixed: &str) -> bool {
    fixed.is_empty()
}

fn applied(text: &str, finding: &Diagnostic) -> Option<String> {
    let fix = finding.fix.as_ref()?;
    let mut fixed = text.to_owned();
    fixed.replace_range(fix.span.range(), &fix.text);
    Some(fixed)
}

fn errors(compiled: &Compiled) -> usize {
    compiled.compilation.diagnostics.errors().count()
}

#[test]
fn a_fix_repairs_its_finding() {
    let mut wrong = Vec::new();
    for (code, text, expected) in CASES {
        let compiled = compile(text);
        let mut findings = compiled.compilation.diagnostics.iter();
        let Some(finding) = findings.find(|own| own.code == *code) else {
            wrong.push(format!("no {code} in {text}\n{}", compiled.all()));
            continue;
        };
        let fixed = applied(text, finding);
        let expected = (!has_no_certain_repair(expected)).then_some(*expected);
        if fixed.as_deref() != expected {
            wrong.push(format!("{text}\nbecomes {fixed:?}\n{}", compiled.all()));
        } else if let Some(fixed) = fixed {
            let again = compile(&fixed);
            if !again.codes().is_empty() {
                wrong.push(format!("{fixed}\n{}", again.all()));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{} fail\n{}",
        wrong.len(),
        wrong.join("\n\n")
    );
}

/// Also where the fix is that of a page's failing example.
#[test]
fn the_fixes_of_the_pages_repair_their_findings() {
    let mut offered = 0;
    for code in Code::ALL {
        let block = code.explanation().split("```sweep fails\n").nth(1);
        let Some(text) = block.and_then(|rest| rest.split("```").next()) else {
            continue;
        };
        let compiled = compile(text);
        for finding in compiled.compilation.diagnostics.iter() {
            let Some(fixed) = applied(text, finding) else {
                continue;
            };
            offered += 1;
            let again = compile(&fixed);
            assert!(!again.codes().contains(code), "{fixed}\n{}", again.all());
        }
    }
    assert!(offered >= 10, "{offered}");
}

/// How many slips are tried.
const SLIPS: usize = 800;
/// How many of them must be offered a fix for the test to say something.
const FIXED: usize = 300;

/// Kinds of slips in signs: what stands in a text, and what is written instead.
const SIGNS: [(&[&str], &[&str]); 9] = [
    (&["^2", "^3"], &["²", "**2", "^+2"]),
    (&[" = ", " == ", " ("], &[" == ", " = ", " := ", "  "]),
    (&["), ("], &[") ("]),
    (&["c"], &["с"]),
    (&["x"], &["х"]),
    (&["a"], &["а"]),
    (&["-"], &["–", "\u{2010}"]),
    (&["]", ")", "[", "("], &["]", ")", "[", "(", " "]),
    (&[" in ", " on "], &[" im ", " om ", " "]),
];

/// A random entry.
fn chosen<T: Copy>(random: &mut Random, list: &[T]) -> Option<T> {
    let bound = u64::try_from(list.len()).ok().filter(|own| *own > 0)?;
    let index = usize::try_from(random.next(bound)).ok()?;
    list.get(index).copied()
}

/// A letter of a word is left out, doubled or exchanged with the next one: where, how many bytes,
/// and what stands there instead.
fn letter_slip(random: &mut Random, text: &str) -> Option<(usize, usize, String)> {
    let pairs = text.as_bytes().windows(2).enumerate();
    let pairs = pairs.filter(|(_, pair)| pair.iter().all(u8::is_ascii_lowercase));
    let places: Vec<usize> = pairs.map(|(at, _)| at).collect();
    let at = chosen(random, &places)?;
    let two = text.get(at..at + 2)?;
    let (first, second) = two.split_at(1);
    let doubled = [first, two].concat();
    let exchanged = [second, first].concat();
    let with = chosen(random, &[second, doubled.as_str(), exchanged.as_str()])?;
    Some((at, 2, with.to_owned()))
}

/// A sign is exchanged with another one.
fn sign_slip(random: &mut Random, text: &str) -> Option<(usize, usize, String)> {
    let (from, to) = chosen(random, &SIGNS)?;
    let found = from
        .iter()
        .flat_map(|own| text.match_indices(own).map(|(at, own)| (at, own.len())));
    let (at, length) = chosen(random, &found.collect::<Vec<_>>())?;
    Some((at, length, chosen(random, to)?.to_owned()))
}

/// A text with one small slip in it, and what it is; none where the slip changes nothing.
fn slipped(random: &mut Random, text: &str) -> Option<(String, String)> {
    let (at, length, with) = match random.next(2) {
        0 => letter_slip(random, text),
        _ => sign_slip(random, text),
    }?;
    let what = format!("at {at}: `{}` -> `{with}`", &text[at..at + length]);
    let mut slipped = text.to_owned();
    slipped.replace_range(at..at + length, &with);
    (slipped != text).then_some((slipped, what))
}

#[test]
fn no_fix_makes_more_errors() -> Result<(), std::io::Error> {
    let known: BTreeSet<Code> = CASES.iter().map(|(code, ..)| *code).collect();
    let mut texts = Vec::new();
    for path in example_files::sweeps(&example_files::folder()) {
        let text = fs::read_to_string(&path)?;
        // Those that import another file do not stand alone.
        if errors(&compile(&text)) == 0 {
            texts.push((example_files::name(&path), text));
        }
    }
    let mut random = Random(20_261);
    let (mut offered, mut worse) = (0, Vec::new());
    for round in 0..SLIPS {
        let (name, text) = &texts[round % texts.len()];
        let Some((slipped, what)) = slipped(&mut random, text) else {
            continue;
        };
        let compiled = compile(&slipped);
        let before = errors(&compiled);
        for finding in compiled.compilation.diagnostics.iter() {
            let Some(fixed) = applied(&slipped, finding) else {
                continue;
            };
            offered += 1;
            assert!(known.contains(&finding.code), "no case of {}", finding.code);
            let after = compile(&fixed);
            let error = finding.severity() == Severity::Error;
            let repeated = error && fixed == *text && errors(&after) > 0;
            if errors(&after) > before || repeated {
                let (finding, all) = (compiled.render(finding), after.all());
                worse.push(format!("{name}, {what}\n{finding}\nthen\n{all}"));
            }
        }
    }
    assert!(
        worse.is_empty(),
        "{} of {offered}\n{}",
        worse.len(),
        worse.join("\n\n")
    );
    assert!(offered >= FIXED, "{offered}");
    Ok(())
}
