//! Elastic-plastic Coulomb friction after Cundall and Strack (1979): the default law
//! (`docs/physics.md#law-return-mapping`).
//!
//! In slip p is dragged behind so that the spring carries exactly `μ_k |F_n|`: the stretch is `s = μ_k δ d`. The
//! tangential dashpot acts on the rate of the spring's own stretch, `−C_t (V_t − q̇)`, q̇ the rate of p along the face, so
//! the force is continuous on re-stick. Breakaway at `μ_s` lets the spring drop to `μ_k`.

use glam::DVec2;

use super::{Breakaway, Forces, Law, Local, Mode};

/// Slip in the direction `d` of the stretch. A turning `d` (two directions of sliding) is a state of the integrator.
pub(super) fn slip(law: &Law, direction: DVec2, here: &Local) -> Forces {
    let stretch = direction * (law.mu_k * here.penetration());
    let (sliding, normal_velocity) = here.relative_velocity(stretch);
    let anchor_rate = here.rate + direction * (law.mu_k * here.gap_rate);
    Forces {
        normal: law.k * here.penetration(),
        normal_damping: -law.c_n * normal_velocity,
        tangential: stretch * -law.k,
        tangential_damping: (sliding - anchor_rate) * -law.c_t,
        stretch,
        sliding,
        normal_velocity,
        anchor_rate,
    }
}

/// Rises through 0 when the plastic rate `λ = q̇·d` returns to 0 (`docs/physics.md#stop`).
///
/// With `μ_k = 0` there is no stretch to give d: it is where the node slides to, and in two directions of sliding nothing
/// comes to rest.
pub(super) fn stopping(law: &Law, direction: DVec2, here: &Local) -> f64 {
    if law.mu_k == 0.0 && law.v_stick > 0.0 {
        return -here.rate.length();
    }
    -(here.rate.dot(direction) + law.mu_k * here.gap_rate)
}

/// Breakaway: the stretch drops from `μ_s δ` to `μ_k δ`, along itself.
pub(super) fn breakaway(law: &Law, anchor: DVec2, here: &Local) -> Breakaway {
    let stretch = here.way - anchor;
    // Without a stretch there is nothing to pull: it slides where it goes.
    let (sliding, _) = here.relative_velocity(stretch);
    let direction = stretch.try_normalize().or(sliding.try_normalize()).unwrap_or(DVec2::X);
    let kept = law.mu_k * here.penetration();
    Breakaway { mode: Mode::Slip { direction }, released: 0.5 * law.k * (stretch.length_squared() - kept * kept) }
}
