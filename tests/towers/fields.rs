//! Towers to try the laws on, and numbers in them that are known twice: exactly, and as balls.

use std::sync::OnceLock;

use num_bigint::BigInt;
use proptest::prelude::*;
use sweepc::number::{Field as _, Rational, Surd, Tower};

use crate::ball::Ball;

/// A number by two roads.
#[derive(Clone, Debug)]
pub(crate) struct Number {
    pub(crate) exact: Surd,
    pub(crate) ball: Ball,
}

impl Number {
    pub(crate) fn ratio(numerator: BigInt, denominator: BigInt) -> Self {
        Self {
            ball: Ball::ratio(&numerator, &denominator),
            exact: Surd::ratio(numerator.into(), denominator.into()),
        }
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self {
            exact: &self.exact + &other.exact,
            ball: self.ball.plus(&other.ball),
        }
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self {
            exact: &self.exact - &other.exact,
            ball: self.ball.minus(&other.ball),
        }
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        Self {
            exact: &self.exact * &other.exact,
            ball: self.ball.times(&other.ball),
        }
    }

    /// a/b; none for b = 0, which the ball decides.
    pub(crate) fn over(&self, other: &Self) -> Option<Self> {
        other.ball.sign().is_ne().then(|| Self {
            exact: &self.exact / &other.exact,
            ball: self.ball.times(&other.ball.inverse()),
        })
    }

    /// √|a|; none if the field would be too large.
    pub(crate) fn root(&self, tower: &Tower) -> Option<Self> {
        let (exact, ball) = match self.ball.sign() {
            std::cmp::Ordering::Equal => return Some(self.clone()),
            std::cmp::Ordering::Less => (-&self.exact, self.ball.negated()),
            std::cmp::Ordering::Greater => (self.exact.clone(), self.ball.clone()),
        };
        Some(Self {
            exact: tower.square_root(&exact).ok()?,
            ball: ball.root(),
        })
    }

    pub(crate) fn power(&self, exponent: u32) -> Self {
        Self {
            exact: self.exact.power(exponent.into()).unwrap(),
            ball: self.ball.power(exponent),
        }
    }
}

/// Radicals in reverse Polish notation, `r` for the root: independent, dependent, nested, nearly
/// degenerate.
const FIELDS: [&str; 20] = [
    "",
    "2 r",
    "3 4 / r",
    "2 r ; 3 r",
    "2 r ; 3 r ; 6 r ; 8 27 / r",
    "6 r ; 5 6 r 2 * + r",
    "6 r ; 5 6 r 2 * - r ; 2 r",
    "2 r 40 * 35 - r",
    "2 r ; 2 2 r + r",
    "5 r ; 10 5 r 2 * - r",
    "2 r r r",
    "1000000000000000000000000000057 r ; 2 r",
    "1 1000000000000000000000000000000000000003 / r",
    "2 r 1 - 31 ^ r",
    "7 r ; 7 r 2 - 9 ^ r",
    "2 r ; 2 2 r + r ; 2 2 2 r + r + r",
    "2 r ; 3 r ; 2 r 3 r + r",
    "3 r ; 3 r 1 - r ; 3 r 1 + r",
    "2 r ; 3 r ; 5 r ; 7 r",
    "2 r ; 3 r ; 1 2 r + 3 r + r ; 6 r 7 + r",
];

/// The fields of degree at most 8 come first.
pub(crate) const SMALL_FIELDS: usize = 15;

/// A tower and its radicals.
#[derive(Debug)]
pub(crate) struct Field {
    pub(crate) tower: Tower,
    pub(crate) radicals: Vec<Number>,
    /// The products of radicals, by their sets.
    products: Vec<Number>,
}

/// The fields, each built once.
pub(crate) fn field(index: usize) -> &'static Field {
    static ALL: OnceLock<Vec<Field>> = OnceLock::new();
    let all = ALL.get_or_init(|| FIELDS.iter().map(|text| Field::new(text)).collect());
    &all[index % all.len()]
}

impl Field {
    pub(crate) fn new(text: &str) -> Self {
        let tower = Tower::new(1 << 16);
        let parts = text.split(';').filter(|part| !part.trim().is_empty());
        let radicals: Vec<_> = parts.map(|part| read(part, &tower)).collect();
        let mut products = vec![Number::ratio(1.into(), 1.into())];
        for own in &radicals {
            let with: Vec<_> = products.iter().map(|product| product.times(own)).collect();
            products.extend(with);
        }
        Self {
            tower,
            radicals,
            products,
        }
    }

    pub(crate) fn number(&self, spec: &Spec) -> Number {
        match spec {
            Spec::Sum(terms) => {
                let zero = Number::ratio(0.into(), 1.into());
                terms
                    .iter()
                    .fold(zero, |sum, (numerator, denominator, set)| {
                        let own = Number::ratio((*numerator).into(), (*denominator).into());
                        sum.plus(&own.times(&self.products[*set % self.products.len()]))
                    })
            }
            Spec::Tiny(index, exponent) => {
                let Some(own) = self.radicals.get(*index % self.radicals.len().max(1)) else {
                    return Number::ratio(1.into(), BigInt::from(3).pow(*exponent));
                };
                // a − ⌊a⌋ is less than 1 in absolute value, and its conjugates are not.
                let floor = own.exact.decide(|value| {
                    let (numerator, denominator) = value.parts();
                    numerator.div_floor(denominator)
                });
                let rest = own.minus(&Number::ratio((&floor).into(), 1.into()));
                // Nearly integers are small enough at once.
                let large = Number::ratio(1.into(), 1_000.into());
                if large.minus(&rest).ball.sign().is_gt() {
                    return rest.power(*exponent % 4 + 1);
                }
                rest.power(*exponent)
            }
        }
    }

