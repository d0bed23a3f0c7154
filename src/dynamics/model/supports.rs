//! Links of a girder's bearings: the parts that yield or slide, supports that can be lost, and the watch on corners that drop.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::dynamics::connection::{Device, Kinematics, Link};
use crate::dynamics::devices::{DropWatch, ElastoPlastic, Hysteresis, LinearBearing, Slider, Support};
use crate::dynamics::model::bearing::Bearing;
use crate::dynamics::model::body::Body;
use crate::dynamics::model::compiled_model::Model;
use crate::dynamics::model::coordinates::section_forces::LinkOf;
use crate::language::{Text, message};
use crate::scene::{
    AfterUnseating, Girder, Kind, ModelKind, ResolvedBearing, Scene, SceneError, SceneErrors, Setting, StandsOn,
    seating,
};

impl Model {
    /// Adds the links of a girder's bearings, each between its place and what it stands on, the ground, a pier or an abutment; their
    /// groups are formed later.
    pub(in crate::dynamics) fn add_supports(
        &mut self,
        body: usize,
        girder: &Girder,
        setting: Setting,
        standing: &[StandsOn],
    ) {
        let mut can_be_lost = false;
        let ends_run = setting.kind == Kind::Planar && girder.after_unseating != Some(AfterUnseating::Continue);
        let mut links = vec![Vec::new(); standing.len()];
        // Springs between girders and piers first, then what yields or slides.
        for on_pier in [true, false] {
            for (number, bearing) in girder.supports(setting).iter().enumerate() {
                let own = self.bodies[body].bearings[number];
                let pier = self.body_under((body, number), bearing.place, standing[number]);
                let (law, own) = match (on_pier, pier) {
                    (true, None) => continue,
                    (true, Some(_)) => (Some(spring(bearing)), own),
                    // The girder's share of the weight is lost with the spring.
                    (false, Some(_)) => (law(bearing, &own), Bearing { preload: DVec3::ZERO, ..own }),
                    (false, None) => (law(bearing, &own), own),
                };
                let room = seating::room(girder, bearing);
                can_be_lost |= room.is_some();
                let device: Arc<dyn Device> = match (law, room) {
                    (None, None) => continue,
                    (None, Some(_)) if pier.is_some() => continue,
                    (Some(law), None) => law,
                    (law, Some(room)) => {
                        let spring = LinearBearing { stiffness: own.stiffness, damping: own.damping };
                        Arc::new(Support { room, spring, preload: own.preload, law, ends_run })
                    }
                };
                links[number].push(self.links.len());
                let name = format!("{}.bearing{}", self.bodies[body].name, number + 1);
                match pier {
                    Some(pier) => {
                        let link = self.bearing_link(name, [body, pier], bearing.place, device);
                        self.add_link(link, LinkOf::Bearing);
                    }
                    None => self.add_to_ground(body, name, bearing.place, (device, LinkOf::Bearing)),
                }
            }
        }
        self.supports.push(links);
        if can_be_lost && setting.kind == Kind::Spatial {
            self.watch_corners(body, girder.drop());
        }
    }

    /// The body below a bearing at this place of a girder \[m\]: a pier, or ground that moves otherwise than the ground of reference.
    fn body_under(&mut self, (girder, bearing): (usize, usize), place: DVec3, on: StandsOn) -> Option<usize> {
        if let StandsOn::Pier(pier) = on {
            return Some(self.piers[pier].body);
        }
        let place = self.bodies[girder].home + self.bodies[girder].axes * place;
        let motion = self.moving.as_ref()?.supports.under(on, place)?;
        let name = format!("{}.bearing{}", self.bodies[girder].name, bearing + 1);
        match on {
            StandsOn::Abutment(number) => self.ground_of_abutment(number, (&name, place)),
            StandsOn::Ground | StandsOn::Pier(_) => self.foundation(motion, (&name, place)),
        }
    }

