//! Straight elastic girders in one line, shaken along it, as bars: what the finite elements and the second answer compute. Numbers
//! of the scene alone; nothing of the solver is used.

use crate::scene::{Kind, Motion, Scene};

/// A bar with its springs to the ground.
#[derive(Clone, Debug)]
pub(super) struct Bar {
    /// L \[m\].
    pub(super) length: f64,
    /// m \[kg\].
    pub(super) mass: f64,
    /// E A \[N\].
    pub(super) axial: f64,
    /// β of a damping stress `β E ε̇` \[s\].
    pub(super) retardation: f64,
    /// Springs and dashpots to the ground: distance from the −x end \[m\], k \[N/m\], c \[N·s/m\].
    pub(super) legs: Vec<[f64; 3]>,
    /// Velocity at the start \[m/s\].
    pub(super) speed: f64,
}

impl Bar {
    /// Speed of waves, √(E A L/m) \[m/s\].
    pub(super) fn wave_speed(&self) -> f64 {
        (self.axial * self.length / self.mass).sqrt()
    }
}

/// One or two bars in a line: the last one's +x end before a wall, or the first one's before the second.
#[derive(Clone, Debug)]
pub(super) struct Line {
    /// From −x to +x.
    pub(super) bars: Vec<Bar>,
    /// Gap as placed \[m\].
    pub(super) gap: f64,
    /// K of the whole face; there is no dashpot \[N/m\].
    pub(super) stiffness: f64,
    /// Nodes that share it.
    pub(super) nodes: f64,
    /// Amplitude \[m/s²\] and circular frequency \[rad/s\] of the ground, a sine from phase 0.
    pub(super) drive: [f64; 2],
}

impl Line {
    /// Of a scene; `None` where it is no such line.
    pub(super) fn of(scene: &Scene) -> Option<Self> {
        let bars: Vec<Bar> = scene.girders.iter().map(|girder| bar(scene, girder)).collect::<Option<_>>()?;
        let contact = &scene.contact;
        let smooth = contact.restitution_normal == 1.0 && contact.mu_static == 0.0 && scene.kind == Kind::Planar;
        let gap = match (&scene.girders[..], &scene.abutments[..]) {
            ([_], [wall]) => wall.gap?,
            ([a, b], []) => b.position[0] - a.position[0] - 0.5 * (a.length + b.length),
            _ => return None,
        };
        let drive = match &scene.motion {
            Motion::None => [0.0, 1.0],
            Motion::Sine(sine) if sine.phase_deg == 0.0 && sine.angle_deg == 0.0 => {
                [sine.amplitude?, std::f64::consts::TAU * sine.frequency_hz]
            }
            _ => return None,
        };
        // Corners of both ends against the other's face; a wall's own enter none.
        let nodes = if bars.len() > 1 { 4.0 } else { 2.0 };
        smooth.then_some(Self { bars, gap, stiffness: contact.stiffness?, nodes, drive })
    }

    /// Acceleration of the ground \[m/s²\].
    pub(super) fn ground(&self, t: f64) -> f64 {
        self.drive[0] * (self.drive[1] * t).sin()
    }
}

fn bar(scene: &Scene, girder: &crate::scene::Girder) -> Option<Bar> {
    let elastic = girder.elastic.as_ref()?;
    let retardation = match (elastic.damping_ratio, &elastic.rayleigh) {
        (Some(0.0), None) => 0.0,
        (None, Some(rayleigh)) if rayleigh.mass == 0.0 => rayleigh.stiffness,
        _ => return None,
    };
    let bearings = girder.bearings.as_ref().map(|b| b.resolve(girder, scene.setting())).unwrap_or_default();
    let legs = bearings.iter().map(|leg| [leg.place.x + 0.5 * girder.length, leg.stiffness[0], leg.damping[0]]);
    Some(Bar {
        length: girder.length,
        mass: girder.mass,
        axial: elastic.young_modulus * elastic.area?,
        retardation,
        legs: legs.collect(),
        speed: girder.initial.velocity[0],
    })
}
