//! The workloads: swept surfaces as data, written as `.sweep` text and compiled by the functions that
//! `compile` calls.

use std::collections::HashMap;
use std::rc::Rc;
use std::time::{Duration, Instant};

use serde::Deserialize;
use sweepc::curve::{Curve, Property};
use sweepc::diag::{Diagnostics, Limits, SourceMap};
use sweepc::export::{Double, RoundedNet};
use sweepc::net::ControlNet;
use sweepc::number::{Real, Tower};
use sweepc::poly::{BiDegree, UniPoly, from_bernstein};
use sweepc::sema;
use sweepc::sweep::{Expansion, Step};
use sweepc::syntax::ast::Document;

use crate::curves::{Curves, Sweep};

const LIBRARY: &str = include_str!("../../src/std/constructions.sweep");

/// A set of records.
#[derive(Debug, Deserialize)]
pub(crate) struct Set {
    pub(crate) cases: Vec<Record>,
}

/// A swept surface: a sweep curve with the hodograph h w², a profile (X/D, Z/D), a formula.
#[derive(Debug, Deserialize)]
pub(crate) struct Record {
    pub(crate) id: String,
    /// The degree of the preimage.
    pub(crate) m: usize,
    kind: String,
    w: Vec<[Coefficient; 2]>,
    h: Vec<String>,
    s0: [String; 2],
    profile: Profile,
    d: String,
    c: String,
    #[serde(default)]
    field: Vec<u32>,
    pub(crate) expected: Option<Expected>,
}

/// A rational number, or its components on 1, √a, √b, √(ab).
#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Coefficient {
    Rational(String),
    Components(Vec<String>),
}

/// Power coefficients in u.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
struct Profile {
    x: Vec<String>,
    z: Vec<String>,
    d: Vec<String>,
}

/// What three other programs found.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Expected {
    pub(crate) hash: String,
    pub(crate) bidegree: [usize; 2],
    pub(crate) common_factor: [usize; 2],
}

impl Record {
    /// The surface as `.sweep` text.
    pub(crate) fn text(&self) -> String {
        let Profile { x, z, d } = &self.profile;
        let [x, z, d] = [x, z, d].map(|own| polynomial(own, "u"));
        let formula = match self.kind.as_str() {
            "oriented" => "c(v) + x(u) n(v) + z(u) k".to_owned(),
            "offset" => format!("c(v) + ({}) n(v) + (x(u), 0, z(u))", self.d),
            "conical" => "c(v) + s(v) / length(c) * (x(u) n(v) + z(u) k)".to_owned(),
            "conical_inv" => {
                let c = &self.c;
                format!("c(v) + ({c}) / ({c} + s(v)) * (x(u) n(v) + z(u) k)")
            }
            "involute" => "c(v) - s(v) t(v) + x(u) t(v) + z(u) k".to_owned(),
            kind => unreachable!("{kind}"),
        };
        format!(
            "profile p(u) in xz = (({x}) / ({d}), ({z}) / ({d}))\n\
             sweep c(v) in xy = {}\nsurface R = {formula}\n",
            self.curve()
        )
    }

    /// The sweep curve, by its preimage or, where a real factor h is given, by its coordinates.
    fn curve(&self) -> String {
        let [start_x, start_y] = &self.s0;
        if self.h.is_empty() {
            let pairs = self.w.iter().map(|[re, im]| {
                let part = |own: &Coefficient| own.text(&self.field);
                format!("({}, {})", part(re), part(im))
            });
            let pairs: Vec<String> = pairs.collect();
            return format!(
                "ph(start: ({start_x}, {start_y}), preimage: [{}])",
                pairs.join(", ")
            );
        }
        let written = |own: &Vec<Real>| {
            let own: Vec<String> = own.iter().map(ToString::to_string).collect();
            polynomial(&own, "v")
        };
        let [x, y] = self.coordinates();
        format!("({}, {})", written(&x), written(&y))
    }

