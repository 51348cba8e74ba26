use crate::number::{Field, Real};

/// The clamped knots of a B-spline direction, with its degree.
///
/// The first knot and the last are repeated degree + 1 times, an inner knot at most degree times;
/// the knots ascend and the first is less than the last. One span is a Bézier direction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Knots {
    degree: usize,
    values: Vec<Real>,
}

impl Knots {
    /// The knots of one span; none if `from` is not less than `to`.
    #[must_use]
    pub fn bezier(degree: usize, from: &Real, to: &Real) -> Option<Self> {
        let mut values = Vec::with_capacity(2 * degree + 2);
        values.resize(degree + 1, from.clone());
        values.resize(2 * degree + 2, to.clone());
        (from < to).then_some(Self { degree, values })
    }

    /// Knots with their repetitions; none if they are not clamped or do not ascend.
    #[must_use]
    pub fn new(degree: usize, values: Vec<Real>) -> Option<Self> {
        let knots = Self { degree, values };
        if !knots.values.is_sorted() {
            return None;
        }
        let runs = knots.multiplicities();
        let last = runs.len().checked_sub(1)?;
        let sound = |(index, (_, count)): (usize, &(&Real, usize))| match index {
            0 => *count == degree + 1,
            _ if index == last => *count == degree + 1,
            _ => *count <= degree,
        };
        let clamped = last > 0 && runs.iter().enumerate().all(sound);
        clamped.then_some(knots)
    }

    /// The degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Whether there is one span.
    #[must_use]
    pub fn is_bezier(&self) -> bool {
        self.values.len() == 2 * self.degree + 2
    }

    /// All knots, ascending, with their repetitions.
    #[must_use]
    pub fn values(&self) -> &[Real] {
        &self.values
    }

    /// The first knot and the last.
    #[must_use]
    pub fn domain(&self) -> (&Real, &Real) {
        (&self.values[0], &self.values[self.values.len() - 1])
    }

    /// The same knots counted from 0 to 1: an affine change of the parameter.
    #[must_use]
    pub fn normalised(&self) -> Self {
        let (from, to) = self.domain();
        let scale = to.minus(from).inverse().unwrap_or_else(Real::one);
        let values = self.values.iter().map(|own| own.minus(from).times(&scale));
        Self {
            degree: self.degree,
            values: values.collect(),
        }
    }

    /// The different knots and how often each is repeated.
    #[must_use]
    pub fn multiplicities(&self) -> Vec<(&Real, usize)> {
        if self.is_bezier() {
            let (first, last) = self.domain();
            return vec![(first, self.degree + 1), (last, self.degree + 1)];
        }
        let runs = self.values.chunk_by(|left, right| left == right);
        runs.filter_map(|run| Some((run.first()?, run.len())))
            .collect()
    }

    /// The number of control points that go with these knots.
    #[must_use]
    pub fn control_points(&self) -> usize {
        self.values.len() - self.degree - 1
    }

    /// The value at a parameter of the B-spline with these homogeneous control points, by repeated
    /// affine combination: de Boor's scheme, which on one span is de Casteljau's.
    ///
    /// None outside the domain, or if the number of points is not [`Knots::control_points`].
    #[must_use]
    pub fn blend(&self, points: &[[Real; 4]], at: &Real) -> Option<[Real; 4]> {
        let (degree, knots) = (self.degree, &self.values);
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
        let (degree, knots) = (self.degree, &self.values);
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
