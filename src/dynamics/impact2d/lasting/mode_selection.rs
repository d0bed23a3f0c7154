//! Contact modes after the impulses of an instant: which points stay in contact, and whether they stick or slip.
//!
//! A point opens where its normal acceleration without any reaction is ≥ 0. Otherwise it sticks if `N ≥ 0` and `|T| ≤ μ_s N`,
//! else it slips in the direction whose own solution agrees. A face is kept while both of its ends are under pressure, which
//! is `|η| ≤ b_f`. Where stick and slip are both consistent (high μ, before the Painlevé bound), stick is taken
//! (`docs/physics.md#change-of-state`). A linear complementarity problem, solved by enumeration; with
//! many pairs by relaxation, pair after pair, and by enumeration where that finds none.

use crate::dynamics::Model;
use crate::dynamics::impact2d::constants::{
    IMPACT_FORCE_ROUNDING, MODE_COMBINATIONS, MODE_COMBINATIONS_LEFT, MODE_SWEEPS,
};
use crate::dynamics::impact2d::delassus::{ContactPoint, centre};
use crate::dynamics::impact2d::kinematics::BodyKinematics;
use crate::dynamics::impact2d::lasting::constrained_motion::{
    ConstrainedMotion, ContactMode, FrictionMode, are_indeterminate, least_reactions,
};
use crate::dynamics::impact2d::lasting::indeterminate::reactions_in_cones;
use crate::scene::ImpactSettings;

/// A pair that may stay in contact.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// The pair, its number in the model.
    pub pair: usize,
    /// Declared contacts with no gap and no speed along the normal: one or two.
    pub sites: Vec<usize>,
    /// Points of contact.
    pub points: Vec<ContactPoint>,
    /// Sign of `v_s`; 0 at rest along the face.
    pub slip: f64,
    /// Whether only stick and opening are tried, for a slip below the stop speed that has no consistent mode.
    pub stick_or_open: bool,
    /// Modes that the event of this instant has ended.
    pub excluded: Excluded,
}

/// Modes that an event has ended.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Excluded {
    /// Stick.
    pub stick: bool,
    /// Contact at this declared contact, by its number in the model, whose reaction has fallen to 0.
    pub site: Option<usize>,
}

impl Candidate {
    /// Signs of a slip that may begin or goes on.
    pub(super) fn slips(&self) -> &'static [f64] {
        match self.slip {
            _ if self.stick_or_open => &[],
            v if v > 0.0 => &[1.0],
            v if v < 0.0 => &[-1.0],
            _ => &[1.0, -1.0],
        }
    }

    /// Modes of the pair in the order in which they are tried, `still` being that of no relative motion; none is opening.
    fn options(&self, settings: &ImpactSettings, still: FrictionMode) -> Vec<Option<ContactMode>> {
        let mut all = vec![None];
        let faces = (self.sites.len() > 1).then(|| self.sites.clone());
        let kept = |sites: &Vec<usize>| self.excluded.site.is_none_or(|out| !sites.contains(&out));
        for sites in faces.into_iter().chain(self.sites.iter().map(|&site| vec![site])).filter(kept) {
            let sticks = self.stick_or_open || (self.slip == 0.0 && !self.excluded.stick);
            let slips = self.slips().iter().map(|&sign| FrictionMode::Slip(sign));
            let frictions = sticks.then_some(still).into_iter().chain(slips);
            all.extend(frictions.map(|friction| Some(ContactMode { pair: self.pair, sites: sites.clone(), friction })));
        }
        all.extend(self.slips_at_an_end(settings).map(Some));
        all
    }

    /// Slips of the face with its pressure at one end, where a corner has another friction than the face: what is left where the face would
    /// turn onto the corner and the corner back onto the face. The reaction of the other end is 0, whether an event has just said so or not.
    fn slips_at_an_end(&self, settings: &ImpactSettings) -> impl Iterator<Item = ContactMode> + '_ {
        let differs = self.sites.len() == 2 && settings.corner_friction()[1] != settings.mu_kinetic;
        let of = |&sign: &f64| [0, 1].map(|end| FrictionMode::SlipAtEnd { sign, end });
        let all = if differs { self.slips() } else { &[] };
        all.iter().flat_map(of).map(|friction| ContactMode { pair: self.pair, sites: self.sites.clone(), friction })
    }
}

/// Modes of all candidates together; none where no combination is consistent (Painlevé).
pub fn select_modes(model: &Model, kinematics: &BodyKinematics, candidates: &[Candidate]) -> Option<Vec<ContactMode>> {
    select(&Consistency { model, kinematics, candidates, impulses: false }, FrictionMode::Stick)
}

