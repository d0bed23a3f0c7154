//! Displacements and rotations shown larger than they are; numbers stay what they are.
//!
//! Contacts go with the body that owns their node. A gap is no displacement: it is shown as it is placed, so bodies that
//! are shown moved too far reach into one another.

use glam::{DMat3, DQuat, DVec3};

use super::gap;
use super::moment::Moment;
use crate::dynamics::Body;
use crate::sim::{History, Motion};

/// A body's motion, `factor` times as far from where it was placed.
pub(super) fn motion(body: &Body, motion: &Motion, factor: f64) -> Motion {
    let home = DQuat::from_mat3(&DMat3::from_cols(body.axes.x_axis, body.axes.y_axis, body.axes.z_axis));
    let turn = (motion.attitude * home.inverse()).to_scaled_axis();
    // The rotation vector has no turns beyond a half; θ counts them all.
    let turn = if turn.truncate().length() < 1e-12 { DVec3::Z * motion.theta } else { turn };
    let displacement = motion.displacement * factor;
    Motion {
        place: body.home + displacement,
        displacement,
        theta: motion.theta * factor,
        attitude: DQuat::from_scaled_axis(turn * factor) * home,
        ..*motion
    }
}

impl Moment {
    /// The moment with everything moved `factor` times as far.
    pub(super) fn exaggerated(mut self, history: &History, factor: f64) -> Self {
        let model = history.model();
        self.true_gaps = gap::gaps(history.scene(), &self).into_iter().map(|g| g.map(|g| g.gap)).collect();
        // The dimension lines stand at the girders as they are shown.
        self.ends.clear();
        let before = self.motions.clone();
        for motions in [&mut self.motions, &mut self.ghosts] {
            for (own, body) in motions.iter_mut().zip(&model.bodies) {
                *own = motion(body, own, factor);
            }
        }
        for wall in self.walls.iter_mut().flatten() {
            wall.displacement *= factor;
            wall.soil.iter_mut().for_each(|soil| soil.front *= factor);
        }
        for pier in &mut self.piers {
            (pier.displacement, pier.foot, pier.theta) =
                (pier.displacement * factor, pier.foot * factor, pier.theta * factor);
        }
        self.feet.iter_mut().flatten().for_each(|foot| *foot *= factor);
        let moved = &self.motions;
        let place = |contact: usize, point: DVec3| {
            let site = &model.sites[contact];
            let motions = site.node_body.and_then(|b| Some((before.get(b)?, moved.get(b)?)));
            motions.map_or(point, |(before, m)| {
                // An edge node is another point of its edge at each touch.
                let own = site.edge.as_ref().map(|_| before.attitude.inverse() * (point - before.place));
                m.place + m.attitude * own.unwrap_or(site.point)
            })
        };
        for contact in &mut self.contacts {
            contact.point = place(contact.contact, contact.point);
        }
        for device in &mut self.devices {
            let link = &model.links[device.link];
            let end = |i: usize| match link.bodies[i].and_then(|body| Some((moved.get(body)?, &model.bodies[body]))) {
                Some((motion, body)) => motion.place + motion.attitude * (body.axes.transpose() * link.arms[i]),
                None => link.homes[i] + link.arms[i],
            };
            device.ends = [end(0), end(1)];
            device.line = link.device.centre_line(&device.phase, device.ends);
        }
        for opened in &mut self.opened {
            opened.point = place(opened.contact, opened.point);
        }
        for impulse in &mut self.impulses {
            impulse.point = place(impulse.contact, impulse.point);
        }
        self
    }
}
