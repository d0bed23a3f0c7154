//! Reactions and accelerations in lasting contact for given contact modes: states c–f, (7)–(25).
//!
//! Unknown are the normal reaction `N ≥ 0` of every kept point and the tangential reaction `T` of every contact that sticks;
//! kept points have no normal acceleration, sticking contacts no tangential one either. A slipping contact carries
//! `T = −μ_k N sgn(v_s)`. All bearing forces are included, so for a straight girder at a wall `N/m` is `R_x` of (15), (20),
//! (23), (25), positive in compression (`docs/physics.md#lasting-contact`). Signs and friction cones
//! are checked by [`mode_selection`](super::mode_selection).

use glam::{DVec2, DVec3};

use crate::dynamics::Model;
use crate::dynamics::impact2d::constants::SINGULAR_PIVOT;
use crate::dynamics::impact2d::delassus::{ContactPoint, centre};
use crate::dynamics::impact2d::kinematics::BodyKinematics;
use crate::dynamics::impact2d::{GirderState, InlineVec};
use crate::dynamics::integrator::dense_lu::{is_singular, solve_regularised};
use crate::scene::ImpactSettings;

/// Motion of a lasting contact along the face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrictionMode {
    /// No relative motion.
    Stick,
    /// No relative motion, of contacts that are statically indeterminate and hold by reactions other than those of least norm
    /// ([`indeterminate`](super::indeterminate)).
    Wedged,
    /// Slip along `s` with this sign of `v_s`, ±1.
    Slip(f64),
    /// Slip of a face whose whole pressure is at one of its ends. By the coefficient of the face the girder would turn onto that corner, by
    /// that of the corner it would turn back: friction between the two keeps the face on the other (`docs/impact-model.md#states`).
    SlipAtEnd {
        /// Sign of `v_s`, ±1.
        sign: f64,
        /// Number of the point that carries the pressure, of the two.
        end: usize,
    },
    /// Without friction, where no motion is consistent with it (Painlevé).
    Frictionless,
}

impl FrictionMode {
    /// Whether there is no relative motion along the face.
    pub fn sticks(self) -> bool {
        matches!(self, Self::Stick | Self::Wedged)
    }

    /// Whether it is selected anew once another mode agrees with Coulomb's law.
    pub fn is_for_want_of_another(self) -> bool {
        matches!(self, Self::Wedged | Self::Frictionless)
    }

    /// Sign of the slip, 0 without friction; none of a contact that sticks.
    pub fn slip_sign(self) -> Option<f64> {
        match self {
            Self::Stick | Self::Wedged => None,
            Self::Slip(sign) | Self::SlipAtEnd { sign, .. } => Some(sign),
            Self::Frictionless => Some(0.0),
        }
    }
}

/// A pair in lasting contact, at a corner or along a face, and its motion along the face.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactMode {
    /// The pair, its number in the model.
    pub pair: usize,
    /// The declared contacts that are kept: one at a corner, the two outermost of a face, the lesser along `s` first.
    pub sites: Vec<usize>,
    /// Motion along the face.
    pub friction: FrictionMode,
}

impl ContactMode {
    /// Whether a whole face lies on the other.
    pub fn is_flush(&self) -> bool {
        self.sites.len() > 1
    }

    /// The state c–f of a girder in this contact.
    pub fn state(&self) -> GirderState {
        match (self.is_flush(), self.friction.sticks()) {
            (true, true) => GirderState::Resting,
            (true, false) => GirderState::Sliding,
            (false, true) => GirderState::Turning,
            (false, false) => GirderState::SlidingTurning,
        }
    }

    /// `[μ_s, μ_k]` of the face or, at one point, of a corner.
    pub fn friction_coefficients(&self, settings: &ImpactSettings) -> [f64; 2] {
        if self.is_flush() { [settings.mu_static, settings.mu_kinetic] } else { settings.corner_friction() }
    }

