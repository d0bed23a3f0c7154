//! Two skewed spans shaken along their axis: at the joint the corner of one end slides sideways past the corner of the other while the
//! ends are pressed together, and the touch goes on from that corner to the other.

use girderbench::scene::Scene;
use girderbench::sim::{ErrorEstimate, History};

use super::expect_carried;
use crate::support::{run, scene, within};

/// Two spans of 25 m by 10 m between abutments, shaken along `angle` \[°\].
fn bridge(skew: f64, angle: f64) -> Scene {
    let span = |name: &str, x: f64| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 25.0\nwidth_m = 10.0\nthickness_m = 1.25\nskew_deg = {skew}\nmass_kg = 5e5\n\
             position_m = [{x}, 0.0, 0.0]\n[girder.bearings]\nfrequency_hz = 0.8\ndamping_ratio = 0.1\n\
             at_skewed_m = [[12.0, 4.0], [12.0, -4.0], [-12.0, 4.0], [-12.0, -4.0]]\n"
        )
    };
    let abutment = |faces: &str, end: &str| {
        format!(
            "[[abutment]]\nname = \"{end}\"\nfaces = \"{faces}\"\nend = \"{end}\"\ngap_m = 0.04\nwidth_m = 24.0\nheight_m = 3.75\n"
        )
    };
    scene(&format!(
        "name = \"joint\"\nduration_s = 2.6\n[contact]\nstiffness_n_per_m = 1e9\nmu_static = 0.2\nmu_kinetic = 0.15\n[motion]\n\
         kind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 0.8\nangle_deg = {angle}\n{}{}{}{}",
        span("west", -12.52),
        span("east", 12.52),
        abutment("east", "+x"),
        abutment("west", "-x"),
    ))
}

/// Largest force of a corner \[N\].
fn peak(history: &History) -> f64 {
    history.hits().touches().iter().fold(0.0, |peak, touch| peak.max(touch.peak_force))
}

#[test]
fn contact_goes_on_from_corner_to_corner_at_any_skew() {
    for skew in [35.0, 40.0, 45.0, 50.0, 60.0] {
        let history = run(&bridge(skew, 0.0));
        expect_carried(&history);
        within("converged", ErrorEstimate::of(&history).error, 1e-9);
        let deepest = history.hits().touches().iter().any(|touch| touch.peak_force > 5e6);
        assert!(deepest, "a hit at {skew}°");
        // What the one corner lets go of the other takes up, but for the angle between the ends and the stretch along them.
        let lost = history.contacts().dropped().map_or(0.0, |dropped| dropped.share);
        assert!(lost < 1e-3, "{lost} of the energy in play at {skew}°");
    }
}

#[test]
fn a_bridge_that_is_turned_end_for_end_moves_as_before() {
    // Half a turn takes the one span into the other, and the ground's motion into its opposite.
    let [one, other] = [0.0, 180.0].map(|angle| run(&bridge(45.0, angle)));
    for i in 0..=100 {
        let t = one.end() * f64::from(i) / 100.0;
        let [a, b] = [one.motion(0, t), other.motion(1, t)];
        within("place", (a.displacement + b.displacement).length(), 1e-8);
        within("rotation", a.theta - b.theta, 1e-9);
    }
}

#[test]
fn the_peak_force_has_no_step_at_45_degrees() {
    let [below, above] = [44.99, 45.01].map(|skew| peak(&run(&bridge(skew, 0.0))));
    assert!((below / above - 1.0).abs() < 2e-3, "{below} and {above} N");
}
