//! The compiler on one screen: text → [`Document`] → [`Program`] → [`Checked`] → [`Model`]
//! → bytes.
//!
//! Each stage is a type, and data only moves forward. Reading and writing files is the affair of
//! the caller.

use std::collections::HashMap;
use std::rc::Rc;

use crate::check::{Checked, Judgement, Verdict, judge};
use crate::curve::{Curve, Parameter};
use crate::diag::{Code, Diagnostic, Diagnostics, Limits, SourceMap};
use crate::export::{Context, Exported, Exporter, Guide, StepSchema, View};
use crate::net::{Model, Part};
use crate::number::{Real, Unit};
use crate::report::Report;
use crate::sema::{self, Library, Program};
use crate::sweep::Scalar;
use crate::syntax;
use crate::syntax::ast::{Document, Item};

/// The standard library, in the language itself.
const LIBRARY: &str = include_str!("std/constructions.sweep");

/// What a compilation is asked for.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Values that replace those of `param` declarations.
    pub overrides: HashMap<String, Real>,
    /// The only surface to work on; all if there is none.
    pub surface: Option<String>,
    /// What the input may ask for.
    pub limits: Limits,
    /// Whether weights may differ by any factor in formats that lose accuracy by it.
    pub any_weight_ratio: bool,
    /// Where pictures are seen from.
    pub view: View,
    /// The application protocol of STEP files.
    pub step_schema: StepSchema,
    /// Whether surfaces in IGES are trimmed by their boundary curves.
    pub iges_trimmed: bool,
    /// The greatest distance between a surface and its triangles; none for a thousandth of the
    /// size.
    pub chord: Option<Real>,
}

/// A step of a compilation that is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step<'a> {
    /// Names are resolved and types checked.
    Lowered,
    /// The surface of this name is expanded and checked.
    Checked(&'a str),
    /// The expectations are decided.
    Judged,
}

/// A compiled file: what was proved of it, and every finding.
#[derive(Debug, Default)]
pub struct Compilation {
    /// The length unit.
    pub unit: Unit,
    /// The names of all surfaces that were asked for; those with errors have nothing behind them.
    pub surfaces: Vec<Option<Checked>>,
    /// The curves of the root file.
    pub curves: Vec<Rc<Curve>>,
    /// The expectations that could be decided or shown to be undecided.
    pub judgements: Vec<Judgement>,
    /// The findings, in the order of the text.
    pub diagnostics: Diagnostics,
}

/// Compiles parsed files, the root file first, up to checked surfaces.
#[must_use]
pub fn compile(
    sources: &mut SourceMap,
    documents: &[Document],
    options: &Options,
    diagnostics: Diagnostics,
) -> Compilation {
    compile_in_steps(sources, documents, options, diagnostics, &mut |_| {})
}

