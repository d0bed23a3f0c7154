//! Whether the energy ledger balances: what its residual may be, as the stability study holds every answer to
//! (`docs/stability.md`).

use crate::language::said;
use crate::sim::energy::view::Energy;
use crate::sim::{ContactNow, Touch};

/// Residual per tolerance. A step errs by the tolerance, relative to the motion in hand, its energy by twice that; errors of many
/// steps add up. Tuned: ten thousand seeds stay below.
const PER_TOLERANCE: f64 = 1e2;
/// Residual that rounding of the sums may leave. Tuned likewise.
const ROUNDING: f64 = 1e-11;
/// Rounding of a place against the depth of a contact, whose force it changes by as much.
const PLACES: f64 = 256.0 * f64::EPSILON;
/// Touches whose depth is looked at, spread over all of them where there are more.
const LOOKS: usize = 100;

/// The residual of the energy ledger at the end of a run, beside its bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balance {
    /// |residual| in parts of the largest energy in play; 0 where there is none.
    pub residual: f64,
    /// The most that it may be.
    pub bound: f64,
}

impl Balance {
    /// Whether the residual keeps its bound; a NaN keeps none.
    pub fn holds(&self) -> bool {
        self.residual <= self.bound
    }
}

impl std::fmt::Display for Balance {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [residual, bound] = [self.residual, self.bound].map(|share| format!("{share:.1e}"));
        f.write_str(&said!("ledger-unsound", "residual" => residual, "bound" => bound))
    }
}

impl Energy<'_> {
    /// The ledger's residual at the end, beside its bound.
    pub fn balance(self) -> Balance {
        let ledger = self.ledger(self.history.end());
        let residual = if ledger.scale > 0.0 { ledger.residual.abs() / ledger.scale } else { 0.0 };
        let touches = self.history.hits().touches();
        let stride = touches.len().div_ceil(LOOKS).max(1);
        let touches = touches.iter().step_by(stride);
        // The force of a dashpot is largest where a hit begins, with no depth yet: within a touch too.
        let inside = |touch: &Touch, part: f64| touch.start + part * (touch.end - touch.start);
        let times = |touch: &Touch| [touch.peak_time, inside(touch, 0.25), inside(touch, 0.5), inside(touch, 0.75)];
        let pressed = touches.flat_map(|touch| {
            times(touch).into_iter().filter_map(|t| self.history.contacts().contact_at(touch.contact, t))
        });
        Balance { residual, bound: self.residual_bound(ledger.scale, pressed) }
    }

    /// Bound on the ledger's residual per largest energy in play, `scale` \[J\], without unit: 100 tolerances, 1e-11, and 256 ε times the
    /// largest place over the deepest penetration of contacts as `pressed` and times `m g r` of all bodies per `scale`; of the impact model,
    /// whose contacts have no depth, times the largest force that lasts times its place per `scale`.
    pub fn residual_bound(self, scale: f64, pressed: impl Iterator<Item = ContactNow>) -> f64 {
        let model = self.history.model();
        let carried =
            (0..model.bodies.len()).filter(|&body| !model.moves_as_given(body)).map(|body| &model.bodies[body]);
        let lifted: f64 = carried.map(|b| b.mass * model.gravity * b.radius).sum();
        let lifted = lifted / scale.max(f64::MIN_POSITIVE);
        let placed = match self.history.impact() {
            Some(_) => self.held(pressed) / scale.max(f64::MIN_POSITIVE),
            None => self.shallowness(pressed),
        };
        PER_TOLERANCE * model.tolerance + ROUNDING + PLACES * (placed + lifted)
    }

    /// The largest of a force that lasts times the place where it acts \[J\].
    fn held(self, pressed: impl Iterator<Item = ContactNow>) -> f64 {
        let size = self.history.model().bodies.iter().map(|body| body.radius).fold(0.0, f64::max);
        pressed.map(|contact| contact.normal_force * (size + contact.point.length())).fold(0.0, f64::max)
    }

    /// The largest place over the deepest penetration; 0 without contact.
    fn shallowness(self, pressed: impl Iterator<Item = ContactNow>) -> f64 {
        let size = self.history.model().bodies.iter().map(|body| body.radius).fold(0.0, f64::max);
        let (mut place, mut depth) = (size, 0.0f64);
        for contact in pressed {
            place = place.max(size + contact.point.length());
            depth = depth.max(contact.penetration);
        }
        if depth > 0.0 { place / depth } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::sim::History;

    #[test]
    fn the_bound_grows_with_the_tolerance_and_as_contacts_get_shallower() {
        let mut scene = presets::load(presets::OPENING).expect("a preset");
        scene.duration = 2.0;
        let bound = |tolerance: f64, deeper: f64| {
            let mut scene = scene.clone();
            scene.solver.tolerance = tolerance;
            let history = History::of(&scene).expect("runs");
            let touch = history.hits().hardest().expect("it hits");
            let mut now = history.contacts().contact_at(touch.contact, touch.peak_time).expect("closed");
            now.penetration *= deeper;
            history.energy().residual_bound(history.energy().ledger(history.end()).scale, [now].into_iter())
        };
        assert!(bound(1e-6, 1.0) > bound(1e-8, 1.0));
        assert!(bound(1e-12, 1e-3) > bound(1e-12, 1.0));
        let nothing = Balance { residual: f64::NAN, bound: 1.0 };
        assert!(!nothing.holds() && Balance { residual: 0.5, ..nothing }.holds());
    }
}
