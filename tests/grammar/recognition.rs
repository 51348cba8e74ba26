//! Whether tokens are a sentence of the grammar: all derivations at once, by the places where each
//! may end.

use std::collections::{BTreeSet, HashMap};

use crate::ebnf::{Grammar, Part};

type Ends = BTreeSet<usize>;

pub(crate) struct Recognition<'a> {
    grammar: &'a Grammar,
    tokens: &'a [String],
    known: HashMap<(&'a str, usize), Ends>,
}

/// Whether the tokens are a document.
pub(crate) fn is_document(grammar: &Grammar, tokens: &[String]) -> bool {
    let mut recognition = Recognition {
        grammar,
        tokens,
        known: HashMap::new(),
    };
    let ends = recognition.rule("Document", 0);
    ends.contains(&tokens.len())
}

/// The rule about characters that a token belongs to.
fn class(grammar: &Grammar, token: &str) -> &'static str {
    let is = |rule: &str| grammar.literals(rule).iter().any(|own| own == token);
    match token.chars().next() {
        _ if is("Keyword") => "Keyword",
        _ if is("Minus") => "Minus",
        _ if is("Times") => "Times",
        _ if is("Prime") => "Prime",
        Some('"') => "STRING",
        Some(c) if c.is_ascii_digit() => "NUMBER",
        Some(c) if c == '_' || c.is_alphabetic() => "NAME",
        _ => "Sign",
    }
}

impl<'a> Recognition<'a> {
    fn rule(&mut self, name: &'a str, at: usize) -> Ends {
        if self.grammar.is_lexical(name) {
            let token = self.tokens.get(at);
            let is_own = token.is_some_and(|own| class(self.grammar, own) == name);
            return is_own.then_some(at + 1).into_iter().collect();
        }
        if name == "Beside" && !self.may_stand_beside(at) {
            return Ends::new();
        }
        if let Some(ends) = self.known.get(&(name, at)) {
            return ends.clone();
        }
        let ends = self.ends(self.grammar.rule(name), at);
        self.known.insert((name, at), ends.clone());
        ends
    }

    /// Section 3.1.
    fn may_stand_beside(&self, at: usize) -> bool {
        let token = |at: usize| self.tokens.get(at).map_or("", String::as_str);
        let number = token(at).starts_with(|c: char| c.is_ascii_digit());
        let applied = ["(", ".", "'", "’", "′", "″"].contains(&token(at + 1));
        let zero = at > 0 && token(at - 1) == "0" && token(at) == "x" && !applied;
        !number && !zero
    }

    fn ends(&mut self, part: &'a Part, at: usize) -> Ends {
        match part {
            Part::Rule(name) => self.rule(name, at),
            Part::Literal(text) => {
                let is_own = self.tokens.get(at) == Some(text);
                is_own.then_some(at + 1).into_iter().collect()
            }
            Part::Sequence(all) => all.iter().fold(Ends::from([at]), |starts, own| {
                starts.iter().flat_map(|at| self.ends(own, *at)).collect()
            }),
            Part::Choice(_, all) => all.iter().flat_map(|own| self.ends(own, at)).collect(),
            Part::Optional(_, inner) => {
                let mut ends = self.ends(inner, at);
                ends.insert(at);
                ends
            }
            Part::Repeated(_, once, inner) => {
                let (mut all, mut new) = (Ends::from([at]), vec![at]);
                let mut reached = Ends::new();
                while let Some(at) = new.pop() {
                    for end in self.ends(inner, at) {
                        reached.insert(end);
                        if all.insert(end) {
                            new.push(end);
                        }
                    }
                }
                if *once { reached } else { all }
            }
            Part::Class(..) | Part::Except(..) => panic!("characters among the declarations"),
        }
    }
}
