use crate::net::ControlNet;
use crate::number::{Integer, Real};

/// How far a patch with positive weights is from flat.
///
/// A level bounds the second derivatives of the homogeneous coordinates, divided by W, in units of
/// 2⁻ᵖ. Over a triangle in the unit square whose box measures a along the first parameter and b
/// along the second, each point of the surface is within (uu a² + 2 uv a b + vv b²)/8 of the
/// triangle between the corners' points, and each point of that triangle within as much of the
/// surface.
///
/// Proof. Let R = P/W, λₖ the barycentric coordinates of a place x among the corners xₖ, and
/// L g = Σ λₖ g(xₖ). The point q = L P / L W of the triangle has the barycentric coordinates
/// λₖ W(xₖ) / L W, and as x runs through its triangle, q does through that in space. For any c
///
/// R − q = ((H − L H) − (R − c) (W − L W)) / L W with H = P − c W.
///
/// Taylor's formula at x, with its remainder as an integral, and Σ λₖ (xₖ − x) = 0 give
/// |g − L g| ≤ ½ Σ λₖ (M₁₁ dₖ² + 2 M₁₂ |dₖ eₖ| + M₂₂ eₖ²), where xₖ − x = (dₖ, eₖ) and M bounds the
/// second derivatives of g. Numbers in an interval of length a have at most the variance a²/4, so
/// Σ λₖ dₖ² ≤ a²/4, and the mixed sum is at most a b/4 by Cauchy and Schwarz. Second differences
/// of Bernstein coefficients bound second derivatives; the hull of the control points holds R.
/// For polynomial surfaces this is the bound of Filip, Magedson and Markot (1986).
#[derive(Clone, Debug)]
pub(super) struct Flatness {
    levels: Vec<Level>,
}

/// Bounds that are taken over parts of the patch: triangles may be as large as a part.
#[derive(Clone, Debug)]
struct Level {
    parts: [usize; 2],
    uu: Integer,
    uv: Integer,
    vv: Integer,
}

/// Binary digits that the least weight has at least.
const WEIGHT_BITS: i64 = 96;

impl Flatness {
    /// The bounds over a net of one span with positive weights, in units of 2⁻ᵖ.
    pub(super) fn of(net: &ControlNet, precision: u32) -> Self {
        let degree = net.degree();
        let mut blocks = vec![vec![Block::of(net, precision)]];
        let halvings = [degree.u, degree.v].map(halvings);
        let mut levels = vec![Level::of(&blocks)];
        for level in 0..halvings[0].max(halvings[1]) {
            if level < halvings[0] {
                let halved = blocks.iter().flat_map(|row| {
                    let halves = row.iter().map(Block::halves_u);
                    let (first, second) = halves.map(|[first, second]| (first, second)).unzip();
                    let both: [Vec<_>; 2] = [first, second];
                    both
                });
                blocks = halved.collect();
            }
            if level < halvings[1] {
                let halved = blocks.iter();
                blocks = halved
                    .map(|row| row.iter().flat_map(Block::halves_v).collect())
                    .collect();
            }
            levels.push(Level::of(&blocks));
        }
        Self { levels }
    }

    /// A bound for the distance between surface and triangles in boxes of 1/m by 1/n.
    pub(super) fn deviation(&self, steps: [usize; 2]) -> Integer {
        let divisor = steps.map(Integer::from);
        let divisor = &divisor[0] * &divisor[0] * &divisor[1] * &divisor[1] * 8_u8;
        let levels = self.levels.iter().filter(|own| own.holds(steps));
        let bounds = levels.map(|own| ceiling(&own.scaled_deviation(steps), &divisor));
        bounds.min().unwrap_or_default()
    }

    /// Steps along both parameters, as few cells as there are, such that all triangles in boxes of
    /// one step each way are within a tolerance; none if a direction would need more than so many.
    pub(super) fn steps(
        &self,
        tolerance: &Integer,
        least: usize,
        greatest: usize,
    ) -> Option<[usize; 2]> {
        let levels = self.levels.iter();
        let found = levels.filter_map(|own| own.steps(tolerance, least, greatest));
        found.min_by_key(cells)
    }
}

/// Few cells come first, of these square numbers.
fn cells([m, n]: &[usize; 2]) -> (usize, usize) {
    (m.saturating_mul(*n), *m.max(n))
}

impl Level {
    /// The greatest bounds over any neighbouring parts: a triangle no larger than a part lies in
    /// two by two of them.
    fn of(blocks: &[Vec<Block>]) -> Self {
        let zero = || Integer::from(0);
        let mut greatest = [zero(), zero(), zero()];
        let parts = [blocks.len(), blocks[0].len()];
        for i in 0..parts[0].max(2) - 1 {
            for j in 0..parts[1].max(2) - 1 {
                let rows = blocks[i..].iter().take(2);
                let group = rows.flat_map(|row| row[j..].iter().take(2));
                let bounds = bounds(&group.collect::<Vec<_>>());
                for (own, bound) in greatest.iter_mut().zip(bounds) {
                    if *own < bound {
                        *own = bound;
                    }
                }
            }
        }
        let [u, v] = parts.map(Integer::from);
        let [uu, uv, vv] = greatest;
        Self {
            parts,
            uu: uu * &u * &u,
            uv: uv * &u * &v,
            vv: vv * &v * &v,
        }
    }

