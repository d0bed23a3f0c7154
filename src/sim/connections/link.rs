//! Devices at any instant: phase, force, energy, and the line to draw.

use glam::DVec3;

use crate::contact::Frame;
use crate::dynamics::connection::{Kinematics, Link, Phase, Separation};
use crate::dynamics::model::wrench::Wrench;
use crate::language::Text;
use crate::sim::Loop;
use crate::sim::connections::view::Connections;

/// A device at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkNow {
    /// Its number in the model.
    pub link: usize,
    /// Its phase.
    pub phase: Phase,
    /// Whether its force acts.
    pub acts: bool,
    /// The phase in a word.
    pub state: Text,
    /// Force at which it yields, or breaks where it does not yield; none where it does neither \[N\].
    pub strength: Option<f64>,
    /// Deformation and resistance: along the line between points apart, else along its axes.
    pub along: Loop,
    /// Its points, world axes \[m\].
    pub ends: [DVec3; 2],
    /// Centre line from the first point to the second, world axes \[m\].
    pub line: Vec<DVec3>,
    /// Force on the first point, world axes; the second feels its opposite \[N\].
    pub force: DVec3,
    /// Force on the first point with the rest of the bearing that it is a part of, world axes \[N\].
    pub reaction: DVec3,
    /// Distance to the beginning of its force; less the deformation while the force acts; of a bearing its remaining travel, NaN without a
    /// limit \[m\].
    pub gap: f64,
    /// Stored energy \[J\].
    pub stored: f64,
    /// Dissipated power \[W\].
    pub dissipated: f64,
}

impl LinkNow {
    /// Force in parts of the strength, where it has one.
    pub fn part_of_strength(&self) -> Option<f64> {
        Some(self.force.length() / self.strength?)
    }
}

/// Whether a device acts along the line between its points.
fn follows_line(link: &Link, motion: &Separation) -> bool {
    link.kinematics == Kinematics::Points && motion.placed.length() > 0.0
}

/// A link with the poses of its ends, the motion of its points, and the arms of its force \[m\].
struct LinkMotion<'a> {
    link: &'a Link,
    frames: [Frame; 2],
    motion: Separation,
    arms: [DVec3; 2],
}

impl<'a> Connections<'a> {
    /// A device at `t`, clamped to what was computed; nothing where the model has no link of that number or the impact model
    /// computed the run.
    pub fn link(self, number: usize, t: f64) -> Option<LinkNow> {
        let t = t.clamp(0.0, self.history.end());
        let phase = self.link_phase(number, t)?;
        self.link_in(number, phase, t)
    }

    /// A device at `t` in this phase of its log, where several begin at one instant; `None` as of [`link`](Self::link).
    pub fn link_in(self, number: usize, phase: Phase, t: f64) -> Option<LinkNow> {
        let LinkMotion { link, frames, motion, .. } =
            self.link_motion_of(number, |body, section| self.history.trajectories.section_frame(body, section, t))?;
        let device = &link.device;
        let (acts, gap) = (device.acts(&phase), device.distance_left(&phase, &motion));
        let ends = [0, 1].map(|i| frames[i].origin() + frames[i].turn(link.arms[i]));
        let stored = device.stored_energy(&phase, &motion);
        let (force, reaction, dissipated) = if acts {
            let [force, reaction] = [Link::force, Link::reaction].map(|of| of(link, &phase, &motion, &frames[1]));
            (force, reaction, device.dissipated_power(&phase, &motion))
        } else {
            (DVec3::ZERO, DVec3::ZERO, 0.0)
        };
        let own = if acts { device.force(&phase, &motion) } else { DVec3::ZERO };
        let along = Loop::of(&motion, own, follows_line(link, &motion));
        let (state, strength) = (device.state(&phase), device.strength());
        let line = device.centre_line(&phase, ends);
        Some(LinkNow {
            link: number,
            phase,
            acts,
            state,
            strength,
            along,
            ends,
            line,
            force,
            reaction,
            gap,
            stored,
            dissipated,
        })
    }

