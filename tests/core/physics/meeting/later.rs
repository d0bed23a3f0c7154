//! What bodies that have met do later: no pair of theirs waits for ever, and nothing that comes changes what was.

use girderbench::scene::Scene;
use girderbench::sim::History;

use crate::support::{run, scene};

/// A girder on soft bearings, shaken against the back of a wall that faces another one: it touches first with a corner, swings away
/// beside the wall, and comes back with another corner two seconds later.
fn shaken_behind_a_wall(law: &str) -> Scene {
    scene(&format!(
        "name = \"behind\"\nduration_s = 3.0\n\
         [[girder]]\nname = \"a\"\nlength_m = 8.594\nwidth_m = 3.0\nthickness_m = 1.0\nskew_deg = 45.0\nmass_kg = 2e4\n\
         held = [\"x\", \"y\", \"yaw\"]\n\
         [[girder]]\nname = \"c\"\nlength_m = 2.056\nwidth_m = 2.87\nthickness_m = 1.0\nskew_deg = 45.0\nmass_kg = 2000.0\n\
         position_m = [-10.88, 2.35, 0.0]\ninitial = {{ velocity_m_s = [0.3, -0.12] }}\n\
         bearings = {{ frequency_hz = 0.4, damping_ratio = 0.0, at_skewed_m = [[0.8, 0.9], [0.8, -0.9], [-0.8, 0.9], [-0.8, -0.9]] }}\n\
         [[abutment]]\nname = \"w\"\nfaces = \"a\"\nend = \"-x\"\ngap_m = 2.28\nwidth_m = 5.2\ndepth_m = 3.7\n\
         [contact]\nstiffness_n_per_m = 1e8\nrestitution_normal = 1.0\nrestitution_tangential = 0.5\nbetween = \"all\"\n\
         mu_static = 0.15\nmu_kinetic = 0.0\nnormal_law = \"{law}\"\n\
         [motion]\nkind = \"sine\"\namplitude_g = 0.396\nfrequency_hz = 0.6\nangle_deg = 132.4\n"
    ))
}

/// The pair that leads the search of two bodies that stand apart can have none of its own contacts within reach for the rest of the run:
/// pairs that have come to wait later are searched all the same.
#[test]
fn a_pair_that_waits_is_searched_though_the_first_of_its_bodies_has_nothing_to_come() {
    for law in ["kelvin-voigt", "hertz"] {
        let history = run(&shaken_behind_a_wall(law));
        assert!(history.overlaps().is_empty(), "{law}: {:?}", history.overlaps());
        let ledger = history.energy().ledger(history.end());
        assert!(ledger.jump_entry > -1e-12 * ledger.scale, "{law}: no spring appears pressed: {} J", ledger.jump_entry);
        assert!(history.hits().touches().iter().any(|touch| touch.start > 2.0), "{law}: it comes back");
    }
}

/// A wall wider than the end that it faces: one of its corners is no contact as placed, and is one once the bodies have met, which they do
/// after five seconds. Before that it shares K where it is over the end.
#[test]
fn what_happens_later_does_not_change_what_happened_before() {
    let thrown = |duration: f64| -> History {
        run(&scene(&format!(
            "name = \"thrown\"\nduration_s = {duration}\n\
             [[girder]]\nname = \"a\"\nlength_m = 8.0\nwidth_m = 1.0\nthickness_m = 1.0\nskew_deg = 60.0\nmass_kg = 6000.0\n\
             heading_deg = 90.0\ninitial = {{ velocity_m_s = [0.0, 1.6] }}\n\
             [[girder]]\nname = \"b\"\nlength_m = 13.0\nwidth_m = 4.0\nthickness_m = 1.0\nskew_deg = 60.0\nmass_kg = 9e4\n\
             position_m = [13.0, 2.0, 0.0]\nheading_deg = 180.0\ninitial = {{ velocity_m_s = [-2.4, -1.0], spin_deg_s = 3.0 }}\n\
             [[abutment]]\nname = \"w\"\nfaces = \"a\"\nend = \"+x\"\ngap_m = 2.0\nwidth_m = 4.0\ndepth_m = 4.0\n\
             [contact]\nstiffness_n_per_m = 1e8\nrestitution_normal = 0.05\nrestitution_tangential = 1.0\nbetween = \"all\"\n\
             mu_kinetic = 0\nmu_static = 0\n"
        )))
    };
    let (short, long) = (thrown(4.0), thrown(7.0));
    let declared = |history: &History| history.model().sites.len();
    assert!(declared(&short) < declared(&long), "more contacts in the longer run, whose bodies meet");
    for look in 0..=40 {
        let t = 0.1 * f64::from(look);
        for girder in [0, 1] {
            let [a, b] = [&short, &long].map(|history| history.motion(girder, t));
            let apart = a.displacement.distance(b.displacement);
            assert!(apart < 1e-9 && (a.theta - b.theta).abs() < 1e-9, "{t} s, girder {girder}: {apart} m apart");
        }
    }
}
