use crate::poly::BiSquareTest;

use super::Verdict;
use super::direction::NormalDirection;

/// Whether ‖R_u × R_v‖ is a rational function up to a constant factor, so that the unit normal
/// and every offset are rational.
pub(super) fn rational_offset(direction: &NormalDirection) -> Verdict {
    match &direction.square {
        BiSquareTest::Square { .. } => Verdict::Proven("‖R_u × R_v‖² is a square".to_owned()),
        BiSquareTest::NotSquare { reason } => {
            Verdict::Refuted(format!("‖R_u × R_v‖² is not a square: {reason}"))
        }
    }
}
