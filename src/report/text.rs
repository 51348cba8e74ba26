use super::report::{Decision, SurfaceReport};
use super::{CurveReport, Report};
use crate::number::Unit;

/// The report for a terminal, one screen for each surface.
#[must_use]
pub fn render_text(report: &Report) -> String {
    let surfaces = report
        .surfaces
        .iter()
        .map(|own| surface(own, &report.file, report.unit));
    let curves = report.curves.iter().map(curve);
    surfaces.chain(curves).collect::<Vec<_>>().join("\n")
}

fn surface(surface: &SurfaceReport, file: &str, unit: Unit) -> String {
    let mut lines = Vec::new();
    let domain = format!(
        "u in [{}], v in [{}]",
        surface.domain.u.join(", "),
        surface.domain.v.join(", ")
    );
    lines.push(format!(
        "{}   {file}   {domain}   {}",
        surface.name,
        unit.symbol()
    ));
    lines.push(String::new());
    lines.push(row("", &["W", "X", "Y", "Z"].map(str::to_owned), ""));
    for degrees in degree_rows(surface) {
        lines.push(row(degrees.label, &degrees.cells, &degrees.remark));
    }
    lines.push(String::new());
    for (label, value) in facts(surface) {
        lines.push(entry(label, &value));
    }
    if !surface.expectations.is_empty() {
        lines.push(String::new());
        lines.extend(expectations(surface));
    }
    let mut text = lines
        .iter()
        .map(|line| line.trim_end())
        .collect::<Vec<_>>()
        .join("\n");
    text.push('\n');
    text
}

/// A row of the degree table.
pub(super) struct DegreeRow {
    pub(super) label: &'static str,
    pub(super) cells: [String; 4],
    pub(super) remark: String,
}

/// bound → constructed → reduced, with what cancelled and what was removed.
pub(super) fn degree_rows(surface: &SurfaceReport) -> [DegreeRow; 3] {
    let bound = surface.bound.list().map(|own| *own);
    let constructed = surface.as_constructed.list().map(|own| *own);
    let reduced = surface.homogeneous.list().map(|own| own.bidegree);
    let removed = surface.common_factor.bidegree.unwrap_or_default();
    let remark = if removed == [0, 0] {
        "nothing to remove".to_owned()
    } else {
        format!("common factor {} removed", degree(Some(removed)))
    };
    [
        DegreeRow {
            label: "bound",
            cells: bound.map(degree),
            remark: String::new(),
        },
        DegreeRow {
            label: "constructed",
            cells: constructed.map(degree),
            remark: cancelled(bound, constructed),
        },
        DegreeRow {
            label: "reduced",
            cells: reduced.map(degree),
            remark,
        },
    ]
}

fn cancelled(bound: [Option<[usize; 2]>; 4], constructed: [Option<[usize; 2]>; 4]) -> String {
    let losses: Vec<String> = ["W", "X", "Y", "Z"]
        .into_iter()
        .zip(bound.into_iter().zip(constructed))
        .filter_map(|(name, pair)| match pair {
            (Some(before), None) if before != [0, 0] => Some(format!("{name} vanishes")),
            (Some([u, v]), Some([a, b])) if (u, v) != (a, b) => Some(format!(
                "{name} loses {}",
                degree(Some([u.saturating_sub(a), v.saturating_sub(b)]))
            )),
            _ => None,
        })
        .collect();
    if losses.is_empty() {
        "nothing cancels".to_owned()
    } else {
        losses.join(", ")
    }
}

pub(super) fn degree(pair: Option<[usize; 2]>) -> String {
    pair.map_or_else(|| "0".to_owned(), |[u, v]| format!("({u}, {v})"))
}

/// The facts below the table, each with its label.
pub(super) fn facts(surface: &SurfaceReport) -> Vec<(&'static str, String)> {
    let remarks = &surface.remarks;
    let [rows, columns] = surface.patch.control_points;
    let patch = degree(Some(surface.patch.bidegree));
    let poles = match remarks.poles.as_slice() {
        [] => "none".to_owned(),
        places => places.join("; "),
    };
    let factor = format!(
        "{}   (the rest is {})",
        remarks.common_factor, remarks.coprimality
    );
    let regular = decision(surface.regular, remarks.regular.because());
    let offset = decision(surface.rational_offset, remarks.rational_offset.because());
    let field = remarks.field.iter().map(|own| ("field", own.clone()));
    let facts = [
        ("common factor", factor),
        ("lowest terms", lowest_terms(surface)),
        (
            "patch",
            format!("{patch}, {rows} × {columns} control points"),
        ),
        ("weights", weights(surface)),
        ("poles", poles),
        ("regular", regular),
        ("rational offset", offset),
        ("crosses itself", "not decided".to_owned()),
    ];
    field.chain(facts).collect()
}

