use std::rc::Rc;

use serde::Serialize;

use crate::check::{AffineDegree, Checked, Judgement, Positivity, Verdict};
use crate::curve::{Curve, Interval};
use crate::number::{Basis, Field, Real, Unit};
use crate::poly::{BiDegree, BiPoly, Coprimality, UniPoly, ZeroKind, ZeroSet};
use crate::sweep::Domain;

use super::curve::{CurveReport, arc_length};

/// The report of a file, as `report --format json` prints it.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    format: &'static str,
    /// The name of the file.
    pub file: String,
    pub(super) field: Vec<Generator>,
    /// One report for each surface.
    pub surfaces: Vec<SurfaceReport>,
    /// One report for each Hermite interpolant, and for each other Pythagorean-hodograph curve whose
    /// speed the file needs.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub curves: Vec<CurveReport>,
    /// The unit of length.
    #[serde(skip)]
    pub unit: Unit,
}

impl Report {
    /// The report of a file's surfaces, each with its expectations and their lines, and of its
    /// curves.
    #[must_use]
    pub fn new(
        file: String,
        unit: Unit,
        surfaces: &[(&Checked, Vec<(&Judgement, usize)>)],
        curves: &[Rc<Curve>],
    ) -> Self {
        let told = |own: &Curve| own.is_measured() || own.interpolant().is_some();
        let used = |own: &&Rc<Curve>| told(own) && !surfaces.is_empty();
        let curves = || curves.iter().filter(used);
        let lengths: Vec<Real> = curves().filter_map(|own| arc_length(own)).collect();
        let basis = surfaces.iter().map(|(surface, _)| basis(surface)).fold(
            Basis::of(lengths.iter().map(Real::numerator)),
            |all, own| all.union(&own),
        );
        let definitions = basis.definitions().into_iter();
        Self {
            format: "sweepc-report/1",
            file,
            field: definitions
                .map(|(name, square)| Generator { name, square })
                .collect(),
            surfaces: surfaces
                .iter()
                .map(|(surface, judgements)| SurfaceReport::of(surface, judgements, &basis))
                .collect(),
            curves: curves().map(|own| CurveReport::of(own, &basis)).collect(),
            unit,
        }
    }
}

/// A generator of the field: the positive root of its square.
#[derive(Debug, Clone, Serialize)]
pub struct Generator {
    /// Its name.
    pub name: String,
    /// The number that it is the root of.
    pub square: String,
}

/// The generators of the numbers that the report of a surface spells.
fn basis(surface: &Checked) -> Basis {
    let homogeneous = surface.surface().coordinates().iter();
    let polynomials = homogeneous.chain(std::iter::once(&surface.expansion().common_factor));
    let rows: Vec<UniPoly<Real>> = polynomials.flat_map(BiPoly::rows).collect();
    let places = surface.poles().iter().chain(surface.singular());
    let bounds = places.flat_map(|own| [&own.u.0, &own.u.1, &own.v.0, &own.v.1]);
    let domain = surface.domain();
    let ends = [&domain.u, &domain.v].map(|own| [own.start(), own.end()]);
    let weights = surface.weights().map(|range| [&range.min, &range.max]);
    let numbers = bounds
        .chain(ends.into_iter().flatten())
        .chain(weights.into_iter().flatten());
    let coefficients = rows.iter().flat_map(UniPoly::numerators);
    Basis::of(coefficients.chain(numbers.map(Real::numerator)))
}

/// The report of one surface. Bidegrees are `[u, v]`, null for the zero polynomial.
#[derive(Debug, Clone, Serialize)]
pub struct SurfaceReport {
    /// Its name.
    pub name: String,
    /// Its domain.
    pub(super) domain: DomainReport,
    pub(super) homogeneous: Coordinates<PolynomialReport>,
    pub(super) bound: Coordinates<Option<[usize; 2]>>,
    pub(super) as_constructed: Coordinates<Option<[usize; 2]>>,
    pub(super) common_factor: PolynomialReport,
    pub(super) affine: AffineReport,
    pub(super) patch: PatchReport,
    pub(super) weights: WeightsReport,
    pub(super) poles: Vec<PlaceReport>,
    pub(super) singular: Vec<PlaceReport>,
    pub(super) regular: Decision,
    pub(super) rational_offset: Decision,
    pub(super) expectations: Vec<ExpectationReport>,
    /// What only the readable forms of the report say.
    #[serde(skip)]
    pub(super) remarks: Remarks,
}

