//! Links and devices put into a compiled model.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::dynamics::connection::{Anchor, Device, Kinematics, Link};
use crate::dynamics::devices::{PlacedLaw, laws};
use crate::dynamics::model::compiled_model::{Model, ModelDevice};
use crate::dynamics::model::coordinates::section_forces::LinkOf;
use crate::scene::device::Joint;
use crate::scene::{Kind, Scene, StandsOn};

/// Why a link cannot be put into a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LinkError {
    /// An end names a body that the model does not have.
    #[error("the link ends at body {0}, which is not in the model: give a number below the number of its bodies")]
    NoBody(usize),
    /// Both ends are at one body, or both at the ground.
    #[error("both ends of the link are at one body or at the ground: give two bodies, or one body and the ground")]
    SameBody,
    /// In a planar model the ends differ in height.
    #[error("the ends of a link of a planar model differ in height: give both ends the same height")]
    OutOfPlane,
}

impl Model {
    /// Puts a device between two points of the bodies as placed; the device sees their motion in `axes`, whose columns are in
    /// the world.
    ///
    /// # Errors
    ///
    /// An end is at no body of the model, both ends are at one body, or, in a planar model, they differ in height.
    pub fn link(
        &mut self,
        name: &str,
        ends: [Anchor; 2],
        axes: DMat3,
        device: Arc<dyn Device>,
    ) -> Result<(), LinkError> {
        self.link_by(name, ends, (axes, Kinematics::Points), device)
    }

    /// The same, with its motion measured in another way.
    ///
    /// # Errors
    /// Those of [`Model::link`].
    pub fn link_by(
        &mut self,
        name: &str,
        ends: [Anchor; 2],
        (axes, kinematics): (DMat3, Kinematics),
        device: Arc<dyn Device>,
    ) -> Result<(), LinkError> {
        let bodies = ends.map(|end| end.body());
        if let Some(missing) = bodies.into_iter().flatten().find(|&body| body >= self.bodies.len()) {
            return Err(LinkError::NoBody(missing));
        }
        if bodies[0] == bodies[1] {
            return Err(LinkError::SameBody);
        }
        let (homes, arms) = (ends.map(|end| self.home_of(&end)), ends.map(|end| self.arm_of(&end)));
        let link = Link { name: name.into(), bodies, arms, sections: [0; 2], homes, axes, kinematics, device };
        if self.kind == Kind::Planar && (homes[0] + arms[0] - homes[1] - arms[1]).z != 0.0 {
            return Err(LinkError::OutOfPlane);
        }
        self.add_link(link, LinkOf::Device);
        self.regroup();
        Ok(())
    }

    /// Adds a link, its points on their sections; its groups are formed later.
    pub(super) fn add_link(&mut self, mut link: Link, of: LinkOf) {
        for (end, body) in link.bodies.into_iter().enumerate() {
            let Some(body) = body else { continue };
            // A device can lead its bodies off an axis.
            self.bodies[body].keeps_to_axis = [false; 2];
            link.sections[end] = self.section_of_link(body, link.arms[end], of);
        }
        self.links.push(link);
    }

    /// The section of a body that the point of a link is on, at this arm from G as placed in the world's axes; an elastic girder gets one
    /// there.
    fn section_of_link(&mut self, body: usize, arm: DVec3, of: LinkOf) -> usize {
        let flexible = self.flexible.get_mut(body).and_then(Option::as_mut);
        let Some(girder) = flexible.and_then(|flexible| flexible.girder.as_mut()) else { return 0 };
        let section = girder.section_of_link(arm, of);
        self.bodies[body].coordinates = girder.coordinates();
        section
    }

    /// Adds the devices of a scene that has been checked; their groups are formed later.
    pub(in crate::dynamics) fn add_devices(&mut self, scene: &Scene) {
        for (id, part) in scene.devices() {
            let (from, ends) = (self.links.len(), part.ends());
            if let Some((joint, device)) = Joint::of(scene, &ends).zip(scene.device(id)) {
                for law in laws(&device, &joint) {
                    self.add_law(ends.name, &joint, law);
                }
            }
            self.devices.push(ModelDevice { id, name: ends.name.to_owned(), links: from..self.links.len() });
        }
    }

    fn add_law(&mut self, name: &str, joint: &Joint, law: PlacedLaw) {
        let PlacedLaw { suffix, axes, kinematics, device } = law;
        let first = self.bodies[joint.girder].home;
        let other = joint.other.or_else(|| self.ground_of(name, joint));
        let second = other.map_or(joint.points[1], |other| self.bodies[other].home);
        let link = Link {
            name: format!("{name}{suffix}"),
            bodies: [Some(joint.girder), other],
            arms: [joint.points[0] - first, joint.points[1] - second],
            sections: [0; 2],
            homes: [first, second],
            axes,
            kinematics,
            device,
        };
        self.add_link(link, LinkOf::Device);
    }

    /// The body of the ground or abutment that the second point of a device is on, where that moves otherwise than the ground of
    /// reference.
    fn ground_of(&mut self, name: &str, joint: &Joint) -> Option<usize> {
        let (on, place) = (joint.abutment.map_or(StandsOn::Ground, StandsOn::Abutment), joint.points[1]);
        let motion = self.moving.as_ref()?.supports.under(on, place)?;
        match joint.abutment {
            Some(number) => self.ground_of_abutment(number, (name, place)),
            None => self.foundation(motion, (name, place)),
        }
    }

    fn home_of(&self, end: &Anchor) -> DVec3 {
        match *end {
            Anchor::Body { body, .. } => self.bodies[body].home,
            Anchor::Ground(point) => point,
        }
    }

    fn arm_of(&self, end: &Anchor) -> DVec3 {
        match *end {
            Anchor::Body { body, point } => self.bodies[body].axes * point,
            Anchor::Ground(_) => DVec3::ZERO,
        }
    }
}
