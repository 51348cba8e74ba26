/// What input may ask for at most. Every limit is reached with an `E05xx` error that names its flag.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of one source file (`--max-source`).
    pub source: usize,
    /// Depth of brackets, signs and calls (`--max-nesting`).
    pub nesting: usize,
    /// Digits of one number (`--max-digits`).
    pub digits: usize,
    /// Absolute value of an exponent (`--max-exponent`).
    pub exponent: u32,
    /// Predicted degree of a polynomial in one parameter (`--max-degree`).
    pub degree: usize,
    /// Predicted number of terms of a polynomial (`--max-terms`).
    pub terms: usize,
    /// Bits of one coefficient (`--max-bits`).
    pub bits: u64,
    /// Degree over the rationals of the field of all numbers (`--max-field-degree`).
    pub field_degree: usize,
    /// Triangles of a mesh (`--max-triangles`).
    pub triangles: usize,
    /// Imported files (`--max-imports`).
    pub imports: usize,
    /// Variants of a run (`--max-variants`).
    pub variants: usize,
    /// Syntax errors reported for one file.
    pub syntax_errors: usize,
}

impl Limits {
    /// The most bytes that a source file may have: as many as spans can count, however high the
    /// limit is set.
    #[must_use]
    pub fn largest_source(&self) -> usize {
        self.source.min(u32::MAX as usize - 1)
    }
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            source: 16 << 20,
            nesting: 256,
            digits: 100_000,
            exponent: 4_096,
            degree: 500,
            terms: 1_000_000,
            bits: 1_000_000,
            field_degree: 64,
            triangles: 1_000_000,
            imports: 256,
            variants: 100_000,
            syntax_errors: 50,
        }
    }
}
