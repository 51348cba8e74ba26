use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use crate::diag::Limits;
use crate::export::{StepSchema, View};

use super::watch::Budget;

/// The exact sweep compiler: swept surfaces in the notation of the papers, proved and compiled to
/// rational Bézier patches.
#[derive(Debug, Parser)]
#[command(name = "sweepc", version, about, max_term_width = 100)]
#[command(after_help = "A file named `-` is read from standard input.\n\
    Exit status: 0 all well; 1 errors in the input; 2 wrong usage; 3 a file could not be read or \
    written; 4 a limit was reached; 70 an internal error; 130 \
    interrupted.")]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub(super) command: Command,
    /// When to colour messages; NO_COLOR is obeyed
    #[arg(long, value_enum, default_value_t = Color::Auto, global = true, value_name = "WHEN")]
    pub(super) color: Color,
    /// Replace the value of a `param`, exactly: 3/2, 0.25
    #[arg(short = 'D', long = "set", value_name = "NAME=VALUE", global = true)]
    pub(super) set: Vec<String>,
    /// Work on this surface only
    #[arg(long, value_name = "NAME", global = true)]
    pub(super) surface: Option<String>,
    /// How many files or variants are worked on side by side; as many as the machine has cores if
    /// it is left out. The result is the same
    #[arg(long, visible_alias = "jobs", value_name = "NUMBER", global = true)]
    threads: Option<NonZeroUsize>,
    /// Print errors only: no warnings, no list of written files, no progress
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    pub(super) quiet: bool,
    /// Print how long each stage takes
    #[arg(short, long, global = true)]
    pub(super) verbose: bool,
    #[command(flatten)]
    limits: LimitArguments,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Parse, expand and check files, and decide their expectations
    Check(CheckArguments),
    /// Print the degree report of every surface of a file
    Report(ReportArguments),
    /// Write the report, the exact net and CAD files of every surface of files or of their variants
    Compile(Box<CompileArguments>),
    /// Explain diagnostics by their codes; without one, list all
    Explain(ExplainArguments),
    /// Write files in their canonical layout
    Fmt(FmtArguments),
    /// Print a script that completes command lines in a shell
    Completions(CompletionsArguments),
    /// Write the manual pages
    Man(ManArguments),
}

#[derive(Debug, Args)]
pub(super) struct CheckArguments {
    /// The files to check
    #[arg(required = true, value_name = "FILE")]
    pub(super) files: Vec<PathBuf>,
    /// How to print diagnostics: `text` to standard error, `json` one object a line to standard
    /// output
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub(super) format: CheckFormat,
}

#[derive(Debug, Args)]
pub(super) struct ReportArguments {
    /// The file
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// How to print the report
    #[arg(long, value_enum, default_value_t = ReportFormat::Text)]
    pub(super) format: ReportFormat,
}

#[derive(Debug, Args)]
pub(super) struct CompileArguments {
    /// The files. Several, or several variants of one, come with a table of their degrees, lengths
    /// and verdicts
    #[arg(required = true, value_name = "FILE")]
    pub(super) files: Vec<PathBuf>,
    /// Let a `param` run from START to END by STEP, all exact: `d=0:1:1/100`. Several of them give
    /// every combination
    #[arg(long, value_name = "NAME=START:END:STEP")]
    pub(super) grid: Vec<String>,
    /// Take the values of `param`s from a CSV file: names in the first line, then a variant a line
    #[arg(long, value_name = "CSV")]
    pub(super) list: Option<PathBuf>,
    /// Where to write; beside the file if it is left out
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// What to write: a comma-separated list of `report`, `table`, `json`, `step`, `iges`, `3dm`,
    /// `geomdl`, `three`, `verb`, `truck`, `obj`, `mesh`, `ply`, `stl`, `glb`, `svg`, `html`
    #[arg(
        long,
        value_delimiter = ',',
        default_value = "report,json,step",
        value_name = "LIST"
    )]
    pub(super) emit: Vec<String>,
    /// Where pictures are seen from: `iso`, `front`, `back`, `left`, `right`, `top`, `bottom`, or
    /// AZIMUTH,ELEVATION in degrees, the elevation from -90 to 90
    #[arg(
        long,
        default_value = "iso",
        allow_hyphen_values = true,
        value_parser = view,
        value_name = "VIEW"
    )]
    pub(super) view: View,
    /// Write weights that differ by more than a factor of 10⁶
    #[arg(long)]
    pub(super) allow_weight_ratio: bool,
    /// The application protocol of `step`
    #[arg(long, value_enum, default_value_t = StepProtocol::Ap214, value_name = "PROTOCOL")]
    pub(super) step_schema: StepProtocol,
    /// Trim the surfaces of `iges` by their boundary curves
    #[arg(long)]
    pub(super) iges_trimmed: bool,
    /// The greatest distance between a surface and the triangles of `mesh`, `ply`, `stl` and
    /// `glb`, exactly and in the file's unit: 1/100, 0.01; a thousandth of the size if it is left
    /// out
    #[arg(long, value_name = "TOLERANCE")]
    pub(super) chord: Option<String>,
}

