use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::rc::Rc;

use crate::curve::{Curve, Parameter};
use crate::diag::{Code, Diagnostic, Diagnostics, FileId, Limits, SourceMap, Span};
use crate::number::{Real, Tower, Unit};
use crate::sweep::{Scalar, SweptSurface};
use crate::syntax::ast::{Declaration, Document, Expr, Item, Name, Role};

use super::definition::{Definition, DefinitionForm, definition_of};
use super::definitions::Definitions;
use super::library::Library;
use super::scope::{Function, Scope};
use super::spelling;
use super::value::Value;
use super::{Program, circle};

/// The names that the language keeps for properties, parameters and unit vectors.
pub const RESERVED: [&str; 14] = [
    "x", "y", "z", "σ", "s", "t", "n", "κ", "ρ", "u", "v", "i", "j", "k",
];

/// How many findings about names and types one run reports at most.
const FINDINGS: usize = 100;

/// A finding that has been reported already.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reported;

pub(super) type Lowered<T> = Result<T, Reported>;

/// What a compilation starts from.
#[derive(Debug)]
pub struct Sources<'a> {
    /// The texts, for messages.
    pub map: &'a SourceMap,
    /// The root file first, then its imports.
    pub documents: &'a [Document],
    /// The standard library.
    pub library: &'a Library,
    /// Values that replace those of `param` declarations.
    pub overrides: &'a HashMap<String, Real>,
    /// What the input may ask for.
    pub limits: &'a Limits,
}

/// Resolves names and types; what is sound goes into the program, every finding into the list.
#[must_use]
pub fn lower(sources: &Sources<'_>, diagnostics: &mut Diagnostics) -> Program {
    let mut lowerer = Lowerer::new(sources, lacks_import(sources.documents, diagnostics));
    lowerer.declare();
    let program = lowerer.program();
    diagnostics.extend(lowerer.diagnostics);
    program
}

/// Whether a file is missing that an import names: names that nothing declares may be its own.
/// Files that import each other are all there.
fn lacks_import(documents: &[Document], diagnostics: &Diagnostics) -> bool {
    let missing = |own: &Item| match &own.declaration {
        Declaration::Import { path_span, .. } => diagnostics
            .errors()
            .any(|found| found.primary == Some(*path_span) && found.code != Code::E0604),
        _ => false,
    };
    documents.iter().flat_map(|own| &own.items).any(missing)
}

/// The meaning of a declared name, once it has been asked for.
#[derive(Debug, Clone)]
pub(super) enum Meaning {
    InProgress,
    Failed,
    Constant(Value),
    Function(Rc<Function>),
    Curve(Rc<Curve>),
    Surface(Rc<SweptSurface>),
}

/// The work of [`lower`]: definitions by name, and their meanings as far as they are known.
pub(super) struct Lowerer<'a> {
    pub(super) sources: &'a Sources<'a>,
    /// The field of all numbers, which grows as they need it.
    pub(super) tower: Tower,
    pub(super) definitions: Definitions<'a>,
    pub(super) meanings: BTreeMap<&'a str, Meaning>,
    /// Names that are being worked out, outermost first.
    pub(super) pending: Vec<&'a Name>,
    pub(super) diagnostics: Diagnostics,
    /// How deep the expression under work is nested.
    pub(super) depth: usize,
    /// Surfaces that the expectation under work mentions.
    pub(super) mentioned: Vec<String>,
    /// Curves whose cusps have been reported.
    pub(super) cusps_reported: Vec<String>,
    /// Shared zeros and cusps of curves.
    pub(super) shared_zeros: Vec<(Parameter, (Real, Real))>,
    /// Whether declarations are missing with an imported file; names that nothing declares are not
    /// reported then.
    pub(super) lacks_import: bool,
    /// Names whose declarations could not be parsed; their uses are not reported.
    pub(super) broken: BTreeSet<&'a str>,
    /// What kinds of curves could not be parsed; uses of their properties are not reported.
    pub(super) broken_roles: HashSet<Role>,
    /// Where names stand in constructions that have been reported as undeclared.
    pub(super) undeclared: BTreeSet<Span>,
}

impl<'a> Lowerer<'a> {
    fn new(sources: &'a Sources<'a>, lacks_import: bool) -> Self {
        let broken = || sources.documents.iter().flat_map(|own| &own.broken);
        Self {
            sources,
            tower: Tower::new(sources.limits.field_degree),
            definitions: Definitions::new(sources.library),
            meanings: BTreeMap::new(),
            pending: Vec::new(),
            diagnostics: Diagnostics::default(),
            depth: 0,
            mentioned: Vec::new(),
            cusps_reported: Vec::new(),
            shared_zeros: Vec::new(),
            lacks_import,
            broken: broken().map(|own| own.name.text.as_str()).collect(),
            broken_roles: broken().filter_map(|own| own.role).collect(),
            undeclared: BTreeSet::new(),
        }
    }

