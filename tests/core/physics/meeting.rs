//! Contact between faces that did not face each other as placed: closed forms of hits, and what holds of any bodies thrown at each
//! other.

mod crossing;
mod edges;
mod flush_corners;
mod later;
mod offset;
mod passing;
mod ramp;
mod round_a_corner;
mod shaken_joint;
mod sliding_joint;
mod stacked;
mod thrown_in_space;

use girderbench::scene::{Between, Direction, Kind, ModelKind, STANDARD_GRAVITY, Scene};
use girderbench::sim::History;
use girderbench::study::stability::family;
use glam::DVec3;

use crate::support::{run, scene, within};

const BODY: &str = "length_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = 2.0\n";

/// Girders without bearings and without friction, `keys` of each.
fn girders(keys: &[&str], duration: f64) -> Scene {
    let girder = |(n, keys): (usize, &&str)| format!("[[girder]]\nname = \"g{n}\"\n{BODY}{keys}");
    let girders = keys.iter().enumerate().map(girder).collect::<Vec<_>>().concat();
    scene(&format!(
        "name = \"met\"\nduration_s = {duration}\n[contact]\nstiffness_n_per_m = 1e6\nrestitution_normal = 0.6\nmu_static = 0.0\n\
         mu_kinetic = 0.0\n{girders}"
    ))
}

/// The scene in space, held flat.
fn held_flat(flat: &Scene) -> Scene {
    let mut upright = flat.clone();
    (upright.kind, upright.gravity) = (Kind::Spatial, 0.0);
    for girder in &mut upright.girders {
        girder.held = vec![Direction::Z, Direction::Roll, Direction::Pitch];
    }
    upright
}

/// Every overlap is carried by a contact, and the ledger balances.
fn expect_carried(history: &History) {
    assert_eq!(history.overlaps(), [], "contacts carry all");
    let balance = history.energy().balance();
    assert!(balance.holds(), "{balance:?}");
}

/// Damping ratio ξ of a coefficient of restitution (65).
fn damping_ratio(restitution: f64) -> f64 {
    let ln = restitution.ln();
    -ln / (std::f64::consts::PI.powi(2) + ln * ln).sqrt()
}

/// Restitution of a contact with damping ratio ξ'.
fn restitution(damping_ratio: f64) -> f64 {
    (-std::f64::consts::PI * damping_ratio / (1.0 - damping_ratio * damping_ratio).sqrt()).exp()
}

/// Velocity of a girder at the end \[m/s\].
fn velocity(history: &History, girder: usize) -> DVec3 {
    history.motion(girder, history.end()).velocity
}

/// Momentum \[kg·m/s\] and angular momentum about the origin \[kg·m²/s\] of girders of equal shape and mass at `t`.
fn momenta(history: &History, t: f64) -> (DVec3, f64) {
    let bodies = history.model().bodies.iter().enumerate();
    bodies.fold((DVec3::ZERO, 0.0), |(linear, angular), (girder, body)| {
        let m = history.motion(girder, t);
        let own = body.mass * body.gyration2 * m.spin.z;
        (linear + body.mass * m.velocity, angular + body.mass * m.place.cross(m.velocity).z + own)
    })
}

#[test]
fn a_flush_hit_of_two_sides_returns_the_restitution() {
    // Twin decks 20 mm apart, closing at 1 m/s.
    let history = run(&girders(&["", "position_m = [0.0, 0.09, 0.0]\ninitial = { velocity_m_s = [0, -1] }\n"], 0.1));
    assert_eq!(history.overlaps(), [], "the sides carry");
    let first = history.hits().touches().iter().map(|touch| touch.start).fold(f64::INFINITY, f64::min);
    within("time of the hit", first - 0.02, 1e-12);
    // (1 ∓ e)/2 of the speed before, equal masses.
    within("struck", velocity(&history, 0).y + 0.8, 1e-9);
    within("striking", velocity(&history, 1).y + 0.2, 1e-9);
}

