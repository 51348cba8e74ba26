/// A unit of length: what the number 1 means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Unit {
    /// 10⁻³ m
    #[default]
    Millimetre,
    /// 10⁻² m
    Centimetre,
    /// 1 m
    Metre,
    /// 25.4 mm
    Inch,
}

impl Unit {
    /// The units.
    pub const ALL: [Self; 4] = [Self::Millimetre, Self::Centimetre, Self::Metre, Self::Inch];

    /// The unit of a symbol: `mm`, `cm`, `m` or `inch`.
    #[must_use]
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.symbol() == symbol)
    }

    /// The symbol.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "inch",
        }
    }
}
