use std::borrow::Cow;
use std::cell::OnceCell;
use std::ops::Range;
use std::rc::Rc;

use crate::number::{Leading, MachineList, Ring};
use crate::poly::Numerators;

use super::products::Numerator;

/// The scaled Bernstein coefficients C(n, i) bᵢ of a polynomial in one parameter, up to a factor.
///
/// The list of a product is the convolution of the lists of its factors. It is multiplied out when
/// an exact number is asked for; its leading digits come from those of the factors.
#[derive(Debug)]
pub(super) struct ScaledForm {
    list: OnceCell<Numerators<Numerator>>,
    product: Option<Product>,
    leading: OnceCell<Option<Rc<[Leading]>>>,
}

#[derive(Debug)]
struct Product {
    left: Rc<ScaledForm>,
    right: Rc<ScaledForm>,
}

impl ScaledForm {
    pub(super) fn list(list: Numerators<Numerator>) -> Self {
        Self {
            list: list.into(),
            product: None,
            leading: OnceCell::new(),
        }
    }

    /// f g
    pub(super) fn product(left: Rc<Self>, right: Rc<Self>) -> Self {
        Self {
            list: OnceCell::new(),
            product: Some(Product { left, right }),
            leading: OnceCell::new(),
        }
    }

    /// All coefficients, multiplied out.
    pub(super) fn coefficients(&self) -> &Numerators<Numerator> {
        self.list.get_or_init(|| {
            let product = self.product.as_ref();
            let list = product.map(Product::multiplied);
            list.unwrap_or_default().into()
        })
    }

    /// The coefficients, if they are multiplied out and machine numbers.
    pub(super) fn machine(&self) -> Option<&MachineList> {
        self.list.get()?.machine()
    }

    /// One coefficient; the others of a product are not multiplied out for it.
    pub(super) fn at(&self, index: usize) -> Cow<'_, Numerator> {
        match (self.list.get(), &self.product) {
            (None, Some(own)) => Cow::Owned(own.at(index)),
            _ => self.coefficients().at(index),
        }
    }

    /// The leading digits of all coefficients; none where few are known of one.
    pub(super) fn leading(&self) -> Option<Rc<[Leading]>> {
        let find = || match (self.list.get(), &self.product) {
            (None, Some(own)) => own.leading(),
            _ => self.coefficients().iter().map(Ring::leading).collect(),
        };
        self.leading.get_or_init(find).clone()
    }

    fn len(&self) -> usize {
        match (self.list.get(), &self.product) {
            (None, Some(own)) => own.left.len() + own.right.len() - 1,
            _ => self.coefficients().len(),
        }
    }
}

impl Product {
    fn multiplied(&self) -> Vec<Numerator> {
        Ring::convolution(self.left.coefficients(), self.right.coefficients())
    }

    /// The i of the terms fᵢ gₖ with i + k = index.
    fn range(&self, index: usize) -> Range<usize> {
        let first = (index + 1).saturating_sub(self.right.len());
        first..self.left.len().min(index + 1)
    }

    /// Σ fᵢ gₖ over i + k = index
    fn at(&self, index: usize) -> Numerator {
        let (left, right) = (self.left.coefficients(), self.right.coefficients());
        let mut sum = Numerator::zero();
        for i in self.range(index) {
            sum.add_product(&left[i], &right[index - i]);
        }
        sum
    }

    /// A coefficient of which the digits of the factors leave few is multiplied out.
    fn leading(&self) -> Option<Rc<[Leading]>> {
        let (left, right) = (self.left.leading()?, self.right.leading()?);
        let sum = |index: usize| {
            let terms = self.range(index);
            let terms = terms.map(|i| (left[i], right[index - i]));
            Leading::sum_of_products(terms).or_else(|| self.at(index).leading())
        };
        (0..left.len() + right.len() - 1).map(sum).collect()
    }
}
