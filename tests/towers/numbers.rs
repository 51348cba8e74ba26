//! The numbers form an ordered field, in a form of which each has one.

use std::cmp::Ordering;

use proptest::prelude::*;
use sweepc::number::{Basis, Field as _, Integer, Ring as _, Surd, gcd};

use crate::cases::for_all;
use crate::fields::{Number, Spec, field, triple};

fn exact(index: usize, specs: &[Spec; 3]) -> [Surd; 3] {
    specs.each_ref().map(|own| field(index).number(own).exact)
}

#[test]
fn sums_and_products_obey_the_axioms() {
    for_all(12_000, triple(), |(index, specs)| {
        let [a, b, c] = &exact(index, &specs);
        prop_assert_eq!(&(a + b) + c, a + &(b + c));
        prop_assert_eq!(a + b, b + a);
        prop_assert_eq!(&(a * b) * c, a * &(b * c));
        prop_assert_eq!(a * b, b * a);
        prop_assert_eq!(a * &(b + c), &(a * b) + &(a * c));
        prop_assert_eq!(a - b, a + &-b);
        prop_assert!((a - a).is_zero() && (a + &-a).is_zero());
        prop_assert_eq!(&(a + &Surd::zero()), a);
        prop_assert_eq!(&(a * &Surd::one()), a);
        prop_assert_eq!(&-&-a, a);
        prop_assert_eq!(&(a + b) * &(a - b), &(a * a) - &(b * b));
        Ok(())
    });
}

#[test]
fn quotients_undo_products() {
    for_all(8_000, triple(), |(index, specs)| {
        let [a, b, c] = &exact(index, &specs);
        let inverse = b.inverse();
        prop_assert_eq!(inverse.is_none(), b.is_zero());
        prop_assert_eq!(b.power(-2).is_none(), b.is_zero());
        let Some(inverse) = inverse else {
            return Ok(());
        };
        prop_assert_eq!(b * &inverse, Surd::one());
        prop_assert_eq!(inverse.inverse(), Some(b.clone()));
        prop_assert_eq!(&(&(a / b) * b), a);
        prop_assert_eq!(&(&(a * b) / b), a);
        prop_assert_eq!(&(a / b) + &(c / b), &(a + c) / b);
        let cube = &(b * b) * b;
        prop_assert_eq!(b.power(3), Some(cube.clone()));
        prop_assert_eq!(b.power(-3), cube.inverse());
        // in the ring: the product is divisible, and one more is so only by a unit
        let (dividend, divisor) = (a.numerator(), b.numerator());
        let product = dividend.times(divisor);
        let quotient = product.quotient(divisor);
        prop_assert_eq!(quotient.as_ref(), Some(dividend));
        let quotient = Surd::integral(dividend.clone());
        let quotient = &quotient / &Surd::integral(divisor.clone());
        let integral = quotient.denominator().is_one();
        prop_assert_eq!(dividend.quotient(divisor).is_some(), integral);
        Ok(())
    });
}

#[test]
fn numbers_are_in_lowest_terms_and_know_what_they_are() {
    for_all(8_000, triple(), |(index, specs)| {
        let [a, b, c] = &exact(index, &specs);
        // (a + b)³ − … = 0, with c that comes and goes
        let sum = &(a + b) + c;
        let cube = &(&sum * &sum) * &sum;
        let other = &sum.power(3).unwrap() - &(&cube - &(c - &(a + c)));
        prop_assert_eq!(&other, &-a);
        for own in [a, b, &sum, &cube] {
            let (numerator, denominator) = own.parts();
            prop_assert!(*denominator > Integer::from(0));
            prop_assert!(gcd(&numerator.content(), denominator).is_one());
            let factor = Integer::from(-6);
            let scaled = Surd::from_parts(numerator.scaled(&factor), denominator * factor);
            prop_assert_eq!(&scaled, own);
            let rational = own.as_rational();
            prop_assert_eq!(rational.is_some(), own.level().is_none());
            prop_assert_eq!(rational.is_some(), own.is_rational());
            if let Some(rational) = &rational {
                prop_assert_eq!(&Surd::from(rational.clone()), own);
                prop_assert_eq!(own.is_integer(), rational.is_integer());
                prop_assert_eq!(own.to_i64(), rational.to_i64());
            } else {
                prop_assert!(own.to_i64().is_none() && !own.is_integer());
            }
        }
        Ok(())
    });
}

#[test]
fn signs_and_order_are_those_of_the_real_numbers() {
    for_all(16_000, triple(), |(index, specs)| {
        let [a, b, c] = &specs.each_ref().map(|own| field(index).number(own));
        for own in [a, b, c, &a.times(b).minus(&b.times(c))] {
            prop_assert_eq!(own.exact.sign(), own.ball.sign());
            let size = own.exact.absolute();
            prop_assert!(size.sign().is_ge() && &size * &size == &own.exact * &own.exact);
        }
        let order = a.ball.minus(&b.ball).sign();
        prop_assert_eq!(a.exact.cmp(&b.exact), order);
        prop_assert_eq!(b.exact.cmp(&a.exact), order.reverse());
        prop_assert_eq!(a.exact == b.exact, order.is_eq());
        let product = a.times(c).ball.minus(&b.times(c).ball).sign();
        let found = (&a.exact * &c.exact).cmp(&(&b.exact * &c.exact));
        prop_assert_eq!(found, product);
        Ok(())
    });
}

