use crate::number::{Field, Real};

use super::sew::Sewing;
use super::{CurveNet, EdgeId, Side, Use, VertexId};

/// Splits edges on which another edge ends, where both run together from there on or up to there.
///
/// Only edges that one side uses are looked at. Each is divided at all ends of others that lie on
/// it; pieces that no other edge has are joined again.
pub(super) fn split_where_others_end(sewing: &mut Sewing) {
    let pieces = shared_pieces(sewing);
    let lists = pieces.into_iter().map(|(edge, ranges)| {
        let row = sewing.all.edges[edge].row.clone();
        let parts = ranges.into_iter().filter_map(|(from, to)| {
            let part = row.between(&from, &to)?;
            let (edge, reversed) = sewing.edge(part.reduced(), part);
            Some(Use {
                edge,
                reversed,
                range: (from, to),
            })
        });
        (edge, parts.collect::<Vec<_>>())
    });
    let lists: Vec<(EdgeId, Vec<Use>)> = lists.collect();
    for face in &mut sewing.all.faces {
        for side in &mut face.sides {
            let Side::Edges(uses) = side else {
                continue;
            };
            let replaced = uses.iter().flat_map(|own| {
                let list = lists.iter().find(|(edge, _)| *edge == own.edge);
                list.map_or_else(|| vec![own.clone()], |(_, parts)| within(own, parts))
            });
            *uses = replaced.collect();
        }
    }
}

/// The parts of an edge as parts of a side that uses it; their ranges are those of the edge's
/// curve, on [0, 1].
fn within(whole: &Use, parts: &[Use]) -> Vec<Use> {
    let (from, to) = &whole.range;
    let width = to.minus(from);
    let place = |own: &Real| {
        let own = if whole.reversed {
            Real::one().minus(own)
        } else {
            own.clone()
        };
        from.plus(&width.times(&own))
    };
    let mut uses: Vec<Use> = parts
        .iter()
        .map(|part| {
            let (start, end) = (place(&part.range.0), place(&part.range.1));
            Use {
                edge: part.edge,
                reversed: part.reversed != whole.reversed,
                range: if whole.reversed {
                    (end, start)
                } else {
                    (start, end)
                },
            }
        })
        .collect();
    if whole.reversed {
        uses.reverse();
    }
    uses
}

/// A part of an edge between places where others end.
struct Piece {
    edge: EdgeId,
    range: (Real, Real),
    curve: CurveNet,
}

/// The edges to be split, each with the ranges of its parts on [0, 1].
fn shared_pieces(sewing: &Sewing) -> Vec<(EdgeId, Vec<(Real, Real)>)> {
    let open = open_edges(sewing);
    let edges = &sewing.all.edges;
    let mut ends: Vec<VertexId> = open
        .iter()
        .flat_map(|own| [edges[*own].start, edges[*own].end])
        .collect();
    ends.sort_unstable();
    ends.dedup();
    let mut pieces = Vec::new();
    for edge in open {
        let own = &edges[edge];
        let others = ends
            .iter()
            .filter(|end| ![own.start, own.end].contains(end));
        let vertices = others.map(|end| &sewing.all.vertices[*end]);
        let mut places: Vec<_> = vertices
            .filter(|point| own.row.may_pass(point))
            .flat_map(|point| own.curve.parameters_of(point))
            .collect();
        places.push(Real::zero());
        places.push(Real::one());
        places.sort();
        let ranges = places.windows(2).filter(|own| own[0] < own[1]);
        let parts = ranges.filter_map(|range| {
            let curve = own.curve.between(&range[0], &range[1])?;
            let range = (range[0].clone(), range[1].clone());
            Some(Piece { edge, range, curve })
        });
        pieces.extend(parts);
    }
    let shared: Vec<bool> = pieces.iter().map(|own| has_twin(own, &pieces)).collect();
    joined(&pieces, &shared)
}

/// Whether another edge has the same piece.
fn has_twin(own: &Piece, pieces: &[Piece]) -> bool {
    let turned = own.curve.reversed();
    let mut others = pieces.iter().filter(|other| other.edge != own.edge);
    others.any(|other| other.curve == own.curve || other.curve == turned)
}

/// Neighbouring pieces without a twin joined, edge by edge; edges that stay whole left out.
fn joined(pieces: &[Piece], shared: &[bool]) -> Vec<(EdgeId, Vec<(Real, Real)>)> {
    let mut lists: Vec<(EdgeId, Vec<(Real, Real)>)> = Vec::new();
    let mut open_end = false;
    for (piece, shared) in pieces.iter().zip(shared) {
        match lists.last_mut().filter(|(edge, _)| *edge == piece.edge) {
            None => lists.push((piece.edge, vec![piece.range.clone()])),
            Some((_, ranges)) => match ranges.last_mut() {
                Some(last) if open_end && !shared => last.1 = piece.range.1.clone(),
                _ => ranges.push(piece.range.clone()),
            },
        }
        open_end = !shared;
    }
    lists.retain(|(_, ranges)| ranges.len() > 1);
    lists
}

/// The edges that one side uses.
fn open_edges(sewing: &Sewing) -> Vec<EdgeId> {
    let mut counts = vec![0; sewing.all.edges.len()];
    for own in sewing.all.faces.iter().flat_map(|face| face.uses()) {
        counts[own.edge] += 1;
    }
    let counts = counts.into_iter().enumerate();
    counts
        .filter(|(_, count)| *count == 1)
        .map(|(edge, _)| edge)
        .collect()
}