    fn holds(&self, [m, n]: [usize; 2]) -> bool {
        m >= self.parts[0] && n >= self.parts[1]
    }

    /// Eight times the bound for triangles in boxes of 1/m by 1/n, times m² n².
    fn scaled_deviation(&self, [m, n]: [usize; 2]) -> Integer {
        let [m, n] = [m, n].map(Integer::from);
        &self.uu * &n * &n + &self.uv * &m * &n * 2_u8 + &self.vv * &m * &m
    }

    fn is_within(&self, steps: [usize; 2], tolerance: &Integer) -> bool {
        let [m, n] = steps.map(Integer::from);
        self.scaled_deviation(steps) <= tolerance * 8_u8 * &m * &m * &n * &n
    }

    fn steps(&self, tolerance: &Integer, least: usize, greatest: usize) -> Option<[usize; 2]> {
        let least = self.parts.map(|own| own.max(least));
        let mut best: Option<[usize; 2]> = None;
        let mut m = least[0];
        while m <= greatest {
            if let Some(n) = self.least_steps(m, tolerance, least[1], greatest) {
                if best.is_none_or(|best| cells(&[m, n]) < cells(&best)) {
                    best = Some([m, n]);
                }
                if n == least[1] {
                    break;
                }
            }
            m += 1 + m / 16;
        }
        best
    }

    /// The least number of steps along the second parameter for so many along the first.
    fn least_steps(
        &self,
        m: usize,
        tolerance: &Integer,
        least: usize,
        greatest: usize,
    ) -> Option<usize> {
        if !self.is_within([m, greatest], tolerance) {
            return None;
        }
        let (mut low, mut high) = (least, greatest);
        while low < high {
            let middle = low + (high - low) / 2;
            if self.is_within([m, middle], tolerance) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        Some(low)
    }
}

/// How often a direction is halved at most.
fn halvings(degree: usize) -> u32 {
    match degree {
        0..=1 => 0,
        2..=4 => 4,
        5..=20 => 3,
        21..=60 => 2,
        _ => 1,
    }
}

/// A part of a patch: W, X, Y, Z in rows of Bernstein coefficients, each within `error` of a whole
/// number. Points are in units of 2⁻ᵖ, from a corner of the patch.
struct Block {
    rows: Vec<Vec<[Integer; 4]>>,
    error: Integer,
}

impl Block {
    fn of(net: &ControlNet, precision: u32) -> Self {
        let weight_bits = WEIGHT_BITS - net.min_weight().binade().unwrap_or_default();
        let weight_bits = u32::try_from(weight_bits).unwrap_or_default();
        let origin = net.point(0, 0).clone();
        let mut error = Integer::from(1);
        let mut whole = |exact: &Real, bits: u32| {
            let [lower, upper] = exact.enclose(bits).ends();
            let [lower, upper] =
                [lower, upper].map(|own| (own.numerator() << bits).div_floor(own.denominator()));
            let width = upper + 1 - &lower;
            if error < width {
                error = width;
            }
            lower
        };
        let mut row = |i: usize| -> Vec<[Integer; 4]> {
            let column = (0..net.columns()).map(|j| {
                let weight = net.weight(i, j);
                let [x, y, z] = [0, 1, 2].map(|axis| {
                    let apart = &net.point(i, j)[axis] - &origin[axis];
                    whole(&(&apart * weight), weight_bits + precision)
                });
                [whole(weight, weight_bits), x, y, z]
            });
            column.collect()
        };
        let rows = (0..net.rows()).map(&mut row).collect();
        Self { rows, error }
    }

    /// Both halves along the first parameter, scaled by 2 to its degree.
    fn halves_u(&self) -> [Self; 2] {
        let degree = self.rows.len() - 1;
        let mut halves = [Vec::new(), Vec::new()];
        let columns: Vec<_> = (0..self.rows[0].len())
            .map(|j| halves_of(self.rows.iter().map(|row| row[j].clone()).collect()))
            .collect();
        for i in 0..=degree {
            for (side, half) in halves.iter_mut().enumerate() {
                half.push(columns.iter().map(|own| own[side][i].clone()).collect());
            }
        }
        let error = &self.error << degree;
        halves.map(|rows| Self {
            rows,
            error: error.clone(),
        })
    }

    /// Both halves along the second parameter, scaled by 2 to its degree.
    fn halves_v(&self) -> [Self; 2] {
        let mut halves = [Vec::new(), Vec::new()];
        for row in &self.rows {
            for (half, own) in halves.iter_mut().zip(halves_of(row.clone())) {
                half.push(own);
            }
        }
        let error = &self.error << (self.rows[0].len() - 1);
        halves.map(|rows| Self {
            rows,
            error: error.clone(),
        })
    }

