//! Six degrees of freedom: the planar answer in the limit, Euler's top, gravity, edges.

use crate::support::{run, scene, within};
use girderbench::dynamics::Model;
use girderbench::dynamics::connection::Connection as _;
use girderbench::dynamics::model::coordinates::spatial;
use girderbench::dynamics::model::rigid_body::{self, BearingMotion};
use girderbench::dynamics::model::wrench::Wrench;
use girderbench::scene::{Bearings, Direction, FrictionLaw, Kind, Motion, Scene, presets};
use girderbench::sim::{Comparison, EventKind, History};
use glam::{DQuat, DVec3};

/// The paper's skewed girder as a planar scene and as a spatial one that is held flat, shaken gently enough for rotations
/// of a given size.
fn flat(scale: f64, law: FrictionLaw) -> (Scene, Scene) {
    let mut planar = presets::load("skew60-abutment").unwrap_or_else(|errors| panic!("{errors}"));
    planar.solver.tolerance = 1e-12;
    planar.duration = 2.0;
    planar.contact.law = law;
    let Motion::Sine(sine) = &mut planar.motion else { panic!("it shakes by a sine") };
    sine.amplitude_g = sine.amplitude_g.map(|a| a * scale);
    sine.angle_deg = -30.0;
    planar.abutments[0].gap = planar.abutments[0].gap.map(|gap| gap * scale);
    let mut spatial = planar.clone();
    spatial.kind = Kind::Spatial;
    spatial.girders[0].held = vec![Direction::Z, Direction::Roll, Direction::Pitch];
    if let Some(Bearings::Shared(shared)) = &mut spatial.girders[0].bearings {
        shared.vertical_frequency_hz = Some(10.0);
    }
    (planar, spatial)
}

#[test]
fn a_spatial_girder_held_flat_tends_to_the_planar_one_as_rotations_fall() {
    for law in [FrictionLaw::Paper, FrictionLaw::ReturnMapping] {
        let differences = [1.0, 0.1, 0.01].map(|scale| {
            let (planar, spatial) = flat(scale, law);
            let (a, b) = (run(&planar), run(&spatial));
            let (mut apart, mut turn) = (0.0f64, 0.0f64);
            for i in 0..=400 {
                let t = 2.0 * f64::from(i) / 400.0;
                let (m, n) = (a.motion(0, t), b.motion(0, t));
                apart = apart.max((m.displacement - n.displacement).length() / (0.02 * scale));
                turn = turn.max(m.theta.abs());
            }
            assert!(a.hits().touches().len() > 4, "{law:?}, {scale}: contacts are in play");
            (apart, turn)
        });
        for w in differences.windows(2) {
            let order = (w[0].0 / w[1].0).ln() / (w[0].1 / w[1].1).ln();
            assert!((order - 2.0).abs() < 0.4, "{law:?}: falls as θ^{order:.2}, {differences:?}");
        }
    }
}

/// Newton's method left too early where slips turn put the deck 3e-7 m off whatever the tolerance was.
#[test]
fn a_deck_that_slides_on_four_nodes_comes_nearer_with_the_tolerance() {
    let mut deck = presets::load("deck-30m").unwrap_or_else(|errors| panic!("{errors}"));
    deck.duration = 8.0;
    let [rough, fine, finest] = [2e-4, 1e-5, 1e-11].map(|tolerance| {
        deck.solver.tolerance = tolerance;
        run(&deck)
    });
    assert_eq!(fine.events().len(), finest.events().len(), "the same events");
    let apart = |run: &History| Comparison::of(run, &finest).of_all().place;
    let (far, near) = (apart(&rough), apart(&fine));
    // A millionth of its peak displacement, and a sixth of that.
    assert!(far < 2.99e-7, "{far} m at 2e-4");
    assert!(near < 5e-8, "{near} m at 1e-5");
}

