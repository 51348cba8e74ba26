use crate::curve::{Interval, Parameter};
use crate::diag::{Code, Diagnostic, Limits};
use crate::number::Real;
use crate::poly::{ZeroKind, ZeroSet};
use crate::sweep::{Domain, Expansion, HomogeneousSurface, SweptSurface};

use super::affine::affine_degrees;
use super::direction::NormalDirection;
use super::offset::rational_offset;
use super::pole::zeros_on;
use super::regular::regular;
use super::weights::weight_range;
use super::{AffineDegree, Positivity, Verdict, WeightRange};

/// A surface whose degrees, common factor, poles and weights are known.
#[derive(Debug, Clone)]
pub struct Checked {
    definition: SweptSurface,
    expansion: Expansion,
    affine: [AffineDegree; 3],
    weights: Option<WeightRange>,
    positivity: Result<Positivity, &'static str>,
    poles: Vec<ZeroSet<Real>>,
    shared_zeros: Vec<ZeroSet<Real>>,
    regular: Verdict,
    singular: Vec<ZeroSet<Real>>,
    rational_offset: Verdict,
}

/// How many poles an error lists.
const POLES_SHOWN: usize = 4;

impl Checked {
    /// Expands a surface and decides what there is to decide.
    ///
    /// # Errors
    ///
    /// What [`Expansion::of`] finds, and E0302 if the formula is a curve or a point.
    pub fn of(definition: SweptSurface, limits: &Limits) -> Result<Self, Box<Diagnostic>> {
        let expansion = Expansion::of(&definition, limits)?;
        let surface = &expansion.surface;
        let domain = &definition.domain;
        let Some(direction) = NormalDirection::of(surface) else {
            let message = format!("`{}` is a curve or a point, not a surface", definition.name);
            let finding = Diagnostic::new(Code::E0302, definition.span, message);
            return Err(Box::new(finding.note("R_u × R_v is zero identically")));
        };
        let poles = zeros_on(surface.weight(), domain);
        let (regular, singular) = if poles.is_empty() {
            regular(&direction, domain)
        } else {
            let reason = "the surface has a pole on the domain".to_owned();
            (Verdict::Undecided(reason), Vec::new())
        };
        let weights = weight_range(surface.weight(), surface.bidegree(), domain);
        let positivity = if !poles.is_empty() {
            Err("W vanishes on the domain")
        } else if weights.as_ref().is_some_and(WeightRange::is_positive) {
            Ok(Positivity::of_one_patch(surface.bidegree(), domain))
        } else {
            Positivity::of(surface.weight(), surface.bidegree(), domain)
        };
        Ok(Self {
            affine: affine_degrees(surface),
            regular,
            singular,
            rational_offset: rational_offset(&direction),
            weights,
            positivity,
            poles,
            shared_zeros: zeros_on(&expansion.common_factor, domain),
            expansion,
            definition,
        })
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.definition.name
    }

    /// Its formula.
    #[must_use]
    pub fn definition(&self) -> &SweptSurface {
        &self.definition
    }

