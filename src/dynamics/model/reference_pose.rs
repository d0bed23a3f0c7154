//! Where a body stood when it was last caught: what its motion in contact is counted from.
//!
//! A contact of a stiff face and a light girder is pressed by less than the last digit of where the girder is. So bodies that
//! touch are integrated as what they moved since the first of their touches, and node and face are measured as if they had
//! been placed there ([`Home::seen_from`]): a gap then rounds with how far it went in contact, not with how far it came.

use glam::{DMat3, DQuat, DVec2, DVec3};

use crate::contact::{Frame, Home, locate, turned_by};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::pair::ContactSite;
use crate::dynamics::model::rigid_body;
use crate::dynamics::model::rigid_body::PLANAR;
use crate::scene::Kind;

/// A place and attitude, and what is counted from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ReferencePose {
    kind: Kind,
    /// Displacement of G since it was placed \[m\].
    shift: DVec3,
    /// Planar: the angle that it had turned \[rad\].
    angle: f64,
    /// Spatial: the same as a quaternion.
    turn: DQuat,
    /// What it had turned, less the identity.
    turned: DMat3,
    /// Number of the flight that ended there, where its end is that to the last bit.
    pub(in crate::dynamics) flown: Option<u32>,
    /// Its number among what is kept to take steps again.
    pub(in crate::dynamics) kept: Option<u32>,
}

impl ReferencePose {
    /// Where the body was placed.
    pub(in crate::dynamics) fn placed(kind: Kind, body: &Body) -> Self {
        // A planar body keeps the height that it started at.
        let shift = if kind == Kind::Planar { DVec3::Z * body.start[2] } else { DVec3::ZERO };
        Self { kind, shift, angle: 0.0, turn: DQuat::IDENTITY, turned: DMat3::ZERO, flown: None, kept: None }
    }

