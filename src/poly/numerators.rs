use std::borrow::Cow;
use std::cell::OnceCell;
use std::fmt;
use std::ops::Deref;
use std::rc::Rc;

use crate::number::{Integer, MachineList, Place, Ring, gcd};

/// A list of numerators over one denominator, in the form that suits them; it is read as a slice.
///
/// Canonical but for products: machine numbers are always held as such.
#[derive(Clone)]
pub struct Numerators<R>(Form<R>);

#[derive(Clone)]
enum Form<R> {
    Machine(Machine<R>),
    /// Of which one is longer than a machine number, or irrational.
    Ring(Rc<Vec<R>>),
    Product(Rc<Lazy<R>>),
}

/// Machine numbers, as elements of the ring for those who ask for such.
struct Machine<R> {
    list: MachineList,
    elements: OnceCell<Vec<R>>,
}

/// A product, multiplied out for those who ask for its coefficients.
struct Lazy<R> {
    product: Product<R>,
    list: OnceCell<Vec<R>>,
}

/// f g / d for polynomials over the integers, of which none is 0, and a divisor of their contents.
pub(super) struct Product<R> {
    pub(super) left: Numerators<R>,
    pub(super) right: Numerators<R>,
    pub(super) divisor: Integer,
}

impl<R: Ring> Numerators<R> {
    /// f g / d, multiplied out when the coefficients are asked for.
    pub(super) fn product(left: Self, right: Self, divisor: Integer) -> Self {
        Self(Form::Product(Rc::new(Lazy {
            product: Product {
                left,
                right,
                divisor,
            },
            list: OnceCell::new(),
        })))
    }

    /// The product that is not multiplied out yet.
    #[inline]
    pub(super) fn factors(&self) -> Option<&Product<R>> {
        match &self.0 {
            Form::Product(own) if own.list.get().is_none() => Some(&own.product),
            _ => None,
        }
    }

    /// The numbers, if all are machine numbers.
    #[must_use]
    #[inline]
    pub fn machine(&self) -> Option<&MachineList> {
        match &self.0 {
            Form::Machine(own) => Some(&own.list),
            _ => None,
        }
    }

    #[inline]
    pub(super) fn len(&self) -> usize {
        match &self.0 {
            Form::Machine(own) => own.list.len(),
            Form::Ring(own) => own.len(),
            Form::Product(own) => own.product.len(),
        }
    }

