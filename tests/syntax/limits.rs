//! Depth, digits, length, time.

use sweepc::diag::{Code, Diagnostics, Limits};
use sweepc::syntax::ast::{Declaration, ExprKind};

use crate::show::show_document;
use crate::{parsed, parsed_within};

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
    let pieces = [
        "let a=1=", ") ", "let let ", "$", "a/b c ", "х ", "(] ", "\" ", "1 2 ", "; 1 ",
    ];
    let values = pieces.map(|piece| ("let a = ", piece));
    for (before, piece) in values.into_iter().chain([("expect a == ", "a 2 ")]) {
        let text = format!("{before}{}", piece.repeat(200_000));
        let start = std::time::Instant::now();
        let (_, diagnostics) = parsed(&text);
        assert!(diagnostics.iter().count() <= 100);
        assert!(start.elapsed().as_secs() < 20, "{piece}");
    }
}
