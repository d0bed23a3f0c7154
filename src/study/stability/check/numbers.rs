//! Every number is finite, attitudes are rotations, held directions do not move.

use super::finding::{Check, Complaint};
use crate::sim::{History, Motion};

pub(super) const CLAIM: &str = "every number is finite; a quaternion's length differs from 1 by 1e-12 at most; a held \
                                direction stays exactly where it was placed";

/// Allowed difference of a quaternion's length from 1 \[–\].
const LENGTH: f64 = 1e-12;

pub(super) fn check(history: &History, times: &[f64], complaints: &mut Vec<Complaint>) {
    for &t in times {
        for body in 0..history.model().bodies.len() {
            let motion = history.motion(body, t);
            let wrong = if is_finite(&motion) { moved(history, body, &motion) } else { Some("not finite".to_owned()) };
            if let Some(wrong) = wrong {
                let detail = format!("{wrong} at t = {t} s: {}", history.model().bodies[body].name);
                return complaints.push(Complaint::new(Check::Numbers, detail));
            }
        }
        if let Some(contact) =
            history.contacts().at(t).iter().find(|c| !c.force.is_finite() || !c.penetration.is_finite())
        {
            let name = &history.model().sites[contact.contact].node;
            let detail = format!("a force that is not finite at t = {t} s: {name}");
            return complaints.push(Complaint::new(Check::Numbers, detail));
        }
    }
}

fn is_finite(motion: &Motion) -> bool {
    motion.displacement.is_finite()
        && motion.velocity.is_finite()
        && motion.spin.is_finite()
        && motion.attitude.is_finite()
        && motion.theta.is_finite()
}

/// Fault of a body's motion.
fn moved(history: &History, body: usize, motion: &Motion) -> Option<String> {
    let off = (motion.attitude.length() - 1.0).abs();
    if off > LENGTH {
        return Some(format!("a quaternion of length 1 ± {off:e}"));
    }
    let model = &history.model().bodies[body];
    let [d, v, w] = [motion.displacement, motion.velocity, motion.spin];
    let start = model.start;
    let still = [
        (d.x - start[0], v.x, "x"),
        (d.y - start[1], v.y, "y"),
        (d.z - start[2], v.z, "z"),
        (0.0, w.x, "roll"),
        (0.0, w.y, "pitch"),
        (motion.theta - start[3], w.z, "yaw"),
    ];
    let held = still.into_iter().zip(model.free).filter(|(_, free)| !free);
    // A held yaw is read back from the attitude: rounding of an arc tangent.
    let strayed =
        held.map(|(s, _)| s).find(|(d, v, name)| *v != 0.0 || d.abs() > if *name == "yaw" { 1e-15 } else { 0.0 });
    strayed.map(|(d, v, name)| format!("held in {name}, moved by {d:e} at {v:e}"))
}
