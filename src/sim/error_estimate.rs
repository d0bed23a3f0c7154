//! The estimated error of a run: its difference from a run at a hundredth of the tolerance whose steps are at most half the intervals of a
//! record. Steps end at every sample; where the tolerance asks for none that is shorter, both runs would have the same steps.

use super::readings::Extreme;
use super::{Comparison, History, RunDifference, Session};
use crate::scene::{FINEST_TOLERANCE, ModelKind};

/// Times by which the tolerance of the run that is compared is smaller \[–\]: its own error is then about a hundredth of the difference.
const FINER: f64 = 100.0;
/// Times by which it is larger where there is none that is smaller \[–\].
const COARSER: f64 = 10.0;

/// Tolerance up to which section forces are not looked at anew \[–\]. Measured: from 1e-10 to 1e-12 the largest stress of a deck with one end
/// on a pier and of one with every device changes by less than 4e-8 of itself, from 1e-6 by up to 9e-5.
const SECTIONS_KNOWN: f64 = 1e-9;

/// Phase of a girder's fastest mode from an instant to either side of it, between which a jump is looked for \[rad\]. Chosen.
const JUMP_PHASE: f64 = 5e-3;
/// Change between the two sides, in parts of the largest value, that is a jump \[–\]: a mode changes by twice [`JUMP_PHASE`] of its amplitude
/// at most. Chosen: twice that.
const JUMP: f64 = 0.02;

/// Part of the largest fibre stress from which on a section force at mid-span counts by itself \[–\]. Chosen.
const STRESS_SHARE: f64 = 0.1;

/// The estimated error of displacements and attitudes, and until when it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorEstimate {
    /// Largest difference in displacement of G from the finer run \[m\]; NaN where there is none.
    pub error: f64,
    /// Largest difference in attitude \[rad\].
    pub rotation: f64,
    /// Largest difference of the fibre stress of a girder that bends, and of N, M and `M_y` at mid-span that make a tenth of it, where and
    /// when each is largest, in parts of it \[–\]; `None` where no girder bends, or at tolerances up to 1e-9.
    pub stress: Option<f64>,
    /// End of the comparison, where the finer run stopped before the end of this one \[s\].
    pub until: Option<f64>,
}

impl ErrorEstimate {
    /// Of a run without a finer one to compare it with.
    pub const UNKNOWN: Self = Self { error: f64::NAN, rotation: f64::NAN, stress: None, until: None };

    /// Largest differences in displacement and attitude of a run from one at a hundredth of the tolerance.
    pub fn of(run: &History) -> Self {
        let mut finer = run.scene().clone();
        finer.model.kind = if run.impact().is_some() { ModelKind::Impact } else { ModelKind::Contact };
        finer.solver.tolerance = (run.scene().solver.tolerance / FINER).max(FINEST_TOLERANCE);
        if run.scene().solver.tolerance <= FINEST_TOLERANCE {
            // There is no finer tolerance: the difference from a run at ten times as much estimates the error of that run.
            finer.solver.tolerance = COARSER * FINEST_TOLERANCE;
        }
        // The scene has been run before: it has no complaint.
        let Ok(session) = Session::for_comparison(&finer, run.model().bodies_met()) else {
            return Self::UNKNOWN;
        };
        let finer = session.complete();
        let comparison = Comparison::of(run, &finer);
        let RunDifference { place: error, turn: rotation } = comparison.of_all();
        let until = Comparison::of(&finer, run).ends_before();
        Self { error, rotation, stress: comparison.of_stress(), until }
    }

    /// The error where it is one of the whole run.
    pub fn of_whole(self) -> Option<Self> {
        self.until.is_none().then_some(self)
    }
}

