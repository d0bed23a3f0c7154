//! Bodies that can come near one another before anything is computed: for a warning, not a bound.
//!
//! A girder goes as far as it would without contact, on its bearings, under its pushes and the ground. A contact hands a
//! motion on but adds none to it, so that this is the size of what a run does; what is passed on along a row may go farther.

use glam::DVec3;

use super::solid::{Joined, Solids};
use crate::dynamics::free_flight::body_motion::BodyMotion;
use crate::dynamics::model::body::BodyCoordinates;
use crate::dynamics::{Body, Model};
use crate::geometry::broad;
use crate::geometry::shape::AlignedBox;
use crate::scene::Scene;
use crate::sim::report::SolidId;

/// Instants at which a motion is looked at where no bound holds for the whole run, as under a record.
const LOOKS: u32 = 256;

/// Two bodies that can come near and that no contact joins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unjoined {
    /// The two bodies.
    pub bodies: [SolidId; 2],
    /// Distance as placed \[m\].
    pub apart: f64,
    /// Bound on the approach of their corners without contact \[m\].
    pub reach: f64,
}

/// Every two bodies of a scene that can come near and that no facing pair joins, in order of their numbers.
pub fn unjoined(scene: &Scene, model: &Model) -> Vec<Unjoined> {
    let solids = Solids::of(scene, model);
    let joined = Joined::of(model);
    let reaches: Vec<f64> = (0..solids.len()).map(|number| reach(&solids, model, number)).collect();
    let grown = |number: usize| {
        let (hull, reach) = (solids.placed_box(model, number), DVec3::splat(reaches[number]));
        solids.flat(AlignedBox { min: hull.min - reach, max: hull.max + reach })
    };
    let boxes: Vec<_> = (0..solids.len()).map(grown).collect();
    let near = broad::pairs(&boxes).into_iter().map(|(one, other)| [one, other]);
    near.filter(|pair| {
        pair.iter().any(|&number| solids.moves(number))
            && joined.facing(pair.map(|number| solids.id(number))).is_empty()
    })
    .map(|pair| Unjoined {
        bodies: pair.map(|number| solids.id(number)),
        apart: solids.separation(pair, &solids.as_placed(model, pair)),
        reach: pair.map(|number| reaches[number]).iter().sum(),
    })
    .filter(|unjoined| unjoined.apart < unjoined.reach)
    .collect()
}

/// Bound on the displacement of a body's corners without contact \[m\].
fn reach(solids: &Solids, model: &Model, number: usize) -> f64 {
    // A backwall that moves is held by the ground unless something hits it.
    let Some(girder) = solids.body(number).filter(|&body| body < model.girders().len()) else { return 0.0 };
    // Piers carry it on: how far is known after a run, not before.
    if stands_on_pier(model, girder) {
        return 0.0;
    }
    // In space, too, the motion in plan decides what comes near.
    let body = Body { coordinates: BodyCoordinates::Planar, ..model.bodies[girder].clone() };
    let Some(motion) = BodyMotion::of(&body, &model.ground, model.duration) else { return 0.0 };
    let Some(flight) = motion.fly(0.0, &body.initial()) else { return 0.0 };
    let bounds = flight.bounds(0.0, model.duration);
    let corner = |reach: f64, turn: f64| reach + solids.radius(number) * turn.min(2.0);
    if bounds.window >= model.duration {
        return corner(bounds.reach, bounds.turn);
    }
    let at = |look: u32| {
        let state = flight.state(model.duration * f64::from(look) / f64::from(LOOKS));
        corner(state[0].hypot(state[1]), state[2].abs())
    };
    (0..=LOOKS).map(at).fold(0.0, f64::max)
}

fn stands_on_pier(model: &Model, girder: usize) -> bool {
    let is_pier = |body: usize| model.piers.iter().any(|pier| pier.body == body);
    model.links.iter().any(|link| link.bodies[0] == Some(girder) && link.bodies[1].is_some_and(is_pier))
}
