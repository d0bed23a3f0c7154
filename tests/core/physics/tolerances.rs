//! Devices whose laws change faster than the bodies move: no tolerance errs by far more than its neighbours.

use girderbench::sim::History;

use crate::support::{run, scene};

/// A girder on a bumper and one on flat sliders before an abutment, which pound, with what is between them.
fn pounding(between: &str, tolerance: f64) -> History {
    let at = "at_skewed_m = [[0.324, 0.121], [0.324, -0.121], [-0.324, 0.121], [-0.324, -0.121]]";
    let girder = |name: &str, x: f64, bearings: &str| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 0.721\nwidth_m = 0.346\nthickness_m = 0.0657\nskew_deg = 72.8\n\
             mass_kg = 64.3\nposition_m = [{x}, 0.0, 0.0]\nbearings = {{ {bearings}, {at} }}\n"
        )
    };
    let [one, other] = [
        girder("g0", 0.0, "frequency_hz = 1.41, damping_ratio = 0.0177"),
        girder(
            "g1",
            0.7332,
            "kind = \"pendulum\", friction = 0.0311, radius_m = 0.0, slider_displacement_m = 0.000845",
        ),
    ];
    let text = format!(
        "name = \"pounding\"\nduration_s = 1.73\n{one}{other}\
         [[abutment]]\nname = \"east\"\nfaces = \"g1\"\nend = \"+x\"\ngap_m = 0.0122\n\
         [[bumper]]\nname = \"rubber\"\ngirder = \"g0\"\nat_m = [-0.288, 0.0]\nto_m = [-0.576, 0.0]\nnormal = [1.0, 0.0]\n\
         gap_m = 0.00872\nstiffness_n_per_m = 334000.0\ndamping_n_s_per_m = 1890.0\n{between}\
         [contact]\nstiffness_n_per_m = 3710000.0\nrestitution_normal = 0.622\nrestitution_tangential = 0.977\n\
         mu_static = 0.645\nmu_kinetic = 0.529\nlaw = \"return-mapping\"\n\
         [motion]\nkind = \"sine\"\namplitude_g = 0.276\nfrequency_hz = 1.2\nangle_deg = 57.3\n\
         [solver]\ntolerance = {tolerance:e}\n"
    );
    run(&scene(&text))
}

const DAMPER: &str = "[[damper]]\nname = \"dashpot\"\ngirder = \"g0\"\nto = \"g1\"\nat_m = [0.288, 0.0414]\n\
                      to_m = [-0.288, 0.069]\ncoefficient = 9.45\nexponent = 0.3\nregularisation_speed_m_s = 0.0001\n";

/// Largest distance of the girders' places over the run from those of a run at a tolerance of 1e-13 \[m\].
fn worst(between: &str, tolerance: f64) -> f64 {
    let [run, exact] = [tolerance, 1e-13].map(|tolerance| pounding(between, tolerance));
    let apart = |i: u32, girder: usize| {
        let t = exact.end() * f64::from(i) / 80.0;
        (run.motion(girder, t).displacement - exact.motion(girder, t).displacement).length()
    };
    (0..=80).flat_map(|i| [0, 1].map(|girder| apart(i, girder))).fold(0.0, f64::max)
}

/// Sliders of a small displacement follow the direction of their velocity within milliseconds. A step of 0.05 s that an event cut
/// left 5e-8 m at the first of these tolerances, 5e-9 m at the second, 4e-11 to 6e-10 m at their neighbours.
#[test]
fn steps_follow_what_sliders_remember() {
    for tolerance in [3.73e-10, 1.39e-10] {
        let error = worst("", tolerance);
        assert!(error < 2e-9, "{error} m at {tolerance:e}");
    }
}

/// Where the rate of a damper of α < 1 passes through 0 its force turns over within 1e-4 m/s. Steps up to that zero left 1.8e-7 and
/// 8.6e-8 m at these tolerances, 3e-10 to 3e-9 m at their neighbours.
#[test]
fn steps_shorten_towards_the_zero_of_a_dampers_rate() {
    for tolerance in [4.16e-10, 5.18e-10] {
        let error = worst(DAMPER, tolerance);
        assert!(error < 1e-8, "{error} m at {tolerance:e}");
    }
}

