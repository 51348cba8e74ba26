//! What is often written instead.

use sweepc::diag::{Code, Diagnostics, Severity};

use crate::{one, parsed};

/// The code, the text with the place that the finding marks, and words of the finding.
const SLIPS: &[(Code, &str, &str)] = &[
    (Code::E0007, "let a = «1,5»", "write `1.5`"),
    (Code::E0007, "let f(u) = 2 u + «1,5»", "comma"),
    (Code::E0007, "expect a == «0,25»", "write `0.25`"),
    (
        Code::E0007,
        "construction f(p) = q where q = «1,5»",
        "write `1.5`",
    ),
    (Code::E0006, "let a = 1«,» 5", "a point is written `(a, b)`"),
    (Code::E0008, "let a = 1 «000»", "digits are not grouped"),
    (Code::E0008, "let a = u «2»", "put the number first"),
    (Code::E0008, "let a = (u) «2»^3", "`2`"),
    (Code::E0008, "let a = u^2 «3»", "`3`"),
    (Code::E0008, "let a = «0 x»", "decimal"),
    (Code::E0008, "let a = «0x1F»", "decimal"),
    (Code::E0009, "let a = u^«+»2", "no `+`"),
    (Code::E0009, "let a = u^«-»n", "parentheses"),
    (Code::E0009, "let a = u^«-»2^2", "two ways"),
    (Code::E0009, "let a = u^«(»1, 2)", "not an exponent"),
    (Code::E0009, "let a = u^«c».x", "an integer"),
    (Code::E0009, "let a = u^«f»'", "an integer"),
    (
        Code::E0006,
        "let a = u^«*»",
        "expected an exponent, found `*`",
    ),
    (
        Code::E0006,
        "let a «3»",
        "expected `=`, found `3`; write `=`",
    ),
    (Code::E0006, "profile p(u) «xy» = q", "write `in xy`"),
    (Code::E0006, "let a «==» 3", "write `=`"),
    (Code::E0006, "expect a «=» 3", "write `==`"),
    (Code::E0006, "expect a «= =» 3", "write `==`"),
    (
        Code::E0006,
        "expect a «=>» 3",
        "compares with `>=`, found `=>`; write `>=`",
    ),
    (Code::E0006, "expect a «=<» 3", "write `<=`"),
    (Code::E0006, "let a = «=» 3", "one `=`"),
    (Code::E0006, "let a = u «**» 2", "`^`"),
    (Code::E0006, "let a = u * «*» 2", "`^`"),
    (Code::E0006, "let a = 1«;»\nlet b = 2", "no `;`"),
    (
        Code::E0006,
        "let a = 2\n«c»(v) in xy = q",
        "found `c`; every declaration begins with a keyword",
    ),
    (
        Code::E0006,
        "expect a == 2\n«f»(1) < 3",
        "found `f`; write `expect` in front",
    ),
    (Code::E0006, "profile p(u) = («start:» 2)", "no function"),
    (
        Code::E0006,
        "let a = (1«;» 2)",
        "expected `)`, found `;`; write `,` between entries",
    ),
    (Code::E0006, "let a = f([1«;» 2])", "between entries"),
    (Code::E0006, "sweep c(v) on [0«;» 1] = q", "between entries"),
    (Code::E0006, "let a = (1«;»)", "no `;`"),
    (Code::E0006, "sweep c(v) on [0, 1«)» = q", "closed"),
    (Code::E0006, "sweep c(v) on «(»0, 1) = q", "closed"),
    (Code::E0006, "sweep c(v) on [0, 1«,» 2] = q", "two ends"),
    (Code::E0006, "sweep c(v) in «zx» = q", "a plane"),
    (Code::E0006, "sweep c(v) on [0, 1] «in xy» = q", "before"),
    (Code::E0006, "sweep c(v) on [0, 1] on «[0, 2]» = q", "twice"),
    (Code::E0006, "sweep c «=» q", "the parameter of the curve"),
    (Code::E0006, "surface R«(»u, v) = q", "no parameter list"),
    (Code::E0006, "surface R on [0, 1] «=» q", "expected `x`"),
    (
        Code::E0006,
        "surface R on [0, 1] «*» [0, 1] = q",
        "expected `x`",
    ),
    (Code::E0006, "surface R = q «where» q = 1", "construction"),
    (
        Code::E0006,
        "let a = 1 «on» [0, 1]",
        "unexpected keyword `on`; `on` stands before the `=`",
    ),
    (
        Code::E0006,
        "construction f «=» q",
        "the parameters of the construction",
    ),
    (
        Code::E0006,
        "construction f(«)» = q",
        "expected a name, found `)`",
    ),
    (
        Code::E0006,
        "construction f(p) = q where q«(»v) = 1",
        "takes no parameters",
    ),
    (Code::E0006, "let a = «+»1", "leading `+`"),
    (Code::E0006, "let a = 1 /«/» text", "`#`"),
    (
        Code::E0006,
        "«//» text",
        "unexpected `//`; a comment begins with `#`",
    ),
    (Code::E0006, "«/*» text */\nlet a = 1", "`#`"),
    (Code::E0006, "«/» 2", "unexpected `/`"),
    (Code::E0006, "let a = (1, «)»", "remove the comma"),
    (Code::E0006, "let a = f(b«]»", "expected `)`, found `]`"),
    (Code::E0006, "let a = b«)»", "closes nothing"),
    (Code::E0006, "let a = «[»1, 2]", "list"),
    (Code::E0006, "let a = b «[»1]", "list"),
    (Code::E0006, "let a = f([«[»1, 2]])", "list"),
    (Code::E0006, "let a = «\"b\"»", "string"),
    (Code::E0006, "let a = b «\"b\"»", "unexpected string"),
    (Code::E0006, "import «'»a'", "double quotes"),
    (
        Code::E0006,
        "sweep c(v) in xy = ph_hermite(a, b, branch: «+-»)",
        "write `\"+-\"`",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy = ph_hermite(branch: «−−», a, b)",
        "write `\"--\"`",
    ),
    (Code::E0006, "unit «in»", "inch"),
    (Code::E0006, "let a = (b)«'»", "behind a name"),
    (Code::E0006, "let a = n(v)«'»", "`f'(v)`"),
    (Code::E0006, "expect a == b «==» c", "one relation"),
    (Code::E0006, "let a = b«:»", "unexpected `:`"),
    (Code::E0006, "«b» = 2", "`let`"),
    (Code::E0006, "«proflie» p(u) = (u, u)", "write `profile`"),
    (Code::E0006, "let a = 1\n«surfce» R = a", "write `surface`"),
    (
        Code::E0006,
        "let a = 1\n«proflie» p(u) in xz = a",
        "write `profile`",
    ),
    (Code::E0006, "let a = 1\n«imprt» \"b\"", "write `import`"),
    (Code::E0006, "let a = 1\n«b» = a", "`let`"),
    (Code::E0006, "let «=» 2", "expected a name, found `=`"),
    (Code::E0006, "let a = c.«2»", "expected a name, found `2`"),
    (Code::E0006, "let a =«»", "write the value behind the `=`"),
    (
        Code::E0006,
        "let a«» # 3\n\n\n",
        "expected `=`, found the end of the declaration; write `let a = 1`",
    ),
    (
        Code::E0006,
        "param r«»\nlet b = 2",
        "write `param r = 1`, or another value",
    ),
    (
        Code::E0006,
        "let a =«»\nparam r = 2",
        "expected an expression, found the end of the declaration",
    ),
    (
        Code::E0006,
        "sweep c(v) in xy«»\n# the surface\nsurface R = c(v) + u k",
        "write `=` and the value",
    ),
    (
        Code::E0006,
        "import«»\nlet b = 2",
        "expected a string, found the end of the declaration",
    ),
    (Code::E0006, "profile p(u)\n  «xz» = q", "write `in xz`"),
    (
        Code::E0006,
        "let a\n  «b» + 2",
        "write `=` before the value",
    ),
    // on one line the keyword may be a word too many
    (
        Code::E0006,
        "let a = 2 + «let» b = 2",
        "expected an expression, found the keyword `let`",
    ),
];

