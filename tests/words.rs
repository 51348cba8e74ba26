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
