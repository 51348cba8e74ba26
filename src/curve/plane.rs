use std::fmt;

/// A surface parameter: profiles run in u, sweep curves in v.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Parameter {
    /// u
    U,
    /// v
    V,
}

impl fmt::Display for Parameter {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::U => "u",
            Self::V => "v",
        })
    }
}

/// A coordinate axis of space.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Axis {
    /// x, along i
    X,
    /// y, along j
    Y,
    /// z, along k
    Z,
}

impl Axis {
    /// The three axes, in order.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// 0, 1, 2
    #[must_use]
    pub fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
            Self::Z => 2,
        }
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(["x", "y", "z"][self.index()])
    }
}

/// The coordinate plane of a plane curve, with its ordered axes (e₁, e₂).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Plane {
    /// e₁ = i, e₂ = j
    Xy,
    /// e₁ = i, e₂ = k
    Xz,
    /// e₁ = j, e₂ = k
    Yz,
}

impl Plane {
    /// (e₁, e₂)
    #[must_use]
    pub fn axes(self) -> (Axis, Axis) {
        match self {
            Self::Xy => (Axis::X, Axis::Y),
            Self::Xz => (Axis::X, Axis::Z),
            Self::Yz => (Axis::Y, Axis::Z),
        }
    }

    /// Coordinates in space from those along e₁ and e₂, and the one across.
    #[must_use]
    pub fn in_space<T>(self, [first, second]: [T; 2], across: T) -> [T; 3] {
        match self {
            Self::Xy => [first, second, across],
            Self::Xz => [first, across, second],
            Self::Yz => [across, first, second],
        }
    }
}