#[test]
fn a_free_prism_keeps_its_energy_and_its_angular_momentum() {
    let mut top = scene(
        r#"
        name = "top"
        kind = "spatial"
        gravity_m_s2 = 0.0
        duration_s = 20.0
        [[girder]]
        name = "top"
        length_m = 1.0
        width_m = 0.5
        thickness_m = 0.2
        skew_deg = 50.0
        mass_kg = 3.0
        position_m = [0.0, 0.0, 0.0]
        initial = { spin_deg_s = 400.0, velocity_m_s = [0.1, 0.2, 0.3] }
        push = { moment_n_m = 0.05 }
        "#,
    );
    top.solver.tolerance = 1e-12;
    let history = run(&top);
    let ledger = history.energy().ledger(20.0);
    assert!(ledger.work_push > 0.1, "the moment works");
    within("ledger", ledger.residual / ledger.scale, 1e-11);
    let i2 = history.model().bodies[0].gyration2;
    let expected = 400f64.to_radians() + 0.05 / (3.0 * i2) * 20.0;
    within("spin about the vertical", history.motion(0, 20.0).spin.z / expected - 1.0, 1e-11);
    within("attitude stays a rotation", history.motion(0, 13.7).attitude.length() - 1.0, 1e-12);
}

#[test]
fn a_body_without_bearings_falls_as_it_must() {
    let mut drop = scene(
        r#"
        name = "drop"
        kind = "spatial"
        duration_s = 1.0
        [[girder]]
        name = "block"
        length_m = 1.0
        width_m = 0.5
        thickness_m = 0.2
        mass_kg = 3.0
        initial = { velocity_m_s = [1.0, 0.0, 2.0] }
        "#,
    );
    drop.solver.tolerance = 1e-12;
    let motion = run(&drop).motion(0, 1.0);
    within("x", motion.displacement.x - 1.0, 1e-12);
    within("z", motion.displacement.z - (2.0 - 0.5 * 9.806_65), 1e-12);
}

/// A deck that has been turned, on some bearings.
fn turned(on: &[[f64; 2]]) -> Scene {
    let mut deck = presets::load("deck-30m").unwrap_or_else(|errors| panic!("{errors}"));
    deck.motion = Motion::None;
    deck.duration = 10.0;
    deck.girders[0].heading_deg = 33.0;
    deck.abutments.clear();
    let Some(Bearings::Shared(shared)) = &mut deck.girders[0].bearings else { panic!("it stands on bearings") };
    (shared.at_skewed, shared.at) = (None, Some(on.to_vec()));
    deck
}

#[test]
fn bearings_and_weight_act_as_all_their_forces_together() {
    for on in [&[[14.0, 5.1], [11.0, -3.3], [-13.7, 4.9], [-12.3, -5.7]][..], &[[3.0, -2.0]]] {
        let model = Model::compile(&turned(on)).unwrap_or_else(|e| panic!("{e}"));
        let body = &model.bodies[0];
        let turn = DQuat::from_scaled_axis(DVec3::new(0.03, -0.02, 0.4));
        let mut state = vec![0.3, -0.2, 0.1, turn.x, turn.y, turn.z, turn.w];
        state.extend([0.5, -0.4, 0.2, 0.06, 0.05, -0.03]);
        let here = body.frame(0, &state);
        let mut slope = [0.0; spatial::WIDTH];
        spatial::slope(body, &here, &state, &Wrench::default(), DVec3::ZERO, &mut slope);
        let (mut force, mut moment) = (DVec3::NEG_Z * (body.mass * model.gravity), DVec3::ZERO);
        for BearingMotion { bearing, motion, arm } in rigid_body::bearing_motions(body, &here) {
            let part = bearing.preload + body.axes * bearing.force(&(), &motion);
            (force, moment) = (force + part, moment + arm.cross(part));
        }
        let inertia = rigid_body::world_inertia(body, &here.rotation(&body.axes));
        let spin_rate = inertia.inverse() * (moment - here.spin.cross(inertia * here.spin));
        let [gains, turns] = [7, 10].map(|from| DVec3::from_slice(&slope[from..from + 3]));
        within("acceleration", (gains - force / body.mass).length(), 1e-12 * gains.length().max(model.gravity));
        within("rate of spin", (turns - spin_rate).length(), 1e-12 * turns.length().max(model.gravity));
    }
}