#[derive(Debug, Args)]
pub(super) struct ExplainArguments {
    /// The codes, such as E0201
    #[arg(value_name = "CODE")]
    pub(super) codes: Vec<String>,
}

#[derive(Debug, Args)]
pub(super) struct FmtArguments {
    /// The files to format, each on its own: one with errors stays as it is; what is read from
    /// standard input goes to standard output
    #[arg(required = true, value_name = "FILE")]
    pub(super) files: Vec<PathBuf>,
    /// Write nothing; list the files that would change, and how
    #[arg(long)]
    pub(super) check: bool,
    /// Write names that have a Latin spelling with it: `sigma`, `kappa`, `rho`
    #[arg(long, conflicts_with = "unicode")]
    pub(super) ascii: bool,
    /// Write these names with Greek letters: `σ`, `κ`, `ρ`
    #[arg(long)]
    pub(super) unicode: bool,
}

#[derive(Debug, Args)]
pub(super) struct CompletionsArguments {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub(super) shell: Shell,
}

#[derive(Debug, Args)]
pub(super) struct ManArguments {
    /// The folder to write them into
    #[arg(value_name = "DIR")]
    pub(super) folder: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Color {
    Auto,
    Always,
    Never,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum CheckFormat {
    Text,
    Json,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum StepProtocol {
    Ap203,
    Ap214,
    Ap242,
}

impl From<StepProtocol> for StepSchema {
    fn from(own: StepProtocol) -> Self {
        match own {
            StepProtocol::Ap203 => Self::Ap203,
            StepProtocol::Ap214 => Self::Ap214,
            StepProtocol::Ap242 => Self::Ap242,
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ReportFormat {
    Text,
    Json,
    Markdown,
}

#[derive(Debug, Clone, Copy, Args)]
#[command(next_help_heading = "Limits")]
struct LimitArguments {
    /// Bytes of one source file
    #[arg(long, value_name = "BYTES", global = true, default_value_t = Limits::default().source)]
    max_source: usize,
    /// Depth of brackets, signs and calls
    #[arg(long, value_name = "LEVELS", global = true, default_value_t = Limits::default().nesting)]
    max_nesting: usize,
    /// Digits of one number
    #[arg(long, value_name = "DIGITS", global = true, default_value_t = Limits::default().digits)]
    max_digits: usize,
    /// Absolute value of an exponent
    #[arg(long, value_name = "EXPONENT", global = true, default_value_t = Limits::default().exponent)]
    max_exponent: u32,
    /// Predicted degree in one parameter
    #[arg(long, value_name = "DEGREE", global = true, default_value_t = Limits::default().degree)]
    max_degree: usize,
    /// Predicted number of terms of a polynomial
    #[arg(long, value_name = "TERMS", global = true, default_value_t = Limits::default().terms)]
    max_terms: usize,
    /// Bits of one number
    #[arg(long, value_name = "BITS", global = true, default_value_t = Limits::default().bits)]
    max_bits: u64,
    /// Degree of the number field
    #[arg(long, value_name = "DEGREE", global = true, default_value_t = Limits::default().field_degree)]
    max_field_degree: usize,
    /// Triangles of a mesh
    #[arg(long, value_name = "TRIANGLES", global = true, default_value_t = Limits::default().triangles)]
    max_triangles: usize,
    /// Imported files
    #[arg(long, value_name = "FILES", global = true, default_value_t = Limits::default().imports)]
    max_imports: usize,
    /// Variants of a run
    #[arg(long, value_name = "VARIANTS", global = true, default_value_t = Limits::default().variants)]
    max_variants: usize,
    /// Seconds of a run, for all its files and variants together
    #[arg(long, value_name = "SECONDS", global = true, default_value_t = 60)]
    max_seconds: u64,
    /// Memory of a run, where the system tells it
    #[arg(long, value_name = "MIB", global = true, default_value_t = 2048)]
    max_memory: u64,
}

/// Reads a view; the range of its elevation is part of what is said of another one.
fn view(text: &str) -> Result<View, String> {
    let range = "with an elevation from -90 to 90";
    text.parse::<View>()
        .map_err(|own| format!("{own}, {range}"))
}

impl Arguments {
    /// The time and the memory that a run may take.
    pub(super) fn budget(&self) -> Budget {
        Budget {
            seconds: self.limits.max_seconds,
            mebibytes: self.limits.max_memory,
        }
    }

    /// How many files are worked on side by side.
    pub(super) fn threads(&self) -> usize {
        let cores = || std::thread::available_parallelism().ok();
        let threads = self.threads.or_else(cores);
        threads.map_or(1, NonZeroUsize::get)
    }

    /// The limits, with those that the command line replaces.
    pub(super) fn limits(&self) -> Limits {
        let given = &self.limits;
        Limits {
            source: given.max_source,
            nesting: given.max_nesting,
            digits: given.max_digits,
            exponent: given.max_exponent,
            degree: given.max_degree,
            terms: given.max_terms,
            bits: given.max_bits,
            field_degree: given.max_field_degree,
            triangles: given.max_triangles,
            imports: given.max_imports,
            variants: given.max_variants,
            ..Limits::default()
        }
    }
}
