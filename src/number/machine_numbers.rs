use std::ops::{Add, AddAssign, Mul, SubAssign};

/// Machine numbers that are read: words, if all are known to be such, else double words.
#[derive(Clone, Copy, Debug)]
pub enum MachineNumbers<'a> {
    /// Of 64 binary digits, with the sign.
    Words(&'a [i64]),
    /// Of 128.
    Doubles(&'a [i128]),
}

/// The binary digits that every word may have, without its sign.
pub(super) const WORD: u32 = i64::BITS - 1;

/// The binary digits that every machine number may have, without its sign.
pub(super) const DOUBLE: u32 = i128::BITS - 1;

/// What is done with machine numbers, as words or as double words.
macro_rules! each_width {
    ($numbers:expr, $list:ident => $result:expr) => {
        match $numbers {
            MachineNumbers::Words($list) => $result,
            MachineNumbers::Doubles($list) => $result,
        }
    };
}

pub(super) use each_width;

/// A word or a double word.
pub(super) trait Width:
    Copy + Default + Add<Output = Self> + AddAssign + SubAssign + Mul<Output = Self>
{
    fn wide(self) -> i128;

    /// A number that is known to be one: its lower digits.
    fn of(wide: i128) -> Self;
}

impl Width for i64 {
    #[inline]
    fn wide(self) -> i128 {
        self.into()
    }

    #[inline]
    fn of(wide: i128) -> Self {
        let lower = wide.cast_unsigned() & u128::from(u64::MAX);
        u64::try_from(lower).unwrap_or_default().cast_signed()
    }
}

impl Width for i128 {
    #[inline]
    fn wide(self) -> i128 {
        self
    }

    #[inline]
    fn of(wide: i128) -> Self {
        wide
    }
}

impl<'a> MachineNumbers<'a> {
    /// None.
    pub const NONE: Self = Self::Words(&[]);

    /// The number 1 alone.
    pub const ONE: Self = Self::Words(&[1]);

    /// How many they are.
    #[must_use]
    #[inline]
    pub fn len(self) -> usize {
        match self {
            Self::Words(own) => own.len(),
            Self::Doubles(own) => own.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    #[inline]
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// One of them; the index is less than their number.
    #[must_use]
    #[inline]
    pub fn at(self, index: usize) -> i128 {
        match self {
            Self::Words(own) => own[index].wide(),
            Self::Doubles(own) => own[index],
        }
    }

    /// All of them, in order. Each is asked for its width; `each_width` asks once.
    #[inline]
    pub fn iter(self) -> impl DoubleEndedIterator<Item = i128> + ExactSizeIterator + use<'a> {
        (0..self.len()).map(move |index| self.at(index))
    }

    /// The least b with −2ᵇ ≤ n < 2ᵇ for all of them.
    #[must_use]
    #[inline]
    pub fn bits(self) -> u32 {
        match self {
            Self::Words(own) => {
                let all = own.iter().fold(0, |all, own| all | (own ^ (own >> WORD)));
                u64::BITS - all.leading_zeros()
            }
            Self::Doubles(own) => {
                let all = own.iter().fold(0, |all, own| all | (own ^ (own >> DOUBLE)));
                u128::BITS - all.leading_zeros()
            }
        }
    }

    /// Adds f aₖ to the sums at the places from the first one on; all products are of their width.
    #[inline]
    pub(super) fn add_multiple<S: Width>(self, factor: i128, sums: &mut [S]) {
        match (i64::try_from(factor), self) {
            (Ok(1), Self::Words(own)) => add_multiple(1_i64, own, sums),
            (Ok(1), Self::Doubles(own)) => add_multiple(1_i64, own, sums),
            // One instruction multiplies two words.
            (Ok(factor), Self::Words(own)) => add_multiple(factor, own, sums),
            (Ok(factor), Self::Doubles(own)) => add_multiple(factor, own, sums),
            (Err(_), Self::Words(own)) => add_multiple(factor, own, sums),
            (Err(_), Self::Doubles(own)) => add_multiple(factor, own, sums),
        }
    }
}

#[inline]
fn add_multiple<S: Width>(factor: impl Width, list: &[impl Width], sums: &mut [S]) {
    let factor = S::of(factor.wide());
    for (sum, own) in sums.iter_mut().zip(list) {
        *sum += factor * S::of(own.wide());
    }
}

impl PartialEq for MachineNumbers<'_> {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Words(own), Self::Words(other)) => own == other,
            (Self::Doubles(own), Self::Doubles(other)) => own == other,
            _ => self.iter().eq(other.iter()),
        }
    }
}

impl Eq for MachineNumbers<'_> {}
