use crate::curve::Interval;
use crate::diag::{Code, Diagnostic, Span};
use crate::number::{Field, Real, RootFault, Tower};
use crate::poly::{
    BiPoly, BiSquareTest, Denominator, Fraction, SquareTest, UniPoly, ZeroKind, ZeroSet, Zeros,
    sign_change, square_test, square_test_bi, zeros_by_subdivision,
};

use super::Domain;

/// The square root of a rational function that is a square, not negative on the domain.
///
/// The function is first brought to lowest terms; then numerator and denominator are squares up
/// to constants; the field grows by the square root of their quotient if it does not hold it.
///
/// # Errors
///
/// E0210 where the function is not a square or the root changes sign on the domain, E0509 where
/// the field would grow beyond the limit on its degree.
pub(super) fn square_root(
    radicand: &Fraction<Real>,
    domain: &Domain,
    tower: &Tower,
    span: Span,
) -> Result<Fraction<Real>, Box<Diagnostic>> {
    let reduced = radicand.reduce();
    if reduced.is_zero() {
        return Ok(reduced);
    }
    let not_square = |what: String| {
        Box::new(
            Diagnostic::new(
                Code::E0210,
                span,
                "the square root of this is not a rational function",
            )
            .note(what),
        )
    };
    let Some((scale, numerator)) = Denominator::split(reduced.numerator()) else {
        return Ok(reduced);
    };
    let (top_factor, top) = root_of(&numerator).map_err(not_square)?;
    let (bottom_factor, bottom) = root_of(reduced.denominator()).map_err(not_square)?;
    let constant = bottom_factor
        .inverse()
        .map(|inverse| scale.times(&top_factor).times(&inverse));
    let constant = constant.unwrap_or_else(Real::zero);
    let root = root_of_number(&constant, tower, span)?;
    let changes = [&top, &bottom]
        .into_iter()
        .find_map(|part| part.change_of_sign(domain));
    if let Some(place) = changes {
        let message = "this square root does not keep its sign on the domain";
        let finding = Diagnostic::new(Code::E0210, span, message);
        return Err(Box::new(finding.note(place)));
    }
    let fraction = Fraction::quotient(&top.polynomial().scale(&root), &bottom.polynomial());
    let fraction = fraction.unwrap_or(reduced);
    Ok(if is_negative(&fraction, domain) {
        fraction.negated()
    } else {
        fraction
    })
}

/// The square root of a number; the field grows by it if it does not hold it.
///
/// # Errors
///
/// E0210 for a negative number, E0509 where the field would grow too far.
pub(super) fn root_of_number(
    radicand: &Real,
    tower: &Tower,
    span: Span,
) -> Result<Real, Box<Diagnostic>> {
    let root = tower.square_root(radicand);
    root.map_err(|fault| Box::new(no_root(radicand, &fault, span)))
}

/// The finding for a number without a square root in the field.
fn no_root(radicand: &Real, fault: &RootFault, span: Span) -> Diagnostic {
    match fault {
        RootFault::Negative => {
            Diagnostic::new(Code::E0210, span, "the square root of a negative number")
                .note(format!("it is {} times a square", radicand.brief()))
        }
        RootFault::DegreeLimit { limit } => {
            let message = format!(
                "√({}) would make the degree of the number field greater than {limit}",
                radicand.brief()
            );
            Diagnostic::new(Code::E0509, span, message)
                .help("raise the limit with `--max-field-degree`")
        }
    }
}

/// Pieces into which the domain is cut at most to find a change of sign.
const PIECES: usize = 256;

/// The roots of the factors in u, in v and in both.
struct Root {
    in_u: UniPoly<Real>,
    in_v: UniPoly<Real>,
    mixed: BiPoly<Real>,
}

impl Root {
    fn polynomial(&self) -> BiPoly<Real> {
        &BiPoly::product(&self.in_u, &self.in_v) * &self.mixed
    }

    /// Where one of the factors changes sign on the domain, in words.
    fn change_of_sign(&self, domain: &Domain) -> Option<String> {
        let [u, v] = [&domain.u, &domain.v];
        if let Some(root) = sign_change(&self.in_u, u.start(), u.end()) {
            return Some(format!("the sign changes at {}", root.place("u")));
        }
        if let Some(root) = sign_change(&self.in_v, v.start(), v.end()) {
            return Some(format!("the sign changes at {}", root.place("v")));
        }
        if self.mixed.as_constant().is_some() || self.mixed_is_square() {
            return None;
        }
        let zeros = zeros_by_subdivision(
            &self.mixed,
            (u.start(), u.end()),
            (v.start(), v.end()),
            PIECES,
        );
        let corner = |set: &ZeroSet<Real>| {
            let at = |(lower, upper): &(Real, Real), range: &Interval| {
                lower == upper && (lower == range.start() || lower == range.end())
            };
            at(&set.u, u) && at(&set.v, v)
        };
        match zeros {
            Some(Zeros::None) => None,
            Some(Zeros::Some(sets)) if sets.iter().all(corner) => None,
            Some(Zeros::Some(sets)) => sets
                .iter()
                .find(|set| set.kind == ZeroKind::Box)
                .or(sets.first())
                .map(|set| format!("it vanishes on a curve through the domain, at {set}")),
            None => {
                Some("that it does is not excluded: this version does not decide it".to_owned())
            }
        }
    }

    /// A square has one sign.
    fn mixed_is_square(&self) -> bool {
        matches!(square_test_bi(&self.mixed), BiSquareTest::Square { .. })
    }
}

/// c and r with c r² the polynomial, or the factor that stands in the way.
fn root_of(polynomial: &Denominator<Real>) -> Result<(Real, Root), String> {
    let univariate = |own: &UniPoly<Real>, variable: &str| match square_test(own) {
        SquareTest::Square { factor, root } => Ok((factor, root)),
        SquareTest::NotSquare { odd_part } => Err(format!(
            "it has this factor an odd number of times: {}",
            odd_part.display(variable)
        )),
    };
    let (in_u, in_v) = (
        univariate(polynomial.in_u(), "u")?,
        univariate(polynomial.in_v(), "v")?,
    );
    let mixed = match polynomial.mixed().map(square_test_bi) {
        None => (Real::one(), BiPoly::one()),
        Some(BiSquareTest::Square { factor, root }) => (factor, root),
        Some(BiSquareTest::NotSquare { reason }) => return Err(reason),
    };
    let factor = in_u.0.times(&in_v.0).times(&mixed.0);
    Ok((
        factor,
        Root {
            in_u: in_u.1,
            in_v: in_v.1,
            mixed: mixed.1,
        },
    ))
}

/// The sign of a fraction that does not change sign on the domain, at the first inner point of
/// the diagonal where it is not 0.
fn is_negative(fraction: &Fraction<Real>, domain: &Domain) -> bool {
    (1..)
        .take(1_000)
        .filter_map(|step| {
            let (u, v) = (
                domain.u.fraction(step, 1_009),
                domain.v.fraction(step, 1_013),
            );
            fraction.evaluate(&u, &v)
        })
        .map(|value| value.sign())
        .find(|sign| sign.is_ne())
        .is_some_and(std::cmp::Ordering::is_lt)
}
