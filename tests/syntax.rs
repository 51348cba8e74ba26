//! The grammar, production by production; every diagnostic with its place; recovery and limits.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on has failed"
)]

mod syntax_support;

use proptest::prelude::*;
use sweepc::diag::{Code, Diagnostics, FileId, Limits, Severity, SourceMap, Style, render_text};
use sweepc::syntax::ast::{Declaration, Document, ExprKind, Sign};
use sweepc::syntax::lexer::Keyword;
use sweepc::syntax::{canonical_name, decode, parse};
use syntax_support::{show_document, show_expression};

const FILE: FileId = FileId(0);

fn parsed(text: &str) -> (Document, Diagnostics) {
    parsed_within(text, &Limits::default())
}

fn parsed_within(text: &str, limits: &Limits) -> (Document, Diagnostics) {
    let mut diagnostics = Diagnostics::default();
    let document = parse(FILE, text, limits, &mut diagnostics);
    (document, diagnostics)
}

/// The tree of a text without findings.
#[track_caller]
fn tree(text: &str) -> String {
    let (document, diagnostics) = parsed(text);
    let findings: Vec<_> = diagnostics.iter().collect();
    assert!(findings.is_empty(), "{text}: {findings:#?}");
    show_document(&document)
}

/// The tree of an expression, warnings allowed.
#[track_caller]
fn expression(text: &str) -> String {
    let (document, diagnostics) = parsed(&format!("let a = {text}"));
    assert!(!diagnostics.has_errors(), "{text}: {diagnostics:#?}");
    match &document.items[..] {
        [item] => match &item.declaration {
            Declaration::Let { value, .. } => show_expression(value),
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    }
}

/// Codes, marked text and messages of all findings.
fn findings(text: &str) -> Vec<(String, String, String)> {
    let (_, diagnostics) = parsed(text);
    let list = diagnostics.iter().map(|finding| {
        let marked = &text[finding.primary.unwrap().range()];
        let code = finding.code.to_string();
        (code, marked.to_owned(), finding.message.clone())
    });
    list.collect()
}

/// Exactly one finding: its code, its place (between `«` and `»` in the text), words of its message
/// or its help.
#[track_caller]
fn one(code: Code, marked: &str, words: &str) {
    let start = marked.find('«').expect("a mark");
    let end = marked.find('»').expect("a mark") - '«'.len_utf8();
    let text = marked.replace(['«', '»'], "");
    let (_, diagnostics) = parsed(&text);
    let list: Vec<_> = diagnostics.iter().collect();
    let [finding] = list[..] else {
        panic!("{text}: {list:#?}");
    };
    assert_eq!(finding.code, code, "{text}: {finding:#?}");
    let primary = finding.primary.unwrap();
    assert_eq!(
        (primary.file, primary.range()),
        (FILE, start..end),
        "{text}: {finding:#?}"
    );
    let said = format!(
        "{}; {}",
        finding.message,
        finding.help.as_deref().unwrap_or("")
    );
    assert!(said.contains(words), "{text}: {said}");
    let mut sources = SourceMap::default();
    sources.add("a.sweep", text);
    assert!(render_text(finding, &sources, Style::Plain).contains(&finding.message));
}

/// The text after the fix of its only finding.
#[track_caller]
fn fixed(text: &str) -> String {
    let (_, diagnostics) = parsed(text);
    let list: Vec<_> = diagnostics.iter().collect();
    let [finding] = list[..] else {
        panic!("{text}: {list:#?}");
    };
    let fix = finding.fix.as_ref().expect("a fix");
    let mut text = text.to_owned();
    text.replace_range(fix.span.range(), &fix.text);
    text
}

// ---- declarations ----

#[test]
fn the_example_of_the_language_parses() {
    let text = "\
# Oriented-translation sweep
profile p(u) in xz on [0, 1] = ((1 - u^2) / (1 + u^2), 2u / (1 + u^2))
sweep   c(v) in xy on [0, 1] = ph_hermite((0, 0), (0, 4), (2, 2), (4, 0))

surface R = c(v) + x(u) n(v) + z(u) k

expect bidegree(R) == (2, 9)
expect bidegree(R.W) == (2, 4)
";
    assert_eq!(
        tree(text),
        "\
(profile p u xz [0 1] (tuple (/ (group (+ 1 (- (^ u 2)))) (group (+ 1 (^ u 2)))) (_/ 2 u (group (+ 1 (^ u 2))))))
(sweep c v xy [0 1] (apply ph_hermite (tuple 0 0) (tuple 0 4) (tuple 2 2) (tuple 4 0)))
(surface R (+ (apply c v) (_ (apply x u) (apply n v)) (_ (apply z u) k)))
(expect (apply bidegree R) == (tuple 2 9))
(expect (apply bidegree R.W) == (tuple 2 4))
"
    );
}

#[test]
fn every_declaration_parses() {
    for (text, expected) in [
        ("param a = 1", "(param a 1)"),
        ("let a = 1", "(let a 1)"),
        ("let f(u) = u", "(let f u u)"),
        ("let f(u, v) = u v", "(let f u v (_ u v))"),
        ("profile p(u) = q", "(profile p u q)"),
        ("profile p(u) in xy = q", "(profile p u xy q)"),
        ("sweep c(v) on [0, 2] = q", "(sweep c v [0 2] q)"),
        (
            "curve d(v) in yz on [-1, 1/2] = q",
            "(curve d v yz [(+ (- 1)) (/ 1 2)] q)",
        ),
        ("construction k1(p) = p", "(construction k1 p p)"),
        (
            "construction f(p, c) = q r where q = 1, r = (2, 3)",
            "(construction f p c (_ q r) (q 1) (r (tuple 2 3)))",
        ),
        ("surface R = c(v)", "(surface R (apply c v))"),
        (
            "surface R on [0, 1] x [2, 3] = c",
            "(surface R [0 1] [2 3] c)",
        ),
        (
            "surface R on [0, 1] × [2, 3] = c",
            "(surface R [0 1] [2 3] c)",
        ),
        ("surface R on [0,1]x[2,3]=c", "(surface R [0 1] [2 3] c)"),
        ("expect regular(R)", "(expect (apply regular R))"),
        ("expect a == b", "(expect a == b)"),
        ("expect a != b", "(expect a != b)"),
        ("expect a < b", "(expect a < b)"),
        ("expect a <= b", "(expect a <= b)"),
        ("expect a > b", "(expect a > b)"),
        ("expect a >= b", "(expect a >= b)"),
        ("expect -a == (b)", "(expect (+ (- a)) == (group b))"),
        ("import \"a/b c.sweep\"", "(import a/b c.sweep)"),
        ("unit mm", "(unit mm)"),
    ] {
        assert_eq!(tree(text), format!("{expected}\n"), "{text}");
    }
}

#[test]
fn declarations_need_no_separator() {
    let text = "let a = 2 let b = a unit mm expect a == b import \"x\" surface R = a";
    assert_eq!(tree(text).lines().count(), 6);
    assert_eq!(tree(""), "");
    assert_eq!(tree("# nothing"), "");
}

#[test]
fn items_span_from_the_keyword_to_the_last_token() {
    let text = "  let a = 1 # x\n\nexpect (a) == b' # y\nimport \"x\"  ";
    let (document, _) = parsed(text);
    let spans = document.items.iter().map(|item| &text[item.span.range()]);
    let expected = ["let a = 1", "expect (a) == b'", "import \"x\""];
    assert_eq!(spans.collect::<Vec<_>>(), expected);
    let comments = document.comments.iter().map(|span| &text[span.range()]);
    assert_eq!(comments.collect::<Vec<_>>(), ["# x", "# y"]);
}

#[test]
fn header_parts_have_their_places() {
    let text = "profile p(u) in xz on [0, 1 ] = q";
    let (document, _) = parsed(text);
    let Declaration::Curve {
        plane,
        domain,
        parameter,
        ..
    } = &document.items[0].declaration
    else {
        panic!()
    };
    assert_eq!(&text[plane.unwrap().1.range()], "xz");
    assert_eq!(&text[domain.as_ref().unwrap().span.range()], "[0, 1 ]");
    assert_eq!(&text[parameter.span.range()], "u");
    let text = "import  \"a\"";
    let (document, _) = parsed(text);
    let Declaration::Import { path_span, .. } = &document.items[0].declaration else {
        panic!()
    };
    assert_eq!(&text[path_span.range()], "\"a\"");
}

// ---- expressions ----

#[test]
fn precedence_is_the_usual_one() {
    for (text, expected) in [
        ("7", "7"),
        ("1 + 2 - 3", "(+ 1 2 (- 3))"),
        ("-a", "(+ (- a))"),
        ("-a + b", "(+ (- a) b)"),
        ("-a b", "(+ (- (_ a b)))"),
        ("-a^2", "(+ (- (^ a 2)))"),
        ("- -a", "(+ (- (neg a)))"),
        ("a - -b", "(+ a (- (neg b)))"),
        ("a + -b c", "(+ a (_ (neg b) c))"),
        ("2 * -x", "(* 2 (neg x))"),
        ("2 * -x^2", "(* 2 (neg (^ x 2)))"),
        ("a * b / c", "(*/ a b c)"),
        ("a · b × c", "(** a b c)"),
        ("a − b", "(+ a (- b))"),
        ("1/2u", "(/_ 1 2 u)"),
        ("2u", "(_ 2 u)"),
        ("x(u) n(v)", "(_ (apply x u) (apply n v))"),
        ("3 (1 - v)^2 v", "(__ 3 (^ (group (+ 1 (- v))) 2) v)"),
        ("u^2(1 - v)", "(_ (^ u 2) (group (+ 1 (- v))))"),
        ("u^n (1 - v)", "(_ (^ u n) (group (+ 1 (- v))))"),
        ("q(v)(1 - v)", "(_ (apply q v) (group (+ 1 (- v))))"),
        ("(a)(b)", "(_ (group a) (group b))"),
        ("a -b", "(+ a (- b))"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn powers_associate_to_the_right() {
    for (text, expected) in [
        ("2^3^2", "(^ 2 (^ 3 2))"),
        ("a^-2", "(^ a (neg 2))"),
        ("a^−2", "(^ a (neg 2))"),
        ("a^n^-1", "(^ a (^ n (neg 1)))"),
        ("a^(1/2)", "(^ a (group (/ 1 2)))"),
        ("a^(n)^2", "(^ a (^ (group n) 2))"),
        ("a^-2 b", "(_ (^ a (neg 2)) b)"),
        ("a^2 + b^2", "(+ (^ a 2) (^ b 2))"),
        ("f(u)^2", "(^ (apply f u) 2)"),
        ("c.x(u)^2", "(^ (apply c.x u) 2)"),
        ("(a, b).x^2", "(^ (. (tuple a b) x) 2)"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn names_take_qualifiers_primes_and_parentheses() {
    for (text, expected) in [
        ("σ(v)", "(apply σ v)"),
        ("c.sigma(v)", "(apply c.σ v)"),
        ("c.σ'(v)", "(apply c.σ' v)"),
        ("f'(v)", "(apply f' v)"),
        ("f''(v)", "(apply f'' v)"),
        ("f″′’(v)", "(apply f'''' v)"),
        ("f'", "f'"),
        ("f' g", "(_ f' g)"),
        ("R.W", "R.W"),
        ("a.x", "a.x"),
        ("a.x.y", "(. a.x y)"),
        ("c(v).x", "(. (apply c v) x)"),
        ("c(v).x y", "(_ (. (apply c v) x) y)"),
        ("(a + b).x", "(. (group (+ a b)) x)"),
        ("c'(v).x.y", "(. (. (apply c' v) x) y)"),
        ("f()", "(apply f)"),
        ("f (a)", "(apply f a)"),
        ("f(a)(b)", "(_ (apply f a) (group b))"),
        ("f((a, b))", "(apply f (tuple a b))"),
        ("f(a, b)", "(apply f a b)"),
        ("sqrt(2) a", "(_ (apply sqrt 2) a)"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn arguments_take_labels_lists_and_strings() {
    for (text, expected) in [
        ("f(a, branch: best)", "(apply f a branch:best)"),
        ("f(branch: \"+-\")", "(apply f branch:\"+-\")"),
        ("f(\"\")", "(apply f \"\")"),
        (
            "bezier([(0, 0), (1, 2)], weights: [1, 2])",
            "(apply bezier (list (tuple 0 0) (tuple 1 2)) weights:(list 1 2))",
        ),
        ("f([])", "(apply f (list))"),
        (
            "f(knots: [-1, a + b])",
            "(apply f knots:(list (+ (- 1)) (+ a b)))",
        ),
        ("(1,5)", "(tuple 1 5)"),
        ("(1, 2, 3, 4)", "(tuple 1 2 3 4)"),
        ("f(1,5)", "(apply f 1 5)"),
        ("f([1,5])", "(apply f (list 1 5))"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn numbers_are_the_longest_match() {
    for (text, expected) in [
        ("007", "007"),
        ("0.8", "0.8"),
        ("1.5e-3", "1.5e-3"),
        ("1.5e−3", "1.5e-3"),
        ("2e5", "2e5"),
        ("2e+5x", "(_ 2e+5 x)"),
        ("2e", "(_ 2 e)"),
        ("2em", "(_ 2 em)"),
        ("2e + 1", "(+ (_ 2 e) 1)"),
        ("2E5", "(_ 2 E5)"),
        ("1e999999999", "1e999999999"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn names_are_folded() {
    for (written, canonical) in [
        ("sigma", "σ"),
        ("kappa", "κ"),
        ("rho", "ρ"),
        ("µ", "μ"),
        ("ϰ", "κ"),
        ("ϱ", "ρ"),
        ("ϵ", "ε"),
        ("ϕ_1", "φ_1"),
        ("sigma1", "sigma1"),
        ("Γ", "Γ"),
        ("_a9", "_a9"),
        ("λμ", "λμ"),
    ] {
        assert_eq!(expression(written), canonical);
        assert_eq!(canonical_name(written), canonical);
        assert_eq!(
            tree(&format!("param {written} = 1")),
            format!("(param {canonical} 1)\n")
        );
    }
}

#[test]
fn spans_of_expressions_are_exact() {
    let text = "let a = -f'(x, l: 2 ) + (b).x c^-2 # end";
    let (document, _) = parsed(text);
    let Declaration::Let { value, .. } = &document.items[0].declaration else {
        panic!()
    };
    let marked = |span: sweepc::diag::Span| &text[span.range()];
    assert_eq!(marked(value.span), "-f'(x, l: 2 ) + (b).x c^-2");
    let ExprKind::Sum(terms) = &value.kind else {
        panic!()
    };
    assert_eq!(terms[0].0, Sign::Minus);
    assert_eq!(marked(terms[0].1.span), "f'(x, l: 2 )");
    let ExprKind::Apply {
        function,
        arguments,
        parenthesis,
    } = &terms[0].1.kind
    else {
        panic!()
    };
    assert_eq!(marked(function.span), "f'");
    assert_eq!(marked(function.name.span), "f");
    assert_eq!(marked(*parenthesis), "(x, l: 2 )");
    assert_eq!(marked(arguments[1].label.as_ref().unwrap().span), "l");
    let ExprKind::Product(factors) = &terms[1].1.kind else {
        panic!()
    };
    assert_eq!(marked(factors[0].1.span), "(b).x");
    assert_eq!(marked(factors[1].1.span), "c^-2");
}

// ---- characters ----

#[test]
fn marks_and_line_ends_are_accepted() {
    let text = "\u{feff}let a = 1 # c\r\nlet b = 2 # d\rlet c = 3\r\n";
    let (document, diagnostics) = parsed(text);
    assert_eq!(diagnostics, Diagnostics::default());
    assert_eq!(
        show_document(&document),
        "(let a 1)\n(let b 2)\n(let c 3)\n"
    );
    let comments = document.comments.iter().map(|span| &text[span.range()]);
    assert_eq!(comments.collect::<Vec<_>>(), ["# c", "# d"]);
    assert_eq!(document.items[0].span.start, 3);
}

#[test]
fn look_alikes_are_named() {
    for (marked, words) in [
        ("let «с» = 1", "`с` (U+0441) looks like `c`; write `c`"),
        ("let a«х» = 1", "`х` (U+0445) looks like `x`; write `ax`"),
        ("let «ς» = 1", "`ς` (U+03C2) looks like `σ`"),
        ("let «𝜎»a = 1", "(U+1D70E) looks like `σ`; write `σa`"),
        ("let «Ａ» = 1", "(U+FF21) looks like `A`"),
        ("let r«₀» = 1", "(U+2080) looks like `0`; write `r0`"),
        ("let a«é» = 1", "(U+00E9) is not a letter of the language"),
        ("let a«\u{301}» = 1", "U+0301"),
        ("let a«\u{200b}»b = 1", "the invisible character U+200B"),
        ("let a«\u{202e}»b = 1", "the invisible character U+202E"),
        (
            "let a =«\u{2060}» 1",
            "U+2060 has no place in the language; remove it",
        ),
        ("let a = 1 «–» 2", "(U+2013) looks like `-`; write `-`"),
        ("let a = 2 «⋅» 3", "(U+22C5) looks like `*`"),
        ("let a = «（»2)", "(U+FF08) looks like `(`"),
        ("let a =«\u{a0}»1", "the space U+00A0"),
        ("let a = u«²»", "U+00B2"),
        ("let a = «１２»", "(U+FF11) looks like `1`; write `12`"),
        ("let a = 1«２»", "looks like `2`"),
        ("# «\u{202e}» hidden", "U+202E"),
        ("import \"«\u{2066}»\"", "U+2066"),
        ("let a = 1«\u{feff}»", "U+FEFF"),
    ] {
        let marked = marked.replace("«１２»", "«１»２");
        one(Code::E0003, &marked, words);
    }
    assert_eq!(fixed("lеt a = 1"), "let a = 1");
    assert_eq!(fixed("let a\u{200b}b = 1"), "let ab = 1");
    assert_eq!(fixed("let a = u¹⁰"), "let a = u^10");
    assert_eq!(fixed("let a = f‘(u)"), "let a = f'(u)");
    assert_eq!(fixed("expect a ≤ b"), "expect a <= b");
}

#[test]
fn a_repaired_name_is_the_name_that_was_meant() {
    let (document, _) = parsed("lеt х = ѕ");
    assert_eq!(show_document(&document), "(let x s)\n");
}

#[test]
fn other_characters_have_no_place() {
    one(Code::E0002, "let a = 1«\0»", "U+0000");
    one(Code::E0002, "# a «\0»", "U+0000");
    one(Code::E0002, "let a = «$»", "`$` (U+0024)");
    one(Code::E0002, "let a = «{» 1", "brackets");
    one(Code::E0002, "expect a «!» b", "`!=`");
    one(Code::E0002, "let a = «√»2", "sqrt");
    let (_, diagnostics) = parsed("let a\n = \0");
    let note = &diagnostics.iter().next().unwrap().notes;
    assert_eq!(note[..], ["at byte 9".to_owned()]);
}

#[test]
fn malformed_numbers_are_errors() {
    one(Code::E0004, "let a = «1.2.3»", "`1.2.3` is not a number");
    one(Code::E0004, "let a = «1.»", "write `1`");
    one(Code::E0004, "let a = «1.»x", "write `1`");
    one(Code::E0004, "let a = «1..2»", "`1..2`");
    one(Code::E0004, "let a = «1e5.3»", "one decimal point");
    assert_eq!(fixed("let a = 1.5."), "let a = 1.5");
    one(Code::E0006, "let a = «.»5", "`0.5`");
}

#[test]
fn bytes_are_decoded_or_refused() {
    let limits = Limits {
        source: 8,
        ..Limits::default()
    };
    let refused = |bytes: &[u8]| {
        let finding = decode(bytes, "a.sweep", &limits).unwrap_err();
        (finding.code, finding.message)
    };
    assert_eq!(
        decode("\u{feff}σ".as_bytes(), "a", &limits).unwrap(),
        "\u{feff}σ"
    );
    assert_eq!(decode(b"12345678", "a", &limits).unwrap(), "12345678");
    let (code, message) = refused(b"123456789");
    assert_eq!(
        (code, message.as_str()),
        (Code::E0501, "`a.sweep` has 9 bytes, the limit is 8")
    );
    let (code, message) = refused(b"ab\nc\xffd");
    assert_eq!(code, Code::E0001);
    assert_eq!(message, "`a.sweep` is not UTF-8 text: invalid at byte 4");
    for utf16 in [
        &b"\xff\xfel\0"[..],
        b"\xfe\xff\0l",
        b"l\0e\0t\0",
        b"\0l\0e\0t",
    ] {
        assert_eq!(
            refused(utf16),
            (Code::E0001, "`a.sweep` looks like UTF-16".to_owned())
        );
    }
    assert_eq!(decode(b"a\0b", "a", &limits).unwrap(), "a\0b");
}

// ---- slips ----

#[test]
fn common_slips_have_clear_messages() {
    for (code, marked, words) in [
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
        (Code::E0006, "let a = «=» 3", "one `=`"),
        (Code::E0006, "let a = u «**» 2", "`^`"),
        (Code::E0006, "let a = u * «*» 2", "`^`"),
        (Code::E0006, "let a = 1«;»\nlet b = 2", "no `;`"),
        (Code::E0006, "let a = (1«;» 2)", "no `;`"),
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
        (Code::E0006, "let a = 1 «on» [0, 1]", "before the `=`"),
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
        (Code::E0006, "let a = (1, «)»", "remove the comma"),
        (Code::E0006, "let a = f(b«]»", "expected `)`, found `]`"),
        (Code::E0006, "let a = b«)»", "closes nothing"),
        (Code::E0006, "let a = «[»1, 2]", "list"),
        (Code::E0006, "let a = b «[»1]", "list"),
        (Code::E0006, "let a = f([«[»1, 2]])", "list"),
        (Code::E0006, "let a = «\"b\"»", "string"),
        (Code::E0006, "import «'»a'", "double quotes"),
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
        (Code::E0006, "let a = 1\nb «=» a", "`let`"),
        (Code::E0006, "let «=» 2", "expected a name, found `=`"),
        (Code::E0006, "let a = c.«2»", "expected a name, found `2`"),
        (Code::E0006, "let a =«»", "found the end of the file"),
        (
            Code::E0006,
            "let a = \n«let» b = 2",
            "found the keyword `let`",
        ),
    ] {
        one(code, marked, words);
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

// ---- recovery ----

#[test]
fn an_unclosed_bracket_is_shown_at_its_opener() {
    one(Code::E0005, "let a = «(»1 + 2", "`(` is not closed");
    one(Code::E0005, "let a = «(»1 + 2\nlet b = 3", "write `)`");
    one(Code::E0005, "let a = f(«[»1, 2", "`[` is not closed");
    one(
        Code::E0005,
        "let a = («(»1, \nsurface R = a",
        "`(` is not closed",
    );
    one(Code::E0005, "let a = «(»1 +", "`(` is not closed");
    one(
        Code::E0005,
        "sweep c(v) on «[»0, 1\nlet a = 1",
        "`[` is not closed",
    );
    one(Code::E0005, "import «\"»a", "the string is not closed");
    one(
        Code::E0005,
        "let a = f(b: «\"»+-)\nlet c = 2",
        "the string is not closed",
    );
    let (document, diagnostics) = parsed("let a = (1\nlet b = 3");
    assert_eq!(show_document(&document), "(let b 3)\n");
    let related = &diagnostics.iter().next().unwrap().related;
    assert_eq!(related[0].0.range(), 11..14);
    assert_eq!(related[0].1, "the next declaration begins here");
}

#[test]
fn every_error_of_a_file_is_reported() {
    let slips = [
        "let a = ",
        "let = 2",
        "param 3 = 2",
        "let b = (1",
        "let c = 1,5",
        "let d = 1 2",
        "profile p = 1",
        "sweep q(v) on [0] = 1",
        "surface R(u) = 1",
        "expect",
        "import x",
        "unit 3",
        "let e = 1..2",
        "let f = \u{441}",
        "let g = ?",
        "let h = u^+2",
        "let in = 2",
        "let l = 1 )",
        "curve m(u) in zz = 1",
        "let o == 2",
    ];
    let text = slips
        .map(|slip| format!("{slip}\nlet z_{} = 1\n", slip.len()))
        .concat();
    let (document, diagnostics) = parsed(&text);
    assert_eq!(
        diagnostics.errors().count(),
        slips.len(),
        "{:#?}",
        findings(&text)
    );
    let good = document.items.iter().filter(|item| {
        matches!(&item.declaration, Declaration::Let { name, .. } if name.text.starts_with("z_"))
    });
    assert_eq!(good.count(), slips.len());
    let places: Vec<_> = diagnostics.iter().map(|finding| finding.primary).collect();
    assert!(places.is_sorted());
}

#[test]
fn recovery_stops_at_misspelt_keywords() {
    let codes =
        findings("let a = )\nproflie p(u) = q\nb = 1\nlet c = 2\nexpct c == 2\nsweep d(v) = (");
    let places: Vec<_> = codes.iter().map(|(_, marked, _)| marked.as_str()).collect();
    assert_eq!(places, [")", "proflie", "expct", "("]);
}

#[test]
fn at_most_fifty_errors_are_reported() {
    let (_, diagnostics) = parsed(&"let a = \n$".repeat(200));
    let errors: Vec<_> = diagnostics.errors().collect();
    assert_eq!(errors.len(), 50);
    assert!(errors[49].notes[0].contains("only the first 50"));
    assert!(errors[48].notes.iter().all(|note| !note.contains("first")));
    let (_, diagnostics) = parsed(&"let a = ) ".repeat(50));
    assert_eq!(diagnostics.errors().count(), 50);
    assert!(diagnostics.errors().all(|error| error.notes.is_empty()));
}

#[test]
fn names_of_broken_declarations_are_kept() {
    let names = |text: &str| {
        let (document, _) = parsed(text);
        let list = document.broken.iter().map(|name| name.text.clone());
        (list.collect::<Vec<_>>().join(" "), document.items.len())
    };
    assert_eq!(
        names("let sigma_1 = (\nsurface R = ) let a = 1"),
        ("sigma_1 R".to_owned(), 1)
    );
    assert_eq!(names("let a = 1\nb = 2\nlet c = 3"), ("a b".to_owned(), 1));
    assert_eq!(names("let a = 1\nsurfce f(u) = 2"), ("a f".to_owned(), 0));
    assert_eq!(names("let a = 1 )"), (String::new(), 1));
}

// ---- limits ----

#[test]
fn depth_is_limited() {
    let limits = Limits::default();
    for (text, place) in [
        ("(".repeat(100_000), 256),
        ("-".repeat(100_000), 257),
        (format!("2{}", "^2".repeat(100_000)), 513),
        (format!("f{}", "(f".repeat(100_000)), 513),
        (format!("f(a: {}", "[f(".repeat(100_000)), 5 + 3 * 127 + 2),
        (format!("a{}", ".x".repeat(100_000)), 515),
        (format!("2*{}x", "-".repeat(100_000)), 258),
    ] {
        let text = format!("let a = {text}\nlet b = 1");
        let (document, diagnostics) = parsed(&text);
        let list: Vec<_> = diagnostics.iter().collect();
        assert_eq!(list.len(), 1, "{list:#?}");
        assert_eq!(list[0].code, Code::E0502);
        assert!(list[0].help.as_ref().unwrap().contains("--max-nesting"));
        assert_eq!(list[0].primary.unwrap().start, 8 + place, "{}", &text[..20]);
        assert_eq!(show_document(&document), "(let b 1)\n");
    }
    let allowed = format!(
        "let a = {}1{}",
        "(".repeat(limits.nesting),
        ")".repeat(limits.nesting)
    );
    assert_eq!(parsed(&allowed).1, Diagnostics::default());
}

#[test]
fn digits_are_limited() {
    let limits = Limits {
        digits: 3,
        ..Limits::default()
    };
    let (_, diagnostics) = parsed_within("let a = 123\nlet b = 1234\nlet c = 1.2e34", &limits);
    let places = diagnostics
        .iter()
        .map(|finding| (finding.code, finding.primary.unwrap().range()));
    let expected = [(Code::E0503, 20..24), (Code::E0503, 33..39)];
    assert_eq!(places.collect::<Vec<_>>(), expected);
    let (_, diagnostics) = parsed(&format!("let a = {}", "7".repeat(1_000_000)));
    let list: Vec<_> = diagnostics.iter().collect();
    assert_eq!(list.len(), 1);
    assert!(list[0].message.len() < 200);
}

#[test]
fn chains_of_a_million_terms_are_flat() {
    for operator in ["+1", "-1", "*a", " a", "/2"] {
        let text = format!("let a = 1{}", operator.repeat(1_000_000));
        let (document, diagnostics) = parsed(&text);
        assert!(!diagnostics.has_errors());
        let Declaration::Let { value, .. } = &document.items[0].declaration else {
            panic!()
        };
        let length = match &value.kind {
            ExprKind::Sum(terms) => terms.len(),
            ExprKind::Product(factors) => factors.len(),
            _ => 0,
        };
        assert_eq!(length, 1_000_001);
    }
}

#[test]
fn long_bad_texts_take_linear_time() {
    for piece in [
        "let a=1=", ") ", "let let ", "$", "a/b c ", "х ", "(] ", "\" ", "1 2 ", "; 1 ",
    ] {
        let text = format!("let a = {}", piece.repeat(200_000));
        let start = std::time::Instant::now();
        let (_, diagnostics) = parsed(&text);
        assert!(diagnostics.iter().count() <= 100);
        assert!(start.elapsed().as_secs() < 20, "{piece}");
    }
}

// ---- the grammar, walked at random ----

/// A text and its tree, of the precedence of a power or tighter.
fn tight() -> impl Strategy<Value = (String, String)> {
    let number = prop::sample::select(&["0.5", "7", "1e-3"][..]);
    let name = prop::sample::select(&["a", "R.W", "f'", "c.κ''", "λ_1"][..]);
    let leaf = prop_oneof![number, name].prop_map(|text| (text.to_owned(), text.to_owned()));
    leaf.prop_recursive(5, 40, 4, |inner| {
        let sum = sum(inner);
        let list = prop::collection::vec(sum.clone(), 2..4).prop_map(|entries| {
            let (texts, trees): (Vec<_>, Vec<_>) = entries.into_iter().unzip();
            (texts.join(" , "), trees.join(" "))
        });
        prop_oneof![
            sum.clone()
                .prop_map(|(text, tree)| (format!("({text})"), format!("(group {tree})"))),
            list.clone()
                .prop_map(|(text, tree)| (format!("({text})"), format!("(tuple {tree})"))),
            list.prop_map(|(text, tree)| {
                (
                    format!("g (l:[{text}],m)"),
                    format!("(apply g l:(list {tree}) m)"),
                )
            }),
            sum.clone().prop_map(|(text, tree)| {
                (
                    format!("c.σ({text}).x"),
                    format!("(. (apply c.σ {tree}) x)"),
                )
            }),
            sum.prop_map(|(text, tree)| {
                (
                    format!("b^n^({text})"),
                    format!("(^ b (^ n (group {tree})))"),
                )
            }),
        ]
    })
}

/// A sum of products of what is given.
fn sum(
    tight: impl Strategy<Value = (String, String)> + Clone,
) -> impl Strategy<Value = (String, String)> + Clone {
    let joint = prop::sample::select(&["*", "/", " "][..]);
    let factors = prop::collection::vec((joint, any::<bool>(), tight), 1..4);
    let product = factors.prop_map(|factors| {
        let (mut text, mut joints, mut trees) = (String::new(), String::new(), String::new());
        let mut only = String::new();
        for (place, (joint, negative, (factor, tree))) in factors.iter().enumerate() {
            // no number on the right, no name that would be applied
            let digit = factor.starts_with(|c: char| c.is_ascii_digit());
            let applies = factor.starts_with('(') && !text.ends_with(')');
            let beside = *joint == " " && !digit && !applies;
            let negative = *negative && place > 0 && !beside;
            if place > 0 {
                text += if beside {
                    " "
                } else {
                    joint.trim().get(..1).unwrap_or("×")
                };
                joints.push(match (beside, *joint) {
                    (true, _) => '_',
                    (false, "/") => '/',
                    _ => '*',
                });
            }
            text += if negative { "-" } else { "" };
            text += factor;
            only = if negative {
                format!("(neg {tree})")
            } else {
                tree.clone()
            };
            trees = format!("{trees} {only}");
        }
        match factors.len() {
            1 => (text, only),
            _ => (text, format!("({joints}{trees})")),
        }
    });
    prop::collection::vec((any::<bool>(), product), 1..4).prop_map(|terms| {
        let (mut text, mut trees) = (String::new(), String::new());
        for (place, (negative, (term, tree))) in terms.iter().enumerate() {
            text += match (negative, place) {
                (true, _) => " - ",
                (false, 0) => "",
                (false, _) => "+",
            };
            text += term;
            trees += &if *negative {
                format!(" (- {tree})")
            } else {
                format!(" {tree}")
            };
        }
        match &terms[..] {
            [(false, (_, tree))] => (text, tree.clone()),
            _ => (text, format!("(+{trees})")),
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn expressions_of_the_grammar_have_their_trees((text, tree) in sum(tight().boxed())) {
        prop_assert_eq!(expression(&text), tree);
    }
}

#[test]
fn the_written_grammar_has_every_keyword_and_no_dead_rule() {
    let grammar = include_str!("../grammar/sweep.ebnf");
    for keyword in Keyword::ALL {
        assert!(
            grammar.contains(&format!("\"{}\"", keyword.as_str())),
            "{keyword:?}"
        );
    }
    let words: Vec<_> = grammar.split(|c: char| !c.is_ascii_alphabetic()).collect();
    for line in grammar.lines() {
        let Some((rule, _)) = line.split_once("::=") else {
            continue;
        };
        let rule = rule.trim();
        let uses = words.iter().filter(|word| **word == rule).count();
        assert!(uses > 1 || matches!(rule, "Document" | "Text"), "{rule}");
    }
}

// ---- anything at all ----

fn sound(text: &str) {
    let (document, diagnostics) = parsed(text);
    let inside = |span: sweepc::diag::Span| text.get(span.range()).is_some();
    assert!(document.items.iter().all(|item| inside(item.span)));
    assert!(document.comments.iter().all(|span| inside(*span)));
    let mut sources = SourceMap::default();
    sources.add("a.sweep", text);
    for finding in diagnostics.iter() {
        assert!(finding.primary.is_some_and(inside), "{finding:?}");
        assert!(finding.fix.as_ref().is_none_or(|fix| inside(fix.span)));
        assert!(!finding.message.ends_with('.'));
        assert!(!render_text(finding, &sources, Style::Plain).is_empty());
    }
    if document.items.is_empty() && document.broken.is_empty() && !text.trim().is_empty() {
        let only_comments = text
            .trim_start_matches('\u{feff}')
            .trim_start()
            .starts_with('#');
        assert!(only_comments || diagnostics.has_errors(), "{text:?}");
    }
}

const SOUP: &[&str] = &[
    "let",
    "param",
    "profile",
    "sweep",
    "curve",
    "construction",
    "surface",
    "expect",
    "import",
    "unit",
    "in",
    "on",
    "where",
    "a",
    "u",
    "v",
    "x",
    "p",
    "c",
    "σ",
    "xy",
    "xz",
    "1",
    "2.5",
    "0",
    "1e3",
    "(",
    ")",
    "[",
    "]",
    ",",
    ":",
    ";",
    ".",
    "=",
    "==",
    "!=",
    "<",
    "+",
    "-",
    "*",
    "/",
    "^",
    "**",
    "'",
    "″",
    "×",
    "·",
    "\"s\"",
    "\"",
    "# c\n",
    "\n",
    "$",
    "с",
    "²",
    "\u{200b}",
    "\0",
    "1.2.3",
    "1,5",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 2_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        sound(&String::from_utf8_lossy(&bytes));
        let _ = decode(&bytes, "a", &Limits::default());
    }

    #[test]
    fn any_text_is_survived(text in any::<String>()) {
        sound(&text);
    }

    #[test]
    fn any_tokens_are_survived(
        pieces in prop::collection::vec(prop::sample::select(SOUP), 0..60),
        glue in prop::sample::select(&["", " "][..]),
    ) {
        sound(&pieces.join(glue));
    }
}
