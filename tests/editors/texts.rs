//! Texts of the language, and their tokens as the compiler sees them.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use sweepc::diag::{Diagnostics, FileId, Limits};
use sweepc::syntax::lexer::{TokenKind, tokenize};
use sweepc::syntax::parse;

use crate::derivation::Derivation;
use crate::ebnf::Grammar;

const SEED: u64 = 20_260_103;
/// How many sentences of the grammar are derived.
const SENTENCES: usize = 600;

/// Every file with an extension under a folder of the project.
pub(crate) fn files(folder: &str, extension: &str) -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut found, mut folders) = (Vec::<PathBuf>::new(), vec![root.join(folder)]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|own| own == extension) {
                found.push(path);
            }
        }
    }
    found.sort();
    let read = |path: PathBuf| {
        let name = path.strip_prefix(root).unwrap().to_str().unwrap();
        (name.to_owned(), fs::read_to_string(&path).unwrap())
    };
    found.into_iter().map(read).collect()
}

/// The examples, the standard library and what the README shows.
pub(crate) fn written() -> Vec<(String, String)> {
    let mut texts = files("examples", "sweep");
    texts.extend(files("src/std", "sweep"));
    let readme = include_str!("../../README.md");
    let shown = readme.split("```sweep\n").skip(1);
    texts.extend(shown.map(|rest| {
        let text = rest.split_once("```").unwrap().0;
        ("README.md".to_owned(), text.to_owned())
    }));
    assert!(texts.len() > 15);
    texts
}

/// Sentences of the written grammar, with blanks, line ends and comments between their tokens.
pub(crate) fn derived() -> Vec<(Vec<String>, String)> {
    let grammar = Grammar::read(include_str!("../../grammar/sweep.ebnf"));
    let mut derivation = Derivation::new(&grammar, SEED);
    let mut sentences = Vec::new();
    while sentences.len() < SENTENCES {
        let tokens = derivation.sentence("Document");
        let mut text = String::new();
        for token in &tokens {
            text += token;
            text += [" ", "\n", " # -1 \"a\"\r\n", "\t"][derivation.random.next(4)];
        }
        sentences.push((tokens, text));
    }
    sentences
}

/// Whether the compiler finds an error of syntax.
pub(crate) fn is_refused(text: &str) -> bool {
    let mut findings = Diagnostics::default();
    parse(FileId(0), text, &Limits::default(), &mut findings);
    findings.has_errors()
}

/// The tokens of a sound text.
pub(crate) fn tokens(text: &str) -> Vec<(TokenKind, Range<usize>)> {
    let lexed = tokenize(FileId(0), text, &Limits::default());
    assert!(lexed.findings.is_empty(), "{text:?}");
    let tokens = lexed.tokens.into_iter();
    tokens
        .filter(|own| own.kind != TokenKind::End)
        .map(|own| (own.kind, own.start as usize..own.end as usize))
        .collect()
}

/// The comments of a text.
pub(crate) fn comments(text: &str) -> Vec<Range<usize>> {
    let lexed = tokenize(FileId(0), text, &Limits::default());
    lexed.comments.into_iter().map(|own| own.range()).collect()
}