/// What carries a weight cancels it exactly: a rounding of it would set off girders that touch as placed.
#[test]
fn a_girder_on_bearings_of_any_plan_stands_still_to_the_last_bit() {
    let deck = turned(&[[14.0, 5.1], [11.0, -3.3], [-13.7, 4.9], [-12.3, -5.7]]);
    let motion = run(&deck).motion(0, 10.0);
    assert_eq!([motion.displacement, motion.velocity, motion.spin], [DVec3::ZERO; 3]);
}

#[test]
fn a_deck_that_leaves_over_the_top_of_a_low_backwall_books_the_edge() {
    let mut low = presets::load("deck-30m").unwrap_or_else(|errors| panic!("{errors}"));
    low.solver.tolerance = 1e-12;
    low.duration = 1.0;
    low.motion = Motion::None;
    low.girders[0].bearings = None;
    // Thrown at the wall and upwards: the lower nodes touch, then slide out over its top.
    low.gravity = 0.0;
    low.girders[0].initial.velocity = [0.5, 0.0, 1.5];
    for wall in &mut low.abutments {
        wall.height = Some(1.6);
        wall.gap = Some(0.001);
    }
    let history = run(&low);
    assert!(history.events().iter().any(|e| e.kind == EventKind::LeftFace), "an edge is left: {:?}", history.events());
    let ledger = history.energy().ledger(1.0);
    assert!(ledger.jump_edge > 0.0, "its spring energy goes to the ledger");
    within("ledger", ledger.residual / ledger.scale, 1e-11);
}

#[test]
fn the_tangential_dashpot_works_on_the_rate_of_the_stretch_as_it_turns() {
    let mut scene = presets::load("flush-free-hit").unwrap_or_else(|errors| panic!("{errors}"));
    scene.kind = Kind::Spatial;
    scene.gravity = 0.0;
    scene.solver.tolerance = 1e-12;
    scene.contact.law = FrictionLaw::ReturnMapping;
    scene.contact.restitution_tangential = 0.2;
    scene.girders[0].initial.velocity = [0.3, 0.2, 0.1];
    scene.girders[0].push.force = [0.0, -300.0, 200.0];
    let history = run(&scene);
    let touch = history.hits().touches()[0];
    let (t, h) = (touch.start + 0.3 * (touch.end - touch.start), 1e-7);
    let stretch =
        |t: f64| history.contacts().contact_at(touch.contact, t).map(|c| (c.point - c.anchor).reject_from(c.normal));
    let (Some(before), Some(after), Some(now)) =
        (stretch(t - h), stretch(t + h), history.contacts().contact_at(touch.contact, t))
    else {
        panic!("it touches from {} to {}", touch.start, touch.end)
    };
    let share = history.model().pairs[0].law.c_t / 4.0;
    let expected = (after - before) / (2.0 * h) * -share;
    // The eased direction lags by a thousandth of the entry's depth over the depth in hand.
    within("dashpot force", (now.tangential_damping - expected).length() / expected.length(), 1e-4);
}

