/// What is known of a statement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    /// It is true, because of this.
    Proven(String),
    /// It is false, as this shows.
    Refuted(String),
    /// It was not decided, for this reason.
    Undecided(String),
}

impl Verdict {
    /// True, false, or none if it is undecided.
    #[must_use]
    pub fn holds(&self) -> Option<bool> {
        match self {
            Self::Proven(_) => Some(true),
            Self::Refuted(_) => Some(false),
            Self::Undecided(_) => None,
        }
    }

    /// The evidence, the witness or the reason.
    #[must_use]
    pub fn because(&self) -> &str {
        match self {
            Self::Proven(why) | Self::Refuted(why) | Self::Undecided(why) => why,
        }
    }
}
