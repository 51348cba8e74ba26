use crate::curve::Interval;
use crate::number::{Field, Real};
use crate::poly::{BiDegree, BiPoly, Denominator, UniPoly, bernstein};
use crate::sweep::Domain;

use super::cuts::{Cuts, is_positive};

/// By how much a degree is raised at most to do without a cut.
const RAISED: usize = 2;
/// The greatest degree that a direction is raised to.
const GREATEST_DEGREE: usize = 25;
/// The greatest number of patches.
const MOST_PATCHES: usize = 256;

/// A certificate that W > 0 on the domain: patches whose weights are all positive.
///
/// - **holds** the Bernstein coefficients of W of this bidegree are positive on every rectangle,
///   and the rectangles fill the domain
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Positivity {
    /// The bidegree of the patches: that of the surface, raised by at most 2.
    pub degree: BiDegree,
    /// The rectangles of the patches, in order of u, then v.
    pub rectangles: Vec<Domain>,
}

impl Positivity {
    /// As few patches as there are to be found of a surface of this bidegree with the weight W,
    /// which is positive at the domain's first corner.
    ///
    /// One patch where elevation by at most 2, within degree 25, suffices. Else, for
    /// W = a(u) b(v), a grid with the least number of cuts in each direction; for other W the
    /// domain is halved, and each half that needs it.
    ///
    /// # Errors
    ///
    /// Why there are none: W is not positive at a corner, or 256 patches (64 along one parameter)
    /// do not suffice.
    pub fn of(
        weight: &BiPoly<Real>,
        degree: BiDegree,
        domain: &Domain,
    ) -> Result<Self, &'static str> {
        let plane = Plane { weight, degree };
        if is_positive(&plane.coefficients(domain)) {
            return Ok(Self::of_one_patch(degree, domain));
        }
        let ends = |own: &Interval| [own.start().clone(), own.end().clone()];
        let [left, right] = ends(&domain.u);
        let mut corners = ends(&domain.v)
            .into_iter()
            .flat_map(|v| [weight.evaluate(&left, &v), weight.evaluate(&right, &v)]);
        if !corners.all(|own| own.sign().is_gt()) {
            return Err("W is not positive at every corner of the domain");
        }
        match Denominator::split(weight) {
            Some((_, split)) if split.is_separable() => plane.grid(&split, domain),
            _ => plane
                .elevated(domain)
                .map_or_else(|| plane.halved(domain), Ok),
        }
        .map_err(|()| TOO_MANY)
    }

    /// The certificate that is the net itself, if all its weights are positive.
    pub(super) fn of_one_patch(degree: BiDegree, domain: &Domain) -> Self {
        Self {
            degree,
            rectangles: vec![domain.clone()],
        }
    }

    /// The inner cuts of u and of v; none if the rectangles are no grid.
    #[must_use]
    pub fn cuts(&self) -> Option<[Vec<&Real>; 2]> {
        let starts = |side: fn(&Domain) -> &Interval| {
            let mut starts: Vec<_> = self
                .rectangles
                .iter()
                .map(|own| side(own).start())
                .collect();
            starts.sort();
            starts.dedup();
            starts.remove(0);
            starts
        };
        let [u, v] = [starts(|own| &own.u), starts(|own| &own.v)];
        let full = (u.len() + 1) * (v.len() + 1) == self.rectangles.len();
        full.then_some([u, v])
    }
}

/// What there is to say where no patches are found.
const TOO_MANY: &str = "more patches are needed than 256, or than 64 along one parameter";

/// W and the bidegree in which its coefficients are asked for.
struct Plane<'a> {
    weight: &'a BiPoly<Real>,
    degree: BiDegree,
}

