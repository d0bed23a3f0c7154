//! Virtual work, rates and ports of an elastic girder in space, in a state with all of it in play.

use super::*;
use crate::dynamics::Model;
use crate::dynamics::model::body::{BodyEnergies, BodyPowers};
use crate::dynamics::model::coordinates::section_forces::SectionForces;
use crate::dynamics::model::elastic_body::ElasticBody;
use crate::scene::format;

/// A skewed deck with a heading, on bearings that leave a moment, pushed off its axis.
fn model() -> Model {
    let text = "name = \"deck\"\nkind = \"spatial\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n\
                mass_kg = 6e5\nskew_deg = 60.0\nheading_deg = 25.0\n\
                bearings = [{ at_m = [12, 4], stiffness_n_per_m = [2e5, 3e5, 4e6], damping_n_s_per_m = [1e6, 2e6, 3e6], travel_m = 5.0 }, \
                { at_m = [-14, -3], stiffness_n_per_m = [3e5, 2e5, 6e6], damping_n_s_per_m = [3e6, 2e6, 1e6] }]\n\
                push = { force_n = [1e6, -2e6, 3e6], moment_n_m = 4e6, moment_x_n_m = -2e6 }\n\
                elastic = { area_m2 = 8.0, modes = 5 }\n";
    Model::compile(&format::parse(text, "test").expect("a scene")).expect("compiles")
}

/// A number between −1 and 1, by its place in a row.
fn some(i: usize) -> f64 {
    (1.7 * (i * i) as f64 + 0.9 * i as f64 + 0.3).sin()
}

/// A state that has come some way, turned by this much and bent until φ is near 0.05.
fn state(body: &Body, turned: f64) -> Vec<f64> {
    let (width, places) = (body.width(), body.positions());
    let mut state: Vec<f64> = (0..width).map(some).collect();
    let q = DQuat::from_scaled_axis(turned * DVec3::new(0.3, -0.5, 0.9));
    state[3..POSITIONS].copy_from_slice(&q.to_array());
    state[POSITIONS..places].iter_mut().for_each(|x| *x *= 40.0);
    state[places + RATES..].iter_mut().for_each(|x| *x *= 300.0);
    state
}

fn wrenches(body: &Body) -> Vec<Wrench> {
    let vector = |i: usize| DVec3::new(some(i), some(i + 1), some(i + 2));
    (0..body.sections()).map(|n| Wrench { force: 3e6 * vector(7 * n), moment: 2e7 * vector(7 * n + 3) }).collect()
}

fn slope(body: &Body, state: &[f64], contact: &[Wrench]) -> Vec<f64> {
    let frames: Vec<Frame> = (0..body.sections()).map(|n| body.frame_since(n, state)).collect();
    let base = body.placed();
    let mut out = vec![0.0; state.len()];
    let ground = GroundNow { acceleration: DVec3::new(0.7, -0.4, 0.2), t: 0.0, since: 0.0 };
    body.slope(Counted { base: &base, frames: &frames, state }, contact, ground, &mut out);
    out
}

fn moved(state: &[f64], slope: &[f64], dt: f64) -> Vec<f64> {
    state.iter().zip(slope).map(|(x, v)| x + dt * v).collect()
}

#[test]
fn frames_move_by_their_velocities() {
    let model = model();
    let body = &model.bodies[0];
    let (state, dt) = (state(body, 1.0), 1e-5);
    let rate = slope(body, &state, &wrenches(body));
    for section in 0..body.sections() {
        let [before, here, after] = [-dt, 0.0, dt].map(|dt| body.frame(section, &moved(&state, &rate, dt)));
        let velocity = (after.shift - before.shift) / (2.0 * dt);
        assert!((velocity - here.velocity).length() < 1e-7, "section {section}: {velocity} against {}", here.velocity);
        let (v, spun) = (DVec3::new(3.0, -1.0, 2.0), here.spin);
        let turning = (after.turned - before.turned) * v / (2.0 * dt);
        let wanted = spun.cross(here.turn(v));
        assert!((turning - wanted).length() < 1e-6, "section {section}: {turning} against {wanted}");
        assert!((here.turn(v).length() - v.length()).abs() < 1e-14, "it is a rotation");
    }
}

