//! One token dropped, doubled, or swapped with its neighbour: what is no sentence any more is an
//! error, and the error is where the change is.

use std::ops::Range;

use sweepc::diag::Code;

use crate::derivation::Derivation;
use crate::ebnf::Grammar;
use crate::recognition::is_document;
use crate::{SEED, grammar, parsed, starts};

/// How many errors may be elsewhere, out of more than two thousand.
const ASTRAY: usize = 40;

/// A sentence with one change.
struct NearMiss {
    tokens: Vec<String>,
    /// The changed tokens and one more on either side; where one is dropped, two.
    place: Range<usize>,
}

impl NearMiss {
    fn of(derivation: &mut Derivation<'_>, mut tokens: Vec<String>) -> Option<Self> {
        let at = derivation.random.next(tokens.len().max(1));
        let place = match derivation.random.next(3) {
            _ if tokens.len() < 2 => return None,
            0 => {
                tokens.remove(at);
                at.saturating_sub(2)..at + 2
            }
            1 => {
                tokens.insert(at, tokens[at].clone());
                at.saturating_sub(1)..at + 3
            }
            _ if at + 1 < tokens.len() && tokens[at] != tokens[at + 1] => {
                tokens.swap(at, at + 1);
                at.saturating_sub(1)..at + 3
            }
            _ => return None,
        };
        Some(Self { tokens, place })
    }

    /// The text, and the bytes of each token in it; behind the last one stands the end.
    fn text(&self) -> (String, Vec<Range<usize>>) {
        let (mut text, mut places) = (String::new(), Vec::new());
        for token in &self.tokens {
            let start = text.len();
            text += token;
            places.push(start..text.len());
            text.push(' ');
        }
        places.push(text.len()..text.len());
        (text, places)
    }

    /// The brackets that have no partner.
    fn unbalanced(&self) -> Vec<usize> {
        let (mut open, mut alone) = (Vec::new(), Vec::new());
        for (place, token) in self.tokens.iter().enumerate() {
            match token.as_str() {
                "(" | "[" => open.push(place),
                ")" | "]" => {
                    let opener = if token == ")" { "(" } else { "[" };
                    match open.last() {
                        Some(last) if self.tokens[*last] == opener => {
                            open.pop();
                        }
                        _ => alone.push(place),
                    }
                }
                _ => {}
            }
        }
        alone.extend(open);
        alone
    }
}

/// What became of a near miss.
#[derive(Debug, PartialEq)]
enum Outcome {
    /// Still a sentence, and parsed as one.
    Sentence,
    /// An error at the change.
    Found,
    /// An error elsewhere.
    Astray(String),
}

fn outcome(grammar: &Grammar, miss: &NearMiss) -> Outcome {
    let (text, places) = miss.text();
    let findings = parsed(&text).1;
    let is_sentence = is_document(grammar, &miss.tokens);
    let Some(first) = findings.errors().next() else {
        assert!(is_sentence, "no sentence, and no error: {text:?}");
        return Outcome::Sentence;
    };
    assert!(!is_sentence, "{first:?}\n{text:?}");
    assert!(
        first.code.is_syntax() || first.code == Code::E0103,
        "{first:?}"
    );
    let span = first.primary.expect("a place").range();
    let touches = |place: usize| {
        let token = places.get(place);
        token.is_some_and(|own| span.start <= own.end && own.start <= span.end)
    };
    if miss.place.clone().chain(miss.unbalanced()).any(touches) {
        return Outcome::Found;
    }
    let last = miss.place.end.min(places.len()) - 1;
    let changed = &text[places[miss.place.start].start..places[last].end];
    Outcome::Astray(format!(
        "`{changed}` {} at `{}`\n    {text}",
        first.message, &text[span]
    ))
}

#[test]
fn near_misses_are_sentences_or_errors_at_the_change() {
    let grammar = grammar();
    let mut derivation = Derivation::new(&grammar, SEED + 1);
    let (mut sentences, mut found, mut astray) = (0, 0, Vec::new());
    for start in starts(&grammar) {
        for _ in 0..2 {
            let tokens = derivation.sentence(&start);
            let Some(miss) = NearMiss::of(&mut derivation, tokens) else {
                continue;
            };
            match outcome(&grammar, &miss) {
                Outcome::Sentence => sentences += 1,
                Outcome::Found => found += 1,
                Outcome::Astray(what) => astray.push(what),
            }
        }
    }
    // Where a bracket, or the name or the sign before one, comes or goes, the text may be a sentence
    // up to a comma, a label, a prime or a bracket far behind that has no place there any more: what
    // stands before a parenthesis decides whether it holds arguments, and what stands in it whether
    // it is a point. No reader from the left could know sooner.
    assert!(
        astray.len() <= ASTRAY && found > 2_000 && sentences > 500,
        "{sentences} sentences, {found} found, {} astray:\n{}",
        astray.len(),
        astray.join("\n")
    );
}
