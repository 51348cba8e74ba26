//! Sentences of the grammar, derived at random.

use std::collections::HashMap;

use crate::ebnf::{Grammar, Part};

/// Characters for `[^…]`: plain ones, and those that mean something elsewhere.
const ANY: &[char] = &[
    'a', 'Z', '0', ' ', '\t', '#', '"', '\'', '(', ']', ',', '=', '/', '*', 'σ', 'ς', 'с', '−',
    '²', '𝜎', '…', '\\', '.',
];
/// Beyond these a derivation takes the shortest way to its end.
const DEPTH: usize = 40;
const TOKENS: usize = 90;

/// Splitmix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((z ^ (z >> 31)) % below as u64).unwrap()
    }
}

/// A source of sentences that remembers which ways it took.
pub(crate) struct Derivation<'a> {
    grammar: &'a Grammar,
    pub(crate) random: Random,
    /// How often each outcome of each choice was taken.
    pub(crate) taken: HashMap<(usize, usize), usize>,
    /// The length of the shortest way through each rule.
    heights: HashMap<String, usize>,
}

impl<'a> Derivation<'a> {
    pub(crate) fn new(grammar: &'a Grammar, seed: u64) -> Self {
        let mut own = Self {
            grammar,
            random: Random(seed),
            taken: HashMap::new(),
            heights: HashMap::new(),
        };
        for _ in &grammar.names {
            for name in &grammar.names {
                if let Some(height) = own.height(grammar.rule(name)) {
                    own.heights.insert(name.clone(), height + 1);
                }
            }
        }
        assert_eq!(own.heights.len(), grammar.names.len(), "a rule has no end");
        own
    }

    /// The least depth of a derivation, where it is known yet.
    fn height(&self, part: &Part) -> Option<usize> {
        match part {
            Part::Rule(name) => self.heights.get(name).copied(),
            Part::Literal(_) | Part::Class(..) => Some(0),
            Part::Optional(..) | Part::Repeated(_, false, _) => Some(0),
            Part::Repeated(_, true, inner) | Part::Except(inner, _) => self.height(inner),
            Part::Sequence(all) => all
                .iter()
                .map(|own| self.height(own))
                .try_fold(0, |highest: usize, own| Some(highest.max(own?))),
            Part::Choice(_, all) => all.iter().filter_map(|own| self.height(own)).min(),
        }
    }

    /// An outcome of a choice: often the one that was taken least.
    fn outcome(&mut self, number: usize, count: usize) -> usize {
        let own = match self.random.next(3) {
            0 => (0..count)
                .min_by_key(|own| self.taken.get(&(number, *own)).copied())
                .unwrap(),
            _ => self.random.next(count),
        };
        *self.taken.entry((number, own)).or_default() += 1;
        own
    }

    /// The tokens of a sentence of a rule.
    pub(crate) fn sentence(&mut self, rule: &str) -> Vec<String> {
        let mut tokens = Vec::new();
        let part = self.grammar.rule(rule);
        self.derive(part, 0, &mut tokens);
        tokens
    }

    fn derive(&mut self, part: &'a Part, depth: usize, tokens: &mut Vec<String>) {
        let short = depth > DEPTH || tokens.len() > TOKENS;
        match part {
            Part::Rule(name) if self.grammar.is_lexical(name) => {
                let token = self.word(name);
                tokens.push(token);
            }
            Part::Rule(name) if name == "Beside" => self.beside(depth, tokens),
            Part::Rule(name) => self.derive(self.grammar.rule(name), depth + 1, tokens),
            Part::Literal(text) => tokens.push(text.clone()),
            Part::Sequence(all) => {
                for own in all {
                    self.derive(own, depth, tokens);
                }
            }
            Part::Choice(_, all) if short => {
                let least = all.iter().min_by_key(|own| self.height(own));
                self.derive(least.unwrap(), depth, tokens);
            }
            Part::Choice(number, all) => {
                let own = self.outcome(*number, all.len());
                self.derive(&all[own], depth, tokens);
            }
            Part::Optional(..) | Part::Repeated(_, false, _) if short => {}
            Part::Optional(number, inner) => {
                if self.outcome(*number, 2) == 1 {
                    self.derive(inner, depth, tokens);
                }
            }
            Part::Repeated(number, once, inner) => {
                if *once {
                    self.derive(inner, depth, tokens);
                }
                while tokens.len() <= TOKENS && self.outcome(*number, 2) == 1 {
                    self.derive(inner, depth, tokens);
                }
            }
            Part::Class(..) | Part::Except(..) => panic!("characters among the declarations"),
        }
    }

    /// Section 3.1: no number stands beside a factor, and no `x` that is not applied beside 0.
    fn beside(&mut self, depth: usize, tokens: &mut Vec<String>) {
        let start = tokens.len();
        if depth + 8 > DEPTH || start > TOKENS {
            // the shortest factor would be a number
            let name = self.word("NAME");
            return tokens.push(format!("n{name}"));
        }
        loop {
            self.derive(self.grammar.rule("Beside"), depth + 1, tokens);
            let first = tokens.get(start).map_or("", String::as_str);
            let zero = tokens[start - 1] == "0" && first.starts_with('x');
            if !zero && !first.starts_with(|c: char| c.is_ascii_digit()) {
                return;
            }
            tokens.truncate(start);
        }
    }

    /// A word of a rule about characters.
    pub(crate) fn word(&mut self, name: &str) -> String {
        let mut word = String::new();
        let part = self.grammar.rule(name);
        self.spell(part, &mut word);
        word
    }

    fn spell(&mut self, part: &'a Part, word: &mut String) {
        match part {
            Part::Rule(name) => self.spell(self.grammar.rule(name), word),
            Part::Literal(text) => word.push_str(text),
            Part::Class(false, ranges) => {
                let (first, last) = ranges[self.random.next(ranges.len())];
                let all: Vec<char> = (first..=last).collect();
                // the ends of a range are its corners
                word.push(match self.random.next(4) {
                    0 => first,
                    1 => last,
                    _ => all[self.random.next(all.len())],
                });
            }
            Part::Class(true, ranges) => {
                let is_out = |c: &char| !ranges.iter().any(|(a, b)| (*a..=*b).contains(c));
                let all: Vec<char> = ANY.iter().copied().filter(is_out).collect();
                word.push(all[self.random.next(all.len())]);
            }
            Part::Sequence(all) => {
                for own in all {
                    self.spell(own, word);
                }
            }
            Part::Choice(number, all) => {
                let own = self.outcome(*number, all.len());
                self.spell(&all[own], word);
            }
            Part::Optional(number, inner) => {
                if self.outcome(*number, 2) == 1 {
                    self.spell(inner, word);
                }
            }
            Part::Repeated(number, once, inner) => {
                if *once {
                    self.spell(inner, word);
                }
                while self.outcome(*number, 2) == 1 {
                    self.spell(inner, word);
                }
            }
            Part::Except(inner, exception) => {
                let start = word.len();
                loop {
                    self.spell(inner, word);
                    if !self.is_word_of(exception, &word[start..]) {
                        return;
                    }
                    word.truncate(start);
                }
            }
        }
    }

    /// Whether a word is one of the literals of a rule.
    fn is_word_of(&self, part: &Part, word: &str) -> bool {
        let Part::Rule(name) = part else {
            panic!("only a rule can be an exception");
        };
        self.grammar.literals(name).iter().any(|own| own == word)
    }
}
