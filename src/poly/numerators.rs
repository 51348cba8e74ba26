use std::ops::Deref;
use std::rc::Rc;

/// The numerators of a polynomial, which copies share; a constant needs no memory of its own.
#[derive(Clone, Debug)]
pub(super) enum Numerators<R> {
    Zero,
    Constant(R),
    /// Two at least.
    Several(Rc<[R]>),
}

impl<R: PartialEq> PartialEq for Numerators<R> {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Several(own), Self::Several(other)) => Rc::ptr_eq(own, other) || own == other,
            _ => **self == **other,
        }
    }
}

impl<R: Eq> Eq for Numerators<R> {}

impl<R> From<Vec<R>> for Numerators<R> {
    fn from(mut list: Vec<R>) -> Self {
        if list.len() > 1 {
            return Self::Several(list.into());
        }
        list.pop().map_or(Self::Zero, Self::Constant)
    }
}

impl<R> FromIterator<R> for Numerators<R> {
    fn from_iter<I: IntoIterator<Item = R>>(list: I) -> Self {
        Vec::from_iter(list).into()
    }
}

impl<R> Deref for Numerators<R> {
    type Target = [R];

    fn deref(&self) -> &[R] {
        match self {
            Self::Zero => &[],
            Self::Constant(own) => std::slice::from_ref(own),
            Self::Several(own) => own,
        }
    }
}
