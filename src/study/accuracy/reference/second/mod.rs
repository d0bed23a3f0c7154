//! The second formulation: the same physics written anew from its equations, to compare with.
//!
//! Common with the event-driven solver: the scene as compiled (sizes, faces, declared contacts, the ground motion), with corners alone as
//! contact points. Different: an attitude is a matrix, not a quaternion; bearings act one by one; contact forces are written with world
//! vectors and an anchor that is a point of the face's body (53), (54), (57)–(59); free flight is integrated like everything else; the
//! integrator extrapolates Gragg's midpoint rule (Bulirsch and Stoer); an event is found by taking the step again, shorter, until the
//! switching function is 0.

mod bodies;
mod contacts;
mod extrapolate;
mod run;

use crate::dynamics::Model;
use crate::scene::{Scene, SceneErrors, validate::validate};
use crate::study::accuracy::{Answer, Instants};

/// The answer of the second formulation.
///
/// # Errors
/// Every complaint about the scene.
pub fn answer(scene: &Scene, instants: Instants) -> Result<Answer, SceneErrors> {
    validate(scene)?;
    let model = Model::compile(scene)?.of_corners();
    Ok(run::Run::new(&model).follow(instants))
}