#[test]
fn powers_of_small_conjugates_keep_their_sign() {
    let cases = (0_usize..20, 0_usize..4, 1_u32..120, 1_u32..120);
    for_all(2_000, cases, |(index, radical, first, second)| {
        let [a, b] = [first, second].map(|n| field(index).number(&Spec::Tiny(radical, n % 60)));
        prop_assert_eq!(a.exact.sign(), a.ball.sign());
        let gap = a.minus(&b);
        prop_assert_eq!(gap.exact.sign(), gap.ball.sign());
        let zero = a.times(&b).minus(&b.times(&a));
        prop_assert!(zero.exact.is_zero() && zero.ball.sign().is_eq());
        Ok(())
    });
}

/// A step of a computation: an operation, and which of the numbers so far it takes.
fn program() -> impl Strategy<Value = Vec<(u8, usize, usize)>> {
    prop::collection::vec((0..10_u8, 0..8_usize, 0..8_usize), 2..9)
}

#[test]
fn computations_with_roots_keep_to_the_real_numbers() {
    let starts = prop::collection::vec((-20_i64..=20, 1_i64..=6), 1..4);
    for_all(5_000, (starts, program()), |(starts, program)| {
        let tower = sweepc::number::Tower::new(16);
        let mut numbers: Vec<Number> = Vec::new();
        for (n, d) in starts {
            numbers.push(Number::ratio(n.into(), d.into()));
        }
        for (operation, left, right) in program {
            let [a, b] = [left, right].map(|index| numbers[index % numbers.len()].clone());
            let next = match operation {
                0 | 1 => Some(a.plus(&b)),
                2 => Some(a.minus(&b)),
                3 | 4 => Some(a.times(&b)),
                5 => a.over(&b),
                6 => a.times(&a).root(&tower),
                _ => a.root(&tower),
            };
            let Some(next) = next.filter(|next| next.exact.bits() < 300) else {
                continue;
            };
            prop_assert_eq!(next.exact.sign(), next.ball.sign());
            if operation == 6 {
                prop_assert_eq!(&next.exact, &a.exact.absolute());
            } else if operation > 6 {
                prop_assert_eq!(&next.exact * &next.exact, a.exact.absolute());
            }
            let order = next.ball.minus(&b.ball).sign();
            prop_assert_eq!(next.exact.cmp(&b.exact), order);
            numbers.push(next);
        }
        Ok(())
    });
}

#[test]
fn spelled_numbers_read_back() {
    for_all(8_000, triple(), |(index, specs)| {
        let [a, b, c] = &exact(index, &specs);
        let basis = Basis::of([a.numerator(), b.numerator()]);
        let wider = basis.clone().union(&Basis::of([c.numerator()]));
        for (basis, own) in [(&basis, a), (&basis, b), (&wider, a), (&wider, c)] {
            let text = basis.spell(own);
            prop_assert_eq!(basis.read(&text), Some(own.clone()), "{}", text);
        }
        prop_assert_eq!(basis.is_rational(), a.is_rational() && b.is_rational());
        prop_assert_eq!(wider.degree(), 1 << wider.generators().len());
        for (position, (name, square)) in wider.definitions().iter().enumerate() {
            let root = wider.read(name).unwrap();
            prop_assert_eq!(wider.read(square), Some(&root * &root));
            prop_assert_eq!(root.sign(), Ordering::Greater);
            prop_assert_eq!(name, &format!("r{}", position + 1));
        }
        prop_assert_eq!(
            wider.read(&format!("r{}", wider.generators().len() + 1)),
            None
        );
        Ok(())
    });
}

#[test]
fn sums_of_roots_compare_as_real_numbers_do() {
    let radicand = || prop_oneof![1_i64..40, 999_990_i64..1_000_010, Just(i64::MAX)];
    let side = || prop::collection::vec(radicand(), 3);
    for_all(250, (side(), side()), |(left, right)| {
        let tower = sweepc::number::Tower::new(1 << 9);
        let zero = Number::ratio(0.into(), 1.into());
        let sum = |list: &[i64]| {
            list.iter().fold(zero.clone(), |sum, own| {
                let own = Number::ratio((*own).into(), 1.into());
                sum.plus(&own.root(&tower).unwrap())
            })
        };
        let (a, b) = (sum(&left), sum(&right));
        let order = a.ball.minus(&b.ball).sign();
        prop_assert_eq!(a.exact.cmp(&b.exact), order);
        // √(n − 1) + √(n + 1) < 2√n
        let middle = i128::from(left[0]);
        let near = [middle - 1, middle, middle + 1];
        let near = near.map(|own| Number::ratio(own.into(), 1.into()));
        let [below, middle, above] = near.map(|own| own.root(&tower).unwrap().exact);
        prop_assert!(&below + &above < &middle * &Surd::from(2));
        Ok(())
    });
}

#[test]
fn texts_that_spell_no_number_are_refused() {
    let text = prop_oneof![
        2 => "[-+*/ r0-3]{0,8}",
        1 => "(-?[0-9](/[0-9])?(\\*r[0-3]){0,2} [-+] ){0,3}r[0-3]",
        1 => "[-+*/ er.0-9√π]{0,8}",
    ];
    for_all(5_000, (0_usize..20, text), |(index, text)| {
        let field = field(index);
        let all = field.radicals.iter().map(|own| own.exact.numerator());
        let basis = Basis::of(all);
        if let Some(own) = basis.read(&text) {
            let spelled = basis.spell(&own);
            prop_assert_eq!(basis.read(&spelled), Some(own), "{}", text);
        } else {
            let whole = text.trim().parse::<Surd>();
            prop_assert!(whole.is_err() || text.contains(['e', '+', ' ']), "{}", text);
        }
        Ok(())
    });
}
