//! Runs of the impact model against closed forms.

use crate::support::within;
use girderbench::dynamics::impact2d::GirderState;
use girderbench::scene::{
    Abutment, Direction, Flush, Girder, ImpactSettings, ModelKind, ModelSettings, Motion, RecordMotion, Scene, presets,
};
use girderbench::sim::History;

fn girder(length: f64, width: f64, skew_deg: f64) -> Girder {
    Girder { skew_deg, ..Girder::straight("deck", [length, width, 1.0], 2.0) }
}

fn scene(girder: Girder, gap: f64, duration: f64, impact: ImpactSettings) -> Scene {
    let wall = Abutment {
        delay: None,
        motion_factor: None,
        ground: None,
        backfill: None,
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
        model: ModelSettings { kind: ModelKind::Impact },
        girders: vec![girder],
        abutments: vec![wall],
        impact,
        motion: Motion::None,
        ..Scene::empty("closed form", duration)
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
            assert!(
                (hit.t - t).abs() < 1e-12 && (hit.impulses.approach[0] + v).abs() < 1e-11,
                "e = {e}: {hit:?} at {t}"
            );
            v *= e;
            t += 2.0 * v / pull;
        }
        assert!(v < e * impact.stop_speed && v >= e * e * impact.stop_speed, "stops below the stop speed: {v}");
        assert_eq!(record.state(0, 1.9), GirderState::Resting, "e = {e}: rests");
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
    for part in [0.2, 0.5, 1.0] {
        session.advance(part * scene.duration, &mut |_| true);
        for (girder, now) in session.motions().expect("it goes on").iter().enumerate() {
            let apart = (now.displacement - whole.motion(girder, part * scene.duration).displacement).length();
            assert!(apart < 1e-12, "girder {girder} on the way: {apart:e} m");
        }
    }
    assert_eq!(session.finish().digest(), whole.digest(), "portions");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    assert_eq!(pool.install(|| History::of(&scene).expect("runs").digest()), whole.digest(), "one thread");
    within(
        "row ledger",
        whole.energy().ledger(whole.end()).residual.abs() / whole.energy().ledger(whole.end()).scale,
        1e-9,
    );
}

/// A girder pressed on a wall and pushed along it, without bearings.
fn pressed(push: [f64; 2], v_y: f64) -> Scene {
    let mut deck = girder(0.19, 0.07, 90.0);
    deck.push.force = [push[0], push[1], 0.0];
    deck.initial.velocity = [0.0, v_y, 0.0];
    scene(deck, 0.001, 2.0, ImpactSettings::default())
}

#[test]
fn a_girder_that_rocks_as_it_lands_ends_on_its_face() {
    for (push, v_y) in [(5.0, 0.02), (10.0, 0.05), (20.0, 0.1), (10.0, 0.3)] {
        let history = run(&pressed([push, 0.0], v_y));
        let record = history.impact().expect("the impact model");
        assert_eq!(
            record.state(0, 2.0),
            GirderState::Resting,
            "push {push} N, {v_y} m/s: {:?}",
            record.transitions.last()
        );
        let end = history.motion(0, 2.0);
        assert!(
            (end.displacement.x - 0.001).abs() < 1e-9 && end.theta.abs() < 1e-8,
            "push {push} N, {v_y} m/s: lies on the wall: {end:?}"
        );
    }
}

/// Shaken along the wall by a sine.
fn shaken(push: f64, amplitude: f64, frequency_hz: f64, phase_deg: f64, duration: f64) -> Scene {
    let mut scene = pressed([push, 0.0], 0.0);
    scene.abutments[0].gap = Some(0.0);
    scene.duration = duration;
    scene.motion = Motion::Sine(girderbench::scene::SineMotion {
        amplitude_g: None,
        amplitude: Some(amplitude),
        frequency_hz,
        phase_deg,
        angle_deg: 90.0,
        vertical_amplitude_g: None,
        vertical_amplitude: None,
        vertical_phase_deg: None,
    });
    scene
}

