//! Runs of the impact model against closed forms.

mod support;

use girderbench::dynamics::impact2d::State;
use girderbench::scene::{
    Abutment, ContactSettings, Direction, Flush, Girder, ImpactSettings, Initial, Kind, ModelKind, ModelSettings,
    Motion, Push, Scene, Seat, SolverSettings, ViewSettings,
};
use girderbench::sim::History;
use support::within;

fn girder(length: f64, width: f64, skew_deg: f64) -> Girder {
    Girder {
        name: "deck".to_owned(),
        length,
        width,
        thickness: 1.0,
        skew_deg,
        mass: 2.0,
        position: [0.0; 3],
        heading_deg: 0.0,
        bearings: None,
        initial: Initial::default(),
        push: Push::default(),
        held: Vec::new(),
        seat: Seat::default(),
    }
}

fn scene(girder: Girder, gap: f64, duration: f64, impact: ImpactSettings) -> Scene {
    let wall = Abutment {
        name: "wall".to_owned(),
        faces: "deck".to_owned(),
        end: girderbench::geometry::End::Plus,
        gap: Some(gap),
        width: Some(40.0 * girder.length),
        height: Some(2.0),
        offset: None,
        polygon: None,
        depth: None,
    };
    Scene {
        format: 1,
        name: "closed form".to_owned(),
        description: String::new(),
        kind: Kind::Planar,
        duration,
        gravity: 9.806_65,
        model: ModelSettings { kind: ModelKind::Impact },
        girders: vec![girder],
        abutments: vec![wall],
        contact: ContactSettings::default(),
        impact,
        motion: Motion::None,
        solver: SolverSettings::default(),
        view: ViewSettings::default(),
    }
}

fn run(scene: &Scene) -> History {
    let history = History::of(scene).expect("a sound scene");
    assert!(history.stop().is_none(), "runs to its end: {:?}", history.stop());
    history
}

/// Velocity after a full-edge hit along the axis at 0.5 m/s of the deck of 30 m by 10 m, e = 0.5.
fn full_edge(skew_deg: f64, mu: f64, flush: Flush) -> [f64; 3] {
    let mut deck = girder(30.0, 10.0, skew_deg);
    deck.initial.velocity = [0.5, 0.0, 0.0];
    let impact =
        ImpactSettings { restitution_normal: 0.5, mu_static: mu, mu_kinetic: mu, flush, ..ImpactSettings::default() };
    let history = run(&scene(deck, 0.1, 0.3, impact));
    let motion = history.motion(0, 0.25);
    [motion.velocity.x, motion.velocity.y, motion.spin.z]
}

#[test]
fn a_full_edge_hit_is_the_rigid_parallelograms() {
    for (skew, mu, expected) in [
        (45.0, 0.0, [0.170, 0.330, 0.018]),
        (60.0, 0.0, [-0.04368, 0.31389, 0.01259]),
        (60.0, 0.3, [-0.15993, 0.15601, 0.0]),
    ] {
        let found = full_edge(skew, mu, Flush::TwoCorner);
        for (found, expected) in found.into_iter().zip(expected) {
            // Half of the last digit given.
            let digit = if skew == 45.0 { 5e-4 } else { 5e-6 };
            assert!((found - expected).abs() <= digit, "β = {skew}°, μ = {mu}: {found} against {expected}");
        }
    }
}

#[test]
fn a_full_edge_hit_turns_the_deck_where_the_rotation_condition_says() {
    for skew in [35.0f64, 45.0, 60.0, 70.0, 75.0, 80.0, 85.0] {
        for mu in [0.0, 0.1, 0.2, 0.3, 0.5] {
            let a = (90.0 - skew).to_radians();
            // Where friction holds the edge, it is another law's.
            if mu >= a.tan() / 1.5 {
                continue;
            }
            let turns = 3.0 * a.cos() * (a.sin() - mu * a.cos()) > 1.0;
            let spin = full_edge(skew, mu, Flush::TwoCorner)[2];
            assert_eq!(spin.abs() > 1e-9, turns, "β = {skew}°, μ = {mu}: {spin} rad/s");
        }
    }
}

