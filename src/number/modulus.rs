use super::{Integer, Ring};

/// How far the first of them lie below 2⁶².
#[rustfmt::skip]
const FIRST: [u64; 32] = [
    57, 87, 117, 143, 153, 167, 171, 195, 203, 273, 287,
    317, 443, 483, 495, 575, 581, 603, 633, 663, 765,
    773, 777, 791, 813, 831, 923, 981, 993, 1001, 1007, 1017,
];

/// A prime modulus q below 2⁶², for images of which many are needed.
///
/// Elements are held in Montgomery's form a 2⁶⁴ mod q; they mean nothing under another modulus.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Modulus {
    prime: u64,
    /// −1/q mod 2⁶⁴
    negative_inverse: u64,
    /// 2⁶⁴ mod q
    one: u64,
    /// 2¹²⁸ mod q
    square: u64,
}

impl Modulus {
    /// The prime 2⁶¹ − 1.
    #[must_use]
    pub fn mersenne() -> Self {
        Self::of_odd((1 << 61) - 1)
    }

    /// The primes below 2⁶², from the greatest down.
    pub fn descending() -> impl Iterator<Item = Self> {
        let bound = (1 << 62) - FIRST[FIRST.len() - 1];
        let first = FIRST.iter().map(|below| Self::of_odd((1 << 62) - below));
        first.chain(Self::search(bound))
    }

    /// The odd primes below the bound, from the greatest down, found one by one.
    fn search(bound: u64) -> impl Iterator<Item = Self> {
        (1..bound / 2)
            .map(move |step| Self::of_odd((bound | 1) - 2 * step))
            .filter(Self::is_prime)
    }

    /// Arithmetic modulo an odd number q, 2 < q < 2⁶².
    fn of_odd(prime: u64) -> Self {
        // Newton's iteration x ← x (2 − q x) doubles the correct bits of 1/q; q itself has 3.
        let inverse = (0..5).fold(prime, |inverse, _| {
            inverse.wrapping_mul(2_u64.wrapping_sub(prime.wrapping_mul(inverse)))
        });
        let one = u64::MAX % prime + 1;
        let square = u128::from(one) * u128::from(one) % u128::from(prime);
        Self {
            prime,
            negative_inverse: inverse.wrapping_neg(),
            one,
            square: u64::try_from(square).unwrap_or_default(),
        }
    }

    /// q
    #[must_use]
    pub fn prime(&self) -> u64 {
        self.prime
    }

    /// The prime as it is named in reports: `2^61 - 1`.
    #[must_use]
    pub fn name(&self) -> String {
        let bits = u64::BITS - self.prime.leading_zeros();
        format!("2^{bits} - {}", (1 << bits) - self.prime)
    }

    /// 1
    #[must_use]
    pub fn one(&self) -> u64 {
        self.one
    }

    /// The image of a machine integer.
    #[must_use]
    pub fn embed(&self, value: u64) -> u64 {
        // The product is less than 2⁶⁴ q, which is all that the reduction asks for.
        self.times(value, self.square)
    }

    /// The image of an integer.
    #[must_use]
    pub fn embed_integer(&self, value: &Integer) -> u64 {
        if let Some(own) = value.machine() {
            return self.embed_machine(own);
        }
        // Digits d_k of 64 bits: Horner's rule in the base 2⁶⁴, whose image is 2¹²⁸ mod q.
        let sum = value.fold_digits(0, |sum, digit| {
            self.plus(self.times(sum, self.square), self.embed(digit))
        });
        if Ring::sign(value).is_lt() {
            self.minus(0, sum)
        } else {
            sum
        }
    }

    /// The image of a machine number.
    #[must_use]
    #[inline]
    pub fn embed_machine(&self, value: i128) -> u64 {
        let size = value.unsigned_abs();
        let image = match u64::try_from(size) {
            Ok(word) => self.embed(word),
            Err(_) => {
                let word =
                    |own: u128| u64::try_from(own & u128::from(u64::MAX)).unwrap_or_default();
                let above = self.embed(word(size >> 64));
                self.plus(self.times(above, self.square), self.embed(word(size)))
            }
        };
        if value < 0 {
            self.minus(0, image)
        } else {
            image
        }
    }

    /// The integer of least absolute value with this image.
    #[must_use]
    pub fn lift(&self, image: u64) -> i64 {
        let value = self.times(image, 1);
        let signed = i64::try_from(value).unwrap_or_default();
        if value > self.prime / 2 {
            signed - i64::try_from(self.prime).unwrap_or_default()
        } else {
            signed
        }
    }

    /// a + b
    #[must_use]
    pub fn plus(&self, left: u64, right: u64) -> u64 {
        let sum = left + right;
        if sum >= self.prime {
            sum - self.prime
        } else {
            sum
        }
    }

    /// a − b
    #[must_use]
    pub fn minus(&self, left: u64, right: u64) -> u64 {
        if left >= right {
            left - right
        } else {
            left + self.prime - right
        }
    }

