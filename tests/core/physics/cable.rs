//! A restrainer cable with slack through the real solver: a device between two points, which pulls once it is taut. Against the
//! closed form of two masses that a spring joins, and against momentum, angular momentum and energy.

use std::f64::consts::PI;
use std::sync::Arc;

use girderbench::dynamics::Model;
use girderbench::dynamics::connection::{
    Activity, Anchor, Connection, Device, DeviceReadings, Phase, Separation, SeparationBounds, Switch, acts_or_open,
};
use girderbench::dynamics::model::links::LinkError;
use girderbench::language::Text;
use girderbench::scene::{ModelKind, Scene, ViewPreset};
use girderbench::sim::quantity::Quantity;
use girderbench::sim::{History, Session};
use girderbench::view::list::Mark;
use girderbench::view::{Background, Bounds, Camera, ViewInput, draw_list};
use glam::{DMat3, DVec3};

use crate::support::{scene, within};

/// Pulls with `k (r − L) + c ṙ` while `r > L`, and does not push.
#[derive(Debug)]
struct Cable {
    /// Length at which it is taut \[m\].
    length: f64,
    /// Stiffness \[N/m\].
    k: f64,
    /// Damping coefficient \[N·s/m\].
    c: f64,
}

const SLACK: u32 = 0;
const TAUT: u32 = 1;

impl Cable {
    fn stretch(&self, motion: &Separation) -> f64 {
        motion.vector().length() - self.length
    }

    fn rate(motion: &Separation) -> f64 {
        motion.vector().normalize_or_zero().dot(motion.rate)
    }

    fn tension(&self, motion: &Separation) -> f64 {
        self.k * self.stretch(motion) + self.c * Self::rate(motion)
    }
}

impl Connection for Cable {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        if self.acts(phase) { motion.vector().normalize_or_zero() * -self.tension(motion) } else { DVec3::ZERO }
    }

    fn stored_energy(&self, phase: &Phase, motion: &Separation) -> f64 {
        if self.acts(phase) { 0.5 * self.k * self.stretch(motion).powi(2) } else { 0.0 }
    }

    fn dissipated_power(&self, phase: &Phase, motion: &Separation) -> f64 {
        if self.acts(phase) { self.c * Self::rate(motion).powi(2) } else { 0.0 }
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        self.k
    }

    fn damping_bound(&self, _: &Phase) -> f64 {
        self.c
    }
}

impl Device for Cable {
    fn initial(&self, motion: &Separation) -> Phase {
        let law = if self.stretch(motion) > 0.0 { TAUT } else { SLACK };
        Phase { branch: law, ..Phase::default() }
    }

    fn activity(&self, phase: &Phase) -> Activity {
        Activity::of(phase.branch == TAUT)
    }

    /// `(L² − r²)/(2L)`: smooth, where the ends meet, too.
    fn gap(&self, _: &Phase, motion: &Separation) -> [f64; 2] {
        let r = motion.vector();
        [
            (self.length - r.length()) * (self.length + r.length()) / (2.0 * self.length),
            -r.dot(motion.rate) / self.length,
        ]
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        (bounds.speed * bounds.speed + bounds.distance * bounds.acceleration) / self.length
    }

    fn stays_idle(&self, _: &Phase, bounds: &SeparationBounds) -> bool {
        bounds.distance < self.length
    }

    fn switches(&self, _: &Phase) -> usize {
        1
    }

    fn switch(&self, _: usize, _: &Phase, motion: &Separation) -> f64 {
        -self.tension(motion) / self.k
    }

    fn next(&self, event: Switch, phase: &Phase, motion: &Separation) -> (Phase, f64) {
        let law = if event == Switch::Closing { TAUT } else { SLACK };
        let released = self.stored_energy(phase, motion);
        (Phase { branch: law, ..*phase }, if law == SLACK { released } else { 0.0 })
    }
}

impl DeviceReadings for Cable {
    fn state(&self, phase: &Phase) -> Text {
        acts_or_open(self.acts(phase))
    }

    fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64 {
        self.gap(phase, motion)[0]
    }
}

const MASS: f64 = 3.0;
const LENGTH: f64 = 0.5;
const SPEED: f64 = 0.4;
const STIFFNESS: f64 = 5e4;
/// Distance of the anchors as placed \[m\].
const APART: f64 = 0.2;

/// Two free girders on one line; the second moves away from the first, which is at rest.
fn two_girders(kind: &str, velocity: [f64; 2], duration: f64) -> Scene {
    let girder = |name: &str, x: f64, [vx, vy]: [f64; 2]| {
        format!(
            r#"
            [[girder]]
            name = "{name}"
            length_m = 0.4
            width_m = 0.1
            thickness_m = 0.05
            mass_kg = {MASS}
            position_m = [{x}, 0.0, 0.0]
            initial = {{ velocity_m_s = [{vx}, {vy}] }}
            "#
        )
    };
    scene(&format!(
        r#"
        name = "cable"
        kind = "{kind}"
        duration_s = {duration}
        gravity_m_s2 = 0.0
        {}{}
        [contact]
        stiffness_n_per_m = 1.55e5
        [solver]
        tolerance = 1e-11
        "#,
        girder("west", 0.0, [0.0, 0.0]),
        girder("east", 0.4 + APART, velocity),
    ))
}

/// Runs a scene with a cable from the east end of the first girder to the west end of the second, at this distance beside their
/// axes.
fn run(scene: &Scene, cable: Cable, beside: f64) -> History {
    let mut model = Model::compile(scene).unwrap_or_else(|errors| panic!("{errors}"));
    let anchor = |body, x| Anchor::Body { body, point: DVec3::new(x, beside, 0.0) };
    let ends = [anchor(0, 0.2), anchor(1, -0.2)];
    model.link("restrainer", ends, DMat3::IDENTITY, Arc::new(cable)).expect("two bodies");
    let mut session = Session::of_model(scene, model);
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    assert!(history.stop().is_none(), "{:?}", history.stop());
    history
}

fn undamped() -> Cable {
    Cable { length: LENGTH, k: STIFFNESS, c: 0.0 }
}

fn momentum(history: &History, t: f64) -> DVec3 {
    (0..2).map(|girder| history.motion(girder, t).velocity * MASS).sum()
}

/// About the origin of the world, of girders with this radius of gyration² in plan.
fn angular_momentum(history: &History, t: f64) -> f64 {
    let body = |girder: usize| {
        let (motion, body) = (history.motion(girder, t), &history.model().bodies[girder]);
        let place = body.home + motion.displacement;
        MASS * (place.cross(motion.velocity).z + body.gyration2 * motion.spin.z)
    };
    body(0) + body(1)
}

#[test]
fn a_slack_cable_goes_taut_for_half_a_period_and_the_girders_exchange_their_velocities() {
    for kind in ["planar", "spatial"] {
        let scene = two_girders(kind, [SPEED, 0.0], 1.0);
        let history = run(&scene, undamped(), 0.0);
        let [(_, slack), (taut, _), (again, _)] = history.connections().link_phases(0) else {
            panic!("slack, taut, slack: {:?}", history.connections().link_phases(0))
        };
        assert_eq!(slack.branch, SLACK);
        let half = PI * (MASS / 2.0 / STIFFNESS).sqrt();
        within(&format!("{kind}: taut at"), taut - (LENGTH - APART) / SPEED, 1e-12);
        within(&format!("{kind}: half a period"), (again - taut) / half - 1.0, 1e-9);
        let tension = SPEED * (STIFFNESS * MASS / 2.0).sqrt();
        let middle = history.connections().link(0, f64::midpoint(*taut, *again)).expect("the link");
        within(&format!("{kind}: peak tension"), middle.force.length() / tension - 1.0, 1e-9);
        assert!(middle.acts && middle.force.x > 0.0, "the first girder is pulled to the second: {}", middle.force);
        let [west, east] = [0, 1].map(|girder| history.motion(girder, 1.0).velocity.x / SPEED);
        within(&format!("{kind}: the first has it"), west - 1.0, 1e-9);
        within(&format!("{kind}: the second stands"), east, 1e-9);
        for t in [0.1, 0.5 * (taut + again), 1.0] {
            let kept = momentum(&history, t) - DVec3::X * MASS * SPEED;
            within(&format!("{kind}: momentum at {t}"), kept.length() / (MASS * SPEED), 1e-12);
            let books = history.energy().ledger(t);
            within(&format!("{kind}: ledger at {t}"), books.residual / books.scale, 1e-9);
        }
    }
}