impl Plane<'_> {
    fn patches(&self, rectangles: Vec<Domain>) -> Positivity {
        Positivity {
            degree: self.degree,
            rectangles,
        }
    }

    /// The Bernstein coefficients on a rectangle, i by i and j within i.
    fn coefficients(&self, on: &Domain) -> Vec<Real> {
        let BiDegree { u, v } = self.degree;
        let mut sums = vec![Real::zero(); (u + 1) * (v + 1)];
        for (in_u, in_v) in self.weight.terms() {
            let rows = bernstein(in_u, u, on.u.start(), on.u.end());
            let columns = bernstein(in_v, v, on.v.start(), on.v.end());
            let products = rows
                .iter()
                .flat_map(|row| columns.iter().map(move |column| row.times(column)));
            for (sum, own) in sums.iter_mut().zip(products) {
                *sum = sum.plus(&own);
            }
        }
        sums
    }

    /// W = a(u) b(v): each direction by itself.
    fn grid(&self, weight: &Denominator<Real>, domain: &Domain) -> Result<Positivity, ()> {
        let direction = |factor: &UniPoly<Real>, degree: usize, on: &Interval| {
            let sign = factor.evaluate(on.start()).sign();
            let factor = if sign.is_lt() {
                factor.scale(&Real::from(-1))
            } else {
                factor.clone()
            };
            Cuts::of(&factor, degrees(degree), on.start(), on.end()).ok_or(())
        };
        let u = direction(weight.in_u(), self.degree.u, &domain.u)?;
        let v = direction(weight.in_v(), self.degree.v, &domain.v)?;
        if (u.inner.len() + 1) * (v.inner.len() + 1) > MOST_PATCHES {
            return Err(());
        }
        let (rows, columns) = (split(&domain.u, &u.inner), split(&domain.v, &v.inner));
        let rectangles = rows.iter().flat_map(|u| {
            columns.iter().map(|v| Domain {
                u: u.clone(),
                v: v.clone(),
            })
        });
        Ok(Positivity {
            degree: BiDegree::new(u.degree, v.degree),
            rectangles: rectangles.collect(),
        })
    }

    /// One patch of a higher bidegree, raised by as little as there is need for.
    fn elevated(&self, domain: &Domain) -> Option<Positivity> {
        let raised = degrees(self.degree.u)
            .flat_map(|u| degrees(self.degree.v).map(move |v| BiDegree::new(u, v)));
        let mut raised: Vec<_> = raised.collect();
        raised.sort_by_key(|own| own.u + own.v);
        let weight = self.weight;
        raised.into_iter().find_map(|degree| {
            let plane = Plane { weight, degree };
            let positive = is_positive(&plane.coefficients(domain));
            positive.then(|| plane.patches(vec![domain.clone()]))
        })
    }

    /// The domain in halves, and each half that needs it in halves again.
    fn halved(&self, domain: &Domain) -> Result<Positivity, ()> {
        let mut done = Vec::new();
        let mut open = vec![domain.clone()];
        while let Some(rectangle) = open.pop() {
            if done.len() + open.len() >= MOST_PATCHES {
                return Err(());
            }
            let halves = [rectangle.divided((2, 1)), rectangle.divided((1, 2))];
            let negative = halves.each_ref().map(|halves| {
                let counts = halves.iter().map(|own| {
                    let coefficients = self.coefficients(own).into_iter();
                    coefficients.filter(|own| !own.sign().is_gt()).count()
                });
                counts.collect::<Vec<_>>()
            });
            let [sum_u, sum_v] = negative.each_ref().map(|own| own.iter().sum::<usize>());
            let ([halves_u, halves_v], [negative_u, negative_v]) = (halves, negative);
            let (halves, negative) = if sum_u <= sum_v {
                (halves_u, negative_u)
            } else {
                (halves_v, negative_v)
            };
            for (half, count) in halves.into_iter().zip(negative) {
                if count == 0 {
                    done.push(half);
                } else {
                    open.push(half);
                }
            }
        }
        let corner = |own: &Domain| (own.u.start().clone(), own.v.start().clone());
        done.sort_by_key(corner);
        Ok(self.patches(done))
    }
}

/// A degree and those to which it may be raised.
fn degrees(own: usize) -> impl Iterator<Item = usize> {
    own..=(own + RAISED).min(GREATEST_DEGREE).max(own)
}

/// The parts of an interval between inner cuts.
fn split(interval: &Interval, cuts: &[Real]) -> Vec<Interval> {
    let ends = std::iter::once(interval.start())
        .chain(cuts)
        .chain([interval.end()]);
    let ends: Vec<_> = ends.collect();
    let pairs = ends.windows(2);
    pairs
        .filter_map(|own| Interval::new(own[0].clone(), own[1].clone()))
        .collect()
}
