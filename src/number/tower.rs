use std::sync::{Arc, RwLock};

use super::{Field, Generator, Integer, Rational, Ring, Surd, SurdInteger};

/// A real field ℚ(√a₁)(√a₂)… that grows by square roots and never shrinks: one for each program.
///
/// Every radicand is positive and no square in the field below it, so the degree over ℚ is
/// 2ᵏ for k generators. Clones are the same tower; [`Tower::fork`] makes one that grows on its
/// own.
#[derive(Debug, Clone)]
pub struct Tower {
    top: Arc<RwLock<Option<Generator>>>,
    limit: usize,
}

/// Why a tower does not give a square root.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RootFault {
    /// The radicand is negative.
    Negative,
    /// The root would make the field's degree over ℚ greater than the limit.
    DegreeLimit {
        /// The greatest degree allowed.
        limit: usize,
    },
}

/// ℚ, which may grow without a limit.
impl Default for Tower {
    fn default() -> Self {
        Self::new(usize::MAX)
    }
}

impl Tower {
    /// ℚ, which may grow to a degree of at most `limit`.
    #[must_use]
    pub fn new(limit: usize) -> Self {
        Self {
            top: Arc::new(RwLock::new(None)),
            limit,
        }
    }

    /// The last generator; none as long as the field is ℚ.
    #[must_use]
    pub fn top(&self) -> Option<Generator> {
        self.top.read().ok()?.clone()
    }

    /// The degree over ℚ.
    #[must_use]
    pub fn degree(&self) -> usize {
        1 << self.top().map_or(0, |top| top.level())
    }

    /// A tower of the same generators, which grows apart from this one.
    #[must_use]
    pub fn fork(&self) -> Self {
        Self {
            top: Arc::new(RwLock::new(self.top())),
            limit: self.limit,
        }
    }

    /// A fork without a limit, for questions whose answers do not stay.
    #[must_use]
    pub fn scratch(&self) -> Self {
        Self {
            limit: usize::MAX,
            ..self.fork()
        }
    }

    /// Takes over the generators of a fork. This tower must not have grown since.
    pub fn adopt(&self, fork: &Self) {
        if let Ok(mut top) = self.top.write() {
            *top = fork.top();
        }
    }

    /// The root of a radicand if it lies in the field; none for a negative radicand.
    #[must_use]
    pub fn root_in_field(&self, radicand: &Surd) -> Option<Surd> {
        root_within(radicand, self.top().as_ref())
    }

    /// The root that is not negative. The field grows if it does not hold it, by the simplest
    /// generator that is found: nested radicals are denested one level.
    ///
    /// For x = a + b√r with a² − r b² = s² one level down, c = √((a + s)/2) gives
    /// √x = c + b√r/2c.
    ///
    /// # Errors
    ///
    /// A negative radicand, and a field of too large a degree.
    pub fn square_root(&self, radicand: &Surd) -> Result<Surd, RootFault> {
        if radicand.sign().is_lt() {
            return Err(RootFault::Negative);
        }
        if let Some(root) = self.root_in_field(radicand) {
            return Ok(root);
        }
        if let SurdInteger::Irrational(own) = radicand.numerator()
            && let Some((first, other)) = denested(radicand, own)
        {
            // The product of both lies in the field: one root gives the other.
            let simpler = if other.bits() < first.bits() {
                other.clone()
            } else {
                first.clone()
            };
            let root = self.square_root(&simpler)?;
            let cross = half_cross(radicand, own);
            return Ok((&root + &(&cross / &root)).absolute());
        }
        self.adjoin(radicand)
    }

    /// The root of a positive radicand that is no square in the field, as a new generator times a
    /// number.
    fn adjoin(&self, radicand: &Surd) -> Result<Surd, RootFault> {
        if self.degree().saturating_mul(2) > self.limit {
            return Err(RootFault::DegreeLimit { limit: self.limit });
        }
        // √(n/d) = √(n d)/d, and square factors come out of the root: those of n and of d, which
        // are coprime, each by itself.
        let numerator = radicand.numerator().scaled(radicand.denominator());
        let content = radicand.numerator().content();
        let outer = square_factor(&content) * square_factor(radicand.denominator());
        let square = numerator.divided(&(&outer * &outer));
        let generator = Generator::new(square, self.top());
        if let Ok(mut top) = self.top.write() {
            *top = Some(generator.clone());
        }
        let scale = Rational::new(outer, radicand.denominator().clone());
        let root = Surd::integral(SurdInteger::generator(&generator));
        Ok(&root * &Surd::from(scale))
    }
}

