//! The four plane Pythagorean-hodograph quintics with given end points and end derivatives, and
//! the choice among them.   [farouki-neff]

use std::cmp::Ordering;

use crate::number::{Complex, Enclosure, Field, Rational, Real, RootFault, Tower};
use crate::poly::{from_bernstein, sign_change};

use super::{Interval, Preimage, rotation_index};

/// One of the four interpolants: the signs of w₂ = ±√d₁ and of the square root in
/// w₁ = [−3(w₀ + w₂) ± √(120Δ − 15(d₀ + d₁) + 10w₀w₂)]/4, where w₀ = √d₀ and all roots are
/// principal values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Branch {
    end_positive: bool,
    middle_positive: bool,
}

impl Branch {
    /// `++`, `+-`, `-+`, `--`
    pub const ALL: [Self; 4] = [
        Self::new(true, true),
        Self::new(true, false),
        Self::new(false, true),
        Self::new(false, false),
    ];

    const fn new(end_positive: bool, middle_positive: bool) -> Self {
        Self {
            end_positive,
            middle_positive,
        }
    }

    /// The branch as it is written in the language.
    #[must_use]
    pub fn word(self) -> &'static str {
        match (self.end_positive, self.middle_positive) {
            (true, true) => "++",
            (true, false) => "+-",
            (false, true) => "-+",
            (false, false) => "--",
        }
    }

    /// The branch that a word names.
    #[must_use]
    pub fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|own| own.word() == word)
    }
}

/// How a branch was chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Choice {
    /// It is written in the source.
    Given,
    /// Its absolute rotation index is the least.
    LeastRotation,
    /// No other has a smaller absolute rotation index, but another has the same; of those it is the
    /// first in the order `++`, `+-`, `-+`, `--`.
    FirstOfEqual,
}

/// Which interpolant of Hermite data a curve is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Interpolant {
    /// The branch.
    pub branch: Branch,
    /// How it was chosen.
    pub choice: Choice,
}

/// The end derivatives d₀ and d₁, and Δ = (P₁ − P₀)/length of the domain.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HermiteData {
    /// d₀
    pub first: Complex,
    /// d₁
    pub last: Complex,
    /// Δ
    pub chord: Complex,
}

impl HermiteData {
    /// The preimage g ω² of one branch.
    ///
    /// With g = d₀ taken out, ω = (1, ω₁, ω₂) in Bernstein form: ω₂ = ±√(d₁/d₀) and
    /// 2ω₁² + 3(1 + ω₂)ω₁ + 3 + 3ω₂² + ω₂ = 15Δ/d₀. The field grows by nothing but the real and
    /// imaginary parts of ω₁ and ω₂, which the control points generate. For d₀ = 0 the end d₁ takes
    /// its place, for d₀ = d₁ = 0 the chord; without motion the preimage is 0.
    ///
    /// # Errors
    ///
    /// A field of too large a degree.
    pub fn preimage(
        &self,
        branch: Branch,
        domain: &Interval,
        tower: &Tower,
    ) -> Result<Preimage, RootFault> {
        Ok(self.solve(branch, tower)?.preimage(domain))
    }

    fn solve(&self, branch: Branch, tower: &Tower) -> Result<Solution, RootFault> {
        let middle = self.chord.scale(&Real::ratio(15.into(), 2.into()));
        let candidates = [&self.first, &self.last, &middle];
        let factor = candidates.into_iter().find(|own| !own.is_zero());
        let Some((factor, inverse)) = factor.and_then(|own| Some((own, own.inverse()?))) else {
            return Ok(Solution::zero());
        };
        // √(radicand/g) with the sign that √g √(radicand/g) is principal, or the other one.
        let root = |radicand: &Complex, positive: bool| {
            let root = radicand.square_root(tower)?;
            let scale = factor.square_root(&tower.scratch())?;
            Ok(if scale.times(&root).is_principal() == positive {
                root
            } else {
                root.negated()
            })
        };
        let start = if self.first.is_zero() {
            Complex::zero()
        } else {
            Complex::one()
        };
        let end = root(&self.last.times(&inverse), branch.end_positive)?;
        let chord = self.chord.times(&inverse).scale(&Real::from(120));
        let squares = start.plus(&end.times(&end)).scale(&Real::from(15));
        let cross = start.times(&end).scale(&Real::from(10));
        let radical = root(&chord.minus(&squares).plus(&cross), branch.middle_positive)?;
        let ends = start.plus(&end).scale(&Real::from(3));
        let middle = radical.minus(&ends).scale(&Real::ratio(1.into(), 4.into()));
        Ok(Solution {
            factor: factor.clone(),
            coefficients: [start, middle, end],
        })
    }

