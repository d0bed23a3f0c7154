//! The paper's friction (55)–(59), read in continuous time (`docs/physics.md#law-paper`).
//!
//! In slip p is the projection of the node: no tangential spring, no tangential dashpot, friction `μ_k |F_n|` against the
//! sliding velocity. On re-stick the tangential force starts again from 0, so a static load creeps; `return_mapping` is
//! the law that holds.

use glam::DVec2;

use super::{Breakaway, Forces, Law, Local, Mode};

/// Below this fraction of the node's speed, `V_t` at breakaway is rounding and the direction comes from the spring.
const STILL: f64 = 1e-12;

/// (57b), (59). With one direction of sliding, friction opposes `direction` until `V_t` stops; with two, it opposes
/// `V_t / max(|V_t|, v_stick)`.
pub(super) fn slip(law: &Law, direction: DVec2, here: &Local) -> Forces {
    let (sliding, normal_velocity) = here.relative_velocity(DVec2::ZERO);
    let normal = law.k * here.penetration();
    let along = if law.v_stick > 0.0 { sliding / sliding.length().max(law.v_stick) } else { direction };
    Forces {
        normal,
        normal_damping: -law.c_n * normal_velocity,
        tangential: along * (-law.mu_k * normal),
        tangential_damping: DVec2::ZERO,
        stretch: DVec2::ZERO,
        sliding,
        normal_velocity,
        anchor_rate: sliding,
    }
}

/// Rises through 0 when `V_t` stops (`docs/physics.md#stop`). With two directions of sliding it is above 0 for a moment
/// only: smooth, so that looks on either side bend towards it, where the length of `V_t` would come to a point.
pub(super) fn stopping(law: &Law, direction: DVec2, here: &Local) -> f64 {
    let (sliding, _) = here.relative_velocity(DVec2::ZERO);
    if law.v_stick > 0.0 {
        0.5 * (law.v_stick - sliding.length_squared() / law.v_stick)
    } else {
        -sliding.dot(direction)
    }
}

/// Breakaway (`docs/physics.md#breakaway`): friction opposes `V_t`, whatever its direction; where `V_t` is zero, it
/// points along the spring's pull.
pub(super) fn breakaway(law: &Law, anchor: DVec2, here: &Local) -> Breakaway {
    let stretch = here.way - anchor;
    let (sliding, normal) = here.relative_velocity(DVec2::ZERO);
    let speed = sliding.length();
    let still = STILL * (speed + normal.abs());
    let direction = if speed > still { sliding / speed } else { stretch.try_normalize().unwrap_or(DVec2::X) };
    Breakaway { mode: Mode::Slip { direction }, released: 0.5 * law.k * stretch.length_squared() }
}