/// As [`compile`], and tells of every step that is done.
#[must_use]
pub fn compile_in_steps(
    sources: &mut SourceMap,
    documents: &[Document],
    options: &Options,
    mut diagnostics: Diagnostics,
    done: &mut dyn FnMut(Step<'_>),
) -> Compilation {
    let library = library(sources, &mut diagnostics);
    compile_with(&library, sources, documents, options, diagnostics, done)
}

/// As [`compile_in_steps`], with a standard library that was parsed before, for texts that are
/// compiled many times.
#[must_use]
pub fn compile_with(
    library: &Library,
    sources: &SourceMap,
    documents: &[Document],
    options: &Options,
    mut diagnostics: Diagnostics,
    done: &mut dyn FnMut(Step<'_>),
) -> Compilation {
    let input = sema::Sources {
        map: sources,
        documents,
        library,
        overrides: &options.overrides,
        limits: &options.limits,
    };
    let program = sema::lower(&input, &mut diagnostics);
    let mut compilation = Compilation {
        unit: program.unit,
        curves: program.curves.clone(),
        diagnostics,
        ..Compilation::default()
    };
    done(Step::Lowered);
    compilation.check(&program, options, done);
    compilation.judge(&program, options);
    done(Step::Judged);
    quiet_consequences(&mut compilation.diagnostics, documents);
    compilation.diagnostics.sort();
    compilation
}

/// Drops what was found in declarations that have errors of syntax: they were not read as they
/// were meant.
fn quiet_consequences(diagnostics: &mut Diagnostics, documents: &[Document]) {
    let errors = diagnostics.iter().filter(|own| own.code.is_syntax());
    let places: Vec<_> = errors.filter_map(|own| own.primary).collect();
    let items = documents.iter().flat_map(|document| &document.items);
    let spoiled = |item: &&Item| places.iter().any(|place| item.span.contains(*place));
    let spoiled: Vec<_> = items.filter(spoiled).map(|item| item.span).collect();
    diagnostics.retain(|own| {
        let inside = |place| spoiled.iter().any(|item| item.contains(place));
        own.code.is_syntax() || !own.primary.is_some_and(inside)
    });
}

/// The standard library's declarations, without its text.
#[must_use]
pub fn standard_library() -> Library {
    library(&mut SourceMap::default(), &mut Diagnostics::default())
}

/// The standard library's declarations; its text joins the sources.
pub fn library(sources: &mut SourceMap, diagnostics: &mut Diagnostics) -> Library {
    let file = sources.add("<standard library>", LIBRARY);
    Library::new(syntax::parse(
        file,
        LIBRARY,
        &Limits::default(),
        diagnostics,
    ))
}

impl Compilation {
    fn check(&mut self, program: &Program, options: &Options, done: &mut dyn FnMut(Step<'_>)) {
        let wanted = |name: &str| options.surface.as_deref().is_none_or(|only| only == name);
        for surface in &program.surfaces {
            if !wanted(&surface.name) {
                self.surfaces.push(None);
                continue;
            }
            match Checked::of(surface.clone(), &options.limits) {
                Ok(checked) => {
                    let shared = checked.shared_zero_finding(&program.shared_zeros);
                    self.diagnostics.extend(shared);
                    self.diagnostics.extend(checked.pole_finding());
                    self.diagnostics.extend(checked.singular_finding());
                    self.surfaces.push(Some(checked));
                }
                Err(finding) => {
                    self.diagnostics.push(*finding);
                    self.surfaces.push(None);
                }
            }
            done(Step::Checked(&surface.name));
        }
    }

    fn judge(&mut self, program: &Program, options: &Options) {
        for expectation in &program.expectations {
            match judge(expectation, &self.surfaces, &program.tower, &options.limits) {
                Ok(Some(judgement)) => {
                    self.diagnostics.extend(finding(&judgement));
                    self.judgements.push(judgement);
                }
                Ok(None) => {}
                Err(finding) => self.diagnostics.push(*finding),
            }
        }
    }

    /// The report of every sound surface. An expectation stands with the surfaces it speaks of,
    /// one that speaks of none with the first.
    #[must_use]
    pub fn report(&self, file: &str, sources: &SourceMap) -> Report {
        let line = |own: &Judgement| sources.position(own.expectation.span).0;
        self.report_in(file, &line)
    }

    /// The report, with lines that a function tells.
    fn report_in(&self, file: &str, line: &dyn Fn(&Judgement) -> usize) -> Report {
        let first = self.surfaces.iter().position(Option::is_some);
        let lined = |index: usize| {
            let own = self.judgements.iter().filter(move |judgement| {
                let of = &judgement.expectation.surfaces;
                of.contains(&index) || (of.is_empty() && first == Some(index))
            });
            own.map(|own| (own, line(own))).collect()
        };
        let surfaces = self.surfaces.iter().enumerate();
        let surfaces: Vec<(&Checked, Vec<(&Judgement, usize)>)> = surfaces
            .filter_map(|(index, surface)| Some((surface.as_ref()?, lined(index))))
            .collect();
        Report::new(file.to_owned(), self.unit, &surfaces, &self.curves)
    }

    /// The surfaces that may be written: checked, and without poles.
    pub fn sound_surfaces(&self) -> impl Iterator<Item = &Checked> {
        let checked = self.surfaces.iter().filter_map(Option::as_ref);
        checked.filter(|surface| surface.poles().is_empty())
    }

    /// The bytes of a surface in each format, or the refusal of a format that cannot carry it.
    pub fn export<'a>(
        &self,
        surface: &'a Checked,
        formats: &'a [&'static Exporter],
        stem: &'a str,
        options: &Options,
    ) -> impl Iterator<Item = (&'static Exporter, Result<Exported, Box<Diagnostic>>)> + 'a {
        let model = part(surface).map(|part| Model::new(vec![part]));
        let mut context = self.context(Context::new(stem, surface.name()), formats, options);
        context.guides = guides([surface]);
        formats.iter().map(move |format| {
            let model = model.as_ref().map_err(Clone::clone);
            let span = surface.definition().span;
            let write =
                |model| (format.write)(model, &context).map_err(|fault| Box::new(fault.at(span)));
            (*format, model.and_then(write))
        })
    }

    /// The bytes of all sound surfaces in one file, in each format that holds several; nothing if
    /// no two of them share an edge.
    pub fn export_together<'a>(
        &'a self,
        formats: &'a [&'static Exporter],
        stem: &'a str,
        options: &Options,
    ) -> impl Iterator<Item = (&'static Exporter, Result<Exported, Box<Diagnostic>>)> + 'a {
        let several = formats.iter().filter(|format| format.several);
        let parts = || self.sound_surfaces().filter_map(|own| part(own).ok());
        let wanted = several.clone().next().is_some() && self.sound_surfaces().nth(1).is_some();
        let model = wanted.then(|| Model::new(parts().collect()));
        let model = model.filter(Model::is_connected_across_parts);
        let span = self.sound_surfaces().next();
        let span = span.map(|own| own.definition().span);
        let mut context = self.context(Context::whole(stem), formats, options);
        context.guides = guides(self.sound_surfaces());
        several.filter_map(move |format| {
            let written = (format.write)(model.as_ref()?, &context);
            let span = span?;
            Some((*format, written.map_err(|fault| Box::new(fault.at(span)))))
        })
    }

    /// A context with what the compilation knows.
    fn context<'a>(
        &self,
        context: Context<'a>,
        formats: &[&Exporter],
        options: &Options,
    ) -> Context<'a> {
        let shown = formats.iter().any(|own| own.shows_report);
        Context {
            unit: self.unit,
            any_weight_ratio: options.any_weight_ratio,
            chord: options.chord.clone(),
            limits: options.limits,
            view: options.view.clone(),
            report: shown.then(|| self.report_in(context.stem, &|_| 0)),
            step_schema: options.step_schema,
            iges_trimmed: options.iges_trimmed,
            ..context
        }
    }
}