#[test]
fn before_the_cable_is_taut_no_step_is_taken() {
    let scene = two_girders("planar", [SPEED, 0.0], 0.7);
    let history = run(&scene, undamped(), 0.0);
    assert_eq!(history.effort().steps, 0, "two flights in closed form");
    assert_eq!(history.connections().link_phases(0).len(), 1, "{:?}", history.connections().link_phases(0));
    let still = run(&two_girders("planar", [0.0, 0.0], 0.7), undamped(), 0.0);
    assert!(still.effort().looks <= 4, "{} looks where nothing moves", still.effort().looks);
}

#[test]
fn a_cable_beside_the_axes_turns_the_girders_and_keeps_angular_momentum_and_energy() {
    for kind in ["planar", "spatial"] {
        let scene = two_girders(kind, [SPEED, 0.15], 1.1);
        let history = run(&scene, undamped(), 0.04);
        assert!(history.connections().link_phases(0).len() >= 3, "{:?}", history.connections().link_phases(0));
        assert!(history.motion(0, 1.1).spin.z.abs() > 1e-2, "{} rad/s", history.motion(0, 1.1).spin.z);
        let before = angular_momentum(&history, 0.0);
        for i in 1..=11 {
            let t = 0.1 * f64::from(i);
            within(&format!("{kind}: angular momentum at {t}"), angular_momentum(&history, t) / before - 1.0, 1e-10);
            let books = history.energy().ledger(t);
            within(&format!("{kind}: ledger at {t}"), books.residual / books.scale, 1e-8);
        }
    }
}

#[test]
fn a_cable_is_drawn_between_its_ends_thick_while_it_is_taut_and_the_legend_has_both() {
    let scene = two_girders("planar", [SPEED, 0.0], 1.0);
    let history = run(&scene, undamped(), 0.03);
    let camera = Camera::preset(ViewPreset::Top, Bounds::of_scene(&scene), 1.5);
    let drawn = |t: f64| {
        let input = ViewInput {
            scene: &scene,
            history: Some(&history),
            t,
            camera: &camera,
            overlays: scene.view.overlays,
            force_scale: None,
            selected: &[],
            kept: &[],
            exaggeration: 1.0,
            bent: None,
            clear: &[],
            size: [900, 600],
            pixels_per_point: 1.0,
            background: Background::Studio,
            title: None,
        };
        draw_list(&input)
    };
    let strokes = |t: f64| drawn(t).xray_lines.into_iter().filter(|line| line.group == "device").collect::<Vec<_>>();
    let taut = history.connections().link_phases(0)[1].0 + 1e-3;
    let ([slack], [tight]) = (&strokes(0.5)[..], &strokes(taut)[..]) else { panic!("one stroke each") };
    assert!(tight.width > 2.0 * slack.width && tight.color != slack.color, "{tight:?} against {slack:?}");
    let [west, east] = [0, 1].map(|girder| history.motion(girder, taut).place + DVec3::Y * 0.03);
    let turned = 1e-3;
    within("its west end", f64::from(tight.from.x) - (west.x + 0.2), turned);
    within("its east end", f64::from(tight.to.x) - (east.x - 0.2), turned);
    let marks = drawn(0.5).marks;
    for (words, sign) in [("device whose force acts", tight), ("idle device", slack)] {
        let at = marks.iter().find_map(|mark| match mark {
            Mark::Text { text, at, .. } if text == words => Some(*at),
            _ => None,
        });
        let at = at.unwrap_or_else(|| panic!("the legend has a row for: {words}"));
        let is_sign = |mark: &Mark| {
            matches!(mark, Mark::Stroke { points, width, color }
                if points[0].y == at.y && (*width, *color) == (sign.width, sign.color))
        };
        assert!(marks.iter().any(is_sign), "{words}: a stroke as the device has it");
    }
}