    /// Least and largest coefficient of kinetic friction of a face whose pressure is at one end: between those of the face and of a corner.
    pub fn friction_at_end(&self, settings: &ImpactSettings) -> [f64; 2] {
        let ([_, face], [_, corner]) = (self.friction_coefficients(settings), settings.corner_friction());
        [corner.min(face), corner.max(face)]
    }

    /// The kept points.
    pub fn points(&self, model: &Model, kinematics: &BodyKinematics) -> Vec<ContactPoint> {
        self.sites.iter().map(|&site| kinematics.point(model, site)).collect()
    }
}

/// Reactions of one contact \[N\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reaction {
    /// `N` at each point, on the first side along `n`.
    pub normal: [f64; 2],
    /// `T`, on the first side along `s`.
    pub tangential: f64,
}

impl Reaction {
    /// `N` of all points \[N\].
    pub fn total(&self) -> f64 {
        self.normal[0] + self.normal[1]
    }
}

/// Reactions of all contacts, and the accelerations with them.
#[derive(Clone, Debug)]
pub struct ConstrainedMotion {
    /// One for each contact mode.
    pub reactions: Vec<Reaction>,
    /// `(ẍ, ÿ, θ̈)` of each body \[m/s²\], \[rad/s²\].
    pub accelerations: InlineVec<DVec3>,
}

impl ConstrainedMotion {
    /// Relative acceleration along a direction at a point, `bias` being its part from velocities alone \[m/s²\].
    pub fn along(&self, point: &ContactPoint, direction: DVec2, bias: f64) -> f64 {
        let part = |(body, row): (Option<usize>, DVec3)| body.map_or(0.0, |b| row.dot(self.accelerations[b]));
        point.row(direction).into_iter().map(part).sum::<f64>() + bias
    }
}

/// An unknown reaction: the force per unit of it, and the acceleration that it brings to 0.
struct Unknown {
    mode: usize,
    /// Number of the contact's point for a normal reaction; `None` for the tangential one of stick.
    at: Option<usize>,
    point: ContactPoint,
    direction: DVec2,
    bias: f64,
    /// Force per unit.
    force: DVec2,
}

/// Whether reactions of these contacts balance each other, so that those of a motion are not unique.
pub(in crate::dynamics::impact2d) fn are_indeterminate(
    kinematics: &BodyKinematics,
    modes: &[ContactMode],
    points: &[Vec<ContactPoint>],
    settings: &ImpactSettings,
) -> bool {
    let unknowns = unknowns(modes, points, settings);
    is_singular(unknowns.len(), |r, c| mobility(kinematics, [&unknowns[r], &unknowns[c]]), SINGULAR_PIVOT)
}

/// Acceleration at one unknown per unit of another \[1/kg\].
fn mobility(kinematics: &BodyKinematics, [row, column]: [&Unknown; 2]) -> f64 {
    kinematics.cluster.mobility(&row.point, row.direction, &column.point, column.force)
}

/// Reactions of least norm, and the accelerations with them; none where a number is not finite.
pub(in crate::dynamics::impact2d) fn least_reactions(
    kinematics: &BodyKinematics,
    modes: &[ContactMode],
    points: &[Vec<ContactPoint>],
    settings: &ImpactSettings,
) -> Option<ConstrainedMotion> {
    let unknowns = unknowns(modes, points, settings);
    let mut accelerations = kinematics.free.clone();
    let without = ConstrainedMotion { reactions: Vec::new(), accelerations: kinematics.free.clone() };
    let entry = |r: usize, c: usize| mobility(kinematics, [&unknowns[r], &unknowns[c]]);
    let right = |r: usize| -without.along(&unknowns[r].point, unknowns[r].direction, unknowns[r].bias);
    let solution = solve_regularised(unknowns.len(), entry, right, SINGULAR_PIVOT)?;
    let mut reactions = vec![Reaction::default(); modes.len()];
    for (unknown, &size) in unknowns.iter().zip(&solution) {
        for (body, row) in unknown.point.row(unknown.force * size) {
            if let Some(b) = body {
                accelerations[b] += kinematics.cluster.inverse[b] * row;
            }
        }
        let reaction = &mut reactions[unknown.mode];
        match unknown.at {
            Some(i) => {
                reaction.normal[i] = size;
                reaction.tangential += size * unknown.force.dot(unknown.point.s);
            }
            None => reaction.tangential += size,
        }
    }
    Some(ConstrainedMotion { reactions, accelerations })
}