    /// Power coefficients of the curve with the hodograph h w².
    fn coordinates(&self) -> [Vec<Real>; 2] {
        let part = |index: usize| {
            let own: Vec<Real> = self.w.iter().map(|pair| pair[index].real(&[])).collect();
            from_bernstein(&own, &0.into(), &1.into())
        };
        let (re, im) = (part(0), part(1));
        let h =
            UniPoly::from_coefficients(&self.h.iter().map(|own| number(own)).collect::<Vec<_>>());
        let slopes = [&(&re * &re) - &(&im * &im), (&re * &im).scale(&2.into())];
        let [x, y] = &self.s0;
        [(&slopes[0], x), (&slopes[1], y)].map(|(slope, start)| {
            let own = (slope * &h).antiderivative_from(&0.into(), &number(start));
            own.coefficients()
        })
    }

    /// The numbers of the curves, and what the formula asks of them.
    fn curves(&self) -> Curves {
        let Profile { x, z, d } = &self.profile;
        let numbers = |own: &Vec<String>| own.iter().map(|own| number(own)).collect();
        let tower = Tower::default();
        let root = |own: &u32| tower.square_root(&Real::from(i64::from(*own)));
        let roots: Result<Vec<Real>, _> = self.field.iter().map(root).collect();
        let roots = roots.unwrap_or_else(|own| unreachable!("{own:?}"));
        let sweep = if self.h.is_empty() {
            let pairs = self.w.iter();
            let pairs = pairs.map(|pair| pair.iter().map(|own| own.real(&roots)).collect());
            Sweep::of_preimage(self.s0.each_ref().map(|own| number(own)), pairs.collect())
        } else {
            Sweep::Coordinates(self.coordinates())
        };
        let properties: Vec<fn(_) -> _> = match self.kind.as_str() {
            "oriented" | "offset" => vec![Property::Position, Property::Normal],
            "involute" => vec![
                Property::Position,
                |_| Property::ArcLength,
                Property::Tangent,
            ],
            _ => vec![
                Property::Position,
                |_| Property::ArcLength,
                Property::Normal,
            ],
        };
        Curves {
            tower,
            sweep,
            profile: [numbers(x), numbers(z), numbers(d)],
            properties,
        }
    }
}

impl Coefficient {
    fn text(&self, field: &[u32]) -> String {
        match self {
            Self::Rational(own) => own.clone(),
            Self::Components(own) => {
                let product = |index: usize| {
                    let roots = field
                        .iter()
                        .enumerate()
                        .filter(|(bit, _)| index >> bit & 1 == 1);
                    roots
                        .map(|(_, own)| format!(" * sqrt({own})"))
                        .collect::<String>()
                };
                let terms = own.iter().enumerate();
                let terms: Vec<String> = terms
                    .map(|(index, own)| format!("({own}){}", product(index)))
                    .collect();
                terms.join(" + ")
            }
        }
    }

    /// The number, with the square roots of the field.
    fn real(&self, roots: &[Real]) -> Real {
        let own = match self {
            Self::Rational(own) => return number(own),
            Self::Components(own) => own,
        };
        let terms = own.iter().enumerate().map(|(index, own)| {
            let roots = roots.iter().enumerate();
            let roots = roots.filter(|(bit, _)| index >> bit & 1 == 1);
            roots.fold(number(own), |product, (_, own)| &product * own)
        });
        terms.fold(Real::from(0), |sum, own| &sum + &own)
    }
}

fn number(text: &str) -> Real {
    text.parse().unwrap_or_else(|()| unreachable!("{text}"))
}

fn polynomial(coefficients: &[String], variable: &str) -> String {
    let terms = coefficients.iter().enumerate();
    let terms: Vec<String> = terms
        .map(|(power, own)| format!("({own}) * {variable}^{power}"))
        .collect();
    if terms.is_empty() {
        "0".to_owned()
    } else {
        terms.join(" + ")
    }
}

/// A parsed record, ready to be compiled any number of times.
pub(crate) struct Parsed {
    curves: Curves,
    map: SourceMap,
    document: Document,
    library: sema::Library,
    limits: Limits,
}

/// What a compilation gave, and how long its steps took.
pub(crate) struct Outcome {
    pub(crate) bidegree: [usize; 2],
    pub(crate) common_factor: [usize; 2],
    pub(crate) hash: String,
    pub(crate) net: ControlNet,
    /// The profile and the sweep curve.
    pub(crate) curves: Vec<Rc<Curve>>,
    /// In the order of [`STEPS`].
    pub(crate) times: [Duration; STEPS.len()],
}

