//! A drawing as SVG: isoparametric lines, control net, profile and sweep curve, without what the
//! surfaces hide.
#![allow(
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "a picture is drawn in doubles"
)]

use crate::export::{Context, ExportFault, Exported, Exporter, Fidelity};
use crate::net::Model;

use super::figure::{CurveFigure, Figure};
use super::shade::{Shade, Shades, TONES};
use super::stage::WIDTH;
use super::stroke::{Polyline, Stroke};

pub(in crate::export) const EXPORTER: Exporter = Exporter {
    name: "svg",
    extension: "svg",
    summary: "a drawing with hidden lines removed",
    several: true,
    shows_report: false,
    write,
};

/// Dark and light of the side that most of a surface shows, and of the other.
const FRONT: [[u8; 3]; 2] = [[0x8f, 0xa9, 0xc2], [0xf6, 0xf9, 0xfc]];
const BACK: [[u8; 3]; 2] = [[0xc0, 0xad, 0x8c], [0xfc, 0xf8, 0xf0]];
/// The letters of a line of the caption at most.
const LETTERS: usize = 80;
/// From one line of the caption to the next.
const LINE: f64 = 19.0;
/// The length of an axis of the triad.
const AXIS: f64 = 26.0;

/// - **errors** a number beyond the last double (E0306)
fn write(model: &Model, context: &Context<'_>) -> Result<Exported, ExportFault> {
    let figure = Figure::of(model, context)?;
    Ok(Exported {
        bytes: document(&figure, model).into_bytes(),
        fidelity: Fidelity::Drawn,
        warnings: Vec::new(),
    })
}

fn document(figure: &Figure, model: &Model) -> String {
    let captions = captions(model);
    let (bottom, text) = caption(&captions, figure.stage.height);
    let (width, height) = (number(WIDTH), number(bottom));
    let mut lines = vec![
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" role=\"img\" fill=\"none\" \
             stroke-linecap=\"round\" stroke-linejoin=\"round\">"
        ),
        format!("<title>{}</title>", escaped(&captions.join("; "))),
        format!("<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>"),
    ];
    lines.extend(shades(&figure.shades));
    let hidden = |own: &'_ Stroke| own.hidden.clone();
    let visible = |own: &'_ Stroke| own.visible.clone();
    let curves = || figure.curves.iter().map(|own| &own.stroke);
    let faint = "stroke-width=\"0.6\" stroke-dasharray=\"1.2 2.6\"";
    let behind = |id: &str, color: &str, paths: Vec<Polyline>| {
        group(&format!("id=\"{id}\" stroke=\"{color}\" {faint}"), &paths)
    };
    let fine = "id=\"isoparametric\" stroke=\"#4a5f74\" stroke-width=\"0.45\"";
    lines.push(group(fine, &paths(&figure.isoparametric, visible)));
    lines.push(behind(
        "hidden-edges",
        "#8a97a5",
        paths(&figure.edges, hidden),
    ));
    lines.push(behind(
        "hidden-net",
        "#d6b98f",
        paths(&figure.control_polygons, hidden),
    ));
    let net = "id=\"control-net\" stroke=\"#b5843f\" stroke-width=\"0.6\"";
    lines.push(group(net, &paths(&figure.control_polygons, visible)));
    let edge = "id=\"edges\" stroke=\"#1d2b3a\" stroke-width=\"1.15\"";
    lines.push(group(edge, &paths(&figure.edges, visible)));
    lines.push(behind("hidden-curves", "#b9483a", paths(curves(), hidden)));
    let faint = "id=\"hidden-points\" stroke=\"#d6b98f\" stroke-width=\"0.6\"";
    lines.push(dots(faint, &figure.hidden_points));
    let clear = "id=\"control-points\" fill=\"#fff\" stroke=\"#b5843f\" stroke-width=\"0.8\"";
    lines.push(dots(clear, &figure.control_points));
    lines.extend(figure.curves.iter().map(curve));
    lines.push(axes(figure));
    lines.push(text);
    lines.push("</svg>\n".to_owned());
    lines.retain(|own| !own.is_empty());
    lines.join("\n")
}

/// A line of text in the middle of its place, all of it in italics. Some readers of SVG know only
/// the first family, and move the parts of a line that are set on their own.
const TEXT: &str = "font-family=\"Times New Roman, STIX Two Text, Latin Modern Roman, serif\" \
                    font-style=\"italic\" text-anchor=\"middle\"";

/// The stretches of some strokes.
fn paths<'a>(
    strokes: impl IntoIterator<Item = &'a Stroke>,
    pick: impl Fn(&'a Stroke) -> Vec<Polyline>,
) -> Vec<Polyline> {
    strokes.into_iter().flat_map(pick).collect()
}

/// A group of lines, one path each; nothing without lines.
fn group(attributes: &str, lines: &[Polyline]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    let paths = lines
        .iter()
        .map(|own| format!("<path d=\"{}\"/>\n", path(own)));
    format!("<g {attributes}>\n{}</g>", paths.collect::<String>())
}

/// M x y L x y …
fn path(line: &[[f64; 2]]) -> String {
    let mut text = String::new();
    for (index, [x, y]) in line.iter().enumerate() {
        text.push(match index {
            0 => 'M',
            1 => 'L',
            _ => ' ',
        });
        text.push_str(&format!("{} {}", number(*x), number(*y)));
    }
    text
}

