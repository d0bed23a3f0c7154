//! A failing scene made small: whatever can go while the same check still fails, goes.

use super::check::Check;
use super::examine::{Outcome, examine};
use super::random::three_digits;
use super::watch::{Clock, Limits, Watch};
use crate::scene::{Bearings, Initial, Motion, Push, Scene};

/// Examinations that one shrinking may take.
const MOST: usize = 120;
/// Time of a whole shrinking, in time limits of one examination \[–\].
const PATIENCES: f64 = 1.0;

/// One way to make a scene smaller; the same scene where there is nothing left to do.
type Step = fn(&Scene) -> Scene;

/// In order: what takes most away first.
const STEPS: &[Step] = &[
    without_last_girder,
    without_first_girder,
    without_last_abutment,
    shorter,
    still,
    without_push,
    without_start,
    without_spin,
    smooth,
    without_restitution,
    undamped,
    straight,
    round,
];

/// The smallest scene found that fails in the same check.
pub(super) fn shrink(scene: &Scene, check: Check, clock: Clock<'_>, limits: Limits) -> Scene {
    let watch = Watch::new(clock, PATIENCES * limits.patience);
    let mut left = MOST;
    smallest(scene, |smaller| {
        let go_on = left > 0 && !watch.is_over();
        left = left.saturating_sub(1);
        go_on && fails(smaller, check, clock, limits)
    })
}

/// Takes away whatever can go while it still fails.
fn smallest(scene: &Scene, mut still_fails: impl FnMut(&Scene) -> bool) -> Scene {
    let mut small = scene.clone();
    loop {
        let before = small.clone();
        for step in STEPS {
            loop {
                let smaller = step(&small);
                if smaller == small || !still_fails(&smaller) {
                    break;
                }
                small = smaller;
            }
        }
        if small == before {
            return small;
        }
    }
}

fn fails(scene: &Scene, check: Check, clock: Clock<'_>, limits: Limits) -> bool {
    match examine(scene, clock, limits).outcome {
        Outcome::Failed(complaints) => complaints.iter().any(|c| c.check == check),
        _ => false,
    }
}

fn changed(scene: &Scene, change: impl FnOnce(&mut Scene)) -> Scene {
    let mut scene = scene.clone();
    change(&mut scene);
    scene
}

fn without_girder(scene: &Scene, number: usize) -> Scene {
    if scene.girders.len() < 2 {
        return scene.clone();
    }
    changed(scene, |s| {
        let gone = s.girders.remove(number).name;
        s.abutments.retain(|a| a.faces != gone);
        s.contact.pairs.retain(|p| !p.between.contains(&gone));
    })
}

fn without_last_girder(scene: &Scene) -> Scene {
    without_girder(scene, scene.girders.len().saturating_sub(1))
}

fn without_first_girder(scene: &Scene) -> Scene {
    without_girder(scene, 0)
}

fn without_last_abutment(scene: &Scene) -> Scene {
    changed(scene, |s| {
        s.abutments.pop();
    })
}

fn shorter(scene: &Scene) -> Scene {
    changed(scene, |s| s.duration = three_digits(s.duration * 0.6))
}

fn still(scene: &Scene) -> Scene {
    changed(scene, |s| s.motion = Motion::None)
}

fn without_push(scene: &Scene) -> Scene {
    changed(scene, |s| s.girders.iter_mut().for_each(|g| g.push = Push::default()))
}

fn without_start(scene: &Scene) -> Scene {
    changed(scene, |s| s.girders.iter_mut().for_each(|g| g.initial = Initial::default()))
}

fn without_spin(scene: &Scene) -> Scene {
    changed(scene, |s| s.girders.iter_mut().for_each(|g| g.initial.spin_deg_s = 0.0))
}

fn smooth(scene: &Scene) -> Scene {
    changed(scene, |s| (s.contact.mu_static, s.contact.mu_kinetic) = (0.0, 0.0))
}

fn without_restitution(scene: &Scene) -> Scene {
    changed(scene, |s| (s.contact.restitution_normal, s.contact.restitution_tangential) = (1.0, 1.0))
}

fn undamped(scene: &Scene) -> Scene {
    changed(scene, |s| {
        for girder in &mut s.girders {
            match &mut girder.bearings {
                Some(Bearings::Shared(shared)) => shared.damping_ratio = crate::scene::PerDirection::Both(0.0),
                Some(Bearings::Deck(deck)) => deck.damping_ratio = None,
                Some(Bearings::Each(each)) => each.iter_mut().for_each(|b| b.damping = [0.0; 3]),
                None => {}
            }
        }
    })
}

fn straight(scene: &Scene) -> Scene {
    changed(scene, |s| s.girders.iter_mut().for_each(|g| g.skew_deg = 90.0))
}

fn round(scene: &Scene) -> Scene {
    let one = |x: f64| format!("{x:.0e}").parse().unwrap_or(x);
    changed(scene, |s| {
        s.contact.stiffness = s.contact.stiffness.map(one);
        for girder in &mut s.girders {
            girder.mass = one(girder.mass);
        }
        if let Motion::Sine(sine) = &mut s.motion {
            sine.amplitude = sine.amplitude.map(one);
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::stability::family;

    #[test]
    fn what_a_failure_does_not_need_is_taken_away() {
        let (_, scene) = family::scene(16);
        assert!(scene.girders.len() > 1 && scene.contact.mu_static > 0.0, "it has something to lose: {scene:?}");
        let long = 0.1 * scene.duration;
        let small = smallest(&scene, |s| s.contact.mu_static > 0.0 && s.duration > long);
        assert_eq!((small.girders.len(), small.abutments.len()), (1, 0), "one girder is left, and no wall");
        assert_eq!(small.motion, Motion::None, "nothing shakes");
        assert!(small.contact.mu_static == scene.contact.mu_static, "what the failure needs stays");
        assert!(small.duration > long && small.duration < 2.0 * long, "it is short: {}", small.duration);
    }
}
