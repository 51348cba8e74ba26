//! PH quintics from Hermite data and circular arcs: they meet their data exactly, in every branch and
//! for degenerate data.
#![allow(clippy::unwrap_used, missing_docs, reason = "tests state facts")]

mod support;

use support::compile;

/// A text compiles, its expectations hold, and there is no finding but of these codes.
fn sound(text: &str, codes: &[&str]) {
    let compiled = compile(text);
    let found: Vec<&str> = compiled.codes().iter().map(|own| own.as_str()).collect();
    assert_eq!(found, codes, "{text}\n{}", compiled.all());
}

/// `(a, b)` as a point of the xy-plane.
fn in_space(pair: &str) -> String {
    let inner = pair.trim().strip_prefix('(').unwrap();
    format!("({}, 0)", inner.strip_suffix(')').unwrap())
}

/// What the report says of the curve.
fn interpolant(text: &str) -> serde_json::Value {
    compile(text).report()["curves"][0]["ph_hermite"].clone()
}

/// A surface that asks for the curve's speed, with expectations on end points and end derivatives.
fn interpolated(data: &str, branch: &str, domain: [i64; 2]) -> String {
    let [a, b] = domain;
    let parts: Vec<&str> = data.split(';').collect();
    let [p0, d0, p1, d1] = parts[..] else {
        unreachable!("four pairs");
    };
    format!(
        "sweep c(v) in xy on [{a}, {b}] = ph_hermite({p0}, {d0}, {p1}, {d1}, branch: {branch})\n\
         surface R = c(v) + u k + 0 s(v) i\n\
         expect c({a}) == {}\nexpect c'({a}) == {}\nexpect c({b}) == {}\nexpect c'({b}) == {}\n",
        in_space(p0),
        in_space(d0),
        in_space(p1),
        in_space(d1)
    )
}

#[test]
fn every_branch_meets_its_data() {
    let data = [
        "(0, 0); (0, 4); (2, 2); (4, 0)",
        "(0, 0); (-2, 0); (0, 1); (2, 0)",
        "(1, -2); (3, 4); (5/2, 1); (5, -12)",
        "(0, 0); (1, 1); (3, 1/2); (2, -1)",
    ];
    for data in data {
        for branch in ["\"++\"", "\"+-\"", "\"-+\"", "\"--\"", "best"] {
            sound(&interpolated(data, branch, [0, 1]), &[]);
        }
    }
    sound(&interpolated(data[0], "best", [1, 3]), &[]);
}

#[test]
fn degenerate_data_have_curves_too() {
    // no derivative at the start, at the end, at both: there is a cusp
    for data in [
        "(0, 0); (0, 0); (2, 2); (4, 0)",
        "(0, 0); (4, 0); (2, 2); (0, 0)",
        "(0, 0); (0, 0); (2, 2); (0, 0)",
    ] {
        sound(&interpolated(data, "best", [0, 1]), &["W1003", "W1011"]);
    }
    // a straight line that stops and turns back has a cusp, and bends nowhere
    let stop = interpolated("(0, 0); (5, 0); (1, 0); (5, 0)", "\"+-\"", [0, 1]);
    sound(&stop, &["W1003", "W1011"]);
    assert_eq!(interpolant(&stop)["bending_energy"], "0");
    // a straight line at constant speed is the best of four, three of which have cusps
    let line = interpolated("(0, 0); (3, 4); (3, 4); (3, 4)", "best", [0, 1]);
    sound(&line, &[]);
    let report = interpolant(&line);
    assert_eq!(report["branch"], "++");
    assert_eq!(report["rotation_index"], "0");
    // a closed curve
    sound(
        &interpolated("(0, 0); (1, 2); (0, 0); (-1, 2)", "best", [0, 1]),
        &[],
    );
}

#[test]
fn mirror_images_are_a_tie() {
    let turn = interpolated("(0, 0); (1, 0); (-1, 0); (1, 0)", "best", [0, 1]);
    let report = interpolant(&turn);
    let choice = "first of those with the least absolute rotation index";
    assert_eq!(report["choice"], choice);
    let index = report["rotation_index"].clone();
    let other = match report["branch"].as_str().unwrap() {
        "++" => "\"+-\"",
        "-+" => "\"--\"",
        branch => unreachable!("{branch} comes after its mirror image"),
    };
    let mirrored = interpolated("(0, 0); (1, 0); (-1, 0); (1, 0)", other, [0, 1]);
    let mirrored = interpolant(&mirrored);
    assert_eq!(mirrored["rotation_index"], index);
    assert_eq!(mirrored["bending_energy"], report["bending_energy"]);
}

/// The branch that is best for data on a domain.
fn best(data: &str, domain: &str) -> String {
    let text =
        format!("sweep c(v) in xy on {domain} = ph_hermite({data})\nsurface R = c(v) + u k\n");
    let report = interpolant(&text);
    report["branch"].as_str().unwrap().to_owned()
}