    /// Its domain.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        &self.definition.domain
    }

    /// W, X, Y, Z, coprime and in normal form.
    #[must_use]
    pub fn surface(&self) -> &HomogeneousSurface {
        &self.expansion.surface
    }

    /// The story of its degrees.
    #[must_use]
    pub fn expansion(&self) -> &Expansion {
        &self.expansion
    }

    /// The degrees of x, y, z in lowest terms.
    #[must_use]
    pub fn affine(&self) -> &[AffineDegree; 3] {
        &self.affine
    }

    /// The range of the weights; none if W vanishes at the first corner.
    #[must_use]
    pub fn weights(&self) -> Option<&WeightRange> {
        self.weights.as_ref()
    }

    /// Patches with positive weights.
    ///
    /// # Errors
    ///
    /// Why there are none, in a few words.
    pub fn positivity(&self) -> Result<&Positivity, &'static str> {
        self.positivity.as_ref().map_err(|reason| *reason)
    }

    /// Where W vanishes on the domain.
    #[must_use]
    pub fn poles(&self) -> &[ZeroSet<Real>] {
        &self.poles
    }

    /// Whether R_u × R_v is nowhere zero on the domain.
    #[must_use]
    pub fn regular(&self) -> &Verdict {
        &self.regular
    }

    /// Places on the domain where R_u × R_v is zero. Lines are complete, of others there may be
    /// more.
    #[must_use]
    pub fn singular(&self) -> &[ZeroSet<Real>] {
        &self.singular
    }

    /// Whether the offsets are rational in the same parameters.
    #[must_use]
    pub fn rational_offset(&self) -> &Verdict {
        &self.rational_offset
    }

    /// The warning for a surface that folds, has a cusp or is otherwise singular inside its domain.
    /// A side that collapses to a point is no such place.
    #[must_use]
    pub fn singular_finding(&self) -> Option<Diagnostic> {
        let Domain { u, v } = self.domain();
        let on_side = |(lower, upper): &(Real, Real), range: &Interval| {
            lower == upper && (lower == range.start() || lower == range.end())
        };
        let place = self.singular.iter().find(|place| match place.kind {
            ZeroKind::LineU => !(on_side(&place.u, u) && self.collapses(place)),
            ZeroKind::LineV => !(on_side(&place.v, v) && self.collapses(place)),
            ZeroKind::Point => !(on_side(&place.u, u) && on_side(&place.v, v)),
            ZeroKind::Box => true,
        })?;
        let message = format!(
            "`{}` is not regular: R_u × R_v is zero at {place}",
            self.name()
        );
        let finding = Diagnostic::new(Code::W1011, self.definition.span, message);
        let note = "the surface folds there, or its sweep curve or profile has a cusp or stops";
        Some(finding.note(note))
    }

    /// Whether all points of a line are the same: X, Y and Z are multiples of W there.
    fn collapses(&self, line: &ZeroSet<Real>) -> bool {
        let coordinates = self.surface().proportional().each_ref();
        let [weight, point @ ..] = coordinates.map(|own| match line.kind {
            ZeroKind::LineU => own.at_u(&line.u.0),
            _ => own.at_v(&line.v.0),
        });
        let lead = weight.leading_coefficient();
        point.iter().all(|own| {
            let multiple = weight.scale(&own.leading_coefficient());
            own.is_zero() || own.scale(&lead) == multiple
        })
    }

    /// The warning for a zero that W, X, Y, Z as constructed have in common on the domain, so that
    /// the formula says 0/0 there. Those that a curve brings, at bounds in its parameter, are told
    /// of the curve.
    #[must_use]
    pub fn shared_zero_finding(
        &self,
        of_curves: &[(Parameter, (Real, Real))],
    ) -> Option<Diagnostic> {
        let overlaps =
            |own: &(Real, Real), other: &(Real, Real)| own.0 <= other.1 && other.0 <= own.1;
        let is_told = |place: &&ZeroSet<Real>| {
            of_curves
                .iter()
                .any(|(parameter, bounds)| match place.kind {
                    ZeroKind::LineU => *parameter == Parameter::U && overlaps(&place.u, bounds),
                    ZeroKind::LineV => *parameter == Parameter::V && overlaps(&place.v, bounds),
                    ZeroKind::Point | ZeroKind::Box => false,
                })
        };
        let untold = self.shared_zeros.iter().filter(|place| !is_told(place));
        let first = untold.clone().next()?;
        let factor = &self.expansion.common_factor;
        let lines = untold.filter(|place| place.kind.is_line());
        let lines: Vec<_> = lines.map(ToString::to_string).collect();
        // Of a factor that vanishes on a curve, one point is known.
        let places = match lines.as_slice() {
            [] => format!("where {factor} = 0, as at {first}"),
            [only] => format!("on the line {only}"),
            several => format!("on the lines {}", several.join(", ")),
        };
        let message = format!(
            "numerators and denominator of `{}` are all zero {places}",
            self.name()
        );
        let finding = Diagnostic::new(Code::W1004, self.definition.span, message);
        Some(finding.note(format!("the common factor {factor} cancels")))
    }

    /// The error that the poles are, if there are any.
    #[must_use]
    pub fn pole_finding(&self) -> Option<Diagnostic> {
        if self.poles.is_empty() {
            return None;
        }
        let message = format!(
            "`{}` has a pole on its domain: W vanishes there",
            self.name()
        );
        let mut finding = Diagnostic::new(Code::E0301, self.definition.span, message);
        for pole in self.poles.iter().take(POLES_SHOWN) {
            finding = finding.note(format!("W = 0 at {pole}"));
        }
        if let Some(more @ 1..) = self.poles.len().checked_sub(POLES_SHOWN) {
            finding = finding.note(format!("and at {more} more places; the report lists them"));
        }
        Some(finding.help("end the domain before the pole: `on [a, b] x [c, d]`"))
    }
}