/// Forces of a bearing and of the link that cancels it when it is lost act at one point: on a rigid section there a couple of φ²/2 would
/// remain.
#[test]
fn a_bearing_and_its_link_are_at_one_point() {
    let model = model();
    let (body, link) = (&model.bodies[0], &model.links[model.supports[0][0][0]]);
    let Some(ElasticBody::Space(girder)) = model.flexible[0].as_ref().and_then(|flexible| flexible.girder.as_ref())
    else {
        panic!("it bends");
    };
    for turned in [0.0, 0.3, 1.5] {
        let state = state(body, turned);
        let (here, [q, rates]) = (girder.mean_axes(&state), girder.modal(&state));
        let own = girder.bearings[0].now(&body.axes, &here, q, rates);
        let frame = body.frame(link.sections[0], &state);
        let (motion, arms) = link.motion([&frame, &Frame::fixed(link.homes[1])]);
        let near = |a: DVec3, b: DVec3| (a - b).length() < 1e-13 * (1.0 + a.length());
        assert!(near(own.motion.moved, motion.moved), "moved {} and {}", own.motion.moved, motion.moved);
        assert!(near(own.motion.rate, motion.rate), "at {} and {}", own.motion.rate, motion.rate);
        let arm = frame.shift - here.shift + arms[0];
        assert!(near(own.arm, arm), "from G {} and {arm}", own.arm);
        let end = body.frame(body.section(End::Plus), &state);
        assert!((end.turn(link.arms[0]) - here.turn(link.arms[0])).length() > 0.1, "where sections turn");
    }
}

/// Power of forces, push and ground on the girder equals the rate of its energies and losses.
#[test]
fn forces_do_the_work_that_its_energy_gains() {
    let model = model();
    let body = &model.bodies[0];
    assert!(body.unbalanced.first_moment.truncate().length() > 0.0 || body.bearings[0].preload.z > 0.0, "it is loaded");
    for turned in [0.0, 0.3, 1.5] {
        let (state, contact, dt) = (state(body, turned), wrenches(body), 3e-6);
        let rate = slope(body, &state, &contact);
        let energy = |dt: f64| {
            let mut there = moved(&state, &rate, dt);
            body.normalise(&mut there);
            let BodyEnergies { kinetic, bearings, gravity } = body.energies(&there, model.gravity);
            kinetic + bearings + gravity + body.own_strain(&there)
        };
        let gained = (energy(dt) - energy(-dt)) / (2.0 * dt);
        let ground = GroundNow { acceleration: DVec3::new(0.7, -0.4, 0.2), t: 0.0, since: 0.0 };
        let BodyPowers { ground: by_ground, push, bearings: loss } = body.powers(&state, ground);
        let by_contact: f64 = (contact.iter().enumerate())
            .map(|(section, wrench)| {
                let here = body.frame(section, &state);
                wrench.force.dot(here.velocity) + wrench.moment.dot(here.spin)
            })
            .sum();
        let worked = by_contact + by_ground + push - loss - body.own_loss(&state);
        let scale = by_contact.abs() + push.abs() + loss + body.own_loss(&state);
        assert!((gained - worked).abs() < 1e-7 * scale, "turned by {turned}: {gained} W against {worked} W");
    }
}

