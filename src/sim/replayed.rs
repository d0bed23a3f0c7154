//! Cache of the last recomputed steps: readings at several instants of one step follow one another.

use std::sync::{Mutex, PoisonError};

use crate::dynamics::record::recomputed_steps::{Past, Replay};
use crate::dynamics::trajectory::step_polynomial::StepPolynomial;

/// Steps in the cache \[–\]: those of both sides of a contact and of their neighbours. Chosen.
const CACHED_STEPS: usize = 4;

/// Steps of a group that are stored by their initial states, with a cache of the last recomputed ones.
#[derive(Debug, Default)]
pub(super) struct Replayed {
    replay: Replay,
    /// The last used last.
    recent: Mutex<Vec<(u32, Vec<StepPolynomial>)>>,
}

impl Clone for Replayed {
    fn clone(&self) -> Self {
        Self::of(self.replay.clone())
    }
}

impl Replayed {
    pub(super) fn of(replay: Replay) -> Self {
        Self { replay, recent: Mutex::default() }
    }

    /// A body's part of the answer of step `number`, which begins at `from`, as `read` takes it.
    pub(super) fn with<T>(
        &self,
        (number, from): (u32, f64),
        body: usize,
        past: &Past<'_>,
        read: impl FnOnce(&StepPolynomial) -> T,
    ) -> T {
        let place = self.replay.bodies(number).position(|b| b == body).unwrap_or(0);
        // After a panic elsewhere the cache still holds whole steps.
        let mut recent = self.recent.lock().unwrap_or_else(PoisonError::into_inner);
        let found = recent.iter().position(|(known, _)| *known == number);
        let step = match found {
            Some(at) => recent.remove(at),
            None => (number, self.replay.step(number, from, past)),
        };
        let answer = read(&step.1[place]);
        if recent.len() == CACHED_STEPS {
            recent.remove(0);
        }
        recent.push(step);
        answer
    }

    /// What it takes, without the steps taken again \[bytes\].
    pub(super) fn bytes(&self) -> usize {
        self.replay.bytes()
    }

    /// How many steps are kept by their starts.
    #[cfg(test)]
    pub(super) fn len(&self) -> usize {
        self.replay.len()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
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
        model.polynomials = polynomials;
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
            let counts = [&whole, &part, &none].map(|history| history.replayed[0].len());
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
            assert_eq!(whole.ledger(whole.end()), none.ledger(whole.end()), "the books, too");
        }
    }

    /// A free deck that is shaken against its abutments.
    fn deck(polynomials: usize) -> History {
        computed(presets::load("deck-30m").expect("a preset"), polynomials)
    }

    #[test]
    fn a_spatial_step_taken_again_is_the_same_to_the_last_bit() {
        let (whole, none) = (deck(usize::MAX), deck(0));
        let (kept, steps) = (none.replayed[0].len(), usize::try_from(whole.effort().steps).expect("few"));
        assert!(kept > steps / 8, "those without sliding: {kept} of {steps}");
        assert_eq!(whole.digest(), none.digest());
        for i in 0..=1000 {
            let t = whole.end() * f64::from(i) / 1000.0;
            let bits = |history: &History| history.state(0, t).into_iter().map(f64::to_bits).collect::<Vec<_>>();
            assert_eq!(bits(&whole), bits(&none), "at {t}");
            let angle = |history: &History| history.motion(0, t).theta.to_bits();
            assert_eq!(angle(&whole), angle(&none), "the angle at {t}");
        }
        assert_eq!(whole.ledger(whole.end()), none.ledger(whole.end()), "the books, too");
        assert!(none.bytes() < whole.bytes(), "{} against {} bytes", none.bytes(), whole.bytes());
    }

    #[test]
    fn a_start_takes_a_fraction_of_a_polynomial() {
        // Head-on a girder moves along one axis: two numbers of its state, sixteen of its polynomial.
        for (angle, most) in [(0.0, 72.0), (20.0, 110.0)] {
            let (whole, none) = (row(angle, usize::MAX), row(angle, 0));
            let stretches: usize =
                none.paths.iter().map(crate::dynamics::trajectory::stored_path::StoredPath::len).sum();
            let each = |history: &History| {
                let kept = history
                    .paths
                    .iter()
                    .map(crate::dynamics::trajectory::stored_path::StoredPath::bytes)
                    .sum::<usize>();
                (kept + history.replayed.iter().map(Replayed::bytes).sum::<usize>()) as f64 / stretches as f64
            };
            assert!(each(&none) < most, "{} bytes a stretch at {angle}°", each(&none));
            assert!(2.0 * each(&none) < each(&whole), "{} against {}", each(&none), each(&whole));
        }
    }
}
