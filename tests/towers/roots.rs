//! The square roots of a tower: what they square to, and how far the field grows.

use proptest::prelude::*;
use sweepc::number::{Complex, Field as _, Integer, RootFault, Surd, Tower};

use crate::cases::for_all;
use crate::fields::{Field, Spec, field, number, small_number};

fn ratio((n, d): (i64, i64)) -> Surd {
    Surd::ratio(n.into(), d.into())
}

#[test]
fn squares_have_their_roots_in_the_field() {
    for_all(6_000, (0_usize..20, number()), |(index, spec)| {
        let field = field(index);
        let own = field.number(&spec).exact;
        let (size, square) = (own.absolute(), &own * &own);
        let tower = field.tower.fork();
        prop_assert_eq!(tower.square_root(&square), Ok(size.clone()));
        prop_assert_eq!(tower.degree(), field.tower.degree());
        prop_assert_eq!(tower.root_in_field(&square), Some(size.clone()));
        let level = |own: &Surd| own.level().map_or(0, |top| top.level());
        let expected = (level(&own) <= level(&square)).then_some(size);
        prop_assert_eq!(square.square_root(), expected);
        if !own.is_zero() {
            prop_assert_eq!(tower.root_in_field(&-&square), None);
            prop_assert_eq!(tower.square_root(&-&square), Err(RootFault::Negative));
        }
        Ok(())
    });
}

#[test]
fn roots_square_to_their_radicands() {
    for_all(4_000, (0_usize..20, number()), |(index, spec)| {
        let field = field(index);
        let radicand = field.number(&spec);
        let tower = field.tower.fork();
        let held = tower.root_in_field(&radicand.exact.absolute());
        let found = radicand.root(&tower).unwrap();
        prop_assert_eq!(&found.exact * &found.exact, radicand.exact.absolute());
        prop_assert_eq!(found.exact.sign(), found.ball.sign());
        let growth = if held.is_some() { 1 } else { 2 };
        prop_assert_eq!(tower.degree(), growth * field.tower.degree());
        if let Some(held) = held {
            prop_assert_eq!(&held, &found.exact);
        }
        // The same root again, and its double, need no further generator.
        let four = &radicand.exact.absolute() * &Surd::from(4);
        let double = &found.exact * &Surd::from(2);
        prop_assert_eq!(tower.square_root(&four), Ok(double));
        prop_assert_eq!(tower.degree(), growth * field.tower.degree());
        Ok(())
    });
}

#[test]
fn rational_multiples_of_squares_need_one_rational_root() {
    let cases = (0_usize..20, number(), 1_i64..40, 1_i64..40);
    for_all(3_000, cases, |(index, spec, n, d)| {
        let field = field(index);
        let own = field.number(&spec).exact;
        let (tower, factor) = (field.tower.fork(), ratio((n, d)));
        let root = tower.square_root(&factor).unwrap();
        let degree = tower.degree();
        let found = tower.square_root(&(&factor * &(&own * &own)));
        prop_assert_eq!(found, Ok(&root * &own.absolute()));
        prop_assert_eq!(tower.degree(), degree);
        Ok(())
    });
}

#[test]
fn sums_of_two_roots_are_found_in_their_squares() {
    let positive = || (1_i64..60, 1_i64..12);
    let cases = (positive(), positive(), any::<bool>());
    for_all(4_000, cases, |(p, q, minus)| {
        // √(p + q ± 2√(pq)) = |√p ± √q|, in whatever order the roots are asked for
        let tower = Tower::new(4);
        let (p, q) = (ratio(p), ratio(q));
        let cross = tower.square_root(&(&p * &q)).unwrap();
        let cross = &cross * &Surd::from(if minus { -2 } else { 2 });
        let found = tower.square_root(&(&(&p + &q) + &cross)).unwrap();
        let [first, second] = [p, q].map(|own| tower.square_root(&own).unwrap());
        let expected = if minus {
            &first - &second
        } else {
            &first + &second
        };
        prop_assert_eq!(found, expected.absolute());
        Ok(())
    });
}

#[test]
fn roots_of_binomials_denest_exactly_if_their_norm_is_a_square() {
    let cases = (1_i64..60, -30_i64..30, 2_i64..12);
    for_all(4_000, cases, |(a, b, radicand)| {
        let tower = Tower::new(4);
        let root = tower.square_root(&radicand.into()).unwrap();
        let own = &Surd::from(a) + &(&Surd::from(b) * &root);
        if own.sign().is_le() || own.is_rational() {
            return Ok(());
        }
        let norm = a * a - b * b * radicand;
        let denests = norm >= 0 && Surd::from(norm).square_root().is_some();
        let found = tower.square_root(&own).unwrap();
        prop_assert_eq!(&found * &found, own);
        // Then every generator is the root of a rational number.
        let chain = tower.top().unwrap().chain();
        let plain = chain.iter().all(|own| own.square().level().is_none());
        prop_assert_eq!(plain, denests);
        Ok(())
    });
}

/// The rank of the vectors of exponents modulo 2 of these primes.
fn rank(numbers: &[(i64, i64)]) -> u32 {
    let parity = |(n, d): &(i64, i64)| {
        let primes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
        primes
            .iter()
            .enumerate()
            .fold(0_u32, |parity, (bit, prime)| {
                let mut rest = n * d;
                let mut odd = false;
                while rest % prime == 0 {
                    rest /= prime;
                    odd = !odd;
                }
                parity | u32::from(odd) << bit
            })
    };
    let mut basis: Vec<u32> = Vec::new();
    for own in numbers.iter().map(parity) {
        let rest = basis.iter().fold(own, |rest, known| rest.min(rest ^ known));
        if rest != 0 {
            basis.push(rest);
            basis.sort_unstable_by(|one, other| other.cmp(one));
        }
    }
    basis.len().try_into().unwrap()
}