#[test]
fn a_smooth_wall_is_slid_along_in_any_direction() {
    // Without friction a slip has no direction to turn: it once was followed all the same, faster and faster from an overlap of
    // rounding.
    let text = "name = \"smooth\"\nkind = \"spatial\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = 0.112\nwidth_m = 0.138\n\
                thickness_m = 0.0552\nskew_deg = 51.2\nmass_kg = 0.09\n\
                bearings = { frequency_hz = 1.3, damping_ratio = 0.1, vertical_frequency_hz = 12.0, \
                at_m = [[0.078, 0.048], [-0.078, 0.048], [0.078, -0.048], [-0.078, -0.048]] }\n\
                push = { force_n = [0.0693, 0.02] }\n[[abutment]]\nname = \"east\"\nfaces = \"deck\"\ngap_m = 0.0\n\
                [contact]\nstiffness_n_per_m = 3e10\nrestitution_normal = 0.01\nmu_static = 0.0\nmu_kinetic = 0.0\n\
                [motion]\nkind = \"sine\"\namplitude_m_s2 = 0.1\nfrequency_hz = 2.0\nangle_deg = 51.2\n";
    let scene = scene(text);
    let history = run(&scene);
    assert!(history.motion(0, 1.0).velocity.is_finite(), "it slides to the end");
}

#[test]
fn a_deck_pressed_from_rest_parts_again() {
    // It starts with an overlap of rounding: how sharply a slip's direction may turn comes from the push, not from that.
    let text = "name = \"pressed\"\nkind = \"spatial\"\nduration_s = 0.248\n[[girder]]\nname = \"deck\"\nlength_m = 2.87\nwidth_m = 0.399\n\
                thickness_m = 0.191\nmass_kg = 7e6\nposition_m = [2.87, 0.0, 0.0]\n\
                bearings = { frequency_hz = [3.89, 2.63], damping_ratio = 0.0, vertical_frequency_hz = 12.3, \
                at_m = [[1.0, 0.14], [1.0, -0.14], [-1.0, 0.14], [-1.0, -0.14]] }\n\
                push = { force_n = [2.41e6, 5.13e6] }\n[[abutment]]\nname = \"east\"\nfaces = \"deck\"\ngap_m = 0.0\n\
                [contact]\nstiffness_n_per_m = 2e9\nrestitution_normal = 1.0\nrestitution_tangential = 1.0\nmu_static = 1.88\n\
                mu_kinetic = 1.24\ntension = \"clamp\"\n[solver]\ntolerance = 3.72e-12\n";
    let scene = scene(text);
    let history = run(&scene);
    assert!(history.events().iter().any(|e| e.kind == EventKind::Opened), "it parts as its bearings bring it back");
}

#[test]
fn a_girder_tossed_at_a_backwall_tumbles_as_exactly_as_its_tolerance_says() {
    let tossed = |tolerance: f64| {
        let text = format!(
            "name = \"tossed\"\nkind = \"spatial\"\nduration_s = 1.15\nsolver = {{ tolerance = {tolerance:e} }}\n\
             [[girder]]\nname = \"g\"\nlength_m = 4.4\nwidth_m = 0.46\nthickness_m = 0.03\nmass_kg = 3e4\n\
             position_m = [0, 0, 0]\ninitial = {{ velocity_m_s = [-11.4, 2.4, 0], spin_deg_s = 45 }}\n\
             [[abutment]]\nname = \"west\"\nfaces = \"g\"\nend = \"-x\"\ngap_m = 0.08\n\
             [contact]\nstiffness_n_per_m = 4e7\nrestitution_normal = 0.02\nrestitution_tangential = 0.7\n\
             mu_static = 1.0\nmu_kinetic = 0.7\n"
        );
        run(&scene(&text))
    };
    let truth = tossed(1e-12);
    assert!(truth.motion(0, 1.0).spin.truncate().length() > 0.5, "friction sets it tumbling");
    for tolerance in [1e-5, 1e-6, 1e-7] {
        let history = tossed(tolerance);
        let turned =
            |t: f64| 2.0 * (history.motion(0, t).attitude.inverse() * truth.motion(0, t).attitude).xyz().length();
        // It tumbles by some five radians: a tolerance for each.
        within("attitude", (1..=50).map(|i| turned(1.15 * f64::from(i) / 50.0)).fold(0.0, f64::max), 5.0 * tolerance);
    }
}