impl Surd {
    /// |a|
    #[must_use]
    pub fn absolute(&self) -> Self {
        if self.sign().is_lt() {
            self.negated()
        } else {
            self.clone()
        }
    }
}

/// b√r/2 for x = a + b√r.
fn half_cross(radicand: &Surd, own: &super::Binomial) -> Surd {
    let cross = SurdInteger::binomial(SurdInteger::zero(), own.slope.clone(), &own.generator);
    Surd::from_parts(cross, radicand.denominator() * Integer::from(2))
}

/// (a + s)/2 and (a − s)/2 for x = a + b√r with a² − r b² = s², s one level down.
fn denested(radicand: &Surd, own: &super::Binomial) -> Option<(Surd, Surd)> {
    let norm = SurdInteger::norm(own);
    let norm = Surd::from_parts(norm, radicand.denominator() * radicand.denominator());
    let root = root_within(&norm, own.generator.below())?;
    let constant = Surd::from_parts(own.constant.clone(), radicand.denominator().clone());
    let half = Surd::from(Rational::new(1.into(), 2.into()));
    let sum = &(&constant + &root) * &half;
    let difference = &(&constant - &root) * &half;
    Some((sum, difference))
}

/// The root that is not negative, if it lies in the field of the generators up to `top`, which
/// holds the radicand.
///
/// In K(√r) a number x of K is a square if x or x r is one in K. For x = a + b√r with b ≠ 0 a root
/// c + d√r has c² + r d² = a and 2cd = b, so c² is one of (a ± s)/2 with s² = a² − r b².
pub(super) fn root_within(radicand: &Surd, top: Option<&Generator>) -> Option<Surd> {
    if radicand.sign().is_lt() {
        return None;
    }
    let Some(top) = top else {
        let root = Field::square_root(&radicand.as_rational()?)?;
        return Some(Surd::from(root));
    };
    if let Some(known) = generator_of(radicand, top) {
        return Some(known);
    }
    if refuted(radicand, top) {
        return None;
    }
    match radicand.numerator() {
        SurdInteger::Irrational(own) if own.generator.level() == top.level() => {
            let (first, second) = denested(radicand, own)?;
            let cross = half_cross(radicand, own);
            let root = [first, second]
                .iter()
                .find_map(|square| root_within(square, top.below()))?;
            Some((&root + &(&cross / &root)).absolute())
        }
        _ => root_within(radicand, top.below()).or_else(|| {
            let square = Surd::integral(top.square().clone());
            let root = root_within(&(radicand * &square), top.below())?;
            let generator = Surd::integral(SurdInteger::generator(top));
            Some((&(&root / &square) * &generator).absolute())
        }),
    }
}

/// The generator up to `top` that is the square root of a number.
fn generator_of(radicand: &Surd, top: &Generator) -> Option<Surd> {
    let mut generators = std::iter::successors(Some(top), |own| own.below());
    let own = generators.find(|own| radicand.numerator() == own.square())?;
    let root = || Surd::integral(SurdInteger::generator(own));
    radicand.denominator().is_one().then(root)
}

/// Whether an image at a place shows that a number is no square in the field up to `top`.
///
/// An image does so for half of the numbers that are none. The search for a root that does not
/// exist is the longer the higher the tower is, so there the number is given more images.
fn refuted(radicand: &Surd, top: &Generator) -> bool {
    top.places().take(top.level()).any(|place| {
        let modulus = place.modulus();
        let denominator = modulus.embed_integer(radicand.denominator());
        let image = modulus.times(radicand.numerator().image(&place), denominator);
        modulus.square_root(image).is_none()
    })
}

