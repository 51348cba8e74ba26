//! Texts compiled through the library, and an independent arithmetic of polynomials in plain
//! rationals to check the results with.
#![allow(
    dead_code,
    clippy::unwrap_used,
    clippy::panic,
    reason = "shared by several test programs; a failing step may end the test"
)]

use num_rational::BigRational;
use num_traits::Zero;
use sweepc::check::Checked;
use sweepc::diag::{Code, Diagnostic, Diagnostics, Limits, SourceMap, Style, render_text};
use sweepc::number::Real;
use sweepc::pipeline::{Compilation, Options};
use sweepc::poly::{BiDegree, BiPoly, UniPoly};
use sweepc::sema::{self, Program};
use sweepc::sweep::{Expansion, SweptSurface};
use sweepc::syntax;

/// A compiled text with its sources.
pub(crate) struct Compiled {
    pub(crate) sources: SourceMap,
    pub(crate) compilation: Compilation,
}

/// Compiles a text, whatever is found.
pub(crate) fn compile(text: &str) -> Compiled {
    let (mut sources, mut found) = (SourceMap::default(), Diagnostics::default());
    let file = sources.add("test.sweep", text);
    let document = syntax::parse(file, text, &Limits::default(), &mut found);
    let options = Options::default();
    let compilation = sweepc::pipeline::compile(&mut sources, &[document], &options, found);
    Compiled {
        sources,
        compilation,
    }
}

impl Compiled {
    /// The surface of a text without errors.
    pub(crate) fn surface(&self) -> &Checked {
        assert!(!self.compilation.diagnostics.has_errors(), "{}", self.all());
        self.compilation.surfaces[0].as_ref().unwrap()
    }

    /// Every finding as it is printed.
    pub(crate) fn all(&self) -> String {
        let findings = self.compilation.diagnostics.iter();
        findings.map(|own| self.render(own) + "\n").collect()
    }

    pub(crate) fn render(&self, finding: &Diagnostic) -> String {
        render_text(finding, &self.sources, Style::Plain)
    }

    pub(crate) fn codes(&self) -> Vec<Code> {
        self.compilation
            .diagnostics
            .iter()
            .map(|own| own.code)
            .collect()
    }

    /// The report, printed as JSON and read again.
    pub(crate) fn report(&self) -> serde_json::Value {
        let report = self.compilation.report("test.sweep", &self.sources);
        serde_json::from_str(&sweepc::report::render_json(&report).unwrap()).unwrap()
    }
}

const LIBRARY: &str = include_str!("../../src/std/constructions.sweep");

/// A text up to the formulas of its surfaces, without the checks that follow.
pub(crate) fn lower(text: &str) -> (Program, Diagnostics) {
    let (mut map, mut found) = (SourceMap::default(), Diagnostics::default());
    let limits = Limits::default();
    let file = map.add("test.sweep", text);
    let document = syntax::parse(file, text, &limits, &mut found);
    let file = map.add("library", LIBRARY);
    let library = sema::Library::new(syntax::parse(file, LIBRARY, &limits, &mut found));
    let input = sema::Sources {
        map: &map,
        documents: &[document],
        library: &library,
        overrides: &std::collections::HashMap::new(),
        limits: &limits,
    };
    let program = sema::lower(&input, &mut found);
    (program, found)
}

/// The first surface of a text, expanded.
pub(crate) fn expand(text: &str) -> (SweptSurface, Expansion) {
    let (program, found) = lower(text);
    assert!(!found.has_errors(), "{text}\n{found:?}");
    let surface = program.surfaces[0].clone();
    let expansion = Expansion::of(&surface, &Limits::default());
    (
        surface,
        expansion.unwrap_or_else(|own| panic!("{text}\n{own:?}")),
    )
}

/// Bidegrees as pairs.
pub(crate) fn pairs(degrees: [Option<BiDegree>; 4]) -> [Option<(usize, usize)>; 4] {
    degrees.map(|own| own.map(|own| (own.u, own.v)))
}

/// Σ c uⁱ vʲ
pub(crate) fn terms(list: &[(usize, usize, i64)]) -> BiPoly<Real> {
    let term = |&(i, j, c): &(usize, usize, i64)| {
        let one = UniPoly::<Real>::one();
        BiPoly::product(&one.shift(i), &one.shift(j)).scale(&Real::from(c))
    };
    list.iter()
        .map(term)
        .fold(BiPoly::zero(), |sum, own| &sum + &own)
}

pub(crate) type Q = BigRational;

pub(crate) fn q(numerator: i64, denominator: i64) -> Q {
    Q::new(numerator.into(), denominator.into())
}

