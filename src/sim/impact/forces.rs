//! Forces of lasting contacts at any instant, and what their friction takes.

use glam::{DVec2, DVec3};

use super::events::contact_state;
use crate::dynamics::impact2d::delassus::centre;
use crate::dynamics::impact2d::kinematics::{BodyKinematics, ground_acceleration};
use crate::dynamics::impact2d::lasting::constrained_motion::{ContactMode, Reaction};
use crate::dynamics::impact2d::lasting::indeterminate::solve_reactions;
use crate::dynamics::impact2d::{ImpactRecord, LastingInterval};
use crate::dynamics::model::coordinates::planar::PlanarState;
use crate::sim::{ContactNow, History};

/// Poses of an interval's bodies at `t`, and its reactions.
fn reactions(history: &History, interval: &LastingInterval, t: f64) -> Option<(BodyKinematics, Vec<Reaction>)> {
    let model = history.model();
    let state = |body: &usize| -> PlanarState {
        let state = history.state(*body, t);
        std::array::from_fn(|i| state[i])
    };
    let states: Vec<PlanarState> = interval.bodies.iter().map(state).collect();
    let ground = &model.ground;
    // A run that ends with its record ends before the step of the ground that follows.
    let number = if t < interval.until { ground.piece_number(t) } else { ground.piece_number_before(t) };
    let piece = ground.piece(number);
    let kinematics = BodyKinematics::new(model, &interval.bodies, &states, ground_acceleration(ground, &piece, t));
    let points: Vec<_> = interval.modes.iter().map(|mode| mode.points(model, &kinematics)).collect();
    let motion = solve_reactions(&kinematics, &interval.modes, &points, &model.impact)?;
    Some((kinematics, motion.reactions))
}

/// Forces of all lasting contacts at `t`, on the body that owns the node.
pub(in crate::sim) fn contacts(history: &History, record: &ImpactRecord, t: f64) -> Vec<ContactNow> {
    let mut all = Vec::new();
    for interval in record.lasting_at(t) {
        let Some((kinematics, reactions)) = reactions(history, interval, t) else { continue };
        for (mode, reaction) in interval.modes.iter().zip(&reactions) {
            for (i, &site) in mode.sites.iter().enumerate() {
                all.push(now(history, &kinematics, mode, reaction, i, site));
            }
        }
    }
    all.sort_by_key(|now| now.contact);
    all
}

fn now(
    history: &History,
    kinematics: &BodyKinematics,
    mode: &ContactMode,
    reaction: &Reaction,
    end: usize,
    site: usize,
) -> ContactNow {
    let model = history.model();
    let contact = &model.sites[site];
    let point = kinematics.point(model, site);
    // Forces and V are the first side's; where the face is, they are the opposite.
    let side = if contact.node_body == model.pairs[mode.pair].bodies[0] { 1.0 } else { -1.0 };
    let flat = |v: DVec2| (v * side).extend(0.0);
    let total = reaction.total();
    let share = if total > 0.0 { reaction.normal[end] / total } else { 1.0 / mode.sites.len() as f64 };
    let [normal_velocity, slide] = kinematics.cluster.speeds(&point);
    let node = history.model().sites[site].node_body.and_then(|body| kinematics.bodies.binary_search(&body).ok());
    let place = match node {
        Some(place) => kinematics.frames[place].origin() + kinematics.frames[place].turn(contact.geometry.arm),
        None => contact.fixed + contact.point,
    };
    let normal = flat(point.n);
    let tangential = flat(point.s * (reaction.tangential * share));
    let [mu_static, mu_kinetic] = mode.friction_coefficients(&model.impact);
    ContactNow {
        contact: site,
        pair: mode.pair,
        state: contact_state(mode),
        point: place,
        anchor: place - normal * point.gap,
        normal,
        penetration: -point.gap,
        normal_velocity,
        sliding: flat(point.s * slide),
        normal_force: reaction.normal[end],
        tangential_force: tangential,
        normal_damping: 0.0,
        tangential_damping: DVec3::ZERO,
        force: normal * reaction.normal[end] + tangential,
        couple: DVec3::ZERO,
        mu_static,
        mu_kinetic,
    }
}

/// Power lost in the friction of an interval \[W\].
pub(in crate::sim) fn friction_power(history: &History, interval: &LastingInterval, t: f64) -> f64 {
    let Some((kinematics, reactions)) = reactions(history, interval, t) else { return 0.0 };
    let model = history.model();
    let power = |(mode, reaction): (&ContactMode, &Reaction)| {
        let centre = centre(&mode.points(model, &kinematics));
        -reaction.tangential * kinematics.cluster.speed(&centre, centre.s)
    };
    interval.modes.iter().zip(&reactions).map(power).sum()
}
