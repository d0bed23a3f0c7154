//! Bars and decks whose motion has a closed form.

use std::f64::consts::PI;

use super::{Bar, bars, case, force_on_first, moving, on_a_wall};
use crate::support::{run, within};
use girderbench::sim::{Comparison, History, OfSection};

/// Force of (F11) in parts of F₀, where touching begins at 0: `a` is K/Z of the wall, 2K/Z of two bars.
pub(super) fn st_venant(a: f64, back: f64, t: f64) -> f64 {
    let left = (-a * back).exp();
    if t <= back {
        1.0 - (-a * t).exp()
    } else {
        let tau = t - back;
        -1.0 + (2.0 - left + 2.0 * a * tau) * (-a * tau).exp()
    }
}

/// Contact time in parts of T, and e.
fn touch(history: &History) -> [f64; 2] {
    let touches = history.hits().touches();
    let (start, end) = touches.iter().fold((f64::INFINITY, 0.0f64), |(a, b), t| (a.min(t.start), b.max(t.end)));
    let speed = |t: f64| {
        let of = |girder: usize| history.motion(girder, t).velocity.x;
        if history.model().girders().len() > 1 { of(0) - of(1) } else { of(0) }
    };
    [(end - start) / Bar::DECK.there_and_back(), -speed(history.end()) / speed(0.0)]
}

#[test]
fn two_equal_bars_meet_as_st_venant_says() {
    for (name, kappa, degree, time, restitution, force) in [
        ("f1_st_venant", 10.0, 64, 1.041_96, 0.997_414, 2e-2),
        ("f1_st_venant_K8e9", 1.0, 40, 1.418_217, 0.975_858_5, 3e-4),
    ] {
        let (case, _) = case(name, Some(degree));
        let history = run(&case.scene);
        let [lasted, returned] = touch(&history);
        within(&format!("κ = {kappa}: contact time"), lasted / time - 1.0, 2e-4);
        within(&format!("κ = {kappa}: e"), returned - restitution, 1e-4);
        let start = history.hits().touches()[0].start;
        let [back, z] = [Bar::DECK.there_and_back(), Bar::DECK.impedance()];
        let a = 4.0 * kappa / back;
        let largest = 0.25 * z;
        let worst = (1..400).map(|i| {
            let t = time * back * f64::from(i) / 400.0;
            // On girder 0, to the left.
            (-force_on_first(&history, start + t).x / largest - st_venant(a, back, t)).abs()
        });
        within(&format!("κ = {kappa}: force"), worst.fold(0.0, f64::max), force);
    }
}

#[test]
fn unequal_bars_leave_the_long_one_ringing() {
    let (long, short) = (Bar::DECK, Bar { length: 20.0, mass: 4e5 });
    let scene = bars(&[long, short], 8e10, 0.5, 0.2);
    let history = run(&scene);
    let speed = |t: f64| history.motion(0, t).velocity.x - history.motion(1, t).velocity.x;
    let returned = -speed(history.end()) / speed(0.0);
    // A program without modes has 0.729; K → ∞ is L₂/L₁ = 2/3.
    within("unequal bars: e", returned - 0.729, 2e-2);
    let momentum = |t: f64| 6e5 * history.motion(0, t).velocity.x + 4e5 * history.motion(1, t).velocity.x;
    within("momentum", (momentum(0.2) - momentum(0.0)) / momentum(0.0), 1e-12);
    let books = history.energy().ledger(history.end());
    within("ledger", books.residual / books.scale, 1e-11);
}

