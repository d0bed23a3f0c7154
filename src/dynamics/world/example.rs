//! Groups of bodies for the unit tests of closing and contact model: all bodies in one island, or all in flight.

use std::sync::Arc;

use crate::dynamics::Model;
use crate::dynamics::model::coordinates::planar::PlanarState;
use crate::dynamics::penalty3d::contact_state::Contact;
use crate::dynamics::penalty3d::example;
use crate::dynamics::world::World;
use crate::dynamics::world::tracks::Trajectory;
use crate::scene::Scene;

/// The group of a scene at t = 0 with all contacts in stick whose nodes are over their faces as placed, and all
/// bodies in one island from `states`, its first step planned.
pub(in crate::dynamics) fn planned(scene: &Scene, states: &[PlanarState]) -> World {
    let (model, active) = example::closed(scene, example::stick);
    let mut island = example::island_of(&model, active.clone(), states.concat());
    island.plan(&model, 1.0, f64::INFINITY).expect("a step that can be made");
    let mut world = World::of(&Arc::new(model), 0);
    for contact in active {
        let track = world.contacts.iter_mut().find(|track| track.site == contact.site).expect("a contact of the group");
        track.state = Contact::Closed(contact.closed);
    }
    for (index, body) in world.bodies.iter_mut().enumerate() {
        body.now = Trajectory::Island { island: 0, index };
    }
    world.islands.push(Some(Box::new(island)));
    world
}

/// The group of a scene with its bodies in flight from `states` at t = 0.
pub(in crate::dynamics) fn in_flight(scene: &Scene, states: &[PlanarState]) -> World {
    flying(Model::compile(scene).unwrap_or_else(|errors| panic!("{errors}")), states)
}

/// The group of a model with its bodies in flight from `states` at t = 0.
pub(in crate::dynamics) fn flying(model: Model, states: &[PlanarState]) -> World {
    let mut world = World::of(&Arc::new(model), 0);
    for (body, state) in world.bodies.iter_mut().zip(states) {
        let free_motion = body.free_motion.as_ref().expect("a free motion in closed form");
        body.now = Trajectory::Flight(free_motion.fly(0.0, state).expect("a state of a girder in plan"));
    }
    world
}
