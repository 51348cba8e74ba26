use std::collections::HashMap;
use std::rc::Rc;

use crate::diag::Code;
use crate::export::outward::turned;
use crate::export::{Context, Double, ExportFault, Precision};
use crate::net::{Face, Model, Shell};
use crate::number::{Integer, Real};
use crate::sweep::NormalVector;

use super::flatness::Flatness;
use super::lattice::{Lattice, inside};
use super::normal_field::{NormalField, PlaceNormal};
use super::outline::Outline;
use super::resolution::Resolution;
use super::strip::strip;
use super::weld::weld;
use super::{Subdivision, facet_normal};

/// The surfaces of a model as triangles with normals.
///
/// - **holds** a vertex is an exact point of the surface, each coordinate rounded once; faces that
///   share an edge share its vertices; no triangle has a vertex twice
#[derive(Clone, Debug)]
pub struct Mesh {
    /// The format of all numbers.
    pub precision: Precision,
    /// For each shell in turn: the vertices of the shell, the inner points of its edges from their
    /// start, the inner points of its faces u by u and v by v within.
    pub vertices: Vec<[Double; 3]>,
    /// The unit normals that occur, each component rounded once; 0 for a triangle on a line whose
    /// surface has no normal.
    pub normals: Vec<[Double; 3]>,
    /// The triangles, face by face.
    pub triangles: Vec<Triangle>,
    /// No point of the surface is farther from the triangles than this, and no point of the
    /// triangles farther from the surface.
    pub chord_error: Real,
    /// The steps of each shell.
    pub subdivisions: Vec<Rc<Subdivision>>,
}

/// A triangle, counter-clockwise as seen from the side to which its normals point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Triangle {
    /// The part of the model that it is on.
    pub part: usize,
    /// Its corners.
    pub corners: [Corner; 3],
}

/// A corner of a triangle, by the places of its vertex and its normal in their lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Corner {
    /// The vertex.
    pub vertex: usize,
    /// The normal of the surface there, as the triangle's face has it.
    pub normal: usize,
}

/// A vertex, with its normal if it has one.
type Bare = (usize, Option<BareNormal>);

/// A normal before its triangle is known.
#[derive(Clone, Copy)]
enum BareNormal {
    /// Its place in the list, and whether it is against the direction that the field has there.
    Known { place: usize, turned: bool },
    /// Along the direction of the field or against it: as in the rest of the triangle.
    Open([Double; 3]),
}

impl Mesh {
    /// The mesh of a model whose parts have patches, within the tolerance of a context.
    ///
    /// - **errors** a surface that is a curve or a point (E0302); a coordinate beyond the last
    ///   number of the format (E0306); a tolerance that the format does not resolve (E0308); more
    ///   triangles than the context allows (E0511)
    pub fn of(
        model: &Model,
        context: &Context<'_>,
        precision: Precision,
    ) -> Result<Self, ExportFault> {
        let faces = model.shells().iter().flat_map(|own| &own.faces);
        faces.map(normal).try_for_each(|own| own.map(drop))?;
        let resolution = Resolution::of(model, context.chord.as_ref(), precision)?;
        let mut mesh = Self {
            precision,
            vertices: Vec::new(),
            normals: Vec::new(),
            triangles: Vec::new(),
            chord_error: Real::from(0),
            subdivisions: Vec::new(),
        };
        let (plans, bound) = plans(model, &resolution, context.limits.triangles)?;
        mesh.chord_error = resolution.with_rounding(bound);
        let mut known = HashMap::new();
        for (shell, steps) in model.shells().iter().zip(plans) {
            let lattice = Lattice::of(shell, &steps, precision, &mut mesh.vertices);
            let lattice = lattice.ok_or_else(|| beyond(precision))?;
            let flipped = turned(shell).unwrap_or_default();
            for (index, face) in shell.faces.iter().enumerate() {
                let opposite = flipped.get(index).copied().unwrap_or_default();
                let mut work = FaceWork {
                    mesh: &mut mesh,
                    known: &mut known,
                    field: Some(NormalField::of(face, normal(face)?, opposite)),
                    part: face.part,
                    opposite,
                };
                work.face(shell, index, &steps, &lattice);
            }
            mesh.subdivisions.push(steps);
        }
        weld(&mut mesh)?;
        Ok(mesh)
    }

    /// The points of a triangle.
    #[must_use]
    pub fn points(&self, triangle: &Triangle) -> [[Double; 3]; 3] {
        triangle.corners.map(|own| self.vertices[own.vertex])
    }
}

/// The steps of all shells, and the bound between surface and triangles with exact points.
fn plans(
    model: &Model,
    resolution: &Resolution,
    limit: usize,
) -> Result<(Vec<Rc<Subdivision>>, Integer), ExportFault> {
    let tolerance = resolution.for_chords();
    let (mut plans, mut count, mut bound) = (Vec::new(), 0_usize, Integer::from(0));
    for shell in model.shells() {
        let flatness = shell.faces.iter();
        let flatness: Vec<_> = flatness
            .map(|own| Flatness::of(&own.net, resolution.bits))
            .collect();
        let greatest = limit.max(4);
        let steps = Subdivision::of(shell, &flatness, &tolerance, greatest);
        let steps = steps.ok_or_else(|| too_many(limit))?;
        count = count.saturating_add(steps.triangles(shell));
        for (flatness, steps) in flatness.iter().zip(&steps.faces) {
            let own = flatness.deviation(*steps);
            if bound < own {
                bound = own;
            }
        }
        plans.push(Rc::new(steps));
    }
    if count > limit {
        return Err(too_many(limit));
    }
    Ok((plans, bound))
}

