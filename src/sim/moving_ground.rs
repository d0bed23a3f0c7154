//! Ground that moves otherwise than the ground of reference, at any instant.

use glam::DVec3;

use super::History;
use crate::dynamics::Model;
use crate::dynamics::model::foundation::GROUND;
use crate::language::{said, six};
use crate::motion::support::SupportMotion;
use crate::scene::shown::escaped;
use crate::scene::{Girder, ResolvedBearing, Scene, placed};

/// Times at which the motion of a support is looked at for its largest displacement: every sample of 20 s at 0.01 s.
const LOOKS: u32 = 2000;

/// Speed that records may leave, of the largest within the run: what is left of a corrected baseline.
const LEFT: f64 = 0.02;

/// A support whose ground moves otherwise than the ground of reference.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct MovedSupport {
    /// The abutment or pier, or the bearing or device on the ground.
    pub name: String,
    /// Motion.
    #[serde(flatten)]
    pub motion: SupportMotion,
    /// The name of its ground motion, where that is not the one of the ground of reference.
    pub ground: Option<String>,
    /// Largest displacement against the ground of reference within the run, of the times looked at \[m\].
    pub largest: f64,
    /// That at the end of the run \[m\].
    pub last: f64,
    /// Speed at which it goes on against the ground of reference when the records of both have ended \[m/s\]; none where that is
    /// rounding beside the motion, or one has no end.
    pub drift: Option<f64>,
    /// Speed at which its own ground goes on when its record has ended \[m/s\], where that is more than rounding and the ground of
    /// reference goes on alike: a delay leaves the two apart by as much as one of them moves within it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub left: Option<f64>,
}

impl MovedSupport {
    /// In words, that the ends of records leave it moving against the ground of reference, and the remedy.
    fn drifting(&self) -> Option<String> {
        let (name, last) = (escaped(&self.name), six(self.last));
        if let Some(speed) = self.drift.map(six) {
            return Some(said!("support-drifts", "name" => name, "speed" => speed, "last" => last));
        }
        let speed = six(self.left.filter(|_| self.stays_apart())?);
        Some(said!("support-stays-apart", "name" => name, "speed" => speed, "last" => last))
    }

    /// Whether it is late, and its record leaves it moving as the ground of reference goes on.
    fn stays_apart(&self) -> bool {
        self.drift.is_none() && self.left.is_some() && self.motion.delay > 0.0
    }
}

/// In words, what records leave moving: every support that goes on moving against the ground of reference, and of those that stay
/// apart because they are late, which is one fault of one record, the farthest.
pub fn drifting(supports: &[MovedSupport]) -> Vec<String> {
    let (apart, others): (Vec<_>, Vec<_>) = supports.iter().partition(|support| support.stays_apart());
    let farthest = apart.into_iter().reduce(|a, b| if b.last > a.last { b } else { a });
    others.into_iter().chain(farthest).filter_map(MovedSupport::drifting).collect()
}

/// The supports of a scene whose ground moves otherwise than the ground of reference: abutments, piers, other places.
pub fn moved_supports(scene: &Scene, model: &Model) -> Vec<MovedSupport> {
    let Some(moving) = &model.moving else { return Vec::new() };
    let supports = &moving.supports;
    let abutments = scene.abutments.iter().enumerate().map(|(i, a)| (a.name.clone(), supports.of_abutment(i)));
    let piers = scene.piers.iter().enumerate().map(|(i, pier)| (pier.name.clone(), supports.of_pier(i)));
    let other = model.foundations.iter().filter(|foundation| !supports.piers.contains(&foundation.motion));
    let above = |body: usize| {
        let name = model.bodies[body].name.as_str();
        name.strip_suffix(GROUND).unwrap_or(name).to_owned()
    };
    let other = other.map(|foundation| (above(foundation.body), Some(foundation.motion)));
    let moved = |(name, motion): (String, Option<SupportMotion>)| {
        let motion = motion?;
        let relative = moving.relative(motion);
        let apart = |t: f64| relative.at(t)[1].length();
        let looks = || (0..=LOOKS).map(|look| model.duration * f64::from(look) / f64::from(LOOKS));
        let fastest = looks().map(|t| relative.at(t)[0].length()).fold(0.0, f64::max);
        let drift = relative.last_velocity().map(DVec3::length).filter(|speed| *speed > LEFT * fastest);
        let own_fastest = looks().map(|t| relative.own_velocity(t).length()).fold(0.0, f64::max);
        let left = relative.own_last_velocity().map(DVec3::length);
        let ground = motion.ground.checked_sub(1).map(|number| scene.grounds[number].name.clone());
        Some(MovedSupport {
            name,
            motion,
            ground,
            largest: looks().map(apart).fold(0.0, f64::max),
            last: apart(model.duration),
            drift,
            left: left.filter(|speed| drift.is_none() && *speed > LEFT * own_fastest),
        })
    };
    let mut all: Vec<MovedSupport> = Vec::new();
    for support in abutments.chain(piers).chain(other).filter_map(moved) {
        // The foundation of a backwall that moves is its abutment's; two of one name that move otherwise are two.
        if !all.contains(&support) {
            all.push(support);
        }
    }
    all
}

/// Displacement of the ground of a support that moves in this way, against the ground of reference \[m\].
pub fn displacement(history: &History, motion: SupportMotion, t: f64) -> DVec3 {
    history.model().moving.as_ref().map_or(DVec3::ZERO, |moving| moving.displacement(motion, t))
}

/// Displacement of the ground under each bearing of each girder \[m\], 0 on piers; nothing where the ground moves as one.
pub fn under_bearings(history: &History, t: f64) -> Vec<Vec<DVec3>> {
    let (scene, Some(moving)) = (history.scene(), &history.model().moving) else { return Vec::new() };
    let of = |girder: &Girder| {
        let (axes, home) = (placed::axes(girder), DVec3::from(girder.position));
        let bearings = girder.supports(scene.setting()).into_iter().zip(scene.standing(girder));
        let motion = |(bearing, on): (ResolvedBearing, _)| moving.supports.under(on, home + axes * bearing.place);
        bearings.map(|bearing| motion(bearing).map_or(DVec3::ZERO, |own| moving.displacement(own, t))).collect()
    };
    scene.girders.iter().map(of).collect()
}
