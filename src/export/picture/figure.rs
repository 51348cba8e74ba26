#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use crate::export::{Context, Double, ExportFault, Guide};
use crate::net::{ControlNet, Model, Part};
use crate::number::{Field, Real};

use super::approx_surface::{ApproxSurface, Sample};
use super::contour::Contours;
use super::grid::Grid;
use super::occluder::Occluder;
use super::orientation::turned;
use super::shade::Shades;
use super::stage::{Stage, WIDTH};
use super::stroke::Stroke;
use super::vector::{Vector, between, dot, minus};

/// Chords of a curve.
const CHORDS: u16 = 128;
/// Pieces of a side of a control polygon, each looked for by itself.
const PIECES: u8 = 48;
/// How far outside of a contour it is looked for, in units of the picture.
const ASIDE: f64 = 1.0;
/// Control points that are farther from the surfaces than this many times their size are left out.
const REACH: f64 = 2.0;

/// What a picture shows, in its plane.
pub(super) struct Figure {
    pub(super) stage: Stage,
    pub(super) shades: Vec<Shades>,
    /// For each surface whether its front is the side of its normal R_u × R_v.
    pub(super) fronts: Vec<bool>,
    pub(super) isoparametric: Vec<Stroke>,
    /// Sides of domains, and contours.
    pub(super) edges: Vec<Stroke>,
    pub(super) control_polygons: Vec<Stroke>,
    pub(super) control_points: Vec<[f64; 2]>,
    pub(super) hidden_points: Vec<[f64; 2]>,
    pub(super) curves: Vec<CurveFigure>,
}

/// A profile or a sweep curve.
pub(super) struct CurveFigure {
    pub(super) name: String,
    pub(super) is_profile: bool,
    pub(super) stroke: Stroke,
    /// Where its name is written.
    pub(super) label: [f64; 2],
}

impl Figure {
    /// Draws the surfaces of a model with the curves of their context.
    ///
    /// - **errors** a number beyond the last double (E0306)
    pub(super) fn of(model: &Model, context: &Context<'_>) -> Result<Self, ExportFault> {
        let bodies = Body::all(model)?;
        let curves = context.guides.iter().map(points);
        let curves: Vec<Vec<Vector>> = curves.collect();
        let samples = bodies.iter().flat_map(|own| own.grid.samples());
        let mut shown: Vec<Vector> = samples.map(|own| own.point).collect();
        shown.extend(curves.iter().flatten());
        let nets = bodies.iter().map(|own| ControlPoints::of(own.net, &shown));
        let nets: Vec<ControlPoints> = nets.collect();
        shown.extend(nets.iter().flat_map(|own| own.points.iter().flatten()));
        let artist = Artist::new(Stage::new(&context.view, &shown), &bodies);
        let mut shades: Vec<Shades> = bodies.iter().map(|own| artist.shades(own)).collect();
        let fronts = fronts(&shades, &turned(model));
        for (own, front) in shades.iter_mut().zip(&fronts) {
            own.turn(*front);
        }
        let mut figure = Self {
            shades,
            fronts,
            isoparametric: Vec::new(),
            edges: Vec::new(),
            control_polygons: Vec::new(),
            control_points: Vec::new(),
            hidden_points: Vec::new(),
            curves: artist.curves(&context.guides, &curves),
            stage: artist.stage.clone(),
        };
        for (body, net) in bodies.iter().zip(&nets) {
            figure.draw(&artist, body, net);
        }
        Ok(figure)
    }

    /// Draws one surface and its net.
    fn draw(&mut self, artist: &Artist, body: &Body<'_>, net: &ControlPoints) {
        let (edges, inner) = body.lines();
        self.edges.extend(artist.contours(body));
        self.edges
            .extend(edges.iter().map(|own| artist.stroke(own)));
        let inner = inner.iter().map(|own| artist.stroke(own));
        self.isoparametric.extend(inner);
        let sides = net.sides();
        let sides = sides.iter().map(|own| artist.stroke(own));
        self.control_polygons.extend(sides);
        for point in net.points.iter().flatten() {
            let place = self.stage.place(*point);
            let dot = [place[0], place[1]];
            if artist.occluder.hides(place) {
                self.hidden_points.push(dot);
            } else {
                self.control_points.push(dot);
            }
        }
    }
}

/// For each surface whether its front is the side of its normal: all fronts together are what is
/// seen most.
fn fronts(shades: &[Shades], turned: &[bool]) -> Vec<bool> {
    let seen = shades.iter().zip(turned).map(|(own, is_turned)| {
        let votes = own.votes();
        if *is_turned { -votes } else { votes }
    });
    let is_normal = seen.sum::<i64>() >= 0;
    turned.iter().map(|own| is_normal != *own).collect()
}

/// One surface, ready to be drawn.
struct Body<'a> {
    net: &'a ControlNet,
    surface: ApproxSurface,
    grid: Grid,
}

