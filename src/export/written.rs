use crate::net::{ControlNet, Knots};
use crate::number::{Field, Real};

use super::refusal::{Readers, check_doubles};
use super::{ExportFault, Fidelity, RoundedNet};

/// What is known of the nets that are written.
pub(super) struct Written {
    readers: &'static Readers,
    pub(super) fidelity: Option<Fidelity>,
    pub(super) warnings: Vec<ExportFault>,
}

impl Written {
    /// Nothing yet, for these readers.
    pub(super) fn for_readers(readers: &'static Readers) -> Self {
        Self {
            readers,
            fidelity: None,
            warnings: Vec::new(),
        }
    }

    /// The doubles of some nets; of each kind of warning the first is kept.
    ///
    /// - **errors** a number beyond what the readers take, weights that vanish, knots that merge
    ///   (E0306)
    pub(super) fn round<'a>(
        &mut self,
        nets: impl Iterator<Item = &'a ControlNet>,
    ) -> Result<Vec<RoundedNet>, ExportFault> {
        let mut list = Vec::new();
        for net in nets {
            let net = readable(net);
            let rounded = RoundedNet::new(&net)?;
            check_doubles(&net, &rounded)?;
            let coordinates = rounded.points.iter().flatten().flatten();
            let weights = rounded.weights.iter().flatten();
            self.readers.check_sizes(coordinates.chain(weights))?;
            let fidelity = rounded.fidelity(&net);
            self.fidelity = Some(match self.fidelity.take() {
                Some(known) => known.worse(fidelity),
                None => fidelity,
            });
            for warning in &rounded.warnings {
                if self.warnings.iter().all(|own| own.code != warning.code) {
                    self.warnings.push(warning.clone());
                }
            }
            list.push(rounded);
        }
        Ok(list)
    }
}

/// The net over a domain that readers can tell from a point: a direction whose parameters lie too
/// close together, or too far out, runs from 0 to 1 instead. The surface is the same.
fn readable(net: &ControlNet) -> ControlNet {
    let limit = Real::from(1_000_000);
    let knots = |knots: &Knots| {
        let (from, to) = knots.domain();
        let length = to.minus(from);
        let far = |end: &Real| {
            let end = if end.sign().is_lt() {
                end.negated()
            } else {
                end.clone()
            };
            end > length.times(&limit)
        };
        let short = length.times(&limit) < Real::one();
        if short || length > limit || far(from) || far(to) {
            knots.normalised()
        } else {
            knots.clone()
        }
    };
    let moved = net.with_knots(knots(net.knots_u()), knots(net.knots_v()));
    moved.unwrap_or_else(|| net.clone())
}
