//! The house rules, held over the source tree.
//!
//! Every rule is a function from one file to its findings, with a test over the tree and a test
//! that shows the rule can fail.
#![allow(clippy::expect_used, reason = "a tree that cannot be read has failed")]

mod citations;
mod layers;
mod lengths;
mod names;
mod paths;
mod reach;
mod source;
mod standard;
mod tree;

use source::Source;

/// A broken rule: the place, and what is wrong there.
type Finding = String;

/// The findings of a rule over all files must be empty.
fn hold<'a>(sources: impl IntoIterator<Item = &'a Source>, rule: impl Fn(&Source) -> Vec<Finding>) {
    settle(sources.into_iter().flat_map(rule).collect());
}

/// No finding, or a failure that lists them all.
fn settle(findings: Vec<Finding>) {
    assert!(findings.is_empty(), "\n{}\n", findings.join("\n"));
}
