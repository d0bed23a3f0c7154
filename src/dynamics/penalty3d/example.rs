//! Closed contacts for the unit tests of the contact model: a girder flush against a wall, two girders end to end.

use crate::contact::parameters::{is_over, sharers};
use crate::contact::{Local, Mode, locate};
use crate::dynamics::integrator::step_control::ControllerState;
use crate::dynamics::model::coordinates::planar::WIDTH;
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::penalty3d::active_contact::ActiveContact;
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::penalty3d::coupled_system::Members;
use crate::dynamics::penalty3d::due::Due;
use crate::dynamics::penalty3d::event_location::first_contact_events;
use crate::dynamics::penalty3d::island::Island;
use crate::dynamics::{Body, ContactSite, Model};
use crate::scene::facing::{self, SolidId};
use crate::scene::{Scene, format};

/// Mass of a girder \[kg\].
pub(in crate::dynamics) const MASS: f64 = 2.0;
/// Impact speed of the examples \[m/s\].
pub(in crate::dynamics) const SPEED: f64 = 0.5;
/// Stiffness of a pair \[N/m\].
pub(in crate::dynamics) const STIFFNESS: f64 = 1.55e5;

const GIRDER: &str = "length_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = 2.0\nheld = [\"yaw\"]\n";
const CONTACT: &str = "[contact]\nstiffness_n_per_m = 1.55e5\nrestitution_normal = 1.0\nrestitution_tangential = 1.0\n\
    law = \"paper\"\n[solver]\ntolerance = 1e-12\n";

fn scene(text: &str) -> Scene {
    format::parse(text, "example").unwrap_or_else(|errors| panic!("{errors}"))
}

/// An elastic girder without bearings and without rotation about Z, flush against a wall.
pub(in crate::dynamics) fn wall() -> Scene {
    let abutment = "[[abutment]]\nname = \"wall\"\nfaces = \"deck\"\ngap_m = 0.0\nwidth_m = 2.0\n";
    scene(&format!("name = \"wall\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\n{GIRDER}{abutment}{CONTACT}"))
}

/// Two girders of this kind end to end.
pub(in crate::dynamics) fn row() -> Scene {
    let [one, two] = [("one", 0.0), ("two", 0.19)]
        .map(|(name, x)| format!("[[girder]]\nname = \"{name}\"\nposition_m = [{x}, 0.0, 0.0]\n{GIRDER}"));
    scene(&format!("name = \"row\"\nduration_s = 1.0\n{one}{two}{CONTACT}"))
}

/// The scene with its girders free to rotate about Z.
pub(in crate::dynamics) fn free_to_turn(mut scene: Scene) -> Scene {
    scene.girders.iter_mut().for_each(|girder| girder.held.clear());
    scene
}

/// The compiled scene, whose first two girders have met: every face of one has a pair with every face of the other.
pub(in crate::dynamics) fn met(scene: &Scene) -> Model {
    let mut facings = facing::find(scene).unwrap_or_else(|errors| panic!("{errors}"));
    facings.extend(facing::between(scene, &[[SolidId::Girder(0), SolidId::Girder(1)]], &facings));
    Model::of(scene, facings).unwrap_or_else(|errors| panic!("{errors}"))
}

/// The compiled scene, with every node closed whose projection is inside a face as placed, in the mode given by
/// `mode`.
pub(in crate::dynamics) fn closed(scene: &Scene, mode: impl Fn(&Local) -> Mode) -> (Model, Vec<ActiveContact>) {
    let model = Model::compile(scene).unwrap_or_else(|errors| panic!("{errors}"));
    let frame = |body: Option<usize>, site: &ContactSite| {
        body.map_or(site.stand, |body| model.bodies[body].planar_frame(&[0.0; WIDTH]))
    };
    let local = |site: &ContactSite| locate(&site.geometry, &frame(site.node_body, site), &frame(site.face_body, site));
    let active = (0..model.sites.len()).filter_map(|number| {
        let site = &model.sites[number];
        let here = local(site);
        let pair = &model.pairs[site.pair];
        let nodes = sharers(pair.sites.clone().map(|n| (&model.sites[n].face, local(&model.sites[n]).at)));
        let closed = ClosedContact::new(pair.law.shared(nodes as f64), mode(&here), 0.0);
        let active = ActiveContact::new(number, [site.node_body, site.face_body], closed, site.geometry);
        // An edge node is one from the closing of its pair on.
        (site.edge.is_none() && is_over(&site.face, here.at)).then_some(active)
    });
    let mut active: Vec<ActiveContact> = active.collect();
    let layout = StateLayout::of(model.bodies.iter());
    for a in &mut active {
        a.find_sections(&model, &layout);
    }
    (model, active)
}

/// Stick with the anchor at the node's projection.
pub(in crate::dynamics) fn stick(here: &Local) -> Mode {
    Mode::Stick { anchor: here.way }
}

/// An island of all bodies of a model at t = 0 with these displacements \[m\] and velocities \[m/s\] `x, y, ẋ, ẏ`.
pub(in crate::dynamics) fn island(model: &Model, active: Vec<ActiveContact>, states: &[[f64; 4]]) -> Island {
    island_of(model, active, states.iter().flat_map(|&[x, y, u, v]| [x, y, 0.0, u, v, 0.0]).collect())
}

/// An island of all bodies of a model at t = 0 in the states `y`, body by body.
pub(in crate::dynamics) fn island_of(model: &Model, active: Vec<ActiveContact>, y: Vec<f64>) -> Island {
    let bodies: Vec<usize> = (0..model.bodies.len()).collect();
    let bases = model.bodies.iter().map(Body::placed).collect();
    let (slots, contacts) = (bodies.clone(), (0..active.len()).collect());
    let members = Members { bodies, bases, active, links: Vec::new() };
    Island::new(model, slots, members, contacts, y, 0.0, ControllerState::default())
}

/// Plans steps until the first event: its time \[s\], with all events within 1 ps of it.
pub(in crate::dynamics) fn first_event(model: &Model, island: &mut Island) -> (f64, Vec<Due>) {
    for _ in 0..1000 {
        island.plan(model, 1.0, f64::INFINITY).expect("a step that can be made");
        if let Some(found) = first_contact_events(model, island, 1e-12) {
            return found;
        }
    }
    panic!("no event until {} s", island.step.until);
}
