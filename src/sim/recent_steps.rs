//! Cache of a body's last recomputed steps: readings at several instants of one step follow one another.

use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::dynamics::trajectory::step_polynomial::StepPolynomial;

/// Steps in the cache of a body \[–\]: those on both sides of an event.
const CACHED_STEPS: usize = 2;

/// The body's part of the steps that were recomputed last, by number.
#[derive(Debug, Default)]
pub(super) struct RecentSteps {
    /// The last used last.
    steps: Mutex<Vec<(u32, StepPolynomial)>>,
}

impl Clone for RecentSteps {
    /// An empty cache: what it held is recomputed to the same bits.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl RecentSteps {
    fn lock(&self) -> MutexGuard<'_, Vec<(u32, StepPolynomial)>> {
        // After a panic elsewhere the cache still holds whole steps.
        self.steps.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Step `number` out of the cache, `None` where it is not there.
    pub(super) fn take(&self, number: u32) -> Option<StepPolynomial> {
        let mut steps = self.lock();
        let at = steps.iter().position(|(known, _)| *known == number)?;
        Some(steps.remove(at).1)
    }

    /// Keeps step `number`, where the cache is full in place of the one that was not used for longest.
    pub(super) fn keep(&self, number: u32, step: StepPolynomial) {
        let mut steps = self.lock();
        // Another reader, or one of another body of the step, may have brought it meanwhile.
        steps.retain(|(known, _)| *known != number);
        if steps.len() == CACHED_STEPS {
            steps.remove(0);
        }
        steps.push((number, step));
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use crate::dynamics::record::recomputed_steps::RecomputedSteps;
    use crate::dynamics::trajectory::stored_path::StoredPath;
    use crate::dynamics::{Model, run};
    use crate::scene::{Motion, Scene, presets};
    use crate::sim::History;

    /// A row of five girders, shaken at `angle_deg`, kept as polynomials up to so many bytes.
    fn row(angle_deg: f64, polynomials: usize) -> History {
        let mut scene: Scene = presets::load("row-of-5").expect("a preset");
        if let Motion::Sine(sine) = &mut scene.motion {
            sine.angle_deg = angle_deg;
        }
        computed(scene, polynomials)
    }

    fn computed(scene: Scene, polynomials: usize) -> History {
        let mut model = Model::compile(&scene).expect("a scene");
        model.polynomial_bytes = polynomials;
        let model = Arc::new(model);
        let kind = scene.model.kind;
        let groups = (0..model.groups.len()).map(|group| {
            let mut engine = run::start(&model, group, kind);
            engine.advance(model.duration);
            engine.finish()
        });
        History::gather(scene, Arc::clone(&model), groups.collect())
    }

    #[test]
    fn a_step_taken_again_is_the_same_to_the_last_bit() {
        for angle in [0.0, 20.0] {
            let (whole, part, none) = (row(angle, usize::MAX), row(angle, 10_000), row(angle, 0));
            let counts = [&whole, &part, &none].map(|history| history.trajectories.recomputed_steps()[0].len());
            let steps = usize::try_from(whole.effort().steps).expect("few");
            assert!(counts[0] == 0 && counts[1] > 0 && counts[2] > counts[1], "{counts:?} of {steps}");
            assert!(counts[2] + 8 > steps / 2, "most are explicit: {counts:?} of {steps}");
            assert_eq!(whole.digest(), part.digest(), "at {angle}°, some");
            assert_eq!(whole.digest(), none.digest(), "at {angle}°, all");
            for i in 0..=1000 {
                let t = whole.end() * f64::from(i) / 1000.0;
                let bits = |history: &History| history.state(0, t).into_iter().map(f64::to_bits).collect::<Vec<_>>();
                assert_eq!(bits(&whole), bits(&none), "at {t}");
            }
            assert_eq!(whole.energy().ledger(whole.end()), none.energy().ledger(whole.end()), "the integrals, too");
        }
    }

    /// A free deck that is shaken against its abutments.
    fn deck(polynomials: usize) -> History {
        computed(presets::load("deck-30m").expect("a preset"), polynomials)
    }

    #[test]
    fn a_spatial_step_taken_again_is_the_same_to_the_last_bit() {
        let (whole, none) = (deck(usize::MAX), deck(0));
        let (kept, steps) =
            (none.trajectories.recomputed_steps()[0].len(), usize::try_from(whole.effort().steps).expect("few"));
        assert!(kept > steps / 8, "those without sliding: {kept} of {steps}");
        assert_eq!(whole.digest(), none.digest());
        for i in 0..=1000 {
            let t = whole.end() * f64::from(i) / 1000.0;
            let bits = |history: &History| history.state(0, t).into_iter().map(f64::to_bits).collect::<Vec<_>>();
            assert_eq!(bits(&whole), bits(&none), "at {t}");
            let angle = |history: &History| history.motion(0, t).theta.to_bits();
            assert_eq!(angle(&whole), angle(&none), "the angle at {t}");
        }
        assert_eq!(whole.energy().ledger(whole.end()), none.energy().ledger(whole.end()), "the integrals, too");
        assert!(none.bytes() < whole.bytes(), "{} against {} bytes", none.bytes(), whole.bytes());
    }

    #[test]
    fn a_start_takes_a_fraction_of_a_polynomial() {
        // Head-on a girder moves along one axis: two numbers of its state, sixteen of its polynomial.
        for (angle, most) in [(0.0, 72.0), (20.0, 110.0)] {
            let (whole, none) = (row(angle, usize::MAX), row(angle, 0));
            let paths = |history: &History, of: &dyn Fn(&StoredPath) -> usize| -> usize {
                (0..history.model().bodies.len()).map(|body| of(history.trajectories.path(body))).sum()
            };
            let segments = paths(&none, &StoredPath::len);
            let each = |history: &History| {
                let recomputed =
                    history.trajectories.recomputed_steps().iter().map(RecomputedSteps::bytes).sum::<usize>();
                (paths(history, &StoredPath::bytes) + recomputed) as f64 / segments as f64
            };
            assert!(each(&none) < most, "{} bytes a segment at {angle}°", each(&none));
            assert!(2.0 * each(&none) < each(&whole), "{} against {}", each(&none), each(&whole));
        }
    }
}
