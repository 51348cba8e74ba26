//! What editors are told about the language is what the compiler reads.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test that cannot go on has failed"
)]

#[allow(dead_code, reason = "one of the programs that share it uses it all")]
#[path = "../grammar/derivation.rs"]
mod derivation;
#[allow(dead_code, reason = "one of the programs that share it uses it all")]
#[path = "../grammar/ebnf.rs"]
mod ebnf;
mod queries;
mod scopes;
mod textmate;
mod texts;
mod trees;
mod vocabulary;
