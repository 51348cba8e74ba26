//! Exact polynomials and rational functions over any [`Field`](crate::number::Field), without
//! fractions inside: integer numerators over one common denominator.

mod bernstein;
mod bi;
mod bidegree;
mod coprimality;
mod fraction;
mod gcd;
mod image;
mod integrate;
mod modular;
mod rational_roots;
mod restrict;
mod root;
mod square;
mod squarefree;
mod sturm;
mod uni;

pub use bernstein::{bernstein, de_casteljau, from_bernstein, subdivide};
pub use bi::BiPoly;
pub use bidegree::BiDegree;
pub use coprimality::Coprimality;
pub use fraction::{Denominator, Fraction};
pub use gcd::{certify_coprime, gcd, gcd_all, lcm};
pub use integrate::{Antiderivative, integrate};
pub use root::{RealRoot, real_roots, sign_change};
pub use square::{SquareTest, square_test};
pub use squarefree::{odd_part, square_free};
pub use sturm::count_roots;
pub use uni::UniPoly;
