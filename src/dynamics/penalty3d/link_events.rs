//! Ends of phases of devices within a planned step: zeros of their switching functions on the dense output.

use smallvec::SmallVec;

use crate::dynamics::Model;
use crate::dynamics::connection::{Excursion, Kinematics, Link, Phase, Separation, SwitchUnit};
use crate::dynamics::locate::first_rise::{EarliestRise, Resolution, first_rise};
use crate::dynamics::locate::sample_times::sample_time;
use crate::dynamics::penalty3d::active_link::ActiveLink;
use crate::dynamics::penalty3d::constants::{POSITION_ROUNDING, ZERO_BAND};
use crate::dynamics::penalty3d::due::LinkDue;
use crate::dynamics::penalty3d::event_location::sample_count;
use crate::dynamics::penalty3d::island::Island;

/// The first end of a phase of the island's devices within its planned step, and its time \[s\]; `None` without one.
pub(in crate::dynamics) fn first_phase_end(model: &Model, island: &Island) -> Option<(f64, LinkDue)> {
    if island.system.links.iter().all(|active| active.link(model).device.switches(&active.phase) == 0) {
        return None;
    }
    let sections = island.system.layout.section_count();
    // The start; further samples once a phase may end.
    let mut times: SmallVec<[f64; 8]> = SmallVec::from_slice(&[island.step.from]);
    let mut frames = island.frames_since(model, &times);
    let mut earliest = EarliestRise::none();
    for (index, active) in island.system.links.iter().enumerate() {
        let link = active.link(model);
        let begins = active.motion(model, &island.system.bases, &frames).0;
        let within = excursion(model, island, active);
        let phase = island.phase_at(index, island.step.from);
        let likely = |number: &usize| !link.device.stays_below(*number, &phase, &begins, within);
        let likely: SmallVec<[usize; 4]> = (0..link.device.switches(&active.phase)).filter(likely).collect();
        if likely.is_empty() {
            continue;
        }
        if times.len() == 1 {
            let (interval, count) = ([island.step.from, island.step.until], sample_count(island));
            times.extend((1..count).map(|i| sample_time(interval, i, count)));
            frames.extend(island.frames_since(model, &times[1..]));
        }
        let motions: Vec<_> =
            frames.chunks_exact(sections).map(|f| active.motion(model, &island.system.bases, f).0).collect();
        for number in likely {
            let SwitchRoundoff { zero, band, noise } =
                switch_roundoff(link, (number, &active.phase), &motions, island.omega());
            let switch =
                |motion: &Separation, t: f64| link.device.switch(number, &island.phase_at(index, t), motion) - band;
            let values: Vec<f64> = motions.iter().zip(&times).map(|(motion, &t)| switch(motion, t)).collect();
            let value_at = |t: f64| {
                let frames = island.frames_since(model, &[t]);
                switch(&active.motion(model, &island.system.bases, &frames).0, t)
            };
            let rise = match link.device.switch_unit(number, &active.phase) {
                SwitchUnit::Length => island.step.allowed.displacement,
                SwitchUnit::Speed => island.step.allowed.speed,
            };
            let resolution = Resolution { zero, rise, noise };
            let rise = first_rise([&times, &values], resolution, false, earliest.known(), value_at);
            earliest.offer(rise, LinkDue { index, switch: number });
        }
    }
    earliest.found()
}

/// Bounds on the change, within the planned step, of displacement and rate of a link's first point relative to the second, in the link's
/// axes; infinite where these turn.
fn excursion(model: &Model, island: &Island, active: &ActiveLink) -> Excursion {
    let link = active.link(model);
    if link.kinematics == Kinematics::Carried && active.ends[1].is_some() {
        return Excursion { way: f64::INFINITY, rate: f64::INFINITY };
    }
    let mut within = Excursion { way: 0.0, rate: 0.0 };
    for (end, arm) in active.ends.into_iter().zip(link.arms) {
        let (Some(body), arm) = (end, arm.length()) else { continue };
        let bounds = island.bound(model, body);
        within.way += island.excursion(model, body, arm, island.step.from);
        // Of a point at this arm: G's, tangential, towards the axis.
        let acceleration = bounds.acceleration + arm * bounds.acceleration_per_arm();
        within.rate += acceleration * (island.step.until - island.step.from);
    }
    within
}

/// Round-off of a switching function, in its unit \[m or m/s\].
pub(in crate::dynamics) struct SwitchRoundoff {
    /// Value up to which the function is at 0 at the start of a stretch.
    pub zero: f64,
    /// Value that is taken off the function: a phase that begins at a zero of the next one's function, with its rate 0 as well, is
    /// not ended by round-off.
    pub band: f64,
    /// Value that round-off alone may give.
    pub noise: f64,
}

