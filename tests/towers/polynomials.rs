//! One suite of polynomial laws, tried over the rational numbers and over the towers.

use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use sweepc::number::{Field, Rational, Surd};
use sweepc::poly::{
    BiPoly, SquareTest, UniPoly, bernstein, certify_coprime, count_roots, de_casteljau,
    exact_div_bi, from_bernstein, gcd, gcd_bi, lcm, odd_part, real_roots, resultant, sign_change,
    square_free, square_test, subdivide,
};

use crate::cases::for_all;
use crate::fields::{SMALL_FIELDS, Spec, field, small_number};

type Outcome = Result<(), TestCaseError>;

/// A field that the suite is tried over.
trait Kind: Field {
    fn of(index: usize, spec: &Spec) -> Self;
}

impl Kind for Rational {
    fn of(index: usize, spec: &Spec) -> Self {
        field(index).rational(spec)
    }
}

impl Kind for Surd {
    fn of(index: usize, spec: &Spec) -> Self {
        field(index).number(spec).exact
    }
}

/// Polynomials and numbers of one field.
struct Case<F: Field> {
    polynomials: Vec<UniPoly<F>>,
    numbers: Vec<F>,
}

type Specs = (usize, Vec<Vec<Spec>>, Vec<Spec>);

/// Polynomials of at most so many coefficients, 0 and constants among them.
fn specs(polynomials: usize, length: usize, numbers: usize) -> impl Strategy<Value = Specs> {
    let coefficients = prop_oneof![
        1 => prop::collection::vec(small_number(), 0..=length),
        4 => prop::collection::vec(small_number(), length - 1..=length),
    ];
    (
        0..SMALL_FIELDS,
        prop::collection::vec(coefficients, polynomials),
        prop::collection::vec(small_number(), numbers),
    )
}

fn case<F: Kind>((index, polynomials, numbers): &Specs) -> Case<F> {
    let read = |list: &Vec<Spec>| list.iter().map(|own| F::of(*index, own)).collect();
    let polynomials = polynomials.iter().map(|list| {
        let coefficients: Vec<F> = read(list);
        UniPoly::from_coefficients(&coefficients)
    });
    Case {
        polynomials: polynomials.collect(),
        numbers: read(numbers),
    }
}

/// Tries a law over both fields on so many cases each.
fn over_both(
    cases: u32,
    shape: impl Strategy<Value = Specs>,
    rational: impl Fn(&Case<Rational>) -> Outcome,
    irrational: impl Fn(&Case<Surd>) -> Outcome,
) {
    for_all(cases, shape, |specs| {
        rational(&case(&specs))?;
        irrational(&case(&specs))
    });
}

/// Σ cᵢ xⁱ by powers.
fn value<F: Field>(polynomial: &UniPoly<F>, at: &F) -> F {
    let mut power = F::one();
    polynomial
        .coefficients()
        .iter()
        .fold(F::zero(), |sum, own| {
            let sum = sum.plus(&own.times(&power));
            power = power.times(at);
            sum
        })
}

fn line<F: Field>(root: &F) -> UniPoly<F> {
    UniPoly::from_coefficients(&[root.negated(), F::one()])
}

fn divides<F: Field>(divisor: &UniPoly<F>, dividend: &UniPoly<F>) -> bool {
    dividend.is_zero() || dividend.exact_div(divisor).is_some()
}

fn ring<F: Field>(case: &Case<F>) -> Outcome {
    let [p, q, r] = [0, 1, 2].map(|index| &case.polynomials[index]);
    let [x, y] = [0, 1].map(|index| &case.numbers[index]);
    let (sum, product) = (p + q, p * q);
    for power in 0..8 {
        let schoolbook = (0..=power).fold(F::zero(), |sum, own| {
            sum.plus(&p.coefficient(own).times(&q.coefficient(power - own)))
        });
        prop_assert_eq!(product.coefficient(power), schoolbook);
        let both = p.coefficient(power).plus(&q.coefficient(power));
        prop_assert_eq!(sum.coefficient(power), both);
    }
    prop_assert_eq!(p.evaluate(x), value(p, x));
    prop_assert_eq!(product.evaluate(x), value(p, x).times(&value(q, x)));
    prop_assert_eq!(&(p - q) + q, p.clone());
    prop_assert_eq!(p * &(q + r), &(p * q) + &(p * r));
    prop_assert_eq!(p.scale(x).evaluate(y), p.evaluate(y).times(x));
    prop_assert_eq!(p.compose(q).evaluate(x), p.evaluate(&q.evaluate(x)));
    let segment = UniPoly::from_coefficients(&[x.clone(), y.minus(x)]);
    prop_assert_eq!(p.restrict(x, y), p.compose(&segment));
    let leibniz = &(&p.derivative() * q) + &(p * &q.derivative());
    prop_assert_eq!(product.derivative(), leibniz);
    prop_assert_eq!(&p.antiderivative().derivative(), p);
    prop_assert_eq!(p.power(3), &(p * p) * p);
    Ok(())
}