    /// Reports a finding.
    pub(super) fn report(&mut self, diagnostic: Diagnostic) -> Reported {
        if self.diagnostics.len() < FINDINGS {
            self.diagnostics.push(diagnostic);
        }
        Reported
    }

    /// Whether so many findings have been reported that another one is not kept.
    pub(super) fn is_full(&self) -> bool {
        self.diagnostics.len() >= FINDINGS
    }

    /// A finding about an expression; inside a construction it stands where that is used.
    pub(super) fn finding(
        &self,
        scope: &Scope<'_>,
        code: Code,
        span: Span,
        message: impl Into<String>,
    ) -> Diagnostic {
        let site = scope.site(span);
        let finding = Diagnostic::new(code, site, message);
        match &scope.frame {
            Some(frame) if site != span => {
                let text = self.sources.map.slice(span);
                finding.related(
                    span,
                    format!("`{}` needs `{text}` here", frame.construction),
                )
            }
            _ => finding,
        }
    }

    /// Enters one level of nesting.
    pub(super) fn descend<T>(
        &mut self,
        scope: &Scope<'_>,
        span: Span,
        work: impl FnOnce(&mut Self) -> Lowered<T>,
    ) -> Lowered<T> {
        let limit = self.sources.limits.nesting;
        if self.depth >= limit {
            let message = format!("nested more than {limit} levels deep");
            let finding = self.finding(scope, Code::E0502, span, message);
            return Err(self.report(finding.help("raise the limit with `--max-nesting`")));
        }
        self.depth += 1;
        let result = work(self);
        self.depth -= 1;
        result
    }

    fn declare(&mut self) {
        for document in self.sources.documents {
            for item in &document.items {
                if let Some(definition) = definition_of(&item.declaration) {
                    self.declare_one(definition);
                }
            }
        }
    }

    fn declare_one(&mut self, definition: Definition<'a>) {
        let Definition { name, form } = definition;
        if let Some(meaning) = reserved_meaning(&name.text) {
            let message = format!("`{}` is reserved", name.text);
            let finding = Diagnostic::new(Code::E0103, name.span, message).label(meaning);
            self.report(finding.help("choose another name"));
            return;
        }
        if let Some(earlier) = self.definitions.of_file(&name.text) {
            let message = format!("`{}` is declared twice", name.text);
            let finding = Diagnostic::new(Code::E0102, name.span, message).label("again here");
            let finding = finding.related(earlier.span(), "first declared here");
            self.report(finding);
            return;
        }
        if matches!(form, DefinitionForm::Construction { .. })
            && self.sources.library.get(&name.text).is_some()
        {
            let message = format!(
                "`{}` replaces the construction of the standard library",
                name.text
            );
            self.report(Diagnostic::new(Code::W1002, name.span, message));
        }
        self.definitions.insert(definition);
    }

    /// The sound curves of a file.
    fn curves(&self, document: &Document) -> Vec<Rc<Curve>> {
        let names = document.items.iter().filter_map(|item| {
            let definition = definition_of(&item.declaration)?;
            self.meanings.get(definition.name.text.as_str())
        });
        let curves = names.filter_map(|meaning| match meaning {
            Meaning::Curve(curve) => Some(Rc::clone(curve)),
            _ => None,
        });
        curves.collect()
    }

    fn program(&mut self) -> Program {
        let Some(root) = self.sources.documents.first() else {
            return Program::default();
        };
        let mut program = Program {
            unit: self.unit(),
            tower: self.tower.clone(),
            ..Program::default()
        };
        self.check_names_of_constructions();
        self.check_every_definition();
        program.curves = self.curves(root);
        for item in &root.items {
            if let Declaration::Surface { name, .. } = &item.declaration {
                program.declares_surfaces = true;
                if let Ok(surface) = self.surface(name) {
                    program.surfaces.push((*surface).clone());
                }
            }
        }
        for item in &root.items {
            if let Declaration::Expect { left, relation } = &item.declaration {
                let text = self.sources.map.slice(item.span);
                let text = text
                    .strip_prefix("expect")
                    .unwrap_or(text)
                    .trim()
                    .to_owned();
                if let Ok(expectation) =
                    self.expectation(text, item.span, left, relation.as_ref(), &program.surfaces)
                {
                    program.expectations.push(expectation);
                }
            }
        }
        program.shared_zeros = std::mem::take(&mut self.shared_zeros);
        program
    }

