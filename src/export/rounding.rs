use crate::diag::Code;
use crate::net::Knots;
use crate::number::{Field, Leading, Rational, Real, Ring};

use super::approx::magnitude;
use super::{Double, ExportFault, Precision};

/// The numerators of exact numbers.
type Numerator = <Real as Field>::Ring;

/// Rounds the numbers of a file one by one and remembers those that become zero or subnormal.
#[derive(Debug, Default)]
pub(super) struct Rounding {
    tiny: Vec<String>,
}

impl Rounding {
    /// The double nearest to a number, which a message would name so.
    ///
    /// - **errors** a number beyond the last double (E0306)
    pub(super) fn round(
        &mut self,
        exact: &Real,
        what: &dyn Fn() -> String,
    ) -> Result<Double, ExportFault> {
        let double = Double::nearest(exact).ok_or_else(|| too_large(exact, &what()))?;
        self.watch(double, exact.is_zero(), what);
        Ok(double)
    }

    /// The double nearest to n/d, by its leading digits where they decide. The exact quotient is only
    /// divided out for a message.
    ///
    /// - **errors** a number beyond the last double (E0306)
    pub(super) fn quotient(
        &mut self,
        leading: Option<Leading>,
        parts: &dyn Fn() -> (Numerator, Numerator),
        exact: &dyn Fn() -> Real,
        what: &dyn Fn() -> String,
    ) -> Result<Double, ExportFault> {
        // What these decide is 0 or normal.
        if let Some(double) = leading.and_then(Double::nearest_to_leading) {
            return Ok(double);
        }
        let (numerator, divisor) = parts();
        let double = Double::nearest_quotient(Precision::Double, &numerator, &divisor);
        let double = double.ok_or_else(|| too_large(&exact(), &what()))?;
        self.watch(double, numerator.is_zero(), what);
        Ok(double)
    }

    fn watch(&mut self, double: Double, is_zero: bool, what: &dyn Fn() -> String) {
        if double.is_tiny() && !is_zero {
            self.tiny.push(what());
        }
    }

    /// The doubles of all knots along `u` or `v`, with their repetitions.
    ///
    /// - **errors** a number beyond the last double (E0306)
    pub(super) fn knots(&mut self, knots: &Knots, along: &str) -> Result<Vec<Double>, ExportFault> {
        let what = || format!("a knot along {along}");
        let mut doubles = Vec::with_capacity(knots.control_points() + knots.degree() + 1);
        for (own, count) in knots.multiplicities() {
            let double = self.round(own, &what)?;
            doubles.resize(doubles.len() + count, double);
        }
        Ok(doubles)
    }

    /// Says which numbers became zero or subnormal (W1005).
    pub(super) fn warning(&self) -> Option<ExportFault> {
        tiny_numbers(&self.tiny)
    }
}

/// A bound for the greatest distance of numbers from their doubles.
pub(super) fn error<'a>(pairs: impl Iterator<Item = (&'a Real, &'a Double)>) -> Rational {
    let distances = pairs.map(|(exact, double)| distance(exact, double));
    distances.max().unwrap_or_else(Rational::zero)
}

/// A bound for the distance of a number from its double, the distance itself if the number is
/// rational.
pub(super) fn distance(exact: &Real, double: &Double) -> Rational {
    let double = double.rational();
    let ends = range(exact).map(|end| {
        let gap = end.minus(&double);
        if gap.sign().is_lt() {
            gap.negated()
        } else {
            gap
        }
    });
    let [lower, upper] = ends;
    lower.max(upper)
}

/// Binary digits behind the point in a bound for an irrational number: more than doubles of
/// coordinates have.
const BOUND_BITS: u32 = 96;

/// Rational bounds of a number; itself twice if it is rational.
pub(super) fn range(exact: &Real) -> [Rational; 2] {
    match exact.as_rational() {
        Some(rational) => [rational.clone(), rational],
        None => exact.enclose(BOUND_BITS).ends(),
    }
}

/// Whether moving the knots without merging any only changes the parametrisation: so it is if each
/// inner knot is repeated as often as the degree says, and the spans are Bézier patches.
pub(super) fn shape_stable(knots: &Knots) -> bool {
    let runs = knots.multiplicities();
    runs.iter().all(|(_, count)| *count >= knots.degree())
}

fn too_large(exact: &Real, what: &str) -> ExportFault {
    let message = format!(
        "{what} is about {}, beyond the last double",
        magnitude(exact)
    );
    ExportFault::new(
        Code::E0306,
        message,
        "use a larger unit of length, or a scale in which the numbers are smaller",
    )
}

fn tiny_numbers(items: &[String]) -> Option<ExportFault> {
    let first = items.first()?;
    let message = match items.len() {
        1 => format!("{first} becomes zero or subnormal as a double"),
        count => {
            format!("{count} numbers become zero or subnormal as doubles, the first is {first}")
        }
    };
    let help = "use a smaller unit of length, or read the exact numbers of the `json` file";
    Some(ExportFault::new(Code::W1005, message, help))
}
