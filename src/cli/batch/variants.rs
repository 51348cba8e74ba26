use crate::cli::arguments::{Arguments, CompileArguments};
use crate::cli::refusal::Refusal;
use crate::cli::session::{Misuse, assignments};
use crate::diag::{Code, Diagnostic, Limits};
use crate::number::Rational;

use super::axis::Axis;
use super::list::List;

/// The most bytes that the values of a variant take in the names of its files.
const LONGEST: usize = 120;

/// The values that parameters run through: each row of the list with each point of the grid, the
/// last range of the grid fastest.
#[derive(Debug, Default)]
pub(super) struct Variants {
    pub(super) list: Option<List>,
    axes: Vec<Axis>,
    /// Every parameter, those of the list first.
    pub(super) names: Vec<String>,
    /// Whether variants are told apart by their values, or else by their number.
    by_values: bool,
}

impl Variants {
    /// The variants that the command line asks for, once their number is known to be allowed.
    pub(super) fn of(own: &CompileArguments, arguments: &Arguments) -> Result<Self, Refusal> {
        let limits = arguments.limits();
        let axes = own.grid.iter().map(|own| Axis::read(own, &limits));
        let axes = axes.collect::<Result<Vec<Axis>, Refusal>>()?;
        check_count(own.files.len(), axes.iter().map(|own| own.count), &limits)?;
        let list = own.list.as_deref().map(|path| List::read(path, &limits));
        let list = list.transpose();
        let list = list.map_err(|(findings, sources)| Refusal::Findings(findings, sources))?;
        let rows = list.as_ref().map_or(1, |own| own.rows.len());
        let counts = axes.iter().map(|own| own.count).chain([rows]);
        check_count(own.files.len(), counts, &limits)?;
        let named = list.iter().flat_map(|own| own.names.iter());
        let named = named.chain(axes.iter().map(|own| &own.name));
        let names: Vec<String> = named.cloned().collect();
        let set = assignments(arguments)?;
        for (index, name) in names.iter().enumerate() {
            if names[..index].contains(name) || set.iter().any(|(own, _)| own == name) {
                return Err(Misuse(format!("`{name}` is given its values twice")).into());
            }
        }
        let mut variants = Self {
            list,
            axes,
            names,
            by_values: true,
        };
        variants.by_values = variants.longest() <= LONGEST;
        Ok(variants)
    }

    /// The parameters of the grid.
    pub(super) fn grid(&self) -> impl Iterator<Item = &str> {
        self.axes.iter().map(|own| own.name.as_str())
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        let rows = self.list.as_ref().map_or(1, |own| own.rows.len());
        let counts = self.axes.iter().map(|own| own.count);
        counts.fold(rows, usize::saturating_mul)
    }

    /// The values of the variant of that number, from 0, in the order of the names.
    pub(super) fn values(&self, index: usize) -> Vec<Rational> {
        let mut rest = index;
        let mut grid = Vec::new();
        for axis in self.axes.iter().rev() {
            grid.push(axis.value(rest % axis.count));
            rest /= axis.count;
        }
        let listed = self.list.as_ref().and_then(|own| own.rows.get(rest));
        let mut values = listed.cloned().unwrap_or_default();
        values.extend(grid.into_iter().rev());
        values
    }

    /// What the files of a variant have behind the name of the source file: `-d=1_100-e=-2`, or
    /// `-variant=17` where the values of some variant are long.
    pub(super) fn suffix(&self, index: usize, values: &[Rational]) -> String {
        if self.names.is_empty() {
            return String::new();
        }
        if !self.by_values {
            return format!("-variant={}", index + 1);
        }
        let pairs = self.names.iter().zip(values);
        let parts = pairs.map(|(name, value)| format!("-{name}={}", portable(value)));
        parts.collect()
    }

    /// A bound of the bytes of all suffixes with values.
    fn longest(&self) -> usize {
        let length = |own: &Rational| own.to_string().len();
        let names: usize = self.names.iter().map(|own| own.len() + 2).sum();
        let axes = self.axes.iter().map(|axis| {
            let values = (0..axis.count).map(|index| length(&axis.value(index)));
            values.max().unwrap_or_default()
        });
        let rows = self.list.iter().flat_map(|own| &own.rows);
        let rows = rows.map(|row| row.iter().map(length).sum::<usize>());
        names + axes.sum::<usize>() + rows.max().unwrap_or_default()
    }
}

/// A number without the characters that file names cannot have.
fn portable(value: &Rational) -> String {
    value.to_string().replace('/', "_")
}

/// Refuses more variants than the limit allows (E0510).
fn check_count(
    files: usize,
    counts: impl Iterator<Item = usize>,
    limits: &Limits,
) -> Result<(), Refusal> {
    let count = counts.fold(files, usize::saturating_mul);
    if count <= limits.variants {
        return Ok(());
    }
    let message = if count == usize::MAX {
        format!("more than {} variants", limits.variants)
    } else {
        format!("{count} variants; {} are allowed", limits.variants)
    };
    let finding = Diagnostic::global(Code::E0510, message);
    Err(finding.help("raise the limit with `--max-variants`").into())
}