    /// Works out every constant, function and curve, used or not, so that one run reports all.
    fn check_every_definition(&mut self) {
        let documents = self.sources.documents;
        for item in documents.iter().flat_map(|document| &document.items) {
            if let Some(Definition { name, form }) = definition_of(&item.declaration) {
                let known = self.definitions.of_file(&name.text);
                let own = known.is_some_and(|known| known.span() == name.span);
                if own
                    && !matches!(
                        form,
                        DefinitionForm::Construction { .. } | DefinitionForm::Surface { .. }
                    )
                {
                    let _ = self.meaning(name, &Scope::constant());
                }
            }
        }
    }

    /// The unit of the root file; its imports must agree with it.
    fn unit(&mut self) -> Unit {
        let mut chosen: Option<(Unit, Span)> = None;
        for (index, document) in self.sources.documents.iter().enumerate() {
            for item in &document.items {
                let Declaration::Unit { name } = &item.declaration else {
                    continue;
                };
                let Some(unit) = Unit::from_symbol(&name.text) else {
                    let message = format!("`{}` is not a length unit", name.text);
                    let finding = Diagnostic::new(Code::E0101, name.span, message);
                    let finding = finding.help("the units are mm, cm, m and inch");
                    self.report(match spelling::unit_meant(&name.text) {
                        Some(meant) => finding.fix(name.span, meant),
                        None => finding,
                    });
                    continue;
                };
                let known = chosen.map_or_else(Unit::default, |(unit, _)| unit);
                let finding = match chosen {
                    Some((_, first)) if first.file == name.span.file => {
                        Diagnostic::new(Code::E0102, name.span, "the length unit is given twice")
                            .related(first, "first given here")
                    }
                    _ if index > 0 && unit != known => {
                        let (own, root) = (unit.symbol(), known.symbol());
                        let message =
                            format!("this file is in {own}, the file that imports it in {root}");
                        Diagnostic::new(Code::E0211, name.span, message)
                            .help(format!("write `unit {own}` in the file that is compiled"))
                    }
                    _ => {
                        chosen = chosen.or(Some((unit, name.span)));
                        continue;
                    }
                };
                self.report(finding);
            }
        }
        chosen.map(|(unit, _)| unit).unwrap_or_default()
    }

