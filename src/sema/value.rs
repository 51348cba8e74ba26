use crate::diag::Span;
use crate::sweep::Scalar;

/// The value of an expression, by its type.
#[derive(Debug, Clone)]
pub(super) enum Value {
    /// A number or a function of u and v.
    Scalar(Scalar),
    /// Two scalars, `(a, b)`.
    Pair([Scalar; 2]),
    /// A vector in space.
    Vector([Scalar; 3]),
    /// Three columns; it can only multiply a vector.
    Matrix(Box<[[Scalar; 3]; 3]>),
}

impl Value {
    /// The type, with its article.
    pub(super) fn type_name(&self) -> &'static str {
        match self {
            Self::Scalar(_) => "a scalar",
            Self::Pair(_) => "a pair",
            Self::Vector(_) => "a vector",
            Self::Matrix(_) => "a matrix",
        }
    }

    /// The components, in order.
    pub(super) fn components(&self) -> Vec<Scalar> {
        match self {
            Self::Scalar(own) => vec![own.clone()],
            Self::Pair(own) => own.to_vec(),
            Self::Vector(own) => own.to_vec(),
            Self::Matrix(columns) => columns.iter().flatten().cloned().collect(),
        }
    }

    /// Changes every component.
    pub(super) fn map(&self, mut change: impl FnMut(&Scalar) -> Scalar) -> Self {
        match self {
            Self::Scalar(own) => Self::Scalar(change(own)),
            Self::Pair([a, b]) => Self::Pair([change(a), change(b)]),
            Self::Vector([x, y, z]) => Self::Vector([change(x), change(y), change(z)]),
            Self::Matrix(columns) => Self::Matrix(Box::new(
                columns
                    .each_ref()
                    .map(|column| column.each_ref().map(&mut change)),
            )),
        }
    }

    /// a + b + … of one type; none if the types differ.
    pub(super) fn sum(span: Span, terms: &[Self]) -> Option<Self> {
        let add = |index: usize| {
            let parts = terms.iter().map(|term| term.components()[index].clone());
            Scalar::sum(span, parts.collect())
        };
        match terms.first()? {
            Self::Scalar(_) if terms.iter().all(|own| matches!(own, Self::Scalar(_))) => {
                Some(Self::Scalar(add(0)))
            }
            Self::Pair(_) if terms.iter().all(|own| matches!(own, Self::Pair(_))) => {
                Some(Self::Pair([add(0), add(1)]))
            }
            Self::Vector(_) if terms.iter().all(|own| matches!(own, Self::Vector(_))) => {
                Some(Self::Vector([add(0), add(1), add(2)]))
            }
            _ => None,
        }
    }
}
