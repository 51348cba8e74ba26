use crate::diag::{Diagnostic, Limits};
use crate::number::{Field, Real, Tower};
use crate::poly::{BiDegree, BiPoly, Fraction, UniPoly};
use crate::sweep::{Claim, Domain, Expander, Expectation, Quality, Quantity, Relation, Scalar};

use super::{Checked, Verdict};

/// An expectation with its verdict.
#[derive(Debug, Clone)]
pub struct Judgement {
    /// What was expected.
    pub expectation: Expectation,
    /// Whether it holds.
    pub verdict: Verdict,
}

/// Decides an expectation. `surfaces` are indexed as in the claim; none stands for one with errors.
///
/// # Errors
///
/// The findings of expanding its two sides.
pub fn judge(
    expectation: &Expectation,
    surfaces: &[Option<Checked>],
    tower: &Tower,
    limits: &Limits,
) -> Result<Option<Judgement>, Box<Diagnostic>> {
    let known = |index: &usize| surfaces.get(*index).is_some_and(Option::is_some);
    if !expectation.surfaces.iter().all(known) {
        return Ok(None);
    }
    let of = |index: usize| surfaces.get(index).and_then(Option::as_ref);
    let domain = expectation.surfaces.first().and_then(|index| of(*index));
    let domain = domain.map_or_else(Domain::unit, |surface| surface.domain().clone());
    let judge = Judge {
        surfaces,
        domain: &domain,
        tower,
        limits,
    };
    let verdict = match &expectation.claim {
        Claim::Quality { quality, surface } => of(*surface).map(|own| self::quality(*quality, own)),
        Claim::Comparison {
            left,
            relation,
            right,
        } => Some(judge.comparison(left, *relation, right)?),
    };
    Ok(verdict.map(|verdict| Judgement {
        expectation: expectation.clone(),
        verdict,
    }))
}

fn quality(quality: Quality, surface: &Checked) -> Verdict {
    match quality {
        Quality::RationalOffset => surface.rational_offset().clone(),
        Quality::Regular => surface.regular().clone(),
        Quality::PositiveWeights => match surface.weights() {
            Some(range) if range.is_positive() => {
                Verdict::Proven(format!("the weights lie in [{}, {}]", range.min, range.max))
            }
            Some(range) => Verdict::Refuted(format!("the least weight is {}", range.min)),
            None => Verdict::Refuted("the first weight is 0".to_owned()),
        },
    }
}

struct Judge<'a> {
    surfaces: &'a [Option<Checked>],
    domain: &'a Domain,
    tower: &'a Tower,
    limits: &'a Limits,
}

type Judged<T> = Result<T, Box<Diagnostic>>;

