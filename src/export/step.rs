//! STEP AP214 (ISO 10303-21, 10303-214): one B-spline face in an open shell.

use crate::diag::Code;
use crate::net::{ControlNet, Knots};
use crate::number::{Field, Real};

use super::entities::{Entities, Id, list, string};
use super::{Context, Double, ExportFault, Exported, Exporter, RoundedNet, Unit};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "step",
    extension: "step",
    summary: "STEP AP214, one B-spline face",
    write,
};

/// The greatest degree that the common kernels read.
const GREATEST_DEGREE: usize = 25;
/// The quotient of the greatest weight by the least that is worth a warning.
const LARGE_WEIGHT_RATIO: i64 = 1_000;

/// - **errors** a degree above 25 or of 0 (E0305); a weight that is not positive, or weights that
///   differ by a factor above 10⁶ (E0304); a number beyond the last double, or knots that merge
///   (E0306)
fn write(net: &ControlNet, context: &Context) -> Result<Exported, ExportFault> {
    check_degrees(net)?;
    let ratio = check_weights(net, context)?;
    let rounded = RoundedNet::new(net)?;
    check_doubles(net, &rounded)?;
    let mut entities = Entities::default();
    let shell = Face::new(net, &rounded, &mut entities).write(context.surface);
    write_product(shell, context, &mut entities);
    let text = format!(
        "ISO-10303-21;\n{}DATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
        header(context),
        entities.text()
    );
    let fidelity = rounded.fidelity(net);
    let warnings = rounded.warnings.into_iter().chain(ratio);
    Ok(Exported {
        bytes: text.into_bytes(),
        fidelity,
        warnings: warnings.collect(),
    })
}

fn check_degrees(net: &ControlNet) -> Result<(), ExportFault> {
    let degree = net.degree();
    for (along, own) in [("u", degree.u), ("v", degree.v)] {
        let help = match own {
            0 => "a surface must move in both directions; the `json` file carries this net",
            1..=GREATEST_DEGREE => continue,
            _ => {
                "readers of STEP drop it without a word; use a profile or curve of lower degree, or the `json` file, which carries any degree"
            }
        };
        let message = format!("degree {own} along {along}: STEP carries 1 to {GREATEST_DEGREE}");
        return Err(ExportFault::new(Code::E0305, message, help));
    }
    Ok(())
}

/// Refuses weights that readers cannot take; a warning where they may lose accuracy.
fn check_weights(net: &ControlNet, context: &Context) -> Result<Option<ExportFault>, ExportFault> {
    let (least, greatest) = (net.min_weight(), net.max_weight());
    let fault = |code, message: String, help| ExportFault::new(code, message, help);
    if !net.all_positive() {
        let message =
            format!("a control point has weight {least}; STEP carries positive weights only");
        let help = "restrict the surface to a smaller domain, or write the `json` file, which carries any weights";
        return Err(fault(Code::E0304, message, help));
    }
    let above = |ratio: i64| *greatest > least.times(&Real::from(ratio));
    if above(Context::GREATEST_WEIGHT_RATIO) && !context.any_weight_ratio {
        let message = format!("the weights run from {least} to {greatest}, a factor above 10^6");
        let help = "readers of STEP lose accuracy with such weights: restrict the surface to a smaller domain, or allow any ratio of weights";
        return Err(fault(Code::E0304, message, help));
    }
    Ok(above(LARGE_WEIGHT_RATIO).then(|| {
        let message = format!("the weights run from {least} to {greatest}, a factor above 10^3");
        let help = "readers of STEP may lose accuracy: restrict the surface to a smaller domain";
        fault(Code::W1006, message, help)
    }))
}

/// Refuses weights that round to 0 and different knots that round to the same double.
fn check_doubles(net: &ControlNet, rounded: &RoundedNet) -> Result<(), ExportFault> {
    let merged = |knots: &Knots, doubles: &[Double]| {
        let pairs = knots.values().windows(2).zip(doubles.windows(2));
        let mut pairs =
            pairs.filter(|(exact, double)| exact[0] != exact[1] && double[0] == double[1]);
        pairs.next().map(|(exact, _)| {
            format!(
                "the knots {} and {} are the same double",
                exact[0], exact[1]
            )
        })
    };
    let zero = rounded.weights.iter().flatten().any(|own| own.is_zero());
    let zero = zero.then(|| "a positive weight becomes 0 as a double".to_owned());
    let fault = zero
        .or_else(|| merged(net.knots_u(), &rounded.knots_u))
        .or_else(|| merged(net.knots_v(), &rounded.knots_v));
    let help = "choose a domain whose ends differ more; the `json` file carries the exact numbers";
    fault.map_or(Ok(()), |message| {
        Err(ExportFault::new(Code::E0306, message, help))
    })
}