fn unknowns(modes: &[ContactMode], points: &[Vec<ContactPoint>], settings: &ImpactSettings) -> Vec<Unknown> {
    let mut all = Vec::new();
    for (number, (mode, points)) in modes.iter().zip(points).enumerate() {
        if let (FrictionMode::SlipAtEnd { end, .. }, [first, second]) = (mode.friction, &points[..]) {
            let (pressed, other) = if end == 0 { (first, second) } else { (second, first) };
            let normal = |at: Option<usize>, point: &ContactPoint, force: DVec2| {
                let (direction, bias) = (point.n, point.bias[0]);
                Unknown { mode: number, at, point: *point, direction, bias, force }
            };
            // Both points lie on one line along the face: friction has the same moment at either.
            all.extend([normal(Some(end), pressed, pressed.n), normal(None, other, other.s)]);
            continue;
        }
        let friction = match mode.friction.slip_sign() {
            None => 0.0,
            Some(sign) => -mode.friction_coefficients(settings)[1] * sign,
        };
        for (i, point) in points.iter().enumerate() {
            all.push(Unknown {
                mode: number,
                at: Some(i),
                point: *point,
                direction: point.n,
                bias: point.bias[0],
                force: point.n + point.s * friction,
            });
        }
        if mode.friction.sticks() {
            let centre = centre(points);
            all.push(Unknown {
                mode: number,
                at: None,
                point: centre,
                direction: centre.s,
                bias: centre.bias[1],
                force: centre.s,
            });
        }
    }
    all
}