/// Modes of all candidates together of which those at rest are wedged: statically indeterminate, with some reactions within the friction
/// cones; none where no combination is.
pub(in crate::dynamics::impact2d) fn select_wedged(
    model: &Model,
    kinematics: &BodyKinematics,
    candidates: &[Candidate],
) -> Option<Vec<ContactMode>> {
    // What has ended is a reaction of least norm.
    let anew = |candidate: &Candidate| Candidate { excluded: Excluded::default(), ..candidate.clone() };
    let candidates: Vec<Candidate> = candidates.iter().map(anew).collect();
    let consistency = Consistency { model, kinematics, candidates: &candidates, impulses: false };
    select(&consistency, FrictionMode::Wedged)
}

/// Modes of all candidates together, with this mode of no relative motion.
fn select(consistency: &Consistency<'_>, still: FrictionMode) -> Option<Vec<ContactMode>> {
    let options: Vec<Vec<Option<ContactMode>>> =
        consistency.candidates.iter().map(|c| c.options(&consistency.model.impact, still)).collect();
    let combinations = options.iter().map(Vec::len).try_fold(1usize, usize::checked_mul);
    let enumerate = |most: usize| {
        (0..combinations.filter(|combinations| *combinations <= most)?).find_map(|number| {
            let choice = combination(number, &options);
            consistency.is_consistent(&choice, None).then_some(choice)
        })
    };
    let choice = match combinations {
        Some(combinations) if combinations <= MODE_COMBINATIONS => enumerate(MODE_COMBINATIONS),
        _ => relax(consistency, &options).or_else(|| enumerate(MODE_COMBINATIONS_LEFT)),
    };
    choice.map(|choice| choice.into_iter().flatten().collect())
}

/// The combination of this number, the options of the first candidate changing fastest.
pub(super) fn combination(mut number: usize, options: &[Vec<Option<ContactMode>>]) -> Vec<Option<ContactMode>> {
    let digit = |of: &Vec<Option<ContactMode>>| {
        let option = of[number % of.len()].clone();
        number /= of.len();
        option
    };
    options.iter().map(digit).collect()
}

/// Each candidate takes its first option consistent with the modes of the others, until none changes.
fn relax(consistency: &Consistency<'_>, options: &[Vec<Option<ContactMode>>]) -> Option<Vec<Option<ContactMode>>> {
    let mut choice: Vec<Option<ContactMode>> = options.iter().map(|of| of.last().cloned().flatten()).collect();
    for _ in 0..MODE_SWEEPS {
        let before = choice.clone();
        for (i, of) in options.iter().enumerate() {
            for option in of {
                choice[i].clone_from(option);
                if consistency.is_consistent(&choice, Some(i)) {
                    break;
                }
            }
        }
        if choice == before {
            return consistency.is_consistent(&choice, None).then_some(choice);
        }
    }
    None
}

/// Inputs of the consistency check of a combination of modes.
pub(super) struct Consistency<'a> {
    pub model: &'a Model,
    pub kinematics: &'a BodyKinematics,
    pub candidates: &'a [Candidate],
    /// Whether reactions are impulses and accelerations velocities: a slip may not have turned then.
    pub impulses: bool,
}