    /// A link of a place of a body \[m\] and the ground there, in the body's axes as placed.
    fn add_to_ground(&mut self, body: usize, name: String, place: DVec3, (device, of): (Arc<dyn Device>, LinkOf)) {
        let kinematics = if self.kind == Kind::Planar { Kinematics::Linear } else { Kinematics::Points };
        let Body { home, axes, .. } = &self.bodies[body];
        let (arm, axes): (DVec3, DMat3) = (*axes * place, *axes);
        let link = Link {
            name,
            bodies: [Some(body), None],
            arms: [arm, DVec3::ZERO],
            sections: [0; 2],
            homes: [*home, *home + arm],
            axes,
            kinematics,
            device,
        };
        self.add_link(link, of);
    }

    fn watch_corners(&mut self, body: usize, depth: f64) {
        let corners = self.bodies[body].prism.corners();
        let lowest = corners.iter().map(|corner| corner.z).fold(f64::INFINITY, f64::min);
        for (number, corner) in corners.into_iter().filter(|corner| corner.z <= lowest).enumerate() {
            let name = format!("{}.corner{}", self.bodies[body].name, number + 1);
            self.add_to_ground(body, name, corner, (Arc::new(DropWatch(depth)), LinkOf::Device));
        }
    }
}

/// Refuses sliders in space that the weight would lift.
///
/// # Errors
/// A slider whose load at rest is not more than 0.
pub(super) fn pressed(scene: &Scene, bodies: &[Body]) -> Result<(), SceneErrors> {
    let mut errors = Vec::new();
    for (girder, body) in scene.girders.iter().zip(bodies) {
        let supports = girder.supports(scene.setting());
        for number in (0..supports.len()).filter(|&number| supports[number].sliding.is_some()) {
            let load = body.bearings[number].preload.z;
            if load <= 0.0 {
                errors.push(SceneError {
                    file: "scene".to_owned(),
                    place: format!("girder.{}.bearings", girder.name).into(),
                    value: message!("found-pulled-slider", "number" => number + 1, "load" => format!("{load:.4e}")),
                    remedy: Text::new("wrong-pulled-slider").into(),
                });
            }
        }
    }
    if errors.is_empty() { Ok(()) } else { Err(SceneErrors(errors)) }
}

/// Refuses the impact model where something acts that it does not know.
///
/// # Errors
/// The first link of the model: a device, a pier's column, a bearing that yields, slides or can be lost, a backwall that moves.
pub(super) fn known_to_impact(scene: &Scene, model: &Model) -> Result<(), SceneErrors> {
    let Some(link) = model.links.first().filter(|_| scene.model.kind != ModelKind::Contact) else { return Ok(()) };
    Err(SceneErrors(vec![SceneError {
        file: "scene".to_owned(),
        place: "model.kind".to_owned().into(),
        value: message!("found-model-links", "model" => scene.model.kind.label(), "name" => link.name.as_str()),
        remedy: Text::new("wrong-impact-links").into(),
    }]))
}

/// Spring and dashpot of a bearing that stands on a pier, or on ground that moves otherwise.
fn spring(bearing: &ResolvedBearing) -> Arc<dyn Device> {
    Arc::new(LinearBearing { stiffness: bearing.stiffness.into(), damping: bearing.damping.into() })
}

/// The law of a bearing beside its spring and dashpot.
fn law(resolved: &ResolvedBearing, bearing: &Bearing) -> Option<Arc<dyn Device>> {
    if let Some(slide) = resolved.sliding {
        return Some(Arc::new(Slider {
            friction: slide.friction,
            curvature: slide.curvature,
            displacement: slide.displacement,
            load: bearing.preload.z,
            stiffness: bearing.stiffness.z,
            damping: bearing.damping.z,
            beside: [bearing.stiffness.truncate(), bearing.damping.truncate()],
        }));
    }
    let yielding = resolved.yielding?;
    let element = ElastoPlastic { stiffness: yielding.stiffness(), force: yielding.force };
    Some(Arc::new(if yielding.per_axis { Hysteresis::PerAxis([element; 2]) } else { Hysteresis::Circle(element) }))
}
