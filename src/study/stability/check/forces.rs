//! Friction lies in its cone.

use super::finding::{Check, Complaint, Figures};
use super::looks::{early_or_late, size};
use crate::sim::{ContactNow, ContactState, History};

pub(super) const CLAIM: &str = "|F_t| ≤ μ_s |F_n| in stick and ≤ μ_k |F_n| in slip, dashpots apart, to 1e-8 of the \
                                contact's peak |F_n| μ and K times the rounding of the farthest place so far, or what \
                                the node moves in a billionth of the contact's radian, within which events are one";

/// Beyond the cone, in parts of the largest friction.
const BEYOND: f64 = 1e-8;
/// Rounding of a place, in parts of the largest girder and of the farthest place so far: what the distance of two girders has rounded
/// by there, it keeps when they come back.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

pub(super) fn check(history: &History, times: &[f64], figures: &mut Figures, complaints: &mut Vec<Complaint>) {
    let all: Vec<(f64, Vec<ContactNow>)> = times.iter().map(|&t| (t, history.contacts().at(t))).collect();
    let peak = all.iter().flat_map(|(_, now)| now).map(|c| c.normal_force).fold(0.0, f64::max);
    let mut farthest = 0.0f64;
    for (t, now) in &all {
        let bodies = 0..history.model().bodies.len();
        farthest = bodies.map(|body| history.motion(body, *t).displacement.length()).fold(farthest, f64::max);
        for contact in now {
            let mu = if contact.state == ContactState::Slip { contact.mu_kinetic } else { contact.mu_static };
            let beyond = contact.tangential_force.length() - mu * contact.normal_force.max(0.0);
            let site = &history.model().sites[contact.contact];
            let stiffness = history.model().pairs[contact.pair].contact.stiffness;
            let place = size(history) + contact.point.length().max(farthest) + site.face.size();
            let late = early_or_late(history, contact.pair, contact.normal_velocity);
            let beyond = beyond - stiffness * (ROUNDING * place + late) * (1.0 + mu);
            figures.cone = figures.cone.max(beyond / peak.max(f64::MIN_POSITIVE));
            if beyond > BEYOND * mu * peak {
                let detail = format!(
                    "{} on {} at t = {t} s, {}: |F_t| = {:e} N is {beyond:e} N beyond μ |F_n| = {:e} N",
                    site.node,
                    site.face_name,
                    contact.state.label(),
                    contact.tangential_force.length(),
                    mu * contact.normal_force,
                );
                return complaints.push(Complaint::new(Check::Cone, detail));
            }
        }
    }
}
