use crate::curve::kinds;
use crate::diag::{Code, Diagnostic, Span};
use crate::number::Unit;
use crate::syntax::ast::Name;
use crate::syntax::lexer::Keyword;

use super::call::BUILT_IN;
use super::expectation::{QUERIES, quality_of};
use super::lowerer::{Lowerer, Reported, parameter_of};
use super::scope::Scope;
use super::spelling;

/// Words of mathematics that the language cannot have, for their values are no square roots.
const TRANSCENDENTAL: [&str; 8] = ["pi", "π", "sin", "cos", "tan", "exp", "log", "ln"];

/// How far back the start of a line is looked for.
const LONGEST_LINE: usize = 200;

impl Lowerer<'_> {
    /// Reports a name that nothing declares, with the way out where one is known.
    pub(super) fn report_unknown(&mut self, name: &Name, scope: &Scope<'_>) -> Reported {
        let text = name.text.as_str();
        let told = self.undeclared.contains(&name.span);
        if told || self.is_full() || self.broken.contains(text) {
            return Reported;
        }
        let lost = self.lost_keyword(name.span);
        if lost.is_some_and(|(first, _)| first != name.span) {
            // The whole line was meant to be a declaration, and its first word is reported.
            return Reported;
        }
        let finding = match self.misplaced(name, scope) {
            Some(finding) => finding,
            None if self.lacks_import && lost.is_none() => return Reported,
            None => self.not_declared(name, lost.map(|(_, keyword)| keyword), scope),
        };
        self.report(finding)
    }

    /// E0101; `lost` is the keyword that the name was probably meant to be.
    fn not_declared(
        &self,
        name: &Name,
        lost: Option<&'static str>,
        scope: &Scope<'_>,
    ) -> Diagnostic {
        let text = name.text.as_str();
        let message = format!("`{text}` is not declared");
        let finding = self.finding(scope, Code::E0101, name.span, message);
        if let Some(keyword) = lost {
            finding
                .help(format!("write `{keyword}`"))
                .fix(name.span, keyword)
        } else if TRANSCENDENTAL.contains(&text) {
            finding.help(
                "values are made of rational numbers and square roots; \
                 `turn(h)` is the cosine and sine of 2 arctan h",
            )
        } else if Unit::from_symbol(text).is_some() {
            finding.help(format!(
                "numbers carry no unit; `unit {text}` holds for the file"
            ))
        } else if let Some(joined) = self.joined(name, scope) {
            let finding = finding.help(format!("did you mean `{}`?", joined.product));
            match joined.edit {
                Some(edit) => finding.fix(name.span, edit),
                None => finding,
            }
        } else if let Some(near) = self
            .repeated(name, scope)
            .or_else(|| self.nearest(name, scope))
        {
            match self.misspelt_declaration(name, &near) {
                Some(declared) => finding
                    .help(format!(
                        "did you mean to declare it where `{near}` is declared?"
                    ))
                    .fix(declared, text),
                None => finding
                    .help(format!("did you mean `{near}`?"))
                    .fix(name.span, near),
            }
        } else {
            finding
        }
    }

    /// The finding about a word that the language has, where it has no place.
    fn misplaced(&self, name: &Name, scope: &Scope<'_>) -> Option<Diagnostic> {
        let text = name.text.as_str();
        let finding = |message: String| self.finding(scope, Code::E0107, name.span, message);
        if quality_of(text).is_some() {
            let message = format!("`{text}` stands only as an `expect` of its own");
            Some(finding(message).help(format!("write `expect {text}(R)`")))
        } else if QUERIES.contains(&text) {
            let message = format!("`{text}` stands only as a side of an `expect`");
            Some(finding(message).help(format!("write `expect {text}(R) == …`")))
        } else if BUILT_IN.contains(&text) {
            let message = format!("the function `{text}` needs its arguments");
            Some(finding(message).help(format!("write `{text}(…)`")))
        } else {
            self.misplaced_constructor(name, scope)
        }
    }

    /// Where a near name is declared, if its declaration seems to be what is misspelt: in this
    /// file nothing uses it, and the unknown name is used more than once.
    fn misspelt_declaration(&self, name: &Name, near: &str) -> Option<Span> {
        let declared = self.definitions.get(near)?.span();
        let text = &self.sources.map.file(name.span.file).text;
        let count = |word: &str| {
            let is_part = |c: char| c.is_alphanumeric() || c == '_';
            let ends = |at: usize| {
                let (before, behind) = (&text[..at], &text[at + word.len()..]);
                !before.ends_with(is_part) && !behind.starts_with(is_part)
            };
            text.match_indices(word).filter(|(at, _)| ends(*at)).count()
        };
        let lonely = declared.file == name.span.file && count(near) == 1;
        (lonely && count(&name.text) > 1).then_some(declared)
    }

    /// The undeclared word at the start of the line of a place, and the keyword that it was
    /// probably meant to be, where another word follows it: the line went into the value of the
    /// declaration before.
    fn lost_keyword(&self, place: Span) -> Option<(Span, &'static str)> {
        let text = self.sources.map.file(place.file).text.as_bytes();
        let before = text.get(..place.start as usize)?;
        let earliest = before.len().saturating_sub(LONGEST_LINE);
        let line = before[earliest..]
            .iter()
            .rposition(|own| b"\n\r".contains(own))?;
        let start = earliest + line + 1;
        let start = start + text[start..].iter().position(|own| !b" \t".contains(own))?;
        let length = text[start..]
            .iter()
            .position(|own| !own.is_ascii_alphabetic())?;
        let span = Span::new(place.file, start, start + length);
        let behind = text.get(start + length..)?.trim_ascii_start();
        let goes_on = behind
            .first()
            .is_some_and(|own| own.is_ascii_alphabetic() || *own == b'"');
        let word = self.sources.map.slice(span);
        let blank = text.get(start + length) == Some(&b' ');
        if !goes_on || !blank || self.definitions.contains(word) {
            return None;
        }
        Some((
            span,
            Keyword::meant(word)
                .filter(|own| own.as_str() != word)?
                .as_str(),
        ))
    }

    /// The nearest spelling that means something, if it is near.
    fn nearest(&self, name: &Name, scope: &Scope<'_>) -> Option<String> {
        let text = name.text.as_str();
        if scope.frame.is_none()
            && let Some(property) = spelling::property_misspelt(text)
        {
            return Some(property.to_owned());
        }
        let capital = ["U", "V"].contains(&text).then(|| text.to_lowercase());
        let allowed = |own: &String| parameter_of(own).is_some_and(|own| scope.allows(own));
        if let Some(parameter) = capital.filter(allowed) {
            return Some(parameter);
        }
        let frame = scope.frame.as_ref();
        let local: Vec<String> = frame
            .map(|frame| frame.bindings.borrow().keys().cloned().collect())
            .unwrap_or_default();
        // what the language has of its own are functions
        let applied = self.behind(name).starts_with('(');
        let fixed = BUILT_IN
            .into_iter()
            .chain(kinds::ALL.iter().map(|kind| kind.name))
            .chain(QUERIES.into_iter().filter(|_| frame.is_none()))
            .filter(|_| applied);
        let declared = self.definitions.names().into_iter().chain(fixed);
        let known = local.into_iter().chain(declared.map(str::to_owned));
        spelling::nearest(text, known)
    }
}