fn division<F: Field>(case: &Case<F>) -> Outcome {
    let [p, q, r] = [0, 1, 2].map(|index| &case.polynomials[index]);
    if q.is_zero() {
        prop_assert!(p.div_rem(q).is_none() && p.exact_div(q).is_none());
        return Ok(());
    }
    let (quotient, rest) = p.div_rem(q).unwrap();
    prop_assert_eq!(&(&(&quotient * q) + &rest), p);
    prop_assert!(rest.degree() < q.degree());
    prop_assert_eq!(p.exact_div(q).is_some(), rest.is_zero());
    let product = r * q;
    prop_assert_eq!(product.exact_div(q), Some(r.clone()));
    if !q.is_constant() {
        prop_assert_eq!((&product + &UniPoly::one()).exact_div(q), None);
    }
    let monic = q.monic();
    prop_assert_eq!(monic.leading_coefficient(), F::one());
    prop_assert_eq!(&monic.scale(&q.leading_coefficient()), q);
    let primitive = q.primitive();
    prop_assert_eq!(&primitive.primitive(), &primitive);
    prop_assert_eq!(primitive.monic(), monic);
    for factor in case.numbers.iter().filter(|own| !own.is_zero()) {
        prop_assert_eq!(&q.scale(factor).primitive(), &primitive);
    }
    Ok(())
}

fn divisors<F: Field>(case: &Case<F>) -> Outcome {
    let [p, q, g] = [0, 1, 2].map(|index| &case.polynomials[index]);
    let (left, right) = (p * g, q * g);
    let (inner, outer) = (gcd(p, q), gcd(&left, &right));
    prop_assert_eq!(&outer, &(&inner * g).primitive());
    prop_assert_eq!(&outer, &gcd(&right, &left));
    if outer.is_zero() {
        return Ok(());
    }
    prop_assert!(divides(&outer, &left) && divides(&outer, &right));
    prop_assert_eq!((&lcm(p, q) * &inner).primitive(), (p * q).primitive());
    let coprime = outer.is_constant();
    prop_assert_eq!(certify_coprime(&[&left, &right]).is_some(), coprime);
    if !(left.is_zero() || right.is_zero()) {
        prop_assert_eq!(!resultant(&left, &right).is_zero(), coprime);
    }
    Ok(())
}

fn squares<F: Field>(case: &Case<F>) -> Outcome {
    let [p, q] = [0, 1].map(|index| &case.polynomials[index]);
    let factor = &case.numbers[0];
    let square = (p * p).scale(factor);
    let SquareTest::Square { factor, root } = square_test(&square) else {
        return Err(TestCaseError::fail("a planted square was not found"));
    };
    prop_assert_eq!(&(&root * &root).scale(&factor), &square);
    prop_assert_eq!(&root.primitive(), &root);
    let other = &square * q;
    let odd = odd_part(&other);
    match square_test(&other) {
        SquareTest::Square { factor, root } => {
            prop_assert!(odd.is_constant());
            prop_assert_eq!(&(&root * &root).scale(&factor), &other);
        }
        SquareTest::NotSquare { odd_part } => {
            prop_assert!(!odd.is_constant());
            prop_assert_eq!(odd_part, odd);
        }
    }
    // p² + 1 has no real root, and 1 + p² = c r² only for a constant p
    let near = &(p * p) + &UniPoly::one();
    let found = matches!(square_test(&near), SquareTest::Square { .. });
    prop_assert_eq!(found, p.is_constant());
    let factors = square_free(&other);
    let rebuilt = factors
        .iter()
        .fold(UniPoly::one(), |rebuilt, (own, power)| {
            &rebuilt * &own.power(*power)
        });
    if !other.is_zero() {
        prop_assert_eq!(rebuilt.primitive(), other.primitive());
    }
    for (own, _) in &factors {
        prop_assert!(gcd(own, &own.derivative()).is_constant());
    }
    Ok(())
}

