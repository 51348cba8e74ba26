use super::Report;
use super::report::{Decision, SurfaceReport};
use super::text::{curve_facts, degree_rows, facts};

/// The report as Markdown: a section with two tables for each surface.
#[must_use]
pub fn render_markdown(report: &Report) -> String {
    let mut text = format!("# {}\n", escape(&report.file));
    for own in &report.surfaces {
        text.push_str(&surface(own, report.unit.symbol()));
    }
    for own in &report.curves {
        text.push_str(&format!("\n## {}\n\n| | |\n|---|---|\n", escape(&own.name)));
        for (label, value) in curve_facts(own) {
            text.push_str(&format!("| {label} | {} |\n", escape(&value)));
        }
    }
    text
}

fn surface(surface: &SurfaceReport, unit: &str) -> String {
    let mut text = format!(
        "\n## {}\n\nu in [{}], v in [{}], lengths in {unit}\n\n| | W | X | Y | Z | |\n|---|---|---|---|---|---|\n",
        escape(&surface.name),
        surface.domain.u.join(", "),
        surface.domain.v.join(", ")
    );
    for row in degree_rows(surface) {
        text.push_str(&format!(
            "| {} | {} | {} |\n",
            row.label,
            row.cells.join(" | "),
            row.remark
        ));
    }
    text.push_str("\n| | |\n|---|---|\n");
    for (label, value) in facts(surface) {
        text.push_str(&format!("| {label} | {} |\n", escape(&value)));
    }
    for own in &surface.expectations {
        let mark = match own.holds {
            Decision::Decided(true) => "holds",
            Decision::Decided(false) => "**fails**",
            Decision::Undecided(_) => "**undecided**",
        };
        text.push_str(&format!(
            "| expect `{}` | {mark} |\n",
            own.text.replace('|', "\\|")
        ));
    }
    text
}

/// Text that Markdown takes as it is.
fn escape(text: &str) -> String {
    text.chars().fold(String::new(), |mut escaped, own| {
        if "\\`*_|<>#".contains(own) {
            escaped.push('\\');
        }
        escaped.push(own);
        escaped
    })
}
