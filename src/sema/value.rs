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

    /// How many expressions are nested in its components at most.
    pub(super) fn depth(&self) -> usize {
        let deepest = |own: &[Scalar]| own.iter().map(Scalar::depth).max().unwrap_or(0);
        match self {
            Self::Scalar(own) => own.depth(),
            Self::Pair(own) => deepest(own),
            Self::Vector(own) => deepest(own),
            Self::Matrix(columns) => columns.iter().map(|own| deepest(own)).max().unwrap_or(0),
        }
    }

    /// a + b + … of one type; none if the types differ.
    pub(super) fn sum(span: Span, terms: &[Self]) -> Option<Self> {
        fn add<'a, const N: usize>(
            span: Span,
            terms: &'a [Value],
            of: impl Fn(&'a Value) -> Option<[&'a Scalar; N]>,
        ) -> Option<[Scalar; N]> {
            let rows: Option<Vec<[&Scalar; N]>> = terms.iter().map(of).collect();
            let rows = rows?;
            Some(std::array::from_fn(|index| {
                let parts = rows.iter().map(|row| row[index].clone());
                Scalar::sum(span, parts.collect())
            }))
        }
        match terms.first()? {
            Self::Scalar(_) => {
                let sum = add(span, terms, |own| match own {
                    Self::Scalar(own) => Some([own]),
                    _ => None,
                });
                sum.map(|[own]| Self::Scalar(own))
            }
            Self::Pair(_) => add(span, terms, |own| match own {
                Self::Pair(own) => Some(own.each_ref()),
                _ => None,
            })
            .map(Self::Pair),
            Self::Vector(_) => add(span, terms, |own| match own {
                Self::Vector(own) => Some(own.each_ref()),
                _ => None,
            })
            .map(Self::Vector),
            Self::Matrix(_) => None,
        }
    }
}
