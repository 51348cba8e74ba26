//! The notation of `grammar/sweep.ebnf`: the EBNF of the W3C, read into rules.

use std::collections::HashMap;
use std::iter::{Cloned, Peekable};
use std::slice::Iter;

/// The right side of a rule. Each place where a derivation chooses has a number of its own.
#[derive(Debug, Clone)]
pub(crate) enum Part {
    Rule(String),
    Literal(String),
    /// Ranges of characters; any other one if the flag is set.
    Class(bool, Vec<(char, char)>),
    Sequence(Vec<Part>),
    Choice(usize, Vec<Part>),
    /// `A?`
    Optional(usize, Box<Part>),
    /// `A*`, and `A+` with the flag
    Repeated(usize, bool, Box<Part>),
    /// `A - B`
    Except(Box<Part>, Box<Part>),
}

/// The rules of the written grammar.
#[derive(Debug)]
pub(crate) struct Grammar {
    rules: HashMap<String, Part>,
    /// Their names in the order of the file.
    pub(crate) names: Vec<String>,
}

#[derive(Debug, Clone, PartialEq)]
enum Word {
    Name(String),
    Literal(String),
    Class(bool, Vec<(char, char)>),
    Sign(char),
    Defines,
}

impl Grammar {
    pub(crate) fn read(text: &str) -> Self {
        let words = words(text);
        let starts: Vec<usize> = (1..words.len())
            .filter(|own| words[*own] == Word::Defines)
            .map(|own| own - 1)
            .collect();
        let mut grammar = Self {
            rules: HashMap::new(),
            names: Vec::new(),
        };
        let mut choices = 0;
        for (place, start) in starts.iter().enumerate() {
            let end = starts.get(place + 1).copied().unwrap_or(words.len());
            let Word::Name(name) = &words[*start] else {
                panic!("no name before `::=`: {:?}", words[*start]);
            };
            let mut reader = Reader {
                words: words[start + 2..end].iter().cloned().peekable(),
                choices: &mut choices,
            };
            let part = reader.choice();
            assert_eq!(reader.words.next(), None, "{name}");
            assert!(!grammar.rules.contains_key(name), "{name} is defined twice");
            grammar.names.push(name.clone());
            grammar.rules.insert(name.clone(), part);
        }
        grammar
    }

    pub(crate) fn rule(&self, name: &str) -> &Part {
        let rule = self.rules.get(name);
        rule.unwrap_or_else(|| panic!("no rule {name}"))
    }

    /// Whether a rule is about characters: it stands before that of the declarations.
    pub(crate) fn is_lexical(&self, name: &str) -> bool {
        let place = |name: &str| self.names.iter().position(|own| own == name);
        place(name) < place("Document")
    }

    /// The choices that the rules reachable from one offer, each with the number of its outcomes.
    pub(crate) fn choices(&self, start: &str) -> HashMap<usize, (String, usize)> {
        let (mut found, mut seen) = (HashMap::new(), vec![start.to_owned()]);
        let mut at = 0;
        while at < seen.len() {
            let name = seen[at].clone();
            let mut parts = vec![self.rule(&name)];
            while let Some(part) = parts.pop() {
                match part {
                    Part::Rule(rule) if !seen.contains(rule) => seen.push(rule.clone()),
                    Part::Rule(_) | Part::Literal(_) | Part::Class(..) => {}
                    Part::Sequence(all) => parts.extend(all),
                    Part::Choice(number, all) => {
                        found.insert(*number, (name.clone(), all.len()));
                        parts.extend(all);
                    }
                    Part::Optional(number, inner) | Part::Repeated(number, _, inner) => {
                        found.insert(*number, (name.clone(), 2));
                        parts.push(inner);
                    }
                    // the exception is no part of a sentence
                    Part::Except(inner, _) => parts.push(inner),
                }
            }
            at += 1;
        }
        found
    }

    /// The rules that a rule names.
    pub(crate) fn named(&self, name: &str) -> Vec<String> {
        let (mut found, mut parts) = (Vec::new(), vec![self.rule(name)]);
        while let Some(part) = parts.pop() {
            match part {
                Part::Rule(own) => found.push(own.clone()),
                Part::Literal(_) | Part::Class(..) => {}
                Part::Choice(_, all) | Part::Sequence(all) => parts.extend(all),
                Part::Optional(_, inner) | Part::Repeated(_, _, inner) => parts.push(inner),
                Part::Except(inner, exception) => parts.extend([&**inner, &**exception]),
            }
        }
        found
    }

