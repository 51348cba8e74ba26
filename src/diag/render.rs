use std::borrow::Cow;

use annotate_snippets::{AnnotationKind, Group, Level, Patch, Renderer, Snippet};
use serde::Serialize;

use super::clipped::clipped;
use super::preview::Preview;
use super::{Diagnostic, Severity, SourceMap, Span};

/// How findings are drawn on a terminal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Style {
    /// Text only.
    #[default]
    Plain,
    /// With ANSI colours.
    Coloured,
}

/// A finding with its excerpt of the source, ending in a line feed.
#[must_use]
pub fn render_text(diagnostic: &Diagnostic, sources: &SourceMap, style: Style) -> String {
    let level = match diagnostic.severity() {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let title = level
        .primary_title(clipped(&diagnostic.message))
        .id(diagnostic.code.as_str());
    let mut main = Group::with_title(title);
    if let Some(primary) = diagnostic.primary {
        for (file, marks) in marks_by_file(diagnostic, primary) {
            let source = sources.file(file);
            let text = with_line_feeds(&source.text);
            let mut snippet = Snippet::source(text).path(source.name.as_str());
            for (span, kind, label) in marks {
                let range = visible(span, &source.text);
                let mark = kind.span(range);
                snippet = snippet.annotation(if label.is_empty() {
                    mark
                } else {
                    mark.label(clipped(label))
                });
            }
            main = main.element(snippet);
        }
    }
    for note in &diagnostic.notes {
        main = main.element(Level::NOTE.message(clipped(note)));
    }
    let mut groups = Vec::new();
    match (&diagnostic.fix, &diagnostic.help) {
        (Some(fix), help) => {
            let text = &sources.file(fix.span.file).text;
            let change = visible(fix.span, text);
            let preview = Preview::of(with_line_feeds(text), change, &fix.text);
            let patch = Patch::new(preview.change, preview.replacement);
            let lines = Snippet::source(preview.text).line_start(preview.first);
            let title = help.clone().unwrap_or_else(|| words(&fix.text));
            let title = Level::HELP.secondary_title(clipped(&title).into_owned());
            groups.push(Group::with_title(title).element(lines.patch(patch)));
        }
        (None, Some(help)) => main = main.element(Level::HELP.message(clipped(help))),
        (None, None) => {}
    }
    groups.insert(0, main);
    let renderer = match style {
        Style::Plain => Renderer::plain(),
        Style::Coloured => Renderer::styled(),
    };
    let mut text = renderer.render(&groups).to_string();
    text.push('\n');
    text
}

/// What an edit says of itself: a short text is told, a longer one is seen in the excerpt.
fn words(edit: &str) -> String {
    match edit.trim() {
        "" => "remove this".to_owned(),
        own if own.contains(['\n', '\r']) || own.chars().count() > 40 => "write".to_owned(),
        own => format!("write `{own}`"),
    }
}

/// The text with a line feed for every CR that ends a line alone, byte for byte as long.
fn with_line_feeds(text: &str) -> Cow<'_, str> {
    let is_lone = |(at, _): &(usize, &str)| text.as_bytes().get(at + 1) != Some(&b'\n');
    if !text.match_indices('\r').any(|own| is_lone(&own)) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for line in text.split_inclusive('\r') {
        let ended = shown.len() + line.len();
        match line.strip_suffix('\r') {
            Some(rest) if text.as_bytes().get(ended) != Some(&b'\n') => {
                shown.push_str(rest);
                shown.push('\n');
            }
            _ => shown.push_str(line),
        }
    }
    Cow::Owned(shown)
}

type Mark<'a> = (Span, AnnotationKind, &'a str);

/// The primary mark first, then the related ones, gathered file by file.
fn marks_by_file(diagnostic: &Diagnostic, primary: Span) -> Vec<(super::FileId, Vec<Mark<'_>>)> {
    let mut files: Vec<(super::FileId, Vec<Mark<'_>>)> = vec![(
        primary.file,
        vec![(primary, AnnotationKind::Primary, diagnostic.label.as_str())],
    )];
    for (span, remark) in &diagnostic.related {
        let mark = (*span, AnnotationKind::Context, remark.as_str());
        match files.iter_mut().find(|(file, _)| *file == span.file) {
            Some((_, marks)) => marks.push(mark),
            None => files.push((span.file, vec![mark])),
        }
    }
    files
}

/// The span as a range inside the text, on character boundaries.
fn visible(span: Span, text: &str) -> std::ops::Range<usize> {
    let snap = |mut offset: usize| {
        offset = offset.min(text.len());
        while !text.is_char_boundary(offset) {
            offset -= 1;
        }
        offset
    };
    let start = snap(span.start as usize);
    start..snap(span.end as usize).max(start)
}

#[derive(Serialize)]
struct JsonSpan {
    start: u32,
    end: u32,
    line: usize,
    column: usize,
}

#[derive(Serialize)]
struct JsonFix<'a> {
    span: JsonSpan,
    text: &'a str,
}

#[derive(Serialize)]
struct JsonDiagnostic<'a> {
    code: &'a str,
    severity: &'a str,
    message: &'a str,
    file: Option<&'a str>,
    span: Option<JsonSpan>,
    notes: Vec<String>,
    fix: Option<JsonFix<'a>>,
}

/// A finding as one line of JSON, without the line feed. What the text shows beside the marks
/// comes first among its notes, the help line last.
#[must_use]
pub fn render_json(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let place = |span: Span| {
        let (line, column) = sources.position(span);
        JsonSpan {
            start: span.start,
            end: span.end,
            line,
            column,
        }
    };
    let related = diagnostic.related.iter().map(|(span, remark)| {
        let (line, column) = sources.position(*span);
        format!("{}:{line}:{column}: {remark}", sources.file(span.file).name)
    });
    let label = (!diagnostic.label.is_empty()).then(|| diagnostic.label.clone());
    let notes = label.into_iter().chain(related);
    let notes = notes.chain(diagnostic.notes.iter().chain(&diagnostic.help).cloned());
    let notes = notes.map(|own| clipped(&own).into_owned());
    let object = JsonDiagnostic {
        code: diagnostic.code.as_str(),
        severity: match diagnostic.severity() {
            Severity::Error => "error",
            Severity::Warning => "warning",
        },
        message: &clipped(&diagnostic.message),
        file: diagnostic
            .primary
            .map(|span| sources.file(span.file).name.as_str()),
        span: diagnostic.primary.map(place),
        notes: notes.collect(),
        fix: diagnostic.fix.as_ref().map(|fix| JsonFix {
            span: place(fix.span),
            text: &fix.text,
        }),
    };
    serde_json::to_string(&object).unwrap_or_default()
}
