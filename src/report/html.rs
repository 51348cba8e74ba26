use super::Report;
use super::report::{Decision, SurfaceReport};
use super::text::{curve_facts, degree_rows, facts};

/// The report of the surfaces and curves of some names as a piece of HTML: a section with a table
/// of degrees and a list of facts for each surface, a list of facts for each curve.
#[must_use]
pub fn render_html(report: &Report, names: &[&str]) -> String {
    let wanted = |name: &str| names.contains(&name);
    let surfaces = report.surfaces.iter().filter(|own| wanted(&own.name));
    let surfaces = surfaces.map(|own| surface(own, report.unit.symbol()));
    let curves = report.curves.iter().filter(|own| wanted(&own.name));
    let curves = curves.map(|own| {
        let facts = curve_facts(own).into_iter();
        let facts = facts.map(|(label, value)| fact(label, &escape(&value)));
        format!(
            "<section>\n<h2><i>{}</i> <small>Pythagorean-hodograph curve</small></h2>\n<dl>\n{}</dl>\n</section>\n",
            escape(&own.name),
            facts.collect::<String>()
        )
    });
    surfaces.chain(curves).collect()
}

fn surface(surface: &SurfaceReport, unit: &str) -> String {
    let rows = degree_rows(surface).into_iter().map(|row| {
        let cells = row
            .cells
            .iter()
            .map(|own| format!("<td>{}</td>", escape(own)));
        format!(
            "<tr><th>{}</th>{}<td class=\"remark\">{}</td></tr>\n",
            row.label,
            cells.collect::<String>(),
            escape(&row.remark)
        )
    });
    let facts = facts(surface).into_iter();
    let facts = facts.map(|(label, value)| fact(label, &escape(&value)));
    let claims = surface.expectations.iter().map(|own| {
        let (class, mark) = match own.holds {
            Decision::Decided(true) => ("holds", "holds"),
            Decision::Decided(false) => ("fails", "fails"),
            Decision::Undecided(_) => ("undecided", "undecided"),
        };
        let text = own.text.split_whitespace().collect::<Vec<_>>().join(" ");
        format!(
            "<li class=\"{class}\"><code>{}</code> <em>{mark}</em></li>\n",
            escape(&text)
        )
    });
    let [u, v] = [&surface.domain.u, &surface.domain.v].map(|own| escape(&own.join(", ")));
    let claims = claims.collect::<String>();
    let claims = if claims.is_empty() {
        claims
    } else {
        format!("<ul>\n{claims}</ul>\n")
    };
    format!(
        "<section>\n<h2><i>{}</i> <small>u in [{u}], v in [{v}], lengths in {unit}</small></h2>\n\
         <table>\n<tr><td></td><th>W</th><th>X</th><th>Y</th><th>Z</th><td></td></tr>\n{}</table>\n\
         <dl>\n{}</dl>\n{claims}</section>\n",
        escape(&surface.name),
        rows.collect::<String>(),
        facts.collect::<String>()
    )
}

fn fact(label: &str, value: &str) -> String {
    format!("<dt>{label}</dt><dd>{value}</dd>\n")
}

/// Text that HTML takes as it is.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
