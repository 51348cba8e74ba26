//! 3DM: an openNURBS archive of version 2, one surface object for each patch.

mod body;

use crate::diag::Code;
use crate::net::{Model, Part};
use crate::number::{Rational, Real, Unit};

use super::refusal::{Readers, check_premultiplied};
use super::{Context, Double, ExportFault, Exported, Exporter, Fidelity, PremultipliedNet};
use body::Body;

pub(super) const EXPORTER: Exporter = Exporter {
    name: "3dm",
    extension: "3dm",
    summary: "3DM, surfaces of an openNURBS archive",
    several: true,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: None,
    // openNURBS calls a surface invalid that has one of these.
    infinite_power: Some(307),
};

/// The first 32 bytes: the name of the format and the version of the archive.
const SIGNATURE: &[u8; 32] = b"3D Geometry File Format        2";
/// A version of the toolkit that archives of version 2 may name: a date, and a 2.
const TOOLKIT: u32 = 200_501_012;

/// The types of chunks.
mod chunk {
    pub(super) const COMMENT: u32 = 0x0000_0001;
    pub(super) const END_OF_FILE: u32 = 0x0000_7FFF;
    pub(super) const END_OF_TABLE: u32 = 0xFFFF_FFFF;
    pub(super) const PROPERTIES: u32 = 0x1000_0014;
    pub(super) const TOOLKIT_VERSION: u32 = 0xA000_0026;
    pub(super) const SETTINGS: u32 = 0x1000_0015;
    pub(super) const UNITS: u32 = 0x2000_8031;
    pub(super) const OBJECTS: u32 = 0x1000_0013;
    pub(super) const OBJECT: u32 = 0x2000_8070;
    pub(super) const OBJECT_TYPE: u32 = 0x8200_0071;
    pub(super) const OBJECT_ATTRIBUTES: u32 = 0x0200_8072;
    pub(super) const OBJECT_END: u32 = 0x8200_007F;
    pub(super) const CLASS: u32 = 0x0002_7FFA;
    pub(super) const CLASS_NAME: u32 = 0x0002_FFFB;
    pub(super) const CLASS_DATA: u32 = 0x0002_FFFC;
    pub(super) const CLASS_END: u32 = 0x8002_7FFF;
}

/// The class of surfaces, 4ED7D4DE-E947-11D3-BFE5-0010830122F0.
const SURFACE: [u8; 16] = [
    0xDE, 0xD4, 0xD7, 0x4E, 0x47, 0xE9, 0xD3, 0x11, 0xBF, 0xE5, 0x00, 0x10, 0x83, 0x01, 0x22, 0xF0,
];
/// The type of surface objects.
const SURFACE_TYPE: u32 = 8;
/// Version 1.0 of a record.
const FIRST_VERSION: u8 = 0x10;

/// - **errors** a degree of 0 (E0305); no patches with positive weights, or weights that differ by
///   a factor above 10⁶ (E0304); a number beyond the last double, or numbers that merge (E0306)
fn write(model: &Model, context: &Context) -> Result<Exported, ExportFault> {
    let ratio = READERS.check(model, context)?;
    let (mut fidelity, mut warnings) = (Fidelity::Exact, Vec::new());
    let constants = Constants::new()?;
    let mut objects = Body::default();
    for part in model.parts() {
        for patch in part.patches().unwrap_or_default() {
            let rounded = PremultipliedNet::new(&patch.net)?;
            check_premultiplied(&patch.net, &rounded)?;
            READERS.check_sizes(rounded.points.iter().flatten().flatten())?;
            objects.chunk(chunk::OBJECT, object(part, &rounded, &constants));
            fidelity = fidelity.worse(rounded.fidelity(&patch.net));
            warnings.extend(rounded.warnings);
        }
    }
    objects.short(chunk::END_OF_TABLE, 0);
    let mut file = Body::default();
    file.bytes(SIGNATURE);
    file.chunk(chunk::COMMENT, comment());
    file.chunk(chunk::PROPERTIES, properties());
    file.chunk(chunk::SETTINGS, settings(context.unit, &constants));
    file.chunk(chunk::OBJECTS, objects);
    let mut end = Body::default();
    // The length of the file, these twelve bytes included.
    end.count(file.length() + 12);
    file.chunk(chunk::END_OF_FILE, end);
    Ok(Exported {
        bytes: file.into_bytes(),
        fidelity,
        warnings: warnings.into_iter().chain(ratio).collect(),
    })
}