#[test]
fn a_bar_against_a_rigid_girder_swings_in_the_roots_of_its_frequency_equation() {
    let (bar, mass, stiffness, speed) = (Bar::DECK, 9e5, 4e9, 0.5);
    let mut scene = bars(&[bar, Bar { mass, ..bar }], stiffness, speed, 0.02);
    scene.girders[1].elastic = None;
    scene.girders[0].elastic.as_mut().expect("elastic").modes = girderbench::scene::Degree(Some(40.0));
    let history = run(&scene);
    let (z, way) = (bar.impedance(), bar.length / bar.wave_speed());
    let g = |w: f64| 1.0 / stiffness - 1.0 / (mass * w * w) - 1.0 / ((w * way).tan() * z * w);
    let root = |k: usize| {
        let (mut a, mut b) = ((k as f64 * PI + 1e-9) / way, ((k + 1) as f64 * PI - 1e-9) / way);
        for _ in 0..200 {
            let middle = f64::midpoint(a, b);
            if g(middle) < 0.0 { a = middle } else { b = middle }
        }
        f64::midpoint(a, b)
    };
    let terms: Vec<[f64; 2]> = (0..4000)
        .map(|k| {
            let w = root(k);
            let slope =
                2.0 / (mass * w.powi(3)) + (way / ((w * way).sin().powi(2)) + 1.0 / (w * (w * way).tan())) / (z * w);
            [w, 2.0 * speed / (w * w * slope)]
        })
        .collect();
    let start = history.hits().touches()[0].start;
    let end = history.hits().touches().iter().map(|touch| touch.end).fold(0.0, f64::max);
    let largest = history.hits().largest_force() * 2.0;
    let worst = (1..200).map(|i| {
        let t = (end - start) * f64::from(i) / 200.0;
        let wanted: f64 = terms.iter().map(|[w, size]| size * (w * t).sin()).sum();
        (-force_on_first(&history, start + t).x - wanted).abs() / largest
    });
    within("bar against a rigid girder: force", worst.fold(0.0, f64::max), 5e-4);
}

#[test]
fn a_stiffer_bar_on_a_wall_comes_to_a_mass_on_a_spring() {
    let table = [
        // Of κ = 1 by (F11), whose second branch it ends in.
        (1.0, 1.5757e-1, 0.8691, 2.6e-2),
        (0.25, 4.316e-2, 0.9536, 4.9e-4),
        (0.1, 1.712e-2, 0.9830, 3.8e-4),
        (0.01, 1.647e-3, 0.998_28, 2.1e-6),
        (0.001, 1.661e-4, 0.999_83, 1.4e-8),
    ];
    for (kappa, longer, peak, lost) in table {
        let bar = Bar::DECK;
        let stiffness = kappa * Bar::AXIAL / bar.length;
        let mut scene = on_a_wall(bar, stiffness, 0.5, 0.01 + 1.3 * PI * (bar.mass / stiffness).sqrt());
        if kappa > 0.1 {
            scene.girders[0].elastic.as_mut().expect("elastic").modes = girderbench::scene::Degree(Some(20.0));
        }
        let history = run(&scene);
        let (start, end) =
            (history.hits().touches()[0].start, history.hits().touches().iter().map(|t| t.end).fold(0.0, f64::max));
        let time = (end - start) / (PI * (bar.mass / stiffness).sqrt()) - 1.0;
        within(&format!("κ = {kappa}: contact time longer by {time:.4e}"), time - longer, 1e-3 * longer + 1e-6);
        let most = 2.0 * history.hits().largest_force() / (0.5 * (stiffness * bar.mass).sqrt());
        within(&format!("κ = {kappa}: peak force {most:.5}"), most - peak, 2e-4);
        let e = -history.motion(0, history.end()).velocity.x / 0.5;
        within(&format!("κ = {kappa}: 1 − e = {:.2e}", 1.0 - e), 1.0 - e, 1.5 * lost + 1e-8);
    }
}

