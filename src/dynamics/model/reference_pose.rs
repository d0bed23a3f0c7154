//! Pose of a body at the start of its present contact: the origin that its motion in contact is counted from.
//!
//! A contact of a stiff face and a light girder is pressed by less than the last digit of where the girder is. So bodies that
//! touch are integrated as what they moved since the first of their touches, and node and face are measured as if they had
//! been placed there ([`ContactGeometry::seen_from`]): the round-off of a gap is then proportional to the
//! displacement during contact, not to that since the body was placed.

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::contact::{ContactGeometry, Frame, locate, turned_by};
use crate::dynamics::model::edge_node::node_place::NodePlace;
use crate::dynamics::model::pair::ContactSite;

/// A place and attitude, and what is counted from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferencePose {
    /// Whether it is a turn about the vertical only.
    level: bool,
    /// Displacement of G since it was placed \[m\].
    shift: DVec3,
    /// Level: the angle that it had turned \[rad\].
    angle: f64,
    /// Rotation as a quaternion, in space.
    turn: DQuat,
    /// Rotation of the body less the identity, R − 1.
    turned: DMat3,
    /// Number of the flight that ended there, where its end is that to the last bit.
    pub(in crate::dynamics) flown: Option<u32>,
    /// Its number among the stored states from which steps are recomputed.
    pub(in crate::dynamics) stored_number: Option<u32>,
}

impl ReferencePose {
    /// Displaced, and turned about the vertical by an angle \[rad\], which adds `turned` to the identity.
    pub fn level(shift: DVec3, angle: f64, turned: DMat3) -> Self {
        Self { level: true, shift, angle, turn: DQuat::IDENTITY, turned, flown: None, stored_number: None }
    }

    /// Displaced and turned in space.
    pub fn spatial(shift: DVec3, turn: DQuat) -> Self {
        Self { level: false, shift, angle: 0.0, turn, turned: turned_by(turn), flown: None, stored_number: None }
    }

    /// Whether it is where the body was placed; a level one keeps its height.
    fn is_placed(&self) -> bool {
        if self.level {
            self.shift.x == 0.0 && self.shift.y == 0.0 && self.angle == 0.0
        } else {
            self.shift == DVec3::ZERO && self.turn == DQuat::IDENTITY
        }
    }

    /// `x, y, θ` of a level one.
    #[inline]
    pub fn planar(&self) -> DVec3 {
        DVec3::new(self.shift.x, self.shift.y, self.angle)
    }

    /// The pose there, at rest; all that is counted from it is independent of where the body was placed.
    pub(in crate::dynamics) fn pose(&self) -> Frame {
        let (shift, turned, heading) = (self.shift, self.turned, self.angle);
        Frame { shift, turned, heading, level: self.level, ..Frame::fixed(DVec3::ZERO) }
    }

    /// The pose since the body was placed, of one counted from here.
    #[inline]
    pub fn whole(&self, since: &Frame) -> Frame {
        let shift = self.shift + since.shift;
        let (here, before) = (&since.turned, &self.turned);
        // (1 + d)(1 + D) = 1 + D + d + d D.
        let turned = if *before == DMat3::ZERO { *here } else { *before + (*here + *here * *before) };
        Frame { shift, turned, heading: self.angle + since.heading, ..*since }
    }

    /// Displacement and rotation about the vertical of that pose alone.
    #[inline]
    pub(in crate::dynamics) fn whole_in_plan(&self, since: &Frame) -> (DVec3, f64) {
        (self.shift + since.shift, self.angle + since.heading)
    }

    /// Number of numbers of its position and attitude, unless it is the placed pose.
    pub(in crate::dynamics) fn size(&self) -> usize {
        if self.level { 3 } else { 7 }
    }

    /// Place and attitude by numbers, `x, y, θ` or `x, y, z` and a quaternion; none where that is where the body was placed.
    pub fn numbers(&self) -> Box<[f64]> {
        let (shift, turn) = (self.shift, self.turn);
        if self.is_placed() {
            Box::default()
        } else if self.level {
            Box::new([shift.x, shift.y, self.angle])
        } else {
            Box::new([shift.x, shift.y, shift.z, turn.x, turn.y, turn.z, turn.w])
        }
    }
}

/// Node, at its place, and face of a contact as if they had been placed where the bases of their bodies
/// are; an abutment stands.
pub(crate) fn seen_from(
    site: &ContactSite,
    place: &NodePlace,
    [node, face]: [Option<&ReferencePose>; 2],
) -> ContactGeometry {
    site.geometry_at(place).seen_from(&pose(site, node), &pose(site, face))
}

/// Displacement of the node, at its place, along the face at the reference poses, since placed \[m\].
pub(in crate::dynamics) fn way_to(
    site: &ContactSite,
    place: &NodePlace,
    [node, face]: [Option<&ReferencePose>; 2],
) -> DVec2 {
    locate(&site.geometry_at(place), &pose(site, node), &pose(site, face)).way
}