#[test]
fn an_end_that_meets_the_middle_of_a_side_returns_the_restitution() {
    // A T, 30 mm apart.
    let ram = "position_m = [0.0, 0.16, 0.0]\nheading_deg = 90\ninitial = { velocity_m_s = [0, -0.5] }\n";
    let history = run(&girders(&["", ram], 0.2));
    assert_eq!(history.overlaps(), [], "the side carries");
    let [a, b] = [0, 1].map(|girder| velocity(&history, girder).y);
    within("parting", (b - a) / 0.5 - 0.6, 1e-9);
    within("momentum", a + b + 0.5, 1e-12);
    let pairs: Vec<&str> =
        history.hits().listed_pairs().iter().map(|&pair| history.model().pairs[pair].name.as_str()).collect();
    assert_eq!(pairs, ["g0+y|g1-x"], "only what touched is listed");
}

#[test]
fn a_corner_that_meets_a_side_moves_both_as_one_point_does() {
    // Turned by 30° the lowest corner meets a side: with w the sum of the mobilities at the point along the normal, the impulse
    // of a spring and a dashpot made for restitution e is that of the restitution e' = exp(−π ξ'/√(1 − ξ'²)), ξ' = ξ √(w n/w₀), where
    // n nodes share and w₀ = 2/m is what the dashpot was made for.
    let striking = "position_m = [0.03, 0.15, 0.0]\nheading_deg = 30\ninitial = { velocity_m_s = [0, -0.5] }\n";
    let history = run(&girders(&["", striking], 0.2));
    assert_eq!((history.overlaps(), history.hits().touches().len()), (&[][..], 1), "one touch, carried");
    let touch = &history.hits().touches()[0];
    let site = &history.model().sites[touch.contact];
    let at = history.motion(0, touch.start).place;
    let node = history.contacts().contact_at(touch.contact, touch.start + 1e-6).expect("closed").point;
    let (m, i2) = (2.0, history.model().bodies[0].gyration2);
    let lever = [node - at, node - history.motion(1, touch.start).place].map(|arm| arm.x);
    let mobility: f64 = lever.iter().map(|x| (1.0 + x * x / i2) / m).sum();
    let nodes = site_sharers(&history, site.pair, touch.start);
    let returned = restitution(damping_ratio(0.6) * (mobility * m / 2.0 / nodes).sqrt());
    let impulse = (1.0 + returned) * 0.5 / mobility;
    // Both turn by a few milliradians during the touch, and with them the levers.
    within("impulse", velocity(&history, 1).y + 0.5 - impulse / m, 2e-3);
    let [before, after] = [0.0, history.end()].map(|t| momenta(&history, t));
    within("momentum", (after.0 - before.0).length(), 1e-12);
    // But for the couple of the tangential dashpot, which acts on the turning over the depth.
    within("angular momentum", after.1 - before.1, 1e-7);
}

/// Nodes of a pair over its faces at `t`, among which K and C are divided.
fn site_sharers(history: &History, pair: usize, t: f64) -> f64 {
    let over = history.model().pairs[pair].sites.clone().filter(|&contact| {
        let site = &history.model().sites[contact];
        let [node, face] = [site.node_body, site.face_body].map(|body| {
            let body = body.expect("girders");
            (history.motion(body, t), &history.model().bodies[body])
        });
        let local = |world: DVec3| face.0.attitude.inverse() * (world - face.0.place);
        site.face.inset(local(node.0.place + node.0.attitude * site.point)) >= 0.0
    });
    over.count().max(1) as f64
}

#[test]
fn bodies_that_never_meet_otherwise_have_the_same_answer() {
    for name in ["skew45-abutment", "straight-straight", "deck-30m"] {
        let mut scene = girderbench::scene::presets::load(name).expect("a preset");
        scene.duration = scene.duration.min(2.0);
        let all = run(&scene);
        scene.contact.between = Between::Ends;
        assert_eq!(all.digest(), run(&scene).digest(), "{name}");
    }
}

#[test]
fn a_girder_thrown_at_the_side_of_an_abutment_comes_back() {
    let text = format!(
        "name = \"wall\"\nduration_s = 0.3\n[contact]\nstiffness_n_per_m = 1e6\nmu_static = 0\nmu_kinetic = 0\n[[girder]]\nname = \"deck\"\n\
         {BODY}[[abutment]]\nname = \"wall\"\nfaces = \"deck\"\ngap_m = 0.01\nwidth_m = 0.1\ndepth_m = 0.3\n[[girder]]\nname = \"stray\"\n{BODY}\
         position_m = [0.25, 0.3, 0.0]\ninitial = {{ velocity_m_s = [0.0, -2.0] }}\n"
    );
    let history = run(&scene(&text));
    assert_eq!(history.overlaps(), [], "the abutment's side carries");
    within("comes back at e", velocity(&history, 1).y / 2.0 - 0.4, 1e-9);
}

