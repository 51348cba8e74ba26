use crate::diag::Diagnostic;

/// What formats refuse or warn of: formats that find the same have one finding, which names them.
#[derive(Debug, Default)]
pub(super) struct FormatFindings {
    list: Vec<(Diagnostic, Vec<&'static str>)>,
}

impl FormatFindings {
    /// Adds what a format finds.
    pub(super) fn add(&mut self, format: &'static str, finding: Diagnostic) {
        let same = |own: &&mut (Diagnostic, _)| {
            let own = &own.0;
            (own.code, own.primary, &own.message)
                == (finding.code, finding.primary, &finding.message)
        };
        match self.list.iter_mut().find(same) {
            Some((_, formats)) if formats.last() == Some(&format) => {}
            Some((_, formats)) => formats.push(format),
            None => self.list.push((finding, vec![format])),
        }
    }

    /// The formats that find something.
    pub(super) fn formats(&self) -> impl Iterator<Item = &'static str> {
        self.list.iter().flat_map(|(_, formats)| formats).copied()
    }

    /// The findings. What comes of them is said with the names of the formats.
    pub(super) fn findings(self, outcome: &str) -> impl Iterator<Item = Diagnostic> {
        self.list.into_iter().map(move |(finding, formats)| {
            let formats: Vec<_> = formats.iter().map(|own| format!("`{own}`")).collect();
            finding.note(format!("{outcome}: {}", formats.join(", ")))
        })
    }
}
