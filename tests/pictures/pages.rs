//! A page holds the exact net and the report, and asks for nothing else.

use serde_json::Value;

use crate::{compiled, model, odd_nets, written};

/// What stands between two marks, once.
fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    let (_, rest) = text.split_once(start).unwrap();
    rest.split_once(end).unwrap().0
}

fn data(page: &str) -> Value {
    let start = "<script type=\"application/json\" id=\"model\">";
    serde_json::from_str(between(page, start, "</script>")).unwrap()
}

#[test]
fn a_page_holds_the_exact_nets() {
    for example in ["paper/example_2.sweep", "design/duct_bend.sweep"] {
        let files = compiled(example, &["--emit", "html,json"]);
        let pages = files.iter().filter(|(name, _)| name.ends_with(".html"));
        for (name, page) in pages {
            let stem = name.strip_suffix(".html").unwrap();
            let nets = data(page)["nets"].as_array().unwrap().clone();
            let net = |name: String| serde_json::from_str::<Value>(&files[&name]).unwrap();
            if let Some((stem, _)) = stem.split_once('-') {
                let surface = nets[0]["name"].as_str().unwrap();
                assert_eq!(nets, [net(format!("{stem}-{surface}.json"))]);
            } else {
                let names = ["Upper", "Lower"];
                let each = names.map(|own| net(format!("{stem}-{own}.json")));
                assert_eq!(nets, each);
            }
        }
    }
}

#[test]
fn a_page_is_the_same_in_every_run_and_asks_for_nothing() {
    let write = || compiled("paper/example_2.sweep", &["--emit", "html"]);
    let files = write();
    assert_eq!(files, write());
    let page = &files["example_2-R.html"];
    for outside in ["src=", "@import", "url(", "<link rel=\"stylesheet\""] {
        let (markup, _) = page.split_once("/*!").unwrap();
        assert!(!markup.contains(outside), "{outside}");
    }
    assert!(page.contains("Permission is hereby granted, free of charge"));
    assert_eq!(
        page.matches("<script").count(),
        page.matches("</script").count()
    );
}

#[test]
fn a_page_shows_the_report_of_its_surface() {
    let page = &compiled("paper/example_2.sweep", &["--emit", "html"])["example_2-R.html"];
    let report = between(page, "<aside>", "</aside>");
    let row = |label: &str, cells: [&str; 4]| {
        let cells = cells.map(|own| format!("<td>{own}</td>")).concat();
        format!("<tr><th>{label}</th>{cells}")
    };
    assert!(report.contains(&row("bound", ["(2, 4)", "(2, 9)", "(2, 9)", "(2, 4)"])));
    assert!(report.contains(&row("reduced", ["(2, 4)", "(2, 9)", "(2, 9)", "(1, 4)"])));
    assert!(report.contains("<code>length(c) == 4 (1 + sqrt(2)) / 3</code> <em>holds</em>"));
    assert!(report.contains("Q(√2)(√(110 + 100*√2)), degree 4"));
    let upper = &compiled("design/duct_bend.sweep", &["--emit", "html"])["duct_bend-Upper.html"];
    assert!(upper.contains("<h2><i>Upper</i>") && !upper.contains("<h2><i>Lower</i>"));
}

#[test]
fn odd_names_and_nets_are_carried() {
    for (name, net) in odd_nets() {
        let page = written("html", &model(&[(name, net)]), "12.5,-30");
        let data = data(&page);
        assert_eq!(data["nets"][0]["name"], name);
        assert_eq!(data["view"], serde_json::json!([12.5, -30.0]));
    }
}