    /// Deformation and resistance of a device along its axes at `t`, and its force on the first point in world axes \[N\], by the poses of
    /// sections of bodies then.
    pub(in crate::sim) fn link_acting(
        self,
        number: usize,
        t: f64,
        frame: &dyn Fn(usize, usize) -> Frame,
    ) -> Option<(Loop, DVec3)> {
        let phase = self.link_phase(number, t)?;
        let LinkMotion { link, frames, motion, .. } = self.link_motion_of(number, frame)?;
        let (own, force) = if link.device.acts(&phase) {
            (link.device.force(&phase, &motion), link.force(&phase, &motion, &frames[1]))
        } else {
            (DVec3::ZERO, DVec3::ZERO)
        };
        Some((Loop::of(&motion, own, follows_line(link, &motion)), force))
    }

    /// Devices at `t`, in the order of their numbers.
    pub fn links(self, t: f64) -> Vec<LinkNow> {
        (0..self.history.model().links.len()).filter_map(|link| self.link(link, t)).collect()
    }

    /// Changes of a device's phase in order of time: when \[s\], and the phase from then on.
    pub fn link_phases(self, number: usize) -> &'a [(f64, Phase)] {
        self.history.trajectories.link_log(number).map_or(&[], |log| log.phases())
    }

    fn link_phase(self, number: usize, t: f64) -> Option<Phase> {
        let device = &self.history.model().links.get(number)?.device;
        self.history.trajectories.link_log(number)?.evolved_at(t, |phase| device.evolves(phase))
    }

    fn link_motion(self, number: usize, t: f64) -> Option<(&'a Link, Phase, Separation)> {
        let phase = self.link_phase(number, t)?;
        let LinkMotion { link, motion, .. } =
            self.link_motion_of(number, |body, section| self.history.trajectories.section_frame(body, section, t))?;
        Some((link, phase, motion))
    }

    /// A link as it moves, by the poses of sections of bodies.
    fn link_motion_of(self, number: usize, frame: impl Fn(usize, usize) -> Frame) -> Option<LinkMotion<'a>> {
        let link = self.history.model().links.get(number)?;
        let frames = link.frames(|end, section| link.bodies[end].map(|body| frame(body, section)));
        let (motion, arms) = link.motion([&frames[0], &frames[1]]);
        Some(LinkMotion { link, frames, motion, arms })
    }

    /// Adds the forces of devices on a body, which is in this state at `t`, to the wrenches on its sections, each about the origin of
    /// the section's frame.
    pub(in crate::sim) fn push_links(self, body: usize, (t, state): (f64, &[f64]), wrenches: &mut [Wrench]) {
        let frame = |other: usize, section: usize| {
            if other == body {
                self.history.model().bodies[body].frame(section, state)
            } else {
                self.history.trajectories.section_frame(other, section, t)
            }
        };
        let own = |(number, link): (usize, &Link)| link.bodies.contains(&Some(body)).then_some(number);
        for number in self.history.model().links.iter().enumerate().filter_map(own) {
            let Some(LinkMotion { link, frames, motion, arms }) = self.link_motion_of(number, frame) else { continue };
            let Some(phase) = self.link_phase(number, t) else { continue };
            if !link.device.acts(&phase) {
                continue;
            }
            let force = link.force(&phase, &motion, &frames[1]);
            for (end, force) in [force, -force].into_iter().enumerate() {
                if link.bodies[end] == Some(body) {
                    wrenches[link.sections[end]].push(force, arms[end]);
                }
            }
        }
    }

    /// Stored energy of a device \[J\].
    pub(in crate::sim) fn link_energy(self, number: usize, t: f64) -> f64 {
        self.link_motion(number, t).map_or(0.0, |(link, phase, motion)| link.device.stored_energy(&phase, &motion))
    }

    /// Power that a device dissipates with its ends in these poses at `t` \[W\].
    pub(in crate::sim) fn link_power(self, number: usize, t: f64, frames: &[Frame; 2]) -> f64 {
        let link = &self.history.model().links[number];
        let acting = self.link_phase(number, t).filter(|phase| link.device.acts(phase));
        acting.map_or(0.0, |phase| link.device.dissipated_power(&phase, &link.motion([&frames[0], &frames[1]]).0))
    }
}
