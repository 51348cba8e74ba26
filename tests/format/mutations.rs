//! Other layouts of the examples: blanks, line ends and comments between any two tokens.

use std::fs;

use sweepc::diag::{FileId, Limits};
use sweepc::syntax::Spelling;
use sweepc::syntax::ast::Declaration;
use sweepc::syntax::lexer::{Token, tokenize};

use crate::{files, formatted, parsed, spelled};

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
}

/// The comments in their order, each with the number of tokens before it and whether one of them
/// is on its line. Signs that the formatter adds or spells in another way are not counted.
fn comments(text: &str) -> Vec<(usize, bool, String)> {
    let lexed = tokenize(FileId(0), text, &Limits::default());
    let is_kept = |own: &&Token| {
        let written = &text[own.start as usize..own.end as usize];
        !matches!(written, "*" | "x" | "×" | "·" | "'" | "’" | "′" | "″")
    };
    let mut found = Vec::new();
    for span in &lexed.comments {
        let start = span.start as usize;
        let before = lexed.tokens.iter().filter(|own| own.end <= span.start);
        let line = text[..start].rfind(['\n', '\r']).map_or(0, |end| end + 1);
        let beside = !text[line..start].trim().is_empty();
        let comment = text[span.range()].trim_end().to_owned();
        found.push((before.filter(is_kept).count(), beside, comment));
    }
    found
}

/// The tokens of a text.
fn tokens(text: &str) -> Vec<&str> {
    let lexed = tokenize(FileId(0), text, &Limits::default());
    let all = lexed.tokens.iter();
    let all = all.map(|own| &text[own.start as usize..own.end as usize]);
    all.filter(|own| !own.is_empty()).collect()
}

/// The tokens with any blanks between them, and with comments.
fn scattered(random: &mut Random, text: &str, comments: bool) -> String {
    let end = ["\n", "\r\n", "\r"][random.next(3)];
    let mut scattered = String::new();
    let mut number = 0;
    for token in tokens(text) {
        let mut gap = String::new();
        while random.next(3) == 0 {
            gap += [" ", "\t", "   ", end][random.next(4)];
        }
        if comments && random.next(12) == 0 {
            number += 1;
            gap += &format!("# comment {number} \t{end}");
        }
        let wordy = |c: char| c == '_' || c.is_alphanumeric();
        if gap.is_empty() && scattered.ends_with(wordy) && token.starts_with(wordy) {
            gap.push(' ');
        }
        scattered += &gap;
        scattered += token;
    }
    scattered
}

#[test]
fn the_files_of_the_project_are_canonical() {
    for path in files() {
        let text = fs::read_to_string(&path).unwrap();
        // what imports mean is not known here: compare by the command
        let folder = path.parent().unwrap();
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_sweepc"))
            .args(["fmt", "--check"])
            .arg(&path)
            .current_dir(folder)
            .output()
            .unwrap();
        let shown = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.success(), "{shown}");
        assert!(
            text.lines()
                .all(|line| line.starts_with('#') || line.chars().count() <= 100)
        );
    }
}

#[test]
fn every_layout_of_a_text_has_its_canonical_one() {
    let mut random = Random(1);
    for path in files() {
        let text = fs::read_to_string(&path).unwrap();
        // what an import declares and what a construction is given is unknown here, and where it
        // is unknown whether a name applies a blank stays
        let items = parsed(&text).items.into_iter().filter(|own| {
            let declaration = &own.declaration;
            !matches!(declaration, Declaration::Construction { .. })
        });
        let items: Vec<_> = items.map(|own| &text[own.span.range()]).collect();
        let text = items.join(" ");
        if text.contains("import") || text.is_empty() {
            continue;
        }
        let canonical = formatted(&tokens(&text).join("\n"));
        for _ in 0..5 {
            let other = formatted(&scattered(&mut random, &text, false));
            // blank lines end a table
            if !other.contains("\n\n") {
                assert_eq!(other, canonical, "{}", path.display());
            }
            let squeezed = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
            assert_eq!(squeezed(&other), squeezed(&canonical));
        }
    }
}

#[test]
fn comments_stay_where_they_are_and_the_text_is_the_same_again() {
    let mut random = Random(2);
    for path in files() {
        let text = fs::read_to_string(&path).unwrap();
        for round in 0..6 {
            let scattered = scattered(&mut random, &text, true);
            let spelling = [Spelling::AsWritten, Spelling::Ascii, Spelling::Unicode][round % 3];
            let own = spelled(&scattered, spelling);
            assert_eq!(comments(&own), comments(&scattered), "{scattered}\n{own}");
            assert_eq!(spelled(&own, spelling), own, "{scattered}");
            assert_eq!(formatted(&own), own, "{scattered}");
            assert_eq!(parsed(&own).items.len(), parsed(&scattered).items.len());
        }
    }
}
