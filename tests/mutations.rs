//! One wrong token in an example: the first error is at the wrong token.
//!
//! Seeded mutations of single tokens. One that leaves a file without errors proves nothing and is
//! skipped; so is a file that only breaks an expectation or a proof about a surface, since it is
//! well-formed and says something else. Every other first error must touch the mutated place, or
//! the token before or behind it. Where a bracket is missing or one too many, any place where it may
//! stand is as right as another: there the error need only be in the same declaration, and these
//! are not among the mutations that are counted.
//!
//! Names are not misspelt where they are declared, and the text of constructions is left alone:
//! such errors are reported where the name or the construction is used.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

mod example_files;

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use example_files::{folder, in_name, run, sweeps};
use serde_json::Value;

/// The mutations that must be found where they are.
const WANTED: usize = 100;
const SEED: u64 = 20_260_101;

/// Keywords that declare the name behind them.
const DECLARING: &[&str] = &[
    "param",
    "let",
    "profile",
    "sweep",
    "curve",
    "construction",
    "surface",
];

/// Splitmix64.
struct Random(u64);

impl Random {
    fn next(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((z ^ (z >> 31)) % below as u64).unwrap()
    }

    fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.next(all.len())]
    }
}

/// The places of the tokens of a text.
fn tokens(text: &str) -> Vec<Range<usize>> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let while_ = |wanted: &dyn Fn(char) -> bool| rest.find(|c| !wanted(c));
        let length = if first == '#' {
            rest.find('\n')
        } else if first == '"' {
            rest[1..].find('"').map(|own| own + 2)
        } else if first.is_ascii_digit() {
            while_(&|c| c.is_ascii_digit() || c == '.')
        } else if in_name(first) {
            while_(&in_name)
        } else if ["==", "!=", "<=", ">="]
            .iter()
            .any(|own| rest.starts_with(own))
        {
            Some(2)
        } else {
            Some(first.len_utf8())
        };
        let end = at + length.unwrap_or(rest.len());
        if !first.is_whitespace() && first != '#' {
            tokens.push(at..end);
        }
        at = end;
    }
    tokens
}

/// The tokens of the declaration that a token belongs to, from its keyword on.
fn declaration(text: &str, tokens: &[Range<usize>], at: usize) -> Range<usize> {
    let begins = |own: &usize| {
        let token = &text[tokens[*own].clone()];
        DECLARING.contains(&token) || ["expect", "import", "unit"].contains(&token)
    };
    let start = (0..=at).rev().find(begins).unwrap_or(0);
    let end = (at + 1..tokens.len()).find(begins);
    start..end.unwrap_or(tokens.len())
}

/// A text with one wrong token.
struct Mutant {
    path: PathBuf,
    what: String,
    text: String,
    /// The mutated place in the new text, with a token before and behind; all of the declaration
    /// and the keyword of the next if it is about brackets.
    place: Range<usize>,
    /// Whether it is not about brackets.
    strict: bool,
}

impl Mutant {
    /// Replaces tokens by a text; `place` reaches to the tokens beside them.
    fn of(path: &Path, text: &str, tokens: &[Range<usize>], own: Range<usize>, by: &str) -> Self {
        let bytes = tokens[own.start].start..tokens[own.end - 1].end;
        let before = own.start.checked_sub(1).map_or(0, |own| tokens[own].start);
        let behind = tokens.get(own.end).map_or(text.len(), |own| own.end);
        let strict = !format!("{}{by}", &text[bytes.clone()]).contains(['(', ')', '[', ']']);
        let (before, behind) = if strict {
            (before, behind)
        } else {
            let declaration = declaration(text, tokens, own.start);
            let next = tokens
                .get(declaration.end)
                .map_or(text.len(), |own| own.end);
            (tokens[declaration.start].start, next)
        };
        let changed = format!("{}{by}{}", &text[..bytes.start], &text[bytes.end..]);
        Self {
            path: path.to_path_buf(),
            what: format!("`{}` becomes `{by}`", &text[bytes.clone()]),
            place: before..behind + by.len() - bytes.len(),
            text: changed,
            strict,
        }
    }

