use crate::export::written::Written;
use crate::export::{Double, ExportFault, RoundedNet};
use crate::net::{Face, Model, Shell, Side};

use super::file::{Entity, File, Parameter, Pointer, Status};
use super::geometry::{self, Constants};
use super::{add_named, label};

use Parameter::Integer;

/// Writes each face as a trimmed surface: entity 144, its boundary 142 in space and in the
/// parameters. Neighbours have the same doubles along the edge that they share.
///
/// - **errors** a number beyond the last double, or numbers that merge (E0306)
pub(super) fn write(
    model: &Model,
    written: &mut Written,
    file: &mut File,
) -> Result<(), ExportFault> {
    let constants = Constants::new()?;
    for shell in model.shells() {
        let nets = written.round(shell.faces.iter().map(|own| &own.net))?;
        for (face, net) in shell.faces.iter().zip(&nets) {
            let part = &model.parts()[face.part];
            let surface = geometry::surface(net, label(part), Status::Part);
            let surface = file.add(&surface);
            let in_space = boundary(face, shell, &constants, file)?;
            let in_parameters = outline(face, net, &constants, file);
            let pointers = [surface, in_parameters, in_space].map(Parameter::Pointer);
            let [on, parameters, space] = pointers;
            // Made by no known way; the curve in space is the one that counts.
            let curve = file.add(&Entity {
                kind: 142,
                form: 0,
                status: Status::Part,
                label: String::new(),
                parameters: vec![Integer(0), on.clone(), parameters, space, Integer(2)],
            });
            // The outer boundary is given, and there are no holes.
            let trimmed = Entity {
                kind: 144,
                form: 0,
                status: Status::Independent,
                label: label(part),
                parameters: vec![on, Integer(1), Integer(0), Parameter::Pointer(curve)],
            };
            add_named(trimmed, part, file);
        }
    }
    Ok(())
}

/// The boundary of a face in space, counter-clockwise in the parameters; collapsed sides are left
/// out.
fn boundary(
    face: &Face,
    shell: &Shell,
    constants: &Constants,
    file: &mut File,
) -> Result<Pointer, ExportFault> {
    let mut curves = Vec::new();
    for (index, side) in face.sides.iter().enumerate() {
        let Side::Edges(uses) = side else {
            continue;
        };
        let along = index < 2;
        let ordered: Vec<_> = if along {
            uses.iter().collect()
        } else {
            uses.iter().rev().collect()
        };
        for own in ordered {
            let row = &shell.edges[own.edge].row;
            let curve = if own.reversed == along {
                geometry::curve(&row.reversed(), constants)?
            } else {
                geometry::curve(row, constants)?
            };
            curves.push(file.add(&curve));
        }
    }
    Ok(geometry::composite(&curves, Status::Part, file))
}

/// The boundary of the domain, counter-clockwise.
fn outline(face: &Face, net: &RoundedNet, constants: &Constants, file: &mut File) -> Pointer {
    let ends = |knots: &[Double]| (knots[0], knots[knots.len() - 1]);
    let ((from_u, to_u), (from_v, to_v)) = (ends(&net.knots_u), ends(&net.knots_v));
    let corners = [
        [from_u, from_v],
        [to_u, from_v],
        [to_u, to_v],
        [from_u, to_v],
    ];
    let sides = face.sides.iter().enumerate();
    let segments = sides.map(|(index, _)| [corners[index], corners[(index + 1) % 4]]);
    let segments: Vec<_> = segments
        .map(|ends| file.add(&geometry::segment(ends, constants)))
        .collect();
    geometry::composite(&segments, Status::Parametric, file)
}