#[test]
fn girders_thrown_at_each_other_from_anywhere_do_not_pass_through() {
    // In the last three another way becomes the shortest while they touch.
    for seed in (0..24).chain([258, 403, 559]).map(|seed| family::FIRST_THROWN + seed) {
        let (_, scene) = family::scene(seed);
        let history = run(&scene);
        assert!(history.stop().is_none(), "seed {seed}: {:?}", history.stop());
        assert_eq!(history.overlaps(), [], "seed {seed}");
        let balance = history.energy().balance();
        assert!(balance.holds(), "seed {seed}: {balance:?}");
    }
}

#[test]
fn the_impact_model_ends_where_bodies_meet_that_it_has_no_contact_for() {
    let keys = ["", "position_m = [0.0, 0.09, 0.0]\ninitial = { velocity_m_s = [0, -1] }\n"];
    let mut scene = girders(&keys, 0.1);
    scene.model.kind = ModelKind::Impact;
    let history = History::of(&scene).expect("a sound scene");
    let stop = history.stop().expect("it ends early");
    within("where the sides meet", stop.t - 0.02, 1e-6);
    assert_eq!((history.end(), stop.place.as_str()), (stop.t, "g0, g1"), "{stop:?}");
    scene.contact.between = Between::Ends;
    assert_eq!(run(&scene).stop(), None, "asked to let them pass");
}

#[test]
fn an_impact_run_that_ends_where_bodies_meet_has_no_later_events() {
    let text = format!(
        "name = \"later\"\nduration_s = 0.1\n[model]\nkind = \"impact\"\n[[girder]]\nname = \"one\"\n{BODY}[[girder]]\nname = \"other\"\n{BODY}\
         position_m = [0.0, 0.09, 0.0]\ninitial = {{ velocity_m_s = [0, -1] }}\n[[girder]]\nname = \"far\"\n{BODY}\
         position_m = [5.0, 5.0, 0.0]\ninitial = {{ velocity_m_s = [0.5, 0] }}\n\
         [[abutment]]\nname = \"early\"\nfaces = \"far\"\nend = \"+x\"\ngap_m = 0.005\n[[abutment]]\nname = \"late\"\nfaces = \"far\"\nend = \"-x\"\n\
         gap_m = 0.005\n"
    );
    let scene = scene(&text);
    let history = History::of(&scene).expect("a sound scene");
    let end = history.end();
    within("where the sides meet", end - 0.02, 1e-6);
    let times: Vec<f64> = history.events().iter().map(|event| event.t).collect();
    assert!(times.iter().any(|t| (t - 0.01).abs() < 1e-6), "the early hit: {times:?}");
    assert!(times.iter().all(|t| *t <= end), "nothing later than {end} s: {times:?}");
}

#[test]
fn a_girder_that_falls_on_another_comes_to_rest_on_it() {
    let bearings = "vertical_frequency_hz = 15.0, frequency_hz = 8.0, damping_ratio = 0.7, \
                    at_m = [[0.8, 0.2], [-0.8, 0.2], [0.8, -0.2], [-0.8, -0.2]]";
    let text = format!(
        "name = \"stack\"\nkind = \"spatial\"\nduration_s = 2.0\n[solver]\ntolerance = 1e-7\n[contact]\nstiffness_n_per_m = 1e5\n\
         restitution_normal = 0.05\n[[girder]]\nname = \"base\"\nlength_m = 2.0\nwidth_m = 0.6\nthickness_m = 0.2\nmass_kg = 50.0\n\
         bearings = {{ {bearings} }}\n[[girder]]\nname = \"top\"\nlength_m = 0.8\nwidth_m = 0.3\nthickness_m = 0.1\nmass_kg = 5.0\n\
         position_m = [0.0, 0.0, 0.17]\n"
    );
    let history = run(&scene(&text));
    assert_eq!(history.overlaps(), [], "the upper side carries");
    // Down by the gap, by the penetration under its weight, and by what the bearings yield under it.
    let weight = 5.0 * STANDARD_GRAVITY;
    let stiffness = 50.0 * (std::f64::consts::TAU * 15.0).powi(2);
    let rest = -(0.02 + weight / 1e5 + weight / stiffness);
    within("at rest", history.motion(1, history.end()).displacement.z - rest, 1e-6);
}