#[test]
fn friction_holds_the_edge_from_tan_a_over_one_plus_e() {
    let a = 20f64.to_radians();
    let limit = a.tan() / 1.5;
    let along = |mu: f64| {
        let [x, y, _] = full_edge(70.0, mu, Flush::TwoCorner);
        // The face runs along (cos β, sin β).
        (x * a.sin() + y * a.cos()).abs()
    };
    assert!(along(1.001 * limit) < 1e-12, "held: {}", along(1.001 * limit));
    assert!(along(0.999 * limit) > 1e-5, "slides: {}", along(0.999 * limit));
}

#[test]
fn the_two_rules_for_a_face_part_on_a_skewed_deck() {
    let paper = full_edge(45.0, 0.0, Flush::Paper);
    let corners = full_edge(45.0, 0.0, Flush::TwoCorner);
    assert!((paper[2] - corners[2]).abs() > 1e-3, "{paper:?} against {corners:?}");
}

#[test]
fn a_girder_that_bounces_under_a_constant_pull_comes_to_rest_as_the_closed_form_does() {
    for e in [0.2, 0.5, 0.8] {
        let (gap, pull) = (0.01, 3.0);
        let mut deck = girder(0.19, 0.07, 90.0);
        deck.push.force = [2.0 * pull, 0.0, 0.0];
        deck.held = vec![Direction::Y];
        let impact = ImpactSettings { restitution_normal: e, ..ImpactSettings::default() };
        let history = run(&scene(deck, gap, 2.0, impact));
        let (mut t, mut v) = ((2.0f64 * gap / pull).sqrt(), (2.0f64 * gap * pull).sqrt());
        let record = history.impact().expect("the impact model");
        for hit in &record.hits {
            assert!((hit.t - t).abs() < 1e-12 && (hit.approach[0] + v).abs() < 1e-11, "e = {e}: {hit:?} at {t}");
            v *= e;
            t += 2.0 * v / pull;
        }
        assert!(v < e * impact.stop_speed && v >= e * e * impact.stop_speed, "stops below the stop speed: {v}");
        assert_eq!(record.state(0, 1.9), State::Resting, "e = {e}: rests");
        // What the rule leaves out is hops of less than v²/(2 a).
        let hop = impact.stop_speed.powi(2) / (2.0 * pull);
        let end = history.motion(0, 2.0).displacement.x;
        assert!((end - gap).abs() <= hop, "e = {e}: {end} at the end");
        let mut worst = 0.0f64;
        for i in 0..=2000 {
            let t = 2.0 * f64::from(i) / 2000.0;
            worst = worst.max((history.motion(0, t).displacement.x - bounce(gap, pull, e, t)).abs());
        }
        assert!(worst <= 2.0 * hop, "e = {e}: {worst} m off, {hop} allowed");
    }
}

/// Place of a girder that falls on a wall by a constant pull and bounces for ever.
fn bounce(gap: f64, pull: f64, e: f64, t: f64) -> f64 {
    let (mut start, mut v) = (0.0, 0.0);
    let mut next = (2.0 * gap / pull).sqrt();
    let mut from = -gap;
    loop {
        if t < next {
            let tau = t - start;
            return gap + from - v * tau + 0.5 * pull * tau * tau;
        }
        v = if from < 0.0 { e * (2.0 * gap * pull).sqrt() } else { e * v };
        if v < 1e-12 {
            return gap;
        }
        (start, from) = (next, 0.0);
        next += 2.0 * v / pull;
    }
}

#[test]
fn runs_are_the_same_in_portions_and_on_any_number_of_threads() {
    let scene = girderbench::scene::presets::load("row-of-5").expect("a preset");
    let mut scene = scene;
    scene.model.kind = ModelKind::Impact;
    let whole = History::of(&scene).expect("runs");
    let mut session = girderbench::sim::Session::new(&scene).expect("a sound scene");
    session.advance(scene.duration, &mut |_| true);
    assert_eq!(session.finish().digest(), whole.digest(), "portions");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    assert_eq!(pool.install(|| History::of(&scene).expect("runs").digest()), whole.digest(), "one thread");
    within("row ledger", whole.ledger(whole.end()).residual.abs() / whole.ledger(whole.end()).scale, 1e-9);
}
