use super::{Basis, Modulus, Place, Ring};

/// All places of a field above one prime that splits it: one for each choice of signs of the
/// square roots modulo the prime. Together they determine the components of an element modulo
/// the prime.
#[derive(Debug, Clone)]
pub struct Conjugates {
    modulus: Modulus,
    places: Vec<Place>,
    /// For each generator the images of its root at the places of the field below it.
    roots: Vec<Vec<u64>>,
}

impl Conjugates {
    /// The places above a prime; none if it does not split the field.
    ///
    /// Place number j has the sign − of generator k where bit k of j is set.
    #[must_use]
    pub fn above(basis: &Basis, modulus: &Modulus) -> Option<Self> {
        let mut images = vec![Vec::new()];
        let mut roots = Vec::new();
        let mut levels: Vec<usize> = Vec::new();
        let place = |levels: &[usize], image: &[u64]| {
            let height = levels.last().copied().unwrap_or(0);
            let mut roots = vec![0; height];
            for (level, root) in levels.iter().zip(image) {
                roots[level - 1] = *root;
            }
            Place::new(*modulus, roots)
        };
        for generator in basis.generators() {
            let own = images.iter().map(|image: &Vec<u64>| {
                let square = generator.square().image(&place(&levels, image));
                modulus.square_root(square).filter(|root| *root != 0)
            });
            let own: Vec<u64> = own.collect::<Option<_>>()?;
            let signed = |sign: bool| {
                images.iter().zip(&own).map(move |(image, root)| {
                    let root = if sign { modulus.minus(0, *root) } else { *root };
                    image.iter().copied().chain([root]).collect::<Vec<u64>>()
                })
            };
            images = signed(false).chain(signed(true)).collect();
            levels.push(generator.level());
            roots.push(own);
        }
        Some(Self {
            modulus: *modulus,
            places: images.iter().map(|image| place(&levels, image)).collect(),
            roots,
        })
    }

    /// Arithmetic modulo the prime.
    #[must_use]
    pub fn modulus(&self) -> &Modulus {
        &self.modulus
    }

    /// The places.
    #[must_use]
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// The components of an element modulo the prime from its images at all places: component j
    /// belongs to the product of the generators k whose bit is set in j.
    ///
    /// From x₊ = a + bρ and x₋ = a − bρ: a = (x₊ + x₋)/2, b = (x₊ − x₋)/2ρ, from the top down.
    #[must_use]
    pub fn components(&self, images: &[u64]) -> Vec<u64> {
        let modulus = &self.modulus;
        let half = modulus.inverse(modulus.embed(2));
        let mut values = images.to_vec();
        for (level, roots) in self.roots.iter().enumerate().rev() {
            let width = 1 << level;
            for block in values.chunks_mut(2 * width) {
                let (low, high) = block.split_at_mut(width);
                for ((plus, minus), root) in low.iter_mut().zip(high).zip(roots) {
                    let sum = modulus.times(modulus.plus(*plus, *minus), half);
                    let gap = modulus.times(modulus.minus(*plus, *minus), half);
                    (*plus, *minus) = (sum, modulus.times(gap, modulus.inverse(*root)));
                }
            }
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Surd, Tower};

    #[test]
    fn images_at_all_places_determine_the_components() {
        let tower = Tower::default();
        let number = |text: &str| text.parse().unwrap_or_else(|()| Surd::from(0));
        let root = |own: &Surd| tower.square_root(own).unwrap_or_else(|_| Surd::from(0));
        let two = root(&number("2"));
        let nested = root(&(&(&number("40") * &two) - &number("35")));
        let value = &(&number("7") - &(&two * &number("3"))) + &(&(&nested * &two) * &number("5"));
        let basis = Basis::of([value.numerator(), nested.numerator()]);
        let found = Modulus::descending().find_map(|modulus| Conjugates::above(&basis, &modulus));
        let lifted = found.map(|own| {
            let images = own
                .places()
                .iter()
                .map(|place| value.numerator().image(place));
            let components = own.components(&images.collect::<Vec<_>>());
            let lifted = components.iter().map(|image| own.modulus().lift(*image));
            lifted.collect::<Vec<_>>()
        });
        assert_eq!(lifted, Some(vec![7, -3, 0, 5]));
    }
}
