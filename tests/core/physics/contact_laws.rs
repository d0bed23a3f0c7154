//! Contact: restitution, momentum, static loads, creep, sharing, tension.

use crate::support::{free_hit, free_pair, run, within};
use girderbench::geometry::Face;
use girderbench::scene::{Direction, FrictionLaw, Scene, Sharing, Tension};
use girderbench::sim::{ContactState, EventKind, History};
use glam::DVec3;

#[test]
fn flush_hit_returns_the_restitution_asked_for() {
    for e in [0.01, 0.1, 0.4, 0.7, 0.95, 1.0] {
        for law in [FrictionLaw::Paper, FrictionLaw::ReturnMapping] {
            let mut scene = free_hit();
            scene.contact.restitution_normal = e;
            scene.contact.law = law;
            scene.duration = 0.2;
            let v = run(&scene).motion(0, 0.2).velocity.x;
            within(&format!("e = {e}, {law:?}"), -v / 0.5 - e, 1e-9);
        }
    }
}

#[test]
fn per_node_sharing_doubles_the_stiffness_of_two_corners_and_the_papers_restitution_is_lost() {
    let mut scene = free_hit();
    scene.contact.sharing = Sharing::PerNode;
    let e = -run(&scene).motion(0, 0.1).velocity.x / 0.5;
    // Two whole springs and dashpots: ξ' = ξ √2, so e' = exp(−π ξ'/√(1 − ξ'²)).
    let xi = girderbench::contact::damping_ratio(0.4) * std::f64::consts::SQRT_2;
    let expected = (-std::f64::consts::PI * xi / (1.0 - xi * xi).sqrt()).exp();
    within("restitution of two whole springs", e - expected, 1e-9);
}

#[test]
fn clamped_contacts_never_pull_and_return_more() {
    let mut scene = free_hit();
    scene.contact.tension = Tension::Clamp;
    let history = run(&scene);
    let touch = history.hits().hardest().expect("it hits");
    for i in 0..=1000 {
        let t = touch.start + (touch.end - touch.start) * f64::from(i) / 1000.0;
        for contact in history.contacts().at(t) {
            let pushed = contact.force.dot(contact.normal);
            assert!(pushed >= -1e-12 * touch.peak_force, "pulls {pushed} N at {t}");
        }
    }
    // Kelvin–Voigt from −v with the pull cut off at K δ = C |δ̇|: the crossing angle is known in closed form.
    let xi = girderbench::contact::damping_ratio(0.4);
    let root = (1.0 - xi * xi).sqrt();
    let angle = (2.0 * xi * root).atan2(2.0 * xi * xi - 1.0);
    let e = (-xi / root * angle).exp();
    within("restitution without tension", -history.motion(0, 0.1).velocity.x / 0.5 - e, 1e-9);
}

#[test]
fn a_hit_between_girders_keeps_momentum_and_angular_momentum_up_to_the_couple() {
    let mut scene = free_pair();
    scene.girders[0].initial.displacement = [0.0, 0.012, 0.0];
    scene.girders[0].initial.velocity = [0.5, 0.05, 0.0];
    scene.girders[0].initial.spin_deg_s = 25.0;
    for law in [FrictionLaw::Paper, FrictionLaw::ReturnMapping] {
        scene.contact.law = law;
        let history = run(&scene);
        assert!(history.hits().touches().len() >= 2, "both corners touch");
        let momentum = |t: f64| -> DVec3 { (0..2).map(|b| history.motion(b, t).velocity * 2.0).sum() };
        within("momentum", (momentum(0.1) - momentum(0.0)).length(), 1e-12);
        let i2 = history.model().bodies[0].gyration2;
        let spin = |t: f64| -> f64 {
            (0..2)
                .map(|b| {
                    let m = history.motion(b, t);
                    2.0 * (m.place.cross(m.velocity).z + i2 * m.spin.z)
                })
                .sum()
        };
        within("angular momentum less the couple", spin(0.1) - spin(0.0) - couple(&history), 1e-9);
    }
}

/// Time integral of `(X_k − X_p) × R_k` over all touches, by Simpson's rule between events.
fn couple(history: &History) -> f64 {
    let mut times: Vec<f64> = history.events().iter().map(|e| e.t).collect();
    times.dedup();
    let moment =
        |t: f64| -> f64 { history.contacts().at(t).iter().map(|c| (c.point - c.anchor).cross(c.force).z).sum() };
    let mut sum = 0.0;
    for w in times.windows(2) {
        let n = 400;
        let (from, h) = (w[0], (w[1] - w[0]) / f64::from(n));
        for i in 0..n {
            let a = from + h * f64::from(i);
            let b = a + h * (1.0 - 1e-9);
            sum += h / 6.0 * (moment(a) + 4.0 * moment(f64::midpoint(a, b)) + moment(b));
        }
    }
    sum
}

