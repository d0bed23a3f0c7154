//! Two runs of the same bodies side by side: how far apart their motions are, and until when they can be compared.

use rayon::prelude::*;

use super::report::RunDifference;
use super::{Cause, History, Motion};

/// Instants at which two runs are compared.
const COMPARED: u32 = 2000;
/// Bodies that are compared side by side at all instants before the next ones are. Neighbours of an island share the steps that
/// are recomputed; paths and caches of so few stay in the processor's own memory.
const COMPARED_TOGETHER: usize = 16;

/// Two runs of the same bodies.
#[derive(Clone, Copy, Debug)]
pub struct Comparison<'a> {
    /// The run whose differences are asked for.
    pub one: &'a History,
    /// The run that it is compared with.
    pub other: &'a History,
}

impl<'a> Comparison<'a> {
    /// One run against another.
    pub const fn of(one: &'a History, other: &'a History) -> Self {
        Self { one, other }
    }

    /// Largest differences of all bodies.
    pub fn of_all(self) -> RunDifference {
        let [one, other] = [self.one, self.other].map(|run| run.model().bodies.len());
        self.of_first(one.min(other))
    }

    /// Largest differences of the girders, by their numbers, as far as both runs have them.
    pub fn of_girders(self) -> RunDifference {
        self.of_first(self.girders_of_both())
    }

    fn girders_of_both(self) -> usize {
        let [one, other] = [self.one, self.other].map(|run| run.model().girders().len());
        one.min(other)
    }

    /// Difference of the girders' motions at `t` \[s\].
    pub fn of_girders_at(self, t: f64) -> RunDifference {
        (0..self.girders_of_both()).map(|body| self.at(body, t)).fold(RunDifference::default(), RunDifference::larger)
    }

    /// Largest differences of the first so many bodies, at evenly spaced instants.
    fn of_first(self, bodies: usize) -> RunDifference {
        let end = self.one.end().min(self.other.end());
        let of_some = |some: usize| {
            let first = some * COMPARED_TOGETHER;
            let instants = (0..=COMPARED).map(|i| end * f64::from(i) / f64::from(COMPARED));
            let own = |t| (first..bodies.min(first + COMPARED_TOGETHER)).map(move |body| self.at(body, t));
            instants.flat_map(own).fold(RunDifference::default(), RunDifference::larger)
        };
        (0..bodies.div_ceil(COMPARED_TOGETHER))
            .into_par_iter()
            .map(of_some)
            .reduce(RunDifference::default, RunDifference::larger)
    }

    /// Difference of a body's motions at `t` \[s\].
    fn at(self, body: usize, t: f64) -> RunDifference {
        let [one, two] = [self.one, self.other].map(|run| Motion::of(run.model(), body, &run.state(body, t)));
        // |q₁ − q₂| = 2 sin(α/4) for a rotation by α between them; q and −q are one attitude.
        let apart = (one.attitude - two.attitude).length().min((one.attitude + two.attitude).length());
        RunDifference {
            place: (one.displacement - two.displacement).length(),
            turn: 4.0 * (0.5 * apart).min(1.0).asin(),
        }
    }

    /// Until when the one run was computed \[s\], where its computation gave up before the other ends.
    pub(super) fn ends_before(self) -> Option<f64> {
        let stop = self.one.stop().filter(|stop| stop.cause == Cause::Computation)?;
        (stop.t < self.other.end()).then_some(stop.t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::scene::{format, presets};
    use crate::sim::Session;

    /// A girder that flies along X at a speed and turns at a rate \[m/s, °/s\].
    fn flying(speed: f64, spin: f64) -> History {
        let text = format!(
            "name = \"flight\"\nduration_s = 2.0\n[[girder]]\nname = \"deck\"\nlength_m = 10.0\nwidth_m = 3.0\n\
             thickness_m = 1.0\nmass_kg = 2e4\n\
             initial = {{ velocity_m_s = [{speed:?}, 0.0], spin_deg_s = {spin:?} }}\n"
        );
        History::of(&format::parse(&text, "flight").expect("a scene")).expect("runs")
    }

    #[test]
    fn two_flights_part_by_their_speeds() {
        let [slow, fast] = [flying(1.0, 0.0), flying(1.5, 3.0)];
        let apart = Comparison::of(&slow, &fast);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        let [half, whole] = [apart.of_girders_at(1.0), apart.of_girders()];
        assert!(near(half.place, 0.5) && near(half.turn, 3f64.to_radians()), "{half:?}");
        assert!(near(whole.place, 1.0) && near(whole.turn, 6f64.to_radians()), "{whole:?}");
        assert_eq!(apart.of_all(), whole, "no bodies but girders");
        assert_eq!(Comparison::of(&fast, &fast).of_all(), RunDifference::default());
    }

    #[test]
    fn a_run_that_gives_up_is_no_measure_of_what_comes_after() {
        let mut scene = presets::load("deck-30m").expect("a preset");
        scene.duration = 12.0;
        let whole = History::of(&scene).expect("a scene");
        // Memory is looked at every few thousand steps.
        let bounded = Model { memory_bytes: 1 << 16, ..Model::compile(&scene).expect("a scene") };
        let mut session = Session::of_model(&scene, bounded);
        session.advance(scene.duration, &mut |_| true);
        let stopped = session.finish();
        let ends_before = |one: &History, other: &History| Comparison::of(one, other).ends_before();
        let until = ends_before(&stopped, &whole);
        assert!(until.is_some_and(|t| 0.0 < t && t == stopped.end() && t < 12.0), "{until:?}");
        assert_eq!((ends_before(&whole, &stopped), ends_before(&whole, &whole)), (None, None));
    }
}
