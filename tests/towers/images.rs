//! Arithmetic modulo a prime, and the homomorphisms to it.

use num_bigint::BigInt;
use num_integer::Integer as _;
use proptest::prelude::*;
use sweepc::number::{Field as _, Modulus, Ring as _};

use crate::cases::for_all;
use crate::fields::{field, triple};

fn moduli() -> Vec<Modulus> {
    let all = std::iter::once(Modulus::mersenne()).chain(Modulus::descending());
    let all = all.filter(|own| own.prime() % 4 == 3);
    all.take(40).collect()
}

/// Residues with a taste for 0, ±1 and the ends of the machine words.
fn residue() -> impl Strategy<Value = u64> {
    prop_oneof![
        1 => 0_u64..4,
        1 => (0_u64..4).prop_map(|own| u64::MAX - own),
        1 => (0_u64..200).prop_map(|own| (1 << 62) - own),
        3 => any::<u64>(),
    ]
}

#[test]
fn images_of_integers_are_remainders() {
    let moduli = moduli();
    let cases = (0_usize..40, residue(), residue(), residue(), 0_u64..100);
    for_all(20_000, cases, |(index, a, b, c, n)| {
        let modulus = &moduli[index];
        let prime = BigInt::from(modulus.prime());
        let long = (BigInt::from(a) << 90_u32) - BigInt::from(b) * c;
        let value = |image: u64| BigInt::from(modulus.lift(image)).mod_floor(&prime);
        let [x, y] = [a, b].map(|own| modulus.embed(own));
        prop_assert_eq!(value(x), BigInt::from(a).mod_floor(&prime));
        prop_assert_eq!(
            value(modulus.embed_integer(&long.clone().into())),
            long.mod_floor(&prime)
        );
        prop_assert_eq!(
            value(modulus.plus(x, y)),
            (BigInt::from(a) + b).mod_floor(&prime)
        );
        prop_assert_eq!(
            value(modulus.minus(x, y)),
            (BigInt::from(a) - b).mod_floor(&prime)
        );
        prop_assert_eq!(
            value(modulus.times(x, y)),
            (BigInt::from(a) * b).mod_floor(&prime)
        );
        prop_assert_eq!(
            value(modulus.power(x, n)),
            BigInt::from(a).modpow(&n.into(), &prime)
        );
        let unit = if x == 0 { 0 } else { modulus.one() };
        prop_assert_eq!(modulus.times(x, modulus.inverse(x)), unit);
        Ok(())
    });
}

#[test]
fn of_a_square_and_its_negative_one_has_a_root() {
    let moduli = moduli();
    for_all(10_000, (0_usize..40, residue()), |(index, a)| {
        let modulus = &moduli[index];
        let own = modulus.embed(a);
        let square = modulus.times(own, own);
        let root = modulus.square_root(square).unwrap();
        prop_assert!(root == own || modulus.plus(root, own) == 0);
        let negative = modulus.square_root(modulus.minus(0, square));
        prop_assert_eq!(negative.is_some(), own == 0);
        // Euler's criterion
        let residue = modulus.power(own, (modulus.prime() - 1) / 2);
        let expected = own == 0 || residue == modulus.one();
        prop_assert_eq!(modulus.square_root(own).is_some(), expected);
        Ok(())
    });
}

#[test]
fn places_are_homomorphisms() {
    for_all(10_000, triple(), |(index, specs)| {
        let [a, b, c] = specs
            .each_ref()
            .map(|own| field(index).number(own).exact.into_parts().0);
        let Some(top) = field(index).tower.top() else {
            return Ok(());
        };
        for place in [
            top.place(),
            [&a, &b, &c]
                .iter()
                .max_by_key(|own| own.height())
                .and_then(|own| own.place()),
        ] {
            let place = place.unwrap();
            let modulus = place.modulus();
            let image = |own: &sweepc::number::SurdInteger| own.image(&place);
            let [x, y, z] = [image(&a), image(&b), image(&c)];
            prop_assert_eq!(image(&a.plus(&b)), modulus.plus(x, y));
            prop_assert_eq!(image(&a.minus(&b)), modulus.minus(x, y));
            prop_assert_eq!(image(&a.times(&b)), modulus.times(x, y));
            let mut sum = c.clone();
            sum.add_product(&a, &b);
            prop_assert_eq!(image(&sum), modulus.plus(z, modulus.times(x, y)));
            prop_assert_eq!(image(&a.negated()), modulus.minus(0, x));
            let twelve = modulus.times(x, modulus.embed(12));
            prop_assert_eq!(image(&a.scaled(&12.into())), twelve);
        }
        for own in top.chain() {
            prop_assert_eq!(own.square().height() < own.level(), true);
            let place = own.place().unwrap();
            let root = sweepc::number::SurdInteger::generator(&own).image(&place);
            let square = own.square().image(&place);
            prop_assert!(square != 0 && place.modulus().times(root, root) == square);
        }
        Ok(())
    });
}
