//! Every declaration, and the places of its parts.

use sweepc::syntax::ast::Declaration;

use crate::{parsed, tree};

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