/// One side of the patch, in the direction of the rising parameter.
struct Side {
    points: Vec<Id>,
    doubles: Vec<[Double; 3]>,
    exact_weights: Vec<Real>,
    weights: Vec<Double>,
}

impl Side {
    /// Whether it is a point: the patch has a pole there and no edge.
    fn is_point(&self) -> bool {
        self.doubles.iter().all(|own| *own == self.doubles[0])
    }

    /// Whether both are the same curve with the same parameter: the patch closes there.
    fn meets(&self, other: &Self) -> bool {
        let [first, second] = [self, other].map(|own| &own.exact_weights[0]);
        let mut weights = self.exact_weights.iter().zip(&other.exact_weights);
        self.doubles == other.doubles
            && weights.all(|(left, right)| left.times(second) == right.times(first))
    }
}

/// The face under construction.
struct Face<'a> {
    net: &'a ControlNet,
    rounded: &'a RoundedNet,
    entities: &'a mut Entities,
    points: Vec<Vec<Id>>,
    vertices: Vec<([Double; 3], Id)>,
}

impl<'a> Face<'a> {
    /// Writes the control points.
    fn new(net: &'a ControlNet, rounded: &'a RoundedNet, entities: &'a mut Entities) -> Self {
        let point = |own: &[Double; 3], entities: &mut Entities| {
            let coordinates = list(own.iter().map(|own| own.step()));
            entities.add(&format!("CARTESIAN_POINT('',{coordinates})"))
        };
        let rows = rounded.points.iter();
        let points = rows
            .map(|row| row.iter().map(|own| point(own, entities)).collect())
            .collect();
        Self {
            net,
            rounded,
            entities,
            points,
            vertices: Vec::new(),
        }
    }

    /// Writes the face and its shell.
    fn write(mut self, name: &str) -> Id {
        let surface = self.surface();
        let bound = self.bound();
        let outer = self
            .entities
            .add(&format!("FACE_OUTER_BOUND('',{bound},.T.)"));
        let name = string(name);
        let face = self
            .entities
            .add(&format!("ADVANCED_FACE({name},({outer}),{surface},.T.)"));
        self.entities.add(&format!("OPEN_SHELL('',({face}))"))
    }

    /// The four sides: v at its start, u at its end, v at its end, u at its start. The first and
    /// second run with the boundary of the domain, the others against it.
    fn sides(&self) -> [Side; 4] {
        let (last_i, last_j) = (self.net.rows() - 1, self.net.columns() - 1);
        let along_u = |j| self.side((0..=last_i).map(|i| (i, j)).collect());
        let along_v = |i| self.side((0..=last_j).map(|j| (i, j)).collect());
        [along_u(0), along_v(last_i), along_u(last_j), along_v(0)]
    }

    fn side(&self, indices: Vec<(usize, usize)>) -> Side {
        let places = || indices.iter().copied();
        Side {
            points: places().map(|(i, j)| self.points[i][j]).collect(),
            doubles: places().map(|(i, j)| self.rounded.points[i][j]).collect(),
            exact_weights: places()
                .map(|(i, j)| self.net.weight(i, j).clone())
                .collect(),
            weights: places().map(|(i, j)| self.rounded.weights[i][j]).collect(),
        }
    }

    /// The boundary: an edge for each side that is not a point, one edge for two opposite sides
    /// that meet; a vertex where nothing else is left.
    fn bound(&mut self) -> Id {
        let sides = self.sides();
        let mut edges: [Option<Id>; 4] = [None; 4];
        for (index, side) in sides
            .iter()
            .enumerate()
            .filter(|(_, side)| !side.is_point())
        {
            edges[index] = match index.checked_sub(2) {
                Some(opposite) if sides[opposite].meets(side) => edges[opposite],
                _ => Some(self.edge(side, index % 2 == 0)),
            };
        }
        let senses = [".T.", ".T.", ".F.", ".F."];
        let oriented: Vec<_> = edges
            .iter()
            .zip(senses)
            .filter_map(|(edge, sense)| Some(format!("ORIENTED_EDGE('',*,*,{},{sense})", (*edge)?)))
            .collect();
        if oriented.is_empty() {
            let vertex = self.vertex(sides[0].doubles[0], sides[0].points[0]);
            return self.entities.add(&format!("VERTEX_LOOP('',{vertex})"));
        }
        let oriented: Vec<_> = oriented.iter().map(|own| self.entities.add(own)).collect();
        self.entities
            .add(&format!("EDGE_LOOP('',{})", list(oriented)))
    }

