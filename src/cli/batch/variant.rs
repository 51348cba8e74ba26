use std::collections::BTreeSet;
use std::path::PathBuf;

use crate::cli::emit::{Emit, Product, keeps_files};
use crate::cli::output::{named, shown};
use crate::cli::parsed::Parsed;
use crate::cli::report::require_surfaces;
use crate::cli::status::Status;
use crate::cli::voice::Voice;
use crate::diag::{Code, Diagnostics, SourceMap};
use crate::number::{Rational, Real};
use crate::pipeline::{Compilation, Options};
use crate::report::Report;

use super::input::Input;
use super::row::Row;
use super::variants::Variants;

/// What came of a variant.
#[derive(Debug)]
pub(super) struct Compiled {
    pub(super) rows: Vec<Row>,
    /// What is to be written.
    pub(super) files: Vec<(PathBuf, Vec<u8>)>,
    /// The findings as text; empty if there are none to tell.
    pub(super) told: String,
    pub(super) codes: BTreeSet<Code>,
    pub(super) status: Status,
}

/// The variant of a file with that number, from 0.
#[derive(Debug, Clone)]
pub(super) struct Variant<'a> {
    input: &'a Input,
    number: usize,
    parameters: Vec<(String, String)>,
    values: Vec<(String, Real)>,
    suffix: String,
}

impl<'a> Variant<'a> {
    pub(super) fn of(input: &'a Input, index: usize, variants: &Variants) -> Self {
        let values = if input.is_varied {
            variants.values(index - input.first)
        } else {
            Vec::new()
        };
        let suffix = if input.is_varied {
            variants.suffix(index - input.first, &values)
        } else {
            String::new()
        };
        let pairs = || variants.names.iter().cloned().zip(&values);
        Self {
            input,
            number: index + 1,
            parameters: pairs().map(|(name, own)| (name, own.to_string())).collect(),
            values: pairs()
                .map(|(name, own): (_, &Rational)| (name, Real::from(own.clone())))
                .collect(),
            suffix,
        }
    }

    /// Whether it has values of its own.
    pub(super) fn is_varied(&self) -> bool {
        self.input.is_varied
    }

    /// What messages call it.
    pub(super) fn describe(&self) -> String {
        let pairs = self.parameters.iter();
        let pairs: Vec<_> = pairs.map(|(name, own)| format!("{name} = {own}")).collect();
        if pairs.is_empty() {
            return shown(&self.input.file);
        }
        format!("{}, {}", shown(&self.input.file), pairs.join(", "))
    }

    /// Compiles it, up to the bytes of its files.
    pub(super) fn compile(&self, emit: &Emit, voice: Voice) -> Compiled {
        let limits = self.input.options.limits;
        let work = |parsed: &Parsed| {
            let mut options = self.input.options.clone();
            options.overrides.extend(self.values.iter().cloned());
            let mut compilation = parsed.compile(&options, &mut |_| {});
            require_surfaces(&mut compilation, parsed.is_readable(), &self.input.file);
            self.finish(compilation, &parsed.sources, emit, &options, voice)
        };
        self.input.with_parsed(&limits, work)
    }

    fn finish(
        &self,
        compilation: Compilation,
        sources: &SourceMap,
        emit: &Emit,
        options: &Options,
        voice: Voice,
    ) -> Compiled {
        let report = compilation.report(&self.input.shown, sources);
        let stem = named(&self.input.stem, &self.suffix);
        let (products, findings) = if keeps_files(&compilation.diagnostics) {
            emit.products_with(Some(&report), &compilation, &stem, options)
        } else {
            Default::default()
        };
        let mut diagnostics = compilation.diagnostics;
        diagnostics.extend(findings);
        let told = voice.findings(&diagnostics, sources);
        Compiled {
            rows: self.rows(&report, &products, &diagnostics),
            told,
            codes: diagnostics.iter().map(|own| own.code).collect(),
            status: Status::of(&diagnostics),
            files: products
                .into_iter()
                .map(|own| (self.input.folder.join(own.name), own.bytes))
                .collect(),
        }
    }

    /// A row for each surface; one without a surface if there is none.
    fn rows(&self, report: &Report, products: &[Product], diagnostics: &Diagnostics) -> Vec<Row> {
        let codes: BTreeSet<Code> = diagnostics.iter().map(|own| own.code).collect();
        let codes = codes.into_iter().map(Code::as_str).collect();
        let row = self.row(Status::of(diagnostics), codes);
        let summaries = report.summaries();
        if summaries.is_empty() {
            return vec![row];
        }
        let lengths = report.lengths();
        let rows = summaries.into_iter().map(|summary| {
            let of_surface = |own: &&Product| own.surface.as_ref() == Some(&summary.surface);
            let own = products.iter().filter(of_surface);
            let files = own.chain(products.iter().filter(|own| own.surface.is_none()));
            let files = files.map(|own| own.name.to_string_lossy().into_owned());
            Row {
                files: files.collect(),
                field: Some(report.field().to_vec()),
                lengths: lengths.clone(),
                summary: Some(summary),
                ..row.clone()
            }
        });
        rows.collect()
    }

    /// A row without a surface.
    pub(super) fn row(&self, status: Status, codes: Vec<&'static str>) -> Row {
        Row {
            variant: self.number,
            file: self.input.shown.clone(),
            parameters: self.parameters.clone(),
            status: status.number(),
            codes,
            summary: None,
            field: None,
            lengths: Vec::new(),
            files: Vec::new(),
        }
    }
}