/// What there is to say of a curve, each with its label.
pub(super) fn curve_facts(curve: &CurveReport) -> Vec<(&'static str, String)> {
    let mut facts = Vec::new();
    let length = match &curve.arc_length {
        None => "not a rational function".to_owned(),
        Some(length) if length.readable == length.decimal => length.decimal.clone(),
        Some(length) => format!("{} ≈ {}", length.readable, length.decimal),
    };
    facts.push(("arc length", length));
    let generators = curve
        .arc_length
        .iter()
        .filter_map(|own| own.generators.clone());
    facts.extend(generators.map(|own| ("with", own)));
    if let Some(own) = &curve.ph_hermite {
        let energy = own.bending_energy.as_deref().unwrap_or("infinite");
        facts.push(("branch", format!("{} ({})", own.branch, own.choice)));
        let rotation = format!("{} (absolute: ∫|κ| ds / 2π)", own.rotation_index);
        facts.push(("rotation index", rotation));
        facts.push(("bending energy", energy.to_owned()));
    }
    facts
}

/// The part of a report that is about a curve.
fn curve(curve: &CurveReport) -> String {
    let heading = format!("{}   Pythagorean-hodograph curve\n", curve.name);
    let facts = curve_facts(curve).into_iter();
    facts.fold(heading, |text, (label, value)| {
        text + &entry(label, &value) + "\n"
    })
}

fn lowest_terms(surface: &SurfaceReport) -> String {
    let affine = &surface.affine;
    let coordinates = [("x", &affine.x), ("y", &affine.y), ("z", &affine.z)];
    let terms = coordinates.map(|(name, own)| {
        let (top, bottom) = (degree(own.numerator), degree(Some(own.denominator)));
        format!("{name} {top}/{bottom}")
    });
    terms.join("   ")
}

fn weights(surface: &SurfaceReport) -> String {
    let sign = if surface.weights.positive {
        "positive"
    } else {
        "not all positive"
    };
    match (&surface.remarks.weights, &surface.remarks.positivity) {
        (Some((min, max)), _) if min == max => format!("all {min}"),
        (Some((min, max)), Some(positivity)) => {
            format!("{positivity}; in the one patch of the net from {min} to {max}")
        }
        (Some((min, max)), None) => format!("{sign}, from {min} to {max}"),
        (None, _) => "the first weight is 0".to_owned(),
    }
}

pub(super) fn decision(decision: Decision, because: &str) -> String {
    match decision {
        Decision::Decided(true) => format!("yes: {because}"),
        Decision::Decided(false) => format!("no: {because}"),
        Decision::Undecided(_) => format!("undecided: {because}"),
    }
}

fn expectations(surface: &SurfaceReport) -> Vec<String> {
    let width = surface
        .expectations
        .iter()
        .map(|own| own.text.chars().count())
        .max();
    let width = width.unwrap_or(0).min(60);
    surface
        .expectations
        .iter()
        .map(|own| {
            let (mark, because) = match own.holds {
                Decision::Decided(true) => ("holds    ", String::new()),
                Decision::Decided(false) => ("fails    ", format!("   {}", own.because)),
                Decision::Undecided(_) => ("undecided", format!("   {}", own.because)),
            };
            let text = own.text.split_whitespace().collect::<Vec<_>>().join(" ");
            format!("  {mark}  {text:<width$}  line {}{because}", own.line)
        })
        .collect()
}

fn row(label: &str, cells: &[String; 4], remark: &str) -> String {
    let [w, x, y, z] = cells;
    format!("  {label:<16}{w:<10}{x:<10}{y:<10}{z:<10}{remark}")
}

fn entry(label: &str, value: &str) -> String {
    format!("  {label:<16}{value}")
}
