//! Lasting contacts of the impact model against closed forms: girders that press on each other, a face pressed at one end, corner past
//! corner, girders that walls hold at both ends.

use girderbench::sim::History;

use crate::support::{scene, within};

const WALLS: &str = "[[abutment]]\nname = \"east\"\nfaces = \"a\"\nend = \"+x\"\ngap_m = 0.0\n";
const NEXT: &str = "[[girder]]\nname = \"b\"\nlength_m = 10.0\nwidth_m = 5.0\nthickness_m = 1.5\nmass_kg = 300e3\n";

/// A girder of 300 t, 10 × 5 m, with these keys; then the rest of the scene.
fn run(duration: f64, keys: &str, rest: &str) -> History {
    let girder =
        format!("[[girder]]\nname = \"a\"\nlength_m = 10.0\nwidth_m = 5.0\nthickness_m = 1.5\nmass_kg = 300e3\n{keys}");
    let head = format!("name = \"lasting\"\nduration_s = {duration:?}\n[model]\nkind = \"impact\"\n");
    let history = History::of(&scene(&format!("{head}{rest}\n{girder}"))).expect("a sound scene");
    assert!(history.stop().is_none(), "runs to its end: {:?}", history.stop());
    history
}

#[test]
fn girders_that_press_on_each_other_and_on_no_wall_move_as_one() {
    for mu in [0.0, 0.5] {
        let impact = format!("[impact]\nmu_static = {mu:?}\nmu_kinetic = {mu:?}\n");
        let next = format!("{impact}{NEXT}position_m = [10.0, 0.0, 0.0]\npush = {{ force_n = [-1e6, 0.0] }}\n");
        let history = run(1.0, "push = { force_n = [3e6, 0.0] }\n", &next);
        for girder in [0, 1] {
            // 2 MN on 600 t.
            within("place [m]", history.motion(girder, 1.0).displacement.x - 5.0 / 3.0, 1e-9);
            within("speed [m/s]", history.motion(girder, 1.0).velocity.x - 10.0 / 3.0, 1e-9);
        }
        let force: f64 = history.contacts().at(0.5).iter().map(|contact| contact.normal_force).sum();
        // Each is accelerated by what is left of its own push.
        within("force between them [N]", force - 2e6, 1e-3);
    }
}

#[test]
fn girders_at_a_wall_leave_it_together() {
    // 300 kN on the wall against a ground of 0 to 3 m/s²: the wall carries nothing from 0.5 MN = 600 t · a on.
    let rest = format!(
        "[motion]\nkind = \"record\"\nsamples_m_s2 = [0.0, 3.0]\ndt_s = 1.0\n{WALLS}{NEXT}position_m = [-10.0, 0.0, 0.0]\n\
         push = {{ force_n = [3e5, 0.0] }}\n"
    );
    let history = run(0.9, "", &rest);
    let start = 3e5 / 6e5 / 3.0;
    for girder in [0, 1] {
        // ẍ = ½ − 3 t from the time on at which that is 0.
        let t: f64 = 0.9 - start;
        within("place [m]", history.motion(girder, 0.9).displacement.x + 0.5 * t.powi(3), 1e-9);
    }
}

#[test]
fn a_run_that_ends_with_its_record_ends_with_the_ground_of_its_last_sample() {
    // 2 m/s² of the ground to the last sample: the wall at −x, which takes 300 t along, is pressed by 600 kN.
    let wall = WALLS.replace("+x", "-x");
    let rest = format!("[motion]\nkind = \"record\"\nsamples_m_s2 = [2.0, 2.0, 2.0]\ndt_s = 0.5\n{wall}");
    let history = run(1.0, "", &rest);
    for t in [0.5, 0.999, 1.0] {
        let force: f64 = history.contacts().at(t).iter().map(|contact| contact.normal_force).sum();
        within(&format!("force at {t} s [N]"), force - 6e5, 1e-3);
    }
}