    /// The edge along a side, between the vertices at its ends.
    fn edge(&mut self, side: &Side, along_u: bool) -> Id {
        let last = side.points.len() - 1;
        let start = self.vertex(side.doubles[0], side.points[0]);
        let end = self.vertex(side.doubles[last], side.points[last]);
        let curve = self.curve(side, along_u);
        self.entities
            .add(&format!("EDGE_CURVE('',{start},{end},{curve},.T.)"))
    }

    /// The vertex at a point; points with the same doubles share it.
    fn vertex(&mut self, place: [Double; 3], point: Id) -> Id {
        if let Some((_, vertex)) = self.vertices.iter().find(|(known, _)| *known == place) {
            return *vertex;
        }
        let vertex = self.entities.add(&format!("VERTEX_POINT('',{point})"));
        self.vertices.push((place, vertex));
        vertex
    }

    fn curve(&mut self, side: &Side, along_u: bool) -> Id {
        let (knots, doubles) = if along_u {
            (self.net.knots_u(), &self.rounded.knots_u)
        } else {
            (self.net.knots_v(), &self.rounded.knots_v)
        };
        let closed = logical(side.doubles.first() == side.doubles.last());
        let spline = format!(
            "{},{},.UNSPECIFIED.,{closed},.U.",
            knots.degree(),
            list(&side.points)
        );
        let (multiplicities, values) = knot_lists(knots, doubles);
        let knots = format!("{multiplicities},{values},.UNSPECIFIED.");
        if side
            .exact_weights
            .iter()
            .all(|own| *own == side.exact_weights[0])
        {
            return self
                .entities
                .add(&format!("B_SPLINE_CURVE_WITH_KNOTS('',{spline},{knots})"));
        }
        let weights = list(side.weights.iter().map(|own| own.step()));
        self.entities.add_complex(&mut [
            "BOUNDED_CURVE()".to_owned(),
            format!("B_SPLINE_CURVE({spline})"),
            format!("B_SPLINE_CURVE_WITH_KNOTS({knots})"),
            "CURVE()".to_owned(),
            "GEOMETRIC_REPRESENTATION_ITEM()".to_owned(),
            format!("RATIONAL_B_SPLINE_CURVE({weights})"),
            "REPRESENTATION_ITEM('')".to_owned(),
        ])
    }

    fn surface(&mut self) -> Id {
        let [south, east, north, west] = self.sides();
        let (closed_u, closed_v) = (logical(west.meets(&east)), logical(south.meets(&north)));
        let degree = self.net.degree();
        let points = list(self.points.iter().map(list));
        let spline = format!(
            "{},{},{points},.UNSPECIFIED.,{closed_u},{closed_v},.U.",
            degree.u, degree.v
        );
        let u = knot_lists(self.net.knots_u(), &self.rounded.knots_u);
        let v = knot_lists(self.net.knots_v(), &self.rounded.knots_v);
        let knots = format!("{},{},{},{},.UNSPECIFIED.", u.0, v.0, u.1, v.1);
        if self.net.weights().iter().all(|own| *own == Real::one()) {
            return self
                .entities
                .add(&format!("B_SPLINE_SURFACE_WITH_KNOTS('',{spline},{knots})"));
        }
        let rows = self.rounded.weights.iter();
        let weights = list(rows.map(|row| list(row.iter().map(|own| own.step()))));
        self.entities.add_complex(&mut [
            "BOUNDED_SURFACE()".to_owned(),
            format!("B_SPLINE_SURFACE({spline})"),
            format!("B_SPLINE_SURFACE_WITH_KNOTS({knots})"),
            "GEOMETRIC_REPRESENTATION_ITEM()".to_owned(),
            format!("RATIONAL_B_SPLINE_SURFACE({weights})"),
            "REPRESENTATION_ITEM('')".to_owned(),
            "SURFACE()".to_owned(),
        ])
    }
}