#[test]
fn what_breaks_away_and_stops_rests_again_and_no_break_is_overlooked() {
    // μ_s N = 2 N holds 1 m/s²; a twentieth of a per cent more breaks, whatever the phase.
    for phase in [0.0, 2.8125, 33.3, 77.0, 90.0, 123.4] {
        let history = run(&shaken(10.0, 1.0005, 1.0, phase, 4.0));
        let record = history.impact().expect("the impact model");
        let slides = record.transitions.iter().filter(|change| change.to == GirderState::Sliding).count();
        let rests = record.transitions.iter().filter(|change| change.to == GirderState::Resting).count();
        assert!(slides >= 7 && rests >= 7, "phase {phase}°: {slides} slides, {rests} rests");
        assert!(record.hits.is_empty(), "phase {phase}°: nothing hits: {:?}", record.hits.first());
        let end = history.motion(0, 4.0);
        assert!(
            end.displacement.x.abs() < 1e-10 && end.theta.abs() < 1e-9,
            "phase {phase}°: stays on the wall: {end:?}"
        );
    }
}

#[test]
fn who_rests_on_a_wall_is_hit_by_who_swings_fast() {
    let mut resting = girder(0.19, 0.07, 90.0);
    resting.push.force = [-10.0, 0.0, 0.0];
    resting.name = "resting".to_owned();
    let mut scene = scene(resting, 0.0, 2.0, ImpactSettings::default());
    scene.abutments[0].faces = "resting".to_owned();
    scene.abutments[0].end = girderbench::geometry::End::Minus;
    let mut swinging = girder(0.19, 0.07, 90.0);
    swinging.name = "swinging".to_owned();
    swinging.position = [0.195, 0.0, 0.0];
    swinging.bearings =
        girderbench::scene::presets::load("straight-abutment").expect("a preset").girders[0].bearings.clone();
    if let Some(girderbench::scene::Bearings::Shared(shared)) = &mut swinging.bearings {
        shared.frequency_hz = girderbench::scene::PerDirection::Both(20.0);
        shared.damping_ratio = girderbench::scene::PerDirection::Both(0.0);
    }
    let omega = 2.0 * std::f64::consts::PI * 20.0;
    swinging.initial.displacement = [0.005_54, 0.0, 0.0];
    scene.girders.push(swinging);
    let history = run(&scene);
    let first = history.impact().expect("the impact model").hits.iter().map(|hit| hit.t).find(|&t| t > 0.0);
    let expected = (-0.005f64 / 0.005_54).acos() / omega;
    assert!((first.expect("it is hit") - expected).abs() < 1e-10, "{first:?} against {expected}");
}

#[test]
fn both_girders_of_a_hit_change_their_states() {
    let mut turned = girder(0.19, 0.07, 90.0);
    turned.initial.rotation_deg = 5.0;
    turned.initial.velocity = [0.3, 0.0, 0.0];
    let mut scene = scene(turned, 1.0, 0.1, ImpactSettings::default());
    scene.abutments.clear();
    let mut other = girder(0.19, 0.07, 90.0);
    other.name = "other".to_owned();
    other.position = [0.205, 0.0, 0.0];
    scene.girders.push(other);
    let history = run(&scene);
    let record = history.impact().expect("the impact model");
    assert_eq!(record.state(1, 0.0), GirderState::Free, "at rest");
    assert!(history.motion(1, 0.1).spin.z.abs() > 0.1, "it is turned");
    assert_eq!(record.state(1, 0.1), GirderState::FreeTurning, "and says so");
}

#[test]
fn a_slow_face_is_met_smoothly_and_lasting_contact_reaches_the_end() {
    let mut deck = girder(0.19, 0.07, 90.0);
    deck.initial.velocity = [5e-5, 0.5, 0.0];
    deck.push.force = [1.0, 0.0, 0.0];
    let history = run(&scene(deck, 1e-6, 0.5, ImpactSettings::default()));
    let record = history.impact().expect("the impact model");
    let slow = record.hits.iter().find(|hit| hit.impulses.approach[0].abs() < 1e-4);
    if let Some(hit) = slow {
        assert_eq!((hit.impulses.first[1], hit.impulses.offset), (0.0, 0.0), "e_t = −1 and ζ = 0 below the stop speed");
    }
    let end = history.end();
    assert!(record.state(0, end).touches(), "still on the wall");
    assert!(!history.contacts().at(end).is_empty(), "and pushed at the last instant");
    assert!(history.events().iter().all(|event| event.t < end), "nothing opens because the run ends");
}

/// Pressed against the wall by `push` \[N\] and sliding along it.
fn sliding(push: f64, v_y: f64, skew_deg: f64) -> Scene {
    let a = (90.0 - skew_deg).to_radians();
    let mut scene = scene(girder(0.19, 0.07, skew_deg), 0.0, 1.0, ImpactSettings::default());
    // Square to the face, so that it lies on it; along the face.
    scene.girders[0].push.force = [push * a.cos(), -push * a.sin(), 0.0];
    scene.girders[0].initial.velocity = [v_y * a.sin(), v_y * a.cos(), 0.0];
    scene
}

