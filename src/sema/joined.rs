//! Names that are written side by side without a blank between them: `uv` for `u v`.

use crate::syntax::ast::Name;

use super::call::BUILT_IN;
use super::definition::DefinitionForm;
use super::lowerer::{Lowerer, Meaning, is_reserved, parameter_of};
use super::scope::{Binding, Scope};
use super::value::Value;

/// The longest word that is taken apart, in characters.
const LONGEST: usize = 16;

/// What a name may be in a product.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Factor {
    Scalar,
    /// A vector or a pair; a product has one at most.
    Vector,
    /// What a parenthesis with arguments follows.
    Function,
}

/// A word taken apart.
pub(super) struct Joined {
    /// The product, `u v`.
    pub(super) product: String,
    /// What stands for the word where it stands, if that is certain.
    pub(super) edit: Option<String>,
}

impl Lowerer<'_> {
    /// The product that an unknown word was probably meant to be, if it can be taken apart in one
    /// way only.
    pub(super) fn joined(&self, name: &Name, scope: &Scope<'_>) -> Option<Joined> {
        let behind = self.behind(name);
        if name.text.chars().count() > LONGEST || behind.starts_with(['.', '\'', '’', '′', '″'])
        {
            return None;
        }
        let applied = behind.starts_with('(');
        let mut found = Vec::new();
        self.take_apart(&name.text, applied, scope, &mut Vec::new(), &mut found);
        let [product] = found.as_slice() else {
            return None;
        };
        let before = self.sources.map.file(name.span.file).text.as_str();
        let before = before.get(..name.span.start as usize)?.trim_end();
        let edit = match before.chars().next_back() {
            Some('^') => None,
            Some('/') if behind.starts_with(['(', '^']) => None,
            Some('/') => Some(format!("({product})")),
            _ => Some(product.clone()),
        };
        let product = product.clone();
        Some(Joined { product, edit })
    }

    /// What follows a name in its file, blanks left out.
    pub(super) fn behind(&self, name: &Name) -> &str {
        let text = self.sources.map.file(name.span.file).text.as_str();
        let behind = text.get(name.span.end as usize..).unwrap_or_default();
        behind.trim_start_matches([' ', '\t'])
    }

    /// Collects the ways, up to two, to take a word apart into two names or more; `applied` says
    /// that the last of them may be a function.
    fn take_apart<'t>(
        &self,
        word: &'t str,
        applied: bool,
        scope: &Scope<'_>,
        names: &mut Vec<(&'t str, Factor)>,
        found: &mut Vec<String>,
    ) {
        if word.is_empty() {
            let vectors = names.iter().filter(|(_, own)| *own == Factor::Vector);
            if names.len() > 1 && vectors.count() < 2 {
                let names: Vec<&str> = names.iter().map(|(own, _)| *own).collect();
                found.push(names.join(" "));
            }
            return;
        }
        let ends = word.char_indices().map(|(at, c)| at + c.len_utf8());
        for end in ends.collect::<Vec<_>>() {
            let (first, rest) = word.split_at(end);
            let fits = |own: &Factor| *own != Factor::Function || (applied && rest.is_empty());
            if found.len() < 2
                && let Some(factor) = self.factor(first, scope).filter(fits)
            {
                names.push((first, factor));
                self.take_apart(rest, applied, scope, names, found);
                names.pop();
            }
        }
    }

    fn factor(&self, name: &str, scope: &Scope<'_>) -> Option<Factor> {
        if let Some(binding) = scope.binding(name) {
            return match binding {
                Binding::Curve(_) | Binding::Function(_) => Some(Factor::Function),
                Binding::Value(value) => Some(factor_of(&value)),
                Binding::Pending(_) | Binding::InProgress | Binding::Failed => Some(Factor::Scalar),
            };
        }
        if let Some(parameter) = parameter_of(name) {
            return scope.allows(parameter).then_some(Factor::Scalar);
        }
        if ["i", "j", "k"].contains(&name) {
            return Some(Factor::Vector);
        }
        if let Some(definition) = self.definitions.get(name) {
            return Some(match (definition.form, self.meanings.get(name)) {
                (_, Some(Meaning::Constant(value))) => factor_of(value),
                (DefinitionForm::Constant { .. }, _) => Factor::Scalar,
                _ => Factor::Function,
            });
        }
        let is_property = is_reserved(name) && scope.frame.is_none();
        (is_property || BUILT_IN.contains(&name)).then_some(Factor::Function)
    }

    /// The single letter that a word repeats, `z` for `zz`, where it means something.
    pub(super) fn repeated(&self, name: &Name, scope: &Scope<'_>) -> Option<String> {
        let mut letters = name.text.chars();
        let letter = letters.next()?;
        let single = letter.to_string();
        let repeats = letters.clone().next().is_some() && letters.all(|own| own == letter);
        let factor = self.factor(&single, scope).filter(|_| repeats)?;
        let applied = self.behind(name).starts_with('(');
        (applied || factor != Factor::Function).then_some(single)
    }
}

fn factor_of(value: &Value) -> Factor {
    match value {
        Value::Scalar(_) => Factor::Scalar,
        _ => Factor::Vector,
    }
}