/// Round-off of a switching function of a phase over a stretch with these motions. `omega` is the fastest circular frequency \[rad/s\].
pub(in crate::dynamics) fn switch_roundoff(
    link: &Link,
    (number, phase): (usize, &Phase),
    motions: &[Separation],
    omega: f64,
) -> SwitchRoundoff {
    let size = |of: &dyn Fn(&Separation) -> f64| motions.iter().map(of).fold(0.0, f64::max);
    // Places round with what has moved, too.
    let moved = size(&|m| m.moved.length());
    match link.device.switch_unit(number, phase) {
        SwitchUnit::Length => length_roundoff(link, moved, size(&|m| link.device.gap(phase, m)[0].abs())),
        SwitchUnit::Speed => speed_roundoff(link, moved, size(&|m| m.rate.length()), omega),
    }
}

/// Of a length, where the link's points are displaced by up to `moved` and its gap is up to `length` \[m\].
pub(in crate::dynamics) fn length_roundoff(link: &Link, moved: f64, length: f64) -> SwitchRoundoff {
    let band = POSITION_ROUNDING * (link.size() + moved + length);
    SwitchRoundoff { zero: ZERO_BAND * length + band, band, noise: band }
}

/// Of a speed, where they are displaced by up to `moved` \[m\] at up to `speed` \[m/s\].
pub(in crate::dynamics) fn speed_roundoff(link: &Link, moved: f64, speed: f64, omega: f64) -> SwitchRoundoff {
    let rounding = POSITION_ROUNDING * (link.size() + moved) * omega;
    SwitchRoundoff { zero: ZERO_BAND * speed + rounding, band: 0.0, noise: rounding }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DMat3, DVec3};

    use super::*;
    use crate::dynamics::Body;
    use crate::dynamics::connection::{Anchor, Device};
    use crate::dynamics::devices::{Failure, Restrainer, Stopper, Yielding};
    use crate::dynamics::integrator::step_control::ControllerState;
    use crate::dynamics::penalty3d::coupled_system::Members;
    use crate::dynamics::penalty3d::example::{MASS, SPEED, STIFFNESS, wall};

    /// The girder without contacts that moves along x at [`SPEED`] from where it is placed, under a device from a point of the ground.
    fn driven(device: Arc<dyn Device>, kinematics: Kinematics, ground: DVec3) -> (Model, Island) {
        let mut model = Model::compile(&wall()).unwrap_or_else(|errors| panic!("{errors}"));
        let ends = [Anchor::Body { body: 0, point: DVec3::ZERO }, Anchor::Ground(ground)];
        model.link_by("device", ends, (DMat3::IDENTITY, kinematics), device).expect("a link in the plane");
        let link = &model.links[0];
        let motion = Separation { placed: link.placed(), moved: DVec3::X * 1e-12, rate: DVec3::X * SPEED };
        let active = ActiveLink {
            number: 0,
            track: 0,
            ends: [Some(0), None],
            sections: [0; 2],
            placed: link.placed(),
            phase: link.device.initial(&motion),
            evolving: None,
        };
        let bases = model.bodies.iter().map(Body::placed).collect();
        let members = Members { bodies: vec![0], bases, active: Vec::new(), links: vec![active] };
        let y = vec![0.0, 0.0, 0.0, SPEED, 0.0, 0.0];
        let island = Island::new(&model, vec![0], members, Vec::new(), y, 0.0, ControllerState::default());
        (model, island)
    }

    /// Plans steps until a phase ends, at most for 0.1 s.
    fn first_end(model: &Model, island: &mut Island) -> Option<(f64, usize)> {
        while island.step.until < 0.1 {
            island.plan(model, 0.1, f64::INFINITY).expect("a step that can be made");
            if let Some((t, due)) = first_phase_end(model, island) {
                return Some((t, due.switch));
            }
        }
        None
    }

    fn stopper(failure: Failure) -> Arc<dyn Device> {
        Arc::new(Stopper { gap: 0.0, stiffness: STIFFNESS, failure })
    }

    fn omega() -> f64 {
        (STIFFNESS / MASS).sqrt()
    }

    #[test]
    fn a_stopper_opens_after_half_a_period() {
        for kinematics in [Kinematics::Points, Kinematics::Linear, Kinematics::Carried] {
            let (model, mut island) = driven(stopper(Failure::Never), kinematics, DVec3::ZERO);
            let (t, switch) = first_end(&model, &mut island).expect("it opens");
            assert_eq!(switch, 0);
            let phase = omega() * t;
            assert!((phase - std::f64::consts::PI).abs() < 1e-9, "{kinematics:?}: at {phase} rad");
        }
    }

    #[test]
    fn a_stopper_breaks_where_its_spring_has_its_strength() {
        let strength = 0.6 * SPEED / omega() * STIFFNESS;
        let (model, mut island) =
            driven(stopper(Failure::Brittle { force: strength }), Kinematics::Points, DVec3::ZERO);
        let (t, switch) = first_end(&model, &mut island).expect("it breaks");
        assert_eq!(switch, 1);
        // K (v/ω) sin ωt = 0.6 K v/ω.
        assert!((omega() * t - 0.6_f64.asin()).abs() < 1e-9, "breaks at {} rad", omega() * t);
    }

    #[test]
    fn a_cable_in_yield_turns_elastic_where_its_points_no_longer_part() {
        // As long as 1 m, drawn out up to its yield as placed: it pulls with T_y + K₂ x.
        let yielding = Some(Yielding { force: 100.0, stiffness: 0.25 * STIFFNESS });
        let slack = -100.0 / STIFFNESS;
        let cable = Restrainer { length: 1.0, slack, stiffness: STIFFNESS, yielding, break_elongation: 1.0 };
        let (model, mut island) = driven(Arc::new(cable), Kinematics::Points, DVec3::NEG_X);
        let (t, switch) = first_end(&model, &mut island).expect("it turns back");
        assert_eq!(switch, 1);
        // x = −x_s + x_s cos ω₂t + (v/ω₂) sin ω₂t with x_s = T_y/K₂: at rest at tan ω₂t = v/(ω₂ x_s).
        let slow = 0.5 * omega();
        let phase = (SPEED / (slow * 100.0 / (0.25 * STIFFNESS))).atan();
        assert!((slow * t - phase).abs() < 1e-8, "at {} rad, not at {phase}", slow * t);
    }

    #[test]
    fn a_device_without_an_event_ends_no_phase() {
        let endless = Failure::Ductile { force: 1e9, displacement: f64::INFINITY };
        let stopper = Stopper { gap: -10.0, stiffness: 1e-3, failure: endless };
        let (model, mut island) = driven(Arc::new(stopper), Kinematics::Points, DVec3::ZERO);
        assert_eq!(first_end(&model, &mut island), None, "pressed in by 10 m at first");
    }

    #[test]
    fn no_point_departs_farther_within_a_step_than_its_excursion() {
        let (model, mut island) = driven(stopper(Failure::Never), Kinematics::Points, DVec3::ZERO);
        island.plan(&model, 0.1, f64::INFINITY).expect("a step");
        let active = &island.system.links[0];
        let within = excursion(&model, &island, active);
        let [from, until] = [island.step.from, island.step.until];
        let at = |t: f64| active.motion(&model, &island.system.bases, &island.frames_since(&model, &[t])).0;
        let begins = at(from);
        for part in [0.1, 0.35, 0.6, 0.85, 1.0] {
            let motion = at(from + part * (until - from));
            assert!((motion.moved - begins.moved).length() <= within.way, "{part} of the step");
            assert!((motion.rate - begins.rate).length() <= within.rate, "{part} of the step");
        }
        let longest = within.way / (SPEED * (until - from));
        assert!(longest < 2.0, "{longest} times the way at the initial speed");
    }

    #[test]
    fn what_rounds_grows_with_the_link_and_its_motion() {
        let (model, _) = driven(stopper(Failure::Never), Kinematics::Points, DVec3::ZERO);
        let link = &model.links[0];
        assert_eq!(link.size(), 0.0, "its points coincide at G");
        let phase = Phase { branch: 1, ..Phase::default() };
        let at = |x: f64, rate: f64| Separation { moved: DVec3::X * x, rate: DVec3::X * rate, ..Separation::default() };
        let motions = [at(0.2, 0.1), at(-0.3, -4.0)];
        // 16 units of round-off of 0.3 m moved and a gap of 0.3 m.
        let SwitchRoundoff { zero, band, .. } = switch_roundoff(link, (0, &phase), &motions, 7.0);
        let rounding = 16.0 * f64::EPSILON * 0.6;
        assert!((band / rounding - 1.0).abs() < 1e-12, "{band} m");
        assert!((zero / (1e-10 * 0.3 + rounding) - 1.0).abs() < 1e-12, "{zero} m");
        // In yield the first one is a speed: of 4 m/s, and of 0.3 m at 7 rad/s.
        let yielding = Phase { branch: 2, ..phase };
        let SwitchRoundoff { zero, band, .. } = switch_roundoff(link, (0, &yielding), &motions, 7.0);
        assert_eq!(band, 0.0);
        assert!((zero / (4e-10 + 16.0 * f64::EPSILON * 0.3 * 7.0) - 1.0).abs() < 1e-12, "{zero} m/s");
    }
}
