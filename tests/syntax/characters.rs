//! Text, characters, numbers.

use sweepc::diag::{Code, Diagnostics, Limits};
use sweepc::syntax::decode;

use crate::show::show_document;
use crate::{fixed, one, parsed};

#[test]
fn marks_and_line_ends_are_accepted() {
    let text = "\u{feff}let a = 1 # c\r\nlet b = 2 # d\rlet c = 3\r\n";
    let (document, diagnostics) = parsed(text);
    assert_eq!(diagnostics, Diagnostics::default());
    assert_eq!(
        show_document(&document),
        "(let a 1)\n(let b 2)\n(let c 3)\n"
    );
    let comments = document.comments.iter().map(|span| &text[span.range()]);
    assert_eq!(comments.collect::<Vec<_>>(), ["# c", "# d"]);
    assert_eq!(document.items[0].span.start, 3);
}

#[test]
fn look_alikes_are_named() {
    for (marked, words) in [
        ("let «с» = 1", "`с` (U+0441) looks like `c`; write `c`"),
        ("let a«х» = 1", "`х` (U+0445) looks like `x`; write `ax`"),
        ("let «ς» = 1", "`ς` (U+03C2) looks like `σ`"),
        ("let «𝜎»a = 1", "(U+1D70E) looks like `σ`; write `σa`"),
        ("let «Ａ» = 1", "(U+FF21) looks like `A`"),
        ("let r«₀» = 1", "(U+2080) looks like `0`; write `r0`"),
        ("let a«é» = 1", "(U+00E9) is not a letter of the language"),
        ("let a«\u{301}» = 1", "U+0301"),
        ("let a«\u{200b}»b = 1", "the invisible character U+200B"),
        ("let a«\u{202e}»b = 1", "the invisible character U+202E"),
        (
            "let a =«\u{2060}» 1",
            "U+2060 has no place in the language; remove it",
        ),
        ("let a = 1 «–» 2", "(U+2013) looks like `-`; write `-`"),
        ("let a = 2 «⋅» 3", "(U+22C5) looks like `*`"),
        ("let a = «（»2)", "(U+FF08) looks like `(`"),
        ("let a =«\u{a0}»1", "the space U+00A0"),
        ("let a = u«²»", "U+00B2"),
        ("let a = «１２»", "(U+FF11) looks like `1`; write `12`"),
        ("let a = 1«２»", "looks like `2`"),
        ("# «\u{202e}» hidden", "U+202E"),
        ("import \"«\u{2066}»\"", "U+2066"),
        ("# a «\u{feff}»", "U+FEFF"),
        ("let a = 1«\u{feff}»", "U+FEFF"),
    ] {
        let marked = marked.replace("«１２»", "«１»２");
        one(Code::E0003, &marked, words);
    }
    assert_eq!(fixed("lеt a = 1"), "let a = 1");
    assert_eq!(fixed("let a\u{200b}b = 1"), "let ab = 1");
    assert_eq!(fixed("let a = u¹⁰"), "let a = u^10");
    assert_eq!(fixed("let a = f‘(u)"), "let a = f'(u)");
    assert_eq!(fixed("expect a ≤ b"), "expect a <= b");
}

#[test]
fn a_repaired_name_is_the_name_that_was_meant() {
    let (document, _) = parsed("lеt х = ѕ");
    assert_eq!(show_document(&document), "(let x s)\n");
}

#[test]
fn other_characters_have_no_place() {
    one(Code::E0002, "let a = 1«\0»", "U+0000");
    one(Code::E0002, "# a «\0»", "U+0000");
    one(Code::E0002, "let a = «$»", "`$` (U+0024)");
    one(Code::E0002, "let a = «{» 1", "brackets");
    one(Code::E0002, "expect a «!» b", "`!=`");
    one(Code::E0002, "let a = «√»2", "sqrt");
    let (_, diagnostics) = parsed("let a\n = \0");
    let note = &diagnostics.iter().next().unwrap().notes;
    assert_eq!(note[..], ["at byte 9".to_owned()]);
}

#[test]
fn malformed_numbers_are_errors() {
    one(Code::E0004, "let a = «1.2.3»", "`1.2.3` is not a number");
    one(Code::E0004, "let a = «1.»", "write `1`");
    one(Code::E0004, "let a = «1.»x", "write `1`");
    one(Code::E0004, "let a = «1..2»", "`1..2`");
    one(Code::E0004, "let a = «1e5.3»", "one decimal point");
    assert_eq!(fixed("let a = 1.5."), "let a = 1.5");
    one(Code::E0006, "let a = «.»5", "`0.5`");
}

#[test]
fn bytes_are_decoded_or_refused() {
    let limits = Limits {
        source: 8,
        ..Limits::default()
    };
    let refused = |bytes: &[u8]| {
        let finding = decode(bytes, "a.sweep", &limits).unwrap_err();
        (finding.code, finding.message)
    };
    assert_eq!(
        decode("\u{feff}σ".as_bytes(), "a", &limits).unwrap(),
        "\u{feff}σ"
    );
    assert_eq!(decode(b"12345678", "a", &limits).unwrap(), "12345678");
    let (code, message) = refused(b"123456789");
    assert_eq!(
        (code, message.as_str()),
        (Code::E0501, "`a.sweep` has 9 bytes, the limit is 8")
    );
    let (code, message) = refused(b"ab\nc\xffd");
    assert_eq!(code, Code::E0001);
    assert_eq!(message, "`a.sweep` is not UTF-8 text: invalid at byte 4");
    for utf16 in [
        &b"\xff\xfel\0"[..],
        b"\xfe\xff\0l",
        b"l\0e\0t\0",
        b"\0l\0e\0t",
    ] {
        assert_eq!(
            refused(utf16),
            (Code::E0001, "`a.sweep` looks like UTF-16".to_owned())
        );
    }
    assert_eq!(decode(b"a\0b", "a", &limits).unwrap(), "a\0b");
}
