//! Tree to text: the canonical layout of a file.
//!
//! The formatter puts the tokens of a text in new lines and adds none of its own but `*`. Layout is
//! a function of the tree and of the tokens that the comments stand at; so what it writes stays as
//! it is when it is formatted again. What it returns was read back and has the tree and the
//! comments of the original.

mod columns;
mod declaration;
mod doc;
mod expression;
mod reading;
mod shape;
mod spelling;
mod tokens;
mod writer;

use super::ast::{Declaration, Document, Reference};
use super::parse;
use crate::diag::{Diagnostics, Limits};

use self::columns::aligned;
use self::shape::{bare, starred};
use self::tokens::Tokens;

pub use self::reading::Reading;
pub use self::spelling::Spelling;

/// The columns of a line.
const WIDTH: usize = 100;
/// What the continuation of a declaration is moved in by.
const INDENT: usize = 4;

/// How a file is formatted.
#[derive(Clone, Copy)]
pub struct Formatter<'a> {
    /// Which spelling of a name is written.
    pub spelling: Spelling,
    /// How a name with a parenthesis behind it is read in a declaration.
    pub reading: &'a dyn Fn(&Reference, &Declaration) -> Reading,
    /// What the text was parsed within.
    pub limits: &'a Limits,
}

impl Formatter<'_> {
    /// The canonical text of a document that was parsed from `text` without errors.
    ///
    /// None if what was written does not read back as the same tree with the same comments; then
    /// nothing may be written. For a text with errors that is the rule, for others a defect.
    ///
    /// - **holds** the result formats to itself; it has the comments of the text in their order, on
    ///   lines of their own or behind the same tokens; it ends with one line feed, or is empty
    ///
    /// ```
    /// use sweepc::diag::{Diagnostics, FileId, Limits};
    /// use sweepc::syntax::{Formatter, Reading, Spelling, parse};
    /// let limits = Limits::default();
    /// let text = "let  a=2*u   # two";
    /// let document = parse(FileId(0), text, &limits, &mut Diagnostics::default());
    /// let formatter = Formatter {
    ///     spelling: Spelling::AsWritten,
    ///     reading: &|_, _| Reading::Application,
    ///     limits: &limits,
    /// };
    /// let formatted = formatter.format(&document, text);
    /// assert_eq!(formatted.as_deref(), Some("let a = 2 * u  # two\n"));
    /// ```
    #[must_use]
    pub fn format(&self, document: &Document, text: &str) -> Option<String> {
        let tree = starred(document, self.reading);
        let mut tokens = Tokens::new(text, self);
        let mut lines = Vec::new();
        for item in &tree.items {
            tokens.item(&item.declaration, &mut lines);
        }
        tokens.end(&mut lines);
        let formatted = aligned(lines);
        self.reads_back(&tree, text, document, &formatted)
            .then_some(formatted)
    }

    /// Whether the new text has the tree and the comments of the old one.
    fn reads_back(&self, tree: &Document, text: &str, old: &Document, formatted: &str) -> bool {
        let mut findings = Diagnostics::default();
        let new = parse(tree.file, formatted, self.limits, &mut findings);
        let comments = |document: &Document, text: &str| -> Vec<String> {
            let spans = document.comments.iter();
            let texts = spans.filter_map(|span| text.get(span.range()));
            texts.map(|own| own.trim_end().to_owned()).collect()
        };
        !findings.has_errors()
            && comments(&new, formatted) == comments(old, text)
            && bare(&new).items == tree.items
    }
}
