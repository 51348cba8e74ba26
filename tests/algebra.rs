//! Laws of the polynomial algorithms: each fact reached by two roads, over inputs biased to
//! corners.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a failing law may end the test"
)]

use proptest::prelude::*;
use sweepc::number::{Field, Rational};
use sweepc::poly::{
    Antiderivative, BiPoly, BiSquareTest, Coprimality, SquareTest, UniPoly, ZeroKind, Zeros,
    bernstein, certify_coprime, count_roots, de_casteljau, exact_div_bi, from_bernstein, gcd,
    gcd_all, gcd_bi, integrate, lcm, odd_part, real_roots, resultant, resultant_v, sign_change,
    square_free, square_test, square_test_bi, subdivide, zeros_in_box,
};

type Poly = UniPoly<Rational>;

fn polynomial(coefficients: &[i64]) -> Poly {
    let coefficients: Vec<_> = coefficients.iter().copied().map(Rational::from).collect();
    Poly::from_coefficients(&coefficients)
}

fn line(root: &Rational) -> Poly {
    Poly::from_coefficients(&[-root, Rational::from(1)]).primitive()
}

/// Numbers with a taste for 0, 1, −1 and small fractions.
fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        3 => (-2_i64..=2).prop_map(Rational::from),
        3 => (-12_i64..=12, 1_i64..=6).prop_map(|(n, d)| Rational::new(n.into(), d.into())),
        1 => (any::<i64>(), 1..i64::MAX).prop_map(|(n, d)| Rational::new(n.into(), d.into())),
    ]
}

/// Polynomials of degree at most the given one, zero and constants among them.
fn any_polynomial(degree: usize) -> impl Strategy<Value = Poly> {
    prop::collection::vec(number(), 0..=degree + 1).prop_map(|list| Poly::from_coefficients(&list))
}

fn nonzero(degree: usize) -> impl Strategy<Value = Poly> {
    any_polynomial(degree).prop_map(|p| if p.is_zero() { Poly::one() } else { p })
}

/// A product of powers of lines and of irreducible quadratics, with repetition and a constant
/// of either sign.
fn factored() -> impl Strategy<Value = (Poly, Vec<(Poly, u32)>)> {
    let simple =
        (-6_i64..=6, 1_i64..=4).prop_map(|(n, d)| line(&Rational::new(n.into(), d.into())));
    let surd = prop::sample::select(vec![2_i64, 3, 5, -1, -3])
        .prop_map(|radicand| polynomial(&[-radicand, 0, 1]));
    let factor = (prop_oneof![2 => simple, 1 => surd], 1_u32..=4);
    let constant = number().prop_filter("not 0", |value| !value.is_zero());
    (constant, prop::collection::vec(factor, 0..5)).prop_map(|(constant, factors)| {
        let start = Poly::constant(&constant);
        let product = factors.iter().fold(start, |product, (factor, power)| {
            &product * &factor.power(*power)
        });
        let mut joined: Vec<(Poly, u32)> = Vec::new();
        for (factor, power) in factors {
            match joined.iter_mut().find(|(known, _)| *known == factor) {
                Some((_, total)) => *total += power,
                None => joined.push((factor, power)),
            }
        }
        (product, joined)
    })
}

/// Polynomials in u and v of bidegree at most (3, 3), products and zero among them.
fn bivariate() -> impl Strategy<Value = BiPoly<Rational>> {
    let term = (any_polynomial(3), any_polynomial(3)).prop_map(|(f, g)| BiPoly::product(&f, &g));
    prop::collection::vec(term, 0..4)
        .prop_map(|terms| terms.iter().fold(BiPoly::zero(), |sum, term| &sum + term))
}

/// Small integers for coefficients.
fn small_bivariate(degree: usize) -> impl Strategy<Value = BiPoly<Rational>> {
    let row = prop::collection::vec(-3_i64..=3, degree + 1).prop_map(|row| polynomial(&row));
    prop::collection::vec(row, 1..=degree + 1).prop_map(|rows| BiPoly::from_rows(&rows))
}

fn divides(divisor: &Poly, dividend: &Poly) -> bool {
    dividend.is_zero() || dividend.exact_div(divisor).is_some()
}

