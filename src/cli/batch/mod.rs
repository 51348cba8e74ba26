//! Many files, or many variants of one: the parameter study.
//!
//! Variants are compiled on several threads; their files are written in order, a group at a time:
//! all files of a group are brought to the disk before the first of them is renamed. The table
//! comes last. A batch that is broken off leaves whole groups, and no table.

mod axis;
mod input;
mod list;
mod output;
mod quotes;
mod row;
mod table;
mod variant;
mod variants;

use std::sync::atomic::{AtomicBool, Ordering};

use crate::diag::{Diagnostics, SourceMap};

use super::arguments::{Arguments, CompileArguments};
use super::emit::Emit;
use super::parallel::Crew;
use super::progress;
use super::refusal::Refusal;
use super::session::Misuse;
use super::status::Status;
use super::voice::Voice;

use input::{Input, check_names};
use output::Output;
use variant::Variant;
use variants::Variants;

/// `sweepc compile FILE… --grid NAME=START:END:STEP --list CSV`
pub(super) fn run(
    emit: &Emit,
    own: &CompileArguments,
    arguments: &Arguments,
    stack: usize,
) -> Status {
    let voice = Voice::of(arguments);
    let (variants, inputs) = match prepare(emit, own, arguments) {
        Ok(prepared) => prepared,
        Err(refusal) => return refusal.complain(voice),
    };
    let count = inputs.last().map_or(0, |own| own.first + own.count);
    progress::begin_variants(count);
    let mut output = match Output::begin(&variants, &inputs, own, voice) {
        Ok(output) => output,
        Err(finding) => {
            let mut findings = Diagnostics::default();
            findings.push(*finding);
            voice.tell(&findings, &SourceMap::default());
            return Status::of(&findings);
        }
    };
    let variant = |index: usize| {
        let at = inputs.partition_point(|own| own.first <= index);
        Variant::of(&inputs[at.saturating_sub(1)], index, &variants)
    };
    let is_over = AtomicBool::new(false);
    let crew = Crew {
        threads: arguments.threads(),
        stack,
    };
    let work = |index: usize| {
        let go_on = !is_over.load(Ordering::Relaxed);
        go_on.then(|| variant(index).compile(emit, voice))
    };
    let mut index = 0;
    crew.in_order(count, work, |compiled| {
        match compiled {
            Some(Some(compiled)) => output.take(compiled, &variant(index)),
            Some(None) => {}
            None => output.take_nothing(&variant(index)),
        }
        is_over.store(output.has_failed(), Ordering::Relaxed);
        progress::advance();
        index += 1;
    });
    output.end(count)
}

/// Everything that can be said before the first variant is compiled.
fn prepare(
    emit: &Emit,
    own: &CompileArguments,
    arguments: &Arguments,
) -> Result<(Variants, Vec<Input>), Refusal> {
    Misuse::of_input(&own.files)?;
    let variants = Variants::of(own, arguments)?;
    let mut findings = Diagnostics::default();
    let mut inputs: Vec<Input> = Vec::new();
    for file in &own.files {
        let mut input = Input::read(file, &variants, emit, own, arguments, &mut findings)?;
        input.first = inputs.last().map_or(0, |own| own.first + own.count);
        inputs.push(input);
    }
    if findings.has_errors() {
        let sources = variants.list.map(|own| own.sources).unwrap_or_default();
        return Err(Refusal::Findings(findings, sources));
    }
    check_names(&inputs, emit)?;
    Ok((variants, inputs))
}
