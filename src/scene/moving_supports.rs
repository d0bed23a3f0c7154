//! Motion of the ground under each support: by the wave, and by the keys of abutments and piers.

use glam::{DVec2, DVec3};

use super::angle::sin_cos_deg;
use super::supports::StandsOn;
use super::{Abutment, Girder, Motion, Scene, placed};
use crate::motion::support::SupportMotion;

/// Motion of the ground under each support of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingSupports {
    /// Delay per metre, along the way of the wave \[s/m\].
    slowness: DVec2,
    /// Delay at the world's origin \[s\].
    origin: f64,
    /// Of each abutment.
    pub abutments: Vec<SupportMotion>,
    /// Of each pier.
    pub piers: Vec<SupportMotion>,
}

impl MovingSupports {
    /// Of the ground under a bearing at this place \[m\], where it moves otherwise than the ground of reference; `None` on a pier.
    pub fn under(&self, on: StandsOn, place: DVec3) -> Option<SupportMotion> {
        match on {
            StandsOn::Pier(_) => None,
            StandsOn::Abutment(number) => self.of_abutment(number),
            StandsOn::Ground => Some(self.at(place)).filter(|motion| *motion != SupportMotion::REFERENCE),
        }
    }

    /// Of an abutment, where it moves otherwise than the ground of reference.
    pub fn of_abutment(&self, number: usize) -> Option<SupportMotion> {
        self.abutments.get(number).copied().filter(|motion| *motion != SupportMotion::REFERENCE)
    }

    /// Of a pier's foot, where it moves otherwise than the ground of reference.
    pub fn of_pier(&self, number: usize) -> Option<SupportMotion> {
        self.piers.get(number).copied().filter(|motion| *motion != SupportMotion::REFERENCE)
    }

    /// Of a place of the ground \[m\].
    pub fn at(&self, place: DVec3) -> SupportMotion {
        let delay = (self.origin + self.slowness.dot(place.truncate())).max(0.0);
        SupportMotion { delay, ..SupportMotion::REFERENCE }
    }
}

impl Scene {
    /// Motion of the ground under each support, where it does not move as one; the ground of reference has the motion of `[motion]` and is
    /// that of the support which the wave reaches first.
    pub fn moving_supports(&self) -> Option<MovingSupports> {
        // Ground that stands still is the same later.
        let still = self.motion == Motion::None;
        let own = |(ground, numbers): (&Option<String>, [Option<f64>; 2])| {
            ground.is_some() || !still && numbers.iter().any(Option::is_some)
        };
        let differs = self.wave.is_some() && !still
            || self.abutments.iter().any(|a| own((&a.ground, [a.delay, a.motion_factor])))
            || self.piers.iter().any(|pier| own((&pier.ground, [pier.delay, pier.motion_factor])));
        if !differs {
            return None;
        }
        let slowness = self.wave.filter(|_| !still).map_or(DVec2::ZERO, |wave| {
            let (sin, cos) = sin_cos_deg(wave.angle_deg);
            DVec2::new(cos, sin) / wave.speed
        });
        let delay = |place: DVec3| slowness.dot(place.truncate());
        let abutments: Vec<DVec3> = self.abutments.iter().map(|wall| self.abutment_place(wall)).collect();
        let piers: Vec<DVec3> = (0..self.piers.len()).map(|number| self.pier(number).top).collect();
        let ground = self.bearing_places_on_ground();
        let places = abutments.iter().chain(&piers).chain(&ground).copied();
        let first = places.map(delay).fold(f64::INFINITY, f64::min);
        let origin = if first.is_finite() { -first } else { 0.0 };
        let waved = |place: DVec3| (origin + delay(place)).max(0.0);
        let motion = |place: DVec3, name: &Option<String>, [delay, factor]: [Option<f64>; 2]| {
            let factor = factor.unwrap_or(1.0);
            match name.as_ref().and_then(|name| self.ground_named(name)) {
                // It says by itself when it begins to move.
                Some(number) => SupportMotion { ground: number + 1, delay: delay.unwrap_or(0.0), factor },
                None if still => SupportMotion::REFERENCE,
                None => SupportMotion { ground: 0, delay: delay.unwrap_or_else(|| waved(place)), factor },
            }
        };
        let supports = MovingSupports {
            slowness,
            origin,
            abutments: (self.abutments.iter().zip(abutments))
                .map(|(a, place)| motion(place, &a.ground, [a.delay, a.motion_factor]))
                .collect(),
            piers: (self.piers.iter().zip(piers))
                .map(|(pier, place)| motion(place, &pier.ground, [pier.delay, pier.motion_factor]))
                .collect(),
        };
        let all = supports.abutments.iter().chain(&supports.piers).copied();
        let one = all.chain(ground.into_iter().map(|place| supports.at(place)));
        one.into_iter().any(|motion| motion != SupportMotion::REFERENCE).then_some(supports)
    }

    /// The middle of an abutment's face \[m\]; the origin where it has none.
    fn abutment_place(&self, abutment: &Abutment) -> DVec3 {
        placed::abutment_face(self, abutment).map_or(DVec3::ZERO, |face| face.into_iter().sum::<DVec3>() / 4.0)
    }

    /// Places of bearings that stand on the ground, world axes \[m\].
    fn bearing_places_on_ground(&self) -> Vec<DVec3> {
        let of = |girder: &Girder| {
            let axes = placed::axes(girder);
            let home = DVec3::from(girder.position);
            let free = girder.supports(self.setting()).into_iter().zip(self.standing(girder));
            let on_ground = free.filter(|(_, on)| *on == StandsOn::Ground);
            on_ground.map(|(bearing, _)| home + axes * bearing.place).collect::<Vec<_>>()
        };
        self.girders.iter().flat_map(of).collect()
    }
}