impl<'a> Body<'a> {
    /// All surfaces of a picture, with lines at about the same distance.
    fn all(model: &'a Model) -> Result<Vec<Self>, ExportFault> {
        let surfaces = model.parts().iter().map(|own| ApproxSurface::new(&own.net));
        let surfaces: Vec<ApproxSurface> = surfaces.collect::<Result<_, _>>()?;
        let spacing = surfaces.iter().map(Grid::spacing).fold(0.0, f64::max);
        let body = |(surface, own): (ApproxSurface, &'a Part)| Body {
            grid: Grid::new(&surface, spacing),
            net: &own.net,
            surface,
        };
        Ok(surfaces.into_iter().zip(model.parts()).map(body).collect())
    }

    fn triangles(&self, stage: &Stage) -> Vec<[Vector; 3]> {
        let cells = self.grid.cells([1, 1]);
        cells
            .flat_map(|cell| {
                let [a, b, c, d] = cell.map(|[i, j]| stage.place(self.grid.at(i, j).point));
                [[a, b, c], [a, c, d]]
            })
            .collect()
    }

    /// The sides of the domain, and the isoparametric lines inside. Where a surface closes, its
    /// sides are lines like the others.
    fn lines(&self) -> (Vec<Vec<Vector>>, Vec<Vec<Vector>>) {
        let grid = &self.grid;
        let [m, n] = grid.steps;
        let inner = |count: usize| (1..count).filter(|own| own % grid.stride() == 0);
        let along = |count: usize, line: &dyn Fn(usize) -> Vec<Vector>| {
            let (start, end) = (line(0), line(count));
            let between: Vec<Vec<Vector>> = inner(count).map(line).collect();
            (start, end, between)
        };
        let (mut edges, mut lines) = (Vec::new(), Vec::new());
        for (start, end, between) in [
            along(m, &|own| grid.line_u(own)),
            along(n, &|own| grid.line_v(own)),
        ] {
            lines.extend(between);
            if is_same(&start, &end) {
                lines.push(start);
            } else {
                edges.extend([start, end]);
            }
        }
        (edges, lines)
    }
}

/// Whether two lines coincide to the eye.
fn is_same(one: &[Vector], other: &[Vector]) -> bool {
    let (low, high) = bounds(one);
    let size = dot(minus(high, low), minus(high, low));
    one.iter().zip(other).all(|(left, right)| {
        let gap = minus(*left, *right);
        dot(gap, gap) <= 1e-18 * size
    })
}

/// The control points of a net in doubles; none where one is at infinity or far away.
struct ControlPoints {
    points: Vec<Option<Vector>>,
    columns: usize,
}

impl ControlPoints {
    fn of(net: &ControlNet, beside: &[Vector]) -> Self {
        let (low, high) = bounds(beside);
        let size = [0, 1, 2].map(|axis| high[axis] - low[axis]);
        let reach = REACH * size.into_iter().fold(0.0, f64::max);
        let is_near = |own: &Vector| {
            [0, 1, 2]
                .into_iter()
                .all(|axis| own[axis] >= low[axis] - reach && own[axis] <= high[axis] + reach)
        };
        let point = |(weight, exact): (&Real, &[Real; 3])| {
            let [x, y, z] = exact.each_ref().map(Double::nearest);
            let point = [x?.value(), y?.value(), z?.value()];
            (!weight.is_zero() && is_near(&point)).then_some(point)
        };
        Self {
            points: net.weights().iter().zip(net.points()).map(point).collect(),
            columns: net.columns(),
        }
    }

    /// The sides of the control polygons, in pieces.
    fn sides(&self) -> Vec<Vec<Vector>> {
        let mut sides = Vec::new();
        for (index, own) in self.points.iter().enumerate() {
            let right = (index + 1) % self.columns != 0;
            let next = [right.then_some(index + 1), Some(index + self.columns)];
            for other in next.into_iter().flatten() {
                let pair = own.zip(self.points.get(other).copied().flatten());
                sides.extend(pair.map(|(from, to)| {
                    let ratio = |piece| f64::from(piece) / f64::from(PIECES);
                    (0..=PIECES)
                        .map(|own| between(from, to, ratio(own)))
                        .collect()
                }));
            }
        }
        sides
    }
}

/// Draws lines among what hides them.
struct Artist {
    stage: Stage,
    occluder: Occluder,
}

