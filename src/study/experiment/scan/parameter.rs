//! Values of a scene that are scanned.

use crate::scene::{Bearings, Motion, Scene};
use crate::study::experiment::cases::girder;

/// A value of the scene that is scanned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// Gap (assumed) \[mm\].
    Gap,
    /// Places of the legs along the girder, ± (assumed) \[mm\].
    LegsAlong,
    /// Places of the legs across the girder, ± (assumed) \[mm\].
    LegsAcross,
    /// Static friction; kinetic friction is 0.75 of it, as in Table 3.
    Friction,
    /// `e_n`.
    Restitution,
    /// `e_t` of the impact model, which the paper could not identify.
    Tangential,
    /// Power of ten of K in N/m; contact model.
    Stiffness,
    /// Scale of the earthquake.
    Scale,
    /// Skew angle β \[degrees\].
    Skew,
    /// Excitation angle \[degrees\].
    Angle,
}

impl Parameter {
    /// With its unit.
    pub fn label(self) -> &'static str {
        match self {
            Self::Gap => "gap [mm]",
            Self::LegsAlong => "legs at ±x [mm]",
            Self::LegsAcross => "legs at ±y [mm]",
            Self::Friction => "friction μ_s (μ_k = 0.75 μ_s)",
            Self::Restitution => "restitution e_n",
            Self::Tangential => "restitution along the face e_t",
            Self::Stiffness => "log10 of K [N/m]",
            Self::Scale => "scale of the record",
            Self::Skew => "skew angle β [°]",
            Self::Angle => "excitation angle [°]",
        }
    }

    /// Its value in the presets.
    pub fn preset(self) -> f64 {
        match self {
            Self::Gap => 1e3 * girder::GAP,
            Self::LegsAlong => 1e3 * girder::LEGS[0],
            Self::LegsAcross => 1e3 * girder::LEGS[1],
            Self::Friction => girder::FRICTION[0],
            Self::Restitution => girder::RESTITUTION,
            Self::Tangential => girder::TANGENTIAL,
            Self::Stiffness => girder::STIFFNESS.log10(),
            Self::Scale => 1.0,
            Self::Skew => 45.0,
            Self::Angle => 0.0,
        }
    }

    /// Sets it in a scene of the paper's.
    pub(super) fn set(self, scene: &mut Scene, value: f64) {
        match self {
            Self::Gap => set_gap(scene, value / 1e3),
            Self::LegsAlong => set_legs(scene, 0, value / 1e3),
            Self::LegsAcross => set_legs(scene, 1, value / 1e3),
            Self::Friction => {
                (scene.contact.mu_static, scene.impact.mu_static) = (value, value);
                let kinetic = value * (girder::FRICTION[1] / girder::FRICTION[0]);
                (scene.contact.mu_kinetic, scene.impact.mu_kinetic) = (kinetic, kinetic);
            }
            Self::Restitution => {
                (scene.contact.restitution_normal, scene.impact.restitution_normal) = (value, value);
            }
            Self::Tangential => scene.impact.restitution_tangential = value,
            Self::Stiffness => scene.contact.stiffness = Some(10f64.powf(value)),
            Self::Scale => {
                if let Motion::Record(record) = &mut scene.motion {
                    record.scale *= value;
                }
            }
            Self::Skew => scene.girders.iter_mut().for_each(|girder| girder.skew_deg = value),
            Self::Angle => match &mut scene.motion {
                Motion::Sine(sine) => sine.angle_deg = value,
                Motion::Record(record) => record.angle_deg = value,
                Motion::None | Motion::Synthetic(_) | Motion::Sweep(_) => {}
            },
        }
    }
}

/// Sets the gap before an abutment, or between two girders in a row \[m\].
fn set_gap(scene: &mut Scene, gap: f64) {
    scene.abutments.iter_mut().for_each(|abutment| abutment.gap = Some(gap));
    if let [first, second] = scene.girders.as_mut_slice() {
        second.position[0] = first.position[0] + 0.5 * (first.length + second.length) + gap;
    }
}

/// Sets the distance of the legs from the middle along one axis \[m\].
fn set_legs(scene: &mut Scene, axis: usize, distance: f64) {
    for girder in &mut scene.girders {
        if let Some(Bearings::Shared(shared)) = &mut girder.bearings {
            let places = shared.at_skewed.iter_mut().flatten();
            places.for_each(|place| place[axis] = distance.copysign(place[axis]));
        }
    }
}
