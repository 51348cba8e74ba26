//! Expressions with their trees at random, and anything at all.

use proptest::prelude::*;
use sweepc::diag::{Limits, SourceMap, Style, render_text};
use sweepc::syntax::decode;

use crate::{expression, parsed};

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

/// A product of what is given.
fn product(
    tight: impl Strategy<Value = (String, String)> + Clone,
) -> impl Strategy<Value = (String, String)> + Clone {
    let joint = prop::sample::select(&["*", "/", " "][..]);
    let factors = prop::collection::vec((joint, any::<bool>(), tight), 1..4);
    factors.prop_map(|factors| {
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
    })
}

/// A sum of products of what is given.
fn sum(
    tight: impl Strategy<Value = (String, String)> + Clone,
) -> impl Strategy<Value = (String, String)> + Clone {
    prop::collection::vec((any::<bool>(), product(tight)), 1..4).prop_map(|terms| {
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
