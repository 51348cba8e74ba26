//! Colours a text by a TextMate grammar: `match`, `begin` and `end`, `captures`, `include`. Anything
//! else in a grammar is an error, so that nothing is passed over in silence.

use std::collections::HashMap;
use std::ops::Range;

use fancy_regex::{Captures, Regex};
use serde_json::Value;

const KEYS: &[&str] = &[
    "begin",
    "beginCaptures",
    "captures",
    "comment",
    "end",
    "endCaptures",
    "include",
    "match",
    "name",
    "patterns",
];

/// A grammar whose regular expressions are compiled.
pub(crate) struct TextMate {
    grammar: Value,
    regexes: HashMap<String, Regex>,
}

/// A text with the scopes of each of its bytes.
pub(crate) struct Coloured(Vec<Vec<String>>);

impl Coloured {
    /// The innermost scopes of a range, which must be the same everywhere in it.
    pub(crate) fn scopes(&self, range: Range<usize>) -> &[String] {
        let first = &self.0[range.start];
        assert!(self.0[range].iter().all(|own| own == first));
        first
    }
}

impl TextMate {
    pub(crate) fn new(grammar: &str) -> Self {
        let mut own = Self {
            grammar: serde_json::from_str(grammar).unwrap(),
            regexes: HashMap::new(),
        };
        let repository = own.grammar["repository"].as_object().unwrap();
        let rules: Vec<Value> = repository.values().cloned().collect();
        for rule in [own.grammar["patterns"].as_array().unwrap().clone(), rules].concat() {
            own.compile(&rule);
        }
        own
    }

    /// Compiles the expressions of a rule and of those in it; checks its keys.
    fn compile(&mut self, rule: &Value) {
        for (key, value) in rule.as_object().unwrap() {
            assert!(KEYS.contains(&key.as_str()), "{key} in {rule}");
            if ["match", "begin", "end"].contains(&key.as_str()) {
                let source = value.as_str().unwrap();
                let regex = Regex::new(source).expect(source);
                self.regexes.insert(source.to_owned(), regex);
            }
            if key == "include" {
                assert!(self.included(value).is_object(), "{value}");
            }
        }
        for inner in rule["patterns"].as_array().into_iter().flatten() {
            self.compile(inner);
        }
    }

    /// The rule of the repository that `#name` stands for.
    fn included(&self, name: &Value) -> &Value {
        let name = name.as_str().and_then(|own| own.strip_prefix('#'));
        &self.grammar["repository"][name.unwrap()]
    }

    /// The parts of the repository that some rule includes.
    pub(crate) fn unused(&self) -> Vec<&str> {
        let text = self.grammar.to_string();
        let names = self.grammar["repository"].as_object().unwrap().keys();
        names
            .filter(|own| !text.contains(&format!("\"#{own}\"")))
            .map(String::as_str)
            .collect()
    }

    /// The rules with an expression that some patterns lead to, in order.
    fn rules<'a>(&'a self, patterns: &'a Value, found: &mut Vec<&'a Value>) {
        for rule in patterns.as_array().unwrap() {
            let rule = match rule.get("include") {
                Some(name) => self.included(name),
                None => rule,
            };
            if rule.get("match").is_some() || rule.get("begin").is_some() {
                found.push(rule);
            } else {
                self.rules(&rule["patterns"], found);
            }
        }
    }

    fn find<'t>(&self, source: &Value, line: &'t str, at: usize) -> Option<Captures<'t, str>> {
        let regex = &self.regexes[source.as_str().unwrap()];
        regex.captures_from_pos(line, at).unwrap()
    }

    /// The scopes of every byte of a text.
    pub(crate) fn colour(&self, text: &str) -> Coloured {
        let mut scopes = vec![Vec::new(); text.len()];
        let (mut open, mut start) = (Vec::new(), 0);
        for line in text.split_inclusive(['\n', '\r']) {
            let content = line.trim_end_matches(['\n', '\r']);
            self.colour_line(content, &mut open, &mut scopes[start..]);
            start += line.len();
        }
        Coloured(scopes)
    }

    /// Colours a line; `open` holds the rules that began before and have not ended.
    fn colour_line<'a>(&'a self, line: &str, open: &mut Vec<&'a Value>, to: &mut [Vec<String>]) {
        let mut at = 0;
        loop {
            let mut rules = Vec::new();
            let patterns = open.last().map_or(&self.grammar, |own| *own);
            self.rules(&patterns["patterns"], &mut rules);
            let end = open.last().and_then(|own| {
                let found = self.find(&own["end"], line, at)?;
                Some((found, None))
            });
            let others = rules.into_iter().filter_map(|rule| {
                let source = rule.get("match").unwrap_or(&rule["begin"]);
                Some((self.find(source, line, at)?, Some(rule)))
            });
            // the first one where several begin at one place
            let matches = end.into_iter().chain(others);
            let Some((found, rule)) =
                matches.min_by_key(|(found, _)| found.get(0).unwrap().start())
            else {
                return;
            };
            let captures = match rule {
                None => &open.pop().unwrap()["endCaptures"],
                Some(rule) if rule.get("begin").is_some() => {
                    open.push(rule);
                    &rule["beginCaptures"]
                }
                Some(rule) => &rule["captures"],
            };
            let whole = found.get(0).unwrap().range();
            if let Some(name) = rule.and_then(|own| own.get("name")) {
                paint(&mut to[whole.clone()], name);
            }
            for (group, capture) in captures.as_object().into_iter().flatten() {
                if let Some(part) = found.get(group.parse().unwrap()) {
                    paint(&mut to[part.range()], &capture["name"]);
                }
            }
            assert!(rule.is_none() || !whole.is_empty(), "an empty match");
            at = whole.end;
        }
    }
}

/// Adds scopes to some bytes.
fn paint(to: &mut [Vec<String>], name: &Value) {
    let names = name.as_str().unwrap().split(' ');
    for own in to {
        own.extend(names.clone().map(str::to_owned));
    }
}