    /// The rational number in the place of one of the field.
    pub(crate) fn rational(&self, spec: &Spec) -> Rational {
        match spec {
            Spec::Sum(terms) => terms.iter().fold(Rational::zero(), |sum, term| {
                &sum + &Rational::new(term.0.into(), term.1.into())
            }),
            Spec::Tiny(_, exponent) => {
                Rational::new(1.into(), BigInt::from(3).pow(*exponent).into())
            }
        }
    }
}

fn read(text: &str, tower: &Tower) -> Number {
    let mut stack: Vec<Number> = Vec::new();
    for token in text.split_whitespace() {
        let own = if let Ok(value) = token.parse::<BigInt>() {
            Number::ratio(value, 1.into())
        } else if token == "r" {
            stack.pop().unwrap().root(tower).unwrap()
        } else {
            let (right, left) = (stack.pop().unwrap(), stack.pop().unwrap());
            match token {
                "+" => left.plus(&right),
                "-" => left.minus(&right),
                "*" => left.times(&right),
                "/" => left.over(&right).unwrap(),
                _ => left.power(right.exact.to_i64().unwrap().try_into().unwrap()),
            }
        };
        stack.push(own);
    }
    stack.pop().unwrap()
}

/// A number of any field.
#[derive(Clone, Debug)]
pub(crate) enum Spec {
    /// Σ n/d times the product of a set of radicals.
    Sum(Vec<(i64, i64, usize)>),
    /// (a − ⌊a⌋)ⁿ for a radical a.
    Tiny(usize, u32),
}

impl Spec {
    /// The sum with another sign of the products with the first radical.
    pub(crate) fn conjugate(&self) -> Self {
        match self {
            Self::Sum(terms) => Self::Sum(
                terms
                    .iter()
                    .map(|&(n, d, set)| (if set % 2 == 1 { -n } else { n }, d, set))
                    .collect(),
            ),
            Self::Tiny(..) => self.clone(),
        }
    }
}

/// Numbers with a taste for 0, ±1, rational ones, and large denominators.
pub(crate) fn number() -> impl Strategy<Value = Spec> {
    let small = || (-3_i64..=3, 1_i64..=3, 0_usize..16);
    let coefficient = prop_oneof![
        4 => -9_i64..=9,
        1 => any::<i32>().prop_map(i64::from),
        1 => any::<i64>().prop_map(|own| own.max(-i64::MAX)),
    ];
    let denominator = prop_oneof![4 => 1_i64..=12, 1 => 1..i64::MAX, 1 => Just(1 << 40)];
    let sum = |terms: Vec<_>| Spec::Sum(terms);
    prop_oneof![
        1 => Just(Spec::Sum(Vec::new())),
        1 => prop::sample::select(vec![-1_i64, 1]).prop_map(|one| Spec::Sum(vec![(one, 1, 0)])),
        2 => (-9_i64..=9, 1_i64..=9).prop_map(|(n, d)| Spec::Sum(vec![(n, d, 0)])),
        2 => (-9_i64..=9, 0_usize..16).prop_map(|(n, set)| Spec::Sum(vec![(n, 1, set)])),
        5 => prop::collection::vec(small(), 1..4).prop_map(sum),
        2 => prop::collection::vec(small(), 4..10).prop_map(sum),
        2 => prop::collection::vec((coefficient, denominator, 0_usize..16), 1..5).prop_map(sum),
        1 => (0_usize..4, 1_u32..40).prop_map(|(index, power)| Spec::Tiny(index, power)),
    ]
}

/// Small numbers of few terms, for what grows.
pub(crate) fn small_number() -> impl Strategy<Value = Spec> {
    let term = (-3_i64..=3, 1_i64..=2, 0_usize..16);
    prop_oneof![
        1 => Just(Spec::Sum(Vec::new())),
        2 => (-3_i64..=3).prop_map(|n| Spec::Sum(vec![(n, 1, 0)])),
        3 => prop::collection::vec(term, 1..3).prop_map(Spec::Sum),
    ]
}

/// Three numbers of one field: free, equal, opposite, conjugate.
pub(crate) fn triple() -> impl Strategy<Value = (usize, [Spec; 3])> {
    let numbers = (number(), number(), number());
    (0..FIELDS.len(), numbers, 0..8_u8).prop_map(|(index, (a, b, c), relation)| {
        let b = match relation {
            0 => a.clone(),
            1 | 2 => a.conjugate(),
            3 => match &a {
                Spec::Sum(terms) => {
                    Spec::Sum(terms.iter().map(|&(n, d, set)| (-n, d, set)).collect())
                }
                Spec::Tiny(..) => a.clone(),
            },
            _ => b,
        };
        (index, [a, b, c])
    })
}
