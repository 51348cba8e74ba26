/// How a name with a parenthesis behind it is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// The name applies to what stands in the parenthesis.
    Application,
    /// The name multiplies it; a `*` is written.
    Product,
    /// Either, as far as is known: it stays as it is written.
    Unknown,
}
