//! What must not change the answer: mirrors, turning the whole scene, the order of bodies, threads, portions.

use crate::support::{run, within};
use girderbench::scene::{Bearings, Between, FrictionLaw, Kind, Motion, Scene, presets};
use girderbench::sim::{History, Session};
use glam::{DMat3, DVec3};

fn preset(name: &str) -> Scene {
    let mut scene = presets::load(name).unwrap_or_else(|errors| panic!("{errors}"));
    scene.solver.tolerance = 1e-12;
    scene.duration = 4.0;
    scene
}

fn angle(scene: &mut Scene) -> &mut f64 {
    match &mut scene.motion {
        Motion::Sine(sine) => &mut sine.angle_deg,
        _ => panic!("the presets used here shake by a sine"),
    }
}

/// Largest difference between two runs under a map of places and rotations.
fn apart(a: &History, b: &History, map: impl Fn(DVec3, f64) -> (DVec3, f64)) -> f64 {
    let mut worst = 0.0f64;
    for i in 0..=400 {
        let t = 4.0 * f64::from(i) / 400.0;
        for body in 0..a.model().bodies.len() {
            let (m, n) = (a.motion(body, t), b.motion(body, t));
            let (d, theta) = map(m.displacement, m.theta);
            worst = worst.max((d - n.displacement).length()).max((theta - n.theta).abs() * 0.05);
        }
    }
    worst
}

#[test]
fn a_mirrored_scene_answers_mirrored() {
    for (name, shake) in [("skew45-abutment", 20.0), ("skew60-abutment", -30.0)] {
        let mut scene = preset(name);
        *angle(&mut scene) = shake;
        let mut mirrored = scene.clone();
        mirrored.girders[0].skew_deg = 180.0 - scene.girders[0].skew_deg;
        *angle(&mut mirrored) = -shake;
        let worst = apart(&run(&scene), &run(&mirrored), |d, theta| (d.with_y(-d.y), -theta));
        // cos 45° and cos 135° differ in the last bit; four seconds of hits carry it on.
        within(&format!("{name} mirrored"), worst, 1e-11);
    }
}

#[test]
fn a_turned_scene_answers_turned() {
    for turn in [90.0, 180.0, 33.0] {
        let scene = preset("skew45-abutment");
        let mut turned = scene.clone();
        turned.girders[0].heading_deg = turn;
        *angle(&mut turned) += turn;
        let rotation = DMat3::from_rotation_z(f64::to_radians(turn));
        let worst = apart(&run(&scene), &run(&turned), |d, theta| (rotation * d, theta));
        within(&format!("turned by {turn}°"), worst, 1e-11);
    }
}

/// A spatial scene of a preset with every vector that a scene can hold, tilted and pushed.
fn in_space(name: &str, law: FrictionLaw, tolerance: f64) -> Scene {
    let mut scene = preset(name);
    (scene.kind, scene.contact.law, scene.solver.tolerance, scene.duration) = (Kind::Spatial, law, tolerance, 1.5);
    for girder in &mut scene.girders {
        if let Some(Bearings::Shared(bearings)) = &mut girder.bearings {
            bearings.vertical_frequency_hz.get_or_insert(15.0);
        }
    }
    let girder = &mut scene.girders[0];
    girder.initial.displacement = [1e-4, -2e-4, 1e-4];
    girder.initial.velocity = [0.01, 0.02, -0.01];
    (girder.initial.roll_deg, girder.initial.pitch_deg) = (Some(0.3), Some(-0.1));
    girder.push.force = [0.1, 0.2, 0.1];
    (girder.push.moment_x, girder.push.moment_y) = (Some(1e-3), Some(-2e-3));
    scene
}

/// The whole scene turned in plan \[°\].
fn turned_by(scene: &Scene, turn: f64) -> Scene {
    let rotation = DMat3::from_rotation_z(turn.to_radians());
    let rotate = |vector: [f64; 3]| (rotation * DVec3::from_array(vector)).to_array();
    let mut turned = scene.clone();
    for girder in &mut turned.girders {
        girder.heading_deg += turn;
        girder.position = rotate(girder.position);
        girder.initial.displacement = rotate(girder.initial.displacement);
        girder.initial.velocity = rotate(girder.initial.velocity);
        girder.push.force = rotate(girder.push.force);
        let moment = [girder.push.moment_x, girder.push.moment_y].map(Option::unwrap_or_default);
        let [x, y, _] = rotate([moment[0], moment[1], 0.0]);
        (girder.push.moment_x, girder.push.moment_y) = (Some(x), Some(y));
    }
    *angle(&mut turned) += turn;
    turned
}

/// Largest difference of places \[m\] and of θ \[rad\] between a run and one that is turned by an angle \[°\].
fn apart_in_space(a: &History, b: &History, turn: f64) -> [f64; 2] {
    let rotation = DMat3::from_rotation_z(turn.to_radians());
    let times = (0..=600).map(|i| a.end() * f64::from(i) / 600.0);
    let at = |t: f64, body: usize| {
        let (m, n) = (a.motion(body, t), b.motion(body, t));
        [(rotation * m.displacement - n.displacement).length(), (m.theta - n.theta).abs()]
    };
    let all = times.flat_map(|t| (0..a.model().bodies.len()).map(move |body| at(t, body)));
    all.fold([0.0; 2], |[place, theta], [p, q]| [f64::max(place, p), f64::max(theta, q)])
}