/// The planted roots with their multiplicities, ascending.
fn planted<F: Field>(numbers: &[F]) -> Vec<(F, u32)> {
    let mut sorted = numbers.to_vec();
    sorted.sort();
    let mut roots: Vec<(F, u32)> = Vec::new();
    for own in sorted {
        match roots.last_mut() {
            Some((last, multiplicity)) if *last == own => *multiplicity += 1,
            _ => roots.push((own, 1)),
        }
    }
    roots
}

fn roots<F: Field>(case: &Case<F>) -> Outcome {
    let (ends, numbers) = case.numbers.split_at(2);
    let (from, to) = ((&ends[0]).min(&ends[1]), (&ends[0]).max(&ends[1]));
    // a factor without real roots changes nothing
    let p = &case.polynomials[0];
    let start = &(p * p) + &UniPoly::one();
    let lines = numbers.iter().map(line);
    let product = lines.fold(start, |product, own| &product * &own);
    let planted = planted(numbers);
    let inside = planted.iter().filter(|(own, _)| (from..=to).contains(&own));
    let inside: Vec<_> = inside.collect();
    let found = real_roots(&product, from, to);
    prop_assert_eq!(found.len(), inside.len());
    if from < to {
        prop_assert_eq!(count_roots(&product, from, to), inside.len());
    }
    for (root, (own, multiplicity)) in found.iter().zip(&inside) {
        prop_assert_eq!(root.multiplicity(), *multiplicity);
        let mut narrow = root.clone();
        narrow.refine(&F::from_parts(sweepc::number::Ring::one(), 1_000.into()));
        for root in [root, &narrow] {
            if root.is_exact() {
                prop_assert_eq!(root.lower(), own);
            } else {
                prop_assert!(root.lower() < own && own < root.upper());
            }
            prop_assert!(from <= root.lower() && root.upper() <= to);
        }
    }
    for pair in found.windows(2) {
        prop_assert!(pair[0].upper() < pair[1].lower());
    }
    let odd = |own: &&&(F, u32)| own.1 % 2 == 1 && *from < own.0 && own.0 < *to;
    let change = sign_change(&product, from, to);
    let expected = inside.iter().find(odd);
    prop_assert_eq!(change.is_some(), expected.is_some());
    if let (Some(change), Some((own, _))) = (change, expected) {
        prop_assert!(change.lower() <= own && own <= change.upper());
    }
    Ok(())
}

fn bernstein_forms<F: Field>(case: &Case<F>) -> Outcome {
    let p = &case.polynomials[0];
    let [from, to, at] = [0, 1, 2].map(|index| &case.numbers[index]);
    let width = to.minus(from);
    let coefficients = bernstein(p, 4, from, to);
    prop_assert_eq!(coefficients.len(), 5);
    let global = from.plus(&at.times(&width));
    prop_assert_eq!(de_casteljau(&coefficients, at), value(p, &global));
    prop_assert_eq!(&coefficients[0], &value(p, from));
    prop_assert_eq!(&coefficients[4], &value(p, to));
    if width.is_zero() {
        return Ok(());
    }
    prop_assert_eq!(&from_bernstein(&coefficients, from, to), p);
    let own = from_bernstein(&case.numbers, from, to);
    let back = bernstein(&own, case.numbers.len() - 1, from, to);
    prop_assert_eq!(&back, &case.numbers);
    let (left, right) = subdivide(&coefficients, at);
    prop_assert_eq!(left, bernstein(p, 4, from, &global));
    prop_assert_eq!(right, bernstein(p, 4, &global, to));
    Ok(())
}

/// f(u) g(v) + h(u) k(v)
fn bivariate<F: Field>(list: &[UniPoly<F>]) -> BiPoly<F> {
    &BiPoly::product(&list[0], &list[1]) + &BiPoly::product(&list[2], &list[3])
}

