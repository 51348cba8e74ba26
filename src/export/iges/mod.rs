//! IGES 5.3: rational B-spline surfaces, one for each patch, on demand trimmed by their boundaries.

mod file;
mod geometry;
mod trimmed;

use crate::diag::Code;
use crate::net::{Model, Part};
use crate::number::{Real, Unit};

use super::boundary::with_clear_boundaries;
use super::refusal::{GREATEST_DEGREE, INFINITE_POWER, Readers};
use super::written::Written;
use super::{Context, Double, ExportFault, Exported, Exporter, Fidelity};
use file::{Entity, File, Parameter, Pointer, Status, ascii};

use Parameter::{Integer, Real as Number, Text};

pub(super) const EXPORTER: Exporter = Exporter {
    name: "iges",
    extension: "igs",
    summary: "IGES, rational B-spline surfaces",
    several: true,
    shows_report: false,
    write,
};

const READERS: Readers = Readers {
    greatest_degree: Some(GREATEST_DEGREE),
    infinite_power: Some(INFINITE_POWER),
};

/// - **errors** a degree above 25 or of 0 (E0305); no patches with positive weights, or weights
///   that differ by a factor above 10⁶ (E0304); a number beyond the last double, or numbers that
///   merge (E0306)
fn write(model: &Model, context: &Context) -> Result<Exported, ExportFault> {
    let ratio = READERS.check(model, context)?;
    let mut file = File::default();
    let mut written = Written::for_readers(&READERS);
    // A closed patch becomes periodic in some readers, which drop its last row.
    let clear = with_clear_boundaries(model)?;
    let bounded = clear.as_ref();
    match bounded.filter(|_| context.iges_trimmed) {
        Some(model) => trimmed::write(model, &mut written, &mut file)?,
        None => write_bare(bounded.unwrap_or(model), &mut written, &mut file)?,
    }
    let text = file.text("Swept surfaces as rational B-splines.", &global(context)?);
    let bare = clear.is_none().then(unbounded);
    let warnings = written.warnings.into_iter().chain(ratio).chain(bare);
    Ok(Exported {
        bytes: text.into_bytes(),
        fidelity: written.fidelity.unwrap_or(Fidelity::Exact),
        warnings: warnings.collect(),
    })
}

/// The surfaces alone; readers bound them by their domains.
fn write_bare(model: &Model, written: &mut Written, file: &mut File) -> Result<(), ExportFault> {
    for part in model.parts() {
        let patches = part.patches().unwrap_or_default();
        for net in written.round(patches.iter().map(|own| &own.net))? {
            let surface = geometry::surface(&net, label(part), Status::Independent);
            add_named(surface, part, file);
        }
    }
    Ok(())
}

/// Adds an entity with the name of a surface, as property 406 of form 15.
fn add_named(mut entity: Entity, part: &Part, file: &mut File) -> Pointer {
    let property = file.add(&Entity {
        kind: 406,
        form: 15,
        status: Status::Property,
        label: String::new(),
        parameters: vec![Integer(1), Text(part.name.clone())],
    });
    // No associativities, one property.
    entity
        .parameters
        .extend([Integer(0), Integer(1), Parameter::Pointer(property)]);
    file.add(&entity)
}

/// The first eight letters of a name.
fn label(part: &Part) -> String {
    ascii(&part.name).chars().take(8).collect()
}

/// The global section. Its time stamp is fixed, so that equal surfaces give equal files.
fn global(context: &Context) -> Result<Vec<Parameter>, ExportFault> {
    let number = |value: Real| {
        let fault = || ExportFault::new(Code::E0306, "a number is beyond the last double", "");
        Double::nearest(&value).map(Number).ok_or_else(fault)
    };
    let text = |value: &str| Text(value.to_owned());
    let program = concat!("sweepc ", env!("CARGO_PKG_VERSION"));
    let date = "19700101.000000";
    let (flag, unit) = match context.unit {
        Unit::Inch => (1, "INCH"),
        Unit::Millimetre => (2, "MM"),
        Unit::Metre => (6, "M"),
        Unit::Centimetre => (10, "CM"),
    };
    let resolution = Real::from(10).power(-7).unwrap_or_else(|| Real::from(1));
    Ok(vec![
        text(","),
        text(";"),
        text(context.name()),
        text(&format!("{}.igs", context.file_stem())),
        text(program),
        text(program),
        // Bits of an integer, greatest power and digits of single and of double precision.
        Integer(32),
        Integer(38),
        Integer(6),
        Integer(308),
        Integer(15),
        text(context.name()),
        number(Real::from(1))?,
        Integer(flag),
        text(unit),
        Integer(1),
        number(Real::from(0))?,
        text(date),
        number(resolution)?,
        number(Real::from(0))?,
        text("unknown"),
        text("unknown"),
        // Version 5.3, no drafting standard.
        Integer(11),
        Integer(0),
        text(date),
    ])
}

fn unbounded() -> ExportFault {
    ExportFault::new(
        Code::W1009,
        "sides or corners coincide or nearly do: the surface is written without edges",
        "some readers ignore such a surface; cut the domain into parts that do not close up, and export each",
    )
}
