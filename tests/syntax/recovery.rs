//! Reading on behind an error.

use sweepc::diag::Code;
use sweepc::syntax::ast::{Declaration, Role};

use crate::show::show_document;
use crate::{findings, one, parsed};

#[test]
fn an_unclosed_bracket_is_shown_at_its_opener() {
    one(Code::E0005, "let a = «(»1 + 2", "`(` is not closed");
    one(Code::E0005, "let a = «(»1 + 2\nlet b = 3", "write `)`");
    one(Code::E0005, "let a = f(«[»1, 2", "`[` is not closed");
    one(
        Code::E0005,
        "let a = («(»1, \nsurface R = a",
        "`(` is not closed",
    );
    one(Code::E0005, "let a = «(»1 +", "`(` is not closed");
    one(
        Code::E0005,
        "sweep c(v) on «[»0, 1\nlet a = 1",
        "`[` is not closed",
    );
    one(Code::E0005, "import «\"»a", "the string is not closed");
    one(
        Code::E0005,
        "let a = f(b: «\"»+-)\nlet c = 2",
        "the string is not closed",
    );
    let (document, diagnostics) = parsed("let a = (1\nlet b = 3");
    assert_eq!(show_document(&document), "(let b 3)\n");
    let related = &diagnostics.iter().next().unwrap().related;
    assert_eq!(related[0].0.range(), 11..14);
    assert_eq!(related[0].1, "the next declaration begins here");
}

#[test]
fn every_error_of_a_file_is_reported() {
    let slips = [
        "let a = ",
        "let = 2",
        "param 3 = 2",
        "let b = (1",
        "let c = 1,5",
        "let d = 1 2",
        "profile p = 1",
        "sweep q(v) on [0] = 1",
        "surface R(u) = 1",
        "expect",
        "import x",
        "unit 3",
        "let e = 1..2",
        "let f = \u{441}",
        "let g = ?",
        "let h = u^+2",
        "let in = 2",
        "let l = 1 )",
        "curve m(u) in zz = 1",
        "let o == 2",
    ];
    let text = slips
        .map(|slip| format!("{slip}\nlet z_{} = 1\n", slip.len()))
        .concat();
    let (document, diagnostics) = parsed(&text);
    assert_eq!(
        diagnostics.errors().count(),
        slips.len(),
        "{:#?}",
        findings(&text)
    );
    let good = document.items.iter().filter(|item| {
        matches!(&item.declaration, Declaration::Let { name, .. } if name.text.starts_with("z_"))
    });
    assert_eq!(good.count(), slips.len());
    let places: Vec<_> = diagnostics.iter().map(|finding| finding.primary).collect();
    assert!(places.is_sorted());
}

#[test]
fn recovery_stops_at_misspelt_keywords() {
    let codes =
        findings("let a = )\nproflie p(u) = q\nb = 1\nlet c = 2\nexpct c == 2\nsweep d(v) = (");
    let places: Vec<_> = codes.iter().map(|(_, marked, _)| marked.as_str()).collect();
    assert_eq!(places, [")", "proflie", "expct", "("]);
}

/// Both are told: the value that is missing, and the keyword that the next declaration lacks.
#[test]
fn a_declaration_without_a_value_ends_before_the_next_without_a_keyword() {
    let found = findings("param r\nlat b = 2\nlet d\nq = 2\nlet e = q");
    let found: Vec<_> = found
        .iter()
        .map(|(_, marked, message)| (marked.as_str(), message.as_str()))
        .collect();
    let missing = ("", "expected `=`, found the end of the declaration");
    assert_eq!(
        found,
        [
            missing,
            ("lat", "expected a declaration, found `lat`"),
            missing,
            ("q", "expected a declaration, found `q`"),
        ]
    );
}

