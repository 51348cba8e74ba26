//! Every code has a page, whose failing example breaks that rule alone and whose other example
//! is sound; and `sweepc explain` prints the pages.

mod example_files;

use std::collections::BTreeSet;
use std::error::Error;
use std::fs;
use std::path::Path;

use sweepc::diag::Code;
use tempfile::TempDir;

use example_files::run;

type Outcome = Result<(), Box<dyn Error>>;

/// The longest line of a page.
const WIDTH: usize = 100;

/// A fenced block: the words behind the fence, and its text.
struct Block {
    info: Vec<&'static str>,
    text: String,
}

fn blocks(page: &'static str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if let Some(info) = line.strip_prefix("```") {
            let inside = lines.by_ref().take_while(|line| *line != "```");
            blocks.push(Block {
                info: info.split(' ').collect(),
                text: inside.flat_map(|line| [line, "\n"]).collect(),
            });
        }
    }
    blocks
}

/// The codes of the findings that a text on standard error shows.
fn codes(printed: &str) -> BTreeSet<&str> {
    let marks = ["error[", "warning["];
    let found = marks.iter().flat_map(|mark| printed.split(mark).skip(1));
    found.filter_map(|rest| rest.get(..5)).collect()
}

/// What a command says of a text on standard error, and whether it succeeds.
fn said(command: &str, text: &str) -> Result<(String, bool), Box<dyn Error>> {
    let folder = TempDir::new()?;
    fs::write(folder.path().join("page.sweep"), text)?;
    let output = run(folder.path(), &[command, "page.sweep"], "");
    Ok((String::from_utf8(output.stderr)?, output.status.success()))
}

/// Runs the lines of a console block, in a new folder, with `sweepc` in the path.
#[cfg(unix)]
fn console(block: &Block) -> Result<(String, bool), Box<dyn Error>> {
    let lines = block.text.lines();
    let lines: Option<Vec<&str>> = lines.map(|line| line.strip_prefix("$ ")).collect();
    let lines = lines.ok_or("every line of a console block begins with `$ `")?;
    let folder = TempDir::new()?;
    let binary = Path::new(env!("CARGO_BIN_EXE_sweepc"));
    let own = binary.parent().ok_or("a folder of the binary")?;
    let path = std::env::var("PATH").unwrap_or_default();
    let output = std::process::Command::new("sh")
        .args(["-e", "-c", &lines.join("\n")])
        .env("PATH", format!("{}:{path}", own.display()))
        .current_dir(folder.path())
        .output()?;
    Ok((String::from_utf8(output.stderr)?, output.status.success()))
}

#[test]
fn the_failing_example_yields_its_code_and_no_other() -> Outcome {
    for code in Code::ALL {
        let blocks = blocks(code.explanation());
        let failing = blocks.first().ok_or("no example")?;
        let (printed, sound) = match failing.info.as_slice() {
            ["sweep", "fails"] => said("check", &failing.text)?,
            ["sweep", "fails", "compile"] => said("compile", &failing.text)?,
            #[cfg(unix)]
            ["console"] => console(failing)?,
            #[cfg(not(unix))]
            ["console"] => continue,
            other => return Err(format!("{code}: {other:?}").into()),
        };
        assert_eq!(
            codes(&printed),
            BTreeSet::from([code.as_str()]),
            "{printed}"
        );
        assert_eq!(sound, code.as_str().starts_with('W'), "{code}");
    }
    Ok(())
}

#[test]
fn the_other_example_is_sound() -> Outcome {
    for code in Code::ALL {
        let blocks = blocks(code.explanation());
        let [failing, sound] = blocks.as_slice() else {
            return Err(format!("{code} has {} examples", blocks.len()).into());
        };
        assert_ne!(failing.text, sound.text, "{code}");
        let runs = match sound.info.as_slice() {
            ["sweep"] => vec![said("check", &sound.text)?, said("compile", &sound.text)?],
            #[cfg(unix)]
            ["console"] => vec![console(sound)?],
            #[cfg(not(unix))]
            ["console"] => continue,
            other => return Err(format!("{code}: {other:?}").into()),
        };
        for own in runs {
            assert_eq!(own, (String::new(), true), "{code}");
        }
    }
    Ok(())
}

#[test]
fn pages_have_one_form() {
    for code in Code::ALL {
        let page = code.explanation();
        let headings: Vec<&str> = page.lines().filter(|line| line.starts_with('#')).collect();
        // A comment of an example begins with `#` too.
        let sections = headings.iter().filter(|line| line.starts_with("## "));
        let sections: Vec<&str> = sections.copied().collect();
        assert_eq!(
            page.lines().next(),
            Some(format!("# {code}: {}", code.title()).as_str())
        );
        assert!(
            sections == ["## Fails", "## Sound"]
                || sections == ["## Mathematics", "## Fails", "## Sound"],
            "{code}: {sections:?}"
        );
        let rule = page.split("\n## ").next().unwrap_or_default();
        assert!(rule.trim().lines().count() > 2, "{code} says nothing");
        assert!(page.ends_with("```\n"), "{code}");
        for line in page.lines() {
            assert!(line.chars().count() <= WIDTH, "{code}: {line}");
            assert_eq!(line.trim_end(), line, "{code}: {line}");
        }
    }
}

