use std::cell::OnceCell;
use std::fmt;
use std::ops::Deref;
use std::rc::Rc;

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
    list: Vec<R>,
    /// The primitive list that it is a multiple of; none if that is the list itself.
    primitive: OnceCell<Option<Numerators<R>>>,
}

impl<R: Clone> Numerators<R> {
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

impl<R: PartialEq> PartialEq for Numerators<R> {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Several(own), Self::Several(other)) if Rc::ptr_eq(own, other) => true,
            _ => **self == **other,
        }
    }
}

impl<R: Eq> Eq for Numerators<R> {}

impl<R: fmt::Debug> fmt::Debug for Numerators<R> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&**self, formatter)
    }
}

impl<R> From<Vec<R>> for Numerators<R> {
    fn from(mut list: Vec<R>) -> Self {
        if list.len() > 1 {
            return Self::Several(Rc::new(Shared {
                list,
                primitive: OnceCell::new(),
            }));
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
            Self::Several(own) => &own.list,
        }
    }
}