#[test]
fn common_slips_have_clear_messages() {
    for (code, marked, words) in SLIPS {
        one(*code, marked, words);
    }
}

#[test]
fn keywords_are_never_names() {
    for marked in [
        "let «in» = 3",
        "let «unit» = 3",
        "param «where» = 3",
        "profile «curve»(u) = q",
        "let a = 2 * «on» + 1",
        "let a = f(«curve»)",
        "let f(«in») = 1",
        "let a = c.«sweep»(v)",
        "let a = f(«unit»: 3)",
    ] {
        one(Code::E0103, marked, "is a keyword and cannot be a name");
    }
}

#[test]
fn quotients_before_a_juxtaposed_factor_warn() {
    one(
        Code::W1001,
        "let f(u) = a/«b c»",
        "`a/b c` means `(a/b) c`; write `(a/b) c` or `a/(b c)`",
    );
    one(Code::W1001, "let f(u) = x(u)/«2 n(v)»", "means");
    one(Code::W1001, "let f(u) = 1/«a b» d", "means");
    one(Code::W1001, "let f(u) = 1/«2^2 b»", "means");
    one(
        Code::W1001,
        &format!("let f(u) = a/«b {}»", "c".repeat(80)),
        "multiplies it",
    );
    for quiet in [
        "1/2u",
        "-1/2u",
        "1/2(u)",
        "a/b * c",
        "(a/b) c",
        "a/(b c)",
        "a b/c",
        "a * 1/2 u",
    ] {
        let (_, diagnostics) = parsed(&format!("let f(u) = {quiet}"));
        assert_eq!(diagnostics, Diagnostics::default(), "{quiet}");
    }
    assert_eq!(Code::W1001.severity(), Severity::Warning);
}