#[test]
fn a_wave_runs_through_a_bar_and_comes_back_as_tension() {
    let bar = Bar::DECK;
    let stiffness = Bar::AXIAL / bar.length;
    let mut scene = on_a_wall(bar, stiffness, 0.5, 0.05);
    scene.girders[0].elastic.as_mut().expect("elastic").modes = girderbench::scene::Degree(Some(40.0));
    let history = run(&scene);
    let start = history.hits().touches()[0].start;
    let force = |t: f64| if t <= start { 0.0 } else { force_on_first(&history, t).x.abs() };
    let (c, half) = (bar.wave_speed(), 0.5 * bar.length);
    let largest = 2.0 * history.hits().largest_force();
    let mut worst = 0.0f64;
    for station in [-10.0, 0.0, 7.5] {
        for i in 1..300 {
            let t = start + bar.there_and_back() * f64::from(i) / 300.0;
            let mut wanted = 0.0;
            for bounce in 0..3 {
                let way = f64::from(2 * bounce) * bar.length;
                wanted -= force(t - (way + half - station) / c);
                wanted += force(t - (way + 1.5 * bar.length + station) / c);
            }
            let seen = history.sections().forces(0, station, t).axial;
            worst = worst.max((seen - wanted).abs() / largest);
        }
    }
    within("N(s, t) against the travelling wave", worst, 7e-3);
    let until = start + bar.there_and_back();
    let field = history.sections().field(0, OfSection::Axial, [start, until], [41, 21]).expect("it bends");
    for (i, value) in field.values.iter().enumerate() {
        let (t, station) = (field.times[i % 41], field.stations[i / 41]);
        within("the field is N(s, t)", value - history.sections().forces(0, station, t).axial, 1e-9 * largest);
    }
    let turned =
        (0..200).map(|i| history.sections().forces(0, 0.0, start + 1.45 * half / c * f64::from(i) / 100.0).axial);
    assert!(turned.fold(0.0, f64::max) < 7e-3 * largest, "compression until the front comes back");
}

#[test]
fn a_whole_scene_comes_to_the_rigid_one_like_one_over_e() {
    let (base, _) = case("f2_abutment_C0", None);
    let mut rigid = base.scene.clone();
    rigid.girders[0].elastic = None;
    rigid.duration = 1.5;
    let rigid = run(&rigid);
    let apart: Vec<f64> = [10.0, 100.0, 500.0]
        .into_iter()
        .map(|factor| {
            let mut scene = base.scene.clone();
            scene.duration = 1.5;
            scene.girders[0].elastic.as_mut().expect("elastic").young_modulus *= factor;
            Comparison::of(&run(&scene), &rigid).of_all().place
        })
        .collect();
    let slope = |a: f64, b: f64, ratio: f64| (b / a).ln() / f64::ln(ratio);
    within("slope of the difference, E × 10 to × 100", slope(apart[0], apart[1], 10.0) + 1.0, 0.1);
    within("slope, × 100 to × 500", slope(apart[1], apart[2], 5.0) + 1.0, 0.1);
}

#[test]
fn momentum_of_a_moving_pair_is_kept() {
    let mut scene = bars(&[Bar::DECK, Bar::DECK], 8e9, 0.5, 0.06);
    // One aside, so that they turn.
    scene.girders[1].position[1] = 3.0;
    moving(&mut scene, 0, [0.5, 0.1]);
    let history = run(&scene);
    let totals = |t: f64| {
        let all = [0, 1].map(|girder| {
            let motion = history.motion(girder, t);
            let body = &history.model().bodies[girder];
            let turning = motion.place.cross(motion.velocity).z + body.gyration2 * motion.spin.z;
            [motion.velocity.x, motion.velocity.y, turning]
        });
        [0, 1, 2].map(|k| all[0][k] + all[1][k])
    };
    let before = totals(0.0);
    for i in 0..=30 {
        let now = totals(history.end() * f64::from(i) / 30.0);
        within("momentum along x", now[0] - before[0], 1e-13);
        within("momentum along y", now[1] - before[1], 1e-13);
        within("moment of momentum", (now[2] - before[2]) / 15.0, 1e-12);
    }
    assert!(history.motion(0, history.end()).spin.z.abs() > 1e-3, "it turned");
}