/// The tones of surfaces, far ones first; neighbours of one tone are one path. Each path names its
/// colour twice: not every reader knows the one that a path has by `color`.
fn shades(all: &[Shades]) -> Vec<String> {
    let mut lines = vec!["<g id=\"surfaces\" stroke-width=\"0.7\">".to_owned()];
    let cells = Shades::from_afar(all);
    let is_alike =
        |one: &&Shade, other: &&Shade| (one.is_front, one.tone) == (other.is_front, other.tone);
    for run in cells.chunk_by(is_alike) {
        let Some(first) = run.first() else { continue };
        let color = color(if first.is_front { FRONT } else { BACK }, first.tone);
        let cells = run.iter().map(|own| {
            let corners = own.corners.map(|corner| corner.map(tenth).join(" "));
            format!("M{}Z", corners.join(" "))
        });
        let cells = cells.collect::<String>();
        lines.push(format!(
            "<path fill=\"{color}\" stroke=\"{color}\" d=\"{cells}\"/>"
        ));
    }
    lines.push("</g>".to_owned());
    lines
}

/// The colour of a tone between a dark and a light one.
fn color([dark, light]: [[u8; 3]; 2], tone: u8) -> String {
    let [red, green, blue] = [0, 1, 2].map(|channel| {
        let (low, high) = (u32::from(dark[channel]), u32::from(light[channel]));
        let (tone, last) = (u32::from(tone), u32::from(TONES - 1));
        (low * (last - tone) + high * tone) / last
    });
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// A circle for each point; nothing without points.
fn dots(attributes: &str, points: &[[f64; 2]]) -> String {
    if points.is_empty() {
        return String::new();
    }
    let dots = points.iter().map(|own| {
        let [x, y] = own.map(number);
        format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"1.6\"/>\n")
    });
    format!("<g {attributes}>\n{}</g>", dots.collect::<String>())
}

/// A profile in blue, a sweep curve in red, each with its name.
fn curve(own: &CurveFigure) -> String {
    let (class, color, parameter) = if own.is_profile {
        ("profile", "#1f6fb2", "u")
    } else {
        ("sweep-curve", "#b9483a", "v")
    };
    let paths = own
        .stroke
        .visible
        .iter()
        .map(|line| format!("<path d=\"{}\"/>\n", path(line)));
    let [x, y] = own.label.map(number);
    let label = |paint: &str| {
        let name = escaped(&own.name);
        format!(
            "<text x=\"{x}\" y=\"{y}\" {TEXT} font-size=\"15\" {paint}>{name}({parameter})</text>"
        )
    };
    // the white around the letters is a text below them: not every reader paints strokes first
    let halo = label("stroke=\"#fff\" stroke-width=\"3\" aria-hidden=\"true\"");
    let letters = label(&format!("fill=\"{color}\""));
    format!(
        "<g class=\"{class}\" stroke=\"{color}\" stroke-width=\"1.9\">\n{}</g>\n{halo}\n{letters}",
        paths.collect::<String>()
    )
}

/// The directions of x, y and z, in the corner.
fn axes(figure: &Figure) -> String {
    let corner = [48.0, figure.stage.height - 36.0];
    let mut text = format!(
        "<g id=\"axes\" stroke=\"#6b7885\" stroke-width=\"0.8\" {TEXT} font-size=\"12\">\n"
    );
    for (index, name) in ["x", "y", "z"].into_iter().enumerate() {
        let mut axis = [0.0; 3];
        axis[index] = 1.0;
        let [right, down, _] = figure.stage.direction(axis);
        if right * right + down * down < 0.01 {
            continue;
        }
        let at = |length: f64| [corner[0] + length * right, corner[1] + length * down];
        let [x, y] = at(AXIS + 9.0);
        text.push_str(&format!(
            "<path d=\"{}\"/>\n<text x=\"{}\" y=\"{}\" fill=\"#6b7885\" stroke=\"none\">{name}</text>\n",
            path(&[corner, at(AXIS)]),
            number(x),
            number(y + 4.0)
        ));
    }
    text.push_str("</g>");
    text
}

/// The name and the bidegree of each surface.
fn captions(model: &Model) -> Vec<String> {
    let names = model.parts().iter().map(|own| {
        let degree = own.net.degree();
        format!("{}, bidegree ({}, {})", own.name, degree.u, degree.v)
    });
    names.collect()
}

/// The caption in as many lines as it needs, and the height of the picture with them.
fn caption(captions: &[String], height: f64) -> (f64, String) {
    let mut lines: Vec<String> = Vec::new();
    for own in captions {
        let letters = |text: &str| text.chars().count();
        match lines.last_mut() {
            Some(line) if letters(line) + letters(own) < LETTERS => {
                line.push_str(&format!("; {own}"));
            }
            _ => lines.push(own.clone()),
        }
    }
    let (mut bottom, mut text) = (height, String::new());
    for (index, line) in lines.iter().enumerate() {
        if index > 0 {
            bottom += LINE;
            text.push('\n');
        }
        text.push_str(&format!(
            "<text x=\"{}\" y=\"{}\" {TEXT} font-size=\"14\" fill=\"#1d2b3a\">{}</text>",
            number(WIDTH / 2.0),
            number(bottom - 22.0),
            escaped(line)
        ));
    }
    (bottom, text)
}

/// A text as XML takes it.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

/// A coordinate to the hundredth, as short as it can be written.
fn number(value: f64) -> String {
    short(format!("{value:.2}"))
}

/// A coordinate to the tenth.
fn tenth(value: f64) -> String {
    short(format!("{value:.1}"))
}

/// A decimal without zeros at its end, and without a sign if it is 0.
fn short(text: String) -> String {
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.strip_prefix('-')
        .filter(|own| *own == "0")
        .unwrap_or(text)
        .to_owned()
}