    /// The literals that stand in a rule itself.
    pub(crate) fn literals(&self, name: &str) -> Vec<String> {
        let (mut found, mut parts) = (Vec::new(), vec![self.rule(name)]);
        while let Some(part) = parts.pop() {
            match part {
                Part::Literal(own) => found.push(own.clone()),
                Part::Choice(_, all) | Part::Sequence(all) => parts.extend(all),
                _ => {}
            }
        }
        found
    }
}

/// Cuts the text into words, without its comments.
fn words(text: &str) -> Vec<Word> {
    let (mut words, mut rest) = (Vec::new(), text);
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '/' => {
                assert!(rest.starts_with("/*"));
                rest.find("*/").expect("an end of the comment") + 2
            }
            '"' | '\'' => {
                let end = rest[1..].find(first).expect("an end of the literal") + 1;
                words.push(Word::Literal(rest[1..end].to_owned()));
                end + 1
            }
            '#' => {
                let end = end_of(&rest[1..], char::is_alphanumeric) + 1;
                words.push(Word::Literal(code_point(&rest[..end]).to_string()));
                end
            }
            '[' => {
                let end = rest.find(']').expect("an end of the class");
                words.push(class(&rest[1..end]));
                end + 1
            }
            ':' => {
                assert!(rest.starts_with("::="));
                words.push(Word::Defines);
                3
            }
            c if c.is_alphabetic() => {
                let end = end_of(rest, char::is_alphanumeric);
                words.push(Word::Name(rest[..end].to_owned()));
                end
            }
            c if c.is_whitespace() => 1,
            c => {
                assert!("?*+|-()".contains(c), "{c}");
                words.push(Word::Sign(c));
                1
            }
        };
        rest = &rest[length..];
    }
    words
}

fn end_of(text: &str, inside: impl Fn(char) -> bool) -> usize {
    text.find(|c| !inside(c)).unwrap_or(text.len())
}

/// `#x2212`
fn code_point(text: &str) -> char {
    let code = u32::from_str_radix(&text[2..], 16).expect("a code point");
    char::from_u32(code).expect("a character")
}

/// What stands in `[…]`.
fn class(text: &str) -> Word {
    let (negated, mut rest) = match text.strip_prefix('^') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let mut ends: Vec<(char, char)> = Vec::new();
    let mut range = false;
    while let Some(first) = rest.chars().next() {
        if first == '-' && !ends.is_empty() {
            range = true;
            rest = &rest[1..];
            continue;
        }
        let length = match first {
            '#' => {
                2 + end_of(&rest[2..], |c| {
                    c.is_ascii_digit() || ('A'..='F').contains(&c)
                })
            }
            c => c.len_utf8(),
        };
        let c = match first {
            '#' => code_point(&rest[..length]),
            c => c,
        };
        match ends.last_mut() {
            Some(last) if range => last.1 = c,
            _ => ends.push((c, c)),
        }
        range = false;
        rest = &rest[length..];
    }
    Word::Class(negated, ends)
}

struct Reader<'a> {
    words: Peekable<Cloned<Iter<'a, Word>>>,
    choices: &'a mut usize,
}

impl Reader<'_> {
    fn number(&mut self) -> usize {
        *self.choices += 1;
        *self.choices
    }

    fn takes(&mut self, sign: char) -> bool {
        self.words.next_if_eq(&Word::Sign(sign)).is_some()
    }

    fn choice(&mut self) -> Part {
        let mut all = vec![self.sequence()];
        while self.takes('|') {
            all.push(self.sequence());
        }
        match all.len() {
            1 => all.remove(0),
            _ => Part::Choice(self.number(), all),
        }
    }

    fn sequence(&mut self) -> Part {
        let mut all = Vec::new();
        while !matches!(self.words.peek(), None | Some(Word::Sign('|' | ')'))) {
            let part = self.repeated();
            if self.takes('-') {
                let exception = Box::new(self.repeated());
                all.push(Part::Except(Box::new(part), exception));
            } else {
                all.push(part);
            }
        }
        match all.len() {
            1 => all.remove(0),
            _ => Part::Sequence(all),
        }
    }

    fn repeated(&mut self) -> Part {
        let part = match self.words.next() {
            Some(Word::Name(name)) => Part::Rule(name),
            Some(Word::Literal(text)) => Part::Literal(text),
            Some(Word::Class(negated, ranges)) => Part::Class(negated, ranges),
            Some(Word::Sign('(')) => {
                let inner = self.choice();
                assert!(self.takes(')'));
                inner
            }
            other => panic!("unexpected {other:?}"),
        };
        if self.takes('?') {
            Part::Optional(self.number(), Box::new(part))
        } else if self.takes('*') {
            Part::Repeated(self.number(), false, Box::new(part))
        } else if self.takes('+') {
            Part::Repeated(self.number(), true, Box::new(part))
        } else {
            part
        }
    }
}
