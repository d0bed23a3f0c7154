//! A third friction law through the real solver, `F_t = −μ_k N V_t/|V_t| − C_t V_t` in slip, against the closed form of a block that is
//! pressed on the wall and thrown along it: a damped oscillator in stick, a decay to the stop in slip.

use crate::support::{free_hit, within};
use girderbench::contact::{Breakaway, Forces, Friction, FrictionLaw, FrictionRule, Law, Local, Mode, SlipDirection};
use girderbench::dynamics::Model;
use girderbench::scene::{Direction, Kind, Scene};
use girderbench::sim::{EventKind, History, Session};
use glam::DVec2;

const MASS: f64 = 2.0;
const K: f64 = 1.55e5;
/// Force that presses the block on the wall \[N\].
const PRESSED: f64 = 10.0;
const MU_S: f64 = 0.2;
const MU_K: f64 = 0.15;
/// \[N·s/m\]
const C_T: f64 = 8.0;
const SPEED: f64 = 0.3;

/// Coulomb's friction and a dashpot on `V_t`; the tangential spring carries nothing in slip, so that a stop and a breakaway are those of law
/// `paper`.
#[derive(Debug)]
struct Viscous;

static VISCOUS: Viscous = Viscous;

impl FrictionRule for Viscous {
    fn slip(&self, law: &Law, direction: DVec2, here: &Local) -> Forces {
        let pressed = law.pressed(here, DVec2::ZERO);
        Forces {
            tangential: law.along_velocity(pressed.sliding, direction) * (-law.mu_k * pressed.normal),
            tangential_damping: pressed.sliding * -law.c_t,
            anchor_rate: pressed.sliding,
            ..pressed
        }
    }

    fn stopping(&self, law: &Law, direction: DVec2, here: &Local) -> f64 {
        FrictionLaw::Paper.rule().stopping(law, direction, here)
    }

    fn breakaway(&self, law: &Law, anchor: DVec2, here: &Local) -> Breakaway {
        FrictionLaw::Paper.rule().breakaway(law, anchor, here)
    }

    fn on_stopping(&self, law: &Law, direction: DVec2, here: &Local) -> Mode {
        FrictionLaw::Paper.rule().on_stopping(law, direction, here)
    }

    fn direction(&self) -> SlipDirection {
        SlipDirection::OfVelocity
    }

    fn is_continuous_at_stop(&self) -> bool {
        false
    }

    fn is_damped_in_slip(&self) -> bool {
        true
    }
}

/// The block inside the wall by `PRESSED/K`, with this velocity along it.
fn thrown(velocity: [f64; 2]) -> Scene {
    let mut scene = free_hit();
    scene.duration = 0.5;
    scene.abutments[0].height = Some(2.0);
    scene.girders[0].initial.displacement = [0.005 + PRESSED / K, 0.0, 0.0];
    scene.girders[0].initial.velocity = [0.0, velocity[0], velocity[1]];
    scene.girders[0].held = vec![Direction::X, Direction::Yaw];
    (scene.contact.mu_static, scene.contact.mu_kinetic) = (MU_S, MU_K);
    scene
}

/// Runs a scene with the law at every pair.
fn run(scene: &Scene) -> History {
    let mut model = Model::compile(scene).unwrap_or_else(|errors| panic!("{errors}"));
    for pair in &mut model.pairs {
        (pair.law.friction, pair.law.c_t) = (Friction::Custom(&VISCOUS), C_T);
    }
    let mut session = Session::of_model(scene, model);
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    assert!(history.stop().is_none(), "{:?}", history.stop());
    history
}

/// Time \[s\], way \[m\] and speed \[m/s\] at breakaway, `k_t y = μ_s N`.
fn breakaway() -> [f64; 3] {
    let gamma = C_T / (2.0 * MASS);
    let w = (K / MASS - gamma * gamma).sqrt();
    let way = |t: f64| SPEED / w * (-gamma * t).exp() * (w * t).sin();
    let (mut a, mut b) = (0.0, 1.0 / w);
    for _ in 0..80 {
        let middle = f64::midpoint(a, b);
        if way(middle) > MU_S * PRESSED / K { b = middle } else { a = middle }
    }
    [b, way(b), SPEED * (-gamma * b).exp() * ((w * b).cos() - gamma / w * (w * b).sin())]
}

/// Breakaway, way, stop and losses of the block; in two directions sliding stops at `v_stick`.
fn check(what: &str, scene: &Scene, tolerance: f64) {
    let history = run(scene);
    let [from, from_way, from_speed] = breakaway();
    let (friction, rate) = (MU_K * PRESSED, C_T / MASS);
    let v_stick = history.model().pairs[0].law.v_stick;
    let slide = ((from_speed + friction / C_T) / (v_stick + friction / C_T)).ln() / rate;
    let slid = |t: f64| (from_speed + friction / C_T) * -(-rate * t).exp_m1() / rate - friction * t / C_T;
    let way = |t: f64| {
        let displacement = history.motion(0, t).displacement;
        displacement.y.hypot(displacement.z)
    };
    let time = |kind: EventKind| {
        let event = history.events().iter().find(|event| event.kind == kind);
        event.unwrap_or_else(|| panic!("{what}: no {kind:?}")).t
    };
    within(&format!("{what}: breakaway"), time(EventKind::StickToSlip) - from, tolerance);
    within(&format!("{what}: stop"), time(EventKind::SlipToStick) - (from + slide), tolerance);
    for part in [0.2, 0.5, 0.9] {
        let expected = from_way + slid(part * slide);
        within(&format!("{what}: way"), way(from + part * slide) - expected, tolerance);
    }
    // At rest, but for what the spring makes of a speed of v_stick.
    let rest = v_stick / (K / MASS).sqrt();
    within(&format!("{what}: at rest"), way(scene.duration) - (from_way + slid(slide)), rest + tolerance);
    let [first, last] = [0.0, scene.duration].map(|t| history.energy().ledger(t));
    within(&format!("{what}: energy"), (last.residual - first.residual) / last.scale, 1e-10);
    assert!(last.loss_friction > 0.9 * 0.5 * MASS * SPEED * SPEED, "{what}: friction takes the energy");
}

#[test]
fn in_one_direction_of_sliding_a_thrown_block_follows_the_closed_form() {
    check("in plan", &thrown([SPEED, 0.0]), 1e-11);
}

#[test]
fn in_two_directions_of_sliding_friction_follows_the_velocity() {
    let mut scene = thrown([0.6 * SPEED, 0.8 * SPEED]);
    (scene.kind, scene.gravity) = (Kind::Spatial, 0.0);
    scene.girders[0].held.extend([Direction::Roll, Direction::Pitch]);
    let law = Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}")).pairs[0].law;
    assert!(law.v_stick > 0.0, "two directions of sliding");
    check("in space", &scene, 1e-10);
}
