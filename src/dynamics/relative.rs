//! How far, fast and sharply two girders can move against each other: less than the sum of what each can do.
//!
//! Under one ground motion the steady responses of like girders cancel, and the difference of two free motions of like
//! oscillators is a free motion itself, whose energy never grows. In a row that sways as one no gap can close, and no
//! look at it is needed until somebody is hit.

use super::bound::Bound;
use super::flight::{Dof, Planar, System, SystemForm};
use crate::motion::Ground;

/// A girder in flight: its system, its state, and the free part of it where that is split off.
pub(super) struct Flyer<'a> {
    pub system: &'a System,
    pub state: Planar,
    pub free: Option<Planar>,
    pub bound: Bound,
}

/// Bounds on the difference of two motions of G over `[t, t + window]`. Rotations have bounds of their own, which hold as
/// long where no record drives them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Apart {
    /// Displacement \[m\].
    pub reach: f64,
    /// Speed \[m/s\].
    pub speed: f64,
    /// Acceleration \[m/s²\].
    pub acceleration: f64,
    /// How long they hold \[s\].
    pub window: f64,
}

impl Apart {
    /// Of two sides, one of which may stand.
    pub(super) fn of(sides: &[Option<Flyer<'_>>; 2], horizon: f64) -> Self {
        match sides {
            [Some(a), Some(b)] => Self::between(a, b, horizon).unwrap_or_else(|| Self::sum(&a.bound, &b.bound)),
            [Some(a), None] | [None, Some(a)] => Self::sum(&a.bound, &Bound::still(horizon)),
            [None, None] => Self::sum(&Bound::still(horizon), &Bound::still(horizon)),
        }
    }

    fn sum(a: &Bound, b: &Bound) -> Self {
        Self {
            reach: a.reach + b.reach,
            speed: a.speed + b.speed,
            acceleration: a.acceleration + b.acceleration,
            window: a.window.min(b.window),
        }
    }

    /// Two girders in flight; nothing where more than a sum cannot be said.
    fn between(a: &Flyer<'_>, b: &Flyer<'_>, horizon: f64) -> Option<Self> {
        let (SystemForm::Split { dof: first, .. }, SystemForm::Split { dof: second, .. }) =
            (&a.system.form, &b.system.form)
        else {
            return None;
        };
        let mut limits = [[0.0; 3]; 2];
        for (i, limit) in limits.iter_mut().enumerate() {
            let dofs = [&first[i], &second[i]];
            let pushes = [a.system.push[i], b.system.push[i]];
            let like = dofs[0].oscillator == dofs[1].oscillator && dofs[0].free && dofs[1].free;
            *limit = match (&a.free, &b.free) {
                (Some(p), Some(q)) if like => difference(dofs, [p, q], i, pushes, drive(a.system), horizon),
                (Some(p), Some(q)) => both(dofs, [p, q], i, pushes, drive(a.system), horizon),
                // Under a record the force of the ground itself cancels.
                _ if like => difference(dofs, [&a.state, &b.state], i, pushes, 0.0, horizon),
                _ => return None,
            };
        }
        let plan = |k: usize| (limits[0][k] * limits[0][k] + limits[1][k] * limits[1][k]).sqrt();
        Some(Self { reach: plan(0), speed: plan(1), acceleration: plan(2), window: horizon })
    }
}

fn drive(system: &System) -> f64 {
    if let Ground::Sine { omega, .. } = system.ground { omega } else { 0.0 }
}

/// The phasors' difference as an amplitude \[m\].
fn amplitude([a, b]: [&Dof; 2]) -> f64 {
    (a.steady.0 - b.steady.0).hypot(a.steady.1 - b.steady.1)
}

fn difference(dofs: [&Dof; 2], [p, q]: [&Planar; 2], i: usize, push: [f64; 2], drive: f64, horizon: f64) -> [f64; 3] {
    let dof = Dof { amplitude: amplitude(dofs), ..*dofs[0] };
    dof.limits([p[i] - q[i], p[3 + i] - q[3 + i]], drive, push[0] - push[1], horizon)
}

fn both(dofs: [&Dof; 2], parts: [&Planar; 2], i: usize, push: [f64; 2], drive: f64, horizon: f64) -> [f64; 3] {
    let steady = amplitude(dofs);
    let mut sum = [steady, drive * steady, drive * drive * steady];
    for ((dof, part), push) in dofs.into_iter().zip(parts).zip(push) {
        let free = Dof { amplitude: 0.0, ..*dof }.limits([part[i], part[3 + i]], drive, push, horizon);
        (0..3).for_each(|k| sum[k] += free[k]);
    }
    sum
}