/// Bodies joined by contact modes, by their places, each group with its modes, in order of the first place.
pub(in crate::dynamics::impact2d) fn connected_groups(
    model: &Model,
    kinematics: &BodyKinematics,
    modes: Vec<ContactMode>,
) -> Vec<(Vec<usize>, Vec<ContactMode>)> {
    let mut groups: Vec<(Vec<usize>, Vec<ContactMode>)> = Vec::new();
    for mode in modes {
        let places: Vec<usize> = kinematics.places(model, mode.pair).into_iter().flatten().collect();
        let (joined, others): (Vec<_>, Vec<_>) =
            groups.into_iter().partition(|(members, _)| places.iter().any(|place| members.contains(place)));
        let mut members = places;
        let mut all = Vec::new();
        for (places, modes) in joined {
            members.extend(places);
            all.extend(modes);
        }
        all.push(mode);
        members.sort_unstable();
        members.dedup();
        groups = others;
        groups.push((members, all));
    }
    groups.sort_by_key(|(members, _)| members.first().copied());
    groups
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::impact2d::example::{self, touching};
    use crate::dynamics::model::coordinates::planar::WIDTH;

    /// A girder of 2 kg, 0.19 × 0.07 m, at a wall at +x under this push \[N\] and acceleration of the ground, at rest.
    fn at_wall(force: [f64; 2]) -> (Model, BodyKinematics) {
        let model = example::block(&format!("push = {{ force_n = {force:?} }}"), 0.0);
        let kinematics = BodyKinematics::new(&model, &[0], &[[0.0; WIDTH]], DVec3::new(0.0, 0.5, 0.0));
        (model, kinematics)
    }

    fn solved(force: [f64; 2], ends: usize, friction: FrictionMode) -> (ConstrainedMotion, ContactPoint) {
        let (model, kinematics) = at_wall(force);
        let sites = touching(&model, &kinematics)[..ends].to_vec();
        let mode = ContactMode { pair: 0, sites, friction };
        let points = vec![mode.points(&model, &kinematics)];
        let settings = ImpactSettings { mu_static: 0.2, mu_kinetic: 0.15, ..ImpactSettings::default() };
        let motion = least_reactions(&kinematics, &[mode], &points, &settings).expect("a solution");
        (motion, centre(&points[0]))
    }

    #[test]
    fn a_resting_face_carries_the_push_and_the_ground() {
        // (25): R_x = F_x/m, R_y from F_y/m − a_g; the moment of T about G shifts N by T a/(2b).
        let (motion, _) = solved([10.0, 3.0], 2, FrictionMode::Stick);
        let reaction = motion.reactions[0];
        assert!((reaction.total() - 10.0).abs() < 1e-12, "{reaction:?}");
        // s = −y: T = F_y − m a_g = 3 − 1.
        assert!((reaction.tangential - 2.0).abs() < 1e-12, "{reaction:?}");
        let difference = (reaction.normal[0] - reaction.normal[1]).abs();
        assert!((difference - 2.0 * 0.095 / 0.035).abs() < 1e-11, "moment equilibrium: {reaction:?}");
        assert!(motion.accelerations[0].length() < 1e-12, "at rest");
    }

    #[test]
    fn a_slipping_face_has_kinetic_friction_against_the_slip() {
        // (20): N = F_x, ÿ = (F_y + T)/m − a_g with |T| = μ_k N.
        let (motion, point) = solved([10.0, 3.0], 2, FrictionMode::Slip(1.0));
        let reaction = motion.reactions[0];
        assert!((reaction.total() - 10.0).abs() < 1e-12 && (reaction.tangential + 1.5).abs() < 1e-12, "{reaction:?}");
        let expected = 3.0 / 2.0 - 0.5 - 1.5 * point.s.y / 2.0;
        assert!((motion.accelerations[0].y - expected).abs() < 1e-12, "{:?}", motion.accelerations);
    }

    #[test]
    fn a_turning_girder_keeps_its_corner() {
        let (motion, point) = solved([10.0, 3.0], 1, FrictionMode::Stick);
        assert!(motion.along(&point, point.n, point.bias[0]).abs() < 1e-12, "no normal acceleration");
        assert!(motion.along(&point, point.s, point.bias[1]).abs() < 1e-12, "no tangential one");
        assert!(motion.accelerations[0].z.abs() > 1.0, "it turns about the corner");
    }

    #[test]
    fn a_face_pressed_at_one_end_carries_the_friction_that_keeps_it_from_turning() {
        // T a = N b about G: of a push of 10 N along x.
        let (motion, point) = solved([10.0, 5.0], 2, FrictionMode::SlipAtEnd { sign: 1.0, end: 0 });
        let reaction = motion.reactions[0];
        assert!((reaction.total() - 10.0).abs() < 1e-12 && reaction.normal[1] == 0.0, "{reaction:?}");
        assert!((reaction.tangential.abs() - 10.0 * 0.035 / 0.095).abs() < 1e-11, "{reaction:?}");
        assert!(motion.accelerations[0].z.abs() < 1e-11, "it does not turn: {:?}", motion.accelerations);
        let expected = 5.0 / 2.0 - 0.5 + reaction.tangential * point.s.y / 2.0;
        assert!((motion.accelerations[0].y - expected).abs() < 1e-12, "{:?}", motion.accelerations);
    }

    #[test]
    fn without_friction_there_is_no_tangential_reaction() {
        let (motion, _) = solved([10.0, 3.0], 2, FrictionMode::Frictionless);
        assert_eq!(motion.reactions[0].tangential, 0.0, "normal reactions only");
    }

    #[test]
    fn states_follow_from_points_and_friction() {
        let state = |count: usize, friction| ContactMode { pair: 0, sites: vec![0; count], friction }.state();
        assert_eq!(state(2, FrictionMode::Stick), GirderState::Resting, "f");
        assert_eq!(state(2, FrictionMode::Slip(1.0)), GirderState::Sliding, "e");
        assert_eq!(state(1, FrictionMode::Stick), GirderState::Turning, "d");
        assert_eq!(state(1, FrictionMode::Frictionless), GirderState::SlidingTurning, "c");
    }
}
