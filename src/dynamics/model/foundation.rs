//! The bodies of a model that are ground: under bearings and feet of piers that stand on ground of one motion.

use glam::DVec3;

use crate::dynamics::model::body::{Body, BodyCoordinates};
use crate::dynamics::model::compiled_model::Model;
use crate::dynamics::model::moving_ground::Foundation;
use crate::geometry::Prism;
use crate::motion::support::SupportMotion;

/// Ending of a ground's name after that of the support on it.
pub const GROUND: &str = ".ground";

/// Ground under a bearing or a foot, which nothing touches.
const POINT: Prism = Prism { length: 0.0, width: 0.0, thickness: 0.0, skew: std::f64::consts::FRAC_PI_2 };

impl Model {
    /// The body that the ground is under a support which moves in this way; one is added at
    /// `place` \[m\] for the first that does, and called as what stands on it with [`GROUND`].
    pub(super) fn foundation(&mut self, motion: SupportMotion, (above, place): (&str, DVec3)) -> Option<usize> {
        let moving = self.moving.as_ref().filter(|_| motion != SupportMotion::REFERENCE)?;
        if let Some(known) = self.foundations.iter().find(|foundation| foundation.motion == motion) {
            return Some(known.body);
        }
        let (number, body) = (self.bodies.len(), moving.body(format!("{above}{GROUND}"), POINT, place, motion));
        self.bodies.push(body);
        self.foundations.push(Foundation { body: number, motion });
        Some(number)
    }

    /// The body of an abutment's own ground, where that moves otherwise: the abutment itself, or what is below a wall before soil.
    pub(super) fn ground_of_abutment(&mut self, number: usize, (above, place): (&str, DVec3)) -> Option<usize> {
        let motion = self.moving.as_ref()?.supports.of_abutment(number)?;
        let wall = self.walls.get(number).copied().flatten()?;
        if wall.soil.is_some() { self.foundation(motion, (above, place)) } else { Some(wall.body) }
    }

    /// Puts soil, sliders and fuses of walls whose ground moves otherwise on that ground.
    pub(super) fn stand_walls_on_their_ground(&mut self) {
        for number in 0..self.walls.len() {
            let Some(wall) = self.walls[number].filter(|wall| wall.soil.is_some()) else { continue };
            let (name, place) = (self.bodies[wall.body].name.clone(), self.bodies[wall.body].home);
            let Some(ground) = self.ground_of_abutment(number, (&name, place)) else { continue };
            let home = self.bodies[ground].home;
            for link in self.links.iter_mut().filter(|link| link.bodies == [Some(wall.body), None]) {
                let point = link.homes[1] + link.arms[1];
                (link.bodies[1], link.homes[1], link.arms[1]) = (Some(ground), home, point - home);
            }
        }
    }

    /// Whether a body moves as it is given, as ground does, and no force moves it.
    pub fn moves_as_given(&self, body: usize) -> bool {
        self.given().any(|given| given == body)
    }

    /// Numbers of the bodies that move as they are given.
    fn given(&self) -> impl Iterator<Item = usize> {
        let walls = self.walls.iter().flatten().filter(|wall| wall.soil.is_none()).map(|wall| wall.body);
        self.foundations.iter().map(|foundation| foundation.body).chain(walls)
    }

    /// Latest end of a step from `t` in an interval between two kinks of the ground's motion: its end or, in a run that halves the intervals,
    /// its middle before that \[s\].
    pub(in crate::dynamics) fn latest_end(&self, t: f64, [from, until]: [f64; 2]) -> f64 {
        let middle = from.midpoint(until);
        if self.halves_intervals && t < middle { middle } else { until }
    }

    /// The next time after `t` at which the motion of the ground has a kink under any support; infinite when there is none \[s\].
    pub fn next_kink(&self, t: f64) -> f64 {
        let own = |body: &Body| match &body.coordinates {
            BodyCoordinates::Custom(coordinates) => coordinates.next_kink(t),
            BodyCoordinates::Planar | BodyCoordinates::Spatial => f64::INFINITY,
        };
        let carried = self.walls.iter().flatten().filter(|wall| wall.soil.is_some()).map(|wall| wall.body);
        self.given().chain(carried).map(|body| own(&self.bodies[body])).fold(self.ground.next_kink(t), f64::min)
    }
}
