//! What the canonical layout is.

use sweepc::syntax::Spelling;

use crate::{formatted, spelled};

const UGLY: &str = "\u{feff}\r\n\r\n#  first   \r\n\r\n\r\n\r
unit   mm\rparam a=1/2# half
param longer = 3 #three
let f( u ,v )=a*u+2 v -  3u^ 2 / 4
let w=-a(1-u)^2 / longer (u)
profile\tp ( u )in xz on[0,1]=((1−u^2)/(1+u^2),2u/(1+u^2)) sweep # of the way
   c(v) in xy=ph(start:(0,0),preimage:[(2,2),(2,1),(3,1/2)])

curve long_name(v) = bezier([(1/2, 0, 0), (1/3, 1/4, 1/5), (1/6, 1/7, 1/8), (1/9, 1/10, 1/11), (1/12, 1, 0)], weights: [1, 2, 3])
construction g(p,c,h)=c(v)+q(p.x(u)c.n(v)+p.z(u)k)+h (1)+h(2) where q=1 , # one
# own
second=2·q
surface R on[0,1]×[0,2]=c(v)+x(u)n(v)+z(u)k + 1000000000 sigma(v) n(v) + 1000000000 c.κ’’(v) n(v) + c.κ″(v) n(v)
expect bidegree(R)==(2,


9) # as printed
# the end


   # very end";

#[test]
fn an_ugly_file_is_made_readable() {
    let own = formatted(UGLY);
    insta::assert_snapshot!("ugly", own);
    assert_eq!(formatted(&own), own);
}

#[test]
fn a_star_is_written_where_a_name_multiplies_a_parenthesis() {
    for (text, expected) in [
        ("let q(v) = 1 + 2 v (1 - v)", "let q(v) = 1 + 2v * (1 - v)"),
        ("let q(u) = u(1 - u)^2 u", "let q(u) = u * (1 - u)^2 u"),
        ("let q(u) = 1/u(1 - u)", "let q(u) = 1 / u * (1 - u)"),
        ("let q(u) = 2 * -u(1 - u)", "let q(u) = 2 * -u * (1 - u)"),
        // divides by the whole
        ("let q(u) = 2 / -u(1 - u)", "let q(u) = 2 / -u * (1 - u)"),
        ("let q(u) = i (u).x", "let q(u) = i * (u).x"),
        ("let q(u) = x (u)", "let q(u) = x(u)"),
        ("let q(u) = turn (u)", "let q(u) = turn(u)"),
        (
            "let q(u) = unknown (u) + unknown(u)",
            "let q(u) = unknown (u) + unknown(u)",
        ),
        (
            "construction q(a) = a (u) + b (u)\n  where b = 1",
            "construction q(a) = a (u) + b * (u)\n  where b = 1",
        ),
    ] {
        assert_eq!(formatted(text), format!("{expected}\n"));
    }
    let text = "let a = 2\nlet b(u) = a (u)\n\nlet c(u) = b (u) + c.σ (u)";
    let expected = "let a    = 2\nlet b(u) = a * (u)\n\nlet c(u) = b(u) + c.σ(u)\n";
    assert_eq!(formatted(text), expected);
}

#[test]
fn names_behind_where_stand_below_each_other() {
    let text = "construction f(p) = p(u) + q v k where # y\nq = 3, # z\nlonger = 4";
    let expected = [
        "construction f(p) = p(u) + q v k",
        "  where              # y",
        "        q      = 3,  # z",
        "        longer = 4",
    ];
    let expected = expected.map(|line| format!("{line}\n")).concat();
    assert_eq!(formatted(text), expected);
    assert_eq!(formatted(&expected), expected);
    let text =
        "construction f(p) = p(u) + q v k\n  # x\n  where q = 3,\n        # z\n        r = 4\n";
    assert_eq!(formatted(text), text);
}

#[test]
fn one_spelling_can_be_asked_for() {
    let text = "surface R on [0, 1] x [0, 1] = c.sigma'(v) + ϰ(v) + rho″(u) + σ1 + µ\n";
    let ascii = "surface R on [0, 1] x [0, 1] = c.sigma'(v) + kappa(v) + rho''(u) + σ1 + μ\n";
    let unicode = "surface R on [0, 1] × [0, 1] = c.σ'(v) + κ(v) + ρ''(u) + σ1 + μ\n";
    let kept = text.replace('″', "''");
    assert_eq!(spelled(text, Spelling::AsWritten), kept);
    assert_eq!(spelled(text, Spelling::Ascii), ascii);
    assert_eq!(spelled(text, Spelling::Unicode), unicode);
    assert_eq!(spelled(ascii, Spelling::Unicode), unicode);
}

#[test]
fn what_tokens_would_become_together_stays_apart() {
    for text in ["let a = 2 .x\n", "let a = 2 e\n", "let a = 2 e5\n"] {
        assert_eq!(formatted(text), text);
    }
}

#[test]
fn long_lines_are_broken() {
    let terms = ["first_name * second_name"; 8].join(" + ");
    let own = formatted(&format!("let sum = {terms}\nexpect f({terms}) == 0"));
    assert!(own.lines().all(|line| line.chars().count() <= 100), "{own}");
    assert_eq!(formatted(&own), own);
    insta::assert_snapshot!("long", own);
}

#[test]
fn an_empty_file_stays_empty() {
    assert_eq!(formatted(""), "");
    assert_eq!(formatted("\u{feff}\r\n"), "");
    assert_eq!(formatted("\n\n# a \n\n\n\n# b"), "# a\n\n# b\n");
}
