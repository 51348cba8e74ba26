use std::cell::OnceCell;

use super::{Part, Shell, sew};

/// Surfaces that go into one file.
#[derive(Clone, Debug)]
pub struct Model {
    parts: Vec<Part>,
    shells: OnceCell<Vec<Shell>>,
}

impl Model {
    /// The model of some surfaces.
    #[must_use]
    pub fn new(parts: Vec<Part>) -> Self {
        Self {
            parts,
            shells: OnceCell::new(),
        }
    }

    /// The surfaces.
    #[must_use]
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The faces of all parts that have [patches](Part::patches), those that share edges together.
    ///
    /// - **holds** faces come in order of part, u, v; shells in order of their first face
    #[must_use]
    pub fn shells(&self) -> &[Shell] {
        self.shells.get_or_init(|| sew(&self.parts))
    }

    /// Whether faces of different parts share an edge.
    #[must_use]
    pub fn is_connected_across_parts(&self) -> bool {
        let mixed = |shell: &Shell| {
            let parts = || shell.faces.iter().map(|face| face.part);
            parts().min() != parts().max()
        };
        self.shells().iter().any(mixed)
    }
}
