//! Rotation of spatial girders about the vertical, counted beyond half a turn.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::support::{run, scene, within};
use girderbench::sim::History;

fn spun(kind: &str, heading_deg: f64) -> History {
    run(&scene(&format!(
        "name = \"spun\"\nkind = \"{kind}\"\ngravity_m_s2 = 0.0\nduration_s = 10.0\n[[girder]]\nname = \"deck\"\n\
         length_m = 1.0\nwidth_m = 0.5\nthickness_m = 0.2\nskew_deg = 60.0\nmass_kg = 3.0\n\
         heading_deg = {heading_deg:?}\ninitial = {{ rotation_deg = 270.0, spin_deg_s = {:?} }}",
        3f64.to_degrees()
    )))
}

#[test]
fn a_spun_girder_reports_all_its_turns_in_space_as_in_plan() {
    for heading in [0.0, 37.0, 90.0] {
        let [plan, space] = ["planar", "spatial"].map(|kind| spun(kind, heading));
        for history in [&plan, &space] {
            within("30 rad in 10 s", history.motion(0, 10.0).theta - 1.5 * PI - 30.0, 1e-8);
            for i in 0..=1000 {
                let t = 0.01 * f64::from(i);
                within("3 rad/s", history.motion(0, t).theta - 1.5 * PI - 3.0 * t, 1e-8);
            }
        }
        let fresh = spun("spatial", heading).motion(0, 7.3).theta;
        assert_eq!(space.motion(0, 7.3).theta.to_bits(), fresh.to_bits(), "whatever was read before");
    }
}

/// Hung by one end from a bearing without damping, level at the start: a pendulum that swings by half a turn.
#[test]
fn a_girder_that_swings_through_the_vertical_keeps_its_angle_about_it() {
    let hung = run(&scene(
        "name = \"hung\"\nkind = \"spatial\"\nduration_s = 6.0\n[[girder]]\nname = \"deck\"\nlength_m = 1.0\n\
         width_m = 0.2\nthickness_m = 0.1\nmass_kg = 3.0\nheading_deg = 30.0\n\
         bearings = [{ at_m = [0.5, 0.0], stiffness_n_per_m = [9e4, 9e4, 9e4], damping_n_s_per_m = [0.0, 0.0, 0.0] }]",
    ));
    let axis = |t: f64| hung.motion(0, t).attitude * glam::DVec3::X;
    let mut passed = 0;
    for i in 0..6000 {
        let t = 1e-3 * f64::from(i);
        let motion = hung.motion(0, t);
        within("no jump", motion.theta - hung.motion(0, t + 1e-3).theta, 1e-6);
        within("about the vertical", motion.theta, 1e-6);
        passed += usize::from(axis(t).truncate().dot(axis(t + 1e-3).truncate()) < 0.0);
    }
    assert!(passed >= 4, "its axis was vertical {passed} times");
    let lowest = (0..600).map(|i| axis(0.01 * f64::from(i)).z.abs()).fold(0.0, f64::max);
    within("as far as the vertical", lowest.asin() - FRAC_PI_2, 0.1);
}