/// A Hertz spring's force ends as δ^{3/2}: a step to 7 % beyond the opening left 1100 tolerances of the energy at the first of these, one to
/// nine at most of their neighbours.
#[test]
fn steps_do_not_go_over_the_opening_of_a_hertz_contact() {
    let text = |tolerance: f64| {
        format!(
            "name = \"hertz\"\nduration_s = 3.69\n[contact]\nstiffness_n_per_m = 439612362\nrestitution_normal = 1.0\n\
             restitution_tangential = 0.5\nmu_static = 0.3\nmu_kinetic = 0.2\nnormal_law = \"hertz-viscous\"\nlaw = \"return-mapping\"\n\
             [motion]\nkind = \"sine\"\namplitude_g = 0.424\nfrequency_hz = 0.46\nangle_deg = -24.0\n\
             [[girder]]\nname = \"g0\"\nlength_m = 28.2\nwidth_m = 9.0\nthickness_m = 1.8\nmass_kg = 537982.0\nafter_unseating = \"continue\"\n\
             bearings = {{ frequency_hz = 0.7, damping_ratio = 0.048, at_skewed_m = [[-12.69, -3.6], [-12.69, 3.6], [12.69, -3.6], \
             [12.69, 3.6]], on_minus_x = \"west\", on_plus_x = \"east\", travel_m = 0.089 }}\n\
             initial = {{ velocity_m_s = [0.163, 0.165], spin_deg_s = -1.6 }}\n\
             [[abutment]]\nname = \"west\"\nfaces = \"g0\"\nend = \"-x\"\ngap_m = 0.017\nground = \"copy\"\n\
             [[abutment]]\nname = \"east\"\nfaces = \"g0\"\nend = \"+x\"\ngap_m = 0.05\nwidth_m = 11.4833\noffset_m = 0.3501\nground = \"copy\"\n\
             [[ground]]\nname = \"copy\"\nkind = \"sine\"\namplitude_g = 0.424\nfrequency_hz = 0.46\nangle_deg = -24.0\n\
             [solver]\ntolerance = {tolerance:e}\n"
        )
    };
    for tolerance in [1e-10, 1.24519e-10, 3e-10] {
        let books = run(&scene(&text(tolerance))).energy().ledger(3.69);
        let parts = books.residual.abs() / (books.scale * tolerance);
        assert!(parts < 20.0, "{parts} tolerances of the energy at {tolerance:e}");
    }
}

/// A deck that bends with these words of its own, on bearings that yield or not, with what stands after it.
fn bending([words, after]: [&str; 2], yields: bool, tolerance: f64) -> History {
    let bearing = |[x, y]: [f64; 2], [k, l]: [f64; 2], kz: f64, force: f64| {
        let law =
            if yields { format!(", yield_force_n = {force}, yield_displacement_m = 0.008") } else { String::new() };
        format!(
            "{{ at_m = [{x}, {y}], stiffness_n_per_m = [{k}, {l}, {kz}], damping_n_s_per_m = [1e5, 2e5, 1e6]{law} }}"
        )
    };
    let bearings = [
        bearing([-12.0, -3.0], [2e7, 1e7], 6e8, 2e5),
        bearing([-12.5, 3.0], [1e7, 2e7], 5e8, 1.5e5),
        bearing([13.0, -2.5], [1.5e7, 1e7], 7e8, 2e5),
        bearing([13.0, 3.5], [1e7, 1e7], 4e8, 1e5),
    ];
    run(&scene(&format!(
        "name = \"deck\"\nkind = \"spatial\"\nduration_s = 0.11\n[solver]\ntolerance = {tolerance:e}\n[[girder]]\nname = \"deck\"\n\
         length_m = 30.0\nwidth_m = 8.0\nthickness_m = 1.2\nskew_deg = 60.0\nmass_kg = 4e5\nbearings = [{}]\n\
         elastic = {{ young_modulus_pa = 3e10, poisson_ratio = 0.2, area_m2 = 5.0, damping_ratio = 0.02, modes = 6 }}\n{words}\n\
         [motion]\nkind = \"sine\"\namplitude_m_s2 = 2.0\nfrequency_hz = 1.7\nangle_deg = 30.0\nphase_deg = 20.0\n\
         vertical_amplitude_m_s2 = 1.5\nvertical_phase_deg = 50.0\n{after}",
        bearings.join(", ")
    )))
}

/// A rise of a switching function that is less than the step errs by is none: yield and its end were found at one instant without end.
#[test]
fn coarse_steps_end_yield_once() {
    for tolerance in [1e-4, 3e-4, 1e-3, 1e-2] {
        let history = bending(["initial = { velocity_m_s = [0.6, 0.3, 0.0] }", ""], true, tolerance);
        assert!(history.stop().is_none(), "{:?} at {tolerance:e}", history.stop());
    }
}

/// Stick that begins at its limit: events were 452 at a tolerance of 1e-6.
#[test]
fn stick_that_begins_at_its_limit_makes_few_events_at_every_tolerance() {
    let words = "heading_deg = 35.0\ninitial = { velocity_m_s = [0.6, 0.7, 0.1], rotation_deg = 0.05, pitch_deg = 0.03, roll_deg = 0.05, \
                 spin_deg_s = 1.0, pitch_deg_s = -0.5, roll_deg_s = 0.6 }";
    let wall = "[[abutment]]\nname = \"east\"\nfaces = \"deck\"\ngap_m = 0.02\n[contact]\nstiffness_n_per_m = 2e9\nmu_static = 0.5\n\
                mu_kinetic = 0.5\nrestitution_normal = 1.0\nrestitution_tangential = 1.0\n";
    for tolerance in [1e-9, 1e-7, 1e-6, 1e-5] {
        let events = bending([words, wall], false, tolerance).events().len();
        assert!((10..40).contains(&events), "{events} at {tolerance:e}");
    }
}