    /// The branch of least absolute rotation index among those without a cusp on the domain, or,
    /// if all have one, among all.
    ///
    /// Enclosures at growing precisions leave fewer and fewer branches, until one is left or those
    /// that are left are known to be equal; of these the first is taken.
    ///
    /// # Errors
    ///
    /// In words, branches whose indices are too close to be told apart.
    pub fn best(&self, domain: &Interval, tower: &Tower) -> Result<(Branch, Choice), String> {
        let scratch = tower.scratch();
        let mut candidates = Vec::with_capacity(Branch::ALL.len());
        for branch in Branch::ALL {
            let solution = self.solve(branch, &scratch);
            let solution =
                solution.map_err(|_| "the field of this curve is too large".to_owned())?;
            candidates.push(Candidate::new(branch, solution, domain));
        }
        if candidates.iter().any(|own| !own.cusp) {
            candidates.retain(|own| !own.cusp);
        }
        for doubling in 0..DOUBLINGS {
            let uppers = candidates.iter().map(|own| own.index.ends()[1].clone());
            let least = uppers.min().unwrap_or_else(Rational::zero);
            candidates.retain(|own| own.index.ends()[0] <= least);
            if let Some((first, rest)) = candidates.split_first()
                && rest.iter().all(|own| self.is_tie(first, own, domain))
            {
                let choice = match rest {
                    [] => Choice::LeastRotation,
                    _ => Choice::FirstOfEqual,
                };
                return Ok((first.branch, choice));
            }
            for own in &mut candidates {
                own.index = rotation_index(&own.preimage, domain, START << (doubling + 1));
            }
        }
        let words: Vec<&str> = candidates.iter().map(|own| own.branch.word()).collect();
        Err(format!(
            "which branch is best is not decided: the rotation indices of {} are too close, name one",
            words.join(" and ")
        ))
    }

    /// Whether two branches are known to have the same absolute rotation index.
    ///
    /// They have if one curve is the other turned, mirrored or run backwards, and if both are
    /// straight. The indices of two branches without inflections differ by an integer if both turn
    /// the same way, and if the end derivatives are parallel they are multiples of 1/2: then they
    /// are equal if they differ by less than 1/4.
    fn is_tie(&self, one: &Candidate, other: &Candidate, domain: &Interval) -> bool {
        if one.solution.is_image_of(&other.solution) {
            return true;
        }
        let (Some(left), Some(right)) = (one.sense(domain), other.sense(domain)) else {
            return false;
        };
        let ends = self.last.times(&self.first.conjugate());
        let quarter = Rational::new(1.into(), 4.into());
        let apart = one.index.minus(&other.index).absolute();
        (left.is_eq() && right.is_eq())
            || (!ends.is_zero()
                && (left == right || ends.imaginary.is_zero())
                && apart.ends()[1] < quarter)
    }
}

/// The Bernstein coefficients of ω on the domain, and the constant g.
struct Solution {
    factor: Complex,
    coefficients: [Complex; 3],
}

impl Solution {
    fn zero() -> Self {
        Self {
            factor: Complex::zero(),
            coefficients: [Complex::zero(), Complex::zero(), Complex::zero()],
        }
    }

    fn preimage(&self, domain: &Interval) -> Preimage {
        let part = |pick: fn(&Complex) -> &Real| {
            let coefficients = self.coefficients.each_ref().map(|own| pick(own).clone());
            from_bernstein(&coefficients, domain.start(), domain.end())
        };
        let (real, imaginary) = (part(|own| &own.real), part(|own| &own.imaginary));
        Preimage::new(self.factor.clone(), real, imaginary)
    }

    /// Whether the other curve is this one turned, mirrored or run backwards: then their absolute
    /// rotation indices are equal.
    fn is_image_of(&self, other: &Self) -> bool {
        let [first, middle, last] = &self.coefficients;
        let forwards = self.coefficients.clone();
        let backwards = [last.clone(), middle.clone(), first.clone()];
        [forwards, backwards].iter().any(|own| {
            let mirrored = own.each_ref().map(Complex::conjugate);
            proportional(own, &other.coefficients) || proportional(&mirrored, &other.coefficients)
        })
    }
}

/// Whether one list is a complex multiple of the other; neither is 0.
fn proportional(left: &[Complex; 3], right: &[Complex; 3]) -> bool {
    let pairs = [(0, 1), (1, 2), (0, 2)];
    pairs
        .iter()
        .all(|&(i, j)| left[i].times(&right[j]) == left[j].times(&right[i]))
}

/// A branch that may be the best.
struct Candidate {
    branch: Branch,
    solution: Solution,
    preimage: Preimage,
    cusp: bool,
    index: Enclosure,
}

/// The precision, in bits, to which indices are compared first.
const START: u32 = 32;
/// How often the precision is doubled.
const DOUBLINGS: u32 = 6;

impl Candidate {
    fn new(branch: Branch, solution: Solution, domain: &Interval) -> Self {
        let preimage = solution.preimage(domain);
        Self {
            branch,
            cusp: preimage.has_cusp(domain),
            index: rotation_index(&preimage, domain, START),
            solution,
            preimage,
        }
    }

    /// Which way the curve turns, if it has no inflection inside the domain: equal for a straight
    /// line.
    fn sense(&self, domain: &Interval) -> Option<Ordering> {
        let turning = self.preimage.turning();
        if turning.is_zero() {
            return Some(Ordering::Equal);
        }
        if sign_change(&turning, domain.start(), domain.end()).is_some() {
            return None;
        }
        let pieces = i64::try_from(turning.numerators().len() + 1).ok()?;
        let at = |piece| turning.evaluate(&domain.fraction(piece, pieces)).sign();
        (1..pieces).map(at).find(|sign| sign.is_ne())
    }
}