#[test]
fn as_placed_on_its_bearings_nothing_moves_it() {
    let mut scene = format::parse(
        "name = \"deck\"\nkind = \"spatial\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\n\
         mass_kg = 6e5\nskew_deg = 60.0\nbearings = { frequency_hz = [1.0, 1.0], vertical_frequency_hz = 8.0, damping_ratio = 0.1, \
         at_m = [[13, 4], [13, -4], [-13, 4], [-13, -4]] }\nelastic = { area_m2 = 8.0, modes = 6 }\n",
        "test",
    )
    .expect("a scene");
    scene.girders[0].heading_deg = 40.0;
    let model = Model::compile(&scene).expect("compiles");
    let body = &model.bodies[0];
    let frames: Vec<Frame> = (0..body.sections()).map(|n| body.frame_since(n, &body.initial())).collect();
    let base = body.placed();
    let mut out = vec![1.0; body.width()];
    let ground = GroundNow { acceleration: DVec3::ZERO, t: 0.0, since: 0.0 };
    let counted = Counted { base: &base, frames: &frames, state: &body.initial() };
    body.slope(counted, &vec![Wrench::default(); body.sections()], ground, &mut out);
    let weight = body.mass * model.gravity;
    assert!(weight > 1e6 && out.iter().all(|rate| rate.abs() < 1e-14 * weight), "{out:?}");
}

#[test]
fn a_port_is_what_the_slope_gains_by_the_force() {
    let model = model();
    let body = &model.bodies[0];
    let mut state = state(body, 0.4);
    state[POSITIONS..body.positions()].fill(0.0);
    let still = vec![Wrench::default(); body.sections()];
    for section in 0..body.sections() {
        let here = body.frame(section, &state);
        let (force, arm) = (DVec3::new(3e5, -1e5, 2e5), DVec3::new(4.0, 1.0, -0.5));
        let mut pushed = still.clone();
        pushed[section].push(force, arm);
        let [without, with] = [&still, &pushed].map(|contact| slope(body, &state, contact));
        let (mut response, mut load) = (vec![0.0; state.len()], vec![0.0; state.len()]);
        body.port(Point { section, frame: &here, arm }, force, [&mut response, &mut load]);
        let size = with.iter().zip(&without).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        for (i, response) in response.iter().enumerate().skip(body.positions()) {
            let gained = with[i] - without[i];
            assert!((response - gained).abs() < 1e-9 * size, "section {section}, {i}: {response} against {gained}");
        }
        let velocity = here.velocity_at(arm);
        let by_load: f64 = load.iter().zip(&state).map(|(load, rate)| load * rate).sum();
        assert!((by_load - force.dot(velocity)).abs() < 1e-9 * by_load.abs(), "power {by_load}");
        // Acceleration of the point by the force: of its velocity with the response for the rates.
        let mut moving = state.clone();
        moving[body.positions()..].copy_from_slice(&response[body.positions()..]);
        let wanted = body.frame(section, &moving).velocity_at(arm);
        let own = body.acceleration(Point { section, frame: &here, arm }, force);
        assert!((own - wanted).length() < 1e-12 * wanted.length(), "section {section}: {own} against {wanted}");
    }
}

#[test]
fn section_forces_vanish_at_both_ends_and_jump_by_the_loads() {
    let model = model();
    let body = &model.bodies[0];
    let state = state(body, 0.2);
    let made = model.flexible[0].as_ref().and_then(|flexible| flexible.girder.as_ref()).expect("it bends");
    let mut contact = vec![Wrench::default(); body.sections()];
    contact[1] = wrenches(body)[1];
    let equilibrium = made.equilibrium(&state, &contact, DVec3::ZERO);
    let size = contact[1].force.length();
    let largest = |forces: SectionForces| {
        let SectionForces { axial, shear, vertical_shear, moment, vertical_moment, torque } = forces;
        let moments = [moment, vertical_moment, torque].map(|m| m.abs() / 10.0);
        [axial, shear, vertical_shear].into_iter().map(f64::abs).chain(moments).fold(0.0, f64::max) / size
    };
    // At an end stands what acts there; beyond it nothing is left.
    let [free, loaded] = [15.0, -15.0].map(|station| largest(equilibrium.at(station)));
    assert!(free < 1e-12, "at the free end {free}");
    assert!(loaded > 0.1, "at the end that is pushed {loaded}");
    let jump = equilibrium.loads.iter().find(|load| load.station <= -15.0).expect("the load there").force;
    let inside = equilibrium.at(-15.0);
    let apart = DVec3::new(inside.axial, inside.shear, inside.vertical_shear) + jump;
    assert!(apart.length() < 1e-11 * size, "{apart} N of {size} N");
}