    /// The coefficient of the lowest power; none for an empty list.
    pub(super) fn first(&self) -> Option<Cow<'_, R>> {
        self.end(|_| 0)
    }

    /// The coefficient of the highest power; none for an empty list.
    pub(super) fn last(&self) -> Option<Cow<'_, R>> {
        self.end(|last| last)
    }

    /// One of them, without the others as elements of the ring.
    #[must_use]
    pub fn at(&self, index: usize) -> Cow<'_, R> {
        match self.machine() {
            Some(own) => Cow::Owned(R::from_integer(&Integer::from(own.numbers().at(index)))),
            None => Cow::Borrowed(&self[index]),
        }
    }

    /// The coefficient at an end, which a product has from those of its factors; the place is told
    /// from the last one.
    fn end(&self, place: fn(usize) -> usize) -> Option<Cow<'_, R>> {
        let last = self.len().checked_sub(1)?;
        let Some(own) = self.factors() else {
            return Some(self.at(place(last)));
        };
        let (left, right) = (own.left.end(place)?, own.right.end(place)?);
        Some(Cow::Owned(left.times(&right).divided(&own.divisor)))
    }

    /// Whether all are rational integers.
    #[inline]
    pub(super) fn is_rational(&self) -> bool {
        match &self.0 {
            Form::Machine(_) | Form::Product(_) => true,
            Form::Ring(own) => own.iter().all(|own| own.height() == 0),
        }
    }

    /// The greatest integer that divides all of them, and a given one.
    pub(super) fn content_with(&self, with: &Integer) -> Integer {
        if with.is_one() {
            return Integer::from(1);
        }
        if let (Some(own), Some(with)) = (self.machine(), with.machine()) {
            return own.content_with(with.unsigned_abs()).into();
        }
        if let Some(own) = self.factors() {
            // Gauss's lemma
            let zero = <Integer as Ring>::zero();
            let [left, right] = [&own.left, &own.right].map(|own| own.content_with(&zero));
            return gcd(with, &(left * right / &own.divisor));
        }
        let mut common = with.clone();
        for own in self.iter().rev() {
            if common.is_one() {
                break;
            }
            common = own.content_with(&common);
        }
        common
    }

    /// All divided by an integer that divides them, and is not 0.
    pub(super) fn over(self, divisor: &Integer) -> Self {
        if divisor.is_one() {
            self
        } else {
            self.times_ratio(R::unit(), divisor)
        }
    }

    /// All divided by an integer that divides them, times a rational integer; neither is 0.
    #[must_use]
    pub fn times_ratio(&self, factor: &R, divisor: &Integer) -> Self {
        if factor.is_one() && divisor.is_one() {
            return self.clone();
        }
        let machine = factor.as_integer().and_then(Integer::machine);
        if let (Some(list), Some(factor), Some(divisor)) =
            (self.machine(), machine, divisor.machine())
            && let Some(scaled) = list.times_ratio(factor, divisor)
        {
            return scaled.into();
        }
        if self.factors().is_some() {
            let factor = if Ring::sign(divisor).is_lt() {
                factor.negated()
            } else {
                factor.clone()
            };
            return Self::product(self.clone(), vec![factor].into(), divisor.abs());
        }
        let list = self.iter().map(|own| own.divided(divisor).times(factor));
        list.collect::<Vec<_>>().into()
    }

    /// The images at a place.
    pub(super) fn image(&self, place: &Place) -> Vec<u64> {
        let modulus = place.modulus();
        if let Some(own) = self.machine() {
            return own.images(modulus);
        }
        let one_by_one = || self.iter().map(|own| own.image(place)).collect();
        let Some(own) = self.factors() else {
            return one_by_one();
        };
        let divisor = modulus.embed_integer(&own.divisor);
        if divisor == 0 {
            return one_by_one();
        }
        let scale = modulus.inverse(divisor);
        let right = own.right.image(place);
        let right: Vec<u64> = right.iter().map(|own| modulus.times(*own, scale)).collect();
        let mut sums = vec![0; self.len()];
        for (index, left) in own.left.image(place).into_iter().enumerate() {
            for (sum, right) in sums[index..].iter_mut().zip(&right) {
                *sum = modulus.plus(*sum, modulus.times(left, *right));
            }
        }
        sums
    }
}

impl<R: Ring> Product<R> {
    fn len(&self) -> usize {
        self.left.len() + self.right.len() - 1
    }

    fn multiplied(&self) -> Vec<R> {
        let product = R::convolution(&self.left, &self.right);
        if self.divisor.is_one() {
            return product;
        }
        let quotients = product.iter().map(|own| own.divided(&self.divisor));
        quotients.collect()
    }
}

impl<R: Clone> Clone for Machine<R> {
    fn clone(&self) -> Self {
        Self {
            list: self.list.clone(),
            elements: OnceCell::new(),
        }
    }
}

impl<R: Ring> PartialEq for Numerators<R> {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Form::Machine(own), Form::Machine(other)) => return own.list == other.list,
            (Form::Ring(own), Form::Ring(other)) => return own == other,
            (Form::Machine(_), Form::Ring(_)) | (Form::Ring(_), Form::Machine(_)) => return false,
            (Form::Product(own), Form::Product(other)) if Rc::ptr_eq(own, other) => return true,
            _ => {}
        }
        match (self.factors(), other.factors()) {
            (Some(own), Some(other)) if own.left == other.left && own.right == other.right => {
                own.divisor == other.divisor
            }
            // Their ends tell most products apart.
            _ => self.len() == other.len() && self.last() == other.last() && **self == **other,
        }
    }
}

impl<R: Ring> Eq for Numerators<R> {}

impl<R: Ring> fmt::Debug for Numerators<R> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&**self, formatter)
    }
}

impl<R: Ring> From<MachineList> for Numerators<R> {
    fn from(list: MachineList) -> Self {
        Self(Form::Machine(Machine {
            list,
            elements: OnceCell::new(),
        }))
    }
}

impl<R: Ring> From<Vec<R>> for Numerators<R> {
    fn from(list: Vec<R>) -> Self {
        match MachineList::of(&list) {
            Some(own) => own.into(),
            None => Self(Form::Ring(Rc::new(list))),
        }
    }
}

impl<R: Ring> Deref for Numerators<R> {
    type Target = [R];

    fn deref(&self) -> &[R] {
        match &self.0 {
            Form::Machine(own) => own.elements.get_or_init(|| own.list.elements()),
            Form::Ring(own) => own,
            Form::Product(own) => own.list.get_or_init(|| own.product.multiplied()),
        }
    }
}
