use crate::number::{Field, Rational};
use crate::syntax::canonical_name;

use crate::cli::numeral::numeral;
use crate::cli::refusal::Refusal;
use crate::cli::session::Misuse;
use crate::diag::Limits;

/// The values START, START + STEP, … of a parameter, as far as END.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Axis {
    pub(super) name: String,
    start: Rational,
    step: Rational,
    /// How many values there are; never 0.
    pub(super) count: usize,
}

impl Axis {
    /// Reads `NAME=START:END:STEP`.
    ///
    /// # Errors
    ///
    /// Another form, a number beyond the limits of literals, and a step that does not lead from
    /// the start to the end.
    pub(super) fn read(text: &str, limits: &Limits) -> Result<Self, Refusal> {
        let parts = text.split_once('=').map(|(name, range)| {
            let numbers: Vec<&str> = range.split(':').collect();
            (name.trim(), numbers)
        });
        let Some((name, [start, end, step])) = parts.as_ref().and_then(|(name, numbers)| {
            Some((*name, <[&str; 3]>::try_from(numbers.as_slice()).ok()?))
        }) else {
            let form = "NAME=START:END:STEP, such as d=0:1:1/100";
            return Err(Misuse(format!("`--grid {text}` is not of the form {form}")).into());
        };
        let number = |own: &str| {
            let option = || format!("--grid {name}=…");
            numeral(own, limits).map_err(|fault| fault.of_option(own, &option()))
        };
        let [start, end, step] = [number(start)?, number(end)?, number(step)?];
        let way = end.minus(&start);
        let Some(steps) = step.inverse().map(|own| way.times(&own)) else {
            return Err(Misuse(format!("the step of `--grid {text}` is 0")).into());
        };
        if steps.sign().is_lt() {
            let message = format!("the step of `--grid {text}` leads away from the end");
            return Err(Misuse(message).into());
        }
        let steps = steps.numerator().div_floor(steps.denominator());
        Ok(Self {
            name: canonical_name(name),
            start,
            step,
            count: usize::try_from(&steps).map_or(usize::MAX, |own| own.saturating_add(1)),
        })
    }

    /// The value of that number, from 0.
    pub(super) fn value(&self, index: usize) -> Rational {
        let index = i64::try_from(index).unwrap_or(i64::MAX);
        self.start.plus(&self.step.times(&Rational::from(index)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(text: &str) -> Result<Vec<String>, String> {
        let axis = Axis::read(text, &Limits::default());
        let axis = axis.map_err(|own| match own {
            Refusal::Misuse(Misuse(own)) => own,
            Refusal::Findings(own, _) => format!("{own:?}"),
        })?;
        Ok((0..axis.count)
            .map(|own| axis.value(own).to_string())
            .collect())
    }

    #[test]
    fn the_end_counts_when_it_is_hit() {
        for (text, expected) in [
            ("d=0:1:1/4", &["0", "1/4", "1/2", "3/4", "1"][..]),
            ("d=0:1:0.3", &["0", "3/10", "3/5", "9/10"]),
            ("d = 1 : -1 : -1", &["1", "0", "-1"]),
            ("d=2:2:5", &["2"]),
            ("d=0:0.9999999:1/2", &["0", "1/2"]),
        ] {
            let expected = expected.iter().map(|own| (*own).to_owned()).collect();
            assert_eq!(values(text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn what_is_no_range() {
        for (text, part) in [
            ("d", "not of the form"),
            ("d=0:1", "not of the form"),
            ("d=0:1:1/2:3", "not of the form"),
            ("d=0:x:1", "`x` is not an exact number"),
            ("d=0:1:0", "is 0"),
            ("d=0:1:-1/2", "leads away"),
        ] {
            let message = values(text).err().unwrap_or_default();
            assert!(message.contains(part), "{text}: {message}");
        }
    }

    #[test]
    fn a_count_beyond_all_bounds() {
        let axis = Axis::read("d=0:1e30:1e-30", &Limits::default());
        assert_eq!(axis.map(|own| own.count).ok(), Some(usize::MAX));
    }
}
