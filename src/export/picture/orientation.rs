use std::collections::BTreeMap;

use crate::net::{Model, Shell, Side};

/// For each part of a model whether its normal R_u × R_v is to be turned, so that faces that share
/// an edge show the same side on both sides of it. Where that cannot be (a Möbius strip, three
/// faces at an edge) the first way found counts.
pub(super) fn turned(model: &Model) -> Vec<bool> {
    let mut turned: Vec<Option<bool>> = vec![None; model.parts().len()];
    for shell in model.shells() {
        let faces = across(shell);
        // The faces from the first on, each turned by what the face before it is.
        for start in 0..shell.faces.len() {
            let mut front = vec![start];
            while let Some(face) = front.pop() {
                let part = shell.faces[face].part;
                let own = *turned[part].get_or_insert(false);
                for (other, against) in faces.get(&face).into_iter().flatten() {
                    let next = shell.faces[*other].part;
                    if turned[next].is_none() {
                        turned[next] = Some(own != *against);
                        front.push(*other);
                    }
                }
            }
        }
    }
    let settled = turned.into_iter().map(Option::unwrap_or_default);
    settled.collect()
}

/// For each face those across its edges, and whether their normals point to the other side.
///
/// Round two faces that show the same side an edge between them runs in both directions.
fn across(shell: &Shell) -> BTreeMap<usize, Vec<(usize, bool)>> {
    let mut uses: BTreeMap<usize, Vec<(usize, bool)>> = BTreeMap::new();
    for (face, own) in shell.faces.iter().enumerate() {
        for (index, side) in own.sides.iter().enumerate() {
            let Side::Edges(along) = side else { continue };
            for one in along {
                // North and west run against the boundary.
                let direction = (index >= 2) != one.reversed;
                uses.entry(one.edge).or_default().push((face, direction));
            }
        }
    }
    let mut across: BTreeMap<usize, Vec<(usize, bool)>> = BTreeMap::new();
    for faces in uses.values() {
        for (face, direction) in faces {
            let others = faces.iter().filter(|(other, _)| other != face);
            let others = others.map(|(other, own)| (*other, own == direction));
            across.entry(*face).or_default().extend(others);
        }
    }
    across
}