#[test]
fn rational_radicals_are_as_independent_as_their_exponents() {
    let radicand = prop_oneof![
        (1_i64..38, 1_i64..38),
        (
            prop::sample::select(vec![2_i64, 3, 6, 8, 12, 18]),
            prop::sample::select(vec![1_i64, 2, 3, 27, 24])
        ),
    ];
    for_all(5_000, prop::collection::vec(radicand, 1..5), |list| {
        let degree = 1 << rank(&list);
        let tower = Tower::new(degree);
        for own in &list {
            let found = tower.square_root(&ratio(*own)).unwrap();
            prop_assert_eq!(&found * &found, ratio(*own));
        }
        prop_assert_eq!(tower.degree(), degree);
        // One less than needed is a fault, and the tower stays as it is.
        if degree > 1 {
            let small = Tower::new(degree / 2);
            let fault = list
                .iter()
                .find_map(|own| small.square_root(&ratio(*own)).err());
            prop_assert_eq!(fault, Some(RootFault::DegreeLimit { limit: degree / 2 }));
            prop_assert_eq!(small.degree(), degree / 2);
        }
        Ok(())
    });
}

#[test]
fn forks_grow_apart_until_they_are_adopted() {
    for_all(1_000, (0_usize..20, number()), |(index, spec)| {
        let tower = field(index).tower.fork();
        let (degree, fork) = (tower.degree(), tower.fork());
        let radicand = field(index).number(&spec).exact.absolute();
        let root = fork.square_root(&radicand).unwrap();
        prop_assert_eq!(tower.degree(), degree);
        let held = tower.root_in_field(&radicand).is_some();
        prop_assert_eq!(held, fork.degree() == degree);
        tower.adopt(&fork);
        prop_assert_eq!(tower.root_in_field(&radicand), Some(root));
        Ok(())
    });
}

#[test]
fn complex_roots_square_to_their_radicands() {
    let cases = (0_usize..12, small_number(), small_number());
    for_all(1_500, cases, |(index, real, imaginary)| {
        let field = field(index);
        let tower = field.tower.fork();
        let [real, imaginary] = [real, imaginary].map(|own| field.number(&own).exact);
        let own = Complex::new(real, imaginary);
        let square = own.times(&own);
        let root = square.square_root(&tower).unwrap();
        prop_assert_eq!(tower.degree(), field.tower.degree());
        prop_assert!(root == own || root == own.negated());
        prop_assert!(root.is_principal());
        let root = own.square_root(&tower).unwrap();
        prop_assert!(root.times(&root) == own && root.is_principal());
        prop_assert!(tower.degree() <= 4 * field.tower.degree());
        Ok(())
    });
}

#[test]
fn large_towers_answer() {
    let fields = [
        "2 r ; 3 r ; 5 r ; 7 r ; 11 r ; 13 r",
        "2 r ; 3 r ; 2 r 3 r + r ; 5 r ; 5 r 2 r + r ; 7 r 1 + r",
    ]
    .map(Field::new);
    assert!(fields.iter().all(|own| own.tower.degree() >= 64));
    let term = || (-9_i64..=9, 1_i64..=6, 0_usize..64);
    let dense = || prop::collection::vec(term(), 1..64).prop_map(Spec::Sum);
    for_all(40, (0_usize..2, dense(), dense()), |(index, one, other)| {
        let field = &fields[index];
        let (one, other) = (field.number(&one), field.number(&other));
        let own = one.exact.absolute();
        let tower = field.tower.fork();
        prop_assert_eq!(tower.square_root(&(&own * &own)), Ok(own));
        let radicand = one.times(&other);
        let root = radicand.root(&tower).unwrap().exact;
        prop_assert_eq!(&root * &root, radicand.exact.absolute());
        Ok(())
    });
}

#[test]
fn high_towers_have_places() {
    for text in [
        "2 r ; 3 r ; 5 r ; 7 r ; 11 r ; 13 r ; 17 r ; 19 r",
        "2 r 1 + r 1 + r 1 + r 1 + r 1 + r 1 + r",
        "2 r r r r r r r",
        "7 r 1 - r 3 + r 1 - r 2 + r 1 - r 5 + r",
    ] {
        let top = Field::new(text).tower.top().unwrap();
        assert!(top.place().is_some(), "{text}");
    }
}

#[test]
fn long_numerators_and_denominators_have_roots() {
    let prime = Integer::from(10).power(40) + Integer::from(121);
    for_all(
        300,
        (number(), 1_u32..12, 1_u32..12),
        |(spec, above, below)| {
            let field = field(3);
            let tower = field.tower.fork();
            let scale = Surd::ratio(prime.power(above), Integer::from(7).power(below * 30));
            let own = &field.number(&spec).exact.absolute() * &scale;
            let root = tower.square_root(&own).unwrap();
            prop_assert_eq!(&root * &root, own.clone());
            prop_assert_eq!(tower.square_root(&(&own * &own)), Ok(own));
            Ok(())
        },
    );
}