    /// A mutation of one of the files.
    fn random(random: &mut Random, files: &[(PathBuf, String)]) -> Option<Self> {
        let (path, text) = &files[random.next(files.len())];
        let tokens = tokens(text);
        let at = random.next(tokens.len());
        let token = |at: usize| tokens.get(at).map(|own| &text[own.clone()]);
        let (own, declared) = (token(at)?, at > 0 && DECLARING.contains(&token(at - 1)?));
        let whole = declaration(text, &tokens, at);
        if token(whole.start)? == "construction" {
            return None;
        }
        let replaced = |by: &str, count: usize| Self::of(path, text, &tokens, at..at + count, by);
        let brackets = ["(", ")", "[", "]"];
        let operators = ["+", "*", "/", "^", "=", "==", "<", ",", ":"];
        Some(match random.next(5) {
            0 => replaced("", 1),
            1 => replaced(&format!("{own} {own}"), 1),
            2 => replaced(&format!("{} {own}", token(at + 1)?), 2),
            // A name that is declared wrong is an error where it is used.
            3 if own.starts_with(in_name) && !own.starts_with(|c: char| c.is_ascii_digit()) => {
                if declared {
                    return None;
                }
                replaced(&format!("{own}q"), 1)
            }
            4 if brackets.contains(&own) => replaced(random.pick(&brackets), 1),
            4 if operators.contains(&own) => replaced(random.pick(&operators), 1),
            _ => return None,
        })
    }

    /// The findings of the compiler that are errors of the text, in its order.
    fn errors(&self) -> Vec<Value> {
        let folder = self.path.parent().unwrap();
        let output = run(folder, &["check", "--format", "json", "-"], &self.text);
        let status = output.status.code();
        assert!(
            matches!(status, Some(0 | 1 | 3)),
            "{status:?}: {}",
            self.what
        );
        let lines = String::from_utf8(output.stdout).unwrap();
        let findings = lines
            .lines()
            .map(|line| serde_json::from_str::<Value>(line).unwrap());
        findings.filter(|own| own["severity"] == "error").collect()
    }

    /// Whether the text is well-formed, and only says something that is not true.
    fn is_sound(errors: &[Value]) -> bool {
        let code = |own: &Value| own["code"].as_str().unwrap().to_owned();
        errors.iter().all(|own| {
            let code = code(own);
            code.starts_with("E03") || code.starts_with("E04")
        })
    }

    fn is_touched_by(&self, error: &Value) -> bool {
        let byte = |name: &str| error["span"][name].as_u64().map(|own| own as usize);
        let (Some(start), Some(end)) = (byte("start"), byte("end")) else {
            return false;
        };
        start <= self.place.end && self.place.start <= end
    }
}

#[test]
fn the_first_error_is_at_the_wrong_token() {
    let paths = sweeps(&folder()).into_iter();
    let files: Vec<_> = paths
        .map(|path| (path.clone(), fs::read_to_string(path).unwrap()))
        .collect();
    let mut random = Random(SEED);
    let (mut strict, mut loose, mut astray) = (0, 0, Vec::new());
    while strict < WANTED {
        let Some(mutant) = Mutant::random(&mut random, &files) else {
            continue;
        };
        let errors = mutant.errors();
        if Mutant::is_sound(&errors) {
            continue;
        }
        *(if mutant.strict {
            &mut strict
        } else {
            &mut loose
        }) += 1;
        if !mutant.is_touched_by(&errors[0]) {
            let line = mutant.text[..mutant.place.start].lines().count();
            let file = mutant.path.file_name().unwrap().display();
            astray.push(format!("{file}:{line}: {}\n    {}", mutant.what, errors[0]));
        }
    }
    // What stays legal until a later token cannot be blamed on the earlier one: a sign less makes
    // a product, a letter less another name.
    assert!(
        astray.len() * 20 <= strict,
        "{} first errors of {strict} mutations and {loose} of brackets are astray:\n{}",
        astray.len(),
        astray.join("\n")
    );
}
