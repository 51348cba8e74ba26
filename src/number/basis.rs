use super::{Field, Generator, Integer, Rational, Ring, Surd, SurdInteger};

/// The generators that occur in some numbers, with short names: r1, r2, … from the ground up.
///
/// Numbers are spelled as sums of rational multiples of products of generators, in the fixed
/// order 1, r1, r2, r1*r2, r3, …
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Basis {
    generators: Vec<Generator>,
}

/// Characters of a number or a field that is written out.
const READABLE: usize = 60;

impl Basis {
    /// The generators that occur in the numbers, and in the radicands of those.
    #[must_use]
    pub fn of<'a>(numbers: impl IntoIterator<Item = &'a SurdInteger>) -> Self {
        let mut basis = Self::default();
        for number in numbers {
            basis.take(number);
        }
        basis.generators.sort_by_key(Generator::level);
        basis
    }

    fn take(&mut self, number: &SurdInteger) {
        if let SurdInteger::Irrational(own) = number {
            if !self.generators.contains(&own.generator) {
                self.generators.push(own.generator.clone());
                self.take(own.generator.square());
            }
            self.take(&own.constant);
            self.take(&own.slope);
        }
    }

    /// The generators of this basis and another.
    #[must_use]
    pub fn union(mut self, other: &Self) -> Self {
        for own in &other.generators {
            if !self.generators.contains(own) {
                self.generators.push(own.clone());
            }
        }
        self.generators.sort_by_key(Generator::level);
        self
    }

    /// Whether the field is ℚ.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.generators.is_empty()
    }

    /// The degree of the field over ℚ.
    #[must_use]
    pub fn degree(&self) -> usize {
        1 << self.generators.len()
    }

    /// The generators, from the ground up.
    #[must_use]
    pub fn generators(&self) -> &[Generator] {
        &self.generators
    }

    /// The name of each generator and its square, spelled with the names before it.
    #[must_use]
    pub fn definitions(&self) -> Vec<(String, String)> {
        let named = self.generators.iter().map(|own| {
            let square = Surd::integral(own.square().clone());
            (self.name(own), self.spell(&square))
        });
        named.collect()
    }

    fn name(&self, generator: &Generator) -> String {
        match self.generators.iter().position(|own| own == generator) {
            Some(index) => format!("r{}", index + 1),
            None => generator.to_string(),
        }
    }

    /// `3/2 + 1/4*r1 - r1*r2`; `p` or `p/q` for a rational number.
    #[must_use]
    pub fn spell(&self, number: &Surd) -> String {
        // Numbers are in lowest terms, and most are rational.
        if let SurdInteger::Rational(own) = number.numerator() {
            let denominator = number.denominator();
            return if denominator.is_one() {
                own.to_string()
            } else {
                format!("{own}/{denominator}")
            };
        }
        sum(number.numerator(), number.denominator(), &|own| {
            self.name(own)
        })
    }

    /// The number with its radicals written out if that is short, else with the names of the
    /// generators.
    #[must_use]
    pub fn readable(&self, number: &Surd) -> String {
        let radicals = number.to_string();
        if radicals.chars().count() <= READABLE {
            radicals
        } else {
            self.spell(number)
        }
    }

    /// `Q(√2)(√(110 + 100*√2)), degree 4` for the field of some of the generators; with their names
    /// where that would be long. None for the rational numbers.
    #[must_use]
    pub fn describe(&self, part: &Self) -> Option<String> {
        if part.is_rational() {
            return None;
        }
        let generators = part.generators.iter();
        let adjoined: String = generators.map(|own| format!("({own})")).collect();
        let degree = part.degree();
        if adjoined.chars().count() <= READABLE {
            return Some(format!("Q{adjoined}, degree {degree}"));
        }
        Some(format!("degree {degree}, {}", self.defined(part)))
    }

    /// `r1 = √(2), r2 = √(3 + r1)` for the generators whose names [`Basis::readable`] writes; none
    /// where it writes radicals.
    #[must_use]
    pub fn legend(&self, number: &Surd) -> Option<String> {
        let named = self.readable(number) != number.to_string();
        named.then(|| self.defined(&Self::of([number.numerator()])))
    }

    /// The names of some of the generators, with what they are.
    fn defined(&self, part: &Self) -> String {
        let names = part.generators.iter().map(|own| {
            let square = Surd::integral(own.square().clone());
            format!("{} = √({})", self.name(own), self.spell(&square))
        });
        names.collect::<Vec<_>>().join(", ")
    }

    /// The number that a text spells; none if it is not of that form.
    #[must_use]
    pub fn read(&self, text: &str) -> Option<Surd> {
        let mut value = Surd::zero();
        let mut rest = text.trim();
        let mut negative = false;
        if let Some(after) = rest.strip_prefix('-') {
            (rest, negative) = (after.trim_start(), true);
        }
        loop {
            let end = rest.find([' ', '+', '-']).unwrap_or(rest.len());
            let term = self.read_term(&rest[..end])?;
            value = if negative {
                &value - &term
            } else {
                &value + &term
            };
            rest = rest[end..].trim_start();
            let Some(sign) = rest.chars().next() else {
                return Some(value);
            };
            negative = match sign {
                '+' => false,
                '-' => true,
                _ => return None,
            };
            rest = rest[1..].trim_start();
        }
    }

    fn read_term(&self, text: &str) -> Option<Surd> {
        let mut product = Surd::one();
        for factor in text.split('*') {
            let value = match factor.strip_prefix('r') {
                Some(index) => {
                    let index = index.parse::<usize>().ok()?.checked_sub(1)?;
                    let generator = self.generators.get(index)?;
                    Surd::integral(SurdInteger::generator(generator))
                }
                None => Surd::from(factor.parse::<Rational>().ok()?),
            };
            product = &product * &value;
        }
        Some(product)
    }
}