fn pose(site: &ContactSite, base: Option<&ReferencePose>) -> Frame {
    base.map_or(site.stand, ReferencePose::pose)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::dynamics::model::edge_node::node_place::NodePlace;
    use crate::scene::{Kind, presets};

    fn model(name: &str) -> Model {
        Model::compile(&presets::load(name).expect("a preset")).expect("a scene")
    }

    /// A state of a body that has come a long way and turned.
    fn away(kind: Kind) -> Vec<f64> {
        match kind {
            Kind::Planar => vec![0.43, -0.21, 0.3, 0.01, -0.02, 0.005],
            Kind::Spatial => {
                let q = DQuat::from_scaled_axis(DVec3::new(0.02, -0.05, 0.3));
                vec![0.43, -0.21, 0.01, q.x, q.y, q.z, q.w, 0.01, -0.02, 0.03, 0.005, 0.001, -0.002]
            }
        }
    }

    /// A small motion from there.
    fn further(kind: Kind, state: &mut [f64]) {
        match kind {
            Kind::Planar => state[..3].copy_from_slice(&[1e-7, 2e-7, -3e-8]),
            Kind::Spatial => {
                let q = DQuat::from_scaled_axis(DVec3::new(3e-8, 1e-8, -2e-8));
                state[..7].copy_from_slice(&[1e-7, 2e-7, -1e-7, q.x, q.y, q.z, q.w]);
            }
        }
    }

    #[test]
    fn counted_from_its_base_a_body_is_where_it_is() {
        for name in ["skew45-abutment", "deck-30m"] {
            let model = model(name);
            let (body, whole) = (&model.bodies[0], away(model.kind));
            let mut since = whole.clone();
            let base = body.rebase(&mut since);
            let mut again = since.clone();
            body.restore(&base.numbers(), &mut again);
            let apart = again.iter().zip(&whole).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 4.0 * f64::EPSILON, "{name}: {again:?} against {whole:?}");
            further(model.kind, &mut since);
            let mut whole = since.clone();
            body.restore(&base.numbers(), &mut whole);
            let [one, other] = [base.whole(&body.frame_since(0, &since)), body.frame(0, &whole)];
            assert!((one.shift - other.shift).length() < 1e-15, "{name}: {one:?} against {other:?}");
            assert!((one.turned - other.turned).abs_diff_eq(DMat3::ZERO, 1e-15), "{name}: {one:?} against {other:?}");
            assert_eq!(body.reference(&base.numbers()), base, "{name}: by its numbers");
        }
    }

    #[test]
    fn a_node_seen_from_bases_is_where_it_is_and_moves_by_its_own_last_digit() {
        for name in ["skew45-abutment", "deck-30m"] {
            let model = model(name);
            let (body, site) = (&model.bodies[0], &model.sites[0]);
            let mut since = away(model.kind);
            let base = body.rebase(&mut since);
            let bases = [site.node_body, site.face_body].map(|owner| owner.map(|_| &base));
            let home = seen_from(site, &NodePlace::default(), bases);
            let look = |state: &[f64]| {
                let own = body.frame_since(0, state);
                let whole = base.whole(&own);
                let side = |owner: Option<usize>, own: Frame| owner.map_or(site.stand, |_| own);
                let [near, far] = [own, whole].map(|frame| [side(site.node_body, frame), side(site.face_body, frame)]);
                [locate(&home, &near[0], &near[1]), locate(&site.geometry, &far[0], &far[1])]
            };
            let [start, far_start] = look(&since);
            further(model.kind, &mut since);
            let [end, far_end] = look(&since);
            assert!((end.gap - far_end.gap).abs() < 1e-13, "{name}: {end:?} against {far_end:?}");
            assert!((end.at - far_end.at).length() < 1e-13, "{name}: {end:?} against {far_end:?}");
            assert!((end.gap_rate - far_end.gap_rate).abs() < 1e-15, "{name}: {end:?} against {far_end:?}");
            assert!((end.rate - far_end.rate).length() < 1e-15, "{name}: {end:?} against {far_end:?}");
            let way = way_to(site, &NodePlace::default(), bases);
            assert!((start.way + way - far_start.way).length() < 1e-15, "{name}: ways add up");
            // A thousandth of the last digit of where the body is.
            let least = 1e-3 * f64::EPSILON * 0.43;
            let mut moved = since.clone();
            moved[..2].iter_mut().for_each(|x| *x = 0.0);
            let still = look(&moved)[0].way + DVec2::new(0.0, look(&moved)[0].gap);
            moved[0] = least;
            let step = look(&moved)[0].way + DVec2::new(0.0, look(&moved)[0].gap) - still;
            assert!(step.length() > 0.0, "{name}: it is seen to move, {step:?}");
        }
    }
}