#[derive(Debug, Clone)]
pub(super) struct Remarks {
    pub(super) field: Option<String>,
    pub(super) common_factor: String,
    pub(super) coprimality: String,
    pub(super) regular: Verdict,
    pub(super) rational_offset: Verdict,
    pub(super) weights: Option<(String, String)>,
    /// In which form the weights are positive, where the one patch is not enough; or why in none.
    pub(super) positivity: Option<String>,
    pub(super) poles: Vec<String>,
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct DomainReport {
    pub(super) u: [String; 2],
    pub(super) v: [String; 2],
}

#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "UPPERCASE")]
pub(super) struct Coordinates<T> {
    pub(super) w: T,
    pub(super) x: T,
    pub(super) y: T,
    pub(super) z: T,
}

impl<T> Coordinates<T> {
    fn of([w, x, y, z]: [T; 4]) -> Self {
        Self { w, x, y, z }
    }

    pub(super) fn list(&self) -> [&T; 4] {
        [&self.w, &self.x, &self.y, &self.z]
    }
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct PolynomialReport {
    pub(super) bidegree: Option<[usize; 2]>,
    pub(super) terms: Vec<(usize, usize, String)>,
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct AffineReport {
    pub(super) x: AffineCoordinate,
    pub(super) y: AffineCoordinate,
    pub(super) z: AffineCoordinate,
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct AffineCoordinate {
    pub(super) numerator: Option<[usize; 2]>,
    pub(super) denominator: [usize; 2],
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct PatchReport {
    pub(super) bidegree: [usize; 2],
    pub(super) spans: [usize; 2],
    pub(super) control_points: [usize; 2],
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct WeightsReport {
    pub(super) positive: bool,
    pub(super) min: Option<String>,
    pub(super) max: Option<String>,
    /// Null if there are poles, or if none was found.
    pub(super) certificate: Option<CertificateReport>,
}

/// Patches whose weights are all positive.
#[derive(Debug, Clone, Serialize)]
pub(super) struct CertificateReport {
    pub(super) bidegree: [usize; 2],
    pub(super) rectangles: Vec<DomainReport>,
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct PlaceReport {
    kind: &'static str,
    u: [String; 2],
    v: [String; 2],
}

/// True, false, or `"undecided"`.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(untagged)]
pub enum Decision {
    /// True or false.
    Decided(bool),
    /// The word for it.
    Undecided(&'static str),
}

impl std::fmt::Display for Decision {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Decided(own) => own.fmt(formatter),
            Self::Undecided(word) => formatter.write_str(word),
        }
    }
}

impl Decision {
    fn of(verdict: &Verdict) -> Self {
        verdict
            .holds()
            .map_or(Self::Undecided("undecided"), Self::Decided)
    }
}

#[derive(Debug, Clone, Serialize)]
pub(super) struct ExpectationReport {
    pub(super) text: String,
    pub(super) holds: Decision,
    pub(super) line: usize,
    #[serde(skip)]
    pub(super) because: String,
}

impl SurfaceReport {
    fn of(surface: &Checked, judgements: &[(&Judgement, usize)], basis: &Basis) -> Self {
        let expansion = surface.expansion();
        let homogeneous = surface.surface();
        let degree = homogeneous.bidegree();
        let range = surface.weights();
        Self {
            name: surface.name().to_owned(),
            domain: domain(surface.domain(), basis),
            homogeneous: Coordinates::of(
                homogeneous
                    .coordinates()
                    .each_ref()
                    .map(|own| polynomial(own, basis)),
            ),
            bound: Coordinates::of(expansion.bound().map(pair)),
            as_constructed: Coordinates::of(expansion.constructed.map(pair)),
            common_factor: polynomial(&expansion.common_factor, basis),
            affine: affine(surface.affine()),
            patch: PatchReport {
                bidegree: [degree.u, degree.v],
                spans: [1, 1],
                control_points: [degree.u + 1, degree.v + 1],
            },
            weights: WeightsReport {
                positive: range.is_some_and(crate::check::WeightRange::is_positive),
                min: range.map(|range| basis.spell(&range.min)),
                max: range.map(|range| basis.spell(&range.max)),
                certificate: surface.positivity().ok().map(|own| certificate(own, basis)),
            },
            poles: surface
                .poles()
                .iter()
                .map(|own| place(own, basis))
                .collect(),
            singular: surface
                .singular()
                .iter()
                .map(|own| place(own, basis))
                .collect(),
            regular: Decision::of(surface.regular()),
            rational_offset: Decision::of(surface.rational_offset()),
            expectations: judgements
                .iter()
                .map(|(own, line)| expectation(own, *line))
                .collect(),
            remarks: remarks(surface, basis),
        }
    }
}

fn remarks(surface: &Checked, names: &Basis) -> Remarks {
    let expansion = surface.expansion();
    Remarks {
        field: names.describe(&basis(surface)),
        common_factor: expansion.common_factor.to_string(),
        coprimality: match expansion.coprimality {
            Some(Coprimality::Modular(prime)) => format!("coprime, proved modulo {}", prime.name()),
            Some(Coprimality::Euclid) => "coprime, proved by exact division".to_owned(),
            None => "coprimality not certified".to_owned(),
        },
        regular: surface.regular().clone(),
        rational_offset: surface.rational_offset().clone(),
        weights: surface
            .weights()
            .map(|range| (number(&range.min), number(&range.max))),
        positivity: positivity(surface),
        poles: surface.poles().iter().map(ToString::to_string).collect(),
    }
}

/// How the weights become positive where those of the one patch are not.
fn positivity(surface: &Checked) -> Option<String> {
    let Ok(own) = surface.positivity() else {
        let reason = surface
            .positivity()
            .err()
            .filter(|_| surface.poles().is_empty());
        return reason.map(|reason| format!("no patches with positive weights: {reason}"));
    };
    let degree = surface.surface().bidegree();
    let raised = |text| {
        if own.degree == degree {
            text
        } else {
            format!(
                "{text}, elevated to bidegree ({}, {})",
                own.degree.u, own.degree.v
            )
        }
    };
    if own.rectangles.len() == 1 {
        let text = "positive as one patch".to_owned();
        return (own.degree != degree).then(|| raised(text));
    }
    let text = format!("positive in {} patches", own.rectangles.len());
    let Some(cuts) = own.cuts() else {
        return Some(raised(format!("{text}, by halving")));
    };
    let named = ["u", "v"].into_iter().zip(&cuts);
    let cuts = named.filter(|(_, own)| !own.is_empty()).map(|(name, own)| {
        let places: Vec<_> = own.iter().map(|own| number(own)).collect();
        format!("{name} = {}", places.join(", "))
    });
    let cuts: Vec<_> = cuts.collect();
    Some(raised(format!("{text}, cut at {}", cuts.join(" and "))))
}

/// A number as a reader wants it: exact where that is short, else its first digits.
fn number(value: &Real) -> String {
    let exact = value.to_string();
    if exact.chars().count() <= 12 {
        exact
    } else {
        format!("≈ {}", value.decimal(6))
    }
}

fn pair(degree: Option<BiDegree>) -> Option<[usize; 2]> {
    degree.map(|BiDegree { u, v }| [u, v])
}

fn ends(interval: &Interval, basis: &Basis) -> [String; 2] {
    [interval.start(), interval.end()].map(|end| basis.spell(end))
}

fn domain(domain: &Domain, basis: &Basis) -> DomainReport {
    DomainReport {
        u: ends(&domain.u, basis),
        v: ends(&domain.v, basis),
    }
}

fn certificate(positivity: &Positivity, basis: &Basis) -> CertificateReport {
    let rectangles = positivity.rectangles.iter();
    CertificateReport {
        bidegree: [positivity.degree.u, positivity.degree.v],
        rectangles: rectangles.map(|own| domain(own, basis)).collect(),
    }
}

fn polynomial(polynomial: &BiPoly<Real>, basis: &Basis) -> PolynomialReport {
    let mut terms = Vec::new();
    for (u, row) in polynomial.rows().iter().enumerate() {
        for (v, coefficient) in UniPoly::coefficients(row).iter().enumerate() {
            if !coefficient.is_zero() {
                terms.push((u, v, basis.spell(coefficient)));
            }
        }
    }
    PolynomialReport {
        bidegree: pair(polynomial.bidegree()),
        terms,
    }
}

fn affine([x, y, z]: &[AffineDegree; 3]) -> AffineReport {
    let of = |own: &AffineDegree| AffineCoordinate {
        numerator: pair(own.numerator),
        denominator: [own.denominator.u, own.denominator.v],
    };
    AffineReport {
        x: of(x),
        y: of(y),
        z: of(z),
    }
}

fn place(zeros: &ZeroSet<Real>, basis: &Basis) -> PlaceReport {
    let bounds = |(lower, upper): &(Real, Real)| [lower, upper].map(|own| basis.spell(own));
    PlaceReport {
        kind: match zeros.kind {
            ZeroKind::LineU => "u",
            ZeroKind::LineV => "v",
            ZeroKind::Point => "point",
            ZeroKind::Box => "box",
        },
        u: bounds(&zeros.u),
        v: bounds(&zeros.v),
    }
}

fn expectation(judgement: &Judgement, line: usize) -> ExpectationReport {
    ExpectationReport {
        text: judgement.expectation.text.clone(),
        holds: Decision::of(&judgement.verdict),
        line,
        because: judgement.verdict.because().to_owned(),
    }
}