/// The number n/d with every radical written out: `3/2 + 1/4*√2`.
pub(super) fn radicals(numerator: &SurdInteger, denominator: &Integer) -> String {
    sum(numerator, denominator, &Generator::to_string)
}

/// The components of n/d over the products of generators, by the generators' names.
fn sum(
    numerator: &SurdInteger,
    denominator: &Integer,
    name: &impl Fn(&Generator) -> String,
) -> String {
    let mut text = String::new();
    for (product, component) in numerator.components() {
        let coefficient = Rational::new(component.clone(), denominator.clone());
        let negative = Field::sign(&coefficient).is_lt();
        text.push_str(match (text.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        let magnitude = if negative { -&coefficient } else { coefficient };
        let mut factors: Vec<String> = product.iter().map(name).collect();
        if factors.is_empty() || magnitude != Rational::one() {
            factors.insert(0, magnitude.to_string());
        }
        text.push_str(&factors.join("*"));
    }
    if text.is_empty() {
        text.push('0');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Tower;

    #[test]
    fn spelled_numbers_read_back() {
        let tower = Tower::new(64);
        let number = |text: &str| text.parse().unwrap_or_else(|()| Surd::zero());
        let root = |own: &Surd| tower.square_root(own).unwrap_or_else(|_| Surd::zero());
        let (two, three) = (root(&number("2")), root(&number("3")));
        let nested = root(&(&(&number("45") * &two) + &number("10")));
        let value = &(&number("3/2") - &(&nested * &two)) + &(&two * &number("1/4"));
        let basis = Basis::of([value.numerator()]);
        assert_eq!(basis.spell(&value), "3/2 + 1/4*r1 - r1*r2");
        assert_eq!(basis.read("3/2 + 1/4*r1 - r1*r2"), Some(value.clone()));
        assert_eq!(basis.read("-r1"), Some(-&two));
        assert_eq!(basis.read("r3"), None);
        assert_eq!(basis.read("1 r1"), None);
        let definitions = basis.definitions();
        assert_eq!(definitions[0], ("r1".to_owned(), "2".to_owned()));
        assert_eq!(definitions[1].0, "r2");
        // √3 does not occur
        assert_eq!((basis.degree(), tower.degree()), (4, 8));
        assert!(!basis.spell(&three).contains('r'));
    }
}