    /// The only curve of a role in a file, or else among all files; none if there are several.
    pub(super) fn only_curve(&self, role: Role, file: FileId) -> Result<&'a Name, usize> {
        let all = || self.definitions.of_files().filter(|own| own.is_curve(role));
        let here = || all().filter(|own| own.span().file == file);
        let found = match here().next() {
            Some(_) => sole(here()),
            None => sole(all()),
        };
        found.map(|own| own.name).ok_or_else(|| all().count())
    }

    /// The names of the curves of a role, in the order of the text.
    pub(super) fn curves_of(&self, role: Role) -> Vec<&'a Name> {
        let curves = self.definitions.of_files().filter(|own| own.is_curve(role));
        let mut names: Vec<_> = curves.map(|own| own.name).collect();
        names.sort_by_key(|own| own.span);
        names
    }

    /// What a declared name means; it is worked out at its first use.
    pub(super) fn meaning(&mut self, name: &Name, scope: &Scope<'a>) -> Lowered<Meaning> {
        let Some(definition) = self.definitions.get(&name.text) else {
            return Err(Reported);
        };
        let key: &'a str = &definition.name.text;
        match self.meanings.get(key) {
            Some(Meaning::Failed) => return Err(Reported),
            Some(Meaning::InProgress) => return Err(self.report_cycle(name, scope)),
            Some(known) => return Ok(known.clone()),
            None => {}
        }
        self.meanings.insert(key, Meaning::InProgress);
        self.pending.push(definition.name);
        let result = self.descend(scope, name.span, |own| own.define(&definition));
        self.pending.pop();
        let meaning = result.unwrap_or(Meaning::Failed);
        self.meanings.insert(key, meaning.clone());
        match meaning {
            Meaning::Failed => Err(Reported),
            known => Ok(known),
        }
    }

    fn define(&mut self, definition: &Definition<'a>) -> Lowered<Meaning> {
        match definition.form {
            DefinitionForm::Constant { value, is_param } => {
                let given = self.sources.overrides.get(&definition.name.text);
                if let (Some(given), true) = (given, is_param) {
                    let number = Scalar::constant(value.span, given.clone());
                    return Ok(Meaning::Constant(Value::Scalar(number)));
                }
                self.constant(value).map(Meaning::Constant)
            }
            DefinitionForm::Function { parameters, value } => {
                let parameters = self.parameters(parameters)?;
                let value = self.value(value, &Scope::of(&parameters))?;
                Ok(Meaning::Function(Rc::new(Function { parameters, value })))
            }
            DefinitionForm::Curve { .. } => self.curve(definition).map(Meaning::Curve),
            DefinitionForm::Surface { domain, value } => {
                let surface = self.define_surface(definition.name, domain, value)?;
                Ok(Meaning::Surface(Rc::new(surface)))
            }
            DefinitionForm::Construction { .. } => Err(Reported),
        }
    }

    /// A constant expression, of any type.
    pub(super) fn constant(&mut self, value: &'a Expr) -> Lowered<Value> {
        let lowered = self.value(value, &Scope::constant())?;
        let numbers = lowered
            .components()
            .iter()
            .map(|own| self.number(own, &Scope::constant()))
            .collect::<Lowered<Vec<Real>>>()?;
        let limit = self.sources.limits.bits;
        if numbers.iter().any(|own| own.bits() > limit) {
            let message = format!("this number has more than {limit} bits");
            let finding = Diagnostic::new(Code::E0507, value.span, message);
            return Err(self.report(finding.help("raise the limit with `--max-bits`")));
        }
        let mut numbers = numbers.into_iter();
        Ok(lowered.map(|own| match numbers.next() {
            Some(number) => Scalar::constant(value.span, number),
            None => own.clone(),
        }))
    }

    /// The parameters of a function: u, v, or both in this order.
    fn parameters(&mut self, names: &[Name]) -> Lowered<Vec<Parameter>> {
        let mut parameters = Vec::new();
        for name in names {
            let message = match parameter_of(&name.text) {
                Some(own) if !parameters.contains(&own) => {
                    parameters.push(own);
                    continue;
                }
                Some(_) => format!("the parameter `{}` stands twice", name.text),
                None => format!("a function takes `u`, `v` or both, not `{}`", name.text),
            };
            let finding = Diagnostic::new(Code::E0109, name.span, message);
            return Err(self.report(finding.help("write `(u)`, `(v)` or `(u, v)`")));
        }
        if let ([Parameter::V, Parameter::U], [first, .., last]) = (parameters.as_slice(), names) {
            let span = first.span.to(last.span);
            let finding = Diagnostic::new(Code::E0109, span, "`u` stands before `v`");
            let finding = finding.help("write `(u, v)`, and the arguments in this order");
            return Err(self.report(finding.fix(span, "u, v")));
        }
        Ok(parameters)
    }

    fn report_cycle(&mut self, name: &Name, scope: &Scope<'_>) -> Reported {
        let start = self
            .pending
            .iter()
            .position(|own| own.text == name.text)
            .unwrap_or(0);
        let cycle: Vec<&str> = self.pending[start..]
            .iter()
            .map(|own| own.text.as_str())
            .collect();
        let mut finding = self.finding(scope, Code::E0104, name.span, circle::message(&cycle));
        for own in &self.pending[start..] {
            finding = finding.related(own.span, format!("`{}` is defined here", own.text));
        }
        self.report(finding)
    }
}

/// The only one.
fn sole<T>(mut all: impl Iterator<Item = T>) -> Option<T> {
    let first = all.next()?;
    all.next().is_none().then_some(first)
}

/// u or v, by name.
pub(super) fn parameter_of(name: &str) -> Option<Parameter> {
    match name {
        "u" => Some(Parameter::U),
        "v" => Some(Parameter::V),
        _ => None,
    }
}

/// Whether a name is one of [`RESERVED`]: nothing that is declared or handed over has it.
pub(super) fn is_reserved(name: &str) -> bool {
    reserved_meaning(name).is_some()
}

fn reserved_meaning(name: &str) -> Option<&'static str> {
    Some(match name {
        "u" | "v" => "this is a parameter of curves and surfaces",
        "i" | "j" | "k" => "this is a unit vector",
        "x" | "y" | "z" => "this is a coordinate of a curve",
        "σ" => "this is the parametric speed of a curve",
        "s" => "this is the arc length of a curve",
        "t" => "this is the unit tangent of a curve",
        "n" => "this is the unit normal of a curve",
        "κ" => "this is the curvature of a curve",
        "ρ" => "this is the radius of curvature of a curve",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved_names_are_those_of_the_list() {
        assert!(RESERVED.into_iter().all(is_reserved));
        let letters = ('a'..='z').chain('α'..='ω').map(String::from);
        let reserved = letters.filter(|own| is_reserved(own)).count();
        assert_eq!(reserved, RESERVED.len());
        assert!(!is_reserved("") && !is_reserved("uv"));
    }
}
