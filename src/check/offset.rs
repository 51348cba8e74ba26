use crate::number::{Field, Real};
use crate::poly::{BiPoly, BiSquareTest, square_test_bi};

use super::Verdict;

/// Whether ‖R_u × R_v‖ is a rational function, so that the unit normal and every offset are.
///
/// `direction` is the polynomial vector M with R_u × R_v = M / W³; the statement is that M·M is
/// a positive number times a square.
pub(super) fn rational_offset(direction: &[BiPoly<Real>; 3]) -> Verdict {
    let squared = direction
        .iter()
        .fold(BiPoly::zero(), |sum, own| &sum + &(own * own));
    match square_test_bi(&squared) {
        BiSquareTest::Square { factor, .. } if factor.sign().is_gt() => {
            Verdict::Proven("‖R_u × R_v‖² is a square".to_owned())
        }
        BiSquareTest::Square { .. } => Verdict::Refuted("R_u × R_v is zero".to_owned()),
        BiSquareTest::NotSquare { reason } => {
            Verdict::Refuted(format!("‖R_u × R_v‖² is not a square: {reason}"))
        }
    }
}
