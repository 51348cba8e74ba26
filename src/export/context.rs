use crate::number::Unit;

/// What a file says beside the net.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Context<'a> {
    /// The name of the surface in the source.
    pub surface: &'a str,
    /// The name of the source file without its extension.
    pub stem: &'a str,
    /// What the number 1 means as a length.
    pub unit: Unit,
    /// Whether weights may differ by any factor, not only by
    /// [10⁶](Context::GREATEST_WEIGHT_RATIO).
    pub any_weight_ratio: bool,
}

impl<'a> Context<'a> {
    /// The quotient of the greatest weight by the least above which kernels lose accuracy.
    pub const GREATEST_WEIGHT_RATIO: i64 = 1_000_000;

    /// A surface of a file, in millimetres.
    #[must_use]
    pub fn new(stem: &'a str, surface: &'a str) -> Self {
        Self {
            surface,
            stem,
            unit: Unit::default(),
            any_weight_ratio: false,
        }
    }
}
