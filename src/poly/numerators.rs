use std::borrow::Cow;
use std::cell::OnceCell;
use std::fmt;
use std::ops::Deref;
use std::rc::Rc;

use crate::number::{Integer, Place, Ring, gcd};

/// The numerators of a polynomial, which copies share; a constant needs no memory of its own.
#[derive(Clone)]
pub(super) enum Numerators<R> {
    Zero,
    Constant(R),
    /// Two at least.
    Several(Rc<Shared<R>>),
}

/// A list, and what was found out about it.
pub(super) struct Shared<R> {
    length: usize,
    list: OnceCell<Vec<R>>,
    /// What the list is multiplied out from, when it is asked for; none for one that was given.
    product: Option<Product<R>>,
    /// The primitive list that it is a multiple of; none if that is the list itself.
    primitive: OnceCell<Option<Numerators<R>>>,
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
        Self::shared(
            left.len() + right.len() - 1,
            OnceCell::new(),
            Some(Product {
                left,
                right,
                divisor,
            }),
        )
    }

    fn shared(length: usize, list: OnceCell<Vec<R>>, product: Option<Product<R>>) -> Self {
        Self::Several(Rc::new(Shared {
            length,
            list,
            product,
            primitive: OnceCell::new(),
        }))
    }

    /// The product that is not multiplied out yet.
    #[inline]
    pub(super) fn factors(&self) -> Option<&Product<R>> {
        match self {
            Self::Several(own) if own.list.get().is_none() => own.product.as_ref(),
            _ => None,
        }
    }

    #[inline]
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Zero => 0,
            Self::Constant(_) => 1,
            Self::Several(own) => own.length,
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        matches!(self, Self::Zero)
    }

    /// The coefficient of the lowest power; none for 0.
    pub(super) fn first(&self) -> Option<Cow<'_, R>> {
        match self.factors() {
            Some(own) => Some(own.end(&*own.left.first()?, &*own.right.first()?)),
            None => (**self).first().map(Cow::Borrowed),
        }
    }

    /// The coefficient of the highest power; none for 0.
    pub(super) fn last(&self) -> Option<Cow<'_, R>> {
        match self.factors() {
            Some(own) => Some(own.end(&*own.left.last()?, &*own.right.last()?)),
            None => (**self).last().map(Cow::Borrowed),
        }
    }

    /// Whether all are rational integers.
    pub(super) fn is_rational(&self) -> bool {
        self.factors().is_some() || self.iter().all(|own| own.height() == 0)
    }

    /// The greatest integer that divides all of them, and a given one.
    pub(super) fn content_with(&self, with: &Integer) -> Integer {
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

    /// The images at a place.
    pub(super) fn image(&self, place: &Place) -> Vec<u64> {
        let Some(own) = self.factors() else {
            return self.iter().map(|own| own.image(place)).collect();
        };
        let modulus = place.modulus();
        let divisor = modulus.embed_integer(&own.divisor);
        if divisor == 0 {
            return self.iter().map(|own| own.image(place)).collect();
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

    /// The primitive list that it is a multiple of, which is sought once; none if that is the list
    /// itself.
    pub(super) fn primitive(&self, find: impl FnOnce() -> Option<Self>) -> Self {
        let found = match self {
            Self::Several(own) => own.primitive.get_or_init(find).clone(),
            _ => find(),
        };
        found.unwrap_or_else(|| self.clone())
    }
}

impl<R: Ring> Product<R> {
    /// The coefficient at an end, from those of the factors.
    fn end(&self, left: &R, right: &R) -> Cow<'_, R> {
        Cow::Owned(left.times(right).divided(&self.divisor))
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

impl<R: Ring> PartialEq for Numerators<R> {
    fn eq(&self, other: &Self) -> bool {
        if let (Self::Several(own), Self::Several(other)) = (self, other)
            && Rc::ptr_eq(own, other)
        {
            return true;
        }
        match (self.factors(), other.factors()) {
            (None, None) => **self == **other,
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

impl<R: Ring> From<Vec<R>> for Numerators<R> {
    fn from(mut list: Vec<R>) -> Self {
        if list.len() > 1 {
            return Self::shared(list.len(), list.into(), None);
        }
        list.pop().map_or(Self::Zero, Self::Constant)
    }
}

impl<R: Ring> FromIterator<R> for Numerators<R> {
    fn from_iter<I: IntoIterator<Item = R>>(list: I) -> Self {
        Vec::from_iter(list).into()
    }
}

impl<R: Ring> Deref for Numerators<R> {
    type Target = [R];

    fn deref(&self) -> &[R] {
        match self {
            Self::Zero => &[],
            Self::Constant(own) => std::slice::from_ref(own),
            Self::Several(own) => own.list.get_or_init(|| {
                let product = own.product.as_ref();
                product.map(Product::multiplied).unwrap_or_default()
            }),
        }
    }
}