    /// a b
    #[must_use]
    pub fn times(&self, left: u64, right: u64) -> u64 {
        let product = u128::from(left) * u128::from(right);
        let low = product & u128::from(u64::MAX);
        let digit = u64::try_from(low)
            .unwrap_or_default()
            .wrapping_mul(self.negative_inverse);
        let sum = (product + u128::from(digit) * u128::from(self.prime)) >> 64;
        let reduced = u64::try_from(sum).unwrap_or_default();
        if reduced >= self.prime {
            reduced - self.prime
        } else {
            reduced
        }
    }

    /// aⁿ
    #[must_use]
    pub fn power(&self, base: u64, exponent: u64) -> u64 {
        (0..u64::BITS - exponent.leading_zeros())
            .rev()
            .fold(self.one, |result, bit| {
                let square = self.times(result, result);
                if exponent >> bit & 1 == 1 {
                    self.times(square, base)
                } else {
                    square
                }
            })
    }

    /// 1 / a by Fermat; 0 for 0
    #[must_use]
    pub fn inverse(&self, value: u64) -> u64 {
        self.power(value, self.prime - 2)
    }

    /// A square root of an image; none if it is no square.
    ///
    /// With q − 1 = 2ˢ o, o odd, the power r = a^((o+1)/2) has r² = a e with e of order 2ᵗ, t < s
    /// for a square; powers of a non-residue's oth power bring e to 1. (Tonelli and Shanks)
    #[must_use]
    pub fn square_root(&self, value: u64) -> Option<u64> {
        let twos = (self.prime - 1).trailing_zeros();
        let odd = (self.prime - 1) >> twos;
        let mut root = self.power(value, odd.div_ceil(2));
        if twos == 1 {
            return (self.times(root, root) == value).then_some(root);
        }
        if value == 0 || self.power(value, (self.prime - 1) / 2) != self.one {
            return (value == 0).then_some(0);
        }
        let minus_one = self.prime - self.one;
        let mut bases = (2..self.prime).map(|base| self.embed(base));
        let base = bases.find(|base| self.power(*base, (self.prime - 1) / 2) == minus_one)?;
        let mut step = self.power(base, odd);
        let mut error = self.power(value, odd);
        let mut order = twos;
        while error != self.one {
            let mut exponent = 0;
            let mut square = error;
            while square != self.one {
                square = self.times(square, square);
                exponent += 1;
            }
            let factor = (0..order - exponent - 1).fold(step, |own, _| self.times(own, own));
            step = self.times(factor, factor);
            error = self.times(error, step);
            root = self.times(root, factor);
            order = exponent;
        }
        Some(root)
    }

    /// Whether q is a prime: strong probable primality to the first twelve prime bases, which
    /// no composite number below 3.3·10²⁴ passes.
    fn is_prime(&self) -> bool {
        const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
        let twos = (self.prime - 1).trailing_zeros();
        let minus_one = self.prime - self.one;
        // Divisions are cheaper than powers.
        let divisor = BASES.iter().find(|own| self.prime.is_multiple_of(**own));
        if let Some(divisor) = divisor {
            return self.prime == *divisor;
        }
        BASES.into_iter().all(|base| {
            let mut power = self.power(self.embed(base), (self.prime - 1) >> twos);
            if power == self.one {
                return true;
            }
            for _ in 1..twos {
                if power == minus_one {
                    return true;
                }
                power = self.times(power, power);
            }
            power == minus_one
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_agree_with_integer_remainders() {
        for modulus in Modulus::descending().take(3) {
            let prime = Integer::from(modulus.prime());
            let mut value = Integer::from(-5);
            for step in 0..30_u32 {
                value = &value * Integer::from(0x9e37_79b9_7f4a_7c15_u64) + Integer::from(step);
                let lifted = Integer::from(modulus.lift(modulus.embed_integer(&value)));
                assert_eq!((lifted - &value) % &prime, Integer::from(0));
            }
            let image = modulus.embed(12_345);
            assert_eq!(modulus.times(image, modulus.inverse(image)), modulus.one());
        }
    }

    #[test]
    fn small_primes_are_told_from_composites() {
        let primes = (1..60)
            .map(|half| 2 * half + 1)
            .filter(|&odd| Modulus::of_odd(odd).is_prime());
        let expected = [
            3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83,
            89, 97, 101, 103, 107, 109, 113,
        ];
        assert_eq!(primes.collect::<Vec<_>>(), expected);
        assert!(!Modulus::of_odd(3_215_031_751).is_prime());
    }

    #[test]
    fn the_first_prime_is_known() {
        // 2⁶² − 57 is the greatest prime below 2⁶².
        let first = Modulus::descending().next().map(|modulus| modulus.prime());
        assert_eq!(first, Some((1 << 62) - 57));
        let several: Vec<_> = Modulus::descending()
            .take(40)
            .map(|own| own.prime())
            .collect();
        let searched = Modulus::search(1 << 62).take(40).map(|own| own.prime());
        assert_eq!(several, searched.collect::<Vec<_>>());
    }
}