#[test]
fn a_spatial_scene_turned_by_any_angle_differs_by_no_more_than_its_tolerance_leaves_open() {
    // Steps are the same until a node stops under law `paper`: there friction turns within 1e-6 m/s of sliding, and the rounding of
    // a velocity decides how long they are.
    for (name, law) in [
        ("skew45-abutment", FrictionLaw::Paper),
        ("skew45-abutment", FrictionLaw::ReturnMapping),
        ("straight-straight", FrictionLaw::Paper),
        ("straight-straight", FrictionLaw::ReturnMapping),
    ] {
        for turn in [37.0, 90.0] {
            let mut gyration = f64::INFINITY;
            let [[coarse, by_tolerance], [fine, _]] = [1e-10, 1e-12].map(|tolerance| {
                let scene = in_space(name, law, tolerance);
                let history = run(&scene);
                let finer = run(&in_space(name, law, 1e-13));
                gyration = history.model().bodies[0].gyration2.sqrt();
                [apart_in_space(&history, &run(&turned_by(&scene, turn)), turn), apart_in_space(&history, &finer, 0.0)]
            });
            // An angle rounds as a place does, over the radius of gyration.
            for (what, k, rounding) in [("place", 0, 1e-13), ("theta", 1, 1e-13 / gyration)] {
                within(&format!("{name}, {law:?}, {turn}°: {what}"), coarse[k], 3.0 * by_tolerance[k] + rounding);
                within(&format!("{name}, {law:?}, {turn}°: {what}, finer"), fine[k], 0.1 * coarse[k] + 1e-12);
            }
        }
    }
}

#[test]
fn the_order_of_bodies_in_the_file_does_not_matter() {
    let scene = preset("straight-straight");
    let mut swapped = scene.clone();
    swapped.girders.reverse();
    let (a, b) = (run(&scene), run(&swapped));
    let mut worst = 0.0f64;
    for i in 0..=400 {
        let t = 4.0 * f64::from(i) / 400.0;
        for body in 0..2 {
            let apart = a.motion(body, t).displacement - b.motion(1 - body, t).displacement;
            worst = worst.max(apart.length());
        }
    }
    // Sums run in another order.
    within("swapped", worst, 1e-11);
}

#[test]
fn the_answer_is_the_same_to_the_bit_again_in_portions_and_on_any_number_of_threads() {
    for name in ["skew45-abutment", "straight-straight", "row-of-5"] {
        let mut scene = preset(name);
        scene.solver.tolerance = 1e-9;
        // What is said on the way is of the pairs that there are: bodies that meet otherwise are joined at the end.
        scene.contact.between = Between::Ends;
        if name != "straight-straight" {
            // A second group that no pair joins to the first.
            let mut far = scene.girders[0].clone();
            far.name = "far".into();
            far.position[1] += 1000.0;
            scene.girders.push(far);
        }
        let first = run(&scene);
        assert!(!first.hits().touches().is_empty(), "{name}: contacts are in play");
        assert_eq!(first.digest(), run(&scene).digest(), "{name}: again");
        let mut session = Session::new(&scene).expect("valid");
        for until in [0.3, 1.0, 2.7, scene.duration, 4.0] {
            session.advance(until, &mut |_| true);
            for (girder, now) in session.motions().expect("it goes on").iter().enumerate() {
                let apart = (now.displacement - first.motion(girder, until).displacement).length();
                assert!(apart < 1e-12, "{name}: girder {girder} on the way, at {until}: {apart:e} m");
            }
        }
        assert_eq!(first.digest(), session.finish().digest(), "{name}: in portions");
        for threads in [1, 2, 5] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            assert_eq!(first.digest(), pool.install(|| run(&scene).digest()), "{name}: {threads} threads");
        }
    }
}

#[test]
fn an_answer_cut_short_is_that_of_a_shorter_scene() {
    let scene = preset("skew45-abutment");
    let whole = run(&scene);
    let until = whole.events()[whole.events().len() / 2].t + 1e-3;
    let (cut, short) = (whole.cut(until), run(&Scene { duration: until, ..scene }));
    assert_eq!(cut.end(), short.end());
    assert_eq!(cut.events(), short.events());
    assert_eq!(cut.hits().touches().len(), short.hits().touches().len());
    for (a, b) in cut.hits().touches().iter().zip(short.hits().touches()) {
        assert_eq!((a.contact, a.start, a.end), (b.contact, b.start, b.end));
        // The shorter run's last step ends where the other one is read within.
        within("peak force", (a.peak_force - b.peak_force).abs(), 1e-9 * b.peak_force);
    }
    for i in 0..=20 {
        let t = until * f64::from(i) / 20.0;
        within("place", (cut.motion(0, t).displacement - short.motion(0, t).displacement).length(), 1e-12);
        let [a, b] = [cut.energy().ledger(t), short.energy().ledger(t)];
        within("friction", (a.loss_friction - b.loss_friction).abs(), 1e-10 * b.scale.max(1e-6));
        within("residual", (a.residual - b.residual).abs(), 1e-10 * b.scale.max(1e-6));
    }
}

#[test]
fn a_cancelled_run_keeps_what_it_has() {
    let scene = preset("skew45-abutment");
    let mut session = Session::new(&scene).expect("valid");
    session.advance(4.0, &mut |reached| reached.t < 1.5);
    let part = session.finish();
    assert!(part.end() >= 1.4 && part.end() < 4.0, "it stops where it was told, at {}", part.end());
    let whole = run(&scene);
    for i in 0..=100 {
        // The last product may round to beyond the end, where only the whole run goes on.
        let t = (part.end() * f64::from(i) / 100.0).min(part.end());
        assert_eq!(part.motion(0, t), whole.motion(0, t), "the same to the bit at {t}");
    }
}