/// Doubles that every file has.
struct Constants {
    zero: Double,
    one: Double,
    minus_one: Double,
    /// 10⁻³, for lengths.
    tolerance: Double,
    /// A sixtieth, for angles.
    angle: Double,
}

impl Constants {
    /// - **errors** none in fact: all are doubles
    fn new() -> Result<Self, ExportFault> {
        let number = |numerator: i64, denominator: i64| {
            let exact = Real::from(Rational::new(numerator.into(), denominator.into()));
            let fault = || ExportFault::new(Code::E0306, "a number is beyond the last double", "");
            Double::nearest(&exact).ok_or_else(fault)
        };
        Ok(Self {
            zero: number(0, 1)?,
            one: number(1, 1)?,
            minus_one: number(-1, 1)?,
            tolerance: number(1, 1_000)?,
            angle: number(1, 60)?,
        })
    }
}

/// What a person reads who prints the file; it ends there.
fn comment() -> Body {
    let mut body = Body::default();
    let program = concat!("sweepc ", env!("CARGO_PKG_VERSION"), "\n\x1A\0");
    body.bytes(program.as_bytes());
    body
}

fn properties() -> Body {
    let mut body = Body::default();
    body.short(chunk::TOOLKIT_VERSION, TOOLKIT);
    body.short(chunk::END_OF_TABLE, 0);
    body
}

/// The unit of length, with tolerances for the user's own work.
fn settings(unit: Unit, constants: &Constants) -> Body {
    let mut units = Body::default();
    units.integer(100);
    units.integer(match unit {
        Unit::Millimetre => 2,
        Unit::Centimetre => 3,
        Unit::Metre => 4,
        Unit::Inch => 8,
    });
    for own in [constants.tolerance, constants.angle, constants.tolerance] {
        units.double(own);
    }
    let mut body = Body::default();
    body.chunk(chunk::UNITS, units);
    body.short(chunk::END_OF_TABLE, 0);
    body
}

/// A surface object with its name.
fn object(part: &Part, net: &PremultipliedNet, constants: &Constants) -> Body {
    let (mut name, mut class) = (Body::default(), Body::default());
    name.bytes(&SURFACE);
    class.chunk(chunk::CLASS_NAME, name);
    class.chunk(chunk::CLASS_DATA, surface(net, constants));
    class.short(chunk::CLASS_END, 0);
    let mut body = Body::default();
    body.short(chunk::OBJECT_TYPE, SURFACE_TYPE);
    body.chunk(chunk::CLASS, class);
    body.chunk(chunk::OBJECT_ATTRIBUTES, attributes(&part.name, constants));
    body.short(chunk::OBJECT_END, 0);
    body
}

/// Dimension, kind, orders, counts, an empty box, knots without the first and the last, points.
fn surface(net: &PremultipliedNet, constants: &Constants) -> Body {
    let Constants {
        zero,
        one,
        minus_one,
        ..
    } = *constants;
    let rational = net.points.iter().flatten().any(|own| own[3] != one);
    let (rows, columns) = (net.points.len(), net.points.first().map_or(0, Vec::len));
    let mut body = Body::default();
    body.bytes(&[FIRST_VERSION]);
    body.count(3);
    body.integer(u32::from(rational));
    body.count(net.knots_u.len() - rows);
    body.count(net.knots_v.len() - columns);
    body.count(rows);
    body.count(columns);
    // Reserved.
    body.integer(0);
    body.integer(0);
    for own in [one, zero, zero, minus_one, zero, zero] {
        body.double(own);
    }
    for knots in [&net.knots_u, &net.knots_v] {
        let inner = &knots[1..knots.len() - 1];
        body.count(inner.len());
        inner.iter().for_each(|own| body.double(*own));
    }
    body.count(rows * columns);
    let coordinates = if rational { 4 } else { 3 };
    for point in net.points.iter().flatten() {
        point[..coordinates]
            .iter()
            .for_each(|own| body.double(*own));
    }
    body
}

/// Name and layer; everything else is left to the program that reads it.
fn attributes(name: &str, constants: &Constants) -> Body {
    let mut body = Body::default();
    body.bytes(&[FIRST_VERSION]);
    // No identifier: the reader gives one.
    body.bytes(&[0; 16]);
    // The first layer, no material, black.
    body.integer(0);
    body.integer(u32::MAX);
    body.integer(0);
    // A style of lines that nobody reads.
    body.bytes(&[0; 4]);
    body.double(constants.zero);
    body.double(constants.one);
    body.integer(1);
    // Normal mode; colour, line and material are those of the layer.
    body.bytes(&[0; 4]);
    body.text(name);
    body.text("");
    body
}