#[test]
fn a_face_that_friction_alone_stops_does_so_where_and_when_the_parabola_says() {
    for skew_deg in [90.0, 80.0] {
        let scene = sliding(10.0, 0.3, skew_deg);
        let history = run(&scene);
        let record = history.impact().expect("the impact model");
        let slowing = scene.impact.mu_kinetic * 10.0 / 2.0;
        let stops = 0.3 / slowing;
        let rests = record.transitions.iter().find(|change| change.to == GirderState::Resting).expect("it stops").t;
        within(&format!("{skew_deg}° stops"), (rests - stops).abs(), 1e-15);
        for i in 0..=20 {
            let t = 0.05 * f64::from(i);
            let held = t.min(stops);
            let along = 0.3 * held - 0.5 * slowing * held * held;
            let here = history.motion(0, t);
            within(&format!("{skew_deg}° at {t}"), (here.displacement.truncate().length() - along).abs(), 1e-16);
            assert_eq!((here.theta, here.spin.z), (0.0, 0.0), "a face that slides does not turn");
        }
    }
}

#[test]
fn a_face_that_slides_on_its_bearings_is_the_damped_oscillator_about_where_friction_would_hold_it() {
    let mut scene = sliding(10.0, 0.5, 90.0);
    scene.girders[0].bearings =
        girderbench::scene::presets::load("straight-abutment").expect("a preset").girders[0].bearings.clone();
    let history = run(&scene);
    let record = history.impact().expect("the impact model");
    let (omega, h) = (std::f64::consts::TAU * 2.4, 0.29);
    let rest = -scene.impact.mu_kinetic * 10.0 / (2.0 * omega * omega);
    let (decay, swing) = (h * omega, omega * (1.0f64 - h * h).sqrt());
    // u − rest = e^{−γt} (A cos + B sin).
    let (a, b) = (-rest, (0.5 - decay * rest) / swing);
    let place = |t: f64| rest + (-decay * t).exp() * (a * (swing * t).cos() + b * (swing * t).sin());
    let stops = (b * swing - a * decay).atan2(a * swing + b * decay) / swing;
    within("turns round", history.motion(0, stops).velocity.y.abs(), 1e-14);
    assert!(history.motion(0, stops + 1e-6).velocity.y < 0.0, "the bearings break what friction would hold");
    assert_eq!(record.state(0, 1.0), GirderState::Resting, "until it comes to rest");
    for i in 0..=40 {
        let t = stops * f64::from(i) / 40.0;
        let here = history.motion(0, t);
        within(&format!("at {t}"), (here.displacement.y - place(t)).abs(), 1e-16);
        assert_eq!(here.displacement.x, 0.0, "it stays on the wall to the last bit");
    }
    let ledger = history.energy().ledger(history.end());
    within("ledger", ledger.residual.abs() / ledger.scale, 1e-13);
}

#[test]
fn a_pressed_girder_comes_to_rest_at_a_wall_of_any_width() {
    // Under a constant push every hop returns with the speed that it left with: e v, e² v, …, until that is below the stop speed.
    for (length, width, restitution) in [(30.0, 600.0, 0.05), (30.0, 20_000.0, 0.002), (60.0, 1200.0, 0.3)] {
        let settings = ImpactSettings { restitution_normal: restitution, ..ImpactSettings::default() };
        let mut scene = scene(girder(length, length / 3.0, 90.0), 0.05, 1.0, settings);
        scene.abutments[0].width = Some(width);
        (scene.girders[0].mass, scene.girders[0].push.force) = (1e5, [8e5, 0.0, 0.0]);
        let history = History::of(&scene).expect("runs");
        assert!(
            history.stop().is_none() && history.overlaps().is_empty(),
            "{length} m at {width} m: {:?}",
            history.stop()
        );
        let record = history.impact().expect("hits");
        let arrival = (2.0f64 * 8.0 * 0.05).sqrt();
        // One hop more that is met behind the face, and the one that ends at rest.
        let hops = (scene.impact.stop_speed / arrival).ln() / restitution.ln();
        #[expect(clippy::cast_precision_loss, reason = "a few hits")]
        let hits = record.hits.len() as f64;
        assert!(hits <= hops.ceil() + 2.0, "{length} m at {width} m: {hits} hits, {hops} by e");
        assert_eq!(record.state(0, 1.0), GirderState::Resting, "pressed onto the wall");
        // The band within which a point touches is 1e-9 of the girder's radius, 1.6e-8 m at 30 m; it is moved out to the face.
        within("place", history.motion(0, 1.0).displacement.x - 0.05, 1e-9);
    }
}