    /// H = P − c W in place of P.
    fn seen_from(&self, centre: &[Integer; 3]) -> Self {
        let shifted = |[weight, point @ ..]: &[Integer; 4]| {
            let [x, y, z] = [0, 1, 2].map(|axis| &point[axis] - &(&centre[axis] * weight));
            [weight.clone(), x, y, z]
        };
        let reach = centre.iter().map(Integer::abs).max().unwrap_or_default();
        let rows = self
            .rows
            .iter()
            .map(|row| row.iter().map(shifted).collect());
        Self {
            rows: rows.collect(),
            error: &self.error * (reach + 1),
        }
    }

    /// The greatest bound over second differences along u, mixed, and along v, by the block's own
    /// parameters.
    fn greatest(&self, bound: impl Fn([Integer; 4]) -> Integer) -> [Integer; 3] {
        let (m, n) = (self.rows.len(), self.rows[0].len());
        let at = |i: usize, j: usize| &self.rows[i][j];
        let second = |far: &[Integer; 4], near: &[Integer; 4], start: &[Integer; 4]| {
            std::array::from_fn(|axis| &far[axis] + &start[axis] - &near[axis] * 2_u8)
        };
        let places =
            |from: [usize; 2]| (from[0]..m).flat_map(move |i| (from[1]..n).map(move |j| (i, j)));
        let along_u = places([2, 0]).map(|(i, j)| second(at(i, j), at(i - 1, j), at(i - 2, j)));
        let along_v = places([0, 2]).map(|(i, j)| second(at(i, j), at(i, j - 1), at(i, j - 2)));
        let mixed = places([1, 1]).map(|(i, j)| {
            std::array::from_fn(|axis| {
                let own = |i: usize, j: usize| &at(i, j)[axis];
                own(i, j) + own(i - 1, j - 1) - own(i - 1, j) - own(i, j - 1)
            })
        });
        let times = |greatest: Option<Integer>, factor: usize| {
            greatest.unwrap_or_default() * Integer::from(factor)
        };
        [
            times(along_u.map(&bound).max(), (m - 1) * m.saturating_sub(2)),
            times(mixed.map(&bound).max(), (m - 1) * (n - 1)),
            times(along_v.map(&bound).max(), (n - 1) * n.saturating_sub(2)),
        ]
    }
}

/// Bounds for the second derivatives over some blocks together: along u, mixed, along v.
fn bounds(group: &[&Block]) -> [Integer; 3] {
    let [weight, corner @ ..] = &group[group.len() - 1].rows[0][0];
    let centre = corner.each_ref().map(|own| own.div_floor(weight));
    let seen: Vec<Block> = group.iter().map(|own| own.seen_from(&centre)).collect();
    let weight_error = &group[0].error;
    // Of H as a vector: √3 < 2.
    let error = &seen[0].error * 2_u8;
    let all = || seen.iter().flat_map(|own| own.rows.iter().flatten());
    let below = |own: &[Integer; 4]| &own[0] - weight_error;
    let least = all().map(below).min().unwrap_or_default();
    let radii = all().map(|own| ceiling(&(length(own) + &error), &below(own)));
    let radius = radii.max().unwrap_or_default();
    let bound = |difference: [Integer; 4]| {
        let along = length(&difference) + &error * 4_u8;
        along + &radius * (difference[0].abs() + weight_error * 4_u8)
    };
    let mut greatest = [0, 0, 0].map(Integer::from);
    for block in &seen {
        for (own, other) in greatest.iter_mut().zip(block.greatest(bound)) {
            if *own < other {
                *own = other;
            }
        }
    }
    greatest.map(|own| ceiling(&own, &least))
}

/// The Bernstein coefficients on both halves of an interval, times 2 to the degree, by sums in
/// place of de Casteljau's means.
fn halves_of(mut row: Vec<[Integer; 4]>) -> [Vec<[Integer; 4]>; 2] {
    let degree = row.len() - 1;
    let raised = |own: &[Integer; 4], bits: usize| own.each_ref().map(|own| own << bits);
    let (mut left, mut right) = (Vec::new(), Vec::new());
    for step in 0..=degree {
        left.push(raised(&row[0], degree - step));
        right.push(raised(&row[degree - step], degree - step));
        for index in 0..degree - step {
            row[index] = std::array::from_fn(|axis| &row[index][axis] + &row[index + 1][axis]);
        }
    }
    right.reverse();
    [left, right]
}

/// An integer that is not below ‖(x, y, z)‖, and hardly above: from 62 digits of the coordinates.
fn length([_, point @ ..]: &[Integer; 4]) -> Integer {
    const DIGITS: u64 = 62;
    let longest = point.iter().map(Integer::bits).max().unwrap_or_default();
    let dropped = longest.saturating_sub(DIGITS);
    let mut square = 0_u128;
    for own in point {
        let size = (own.abs() >> dropped).machine().unwrap_or_default();
        let size = size.unsigned_abs() + u128::from(dropped > 0);
        square += size * size;
    }
    let root = square.isqrt();
    let root = root + u128::from(root * root < square);
    Integer::from(root) << dropped
}

/// The least integer that is not below n/d; d > 0.
fn ceiling(numerator: &Integer, denominator: &Integer) -> Integer {
    -(-numerator).div_floor(denominator)
}
