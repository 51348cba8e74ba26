use std::cell::OnceCell;
use std::rc::Rc;

use crate::check::{Checked, Positivity};
use crate::number::{Field, Real};
use crate::poly::{BiPoly, from_bernstein};
use crate::sweep::{Domain, HomogeneousSurface};

use super::{ControlNet, Knots, Patch};

/// One surface of a model.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// The surface as one net over its domain, whatever the signs of its weights.
    pub net: ControlNet,
    pieces: Vec<Piece>,
    division: (usize, usize),
    patches: OnceCell<Result<Vec<Patch>, &'static str>>,
}

/// The surface on one pair of spans.
#[derive(Clone, Debug)]
struct Piece {
    surface: Rc<HomogeneousSurface>,
    positivity: Result<Positivity, &'static str>,
}

impl Part {
    /// A checked surface; none if W is 0 at the first corner of its domain.
    #[must_use]
    pub fn of(surface: &Checked) -> Option<Self> {
        let (u, v) = (&surface.domain().u, &surface.domain().v);
        let homogeneous = surface.surface().clone();
        let coordinates = homogeneous.proportional().each_ref();
        let net = ControlNet::bezier(coordinates, (u.start(), u.end()), (v.start(), v.end()))?;
        let piece = Piece {
            surface: Rc::new(homogeneous),
            positivity: surface.positivity().cloned(),
        };
        Some(Self::with_pieces(surface.name(), net, vec![piece]))
    }

    /// The surface of a net.
    #[must_use]
    pub fn of_net(name: &str, net: ControlNet) -> Self {
        let (spans_u, spans_v) = (spans(net.knots_u()), spans(net.knots_v()));
        let pairs = spans_u
            .iter()
            .flat_map(|u| spans_v.iter().map(move |v| (u, v)));
        let pieces = pairs.filter_map(|(u, v)| {
            let own = net.restricted((&u.0, &u.1), (&v.0, &v.1))?;
            let surface = homogeneous(&own);
            let domain = Domain::new(u.clone(), v.clone())?;
            Some(Piece {
                positivity: Positivity::of(surface.weight(), own.degree(), &domain),
                surface: Rc::new(surface),
            })
        });
        let pieces = pieces.collect();
        Self::with_pieces(name, net, pieces)
    }

    fn with_pieces(name: &str, net: ControlNet, pieces: Vec<Piece>) -> Self {
        Self {
            name: name.to_owned(),
            net,
            pieces,
            division: (1, 1),
            patches: OnceCell::new(),
        }
    }

    /// The same surface with each patch cut into equal parts along u and along v.
    #[must_use]
    pub fn divided(&self, along_u: usize, along_v: usize) -> Self {
        Self {
            division: (along_u.max(1), along_v.max(1)),
            patches: OnceCell::new(),
            ..self.clone()
        }
    }

    /// W, X, Y, Z; none if the net has several spans, each with polynomials of its own, as its
    /// [patches](Patch) tell.
    #[must_use]
    pub fn surface(&self) -> Option<&HomogeneousSurface> {
        match self.pieces.as_slice() {
            [piece] => Some(&piece.surface),
            _ => None,
        }
    }

    /// The surface in patches whose weights are all positive, in order of u, then v.
    ///
    /// # Errors
    ///
    /// Why there are none, in a few words.
    pub fn patches(&self) -> Result<&[Patch], &'static str> {
        let patches = self.patches.get_or_init(|| self.cut());
        patches.as_deref().map_err(|reason| *reason)
    }

    fn cut(&self) -> Result<Vec<Patch>, &'static str> {
        if self.net.all_positive() && self.division == (1, 1) && self.pieces.len() == 1 {
            let surface = self.pieces[0].surface.clone();
            let net = self.net.clone();
            return Ok(vec![Patch { net, surface }]);
        }
        let mut patches = Vec::new();
        for Piece {
            surface,
            positivity,
        } in &self.pieces
        {
            let positivity = positivity.as_ref().map_err(|reason| *reason)?;
            let rectangles = positivity.rectangles.iter();
            for rectangle in rectangles.flat_map(|own| own.divided(self.division)) {
                let (u, v) = (&rectangle.u, &rectangle.v);
                let coordinates = surface.proportional().each_ref();
                let (u, v) = ((u.start(), u.end()), (v.start(), v.end()));
                let net = ControlNet::bezier(coordinates, u, v);
                let net = net.and_then(|own| own.elevated(positivity.degree));
                patches.push(Patch {
                    net: net.ok_or("a weight is 0 at the corner of a patch")?,
                    surface: Rc::clone(surface),
                });
            }
        }
        let place = |own: &Patch| {
            let corner = (own.net.knots_u().domain().0, own.net.knots_v().domain().0);
            (corner.0.clone(), corner.1.clone())
        };
        patches.sort_by_cached_key(place);
        Ok(patches)
    }
}

/// The intervals between different knots.
fn spans(knots: &Knots) -> Vec<(Real, Real)> {
    let knots = knots.multiplicities();
    let pairs = knots.windows(2);
    pairs
        .map(|own| (own[0].0.clone(), own[1].0.clone()))
        .collect()
}

/// W, X, Y, Z of a net of one span.
fn homogeneous(net: &ControlNet) -> HomogeneousSurface {
    let (from_u, to_u) = net.knots_u().domain();
    let (from_v, to_v) = net.knots_v().domain();
    let coordinate = |axis: usize| {
        (0..net.rows()).fold(BiPoly::zero(), |sum, i| {
            let row = (0..net.columns()).map(|j| net.homogeneous(i, j)[axis].clone());
            let in_v = from_bernstein(&row.collect::<Vec<_>>(), from_v, to_v);
            let mut unit = vec![Real::zero(); net.rows()];
            unit[i] = Real::one();
            let in_u = from_bernstein(&unit, from_u, to_u);
            &sum + &BiPoly::product(&in_u, &in_v)
        })
    };
    HomogeneousSurface::new([0, 1, 2, 3].map(coordinate))
}