#[test]
fn two_ends_shifted_by_a_micrometre_answer_as_two_ends_aligned() {
    let aligned = run(&free_pair());
    let mut shifted = free_pair();
    shifted.girders[0].initial.displacement[1] = 1e-6;
    let shifted = run(&shifted);
    for (body, name) in ["one", "two"].into_iter().enumerate() {
        let apart = aligned.motion(body, 0.1).velocity - shifted.motion(body, 0.1).velocity;
        within(&format!("velocity of {name}"), apart.length() / 0.5, 1e-4);
    }
    let e = |h: &History| (h.motion(1, 0.1).velocity.x - h.motion(0, 0.1).velocity.x) / 0.5;
    within("restitution, aligned", e(&aligned) - 0.4, 1e-9);
    within("restitution, shifted", e(&shifted) - 0.4, 1e-6);
}

/// A block pressed on the wall, free to move along it only.
fn pressed(push: f64, law: FrictionLaw) -> Scene {
    let mut scene = free_hit();
    let pressure = 10.0;
    scene.girders[0].initial.velocity = [0.0; 3];
    scene.girders[0].initial.displacement = [0.005 + pressure / 1.55e5, 0.0, 0.0];
    scene.girders[0].held = vec![Direction::X, Direction::Yaw];
    scene.girders[0].push.force = [0.0, push, 0.0];
    scene.contact.law = law;
    scene.duration = 3.0;
    scene
}

fn speed(history: &History) -> f64 {
    (history.motion(0, 3.0).displacement.y - history.motion(0, 2.0).displacement.y).abs()
}

#[test]
fn a_steady_push_below_the_friction_limit_holds_under_return_mapping() {
    // Normal force 10 N: μ_s holds 2 N, μ_k 1.5 N. A push that sets in at once overshoots to 1.9 times itself, so the last
    // two break away first; sliding stops because μ_k still holds more than the push.
    for push in [0.5, 1.0, 1.2, 1.4] {
        let history = run(&pressed(push, FrictionLaw::ReturnMapping));
        within(&format!("creep under {push} N"), speed(&history), 1e-12);
        let contact = history.contacts().at(3.0);
        assert!(contact.iter().all(|c| c.state == ContactState::Stick), "both corners stick");
        let held: f64 = contact.iter().map(|c| -c.tangential_force.y).sum();
        within("the push is held", held - push, 1e-9);
    }
    assert!(speed(&run(&pressed(2.1, FrictionLaw::ReturnMapping))) > 0.1, "above the limit it slides");
}

#[test]
fn the_papers_law_creeps_between_its_two_limits_and_holds_below() {
    // μ_s F_n = 2 N and, after each re-stick from 0, μ_s F_n/(1 + e_t) = 1.053 N.
    within("below both limits", speed(&run(&pressed(0.98 * 2.0 / 1.9, FrictionLaw::Paper))), 1e-12);
    for push in [1.02 * 2.0 / 1.9, 1.2, 1.4] {
        let creeping = speed(&run(&pressed(push, FrictionLaw::Paper)));
        assert!((1e-4..1e-2).contains(&creeping), "about a millimetre a second, got {creeping} m/s under {push} N");
    }
}

/// Weights of the corners a, b, c, d of a face at a point in its plane, paper equations (66), (67). The foot of the perpendicular is taken
/// on both parallel sides, so `t1` and `t2` differ on a trapezium; `t2` is measured from d instead of c.
fn corner_weights(face: &Face, point: DVec3) -> [f64; 4] {
    let [a, b, c, d] = face.corners;
    let (ab, dc) = (b - a, c - d);
    let t = (point - a).dot(face.bitangent) / (d - a).dot(face.bitangent);
    let [t1, t2] = [(point - a).dot(ab) / ab.length_squared(), (point - d).dot(dc) / dc.length_squared()];
    [(1.0 - t1) * (1.0 - t), t1 * (1.0 - t), t2 * t, (1.0 - t2) * t]
}

