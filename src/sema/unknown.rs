use crate::curve::kinds;
use crate::diag::Code;
use crate::number::Unit;
use crate::syntax::ast::Name;

use super::call::BUILT_IN;
use super::lowerer::{Lowerer, Reported};
use super::scope::Scope;
use super::spelling;

/// Words of mathematics that the language cannot have, for they are not rational.
const IRRATIONAL: [&str; 8] = ["pi", "π", "sin", "cos", "tan", "exp", "log", "ln"];

/// What only an expectation may ask.
const QUALITIES: [&str; 5] = [
    "bidegree",
    "common_factor",
    "positive_weights",
    "rational_offset",
    "regular",
];

impl Lowerer<'_> {
    /// Reports a name that nothing declares, with the way out where one is known.
    pub(super) fn report_unknown(&mut self, name: &Name, scope: &Scope<'_>) -> Reported {
        let text = name.text.as_str();
        if self.is_full() || self.broken.contains(&text) {
            return Reported;
        }
        let message = format!("`{text}` is not declared");
        let finding = self.finding(scope, Code::E0101, name.span, message);
        let finding = if IRRATIONAL.contains(&text) {
            finding.help("all values are rational: `turn(h)` is the cosine and sine of 2 arctan h")
        } else if Unit::from_symbol(text).is_some() {
            finding.help(format!(
                "numbers carry no unit; `unit {text}` holds for the file"
            ))
        } else if let Some(near) = self.nearest(text, scope) {
            finding
                .help(format!("did you mean `{near}`?"))
                .fix(name.span, near)
        } else {
            finding
        };
        self.report(finding)
    }

    /// The nearest spelling that means something, if it is near.
    fn nearest(&self, name: &str, scope: &Scope<'_>) -> Option<String> {
        if scope.frame.is_none()
            && let Some(property) = spelling::property_misspelt(name)
        {
            return Some(property.to_owned());
        }
        let frame = scope.frame.as_ref();
        let local: Vec<String> = frame
            .map(|frame| frame.bindings.borrow().keys().cloned().collect())
            .unwrap_or_default();
        let fixed = BUILT_IN
            .into_iter()
            .chain(kinds::ALL.iter().map(|kind| kind.name))
            .chain(QUALITIES.into_iter().filter(|_| frame.is_none()));
        let declared = self.definitions.keys().copied().chain(fixed);
        let known = local.into_iter().chain(declared.map(str::to_owned));
        spelling::nearest(name, known)
    }
}