/// The words of a text that have the form of a code.
fn mentioned(text: &str) -> impl Iterator<Item = &str> {
    let words = text.split(|c: char| !c.is_ascii_alphanumeric());
    words.filter(|word| {
        word.len() == 5
            && word.starts_with(['E', 'W'])
            && word[1..].bytes().all(|byte| byte.is_ascii_digit())
    })
}

#[test]
fn pages_mention_codes_that_exist() {
    assert_eq!(
        mentioned("see E0201, (W1003)").collect::<Vec<_>>(),
        ["E0201", "W1003"]
    );
    for code in Code::ALL {
        for word in mentioned(code.explanation()) {
            let exists = Code::ALL.iter().any(|own| own.as_str() == word);
            assert!(exists, "{code} mentions {word}");
        }
    }
}

#[test]
fn every_page_belongs_to_a_code() -> Outcome {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/diag/explain");
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        files.push(entry?.file_name().to_string_lossy().into_owned());
    }
    files.sort();
    let mut pages: Vec<String> = Code::ALL.iter().map(|own| format!("{own}.md")).collect();
    pages.sort();
    assert_eq!(files, pages);
    Ok(())
}

/// Standard output, standard error and status of `sweepc explain`.
fn explain(arguments: &[&str]) -> Result<(String, String, Option<i32>), Box<dyn Error>> {
    let arguments = [&["explain"], arguments].concat();
    let output = run(Path::new("."), &arguments, "");
    let (out, err) = (
        String::from_utf8(output.stdout)?,
        String::from_utf8(output.stderr)?,
    );
    Ok((out, err, output.status.code()))
}

#[test]
fn the_command_prints_pages() -> Outcome {
    let (out, err, status) = explain(&["e0201"])?;
    assert_eq!(
        (out.as_str(), err.as_str()),
        (Code::E0201.explanation(), "")
    );
    assert_eq!(status, Some(0));

    let (out, _, status) = explain(&["W1003", "E0001"])?;
    let both = [Code::W1003.explanation(), Code::E0001.explanation()].join("\n");
    assert_eq!((out, status), (both, Some(0)));

    let (out, _, status) = explain(&["--color", "always", "E0201"])?;
    assert!(out.contains('\u{1b}') && !out.contains("```"), "{out}");
    assert_eq!(status, Some(0));
    Ok(())
}

#[test]
fn without_a_code_the_command_lists_all() -> Outcome {
    let (out, err, status) = explain(&[])?;
    assert_eq!((err.as_str(), status), ("", Some(0)));
    for code in Code::ALL {
        let line = format!("  {code}  {}\n", code.title());
        assert_eq!(out.matches(&line).count(), 1, "{line}");
        let group = format!("{}\n", code.group());
        assert_eq!(out.matches(&group).count(), 1, "{group}");
        assert!(out.find(&group) < out.find(&line), "{group} {line}");
    }
    Ok(())
}

#[test]
fn an_unknown_code_is_wrong_usage_and_shows_the_nearest() -> Outcome {
    for (word, near) in [
        ("E0291", "E0201"),
        ("0201", "E0201"),
        ("E201", "E0201"),
        ("pythagorean", "E0201"),
    ] {
        let (out, err, status) = explain(&[word])?;
        assert_eq!((out.as_str(), status), ("", Some(2)), "{word}");
        assert!(err.contains(near), "{err}");
    }
    let (out, _, status) = explain(&["E0201", "E9999"])?;
    assert_eq!((out.as_str(), status), ("", Some(2)));
    Ok(())
}

#[test]
fn a_run_with_findings_ends_with_one_hint() -> Outcome {
    let folder = TempDir::new()?;
    fs::write(folder.path().join("a.sweep"), "surface R = (u, v, w) + u\n")?;
    fs::write(folder.path().join("b.sweep"), "let a = 1,5\n")?;
    let output = run(folder.path(), &["check", "a.sweep", "b.sweep"], "");
    let printed = String::from_utf8(output.stderr)?;
    let hint = "for more: sweepc explain E0007 E0101";
    assert_eq!(printed.lines().last(), Some(hint), "{printed}");
    assert_eq!(printed.matches("for more").count(), 1);
    let output = run(folder.path(), &["check", "--format", "json", "a.sweep"], "");
    assert_eq!(output.stderr, b"");
    let output = run(folder.path(), &["compile", "b.sweep"], "");
    let printed = String::from_utf8(output.stderr)?;
    assert!(
        printed.ends_with("\nfor more: sweepc explain E0007\n"),
        "{printed}"
    );
    Ok(())
}