#[test]
fn the_weights_give_a_point_of_a_trapezium_back() {
    let corners = [(0.0, 0.0), (4.0, 0.0), (3.0, 2.0), (1.0, 2.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
    let face = Face::new(corners, 1.0).expect("a trapezium is a face");
    let point = DVec3::new(1.7, 0.9, 0.0);
    let weights = corner_weights(&face, point);
    let back: DVec3 = (0..4).map(|i| weights[i] * corners[i]).sum();
    within("the point", (back - point).length(), 4e-15);
    within("sum of the weights", weights.iter().sum::<f64>() - 1.0, 1e-15);
}

#[test]
fn the_corners_get_what_the_point_gets() {
    let mut scene = free_pair();
    scene.girders[0].initial.displacement = [0.0, 0.012, 0.0];
    scene.girders[0].initial.velocity = [0.5, 0.2, 0.0];
    let history = run(&scene);
    let touch = history.hits().hardest().expect("they hit");
    let contact = history.contacts().contact_at(touch.contact, touch.peak_time).expect("closed at its peak");
    let site = &history.model().sites[touch.contact];
    let owner = history.motion(site.face_body.expect("a girder's face"), touch.peak_time);
    let world = |v: DVec3| owner.place + owner.attitude * v;
    let local = owner.attitude.inverse() * (contact.anchor - owner.place);
    let weights = corner_weights(&site.face, local);
    within("sum of the weights", weights.iter().sum::<f64>() - 1.0, 1e-14);
    let (mut force, mut moment) = (DVec3::ZERO, DVec3::ZERO);
    for (w, corner) in weights.iter().zip(site.face.corners) {
        force += -contact.force * *w;
        moment += (world(corner) - owner.place).cross(-contact.force * *w);
    }
    let direct = (contact.anchor - owner.place).cross(-contact.force);
    within("force", (force + contact.force).length() / touch.peak_force, 1e-14);
    within("moment about G", (moment - direct).length() / (touch.peak_force * 0.1), 1e-13);
}

#[test]
fn the_dashpots_impulse_over_a_flush_touch_is_nothing() {
    let history = run(&free_hit());
    let touch = history.hits().hardest().expect("it hits");
    let n = 20_000;
    let h = (touch.end - touch.start) / f64::from(n);
    let impulse: f64 = (0..n)
        .map(|i| {
            let t = touch.start + h * (f64::from(i) + 0.5);
            history.contacts().at(t).iter().map(|c| c.normal_damping).sum::<f64>() * h
        })
        .sum();
    // The midpoint rule over 20,000 parts leaves (h ω)²/24 of the 0.7 N·s exchanged.
    within("impulse of the dashpot", impulse / 0.7, 1e-7);
}

#[test]
fn a_friction_force_lies_inside_its_cone_in_stick_and_on_it_in_slip() {
    let mut scene = free_pair();
    scene.girders[0].initial.displacement = [0.0, 0.012, 0.0];
    scene.girders[0].initial.velocity = [0.5, 0.08, 0.0];
    for law in [FrictionLaw::Paper, FrictionLaw::ReturnMapping] {
        scene.contact.law = law;
        let history = run(&scene);
        let mut seen = [0; 2];
        for i in 0..5000 {
            for c in history.contacts().at(0.1 * f64::from(i) / 5000.0) {
                let ratio = c.tangential_force.length() / c.normal_force;
                if c.state == ContactState::Stick {
                    seen[0] += 1;
                    assert!(ratio <= c.mu_static * (1.0 + 1e-9), "stick at ratio {ratio}");
                } else {
                    seen[1] += 1;
                    within("slip off its cone", ratio - c.mu_kinetic, 1e-9);
                }
            }
        }
        assert!(seen[0] > 0 && seen[1] > 0, "{law:?}: both states are seen, {seen:?}");
    }
}

#[test]
fn a_node_that_misses_a_face_is_ignored_until_it_is_in_front_again() {
    let mut scene = free_pair();
    // Passes by, 1 mm beside: nobody touches, both planes are crossed.
    scene.girders[0].initial.displacement = [0.0, 0.071, 0.0];
    let history = run(&scene);
    assert!(history.hits().touches().is_empty(), "no touch");
    assert!(history.events().iter().all(|e| e.kind == EventKind::Missed), "only misses");
    assert_eq!(history.events().len(), 4, "two nodes of each girder");
    within("speed", history.motion(0, 0.1).velocity.x - 0.5, 1e-15);
}

#[test]
fn a_node_that_slides_along_the_face_as_it_enters_slips() {
    // No gap, no speed into the wall, but along it: |V_t|/|V_n| has no limit, whatever the push does next.
    for (law, vy) in
        [(FrictionLaw::Paper, 0.05), (FrictionLaw::ReturnMapping, 0.05), (FrictionLaw::ReturnMapping, -0.05)]
    {
        let mut scene = free_hit();
        scene.abutments[0].gap = Some(0.0);
        scene.girders[0].initial.velocity = [0.0, vy, 0.0];
        scene.girders[0].push.force = [20.0, 0.0, 0.0];
        scene.contact.law = law;
        let history = run(&scene);
        assert_eq!(history.events()[0].kind, EventKind::OpenToSlip, "{law:?}, {vy}");
        assert!(history.motion(0, 0.1).velocity.y.abs() < 0.05, "{law:?}, {vy}: friction slows it");
    }
}

#[test]
fn a_pressed_start_without_friction_slides_freely() {
    for law in [FrictionLaw::Paper, FrictionLaw::ReturnMapping] {
        let mut scene = free_hit();
        scene.girders[0].initial.displacement = [0.0051, 0.0, 0.0];
        scene.girders[0].initial.velocity = [0.0, 0.3, 0.0];
        (scene.contact.mu_static, scene.contact.mu_kinetic) = (0.0, 0.0);
        scene.contact.law = law;
        within(&format!("{law:?}: speed along the wall"), run(&scene).motion(0, 0.1).velocity.y - 0.3, 1e-12);
    }
}

#[test]
fn equal_coefficients_of_friction_do_not_chatter() {
    for stiffness in [1e6, 1e9, 1.5e9, 1e11] {
        let mut scene =
            girderbench::scene::presets::load("skew45-abutment").unwrap_or_else(|errors| panic!("{errors}"));
        scene.contact.law = FrictionLaw::ReturnMapping;
        scene.contact.stiffness = Some(stiffness);
        (scene.contact.mu_static, scene.contact.mu_kinetic) = (0.2, 0.2);
        let history = run(&scene);
        let touches = history.hits().touches().len();
        assert!(
            history.events().len() < 12 * touches,
            "{stiffness:e}: {} events in {touches} touches",
            history.events().len()
        );
    }
}

#[test]
fn a_node_touches_one_of_two_faces_at_the_same_place() {
    let mut scene = free_hit();
    let mut second = scene.abutments[0].clone();
    second.name = "behind".into();
    // The same plane, half as wide, and thin: placed where the first stands it would overlap, so beside each other.
    second.width = Some(0.5);
    second.offset = Some(1.25);
    scene.abutments.push(second);
    within("restitution", -run(&scene).motion(0, 0.1).velocity.x / 0.5 - 0.4, 1e-9);
}

#[test]
fn a_long_search_misses_no_touch() {
    // Two undamped decks whose phases drift apart for two minutes before they meet: one search looks ahead over the whole
    // run, the other, under a sine of no amplitude, over a period at a time.
    let mut scene = free_pair();
    scene.duration = 125.0;
    scene.solver.tolerance = 1e-9;
    scene.girders[1].position[0] = 0.19 + 0.009;
    for (girder, frequency) in scene.girders.iter_mut().zip([30.0, 30.003]) {
        girder.initial.velocity = [0.0; 3];
        girder.initial.displacement = [0.005, 0.0, 0.0];
        girder.bearings = Some(girderbench::scene::Bearings::Shared(girderbench::scene::SharedBearings {
            frequency_hz: girderbench::scene::PerDirection::Both(frequency),
            damping_ratio: girderbench::scene::PerDirection::Both(0.0),
            vertical_frequency_hz: None,
            vertical_damping_ratio: None,
            on_minus_x: None,
            on_plus_x: None,
            at_skewed: None,
            height: None,
            travel: None,
            at: Some(vec![[0.07, 0.025], [0.07, -0.025], [-0.07, 0.025], [-0.07, -0.025]]),
        }));
    }
    let at_once = run(&scene);
    scene.motion = girderbench::scene::Motion::Sine(girderbench::scene::SineMotion {
        amplitude_g: None,
        amplitude: Some(0.0),
        frequency_hz: 1.0,
        phase_deg: 0.0,
        angle_deg: 0.0,
        vertical_amplitude_g: None,
        vertical_amplitude: None,
        vertical_phase_deg: None,
    });
    let by_periods = run(&scene);
    let first = |h: &History| h.hits().touches().first().map(|touch| touch.start).expect("they meet");
    within("first touch", first(&at_once) - first(&by_periods), 1e-9);
}