/// A large k with k² | n, from the small primes and from the rest where that is a square.
fn square_factor(content: &Integer) -> Integer {
    let mut rest = content.clone();
    let mut factor = Integer::from(1);
    for prime in 2_u32..1_000 {
        let square = Integer::from(prime * prime);
        while Ring::is_zero(&(&rest % &square)) {
            rest /= &square;
            factor *= prime;
        }
        // Once only: what is left of a prime does not occur twice.
        if u32::try_from(&rest).is_ok_and(|rest| rest < prime * prime) {
            return factor;
        }
        let prime = Integer::from(prime);
        if Ring::is_zero(&(&rest % &prime)) {
            rest /= prime;
        }
    }
    let root = rest.sqrt();
    if &root * &root == rest {
        factor *= root;
    }
    factor
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rational(text: &str) -> Surd {
        text.parse().unwrap_or_else(|()| Surd::zero())
    }

    fn root(tower: &Tower, radicand: &Surd) -> Surd {
        tower.square_root(radicand).unwrap_or_else(|_| Surd::zero())
    }

    #[test]
    fn dependent_radicals_do_not_extend_the_field() {
        let tower = Tower::new(64);
        let [two, three, six] = ["2", "3", "6"].map(rational);
        let (first, second) = (root(&tower, &two), root(&tower, &three));
        assert_eq!(tower.degree(), 4);
        assert_eq!(root(&tower, &six), &first * &second);
        assert_eq!(root(&tower, &rational("8/27")).to_string(), "2/9*√2*√3");
        assert_eq!(tower.degree(), 4);
    }

    #[test]
    fn nested_radicals_are_denested_where_they_denest() {
        let tower = Tower::new(64);
        let six = root(&tower, &rational("6"));
        let nested = &rational("5") + &(&rational("2") * &six);
        let found = root(&tower, &nested);
        assert_eq!(&found * &found, nested);
        assert_eq!(found.sign(), std::cmp::Ordering::Greater);
        assert_eq!(tower.degree(), 4);
        assert_eq!(
            tower.top().map(|top| top.square().to_string()).as_deref(),
            Some("3")
        );
        // √(40√2 − 35) does not denest
        let two = root(&tower, &rational("2"));
        let honest = &(&rational("40") * &two) - &rational("35");
        let found = root(&tower, &honest);
        assert_eq!((tower.degree(), &found * &found), (8, honest));
    }

    #[test]
    fn large_squares_come_out_of_numerator_and_denominator() {
        // 1009/10007² and 10007²/1009, whose large primes no trial division meets
        for (text, expected) in [
            ("1009/100140049", "1/10007*√1009"),
            ("100140049/1009", "10007/1009*√1009"),
        ] {
            let found = root(&Tower::new(64), &rational(text));
            assert_eq!(found.to_string(), expected);
        }
    }

    #[test]
    fn limits_and_signs_are_faults() {
        let tower = Tower::new(2);
        assert_eq!(tower.square_root(&rational("-1")), Err(RootFault::Negative));
        root(&tower, &rational("2"));
        let limit = RootFault::DegreeLimit { limit: 2 };
        assert_eq!(tower.square_root(&rational("3")), Err(limit));
        assert_eq!(root(&tower, &rational("0")), Surd::zero());
        assert_eq!(root(&tower, &rational("9/4")), rational("3/2"));
    }

    #[test]
    fn signs_of_nearly_equal_numbers_are_right() {
        // √2 + √3 − √(5 + 2√6) = 0, and √2 against its 200-digit neighbours
        let tower = Tower::new(64);
        let [two, three] = ["2", "3"].map(|text| root(&tower, &rational(text)));
        let sum = &two + &three;
        let other = root(&tower, &(&sum * &sum));
        assert_eq!(sum, other);
        let near: Integer = (Integer::from(2) << 1400_u32).sqrt();
        let unit = Integer::from(1) << 700_u32;
        let below = Surd::from(Rational::new(near.clone(), unit.clone()));
        let above = Surd::from(Rational::new(near + 1, unit));
        assert!(below < two && two < above);
    }
}
