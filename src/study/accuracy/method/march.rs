//! The loop of every method that takes equal steps.

use super::interface::{Job, Work};
use super::world::World;
use crate::study::accuracy::Answer;
use crate::study::accuracy::answer::INTERVALS;

/// Displacements beyond this have diverged \[m\].
const FAR: f64 = 1e6;

/// A scheme that takes one step of `h` from `t`, in `world.y`.
pub(super) trait Scheme {
    /// Sets up for a world.
    fn new(world: &mut World) -> Self;

    /// Takes a step.
    fn step(&mut self, world: &mut World, t: f64, h: f64);

    /// Note at the end.
    fn note(&self) -> String {
        String::new()
    }
}

/// Steps through a scene, `job.setting` steps to an interval of comparison.
pub(super) fn march<S: Scheme>(job: &Job<'_>) -> Result<Work, String> {
    let mut world = World::new(job.scene)?;
    let mut scheme = S::new(&mut world);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count, at least 1")]
    let per_interval = job.setting.max(1.0) as usize;
    let h = job.instants.until / (INTERVALS * per_interval) as f64;
    let mut places = world.places(&world.y);
    for interval in 0..INTERVALS {
        for k in 0..per_interval {
            let t = (interval * per_interval + k) as f64 * h;
            scheme.step(&mut world, t, h);
            world.settle();
        }
        if !world.y.iter().all(|y| y.abs() < FAR) {
            return Err(format!("diverged by {:.3} s at a step of {h:.3e} s", job.instants.at(interval + 1)));
        }
        places.extend(world.places(&world.y));
    }
    Ok(Work::Sampled(Answer {
        places,
        bodies: world.model.bodies.len(),
        peak_force: world.peak_force(),
        steps: INTERVALS * per_interval,
        note: scheme.note(),
    }))
}
