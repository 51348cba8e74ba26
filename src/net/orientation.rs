use super::{Shell, Side};

impl Shell {
    /// The faces to be flipped so that two faces run through the edge between them in opposite
    /// directions; none if there is no such choice, or if three faces share an edge.
    ///
    /// - **holds** the first face of the shell is not flipped
    #[must_use]
    pub fn orientation(&self) -> Option<Vec<bool>> {
        let uses = self.edge_uses();
        if uses.iter().any(|own| own.len() > 2) {
            return None;
        }
        let mut flipped: Vec<Option<bool>> = vec![None; self.faces.len()];
        let mut open = Vec::new();
        for first in 0..self.faces.len() {
            if flipped[first].is_none() {
                flipped[first] = Some(false);
                open.push(first);
            }
            while let Some(face) = open.pop() {
                let own = flipped[face]?;
                for pair in uses
                    .iter()
                    .filter(|uses| uses.iter().any(|own| own.0 == face))
                {
                    let [one, other] = pair.as_slice() else {
                        continue;
                    };
                    let (near, far) = if one.0 == face {
                        (one, other)
                    } else {
                        (other, one)
                    };
                    let wanted = (near.1 == far.1) != own;
                    match flipped[far.0] {
                        Some(known) if known != wanted => return None,
                        Some(_) => {}
                        None => {
                            flipped[far.0] = Some(wanted);
                            open.push(far.0);
                        }
                    }
                }
            }
        }
        flipped.into_iter().collect()
    }

    /// Whether every edge bounds two faces, in opposite directions.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.edge_uses().iter().all(|own| own.len() == 2) && self.orientation().is_some()
    }

    /// The faces that each edge bounds, and whether they run along its curve in the counter-clockwise
    /// direction of their domains.
    fn edge_uses(&self) -> Vec<Vec<(usize, bool)>> {
        let mut uses = vec![Vec::new(); self.edges.len()];
        for (index, face) in self.faces.iter().enumerate() {
            for (place, side) in face.sides.iter().enumerate() {
                if let Side::Edges(edges) = side {
                    for own in edges {
                        uses[own.edge].push((index, own.reversed != (place < 2)));
                    }
                }
            }
        }
        uses
    }
}