    /// Where a state has the body; what is left of the state is its speeds.
    pub(in crate::dynamics) fn of(kind: Kind, body: &Body, state: &mut [f64]) -> Self {
        match kind {
            Kind::Planar => {
                let base = Self::by(kind, body, &state[..3]);
                state[..3].fill(0.0);
                base
            }
            Kind::Spatial => {
                let turn = rigid_body::turn(state);
                state[3..7].copy_from_slice(&[turn.x, turn.y, turn.z, turn.w]);
                let base = Self::by(kind, body, &state[..7]);
                state[..7].copy_from_slice(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
                base
            }
        }
    }

    /// By its [`numbers`](Self::numbers).
    pub(crate) fn by(kind: Kind, body: &Body, numbers: &[f64]) -> Self {
        let placed = Self::placed(kind, body);
        match *numbers {
            [x, y, angle] => {
                let turned = body.planar_frame(&[x, y, angle, 0.0, 0.0, 0.0]).turned;
                Self { shift: DVec3::new(x, y, placed.shift.z), angle, turned, ..placed }
            }
            [x, y, z, i, j, k, w] => {
                let turn = DQuat::from_xyzw(i, j, k, w);
                Self { shift: DVec3::new(x, y, z), turn, turned: turned_by(turn), ..placed }
            }
            _ => placed,
        }
    }

    /// Whether nothing is counted from elsewhere than where the body was placed.
    fn is_placed(&self) -> bool {
        match self.kind {
            Kind::Planar => self.shift.x == 0.0 && self.shift.y == 0.0 && self.angle == 0.0,
            Kind::Spatial => self.shift == DVec3::ZERO && self.turn == DQuat::IDENTITY,
        }
    }

    /// `x, y, θ` of a planar base.
    pub(in crate::dynamics) fn planar(&self) -> DVec3 {
        DVec3::new(self.shift.x, self.shift.y, self.angle)
    }

    /// The same as a state at rest.
    pub(in crate::dynamics) fn state(&self) -> [f64; PLANAR] {
        [self.shift.x, self.shift.y, self.angle, 0.0, 0.0, 0.0]
    }

    /// A base from the numbers of where it is, which may be where the body was placed.
    pub(in crate::dynamics) fn from_kept(kind: Kind, body: &Body, numbers: &[f64]) -> Self {
        let base = Self::by(kind, body, numbers);
        if base.is_placed() { Self::placed(kind, body) } else { base }
    }

    /// The pose there, at rest; all that is counted from it is independent of where the body was placed.
    pub(in crate::dynamics) fn pose(&self) -> Frame {
        let level = self.kind == Kind::Planar;
        Frame { shift: self.shift, turned: self.turned, level, ..Frame::fixed(DVec3::ZERO) }
    }

    /// Pose and twist by what is counted from here.
    #[inline]
    pub(crate) fn since(&self, body: &Body, state: &[f64]) -> Frame {
        let mut frame = rigid_body::frame(self.kind, body, state);
        if self.kind == Kind::Planar {
            frame.shift.z = 0.0;
        }
        frame
    }

    /// The pose since the body was placed, of one counted from here.
    #[inline]
    pub(crate) fn whole(&self, since: &Frame) -> Frame {
        let shift = self.shift + since.shift;
        let (here, before) = (&since.turned, &self.turned);
        // (1 + d)(1 + D) = 1 + D + d + d D.
        let turned = if *before == DMat3::ZERO { *here } else { *before + (*here + *here * *before) };
        Frame { shift, turned, ..*since }
    }

    /// The state since the body was placed, of one counted from here.
    pub(in crate::dynamics) fn add(&self, state: &mut [f64]) {
        add(&self.numbers(), state);
    }

    /// Place and attitude in the order of a state; nothing where that is where the body was placed.
    pub(in crate::dynamics) fn numbers(&self) -> Box<[f64]> {
        if self.is_placed() {
            return Box::default();
        }
        let (shift, turn) = (self.shift, self.turn);
        match self.kind {
            Kind::Planar => Box::new([shift.x, shift.y, self.angle]),
            Kind::Spatial => Box::new([shift.x, shift.y, shift.z, turn.x, turn.y, turn.z, turn.w]),
        }
    }
}

/// Adds place and attitude of a base, by its numbers, to a state that is counted from it.
pub(in crate::dynamics) fn add(numbers: &[f64], state: &mut [f64]) {
    let turns = numbers.len() > 3;
    state.iter_mut().zip(numbers).take(3).for_each(|(component, base)| *component += base);
    if turns {
        let quaternion = |q: &[f64]| DQuat::from_xyzw(q[3], q[4], q[5], q[6]);
        // Linear in the components: a state between two steps has no length of exactly 1.
        let turn = product(quaternion(state), quaternion(numbers));
        state[3..7].copy_from_slice(&[turn.x, turn.y, turn.z, turn.w]);
    }
}

/// The product of two quaternions, which need not be of length 1.
fn product(a: DQuat, b: DQuat) -> DQuat {
    let (u, v) = (a.xyz(), b.xyz());
    DQuat::from_vec4((u * b.w + v * a.w + u.cross(v)).extend(a.w * b.w - u.dot(v)))
}

/// Node and face of a contact as if they had been placed where the bases of their bodies are; an abutment stands. `at`, if
/// it is known better than by these.
pub(crate) fn seen_from(site: &ContactSite, [node, face]: [Option<&ReferencePose>; 2], at: Option<DVec3>) -> Home {
    let home = site.home.seen_from(&pose(site, node), &pose(site, face));
    at.map_or(home, |at| home.with_node(at))
}

/// How far the node was there from where it was as placed, along the face \[m\].
pub(in crate::dynamics) fn way_to(site: &ContactSite, [node, face]: [Option<&ReferencePose>; 2]) -> DVec2 {
    locate(&site.home, &pose(site, node), &pose(site, face)).way
}

fn pose(site: &ContactSite, base: Option<&ReferencePose>) -> Frame {
    base.map_or(site.stand, ReferencePose::pose)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::scene::presets;

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
            let base = ReferencePose::of(model.kind, body, &mut since);
            let mut again = since.clone();
            base.add(&mut again);
            let apart = again.iter().zip(&whole).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 4.0 * f64::EPSILON, "{name}: {again:?} against {whole:?}");
            further(model.kind, &mut since);
            let mut whole = since.clone();
            base.add(&mut whole);
            let [one, other] = [base.whole(&base.since(body, &since)), rigid_body::frame(model.kind, body, &whole)];
            assert!((one.shift - other.shift).length() < 1e-15, "{name}: {one:?} against {other:?}");
            assert!((one.turned - other.turned).abs_diff_eq(DMat3::ZERO, 1e-15), "{name}: {one:?} against {other:?}");
            assert_eq!(ReferencePose::by(model.kind, body, &base.numbers()), base, "{name}: by its numbers");
        }
    }

    #[test]
    fn a_node_seen_from_bases_is_where_it_is_and_moves_by_its_own_last_digit() {
        for name in ["skew45-abutment", "deck-30m"] {
            let model = model(name);
            let (body, site) = (&model.bodies[0], &model.contacts[0]);
            let mut since = away(model.kind);
            let base = ReferencePose::of(model.kind, body, &mut since);
            let bases = [site.node_body, site.face_body].map(|owner| owner.map(|_| &base));
            let home = seen_from(site, bases, None);
            let look = |state: &[f64]| {
                let own = base.since(body, state);
                let whole = base.whole(&own);
                let side = |owner: Option<usize>, own: Frame| owner.map_or(site.stand, |_| own);
                let [near, far] = [own, whole].map(|frame| [side(site.node_body, frame), side(site.face_body, frame)]);
                [locate(&home, &near[0], &near[1]), locate(&site.home, &far[0], &far[1])]
            };
            let [start, far_start] = look(&since);
            further(model.kind, &mut since);
            let [end, far_end] = look(&since);
            assert!((end.gap - far_end.gap).abs() < 1e-13, "{name}: {end:?} against {far_end:?}");
            assert!((end.at - far_end.at).length() < 1e-13, "{name}: {end:?} against {far_end:?}");
            assert!((end.gap_rate - far_end.gap_rate).abs() < 1e-15, "{name}: {end:?} against {far_end:?}");
            assert!((end.rate - far_end.rate).length() < 1e-15, "{name}: {end:?} against {far_end:?}");
            let way = way_to(site, bases);
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
