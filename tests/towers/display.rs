//! Numbers as they are printed, read by a reader of its own.

use std::iter::Peekable;
use std::str::Chars;

use num_bigint::BigInt;
use proptest::prelude::*;

use crate::ball::Ball;
use crate::cases::for_all;
use crate::fields::{field, triple};

/// Sums of products of rational numbers and of roots of integers or of sums in parentheses.
struct Reader<'a>(Peekable<Chars<'a>>);

impl Reader<'_> {
    fn take(&mut self, own: char) -> bool {
        self.0.next_if_eq(&own).is_some()
    }

    fn sum(&mut self) -> Ball {
        let negative = self.take('-');
        let mut sum = self.product(negative);
        while self.take(' ') {
            let negative = self.take('-');
            assert!(negative || self.take('+'));
            assert!(self.take(' '));
            sum = sum.plus(&self.product(negative));
        }
        sum
    }

    fn product(&mut self, negative: bool) -> Ball {
        let mut product = self.factor();
        while self.take('*') {
            product = product.times(&self.factor());
        }
        if negative { product.negated() } else { product }
    }

    fn factor(&mut self) -> Ball {
        if !self.take('√') {
            let numerator = self.integer();
            let denominator = if self.take('/') {
                self.integer()
            } else {
                1.into()
            };
            return Ball::ratio(&numerator, &denominator);
        }
        if !self.take('(') {
            return Ball::ratio(&self.integer(), &1.into()).root();
        }
        let radicand = self.sum();
        assert!(self.take(')'));
        radicand.root()
    }

    fn integer(&mut self) -> BigInt {
        let mut digits = String::new();
        while let Some(digit) = self.0.next_if(char::is_ascii_digit) {
            digits.push(digit);
        }
        digits.parse().unwrap()
    }
}

#[test]
fn printed_numbers_mean_what_they_say() {
    for_all(5_000, triple(), |(index, specs)| {
        for spec in &specs {
            let number = field(index).number(spec);
            let text = number.exact.to_string();
            let mut reader = Reader(text.chars().peekable());
            let read = reader.sum();
            prop_assert_eq!(reader.0.next(), None, "{}", text);
            prop_assert!(read.minus(&number.ball).sign().is_eq(), "{}", text);
        }
        Ok(())
    });
}