fn bivariate_ring<F: Field>(case: &Case<F>) -> Outcome {
    let (p, q) = (
        bivariate(&case.polynomials[..4]),
        bivariate(&case.polynomials[4..]),
    );
    let [x, y] = [0, 1].map(|index| &case.numbers[index]);
    let schoolbook = |own: &BiPoly<F>| {
        let rows = own.rows();
        let rows: Vec<F> = rows.iter().map(|row| value(row, y)).collect();
        value(&UniPoly::from_coefficients(&rows), x)
    };
    let [f, g, h, k] = [0, 1, 2, 3].map(|index| &case.polynomials[index]);
    let by_terms = value(f, x)
        .times(&value(g, y))
        .plus(&value(h, x).times(&value(k, y)));
    prop_assert_eq!(p.evaluate(x, y), by_terms.clone());
    prop_assert_eq!(schoolbook(&p), by_terms);
    let product = &p * &q;
    prop_assert_eq!(schoolbook(&product), schoolbook(&p).times(&schoolbook(&q)));
    prop_assert_eq!(&(&p - &q) + &q, p.clone());
    prop_assert_eq!(&BiPoly::from_rows(&product.rows()), &product);
    prop_assert_eq!(&BiPoly::from_columns(&product.columns()), &product);
    prop_assert_eq!(&product.transpose().transpose(), &product);
    prop_assert_eq!(product.at_u(x).evaluate(y), product.at_v(y).evaluate(x));
    prop_assert_eq!(product.is_zero(), p.is_zero() || q.is_zero());
    let leibniz = |d: fn(&BiPoly<F>) -> BiPoly<F>| d(&product) == &(&d(&p) * &q) + &(&p * &d(&q));
    prop_assert!(leibniz(BiPoly::derivative_u) && leibniz(BiPoly::derivative_v));
    Ok(())
}

fn bivariate_divisors<F: Field>(case: &Case<F>) -> Outcome {
    let list = &case.polynomials;
    let (p, q, g) = (
        bivariate(&list[..4]),
        bivariate(&list[4..8]),
        bivariate(&list[8..12]),
    );
    let [f, h] = [&list[12], &list[13]];
    let (left, right) = (&p * &g, &q * &g);
    let (inner, outer) = (gcd_bi(&p, &q), gcd_bi(&left, &right));
    prop_assert_eq!(&outer, &(&inner * &g).primitive());
    if !g.is_zero() {
        prop_assert_eq!(exact_div_bi(&left, &g), Some(p.clone()));
    }
    if !outer.is_zero() {
        prop_assert!(exact_div_bi(&left, &outer).is_some());
        prop_assert!(exact_div_bi(&right, &outer).is_some());
    }
    let spread = &p * &BiPoly::product(f, h);
    if spread.is_zero() {
        return Ok(());
    }
    prop_assert_eq!(spread.content_u(), (&p.content_u() * f).primitive());
    prop_assert_eq!(spread.content_v(), (&p.content_v() * h).primitive());
    let quotient = spread.exact_div_u(f).and_then(|own| own.exact_div_v(h));
    prop_assert_eq!(quotient, Some(p));
    Ok(())
}

#[test]
fn polynomials_form_a_ring() {
    over_both(6_000, specs(3, 4, 2), ring, ring);
}

#[test]
fn division_undoes_multiplication() {
    over_both(5_000, specs(3, 4, 2), division, division);
}

#[test]
fn planted_divisors_are_found() {
    over_both(3_000, specs(3, 3, 0), divisors, divisors);
}

#[test]
fn planted_squares_are_found() {
    over_both(3_000, specs(2, 3, 1), squares, squares);
}

#[test]
fn planted_roots_are_found() {
    over_both(2_000, specs(1, 2, 5), roots, roots);
}

#[test]
fn bernstein_coefficients_are_the_polynomial() {
    over_both(4_000, specs(1, 5, 4), bernstein_forms, bernstein_forms);
}

#[test]
fn bivariate_polynomials_form_a_ring() {
    over_both(2_500, specs(8, 3, 2), bivariate_ring, bivariate_ring);
}

#[test]
fn planted_bivariate_divisors_are_found() {
    over_both(600, specs(14, 2, 0), bivariate_divisors, bivariate_divisors);
}
