//! The table of `seeds/farouki-nittler/table.md`: what the paper prints of its examples beside what
//! the compiler finds.
//!
//! `SWEEPC_REGENERATE=1 cargo test --test paper table` writes the file anew.

use std::fmt::Write;
use std::path::Path;

use serde_json::Value;
use sweepc::check::Checked;
use sweepc::curve::Interval;
use sweepc::number::{Basis, Field, Real};
use sweepc::poly::{BiDegree, BiPoly, UniPoly};

use crate::hermite::hermite_data;
use crate::reference::{Examples, NAMES, items, surfaces, text};

const DEGREES: &str = include_str!("../../seeds/farouki-nittler/degrees.json");
const EXAMPLES: &str = include_str!("../../seeds/farouki-nittler/examples.json");
const ERRATA: &str = include_str!("../../seeds/farouki-nittler/errata.md");
const HEAD: &str = "\
# The examples of the paper

What the paper prints, and what the compiler finds in `examples/paper`. The test `paper` holds this
file to the program; [README.md](README.md) says how it is written anew.

- *bound*: by counting, nothing cancels
- *constructed*: of the formula over its common denominator
- *reduced*: after the common factor is removed
- *upper bound*: the printed bidegree is too high; *erratum*: it is no bound. See [errata.md](errata.md).
";

/// How a printed bidegree compares with the exact one.
fn verdict(printed: [usize; 2], exact: [usize; 2]) -> &'static str {
    if printed == exact {
        "agrees"
    } else if printed[0] >= exact[0] && printed[1] >= exact[1] {
        "upper bound"
    } else {
        "erratum"
    }
}

fn pair(own: Option<BiDegree>) -> [usize; 2] {
    own.map(|own| [own.u, own.v]).unwrap()
}

fn show([u, v]: [usize; 2]) -> String {
    format!("({u}, {v})")
}

/// An example with its surface.
struct Row<'a> {
    printed: &'a Value,
    surface: &'a Checked,
    title: String,
}

impl Row<'_> {
    /// One line for each coordinate.
    fn degrees(&self, table: &mut String) {
        let expansion = self.surface.expansion();
        let reduced = self.surface.surface().bidegrees();
        for (index, name) in NAMES.iter().enumerate() {
            let own = &self.printed[name];
            let number = |index: usize| usize::try_from(own["printed"][index].as_u64().unwrap());
            let printed = [number(0).unwrap(), number(1).unwrap()];
            let exact = pair(reduced[index]);
            let mut verdict = verdict(printed, exact).to_owned();
            assert_eq!(verdict, text(&own["verdict"]), "{} {name}", self.title);
            if verdict != "agrees" {
                let id = text(&own["erratum"]);
                assert!(ERRATA.contains(&format!("## {id} ")), "{id}");
                write!(verdict, ", {id}").unwrap();
            }
            let cells = [
                printed,
                pair(expansion.bound()[index]),
                pair(expansion.constructed[index]),
                exact,
            ];
            let cells = cells.map(show).join(" | ");
            writeln!(table, "| {} | {name} | {cells} | {verdict} |", self.title).unwrap();
        }
    }

    /// The net, the field and the arc length of the PH curve.
    fn surface(&self, table: &mut String) {
        let coordinates = self.surface.surface().coordinates().iter();
        let rows: Vec<UniPoly<Real>> = coordinates.flat_map(BiPoly::rows).collect();
        let basis = Basis::of(rows.iter().flat_map(UniPoly::numerators));
        let definitions = basis.definitions();
        let definitions = definitions.iter().map(|(name, square)| {
            let square = square.replace('*', " ");
            format!("{name}² = {square}")
        });
        let field = match definitions.collect::<Vec<_>>().join(", ") {
            none if none.is_empty() => "ℚ".to_owned(),
            some => some,
        };
        let patch = self.surface.surface().bidegree();
        let net = format!("{} × {}", patch.u + 1, patch.v + 1);
        let (exact, decimal) = self.length().map_or_else(
            || ("–".to_owned(), "–".to_owned()),
            |length| {
                let basis = basis.clone().union(&Basis::of([length.numerator()]));
                let exact = basis.spell(&length).replace('*', " ");
                (exact, length.decimal(29))
            },
        );
        let degree = basis.degree();
        let title = &self.title;
        writeln!(
            table,
            "| {title} | {net} | {field} | {degree} | {exact} | {decimal} |"
        )
        .unwrap();
    }

    /// The total arc length of the example's PH curve; none if it has no such curve.
    fn length(&self) -> Option<Real> {
        let examples: Value = serde_json::from_str(EXAMPLES).unwrap();
        let example = items(&examples["examples"])
            .iter()
            .find(|own| own["example"] == self.printed["example"])
            .cloned();
        let printed = &example.unwrap()["printed"];
        let data = ["sweep", "profile"].map(|own| &printed[own]["hermite"]);
        let (hermite, _) = hermite_data(data.into_iter().find(|own| own.is_object())?);
        let tower = self.surface.definition().tower.scratch();
        let unit = Interval::unit();
        let (branch, _) = hermite.best(&unit, &tower).unwrap();
        let preimage = hermite.preimage(branch, &unit, &tower).unwrap();
        let speed = preimage.speed(&tower).unwrap();
        Some(speed.antiderivative().evaluate(&Real::one()))
    }
}

fn table() -> String {
    let degrees: Value = serde_json::from_str(DEGREES).unwrap();
    let (data, mut examples) = (surfaces(), Examples::default());
    let mut coordinates = String::from(
        "\n| example | | printed | bound | constructed | reduced | verdict |\n|---|---|---|---|---|---|---|\n",
    );
    let mut nets = String::from(
        "\n| example | net | field | its degree | arc length S | S in 30 digits |\n|---|---|---|---|---|---|\n",
    );
    let mut count = 0;
    for printed in items(&degrees["examples"]) {
        let cases = items(&data["cases"]);
        let case = cases.iter().find(|own| own["id"] == printed["case"]);
        let (_, surface) = examples.case(case.unwrap());
        let title = text(&printed["case"]).trim_start_matches('E');
        let row = Row {
            printed,
            surface,
            title: match title {
                "3" => "3, d = v".to_owned(),
                "3b" => "3, d = v²".to_owned(),
                "3c" => "3, d = −v²".to_owned(),
                other => other.to_owned(),
            },
        };
        row.degrees(&mut coordinates);
        row.surface(&mut nets);
        count += 1;
    }
    assert_eq!(count, 7);
    format!("{HEAD}{coordinates}{nets}")
}

#[test]
fn table_is_what_the_program_gives() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("seeds/farouki-nittler/table.md");
    let found = table();
    if std::env::var_os("SWEEPC_REGENERATE").is_some_and(|own| own == "1") {
        std::fs::write(&path, &found).unwrap();
    }
    let written = std::fs::read_to_string(&path).unwrap();
    assert_eq!(
        written, found,
        "to write it anew: SWEEPC_REGENERATE=1 cargo test --test paper table"
    );
}

#[test]
fn printed_degrees_are_judged() {
    assert_eq!(verdict([2, 4], [2, 4]), "agrees");
    assert_eq!(verdict([2, 4], [1, 4]), "upper bound");
    assert_eq!(verdict([2, 5], [1, 9]), "erratum");
    assert_eq!(verdict([2, 9], [3, 9]), "erratum");
}
