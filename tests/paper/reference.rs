//! The reference values, and the field they are compared in.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde_json::Value;
use sweepc::check::Checked;
use sweepc::number::{Field, Real, Tower};

use crate::support::{self, Compiled};

const SURFACES: &str = include_str!("../../seeds/farouki-nittler/reference.json");
const INTERPOLANTS: &str = include_str!("../../seeds/farouki-neff/interpolants.json");

pub(crate) const NAMES: [&str; 4] = ["W", "X", "Y", "Z"];

pub(crate) fn surfaces() -> Value {
    serde_json::from_str(SURFACES).unwrap()
}

pub(crate) fn interpolants() -> Value {
    serde_json::from_str(INTERPOLANTS).unwrap()
}

/// The items of a list.
pub(crate) fn items(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

pub(crate) fn text(value: &Value) -> &str {
    value.as_str().unwrap()
}

/// The field of reference values inside a tower of ours: the products of its generators.
pub(crate) struct Embedding {
    products: Vec<Real>,
}

impl Embedding {
    /// Each generator is the positive root of its square, so there is one embedding into the reals,
    /// and the tower finds it. It grows if it does not hold the field.
    pub(crate) fn new(data: &Value, field: &str, tower: &Tower) -> Self {
        let squares = items(&data["fields"][field]).iter();
        Self::of(squares.map(text), Self::number, tower)
    }

    /// The same for generators that are listed as `{"name": "r1", "square": "2"}`.
    pub(crate) fn of_generators(list: &Value, tower: &Tower) -> Self {
        let squares = items(list).iter().map(|own| text(&own["square"]));
        Self::of(squares, Self::sum, tower)
    }

    fn of<'a>(
        squares: impl Iterator<Item = &'a str>,
        read: impl Fn(&Self, &str) -> Real,
        tower: &Tower,
    ) -> Self {
        let products = vec![Real::one()];
        squares.fold(Self { products }, |mut own, square| {
            let generator = tower.square_root(&read(&own, square)).unwrap();
            let further: Vec<Real> = own.products.iter().map(|one| one * &generator).collect();
            own.products.extend(further);
            own
        })
    }

    /// A number as a sum: `3/2 + 1/4*r1 - r1*r2`.
    pub(crate) fn sum(&self, sum: &str) -> Real {
        let terms = sum.replace(" - ", " + -");
        terms.split(" + ").fold(Real::zero(), |sum, term| {
            let (negative, term) = match term.strip_prefix('-') {
                Some(term) => (true, term),
                None => (false, term),
            };
            let product = term.split('*').fold(Real::one(), |product, factor| {
                let factor = match factor.strip_prefix('r') {
                    // The generators are the products 1, 2, 4, …
                    Some(index) => {
                        let index: usize = index.parse().unwrap();
                        self.products[1 << (index - 1)].clone()
                    }
                    None => factor.parse().unwrap(),
                };
                &product * &factor
            });
            if negative {
                &sum - &product
            } else {
                &sum + &product
            }
        })
    }

    /// The degree over ℚ.
    pub(crate) fn degree(&self) -> usize {
        self.products.len()
    }

    /// A number as a list of rationals over the products.
    pub(crate) fn number(&self, list: &str) -> Real {
        let list: Vec<Real> = list
            .split_whitespace()
            .map(|own| own.parse().unwrap())
            .collect();
        assert!(!list.is_empty() && list.len() <= self.degree(), "{list:?}");
        let pairs = list.iter().zip(&self.products);
        pairs.fold(Real::zero(), |sum, (own, product)| &sum + &(own * product))
    }

    pub(crate) fn numbers(&self, list: &Value) -> Vec<Real> {
        items(list)
            .iter()
            .map(|own| self.number(text(own)))
            .collect()
    }
}

/// The factor by which one list is the other, zeros at the same places; what differs otherwise.
pub(crate) fn ratio(ours: &[Real], theirs: &[Real]) -> Result<Real, String> {
    if ours.len() != theirs.len() {
        return Err(format!("{} numbers for {}", ours.len(), theirs.len()));
    }
    let first = theirs.iter().position(|own| !own.is_zero());
    let first = first.ok_or("nothing but zeros")?;
    for (index, (own, their)) in ours.iter().zip(theirs).enumerate() {
        if own * &theirs[first] != &ours[first] * their {
            return Err(format!("number {index} is {own} for {their}"));
        }
    }
    let factor = &ours[first] / &theirs[first];
    if factor.is_zero() {
        return Err("nothing but zeros".to_owned());
    }
    Ok(factor)
}

/// Whether a number has these digits, to the last one.
pub(crate) fn has_digits(number: &Real, decimal: &str) -> bool {
    match decimal.split_once('.') {
        Some((_, digits)) => number.decimal(u32::try_from(digits.len()).unwrap()) == decimal,
        None => decimal == "0" && number.is_zero(),
    }
}

/// The path of an example of the paper.
fn path(file: &str) -> PathBuf {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    root.join("examples/paper").join(format!("{file}.sweep"))
}

/// The examples of the paper, compiled as they stand.
#[derive(Default)]
pub(crate) struct Examples {
    files: BTreeMap<String, Compiled>,
}

impl Examples {
    /// The compilation that holds a case, and its surface.
    pub(crate) fn case(&mut self, case: &Value) -> (&Compiled, &Checked) {
        let (file, name) = (text(&case["file"]), text(&case["surface"]));
        let compiled = self.files.entry(file.to_owned()).or_insert_with(|| {
            let text = std::fs::read_to_string(path(file)).unwrap();
            support::compile(&text)
        });
        let mut surfaces = compiled.compilation.surfaces.iter().flatten();
        let surface = surfaces.find(|own| own.name() == name);
        let surface = surface.unwrap_or_else(|| panic!("{file} {name}\n{}", compiled.all()));
        (compiled, surface)
    }
}

#[test]
fn numbers_are_read_over_their_products() {
    let (data, tower) = (surfaces(), Tower::default());
    let field = Embedding::new(&data, "K", &tower);
    let [two, other] = [field.number("0 1"), field.number("0 0 1")];
    assert_eq!(&two * &two, Real::from(2));
    assert_eq!(&other * &other, field.number("-35 40"));
    assert!(two.sign().is_gt() && other.sign().is_gt());
    assert_eq!(field.number("0 0 0 1"), &two * &other);
    let sum = field.number("-1/2 -1 0 3/4");
    assert_eq!(field.sum("-1/2 - r1 + 3/4*r1*r2"), sum);
    assert_eq!((field.degree(), tower.degree()), (4, 4));
}

#[test]
fn what_is_not_proportional_is_noticed() {
    let list = |numbers: &[i64]| -> Vec<Real> { numbers.iter().copied().map(Real::from).collect() };
    assert_eq!(ratio(&list(&[0, 2, -6]), &list(&[0, 1, -3])), Ok(2.into()));
    for theirs in [
        &[0, 1, -4][..],
        &[1, 1, -3],
        &[0, 1, 0],
        &[0, 1],
        &[0, 0, 0],
    ] {
        assert!(ratio(&list(&[0, 2, -6]), &list(theirs)).is_err());
    }
    assert!(ratio(&list(&[0, 0]), &list(&[1, 2])).is_err());
    assert!(has_digits(&Real::ratio(2.into(), 3.into()), "0.667"));
    assert!(!has_digits(&Real::ratio(2.into(), 3.into()), "0.666"));
    assert!(!has_digits(&Real::from(1), "0"));
}