#[test]
fn at_most_fifty_errors_are_reported() {
    let (_, diagnostics) = parsed(&"let a = \n$".repeat(200));
    let errors: Vec<_> = diagnostics.errors().collect();
    assert_eq!(errors.len(), 50);
    assert!(errors[49].notes[0].contains("only the first 50"));
    assert!(errors[48].notes.iter().all(|note| !note.contains("first")));
    let (_, diagnostics) = parsed(&"let a = ) ".repeat(50));
    assert_eq!(diagnostics.errors().count(), 50);
    assert!(diagnostics.errors().all(|error| error.notes.is_empty()));
}

#[test]
fn names_of_broken_declarations_are_kept() {
    let names = |text: &str| {
        let (document, _) = parsed(text);
        let list = document.broken.iter().map(|own| own.name.text.clone());
        (list.collect::<Vec<_>>().join(" "), document.items.len())
    };
    assert_eq!(
        names("let sigma_1 = (\nsurface R = ) let a = 1"),
        ("sigma_1 R".to_owned(), 1)
    );
    assert_eq!(names("let a = 1\nb = 2\nlet c = 3"), ("a b".to_owned(), 1));
    assert_eq!(names("let a = 1\nsurfce f(u) = 2"), ("a f".to_owned(), 0));
    assert_eq!(names("let a = 1 )"), (String::new(), 1));
    assert_eq!(names("proflie p(u) = a"), ("p".to_owned(), 0));
    assert_eq!(names("b = 2\nlet c = 3"), ("b".to_owned(), 1));
    assert_eq!(names("let a = )\nlett b = 2"), ("a b".to_owned(), 0));
    assert_eq!(names("unit mm\nb = 2\nlet c = 3"), ("b".to_owned(), 2));
    // nothing of the line went into the declaration before
    assert_eq!(
        names("import \"a\"\nlett b = 2\nunit mm\nlett c = 2"),
        ("b c".to_owned(), 2)
    );
}

#[test]
fn roles_of_broken_curves_are_kept() {
    use Role::{Further, Profile, Sweep};
    let roles = |text: &str| -> Vec<_> {
        let (document, _) = parsed(text);
        document.broken.iter().map(|own| own.role).collect()
    };
    assert_eq!(roles("profile p(u) = ("), [Some(Profile)]);
    assert_eq!(roles("sweeep c(v) in xy = ("), [Some(Sweep)]);
    assert_eq!(roles("let a = 2\ncurv c(v) = a"), [None, Some(Further)]);
    assert_eq!(roles("q(u) in xz = a\nlet b = 1"), [Some(Profile)]);
    assert_eq!(roles("let a = 2\nc(v) on [0, 1] = a"), [None, Some(Sweep)]);
    assert_eq!(roles("let a = 2\nf(v) = a\nlett b = 1"), [None; 3]);
}

#[test]
fn a_declaration_after_an_unfinished_one_is_read() {
    let (document, diagnostics) = parsed("let a = 2 *\nexpect (b) == c\nlet d = (\nexpect -b == c");
    let shown = "(expect (group b) == c)\n(expect (+ (- b)) == c)\n";
    assert_eq!(show_document(&document), shown);
    let codes = diagnostics.errors().map(|error| error.code);
    assert_eq!(codes.collect::<Vec<_>>(), [Code::E0006, Code::E0005]);
}

#[test]
fn a_keyword_that_touches_a_dot_begins_no_declaration() {
    one(
        Code::E0006,
        "import «b».sweep\nlet a = 1",
        "a string stands in double quotes",
    );
    one(
        Code::E0103,
        "let a = c.«sweep»\nlet b = 1",
        "`sweep` is a keyword",
    );
    let (document, diagnostics) = parsed("import ../b.sweep # c\nlet a = 1\nlet b = c.\nlet d = 2");
    let fix = diagnostics.iter().next().unwrap().fix.clone().unwrap();
    assert_eq!(
        (fix.span.range(), fix.text.as_str()),
        (7..17, "\"../b.sweep\"")
    );
    let shown = show_document(&document);
    assert_eq!(shown, "(let a 1)\n(let d 2)\n");
}