impl Artist {
    fn new(stage: Stage, bodies: &[Body<'_>]) -> Self {
        let triangles = bodies.iter().flat_map(|own| own.triangles(&stage));
        Self {
            occluder: Occluder::new(triangles.collect()),
            stage,
        }
    }

    fn shades(&self, body: &Body<'_>) -> Shades {
        Shades::of(&body.grid, &self.stage, &self.occluder)
    }

    fn placed(&self, line: &[Vector]) -> Vec<Vector> {
        line.iter().map(|own| self.stage.place(*own)).collect()
    }

    fn stroke(&self, line: &[Vector]) -> Stroke {
        Stroke::of(&self.placed(line), &self.occluder)
    }

    /// The contours of a surface, looked for a little outside of it: on a contour itself the
    /// triangles beside it decide nothing.
    fn contours(&self, body: &Body<'_>) -> Vec<Stroke> {
        let chains = Contours::of(&body.surface, &body.grid, self.stage.toward());
        let strokes = chains.iter().map(|chain| {
            let points: Vec<Vector> = chain.iter().map(|own| own.point).collect();
            let shifts: Vec<Vector> = chain.iter().map(|own| self.aside(body, own)).collect();
            Stroke::beside(&self.placed(&points), &shifts, &self.occluder)
        });
        strokes.collect()
    }

    /// A step in the picture from a contour point away from the surface.
    ///
    /// The direction to the viewer is a R_u + b R_v there; along it the surface leaves the line of
    /// sight on its own side only.
    fn aside(&self, body: &Body<'_>, sample: &Sample) -> Vector {
        let [right, up] = sample.tangents;
        let toward = self.stage.toward();
        let (e, f, g) = (dot(right, right), dot(right, up), dot(up, up));
        let (first, second) = (dot(right, toward), dot(up, toward));
        let determinant = e * g - f * f;
        let step = 6.0 / self.stage.scale();
        let rates = [
            (g * first - f * second) / determinant * step,
            (e * second - f * first) / determinant * step,
        ];
        let here = self.stage.place(sample.point);
        let offset = |sign: f64| {
            let point = body
                .surface
                .beside(sample.place, [sign * rates[0], sign * rates[1]]);
            let there = self.stage.place(point);
            [there[0] - here[0], there[1] - here[1]]
        };
        let (one, other) = (offset(1.0), offset(-1.0));
        let inward = [one[0] + other[0], one[1] + other[1]];
        let length = (inward[0] * inward[0] + inward[1] * inward[1]).sqrt();
        if length > 0.0 && length.is_finite() {
            [
                -ASIDE * inward[0] / length,
                -ASIDE * inward[1] / length,
                0.0,
            ]
        } else {
            Vector::default()
        }
    }

    /// Curves, each with its name beside an end or its middle: as far out as the names before it
    /// leave room.
    fn curves(&self, guides: &[Guide], lines: &[Vec<Vector>]) -> Vec<CurveFigure> {
        let mut curves: Vec<CurveFigure> = Vec::new();
        for (guide, points) in guides.iter().zip(lines) {
            let line = self.placed(points);
            let middle = line.get(line.len() / 2);
            let ends = [line.first(), line.last(), middle].into_iter().flatten();
            let letters = u32::try_from(guide.name.chars().count() + 3).unwrap_or_default();
            let half = (3.6 * f64::from(letters)).min(WIDTH / 2.0);
            let mut places: Vec<(f64, [f64; 2])> = ends.map(|own| self.label(*own, half)).collect();
            places.sort_by(|one, other| other.0.total_cmp(&one.0));
            let is_free = |(_, own): &&(f64, [f64; 2])| {
                let apart =
                    |axis: usize, other: &CurveFigure| (own[axis] - other.label[axis]).abs();
                let far =
                    |other: &CurveFigure| apart(0, other) > 2.0 * half || apart(1, other) > 18.0;
                curves.iter().all(far)
            };
            let place = places.iter().find(is_free).or(places.first());
            curves.push(CurveFigure {
                name: guide.name.clone(),
                is_profile: guide.is_profile,
                stroke: Stroke::of(&line, &self.occluder),
                label: place.map_or([0.0; 2], |(_, own)| *own),
            });
        }
        curves
    }

    /// How far out a point is, and where a name of some width stands beside it.
    fn label(&self, point: Vector, half: f64) -> (f64, [f64; 2]) {
        let middle = self.stage.middle();
        let out = [0, 1].map(|axis| point[axis] - middle[axis]);
        let distance = (out[0] * out[0] + out[1] * out[1]).sqrt();
        let step = |axis: usize| {
            if distance > 0.0 {
                14.0 * out[axis] / distance
            } else {
                0.0
            }
        };
        let x = (point[0] + step(0)).clamp(half, WIDTH - half);
        (distance, [x, point[1] + step(1) + 4.0])
    }
}

fn points(guide: &Guide) -> Vec<Vector> {
    let points = guide.points(CHORDS).into_iter();
    points.map(|own| own.map(Double::value)).collect()
}

/// The least and the greatest coordinates.
fn bounds(points: &[Vector]) -> (Vector, Vector) {
    let finite = || {
        points
            .iter()
            .filter(|own| own.iter().all(|own| own.is_finite()))
    };
    let least = |axis: usize| finite().map(|own| own[axis]).fold(f64::INFINITY, f64::min);
    let greatest = |axis: usize| {
        finite()
            .map(|own| own[axis])
            .fold(f64::NEG_INFINITY, f64::max)
    };
    ([0, 1, 2].map(least), [0, 1, 2].map(greatest))
}