/// The roots of the factors in the closed interval, with multiplicities: rational ones by
/// comparison, ±√n by squaring the ends.
fn expected_roots(factors: &[(Poly, u32)], from: &Rational, to: &Rational) -> Vec<u32> {
    let mut multiplicities = Vec::new();
    for (factor, multiplicity) in factors {
        if factor.degree() == Some(1) {
            let root = -&(&factor.coefficient(0) / &factor.coefficient(1));
            if from <= &root && &root <= to {
                multiplicities.push(*multiplicity);
            }
            continue;
        }
        let radicand = factor.coefficient(0).negated();
        let zero = Rational::from(0);
        // below(x): x ≤ √n; above(x): x ≥ √n
        let below = |x: &Rational| *x <= zero || x * x <= radicand;
        let above = |x: &Rational| *x >= zero && x * x >= radicand;
        if radicand > zero {
            let positive = below(from) && above(to);
            let negative = below(&-to) && above(&-from);
            for _ in 0..usize::from(positive) + usize::from(negative) {
                multiplicities.push(*multiplicity);
            }
        }
    }
    multiplicities.sort_unstable();
    multiplicities
}

proptest! {
    #[test]
    fn common_factors_come_out(a in any_polynomial(6), b in any_polynomial(6), g in nonzero(5)) {
        let inner = gcd(&a, &b);
        let outer = gcd(&(&a * &g), &(&b * &g));
        prop_assert_eq!(&outer, &(&inner * &g).primitive());
        if !outer.is_zero() {
            prop_assert!(divides(&outer, &(&a * &g)) && divides(&outer, &(&b * &g)));
        }
        prop_assert_eq!(gcd(&a, &b), gcd(&b, &a));
        let product = (&a * &b).primitive();
        prop_assert_eq!((&lcm(&a, &b) * &inner).primitive(), product);
    }

    #[test]
    fn certificates_agree_with_the_divisor(
        a in nonzero(5), b in nonzero(5), c in any_polynomial(5), g in any_polynomial(3),
    ) {
        let list = [&a * &g, &b * &g, &c * &g];
        let references: Vec<_> = list.iter().collect();
        let common = gcd_all(&list);
        prop_assert_eq!(&common, &gcd(&gcd(&list[0], &list[1]), &list[2]));
        let coprime = common.degree() == Some(0);
        prop_assert_eq!(certify_coprime(&references).is_some(), coprime);
        if coprime && list.iter().any(|own| !own.is_constant()) {
            prop_assert!(matches!(certify_coprime(&references), Some(Coprimality::Modular(_))));
        }
    }

    #[test]
    fn square_free_factors_rebuild_the_polynomial((product, factors) in factored()) {
        let found = square_free(&product);
        let rebuilt = found.iter().fold(Poly::one(), |rebuilt, (factor, multiplicity)| {
            &rebuilt * &factor.power(*multiplicity)
        });
        prop_assert_eq!(rebuilt.primitive(), product.primitive());
        for (factor, multiplicity) in &found {
            let planted = factors.iter().filter(|(_, own)| own == multiplicity);
            let planted = planted.fold(Poly::one(), |all, (own, _)| &all * own);
            prop_assert_eq!(factor, &planted);
        }
        let odd = factors.iter().filter(|(_, own)| own % 2 == 1);
        let odd = odd.fold(Poly::one(), |all, (own, _)| &all * own);
        prop_assert_eq!(&odd_part(&product), &odd);
        match square_test(&product) {
            SquareTest::Square { factor, root } => {
                prop_assert!(odd.is_constant());
                prop_assert_eq!((&root * &root).scale(&factor), product);
                prop_assert_eq!(root.primitive(), root);
            }
            SquareTest::NotSquare { odd_part } => {
                prop_assert!(!odd.is_constant());
                prop_assert_eq!(odd_part, odd);
            }
        }
    }

    #[test]
    fn squares_are_known_and_near_squares_refused(
        root in nonzero(9), factor in number(), place in 0_usize..19, change in number(),
    ) {
        let square = (&root * &root).scale(&factor);
        let SquareTest::Square { factor: found, root: base } = square_test(&square) else {
            panic!("{square} is a square");
        };
        prop_assert_eq!((&base * &base).scale(&found), square.clone());
        let near = &square + &Poly::constant(&change).shift(place);
        let known = match square_test(&near) {
            SquareTest::Square { factor, root } => {
                prop_assert_eq!((&root * &root).scale(&factor), near.clone());
                true
            }
            SquareTest::NotSquare { odd_part } => {
                prop_assert!(divides(&odd_part, &near) && !odd_part.is_constant());
                false
            }
        };
        let even = square_free(&near).iter().all(|(_, multiplicity)| multiplicity % 2 == 0);
        prop_assert_eq!(known, even);
    }

    #[test]
    fn roots_are_those_of_the_known_factors(
        (product, factors) in factored(), a in number(), b in number(),
    ) {
        let (from, to) = (a.clone().min(b.clone()), a.max(b));
        let mut expected = expected_roots(&factors, &from, &to);
        let roots = real_roots(&product, &from, &to);
        prop_assert_eq!(count_roots(&product, &from, &to), expected.len());
        let mut found: Vec<_> = roots.iter().map(|root| root.multiplicity()).collect();
        found.sort_unstable();
        prop_assert_eq!(&found, &expected);
        for pair in roots.windows(2) {
            prop_assert!(pair[0].upper() < pair[1].lower());
        }
        for root in &roots {
            prop_assert!(&from <= root.lower() && root.upper() <= &to);
            prop_assert_eq!(count_roots(&product, root.lower(), root.upper()), 1);
            prop_assert!(divides(root.polynomial(), &product));
            let value = root.polynomial().evaluate(root.lower());
            prop_assert_eq!(root.is_exact(), value.is_zero());
            let mut finer = root.clone();
            let width = Rational::new(1.into(), 1_000.into());
            finer.refine(&width);
            prop_assert!(finer.width() <= width);
            prop_assert!(root.lower() <= finer.lower() && finer.upper() <= root.upper());
            prop_assert_eq!(count_roots(&product, finer.lower(), finer.upper()), 1);
        }
        let exact = factors.iter().filter(|(factor, _)| factor.degree() == Some(1));
        let exact: Vec<_> = exact.cloned().collect();
        expected = expected_roots(&exact, &from, &to);
        prop_assert_eq!(roots.iter().filter(|root| root.is_exact()).count(), expected.len());
        let inside = |root: &&sweepc::poly::RealRoot<Rational>| {
            root.multiplicity() % 2 == 1 && !(root.is_exact() && (root.lower() == &from || root.lower() == &to))
        };
        let first = sign_change(&product, &from, &to);
        prop_assert_eq!(first.as_ref(), roots.iter().find(inside));
    }

    #[test]
    fn dense_polynomials_have_as_many_roots_as_sturm_counts(
        p in nonzero(12), a in number(), b in number(),
    ) {
        let (from, to) = (a.clone().min(b.clone()), a.max(b));
        prop_assert_eq!(real_roots(&p, &from, &to).len(), count_roots(&p, &from, &to));
    }

    #[test]
    fn antiderivatives_lead_back(p in any_polynomial(5), (q, _) in factored()) {
        // (p/q)′ = (p′q − pq′)/q²
        let numerator = &(&p.derivative() * &q) - &(&p * &q.derivative());
        let denominator = &q * &q;
        let Antiderivative::Rational { numerator: top, denominator: bottom } =
            integrate(&numerator, &denominator)
        else {
            panic!("({p})/({q}) is an antiderivative");
        };
        // equal up to a constant: (top q − p bottom) / (bottom q) is one
        let gap = &(&top * &q) - &(&p * &bottom);
        let constant = gap.div_rem(&(&bottom * &q)).unwrap();
        prop_assert!(constant.1.is_zero() && constant.0.is_constant());
        prop_assert!(gcd(&top, &bottom).is_constant());
    }

    #[test]
    fn logarithms_are_named(p in any_polynomial(4), (q, _) in factored(), root in -6_i64..=6) {
        // (p/q)′ + 1/(x²+x+5) + 1/(x−a): just the last two have residues, for a not a pole of q
        let (circle, simple) = (polynomial(&[5, 1, 1]), polynomial(&[-root, 1]));
        prop_assume!(gcd(&simple, &q).is_constant());
        let flat = &(&p.derivative() * &q) - &(&p * &q.derivative());
        let square = &q * &q;
        let both = &circle * &simple;
        let numerator = &(&flat * &both) + &(&square * &(&circle + &simple));
        let logarithmic = integrate(&numerator, &(&square * &both));
        prop_assert_eq!(logarithmic, Antiderivative::NotRational { logarithmic: both });
    }

    #[test]
    fn bernstein_coefficients_evaluate_alike(
        p in any_polynomial(7), extra in 0_usize..3, from in number(), to in number(), t in number(),
    ) {
        prop_assume!(from != to);
        let degree = p.degree().unwrap_or(0) + extra;
        let coefficients = bernstein(&p, degree, &from, &to);
        prop_assert_eq!(coefficients.len(), degree + 1);
        prop_assert_eq!(&from_bernstein(&coefficients, &from, &to), &p);
        let at = &from + &(&t * &(&to - &from));
        prop_assert_eq!(de_casteljau(&coefficients, &t), p.evaluate(&at));
        let (left, right) = subdivide(&coefficients, &t);
        prop_assert_eq!(left, bernstein(&p, degree, &from, &at));
        prop_assert_eq!(right, bernstein(&p, degree, &at, &to));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn bivariate_common_factors_come_out(a in bivariate(), b in bivariate(), g in bivariate()) {
        prop_assume!(!g.is_zero());
        let (left, right) = (&a * &g, &b * &g);
        let inner = gcd_bi(&a, &b);
        let outer = gcd_bi(&left, &right);
        prop_assert_eq!(&outer, &(&inner * &g).primitive());
        prop_assert_eq!(&gcd_bi(&right, &left), &outer);
        prop_assert_eq!(exact_div_bi(&left, &g), Some(a.clone()));
        if !outer.is_zero() {
            let quotients = [&left, &right].map(|own| exact_div_bi(own, &outer).unwrap());
            prop_assert_eq!(&quotients[0] * &outer, left);
            prop_assert_eq!(&quotients[1] * &outer, right);
        }
    }

    #[test]
    fn bivariate_squares_are_known_and_near_squares_refused(
        root in bivariate(), factor in number(), f in nonzero(3), change in number(),
        i in 0_usize..4, j in 0_usize..4,
    ) {
        prop_assume!(!factor.is_zero());
        let square = (&root * &root).scale(&factor);
        let near = &square + &BiPoly::product(
            &Poly::one().shift(i), &Poly::constant(&change).shift(j),
        );
        for candidate in [square.clone(), &square * &BiPoly::in_u(&f), &square * &BiPoly::in_v(&f), near] {
            match square_test_bi(&candidate) {
                BiSquareTest::Square { factor, root } => {
                    prop_assert_eq!((&root * &root).scale(&factor), candidate);
                    prop_assert_eq!(root.primitive(), root);
                }
                BiSquareTest::NotSquare { .. } => {
                    prop_assert!(candidate != square);
                    // the other road: on some line u = const or v = const it is none
                    let refused = (-12..=12).map(Rational::from).any(|at| {
                        [candidate.at_u(&at), candidate.at_v(&at)]
                            .iter()
                            .any(|own| !odd_part(own).is_constant())
                    });
                    prop_assert!(refused);
                }
            }
        }
    }

    #[test]
    fn resultants_vanish_with_a_common_root(a in nonzero(4), b in nonzero(4), root in number()) {
        let common = !gcd(&a, &b).is_constant();
        prop_assert_eq!(resultant(&a, &b).is_zero(), common);
        let both = resultant(&(&a * &line(&root)), &b);
        let split = &resultant(&a, &b) * &resultant(&line(&root), &b);
        prop_assert_eq!(both, split);
    }

    #[test]
    fn elimination_commutes_with_evaluation(
        a in small_bivariate(2), b in small_bivariate(2), u in number(),
    ) {
        prop_assume!(!a.is_zero() && !b.is_zero());
        let (high, low) = (a.at_u(&u), b.at_u(&u));
        let degrees = [&a, &b].map(|own| own.bidegree().map(|degree| degree.v));
        prop_assume!([high.degree(), low.degree()] == degrees);
        prop_assert_eq!(resultant_v(&a, &b).evaluate(&u), resultant(&high, &low));
    }

    #[test]
    fn zeros_agree_with_samples(p in small_bivariate(3), from in -2_i64..=1, size in 1_i64..=2) {
        let (from, to) = (Rational::from(from), Rational::from(from + size));
        let grid: Vec<Rational> = (0..=8)
            .map(|step| &from + &Rational::new((step * size).into(), 8.into()))
            .collect();
        let signs = grid.iter().flat_map(|u| grid.iter().map(|v| p.evaluate(u, v).sign()));
        let signs: Vec<_> = signs.collect();
        match zeros_in_box(&p, (&from, &to), (&from, &to)) {
            Zeros::None => {
                prop_assert!(signs.iter().all(|sign| sign.is_ne() && *sign == signs[0]));
            }
            Zeros::Some(sets) => {
                for set in &sets {
                    prop_assert!(from <= set.u.0 && set.u.1 <= to && set.u.0 <= set.u.1);
                    prop_assert!(from <= set.v.0 && set.v.1 <= to && set.v.0 <= set.v.1);
                    check_zero_set(&p, set)?;
                }
            }
        }
    }

    #[test]
    fn touching_points_are_found_and_missed_when_lifted(
        a in number(), b in number(), slope in -2_i64..=2, weight in 1_i64..=3,
    ) {
        // (u−a)² + w (v−b+s(u−a)²)² vanishes at (a, b) only
        let first = BiPoly::in_u(&Poly::from_coefficients(&[-&a, Rational::from(1)]));
        let second = BiPoly::in_v(&Poly::from_coefficients(&[-&b, Rational::from(1)]));
        let second = &second + &first.power(2).scale(&slope.into());
        let touching = &first.power(2) + &second.power(2).scale(&weight.into());
        let (low, high) = (Rational::from(-1), Rational::from(1));
        let inside = |value: &Rational| &low <= value && value <= &high;
        match zeros_in_box(&touching, (&low, &high), (&low, &high)) {
            Zeros::None => prop_assert!(!inside(&a) || !inside(&b)),
            Zeros::Some(sets) => {
                prop_assert_eq!(sets.len(), 1);
                prop_assert_eq!(&sets[0].u, &(a.clone(), a));
                prop_assert_eq!(&sets[0].v, &(b.clone(), b));
            }
        }
        let lifted = &touching + &BiPoly::constant(&Rational::new(1.into(), 1_000_000.into()));
        prop_assert_eq!(zeros_in_box(&lifted, (&low, &high), (&low, &high)), Zeros::None);
    }
}

#[test]
fn polynomials_are_written_as_one_reads_them() {
    let rows = |rows: &[&[i64]]| {
        let rows: Vec<Poly> = rows.iter().map(|own| polynomial(own)).collect();
        BiPoly::from_rows(&rows).to_string()
    };
    assert_eq!(rows(&[&[0, 1], &[-1]]), "-u + v");
    assert_eq!(rows(&[&[2, 0, -1], &[-3], &[1]]), "u^2 - 3 u - v^2 + 2");
    assert_eq!(rows(&[&[0, 5], &[1, -1]]), "(-v + 1) u + 5 v");
    assert_eq!(rows(&[&[-1]]), "-1");
}

/// u v (u − v) vanishes on two lines, and at the corners on a third.
#[test]
fn zeros_of_lines_and_of_what_they_leave() {
    let product = BiPoly::from_rows(&[
        polynomial(&[]),
        polynomial(&[0, 0, -1]),
        polynomial(&[0, 1]),
    ]);
    let (zero, one) = (Rational::from(0), Rational::from(1));
    let Zeros::Some(sets) = zeros_in_box(&product, (&zero, &one), (&zero, &one)) else {
        panic!("the lines u = 0 and v = 0 are in the box")
    };
    for (kind, count) in [(ZeroKind::LineU, 1), (ZeroKind::LineV, 1)] {
        assert_eq!(sets.iter().filter(|set| set.kind == kind).count(), count);
    }
    assert!(sets.iter().any(|set| set.kind == ZeroKind::Point));
    for set in &sets {
        check_zero_set(&product, set).unwrap();
    }
}

/// A set of zeros holds one: lines by the divisors in one variable alone, points and boxes by what
/// these leave, on which all the other zeros lie.
fn check_zero_set(
    p: &BiPoly<Rational>,
    set: &sweepc::poly::ZeroSet<Rational>,
) -> Result<(), TestCaseError> {
    let (u, v) = (&set.u, &set.v);
    if p.is_zero() {
        prop_assert_eq!(set.kind, ZeroKind::Box);
        return Ok(());
    }
    let rest = p.exact_div_u(&p.content_u()).unwrap();
    let rest = rest.exact_div_v(&p.content_v()).unwrap();
    match set.kind {
        ZeroKind::LineU => prop_assert!(count_roots(&p.content_u(), &u.0, &u.1) == 1),
        ZeroKind::LineV => prop_assert!(count_roots(&p.content_v(), &v.0, &v.1) == 1),
        ZeroKind::Point if u.0 == u.1 => {
            prop_assert!(count_roots(&rest.at_u(&u.0), &v.0, &v.1) == 1);
        }
        ZeroKind::Point => prop_assert!(count_roots(&rest.at_v(&v.0), &u.0, &u.1) == 1),
        ZeroKind::Box => {
            let corners = [(&u.0, &v.0), (&u.0, &v.1), (&u.1, &v.0), (&u.1, &v.1)];
            let signs = corners.map(|(u, v)| rest.evaluate(u, v).sign());
            prop_assert!(signs.contains(&std::cmp::Ordering::Less));
            prop_assert!(signs.contains(&std::cmp::Ordering::Greater));
        }
    }
    Ok(())
}
