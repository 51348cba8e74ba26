use crate::diag::Span;

use super::Scalar;

/// What a file expects of its surfaces and numbers.
#[derive(Debug, Clone)]
pub struct Expectation {
    /// The text, as written behind `expect`.
    pub text: String,
    /// Where it stands.
    pub span: Span,
    /// The surfaces that it speaks of, by index.
    pub surfaces: Vec<usize>,
    /// What is claimed.
    pub claim: Claim,
}

/// A claim about surfaces; they are named by their index.
#[derive(Debug, Clone)]
pub enum Claim {
    /// Two quantities compare.
    Comparison {
        /// The left side.
        left: Quantity,
        /// How they compare.
        relation: Relation,
        /// The right side.
        right: Quantity,
    },
    /// A surface has a quality.
    Quality {
        /// Which.
        quality: Quality,
        /// Of which surface.
        surface: usize,
    },
}

/// How two quantities compare.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
}

impl Relation {
    /// Whether the relation holds between values that compare so.
    #[must_use]
    pub fn holds(self, ordering: std::cmp::Ordering) -> bool {
        match self {
            Self::Equal => ordering.is_eq(),
            Self::NotEqual => ordering.is_ne(),
            Self::Less => ordering.is_lt(),
            Self::LessOrEqual => ordering.is_le(),
            Self::Greater => ordering.is_gt(),
            Self::GreaterOrEqual => ordering.is_ge(),
        }
    }

    /// Whether it orders its sides.
    #[must_use]
    pub fn is_order(self) -> bool {
        !matches!(self, Self::Equal | Self::NotEqual)
    }
}

/// A side of a comparison.
#[derive(Debug, Clone)]
pub enum Quantity {
    /// `bidegree(R)`, or of W, X, Y, Z by index.
    BiDegree {
        /// The surface.
        surface: usize,
        /// 0 for W, … 3 for Z; none for the patch.
        coordinate: Option<usize>,
    },
    /// `common_factor(R)`
    CommonFactor {
        /// The surface.
        surface: usize,
    },
    /// A scalar, a pair or a vector, by its components.
    Value(Vec<Scalar>),
}

/// A quality that a surface has or has not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quality {
    /// The offsets are rational in the same parameters.
    RationalOffset,
    /// All weights of the net have one sign.
    PositiveWeights,
    /// R_u × R_v is nowhere zero on the domain.
    Regular,
}