/// A girder of 0.19 by 0.07 m pressed on its wall by 10 N while the ground's acceleration along the wall rises to 3 m/s² within a second.
/// The pressure reaches the end of the face at T/N = b/a = 7/19, between the friction of the corner and that of the face: the face slides
/// with that ratio, ÿ = −3 (t − t₀) from 6 t₀ = 10 b/a on.
#[test]
fn a_face_pressed_at_its_end_slides_by_the_lever_of_its_corner_however_the_ground_is_sampled() {
    let ratio = 7.0 / 19.0;
    let start = 10.0 * ratio / 6.0;
    let exact = -0.5 * (1.0_f64 - start).powi(3);
    for count in [1, 2, 10] {
        let dt = 1.0 / f64::from(count);
        let samples = (0..=2 * count).map(|n| 3.0 * (1.0 - (f64::from(n) * dt - 1.0).abs())).collect();
        let record = RecordMotion { samples: Some(samples), dt: Some(dt), angle_deg: 90.0, ..RecordMotion::default() };
        let mut deck = girder(0.19, 0.07, 90.0);
        deck.push.force = [10.0, 0.0, 0.0];
        let impact = ImpactSettings {
            mu_static: 0.4,
            mu_kinetic: 0.38,
            corner_mu_static: Some(0.36),
            corner_mu_kinetic: Some(0.35),
            ..ImpactSettings::default()
        };
        let scene = Scene { motion: Motion::Record(record), ..scene(deck, 0.0, 1.0, impact) };
        let history = run(&scene);
        within(&format!("{count} samples a second: place [m]"), history.motion(0, 1.0).displacement.y - exact, 1e-9);
        within("turn [rad]", history.motion(0, 1.0).theta, 1e-15);
        assert!(history.contacts().without_friction().is_none(), "with friction all the time");
        let lost = history.energy().ledger(1.0).loss_friction;
        within("lost in friction [J]", lost - 10.0 * ratio * exact.abs(), 1e-8);
    }
}

/// The same with kinetic friction of the face below b/a and static above: once the end opens, the face slides under pressure at both ends,
/// ÿ = −(6 t − 3.6)/2 from t₀ on.
#[test]
fn a_face_that_opens_at_its_end_slides_flush_where_its_kinetic_friction_does_not_turn_it() {
    let start: f64 = 10.0 * 7.0 / 19.0 / 6.0;
    let record =
        RecordMotion { samples: Some(vec![0.0, 3.0]), dt: Some(1.0), angle_deg: 90.0, ..RecordMotion::default() };
    let mut deck = girder(0.19, 0.07, 90.0);
    deck.push.force = [10.0, 0.0, 0.0];
    let impact = ImpactSettings {
        mu_static: 0.4,
        mu_kinetic: 0.36,
        corner_mu_static: Some(0.36),
        corner_mu_kinetic: Some(0.35),
        ..ImpactSettings::default()
    };
    let history = run(&Scene { motion: Motion::Record(record), ..scene(deck, 0.0, 0.99, impact) });
    let (t, from) = (0.99_f64, start);
    let speed = |t: f64| 0.5 * t.powi(3) - 0.9 * t * t;
    let exact = -(speed(t) - speed(from) - (1.5 * from * from - 1.8 * from) * (t - from));
    within("place [m]", history.motion(0, t).displacement.y - exact, 1e-9);
    assert!(history.contacts().without_friction().is_none(), "with friction all the time");
}

/// Points in lasting contact drift by what a step may err: 334 hits at 1e-4 where that counted as one.
#[test]
fn the_error_of_the_integrator_is_no_hit() {
    let hits = |tolerance: f64| {
        let mut scene = presets::load("straight-straight").expect("ships");
        (scene.model.kind, scene.solver.tolerance) = (ModelKind::Impact, tolerance);
        History::of(&scene).expect("runs").hits().count()
    };
    let [coarse, fine] = [1e-4, 1e-6].map(hits);
    assert!(coarse.abs_diff(fine) <= fine / 50, "{coarse} hits at 1e-4, {fine} at 1e-6");
}