/// A number of the compiler as a plain rational, by way of its text.
pub(crate) fn plain(value: &Real) -> Q {
    value.to_string().parse().unwrap()
}

/// A polynomial in two parameters: `rows[i][j]` belongs to uⁱ vʲ.
pub(crate) type Rows = Vec<Vec<Q>>;

pub(crate) fn rows(polynomial: &BiPoly<Real>) -> Rows {
    let coefficients = |row: &UniPoly<Real>| row.coefficients().iter().map(plain).collect();
    polynomial.rows().iter().map(coefficients).collect()
}

pub(crate) fn value(polynomial: &[Q], at: &Q) -> Q {
    let step = |sum: Q, own: &Q| sum * at + own;
    polynomial.iter().rev().fold(Q::zero(), step)
}

fn transposed(rows: &Rows) -> Rows {
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    let entry = |row: &Vec<Q>, j: usize| row.get(j).cloned().unwrap_or_else(Q::zero);
    (0..width)
        .map(|j| rows.iter().map(|row| entry(row, j)).collect())
        .collect()
}

fn trimmed(mut polynomial: Vec<Q>) -> Vec<Q> {
    while polynomial.last().is_some_and(Zero::is_zero) {
        polynomial.pop();
    }
    polynomial
}

/// Euclid's algorithm with monic remainders.
fn euclid(left: Vec<Q>, right: Vec<Q>) -> Vec<Q> {
    let (mut left, mut right) = (trimmed(left), trimmed(right));
    while let Some(last) = right.last().cloned() {
        let monic: Vec<Q> = right.iter().map(|own| own / &last).collect();
        while left.len() >= monic.len() {
            let (shift, top) = (left.len() - monic.len(), left[left.len() - 1].clone());
            for (index, own) in monic.iter().enumerate() {
                left[index + shift] -= &top * own;
            }
            left.pop();
            left = trimmed(left);
        }
        (left, right) = (monic, left);
    }
    left
}

/// A proof that no factor which has to do with the second parameter is common to all: at one
/// value of the first, where the leading coefficient of the first polynomial in the second does
/// not vanish, nothing is common.
fn coprime_in_second(list: &[Rows]) -> bool {
    let leading = transposed(&list[0]).pop().unwrap();
    let values = [q(7, 5), q(-11, 3), q(13, 8)];
    let mut sound = values.iter().filter(|at| !value(&leading, at).is_zero());
    sound.any(|at| {
        let slices = list.iter().map(|own| {
            let columns = transposed(own);
            columns.iter().map(|own| value(own, at)).collect()
        });
        slices.fold(Vec::new(), euclid).len() == 1
    })
}

/// Whether polynomials, the first of them not zero, have no common factor.
pub(crate) fn coprime(list: &[BiPoly<Real>; 4]) -> bool {
    let list: Vec<Rows> = list.iter().map(rows).collect();
    let turned: Vec<Rows> = list.iter().map(transposed).collect();
    coprime_in_second(&list) && coprime_in_second(&turned)
}

/// Numbers that look random and are the same in every run.
pub(crate) struct Random(pub u64);

impl Random {
    pub(crate) fn next(&mut self, bound: u64) -> i64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        i64::try_from((self.0 >> 33) % bound).unwrap()
    }

    /// A fraction between −4 and 4 that is not 0, as text.
    pub(crate) fn number(&mut self) -> String {
        let sign = if self.next(2) == 0 { "-" } else { "" };
        format!("{sign}{}/{}", 1 + self.next(29), 8 + self.next(9))
    }

    /// The same, positive.
    pub(crate) fn positive(&mut self) -> String {
        format!("{}/{}", 1 + self.next(29), 8 + self.next(9))
    }

    /// A polynomial of a degree.
    pub(crate) fn polynomial(&mut self, degree: usize, variable: &str) -> String {
        let terms: Vec<String> = (0..=degree)
            .map(|power| format!("({}) {variable}^{power}", self.number()))
            .collect();
        format!("({})", terms.join(" + "))
    }

    /// A polynomial of a degree that is positive for positive arguments.
    pub(crate) fn positive_polynomial(&mut self, degree: usize, variable: &str) -> String {
        let terms: Vec<String> = (0..=degree)
            .map(|power| format!("({}) {variable}^{power}", self.positive()))
            .collect();
        format!("({})", terms.join(" + "))
    }

    /// A planar PH curve with a preimage of degree m.
    pub(crate) fn ph(&mut self, m: usize) -> String {
        let pairs: Vec<String> = (0..=m)
            .map(|_| format!("({}, {})", self.number(), self.number()))
            .collect();
        let (a, b) = (self.number(), self.number());
        format!("ph(start: ({a}, {b}), preimage: [{}])", pairs.join(", "))
    }
}