/// The multiplicities and the different knots.
fn knot_lists(knots: &Knots, doubles: &[Double]) -> (String, String) {
    let runs = knots.multiplicities();
    let counts: Vec<_> = runs.iter().map(|(_, count)| *count).collect();
    let starts = counts.iter().scan(0, |next, count| {
        let start = *next;
        *next += count;
        Some(start)
    });
    let values = list(starts.map(|start| doubles[start].step()));
    (list(counts), values)
}

fn logical(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}

/// The header: its records are filled and the time stamp is fixed, so that equal surfaces give
/// equal files.
fn header(context: &Context) -> String {
    let file = string(&format!("{}-{}.step", context.stem, context.surface));
    let program = concat!("'sweepc ", env!("CARGO_PKG_VERSION"), "'");
    format!(
        "HEADER;\n\
         FILE_DESCRIPTION(('swept surface as a rational B-spline'),'2;1');\n\
         FILE_NAME({file},'1970-01-01T00:00:00',('unknown'),('unknown'),{program},{program},'none');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\n\
         ENDSEC;\n"
    )
}

/// The unit of length as an entity.
fn write_unit(unit: Unit, entities: &mut Entities) -> Id {
    let length = "LENGTH_UNIT()".to_owned();
    let mut metric = |prefix: &str| {
        let si = format!("SI_UNIT({prefix},.METRE.)");
        entities.add_complex(&mut [length.clone(), "NAMED_UNIT(*)".to_owned(), si])
    };
    match unit {
        Unit::Millimetre => metric(".MILLI."),
        Unit::Centimetre => metric(".CENTI."),
        Unit::Metre => metric("$"),
        Unit::Inch => {
            let base = metric(".MILLI.");
            let factor = entities.add(&format!(
                "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{base})"
            ));
            let dimensions = entities.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
            entities.add_complex(&mut [
                length.clone(),
                format!("NAMED_UNIT({dimensions})"),
                format!("CONVERSION_BASED_UNIT('INCH',{factor})"),
            ])
        }
    }
}

/// The units and the uncertainty in which the geometry is meant.
fn write_geometric_context(unit: Unit, entities: &mut Entities) -> Id {
    let length = write_unit(unit, entities);
    let mut si = |kind: &str, name: &str| {
        let parts = [
            format!("{kind}()"),
            "NAMED_UNIT(*)".to_owned(),
            format!("SI_UNIT($,.{name}.)"),
        ];
        entities.add_complex(&mut parts.clone())
    };
    let angle = si("PLANE_ANGLE_UNIT", "RADIAN");
    let solid = si("SOLID_ANGLE_UNIT", "STERADIAN");
    let uncertainty = entities.add(&format!(
        "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),{length},'distance_accuracy_value','points closer than this coincide')"
    ));
    entities.add_complex(&mut [
        "GEOMETRIC_REPRESENTATION_CONTEXT(3)".to_owned(),
        format!("GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({uncertainty}))"),
        format!("GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid}))"),
        "REPRESENTATION_CONTEXT('','3D')".to_owned(),
    ])
}

/// The product whose shape the shell is; without it readers find no shape.
fn write_product(shell: Id, context: &Context, entities: &mut Entities) {
    let name = string(context.surface);
    let model = entities.add(&format!("SHELL_BASED_SURFACE_MODEL({name},({shell}))"));
    let geometry = write_geometric_context(context.unit, entities);
    let shape = entities.add(&format!(
        "MANIFOLD_SURFACE_SHAPE_REPRESENTATION({name},({model}),{geometry})"
    ));
    let application = entities.add("APPLICATION_CONTEXT('automotive design')");
    entities.add(&format!(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})"
    ));
    let product_context = entities.add(&format!("PRODUCT_CONTEXT('',{application},'mechanical')"));
    let product = entities.add(&format!("PRODUCT({name},{name},'',({product_context}))"));
    entities.add(&format!(
        "PRODUCT_RELATED_PRODUCT_CATEGORY('part','',({product}))"
    ));
    let formation = entities.add(&format!("PRODUCT_DEFINITION_FORMATION('','',{product})"));
    let stage = entities.add(&format!(
        "PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')"
    ));
    let definition = entities.add(&format!("PRODUCT_DEFINITION('','',{formation},{stage})"));
    let property = entities.add(&format!("PRODUCT_DEFINITION_SHAPE('','',{definition})"));
    entities.add(&format!(
        "SHAPE_DEFINITION_REPRESENTATION({property},{shape})"
    ));
}