#[test]
fn the_impact_model_refuses_a_device_in_words() {
    let mut scene = two_girders("planar", [SPEED, 0.0], 1.0);
    scene.model.kind = ModelKind::Impact;
    let mut model = Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    let anchor = |body, x| Anchor::Body { body, point: DVec3::X * x };
    let cable = || Arc::new(undamped());
    assert_eq!(model.link("r", [anchor(0, 0.2), anchor(7, 0.0)], DMat3::IDENTITY, cable()), Err(LinkError::NoBody(7)));
    assert_eq!(model.link("r", [anchor(0, 0.2), anchor(0, 0.0)], DMat3::IDENTITY, cable()), Err(LinkError::SameBody));
    model.link("restrainer", [anchor(0, 0.2), anchor(1, -0.2)], DMat3::IDENTITY, cable()).expect("two bodies");
    let mut session = Session::of_model(&scene, model);
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    let stop = history.stop().expect("a refusal");
    assert!(stop.t == 0.0 && stop.reason.to_string().contains("device"), "{stop:?}");
}

#[test]
fn what_a_damped_cable_loses_is_booked() {
    let damped = Cable { c: 60.0, ..undamped() };
    let history = run(&two_girders("planar", [SPEED, 0.0], 1.0), damped, 0.0);
    let books = history.energy().ledger(1.0);
    assert!(books.loss_device > 0.01 * books.scale, "{} J of {}", books.loss_device, books.scale);
    within("ledger", books.residual / books.scale, 1e-9);
    let taut = history.connections().link_phases(0)[1].0 + 2e-3;
    for t in [0.5, taut, 1.0] {
        let energy = |name: &str| Quantity::find(&history, name).expect("a plotted energy").at(&history, t);
        let plotted = ["energy.kinetic", "energy.devices", "energy.lost-devices"].map(energy);
        within("plotted energies", plotted.iter().sum::<f64>() / (0.5 * MASS * SPEED * SPEED) - 1.0, 1e-9);
        assert_eq!(plotted[1] > 0.0, t == taut, "{} J stored at {t} s", plotted[1]);
        assert_eq!(plotted[2] > 0.0, t >= taut, "{} J lost at {t} s", plotted[2]);
    }
    let [west, east] = [0, 1].map(|girder| history.motion(girder, 1.0).velocity.x);
    within("momentum", (west + east) / SPEED - 1.0, 1e-12);
    assert!(east > 0.0 && east < west, "less than an exchange: {west}, {east}");
}

#[test]
fn between_cable_and_contact_two_girders_go_to_and_fro() {
    let mut scene = two_girders("planar", [SPEED, 0.0], 4.0);
    (scene.contact.restitution_normal, scene.contact.restitution_tangential) = (1.0, 1.0);
    let history = run(&scene, undamped(), 0.0);
    assert!(history.connections().link_phases(0).len() >= 5 && history.hits().touches().len() >= 2, "both act in turn");
    let books = history.energy().ledger(4.0);
    within("ledger", books.residual / books.scale, 1e-8);
    within("energy", books.kinetic / (0.5 * MASS * SPEED * SPEED) - 1.0, 1e-8);
    within("momentum", momentum(&history, 4.0).x / (MASS * SPEED) - 1.0, 1e-11);
    assert_eq!(history.digest(), run(&scene, undamped(), 0.0).digest(), "the same again");
}