/// By the strain of smooth shapes the series is as good as equilibrium: of free vibration in one mode, without loads.
#[test]
fn section_forces_of_a_mode_are_those_by_strain() {
    let mut model = model();
    let body = &mut model.bodies[0];
    (body.push, body.moment, body.unbalanced) =
        (DVec3::ZERO, DVec3::ZERO, crate::dynamics::model::bearing::UnbalancedWeight::default());
    body.bearings.clear();
    let beam = model.flexible[0].as_ref().and_then(|flexible| flexible.space).expect("in space");
    let modes = crate::dynamics::elastic::SpaceModes::of(beam, 32);
    let girder = SpatialElasticGirder::new(body, modes, super::super::modal_springs::ModalDamping::Ratio(0.0));
    let still = vec![Wrench::default(); girder.sections()];
    for mode in 0..12 {
        let mut state = girder.initial(body);
        state[POSITIONS + mode] = 1.0;
        let equilibrium = girder.equilibrium(&state, &still);
        let stations = [-14.0, -9.0, -3.0, 0.0, 5.0, 11.0];
        let all = |of: &dyn Fn(f64) -> SectionForces| {
            stations.map(|s| {
                let f = of(s);
                [[f.axial, f.shear, f.vertical_shear], [f.torque, f.vertical_moment, f.moment]]
            })
        };
        let strained = girder.strained(&state);
        let (one, other) = (all(&|s| equilibrium.at(s)), all(&|s| strained.at(s)));
        for kind in 0..2 {
            let size = one.iter().flat_map(|f| f[kind]).map(f64::abs).fold(1.0, f64::max);
            for (a, b) in one.iter().zip(&other) {
                let apart = (0..3).map(|i| (a[kind][i] - b[kind][i]).abs()).fold(0.0, f64::max);
                assert!(apart < 1e-6 * size, "mode {mode}: {a:?} against {b:?}");
            }
        }
    }
}

#[test]
fn bounds_and_excursion_are_not_below_the_motion() {
    let model = model();
    let body = &model.bodies[0];
    let (state, rate) = {
        let state = state(body, 0.3);
        let rate = slope(body, &state, &wrenches(body));
        (state, rate)
    };
    let places = body.positions();
    let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    // Rates and second derivatives along the slope; a quaternion's second derivative is half of ω̇ and of ω².
    let second = |range: Range<usize>| -> f64 {
        match range.start {
            0 => norm(&rate[places..places + 3]),
            3 => {
                let spin = norm(&state[places + 3..places + RATES]);
                0.5 * norm(&rate[places + 3..places + RATES]) + 0.25 * spin * spin
            }
            j => rate[places + RATES + j - POSITIONS].abs(),
        }
    };
    let bounds = body.bounds(&|range: Range<usize>| [norm(&rate[range.clone()]), second(range)]);
    let dt = 1e-6;
    for section in 0..body.sections() {
        let [before, here, after] = [-dt, 0.0, dt].map(|dt| body.frame(section, &moved(&state, &rate, dt)));
        let gain = (after.velocity - before.velocity).length() / (2.0 * dt);
        let bend = (after.spin - before.spin).length() / (2.0 * dt);
        let pairs = [
            (here.velocity.length(), bounds.speed),
            (here.spin.length(), bounds.spin),
            (gain, bounds.acceleration),
            (bend, bounds.spin_rate),
        ];
        assert!(pairs.iter().all(|(value, bound)| value <= bound), "section {section}: {pairs:?}");
    }
    let dt = 1e-3;
    let there = moved(&state, &rate, dt);
    let way = |range: Range<usize>| dt * norm(&rate[range]);
    for corner in body.prism.corners() {
        let placed = body.axes * corner;
        let point = |state: &[f64], section: usize| {
            let frame = body.frame(section, state);
            frame.shift + frame.turn(placed)
        };
        for section in 0..body.sections() {
            let far = (point(&there, section) - point(&state, section)).length();
            let bound = body.excursion(placed.length(), &way);
            assert!(far <= bound, "section {section}: {far} m beyond {bound} m");
        }
    }
}