/// A face that slides along a wall under a moment that takes the pressure of one end, where the corner has more friction than the face: the
/// other end's pressure is 0 from `t = 4/9` s on, and friction between the two coefficients keeps the face on the wall until it is that of the
/// corner at `34/63` s.
#[test]
fn a_corner_with_more_friction_than_the_face_keeps_it_on_the_wall() {
    let rest = format!(
        "[impact]\nrestitution_normal = 0.0\nmu_static = 0.2\nmu_kinetic = 0.1\ncorner_mu_static = 0.3\n\
         corner_mu_kinetic = 0.2\n[motion]\nkind = \"record\"\nsamples_m_s2 = [0.0, 3.0]\ndt_s = 1.0\n{WALLS}"
    );
    let history = run(0.6, "push = { force_n = [1e6, 6e5], moment_n_m = 1.8e6 }\n", &rest);
    let speed = |t: f64| history.motion(0, t).velocity.y;
    let open: f64 = 4.0 / 9.0;
    // T = 0.1 N and N = 1 MN − 0.9 MN/s · t; then T = (1.8 MN·m − 2.5 m · N)/5 m.
    let before = 5.0 / 3.0 * open + 0.15 * open * open;
    within("speed as one end opens [m/s]", speed(open) - before, 1e-9);
    let corner: f64 = 34.0 / 63.0;
    let slope = |t: f64| 37.0 / 15.0 * t - 0.75 * t * t;
    within("speed as the face leaves [m/s]", speed(corner) - before - slope(corner) + slope(open), 1e-9);
    within("flush until then [rad]", history.motion(0, corner).theta, 1e-12);
    assert!(history.motion(0, 0.6).theta.abs() > 1e-9, "then it turns");
    for t in [0.2, 0.46, 0.5, 0.53, 0.58] {
        let pulls = history.contacts().at(t).iter().any(|contact| contact.normal_force < -1e-3);
        assert!(!pulls, "no end pulls at {t} s: {:?}", history.contacts().at(t));
    }
    assert!(history.contacts().without_friction().is_none(), "with friction all the time");
}

#[test]
fn a_corner_that_slides_past_the_corner_of_the_other_leaves_that_one_in_contact() {
    // b, turned by 1°, slides along the end of a, which is held, and on past its corner.
    let next = format!(
        "[contact]\nbetween = \"ends\"\n[impact]\nrestitution_normal = 0.0\nmu_static = 0.0\nmu_kinetic = 0.0\n{NEXT}\
         position_m = [10.1, 0.0, 0.0]\nheld = [\"yaw\"]\npush = {{ force_n = [-1e5, 0.0] }}\n\
         initial = {{ displacement_m = [-0.0571, 0.0776], rotation_deg = 1.0, velocity_m_s = [0.0, 0.1] }}\n"
    );
    let history = run(1.0, "held = [\"x\", \"y\", \"yaw\"]\n", &next);
    assert_eq!(history.overlaps(), [], "the corner of a carries it");
    // That corner does not move, and b's face, turned by 1°, slides along it.
    let m = history.motion(1, 1.0);
    let forward = m.velocity.x + m.velocity.y * 1f64.to_radians().tan();
    within("it slides along its face [m/s]", forward, 1e-9);
}

#[test]
fn a_skewed_girder_that_two_walls_hold_stays_at_rest() {
    let text = |e_t: f64| {
        format!(
            "name = \"held\"\nduration_s = 0.01\n[model]\nkind = \"impact\"\n[impact]\nrestitution_normal = 0.0\n\
             restitution_tangential = {e_t:?}\nmu_static = 0.5\nmu_kinetic = 0.5\n[[girder]]\nname = \"a\"\nlength_m = 20.0\n\
             width_m = 14.0\nthickness_m = 1.5\nskew_deg = 75.0\nmass_kg = 300e3\npush = {{ force_n = [-124e3, 108e3] }}\n{WALLS}\
             [[abutment]]\nname = \"west\"\nfaces = \"a\"\nend = \"-x\"\ngap_m = 0.0\n"
        )
    };
    for e_t in [-1.0, -0.9] {
        let history = History::of(&scene(&text(e_t))).expect("a sound scene");
        assert!(history.stop().is_none(), "runs to its end: {:?}", history.stop());
        within("at rest [m]", history.motion(0, history.end()).displacement.length(), 1e-12);
        let sum: glam::DVec3 = history.contacts().at(0.005).iter().map(|contact| contact.force).sum();
        within("the walls carry the push [N]", (sum + glam::DVec3::new(-124e3, 108e3, 0.0)).length(), 1e-2);
    }
}
