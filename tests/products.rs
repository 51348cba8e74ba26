//! Long products are held as their factors until their coefficients are asked for: what they say
//! before that is true.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests state facts"
)]

use proptest::prelude::*;
use sweepc::export::RoundedNet;
use sweepc::net::ControlNet;
use sweepc::number::{Field, Real};
use sweepc::poly::{BiPoly, UniPoly, common_factor_v};

type Poly = UniPoly<Real>;

/// Σ aᵢ bₖ xⁱ⁺ᵏ, coefficient by coefficient.
fn multiplied(left: &Poly, right: &Poly) -> Poly {
    let (left, right) = (left.coefficients(), right.coefficients());
    let mut sums = vec![Real::from(0); (left.len() + right.len()).saturating_sub(1)];
    for (i, a) in left.iter().enumerate() {
        for (k, b) in right.iter().enumerate() {
            sums[i + k] = sums[i + k].plus(&a.times(b));
        }
    }
    Poly::from_coefficients(&sums)
}

fn number() -> impl Strategy<Value = Real> {
    let part = prop_oneof![
        2 => Just(0),
        3 => -3_i64..=3,
        2 => (-20_i64..20).prop_map(|own| 6 * own),
        1 => any::<i64>(),
    ];
    (part, prop_oneof![Just(1_i64), Just(6), 1_i64..50])
        .prop_map(|(above, below)| Real::from(above).times(&Real::from(below).inverse().unwrap()))
}

/// Short polynomials, and such as have long products; 0 and monomials among them.
fn polynomial() -> impl Strategy<Value = Poly> {
    let list = |range| prop::collection::vec(number(), range);
    prop_oneof![
        1 => list(0..4).boxed(),
        5 => list(15..22).boxed(),
        1 => (0_usize..30, number()).prop_map(|(power, own)| {
            let mut list = vec![Real::from(0); power];
            list.push(own);
            list
        }).boxed(),
    ]
    .prop_map(|list| Poly::from_coefficients(&list))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn products_are_what_they_multiply_out_to(
        a in polynomial(), b in polynomial(), c in polynomial(), factor in number(),
    ) {
        let whole = multiplied(&a, &b);
        // each question to a product of which nothing was asked before
        let product = || &a * &b;
        prop_assert_eq!(product().degree(), whole.degree());
        prop_assert_eq!(product().leading_coefficient(), whole.leading_coefficient());
        prop_assert_eq!(product().coefficient(0), whole.coefficient(0));
        prop_assert_eq!(product().coefficient(7), whole.coefficient(7));
        prop_assert_eq!(product().content(), whole.content());
        prop_assert_eq!(product().denominator().clone(), whole.denominator().clone());
        prop_assert_eq!(product().primitive(), whole.primitive());
        prop_assert_eq!(product().scale(&factor), multiplied(&whole, &Poly::constant(&factor)));
        prop_assert_eq!(-&product(), multiplied(&whole, &Poly::constant(&Real::from(-1))));
        prop_assert_eq!(product(), &b * &a);
        prop_assert_eq!(&product() * &c, multiplied(&whole, &c));
        prop_assert_eq!(&product() + &c, &whole + &c);
        prop_assert_eq!(product() == &product() + &Poly::one(), false);
        prop_assert_eq!(product().coefficients(), whole.coefficients());
        prop_assert_eq!(product(), whole);
    }

    #[test]
    fn common_factors_of_products_are_those_of_what_they_multiply_out_to(
        a in polynomial(), b in polynomial(), c in polynomial(), d in polynomial(),
    ) {
        prop_assume!(!a.is_zero());
        let u = Poly::variable();
        let surface = |times: fn(&Poly, &Poly) -> Poly| {
            let constant = BiPoly::in_v(&times(&a, &b));
            &constant + &BiPoly::product(&u, &times(&times(&c, &d), &a))
        };
        let [own, whole] = [surface(|left, right| left * right), surface(multiplied)];
        prop_assert_eq!(own.bidegree(), whole.bidegree());
        prop_assert_eq!(common_factor_v(&a, &[&own]), common_factor_v(&a, &[&whole]));
        prop_assert_eq!(own, whole);
    }

    #[test]
    fn nets_of_products_are_those_of_what_they_multiply_out_to(
        factors in prop::collection::vec((polynomial(), polynomial()), 4),
        profile in prop::collection::vec(number(), 1..20),
        unit in any::<bool>(),
    ) {
        let profile = Poly::from_coefficients(&profile);
        let coordinates = |times: fn(&Poly, &Poly) -> Poly| {
            let own = |index: usize| {
                let [(a, b), (c, _)] = [&factors[index], &factors[(index + 1) % 4]];
                &BiPoly::in_v(&times(a, b)) + &BiPoly::product(&profile, &times(c, b))
            };
            [own(0), own(1), own(2), own(3)]
        };
        let [start, end] = if unit { ["0", "1"] } else { ["-1/3", "2"] };
        let ends: [Real; 2] = [start, end].map(|own| own.parse().unwrap());
        let domain = (&ends[0], &ends[1]);
        let net = |coordinates: [BiPoly<Real>; 4]| {
            ControlNet::bezier(coordinates.each_ref(), domain, domain)
        };
        let own = net(coordinates(|left, right| left * right));
        let whole = net(coordinates(multiplied));
        prop_assert_eq!(own.is_some(), whole.is_some());
        if let (Some(own), Some(whole)) = (own, whole) {
            let doubles = [&own, &whole].map(|net| RoundedNet::new(net).map_err(|own| own.code));
            prop_assert_eq!(&doubles[0], &doubles[1]);
            prop_assert_eq!(own.points(), whole.points());
            prop_assert_eq!(own.weights(), whole.weights());
        }
    }
}
