//! Exact polynomials and rational functions over any [`Field`](crate::number::Field), without
//! fractions inside: integer numerators over one common denominator.

mod algebraic;
mod bernstein;
mod bernstein_grid;
mod bi;
mod bidegree;
mod bigcd;
mod bisquare;
mod common_zero;
mod conjugate_gcd;
mod content;
mod coprimality;
mod division;
mod fraction;
mod gcd;
mod image;
mod integrate;
mod interpolation;
mod modular;
mod numerators;
mod product;
mod quotient;
mod rational_roots;
mod restrict;
mod resultant;
mod root;
mod square;
mod squarefree;
mod sturm;
mod subresultant;
mod sum;
mod tensor;
mod touching;
mod uni;
mod zero_set;

pub use bernstein::{
    bernstein, binomial, binomials, de_casteljau, from_bernstein, scaled_bernstein, subdivide,
};
pub use bernstein_grid::BernsteinGrid;
pub use bi::BiPoly;
pub use bidegree::BiDegree;
pub use bigcd::{exact_div_bi, gcd_bi};
pub use bisquare::{BiSquareTest, square_test_bi, sum_of_squares_refuted};
pub use common_zero::{common_zeros_of_products, never_vanish_together};
pub use content::{common_factor_u, common_factor_v};
pub use coprimality::Coprimality;
pub use fraction::{Denominator, Fraction};
pub use gcd::{certify_coprime, gcd, gcd_all, lcm};
pub use integrate::{Antiderivative, integrate};
pub use numerators::Numerators;
pub use quotient::Quotient;
pub use resultant::{resultant, resultant_v};
pub use root::{RealRoot, real_roots, sign_change};
pub use square::{SquareTest, square_test};
pub use squarefree::{odd_part, square_free};
pub use sturm::count_roots;
pub use uni::UniPoly;
pub use zero_set::{ZeroKind, ZeroSet, Zeros, zeros_by_subdivision, zeros_in_box};