impl Consistency<'_> {
    /// Whether a combination violates no condition of one candidate, or of any.
    pub(super) fn is_consistent(&self, choice: &[Option<ContactMode>], only: Option<usize>) -> bool {
        let modes: Vec<ContactMode> = choice.iter().flatten().cloned().collect();
        let points: Vec<Vec<ContactPoint>> =
            modes.iter().map(|mode| mode.points(self.model, self.kinematics)).collect();
        let Some(motion) = self.motion(&modes, &points) else { return false };
        let scale = self.scale();
        let mut before = 0;
        for (i, (option, candidate)) in choice.iter().zip(self.candidates).enumerate() {
            let number = before;
            before += usize::from(option.is_some());
            if only.is_some_and(|one| one != i) {
                continue;
            }
            let kept = option.as_ref().map_or(&[][..], |mode| &mode.sites[..]);
            let opens = |(site, point): (&usize, &ContactPoint)| {
                kept.contains(site) || motion.along(point, point.n, point.bias[0]) >= -IMPACT_FORCE_ROUNDING * scale
            };
            if !candidate.sites.iter().zip(&candidate.points).all(opens) {
                return false;
            }
            if let Some(mode) = option
                && !self.satisfies_friction(mode, &points[number], &motion, number, candidate)
            {
                return false;
            }
        }
        true
    }

    /// Motion with these modes; none where wedged contacts are not indeterminate, or have no reactions within the friction cones.
    pub(super) fn motion(&self, modes: &[ContactMode], points: &[Vec<ContactPoint>]) -> Option<ConstrainedMotion> {
        let motion = least_reactions(self.kinematics, modes, points, &self.model.impact)?;
        if modes.iter().all(|mode| mode.friction != FrictionMode::Wedged) {
            return Some(motion);
        }
        let indeterminate = are_indeterminate(self.kinematics, modes, points, &self.model.impact);
        let reactions = || reactions_in_cones(self.kinematics, modes, points, &self.model.impact, &motion);
        let reactions = indeterminate.then(reactions).flatten()?;
        Some(ConstrainedMotion { reactions, ..motion })
    }

    /// Whether reactions are compressive and the friction agrees with the motion along the face.
    fn satisfies_friction(
        &self,
        mode: &ContactMode,
        points: &[ContactPoint],
        motion: &ConstrainedMotion,
        number: usize,
        candidate: &Candidate,
    ) -> bool {
        let reaction = &motion.reactions[number];
        let [mu_s, mu_k] = mode.friction_coefficients(&self.model.impact);
        let centre = centre(points);
        let [w_n, _, w_ns] = self.kinematics.cluster.mobilities(&centre);
        let force = self.kinematics.force_round_off(&centre);
        let n = mode.sites.len();
        if reaction.normal[..n].iter().any(|push| *push < -force) {
            return false;
        }
        match mode.friction {
            FrictionMode::Stick => reaction.tangential.abs() <= mu_s * reaction.total() + force,
            // Past the Painlevé bound a normal reaction would make the point approach.
            FrictionMode::Slip(sign) if w_n - mu_k * sign * w_ns <= 0.0 => false,
            FrictionMode::Frictionless | FrictionMode::Wedged => true,
            FrictionMode::SlipAtEnd { sign, .. } => {
                let [least, most] = mode.friction_at_end(&self.model.impact);
                let (friction, pressure) = (-sign * reaction.tangential, reaction.total());
                let within = friction >= least * pressure - force && friction <= most * pressure + force;
                within && (candidate.slip != 0.0 || self.begins_along(sign, motion, &centre))
            }
            FrictionMode::Slip(sign) => {
                (candidate.slip != 0.0 && !self.impulses) || self.begins_along(sign, motion, &centre)
            }
        }
    }

    /// Whether a slip with this sign agrees with the acceleration along the face. Without one, contacts that are statically indeterminate do
    /// not slip: they are wedged.
    fn begins_along(&self, sign: f64, motion: &ConstrainedMotion, centre: &ContactPoint) -> bool {
        let (along, zero) =
            (sign * motion.along(centre, centre.s, centre.bias[1]), IMPACT_FORCE_ROUNDING * self.scale());
        along > zero || (along >= -zero && (self.impulses || !self.all_at_rest_are_indeterminate()))
    }

    /// Whether the reactions of all candidates, none of them slipping, are not unique.
    fn all_at_rest_are_indeterminate(&self) -> bool {
        let mode = |c: &Candidate| ContactMode { pair: c.pair, sites: c.sites.clone(), friction: FrictionMode::Stick };
        let modes: Vec<ContactMode> = self.candidates.iter().map(mode).collect();
        let points: Vec<_> = modes.iter().map(|mode| mode.points(self.model, self.kinematics)).collect();
        are_indeterminate(self.kinematics, &modes, &points, &self.model.impact)
    }

    /// Largest acceleration in play \[m/s²\].
    fn scale(&self) -> f64 {
        self.kinematics.scale()
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::dynamics::impact2d::example::{self, BLOCK_HALF};
    use crate::dynamics::model::coordinates::planar::WIDTH;

    /// A block of 2 kg flush at a wall at +x under this push \[N\], and its candidate.
    fn block(force: [f64; 2], slip: f64) -> (Model, BodyKinematics, Candidate) {
        let model = example::block(&format!("push = {{ force_n = {force:?} }}"), 0.0);
        let kinematics = BodyKinematics::new(&model, &[0], &[[0.0; WIDTH]], DVec3::ZERO);
        let sites = example::touching(&model, &kinematics);
        let points = sites.iter().map(|&site| kinematics.point(&model, site)).collect();
        let excluded = Excluded::default();
        let candidate = Candidate { pair: 0, sites, points, slip, stick_or_open: false, excluded };
        (model, kinematics, candidate)
    }

    /// The mode of the block; its declared contacts are those at the wall.
    fn mode(force: [f64; 2], slip: f64, mu: f64, change: impl FnOnce(&mut Candidate)) -> Option<ContactMode> {
        let (mut model, kinematics, mut candidate) = block(force, slip);
        change(&mut candidate);
        model.impact = ImpactSettings { mu_static: mu, mu_kinetic: 0.75 * mu, ..ImpactSettings::default() };
        select_modes(&model, &kinematics, &[candidate]).expect("a consistent mode").pop()
    }

    #[test]
    fn a_block_under_tension_opens() {
        assert_eq!(mode([-1.0, 0.0], 0.0, 0.2, |_| ()), None, "nothing holds it");
    }

    #[test]
    fn a_block_sticks_inside_the_cone_and_slips_outside() {
        let inside = mode([10.0, 1.99], 0.0, 0.2, |_| ()).expect("in contact");
        assert!(inside.is_flush() && inside.friction == FrictionMode::Stick, "{inside:?}");
        let outside = mode([10.0, 2.01], 0.0, 0.2, |_| ()).expect("in contact");
        // s = −y and the push is along +y.
        assert!(outside.is_flush() && outside.friction == FrictionMode::Slip(-1.0), "{outside:?}");
    }

    #[test]
    fn the_direction_of_a_slip_is_kept_whatever_the_push() {
        let slipping = mode([10.0, 1.0], 1.0, 0.2, |_| ()).expect("in contact");
        assert_eq!(slipping.friction, FrictionMode::Slip(1.0), "it goes on");
        let slow = mode([10.0, 1.0], 1.0, 0.2, |candidate| candidate.stick_or_open = true).expect("in contact");
        assert_eq!(slow.friction, FrictionMode::Stick, "below the stop speed");
    }

    #[test]
    fn a_face_turns_onto_one_corner_where_the_reaction_leaves_it() {
        // |T| a > N b: a push of 10 N along x carries 10 b/a = 3.68 N along y.
        let limit = 10.0 * BLOCK_HALF[1] / BLOCK_HALF[0];
        let flush = mode([10.0, 0.99 * limit], 0.0, 2.0, |_| ()).expect("in contact");
        assert!(flush.is_flush(), "{flush:?}");
        let corner = mode([10.0, 1.01 * limit], 0.0, 2.0, |_| ()).expect("in contact");
        assert!(!corner.is_flush() && corner.friction == FrictionMode::Stick, "{corner:?}");
    }

    #[test]
    fn a_face_that_neither_turns_onto_its_corner_nor_slips_flush_slides_with_its_pressure_at_the_corner() {
        // b/a = 0.368 lies between the coefficients of corner and face.
        let (mut model, kinematics, candidate) = block([10.0, 3.69], 0.0);
        let of = |corner: f64| ImpactSettings {
            mu_static: 0.4,
            mu_kinetic: 0.38,
            corner_mu_static: Some(corner + 0.01),
            corner_mu_kinetic: Some(corner),
            ..ImpactSettings::default()
        };
        let mut mode = |settings: ImpactSettings| {
            model.impact = settings;
            select_modes(&model, &kinematics, std::slice::from_ref(&candidate)).and_then(|mut modes| modes.pop())
        };
        let at_end = mode(of(0.35)).expect("a consistent mode");
        assert!(
            at_end.is_flush() && matches!(at_end.friction, FrictionMode::SlipAtEnd { sign: -1.0, .. }),
            "{at_end:?}"
        );
        let turning = mode(of(0.38)).expect("a consistent mode");
        assert!(!turning.is_flush(), "with the friction of the face at the corner it turns: {turning:?}");
    }

    #[test]
    fn what_an_event_has_ended_is_not_selected_again() {
        let broke = mode([10.0, 2.0], 0.0, 0.2, |candidate| candidate.excluded.stick = true).expect("in contact");
        assert_eq!(broke.friction, FrictionMode::Slip(-1.0), "stick has ended");
    }

    #[test]
    fn relaxation_finds_the_mode_of_enumeration() {
        for force in [[10.0, 1.0], [10.0, 3.0], [-1.0, 0.0]] {
            let (mut model, kinematics, candidate) = block(force, 0.0);
            model.impact = ImpactSettings { mu_static: 0.2, mu_kinetic: 0.15, ..ImpactSettings::default() };
            let candidates = [candidate];
            let consistency =
                Consistency { model: &model, kinematics: &kinematics, candidates: &candidates, impulses: false };
            let options: Vec<_> = candidates.iter().map(|c| c.options(&model.impact, FrictionMode::Stick)).collect();
            let relaxed = relax(&consistency, &options).expect("a consistent mode");
            let enumerated = select_modes(&model, &kinematics, &candidates).expect("a consistent mode");
            assert_eq!(relaxed.into_iter().flatten().collect::<Vec<_>>(), enumerated, "push {force:?} N");
        }
    }
}
