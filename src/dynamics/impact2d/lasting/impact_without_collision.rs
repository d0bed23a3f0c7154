//! Impact without collision: impulses between bodies none of whose contacts approaches.
//!
//! Where no accelerations agree with the friction of contacts that slip (Painlevé), elastic bodies are pressed into each other by the
//! friction itself, until a slip stops: in the rigid limit, impulses at one instant. They obey the conditions of a plastic impact with
//! friction: a contact opens without an impulse, or keeps its normal velocity 0 by `P_n ≥ 0` and either stops, `|P_t| ≤ μ_s P_n`, or slips on in
//! its direction, `P_t = −μ_k σ P_n`. They are those of lasting contact with velocities for accelerations, besides that a slip must stop, and are
//! solved by the same enumeration; of several solutions that one is taken in which the fewest slips stop.

use glam::DVec3;

use crate::dynamics::Model;
use crate::dynamics::impact2d::InlineVec;
use crate::dynamics::impact2d::constants::{IMPACT_FORCE_ROUNDING, MODE_COMBINATIONS};
use crate::dynamics::impact2d::delassus::Cluster;
use crate::dynamics::impact2d::kinematics::BodyKinematics;
use crate::dynamics::impact2d::lasting::constrained_motion::{ContactMode, FrictionMode};
use crate::dynamics::impact2d::lasting::mode_selection::{Candidate, Consistency, Excluded, combination};

/// Velocities after impulses at one instant.
#[derive(Clone, Debug)]
pub(in crate::dynamics::impact2d) struct Stopped {
    /// `(v_x, v_y, ω)` of each body after them.
    pub velocities: InlineVec<DVec3>,
    /// Pairs whose slip they have stopped.
    pub pairs: Vec<usize>,
}

/// Velocities after impulses within Coulomb's law that stop a slip; none where there are no such, or too many combinations.
pub(in crate::dynamics::impact2d) fn stop_within_friction(
    model: &Model,
    kinematics: &BodyKinematics,
    candidates: &[Candidate],
) -> Option<Stopped> {
    let kinematics = in_velocities(model, kinematics);
    let of = |candidate: &Candidate| Candidate {
        points: candidate.sites.iter().map(|&site| kinematics.point(model, site)).collect(),
        stick_or_open: false,
        excluded: Excluded::default(),
        ..candidate.clone()
    };
    let candidates: Vec<Candidate> = candidates.iter().map(of).collect();
    let options: Vec<Vec<Option<ContactMode>>> = candidates.iter().map(options).collect();
    let combinations = options.iter().map(Vec::len).try_fold(1usize, usize::checked_mul)?;
    if combinations > MODE_COMBINATIONS {
        return None;
    }
    let consistency = Consistency { model, kinematics: &kinematics, candidates: &candidates, impulses: true };
    let stops = |choice: &[Option<ContactMode>]| -> Vec<usize> {
        let stops = |(mode, candidate): (&Option<ContactMode>, &Candidate)| {
            let sticks = mode.as_ref().is_some_and(|mode| mode.friction == FrictionMode::Stick);
            (sticks && candidate.slip != 0.0).then_some(candidate.pair)
        };
        choice.iter().zip(&candidates).filter_map(stops).collect()
    };
    let slipping = candidates.iter().filter(|candidate| candidate.slip != 0.0).count();
    let energy = |velocities: &InlineVec<DVec3>| {
        Cluster { velocity: velocities.clone(), ..kinematics.cluster.clone() }.kinetic_energy()
    };
    let most = energy(&kinematics.free) * (1.0 + IMPACT_FORCE_ROUNDING);
    (1..=slipping).find_map(|count| {
        (0..combinations).find_map(|number| {
            let choice = combination(number, &options);
            let pairs = stops(&choice);
            if pairs.len() != count || !consistency.is_consistent(&choice, None) {
                return None;
            }
            let modes: Vec<ContactMode> = choice.into_iter().flatten().collect();
            let points: Vec<_> = modes.iter().map(|mode| mode.points(model, &kinematics)).collect();
            let velocities = consistency.motion(&modes, &points)?.accelerations;
            (energy(&velocities) <= most).then_some(Stopped { velocities, pairs })
        })
    })
}

/// The bodies with velocities in place of free accelerations, and without the part by which directions turn.
fn in_velocities(model: &Model, kinematics: &BodyKinematics) -> BodyKinematics {
    let mut still = kinematics.clone();
    for frame in &mut still.frames {
        (frame.velocity, frame.spin) = (DVec3::ZERO, DVec3::ZERO);
    }
    let at_corner = |(v, &body): (&DVec3, &usize)| v.truncate().length() + v.z.abs() * model.bodies[body].radius;
    still.sizes = kinematics.cluster.velocity.iter().zip(&kinematics.bodies).map(at_corner).collect();
    still.free.clone_from(&kinematics.cluster.velocity);
    still
}

/// Opening, and of each set of points stick and slip.
fn options(candidate: &Candidate) -> Vec<Option<ContactMode>> {
    let faces = (candidate.sites.len() > 1).then(|| candidate.sites.clone());
    let sets = faces.into_iter().chain(candidate.sites.iter().map(|&site| vec![site]));
    let modes = sets.flat_map(|sites| {
        let slips = candidate.slips().iter().map(|&sign| FrictionMode::Slip(sign));
        let of = |friction| Some(ContactMode { pair: candidate.pair, sites: sites.clone(), friction });
        std::iter::once(FrictionMode::Stick).chain(slips).map(of).collect::<Vec<_>>()
    });
    std::iter::once(None).chain(modes).collect()
}