/// A checked surface as the part of a model.
fn part(surface: &Checked) -> Result<Part, Box<Diagnostic>> {
    Part::of(surface).ok_or_else(|| {
        let message = format!("the first weight of `{}` is 0", surface.name());
        Box::new(Diagnostic::new(
            Code::E0301,
            surface.definition().span,
            message,
        ))
    })
}

/// The curves that surfaces are made of, in the order of their formulas.
fn guides<'a>(surfaces: impl IntoIterator<Item = &'a Checked>) -> Vec<Guide> {
    let mut curves: Vec<Rc<Curve>> = Vec::new();
    let formulas = surfaces.into_iter().map(Checked::definition);
    for formula in formulas {
        Scalar::visit_curves(&formula.coordinates, &mut |curve, _| {
            if !curves.iter().any(|known| Rc::ptr_eq(known, curve)) {
                curves.push(Rc::clone(curve));
            }
        });
    }
    let guide = |own: &Rc<Curve>| {
        let position = own.position();
        let [x, y, z] = position.coordinates.clone();
        let domain = own.domain();
        Guide {
            name: own.name().to_owned(),
            is_profile: own.parameter() == Parameter::U,
            domain: (domain.start().clone(), domain.end().clone()),
            coordinates: [position.weight.clone(), x, y, z],
        }
    };
    curves.iter().map(guide).collect()
}

/// The error that an expectation is which does not hold.
fn finding(judgement: &Judgement) -> Option<Diagnostic> {
    let expectation = &judgement.expectation;
    let text = expectation
        .text
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    match &judgement.verdict {
        Verdict::Proven(_) => None,
        Verdict::Refuted(witness) => {
            let message = format!("the expectation `{text}` does not hold");
            Some(Diagnostic::new(Code::E0401, expectation.span, message).label(witness))
        }
        Verdict::Undecided(reason) => {
            let message = format!("the expectation `{text}` is undecided");
            Some(Diagnostic::new(Code::E0402, expectation.span, message).label(reason))
        }
    }
}