impl Comparison<'_> {
    /// Largest difference of what is largest in a girder's sections, in parts of it. Section forces follow from accelerations, in which errors
    /// of the modes count by the square of their frequencies: they can be noise where displacements are right to nanometres.
    fn of_stress(self) -> Option<f64> {
        if self.one.scene().solver.tolerance <= SECTIONS_KNOWN {
            return None;
        }
        let (run, finer) = (self.one, self.other);
        let of_girder = |girder: usize| {
            let (forces, (stress, station)) = run.sections().largest(girder)?;
            let fibre = self
                .apart_from(girder, stress, &|t| finer.sections().stress(girder, station, t.clamp(0.0, finer.end())));
            let at_mid_span = forces.into_iter().filter_map(|(most, of, alone)| {
                let counts = run.sections().fibre_stress(girder, &alone(most.value)) > STRESS_SHARE * stress.value;
                let there = |t: f64| of(&finer.sections().forces(girder, 0.0, t.clamp(0.0, finer.end()))).abs();
                counts.then(|| self.apart_from(girder, most, &there))
            });
            (stress.value > 0.0).then(|| at_mid_span.fold(fibre, f64::max))
        };
        (0..run.model().girders().len()).filter_map(of_girder).reduce(f64::max)
    }

    /// Difference of a largest value from what is `there` in the other run at its time, in parts of it \[–\]. A dashpot's force jumps where a
    /// contact opens, at an instant that differs between the runs: either side of it counts.
    fn apart_from(self, girder: usize, most: Extreme, there: &dyn Fn(f64) -> f64) -> f64 {
        let apart = |value: f64| (value - most.value).abs() / most.value;
        let beside = JUMP_PHASE / self.one.model().bodies[girder].fastest();
        let sides = [there(most.t - beside), there(most.t + beside)].map(apart);
        let here = apart(there(most.t));
        if (sides[0] - sides[1]).abs() > JUMP { sides.into_iter().fold(here, f64::min) } else { here }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::format;

    /// A deck that shakes on bearings of which two stand on a pier: at 1e-4 the noise of its fastest modes is as large as its stress, and
    /// the displacement right to a nanometre.
    #[test]
    fn section_forces_err_where_displacements_do_not() {
        let text = |tolerance: f64| {
            let bearing = |at: &str, on: &str| {
                format!(
                    "{{ at_m = {at}, stiffness_n_per_m = [2e7, 1e7, 6e8], damping_n_s_per_m = [1e5, 2e5, 1e6]{on} }}"
                )
            };
            let pier = ", on = \"p\"";
            let bearings = [("[-12.0, -3.0]", pier), ("[-12.5, 3.0]", pier), ("[13.0, -2.5]", ""), ("[13.0, 3.5]", "")];
            let bearings: Vec<String> = bearings.iter().map(|(at, on)| bearing(at, on)).collect();
            format!(
                "name = \"pier\"\nkind = \"spatial\"\nduration_s = 0.1\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 8.0\n\
                 thickness_m = 1.2\nskew_deg = 60.0\nmass_kg = 4e5\nbearings = [{}]\n\
                 elastic = {{ young_modulus_pa = 3e10, area_m2 = 5.0, damping_ratio = 0.02, modes = 6 }}\n\
                 initial = {{ velocity_m_s = [0.3, 0.2, 0.0] }}\n[solver]\ntolerance = {tolerance:e}\n[[pier]]\nname = \"p\"\n\
                 mass_kg = 1.2e5\nposition_m = [-12.2, 0.1]\nheading_deg = 20.0\nstiffness_n_per_m = [8e7, 1.2e8]\n\
                 damping_ratio = [0.03, 0.06]\nturn_stiffness_n_m_per_rad = 2e9\nturn_inertia_kg_m2 = 8e5\nheight_m = 8.0\n",
                bearings.join(", ")
            )
        };
        let [coarse, fine] = [1e-4, 1e-10].map(|tolerance| {
            let scene = format::parse(&text(tolerance), "pier").unwrap_or_else(|errors| panic!("{errors}"));
            History::of(&scene).expect("runs")
        });
        let estimate = ErrorEstimate::of(&coarse);
        let [(rough, _), (right, _)] =
            [&coarse, &fine].map(|history| history.sections().largest(0).expect("it bends").1);
        let off = (rough.value - right.value) / rough.value;
        assert!(estimate.error < 1e-8 && off > 0.1, "{estimate:?}, {off} of the stress");
        let told = estimate.stress.expect("it bends");
        assert!(told > 0.5 * off, "{told} is told where it is {off}");
        assert_eq!(ErrorEstimate::of(&fine).stress, None, "at a fine tolerance it is known");
    }

    /// At 1e-4 every step is as long as an interval of the record, at 1e-6 as well.
    #[test]
    fn steps_that_end_at_samples_at_every_tolerance_are_compared_with_shorter_ones() {
        let [rough, finest] = [1e-4, 1e-11].map(|tolerance| {
            let mut scene = crate::scene::presets::load("viaduct-5").expect("ships");
            (scene.duration, scene.solver.tolerance) = (6.0, tolerance);
            History::of(&scene).expect("runs")
        });
        let off = Comparison::of(&rough, &finest).of_all().place;
        let told = ErrorEstimate::of(&rough).error;
        assert!(off > 1e-13 && (0.5 * off..3.0 * off).contains(&told), "{told} m is told where it is {off} m");
    }

    #[test]
    fn a_girder_that_only_tumbles_errs_in_its_attitude() {
        let scene = format::parse(
            "name = \"spin\"\nkind = \"spatial\"\nduration_s = 2.0\ngravity_m_s2 = 0.0\n[[girder]]\nname = \"deck\"\n\
             length_m = 10.0\nwidth_m = 3.0\nthickness_m = 1.0\nmass_kg = 2e4\n\
             initial = { spin_deg_s = 1.0, roll_deg_s = 2.0, pitch_deg_s = 600.0 }\n[solver]\ntolerance = 1e-6\n",
            "spin",
        );
        let (rough, mut finest) = (scene.clone().expect("a scene"), scene.expect("a scene"));
        finest.solver.tolerance = 1e-12;
        let [rough, finest] = [rough, finest].map(|scene| History::of(&scene).expect("runs"));
        let corner = |run: &History, t| run.motion(0, t).attitude * glam::DVec3::new(5.0, 1.5, 0.5);
        let times = (0..=100).map(|i| 0.02 * f64::from(i));
        let off = times.map(|t| (corner(&rough, t) - corner(&finest, t)).length()).fold(0.0, f64::max);
        let ErrorEstimate { error, rotation, .. } = ErrorEstimate::of(&rough);
        let told = error + rough.model().bodies[0].radius * rotation;
        assert!(off > 1e-8, "it errs: {off} m");
        assert!((off..4.0 * off).contains(&told), "a corner is {off} m off, told {error} m and {rotation} rad");
    }

    #[test]
    fn an_estimate_up_to_a_stop_is_none_of_the_whole_run() {
        let whole = ErrorEstimate { error: 1e-9, rotation: 1e-10, stress: None, until: None };
        assert_eq!(whole.of_whole(), Some(whole));
        assert_eq!(ErrorEstimate { until: Some(0.5), ..whole }.of_whole(), None);
    }
}