impl Judge<'_> {
    fn comparison(&self, left: &Quantity, relation: Relation, right: &Quantity) -> Judged<Verdict> {
        if let (Quantity::Value(left), Quantity::Value(right)) = (left, right) {
            return self.values(left, relation, right);
        }
        let common_factor = |side: &Quantity| matches!(side, Quantity::CommonFactor { .. });
        if common_factor(left) || common_factor(right) {
            return self.polynomials(left, relation, right);
        }
        let (left, right) = (self.bidegree(left)?, self.bidegree(right)?);
        let text = format!("{} and {}", show(&left), show(&right));
        Ok(verdict(relation, left == right, text))
    }

    /// A bidegree as two numbers; none for the zero polynomial.
    fn bidegree(&self, side: &Quantity) -> Judged<Option<[Real; 2]>> {
        let number = |own: usize| Real::from(i64::try_from(own).unwrap_or(i64::MAX));
        Ok(match side {
            Quantity::BiDegree {
                surface,
                coordinate,
            } => {
                let surface = self.surfaces.get(*surface).and_then(Option::as_ref);
                let degree = surface.and_then(|own| match coordinate {
                    None => Some(own.surface().bidegree()),
                    Some(index) => own.surface().bidegrees()[*index],
                });
                degree.map(|BiDegree { u, v }| [number(u), number(v)])
            }
            Quantity::Value(parts) => match parts.as_slice() {
                [u, v] => self
                    .constant(u)?
                    .zip(self.constant(v)?)
                    .map(|(u, v)| [u, v]),
                _ => None,
            },
            Quantity::CommonFactor { .. } => None,
        })
    }

    fn constant(&self, scalar: &Scalar) -> Judged<Option<Real>> {
        Expander::new(self.domain, self.tower, self.limits).constant(scalar)
    }

    /// Common factors are equal if they are proportional.
    fn polynomials(
        &self,
        left: &Quantity,
        relation: Relation,
        right: &Quantity,
    ) -> Judged<Verdict> {
        let (left, right) = (self.polynomial(left)?, self.polynomial(right)?);
        let equal = match (&left, &right) {
            (Some(left), Some(right)) => first(left)
                .zip(first(right))
                .is_some_and(|(l, r)| left.scale(&r) == right.scale(&l)),
            _ => false,
        };
        let text = |own: &Option<BiPoly<Real>>| {
            own.as_ref()
                .map_or_else(|| "not a polynomial".to_owned(), ToString::to_string)
        };
        Ok(verdict(
            relation,
            equal,
            format!("{} and {}", text(&left), text(&right)),
        ))
    }

    fn polynomial(&self, side: &Quantity) -> Judged<Option<BiPoly<Real>>> {
        Ok(match side {
            Quantity::CommonFactor { surface } => {
                let surface = self.surfaces.get(*surface).and_then(Option::as_ref);
                surface.map(|own| own.expansion().common_factor.clone())
            }
            Quantity::Value(parts) => {
                let fraction = Expander::new(self.domain, self.tower, self.limits)
                    .expand(&parts[0])?
                    .fraction()
                    .reduce();
                let whole = fraction.denominator().polynomial().as_constant();
                whole
                    .and_then(|own| own.inverse())
                    .map(|own| fraction.numerator().scale(&own))
            }
            Quantity::BiDegree { .. } => None,
        })
    }

    /// Identities are proved by multiplying out; only numbers have an order.
    fn values(&self, left: &[Scalar], relation: Relation, right: &[Scalar]) -> Judged<Verdict> {
        let mut expander = Expander::new(self.domain, self.tower, self.limits);
        let mut pairs = Vec::new();
        for (l, r) in left.iter().zip(right) {
            pairs.push((
                expander.expand(l)?.fraction(),
                expander.expand(r)?.fraction(),
            ));
        }
        let constants: Option<Vec<(Real, Real)>> = pairs
            .iter()
            .map(|(l, r)| l.as_constant().zip(r.as_constant()))
            .collect();
        if let Some(constants) = constants {
            let side = |pick: fn(&(Real, Real)) -> &Real| {
                let parts: Vec<String> =
                    constants.iter().map(|own| pick(own).to_string()).collect();
                if parts.len() == 1 {
                    parts[0].clone()
                } else {
                    format!("({})", parts.join(", "))
                }
            };
            let text = format!("{} and {}", side(|own| &own.0), side(|own| &own.1));
            let holds = match constants.as_slice() {
                [(l, r)] => relation.holds(l.cmp(r)),
                all => (all.iter().all(|(l, r)| l == r)) == (relation == Relation::Equal),
            };
            return Ok(if holds {
                Verdict::Proven(text)
            } else {
                Verdict::Refuted(text)
            });
        }
        if relation.is_order() {
            return Ok(Verdict::Undecided(
                "only numbers are ordered, a side depends on u or v".to_owned(),
            ));
        }
        let equal = pairs.iter().all(|(l, r)| l.minus(r).is_zero());
        let text = if equal {
            "an identity in u and v".to_owned()
        } else {
            self.witness(&pairs)
        };
        Ok(verdict(relation, equal, text))
    }

    /// A point at which two sides differ: a corner or a middle of the domain if one shows it.
    fn witness(&self, pairs: &[(Fraction<Real>, Fraction<Real>)]) -> String {
        let places = (0..9).map(|step| ((step % 3, 2), (step / 3, 2)));
        let others = (1..200).map(|step| ((step, 211), (step * step % 223, 223)));
        for ((i, m), (j, n)) in places.chain(others) {
            let (u, v) = (self.domain.u.fraction(i, m), self.domain.v.fraction(j, n));
            let at = |(left, right): &(Fraction<Real>, Fraction<Real>)| {
                left.evaluate(&u, &v).zip(right.evaluate(&u, &v))
            };
            let Some(values) = pairs.iter().map(at).collect::<Option<Vec<_>>>() else {
                continue;
            };
            let differs = values.iter().position(|(left, right)| left != right);
            if let Some(index) = differs {
                let (left, right) = &values[index];
                let names: &[&str] = if values.len() == 1 {
                    &["the value"]
                } else {
                    &["x", "y", "z"]
                };
                let name = names[index];
                return format!(
                    "at u = {u}, v = {v} {name} is {left} on the left, {right} on the right"
                );
            }
        }
        "the two sides are different functions".to_owned()
    }
}

fn verdict(relation: Relation, equal: bool, text: String) -> Verdict {
    if equal == (relation == Relation::Equal) {
        Verdict::Proven(text)
    } else {
        Verdict::Refuted(text)
    }
}

fn show(degree: &Option<[Real; 2]>) -> String {
    degree.as_ref().map_or_else(
        || "the zero polynomial".to_owned(),
        |[u, v]| format!("({u}, {v})"),
    )
}

fn first(polynomial: &BiPoly<Real>) -> Option<Real> {
    polynomial.rows().last().map(UniPoly::leading_coefficient)
}
