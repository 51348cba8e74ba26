use crate::syntax::canonical_name;
use crate::syntax::lexer::TokenKind;

/// Which spelling of a name with two spellings is written: `σ` or `sigma`, `κ` or `kappa`, `ρ` or
/// `rho`; between the intervals of a domain `×` or `x`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Spelling {
    /// The one in the text.
    #[default]
    AsWritten,
    /// Latin letters where there are any.
    Ascii,
    /// Greek letters.
    Unicode,
}

/// The names with a Latin spelling.
const LATIN: [(&str, &str); 3] = [("σ", "sigma"), ("κ", "kappa"), ("ρ", "rho")];

impl Spelling {
    /// How a token is written.
    pub(super) fn token(self, kind: TokenKind, written: &str) -> String {
        match kind {
            TokenKind::Name => self.name(written),
            TokenKind::Number => written.replace('−', "-"),
            TokenKind::Minus => "-".to_owned(),
            TokenKind::Star => "*".to_owned(),
            TokenKind::Prime => "'".to_owned(),
            TokenKind::DoublePrime => "''".to_owned(),
            _ => written.to_owned(),
        }
    }

    /// How the sign between the two intervals of a domain is written.
    pub(super) fn times(self, written: &str) -> String {
        match self {
            Spelling::AsWritten => written.to_owned(),
            Spelling::Ascii => "x".to_owned(),
            Spelling::Unicode => "×".to_owned(),
        }
    }

    fn name(self, written: &str) -> String {
        if self == Spelling::AsWritten {
            return written.to_owned();
        }
        let canonical = canonical_name(written);
        let latin = LATIN.iter().find(|(greek, _)| *greek == canonical);
        match latin {
            Some((_, latin)) if self == Spelling::Ascii => (*latin).to_owned(),
            _ => canonical,
        }
    }
}
