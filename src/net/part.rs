use std::cell::OnceCell;
use std::rc::Rc;

use crate::check::Checked;
use crate::number::Real;
use crate::poly::{BiPoly, from_bernstein};
use crate::sweep::HomogeneousSurface;

use super::{ControlNet, Patch};

/// One surface of a model.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// The surface as one net over its domain, whatever the signs of its weights.
    pub net: ControlNet,
    surface: Option<Rc<HomogeneousSurface>>,
    patches: OnceCell<Result<Vec<Patch>, String>>,
}

impl Part {
    /// A checked surface; none if W is 0 at the first corner of its domain.
    #[must_use]
    pub fn of(surface: &Checked) -> Option<Self> {
        let (u, v) = (&surface.domain().u, &surface.domain().v);
        let homogeneous = surface.surface().clone();
        let coordinates = homogeneous.coordinates().each_ref();
        let net = ControlNet::bezier(coordinates, (u.start(), u.end()), (v.start(), v.end()))?;
        Some(Self {
            name: surface.name().to_owned(),
            net,
            surface: Some(Rc::new(homogeneous)),
            patches: OnceCell::new(),
        })
    }

    /// The surface of a net.
    #[must_use]
    pub fn of_net(name: &str, net: ControlNet) -> Self {
        let one_span = |count: usize| count == 2;
        let spans_u = net.knots_u().multiplicities().len();
        let spans_v = net.knots_v().multiplicities().len();
        let single = one_span(spans_u) && one_span(spans_v);
        Self {
            name: name.to_owned(),
            surface: single.then(|| Rc::new(homogeneous(&net))),
            net,
            patches: OnceCell::new(),
        }
    }

    /// W, X, Y, Z; none if the net has several spans, each with polynomials of its own, as its
    /// [patches](Patch) tell.
    #[must_use]
    pub fn surface(&self) -> Option<&HomogeneousSurface> {
        self.surface.as_deref()
    }

    /// The surface in patches whose weights are all positive, in order of u, then v.
    ///
    /// # Errors
    ///
    /// Why there are none, in a few words.
    pub fn patches(&self) -> Result<&[Patch], &str> {
        let patches = self.patches.get_or_init(|| self.divide());
        patches.as_deref().map_err(String::as_str)
    }

    fn divide(&self) -> Result<Vec<Patch>, String> {
        if !self.net.all_positive() {
            let least = self.net.min_weight().brief();
            return Err(format!("a control point has weight {least}"));
        }
        let surface = self.surface.clone();
        Ok(vec![Patch {
            net: self.net.clone(),
            surface: surface.unwrap_or_else(|| Rc::new(homogeneous(&self.net))),
        }])
    }
}

/// W, X, Y, Z of a net of one span.
fn homogeneous(net: &ControlNet) -> HomogeneousSurface {
    let (from_u, to_u) = net.knots_u().domain();
    let (from_v, to_v) = net.knots_v().domain();
    let coordinate = |axis: usize| {
        (0..net.rows()).fold(BiPoly::zero(), |sum, i| {
            let row = (0..net.columns()).map(|j| net.homogeneous(i, j)[axis].clone());
            let in_v = from_bernstein(&row.collect::<Vec<_>>(), from_v, to_v);
            let mut unit = vec![Real::from(0); net.rows()];
            unit[i] = Real::from(1);
            let in_u = from_bernstein(&unit, from_u, to_u);
            &sum + &BiPoly::product(&in_u, &in_v)
        })
    };
    HomogeneousSurface::new([0, 1, 2, 3].map(coordinate))
}
