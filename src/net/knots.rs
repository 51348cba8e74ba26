use std::cell::OnceCell;

use crate::number::{Field, Real};

/// The clamped knots of a B-spline direction, with its degree.
///
/// The first knot and the last are repeated degree + 1 times, an inner knot at most degree times;
/// the knots ascend and the first is less than the last. One span is a Bézier direction.
#[derive(Clone, Debug)]
pub struct Knots {
    degree: usize,
    /// The different knots, and how often each is repeated.
    runs: Vec<(Real, usize)>,
    control_points: usize,
    /// With their repetitions, for those who ask.
    values: OnceCell<Vec<Real>>,
}

impl PartialEq for Knots {
    fn eq(&self, other: &Self) -> bool {
        (self.degree, &self.runs) == (other.degree, &other.runs)
    }
}

impl Eq for Knots {}

impl Knots {
    /// The knots of one span; none if `from` is not less than `to`.
    #[must_use]
    pub fn bezier(degree: usize, from: &Real, to: &Real) -> Option<Self> {
        (from < to).then(|| {
            let ends = [from, to].map(|own| (own.clone(), degree + 1));
            Self::of_runs(degree, ends.into())
        })
    }

    /// Knots with their repetitions; none if they are not clamped or do not ascend.
    #[must_use]
    pub fn new(degree: usize, values: &[Real]) -> Option<Self> {
        if !values.is_sorted() {
            return None;
        }
        let runs = values.chunk_by(|left, right| left == right);
        let runs = runs.filter_map(|run| Some((run.first()?.clone(), run.len())));
        let runs: Vec<_> = runs.collect();
        let last = runs.len().checked_sub(1)?;
        let sound = |(index, (_, count)): (usize, &(Real, usize))| match index {
            0 => *count == degree + 1,
            _ if index == last => *count == degree + 1,
            _ => *count <= degree,
        };
        let clamped = last > 0 && runs.iter().enumerate().all(sound);
        clamped.then(|| Self::of_runs(degree, runs))
    }

    fn of_runs(degree: usize, runs: Vec<(Real, usize)>) -> Self {
        let all: usize = runs.iter().map(|(_, count)| count).sum();
        Self {
            degree,
            control_points: all - degree - 1,
            runs,
            values: OnceCell::new(),
        }
    }

    /// The degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Whether there is one span.
    #[must_use]
    pub fn is_bezier(&self) -> bool {
        self.runs.len() == 2
    }

    /// All knots, ascending, with their repetitions.
    #[must_use]
    pub fn values(&self) -> &[Real] {
        self.values.get_or_init(|| {
            let runs = self.runs.iter();
            runs.flat_map(|(own, count)| std::iter::repeat_n(own.clone(), *count))
                .collect()
        })
    }

    /// The first knot and the last.
    #[must_use]
    pub fn domain(&self) -> (&Real, &Real) {
        (&self.runs[0].0, &self.runs[self.runs.len() - 1].0)
    }

    /// The same knots counted from 0 to 1: an affine change of the parameter.
    #[must_use]
    pub fn normalised(&self) -> Self {
        let (from, to) = self.domain();
        let scale = to.minus(from).inverse().unwrap_or_else(Real::one);
        let runs = self.runs.iter();
        let runs = runs.map(|(own, count)| (own.minus(from).times(&scale), *count));
        Self::of_runs(self.degree, runs.collect())
    }

    /// The different knots and how often each is repeated.
    #[must_use]
    pub fn multiplicities(&self) -> &[(Real, usize)] {
        &self.runs
    }

    /// The number of control points that go with these knots.
    #[must_use]
    pub fn control_points(&self) -> usize {
        self.control_points
    }

    /// The value at a parameter of the B-spline with these homogeneous control points, by repeated
    /// affine combination: de Boor's scheme, which on one span is de Casteljau's.
    ///
    /// None outside the domain, or if the number of points is not [`Knots::control_points`].
    #[must_use]
    pub fn blend(&self, points: &[[Real; 4]], at: &Real) -> Option<[Real; 4]> {
        let (degree, knots) = (self.degree, self.values());
        if points.len() != self.control_points() || at < knots.first()? || at > knots.last()? {
            return None;
        }
        let span = knots.partition_point(|knot| knot <= at);
        let first = span.min(self.control_points()) - 1 - degree;
        self.polar_form(points, first, &vec![at; degree])
    }

    /// The polar form of the B-spline on the span whose first control point is given, at as many
    /// arguments as the degree: the value where all of them are equal.
    pub(super) fn polar_form(
        &self,
        points: &[[Real; 4]],
        first: usize,
        arguments: &[&Real],
    ) -> Option<[Real; 4]> {
        let (degree, knots) = (self.degree, self.values());
        let mut corner = points.get(first..=first + degree)?.to_vec();
        for (step, at) in (1..=degree).zip(arguments) {
            for index in (step..=degree).rev() {
                let low = &knots[first + index];
                let high = &knots[first + index + 1 + degree - step];
                let ratio = at.minus(low).times(&high.minus(low).inverse()?);
                let rest = Real::one().minus(&ratio);
                corner[index] = std::array::from_fn(|axis| {
                    let near = corner[index - 1][axis].times(&rest);
                    near.plus(&corner[index][axis].times(&ratio))
                });
            }
        }
        corner.pop()
    }
}