/// The steps of a compilation: names, types and curves of the text; the formula over a common
/// denominator; the common factor, and the proof that it is all; the quotients; the net; its doubles.
pub(crate) const STEPS: [&str; 6] = ["lower", "expand", "gcd", "divide", "bernstein", "round"];

/// Gives the time since the last call to one of the steps.
struct Watch {
    last: Instant,
    times: [Duration; STEPS.len()],
}

impl Watch {
    fn start() -> Self {
        Self {
            last: Instant::now(),
            times: Default::default(),
        }
    }

    fn tick(&mut self, step: usize) {
        let now = Instant::now();
        self.times[step] += now - self.last;
        self.last = now;
    }
}

impl Parsed {
    /// Parses the text of a record.
    pub(crate) fn new(record: &Record) -> Self {
        let limits = Limits {
            degree: usize::MAX,
            terms: usize::MAX,
            ..Limits::default()
        };
        let (mut map, mut found) = (SourceMap::default(), Diagnostics::default());
        let text = record.text();
        let file = map.add("workload.sweep", &text);
        let document = sweepc::syntax::parse(file, &text, &limits, &mut found);
        let file = map.add("library", LIBRARY);
        let library = sweepc::syntax::parse(file, LIBRARY, &limits, &mut found);
        assert!(!found.has_errors(), "{text}\n{found:?}");
        Self {
            curves: record.curves(),
            map,
            document,
            library: sema::Library::new(library),
            limits,
        }
    }

    /// How long the curves alone take.
    ///
    /// # Panics
    ///
    /// If they are not those that were compiled.
    pub(crate) fn curves(&self, outcome: &Outcome) -> Duration {
        let (time, curves) = self.curves.measure();
        let compiled = outcome.curves.iter().map(|own| own.position());
        assert!(curves.iter().map(Curve::position).eq(compiled));
        time
    }

    /// From the tree to the doubles.
    pub(crate) fn compile(&self) -> Outcome {
        let mut found = Diagnostics::default();
        let mut watch = Watch::start();
        let program = sema::lower(
            &sema::Sources {
                map: &self.map,
                documents: std::slice::from_ref(&self.document),
                library: &self.library,
                overrides: &HashMap::new(),
                limits: &self.limits,
            },
            &mut found,
        );
        watch.tick(0);
        let Some(surface) = program.surfaces.first() else {
            unreachable!("{found:?}");
        };
        let expansion = Expansion::of_in_steps(surface, &self.limits, &mut |step| {
            watch.tick(match step {
                Step::Expanded => 1,
                Step::FactorFound | Step::Certified => 2,
                Step::Divided | Step::Scaled => 3,
            });
        });
        let expansion = expansion.unwrap_or_else(|own| unreachable!("{own:?}"));
        let (zero, one) = (Real::from(0), Real::from(1));
        let coordinates = expansion.surface.proportional();
        let net = ControlNet::bezier(coordinates.each_ref(), (&zero, &one), (&zero, &one));
        let Some(net) = net else {
            unreachable!("the first weight is 0");
        };
        watch.tick(4);
        let rounded = RoundedNet::new(&net);
        let rounded = rounded.unwrap_or_else(|own| unreachable!("{own:?}"));
        watch.tick(5);
        let pair = |own: BiDegree| [own.u, own.v];
        Outcome {
            bidegree: pair(expansion.surface.bidegree()),
            common_factor: expansion.common_factor.bidegree().map_or([0, 0], pair),
            hash: hash(&rounded),
            net,
            curves: program.curves,
            times: watch.times,
        }
    }
}

/// FNV-1a 64 over the little-endian bytes of x y z w, point by point, u outside and v inside.
fn hash(net: &RoundedNet) -> String {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut take = |own: &Double| {
        for byte in own.value().to_bits().to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    };
    for (weights, points) in net.weights.iter().zip(&net.points) {
        for (weight, point) in weights.iter().zip(points) {
            point.iter().for_each(&mut take);
            take(weight);
        }
    }
    format!("{hash:016x}")
}