#[test]
fn the_best_branch_turns_least_at_every_scale() {
    // nearly a straight line: the first comparison needs more digits than it starts with
    for last in ["(-1, 1e-8)", "(-1, 1e-10)"] {
        assert_eq!(
            best(&format!("(0, 0), (1, 0), (3, 0), {last}"), "[0, 1]"),
            "++"
        );
    }
    assert_eq!(best("(0, 0), (1, 0), (1, 1), (0, 1)", "[0, 1]"), "++");
    assert_eq!(
        best("(0, 0), (1e5, 0), (1, 1), (0, 1e5)", "[0, 1e-5]"),
        "++"
    );
    assert_eq!(
        best("(0, 0), (1e-9, 0), (1, 1), (0, 1e-9)", "[0, 1e9]"),
        "++"
    );
    // ++ and +- turn by the same angle, without being images of each other, but more than -+
    assert_eq!(best("(0, 0), (5, 1), (0, 0), (-4, 3)", "[0, 1]"), "-+");
    // an end that almost stands still
    for small in ["1e-9", "1e-40"] {
        best(&format!("(0, 0), (1, 0), (1, 1), (0, {small})"), "[0, 1]");
    }
}

#[test]
fn energies_are_known_at_every_scale() {
    let energy = |data: &str, domain: &str| {
        let text =
            format!("sweep c(v) in xy on {domain} = ph_hermite({data})\nsurface R = c(v) + u k\n");
        interpolant(&text)["bending_energy"]
            .as_str()
            .unwrap()
            .to_owned()
    };
    // lengths times 10⁶⁰ divide the energy by as much
    let [unit, large] = ["1", "1e60"].map(|own| {
        energy(
            &format!("(0, 0), ({own}, 0), ({own}, {own}), (0, {own})"),
            "[0, 1]",
        )
    });
    assert_eq!(format!("{unit}e-60"), large);
    for (data, domain) in [
        ("(0, 0), (1, 0), (1, 1e-4), (1, 0)", "[0, 1]"),
        ("(0, 0), (1, 0), (1000, 500), (0, 1)", "[0, 1]"),
        ("(0, 0), (1, 0), (1000, 1000), (0, 1)", "[0, 1000]"),
        ("(0, 0), (1e12, 0), (1, 1), (0, 1e12)", "[0, 1]"),
        ("(0, 0), (1e-12, 0), (1e-12, 1e-12), (0, 1e-12)", "[0, 1]"),
    ] {
        let found = energy(data, domain);
        assert!(
            found.starts_with(|own: char| own.is_ascii_digit()),
            "{data}: {found}"
        );
        assert_ne!(found, "0", "{data}");
    }
}

#[test]
fn wrong_data_are_refused() {
    let curve =
        |constructor: &str| format!("sweep c(v) in xy = {constructor}\nsurface R = c(v) + u k\n");
    let refused = |constructor: &str, part: &str| {
        let compiled = compile(&curve(constructor));
        assert_eq!(
            compiled.codes(),
            [sweepc::diag::Code::E0208],
            "{constructor}"
        );
        assert!(compiled.all().contains(part), "{}", compiled.all());
    };
    refused(
        "ph_hermite((0, 0), (1, 0), (1, 1), (0, 1), branch: good)",
        "there is no branch `good`",
    );
    refused(
        "ph_hermite((0, 0), (0, 0), (0, 0), (0, 0))",
        "the hodograph of this curve is zero",
    );
    refused(
        "ph_hermite((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))",
        "its data are pairs",
    );
    refused(
        "arc(center: (0, 0), start: (1, 0), end: (0, 2))",
        "the squares are 1 and 4",
    );
    for end in ["(-1, 0)", "(1, 0)"] {
        refused(
            &format!("arc(center: (0, 0), start: (1, 0), end: {end})"),
            "more than 0° and less than 180°",
        );
    }
}

#[test]
fn arcs_keep_their_distance() {
    for [center, start, end] in [
        ["(1, 2)", "(4, 6)", "(-3, 5)"],
        ["(0, 0)", "(1, 0)", "(0, 1)"],
        ["(0, 0)", "(1, 1)", "(0, sqrt(2))"],
        ["(0, 0)", "(-5, 0)", "(4, 3)"],
    ] {
        let middle = in_space(center);
        sound(
            &format!(
                "sweep c(v) in xy = arc(center: {center}, start: {start}, end: {end})\n\
                 let m = {middle}\n\
                 surface R = c(v) + u k\n\
                 expect norm2(c(v) - m) == norm2({} - m)\n\
                 expect c(1) == {}\n",
                in_space(start),
                in_space(end)
            ),
            &[],
        );
    }
    sound(
        "sweep c(v) = arc(center: (0, 0, 1), start: (2, 1, 3), end: (1, -2, -1))\n\
         surface R = c(v) + u (0, 0, 1)\n\
         expect norm2(c(v) - (0, 0, 1)) == 9\n",
        &[],
    );
}
