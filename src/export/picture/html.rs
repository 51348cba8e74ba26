//! A page that opens without a network: the viewer, the exact nets that it reads, and the report.

use serde_json::json;

use crate::export::json::net_text;
use crate::export::{
    Context, Double, ExportFault, Exported, Exporter, Fidelity, Guide, RoundedNet,
};
use crate::net::{Model, Part};
use crate::number::Real;
use crate::report::render_html;

use super::figure::Figure;

pub(in crate::export) const EXPORTER: Exporter = Exporter {
    name: "html",
    extension: "html",
    summary: "a page to turn and to read exact coordinates from",
    several: true,
    shows_report: true,
    write,
};

/// The page with a place for each part, such as `<!-- report -->`.
const PAGE: &str = include_str!("viewer/page.html");
const STYLE: &str = include_str!("viewer/page.css");
/// The viewer with the libraries that it uses, made by `npm run build`.
const VIEWER: &str = include_str!("viewer/viewer.min.js");
/// Chords of a curve.
const CHORDS: u16 = 128;

/// - **errors** a number beyond the last double (E0306)
fn write(model: &Model, context: &Context<'_>) -> Result<Exported, ExportFault> {
    let nets = model.parts().iter().map(|own| {
        let rounded = RoundedNet::new(&own.net)?;
        Ok(net_text(&own.name, &own.net, &rounded)
            .trim_end()
            .to_owned())
    });
    let nets: Vec<String> = nets.collect::<Result<_, ExportFault>>()?;
    let curves = context.guides.iter().map(curve).collect::<Vec<_>>();
    let angles = [context.view.azimuth(), context.view.elevation()];
    let angles = angles.map(|own| double(Double::nearest(&Real::from(own.clone()))));
    let fronts = Figure::of(model, context)?.fronts;
    let data = format!(
        "{{\"view\": [{}],\n\"fronts\": {},\n\"curves\": [{}],\n\"nets\": [\n{}\n]}}",
        angles.join(", "),
        json!(fronts),
        curves.join(",\n"),
        nets.join(",\n")
    );
    let parts: [(&str, &str); 6] = [
        ("title", &escaped(&context.file_stem())),
        ("style", STYLE),
        ("heading", &heading(model, context)),
        ("report", &report(model, context)),
        // A page takes `</script>` for the end, wherever it stands; in JSON it has another form.
        ("model", &data.replace('<', "\\u003c")),
        ("viewer", VIEWER.trim_end()),
    ];
    Ok(Exported {
        bytes: filled(PAGE, &parts).into_bytes(),
        fidelity: Fidelity::Drawn,
        warnings: Vec::new(),
    })
}

/// A text with what belongs to `<!-- name -->` in its places.
fn filled(text: &str, parts: &[(&str, &str)]) -> String {
    let mut pieces = text.split("<!-- ");
    let mut page = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (name, rest) = piece.split_once(" -->").unwrap_or((piece, ""));
        let part = parts.iter().find(|(own, _)| *own == name);
        page.push_str(part.map_or("", |(_, own)| own));
        page.push_str(rest);
    }
    page
}

/// A profile or a sweep curve as JSON, by the doubles of its points.
fn curve(guide: &Guide) -> String {
    let points = guide.points(CHORDS).into_iter().map(|point| {
        let [x, y, z] = point.map(Double::json);
        format!("[{x}, {y}, {z}]")
    });
    format!(
        "{{\"name\": {}, \"profile\": {}, \"points\": [{}]}}",
        json!(guide.name),
        guide.is_profile,
        points.collect::<Vec<_>>().join(", ")
    )
}

fn double(own: Option<Double>) -> String {
    own.map_or_else(|| "0.0".to_owned(), Double::json)
}

/// The name of the page and the bidegrees of its surfaces.
fn heading(model: &Model, context: &Context<'_>) -> String {
    let degree = |own: &Part| {
        let degree = own.net.degree();
        format!(
            "<i>{}</i>, bidegree ({}, {})",
            escaped(&own.name),
            degree.u,
            degree.v
        )
    };
    let degrees: Vec<String> = model.parts().iter().map(degree).collect();
    format!(
        "<h1>{}</h1>\n<p>{}</p>",
        escaped(context.stem),
        degrees.join("<br>")
    )
}

/// The degree report of the surfaces and curves on the page.
fn report(model: &Model, context: &Context<'_>) -> String {
    let surfaces = model.parts().iter().map(|own| own.name.as_str());
    let curves = context.guides.iter().map(|own| own.name.as_str());
    let names: Vec<&str> = surfaces.chain(curves).collect();
    let report = context.report.as_ref();
    report.map_or_else(String::new, |own| render_html(own, &names))
}

/// A text as HTML takes it.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