fn too_many(limit: usize) -> ExportFault {
    let message = format!("the mesh would have more than {limit} triangles");
    let help = "give a greater `--chord`, or raise the limit with `--max-triangles`";
    ExportFault::new(Code::E0511, message, help)
}

fn beyond(precision: Precision) -> ExportFault {
    let message = "a coordinate is beyond the last number of the format";
    let help = match precision {
        Precision::Single => {
            "use a larger unit of length, or write `ply` or `mesh`, whose numbers are doubles"
        }
        Precision::Double => {
            "use a larger unit of length, or read the exact numbers of the `json` file"
        }
    };
    ExportFault::new(Code::E0306, message, help)
}

/// The normal of a face's surface.
///
/// - **errors** a surface that is a curve or a point (E0302)
fn normal(face: &Face) -> Result<&NormalVector, ExportFault> {
    face.surface.normal_vector().ok_or_else(|| {
        let message = "R_u × R_v is zero: this is a curve or a point";
        let help = "a surface must move in both directions; the `json` file carries this net";
        ExportFault::new(Code::E0302, message, help)
    })
}

/// The triangles of one face.
struct FaceWork<'a> {
    mesh: &'a mut Mesh,
    known: &'a mut HashMap<[Double; 3], usize>,
    field: Option<NormalField>,
    part: usize,
    opposite: bool,
}

impl FaceWork<'_> {
    fn face(&mut self, shell: &Shell, face: usize, steps: &Subdivision, lattice: &Lattice) {
        let [m, n] = steps.faces[face];
        let normals = self.inner_normals([m, n]);
        let at = |[i, j]: [usize; 2]| {
            let normal = normals[(i - 1) * (n - 1) + j - 1];
            (lattice.in_face(face, [i, j]), normal)
        };
        for i in 1..m - 1 {
            for j in 1..n - 1 {
                let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(at);
                self.triangle([corners[0], corners[1], corners[2]]);
                self.triangle([corners[0], corners[2], corners[3]]);
            }
        }
        for outline in Outline::sides(shell, face, steps, lattice) {
            let beside = outline
                .inner
                .iter()
                .map(|(place, own)| (place.clone(), at(*own)));
            self.side(&outline, &beside.collect::<Vec<_>>());
        }
    }

    /// The normals at the inner points, u by u and v by v within.
    fn inner_normals(&mut self, [m, n]: [usize; 2]) -> Vec<Option<BareNormal>> {
        let mut normals = vec![None; (m - 1) * (n - 1)];
        if let Some(field) = self.field.take() {
            field.grid(
                self.mesh.precision,
                &inside(m),
                &inside(n),
                |[i, j], own| {
                    normals[i * (n - 1) + j] = own.map(|own| self.bare_normal(own));
                },
            );
            self.field = Some(field);
        }
        normals
    }

    /// The triangles along a side. Around a collapsed one, each has the normal in its middle.
    fn side(&mut self, outline: &Outline, inner: &[(Real, Bare)]) {
        if let [(_, apex)] = outline.outer.as_slice() {
            for pair in inner.windows(2) {
                let middle = &(&pair[0].0 + &pair[1].0) / &Real::from(2);
                let normal = self.normal(&outline.parameters(&middle));
                self.triangle([(*apex, normal), pair[1].1, pair[0].1]);
            }
            return;
        }
        let outer: Vec<(Real, Bare)> = outline
            .outer
            .iter()
            .map(|(place, vertex)| {
                let normal = self.normal(&outline.parameters(place));
                (place.clone(), (*vertex, normal))
            })
            .collect();
        strip(&outer, inner, &mut |corners| self.triangle(corners));
    }

    /// The normal at parameters of the unit square.
    fn normal(&mut self, [u, v]: &[Real; 2]) -> Option<BareNormal> {
        let normal = self.field.as_ref()?.at(self.mesh.precision, u, v)?;
        Some(self.bare_normal(normal))
    }

    fn bare_normal(&mut self, normal: PlaceNormal) -> BareNormal {
        match normal.turned {
            Some(turned) => BareNormal::Known {
                place: self.known_normal(normal.vector),
                turned,
            },
            None => BareNormal::Open(normal.vector),
        }
    }

    /// The place of a normal in the list of all.
    fn known_normal(&mut self, normal: [Double; 3]) -> usize {
        let list = &mut self.mesh.normals;
        *self.known.entry(normal).or_insert_with(|| {
            list.push(normal);
            list.len() - 1
        })
    }

    /// A triangle. A normal that is open turns as the others do, so that it is their limit on this
    /// side; where the surface has none, or all are open, it is the triangle's own.
    fn triangle(&mut self, mut corners: [Bare; 3]) {
        if self.opposite {
            corners.swap(1, 2);
        }
        let side = corners.iter().find_map(|(_, normal)| match normal {
            Some(BareNormal::Known { turned, .. }) => Some(*turned),
            _ => None,
        });
        let normals = corners.map(|(_, normal)| match (normal?, side) {
            (BareNormal::Known { place, .. }, _) => Some(place),
            (BareNormal::Open(vector), Some(false)) => Some(self.known_normal(vector)),
            (BareNormal::Open(vector), Some(true)) => {
                Some(self.known_normal(vector.map(Double::negated)))
            }
            (BareNormal::Open(_), None) => None,
        });
        let vertices = corners.map(|(vertex, _)| vertex);
        let own = normals.contains(&None).then(|| {
            let points = vertices.map(|own| self.mesh.vertices[own]);
            let facet = facet_normal(self.mesh.precision, points);
            self.known_normal(facet.unwrap_or_default())
        });
        let corners = [0, 1, 2].map(|index| Corner {
            vertex: vertices[index],
            normal: normals[index].or(own).unwrap_or_default(),
        });
        let part = self.part;
        self.mesh.triangles.push(Triangle { part, corners });
    }
}
