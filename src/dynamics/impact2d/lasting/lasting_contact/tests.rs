//! The closed form of a sliding face against the integrator.

use glam::{DMat3, DVec2};

use super::*;
use crate::dynamics::impact2d::example;

/// A preset's girder, its face on the wall and sliding.
fn sliding(preset: &str, change: impl FnOnce(&mut Model), sign: f64) -> (Model, LastingContact) {
    let mut model = example::preset(preset, |scene| {
        scene.abutments[0].gap = Some(0.0);
        scene.girders[0].push.force = [40.0, 3.0, 0.0];
    });
    change(&mut model);
    let home = BodyKinematics::new(&model, &[0], &[[0.0; WIDTH]], DVec3::ZERO);
    let sites = example::touching(&model, &home);
    let sites = vec![sites[0], sites[sites.len() - 1]];
    let s: DVec2 = home.point(&model, sites[0]).s;
    let v = s * (0.3 * sign);
    let mode = ContactMode { pair: 0, sites, friction: FrictionMode::Slip(sign) };
    let contact = LastingContact::new(vec![0], vec![mode], &[[0.0, 0.0, 0.0, v.x, v.y, 0.0]], 0.0);
    (model, contact)
}

/// State at `end` by Dormand–Prince at the finest tolerance.
fn integrated(model: &Model, contact: &LastingContact, end: f64) -> Vec<f64> {
    let mut contact = contact.clone();
    while contact.from < end {
        let piece = model.ground.piece(model.ground.piece_number(contact.from));
        let cap = end.min(piece.until);
        let dense = contact.integrate(model, piece, [1e-15; 2], cap).expect("a step");
        let to = if dense.from + dense.step >= cap { cap } else { dense.from + dense.step };
        let mut y = vec![0.0; WIDTH];
        dense.read(0..WIDTH, to, &mut y);
        (contact.y, contact.from) = (y, to);
    }
    contact.y
}

/// In closed form, piece by piece.
fn closed(model: &Model, contact: &LastingContact, end: f64) -> Vec<f64> {
    let mut contact = contact.clone();
    while contact.from < end {
        let piece = model.ground.piece(model.ground.piece_number(contact.from));
        let to = end.min(piece.until);
        let (slide, _) = contact.slide(model, &piece, to).expect("a face on a wall");
        (contact.y, contact.from) = (slide.state(to).to_vec(), to);
    }
    contact.y
}

fn agree(name: &str, (model, contact): &(Model, LastingContact), end: f64) {
    let (ours, theirs) = (closed(model, contact, end), integrated(model, contact, end));
    let moved = theirs[0].hypot(theirs[1]);
    assert!(moved > 1e-4, "{name}: it slides, by {moved}");
    for (i, (a, b)) in ours.iter().zip(&theirs).enumerate() {
        let scale = if i < 3 { moved.max(0.03) } else { 0.5 };
        assert!((a - b).abs() < 2e-13 * scale, "{name}: component {i} is {a} against {b}, apart {:e}", a - b);
    }
}

/// Other bearings, without dashpots \[N/m\].
fn bear(model: &mut Model, along_x: f64, along_y: f64) {
    model.bodies[0].planar.stiffness = DMat3::from_diagonal(DVec3::new(along_x, along_y, 4.0));
    model.bodies[0].planar.damping = DMat3::ZERO;
}

#[test]
fn a_sliding_face_goes_as_the_integrator_does() {
    let still = |model: &mut Model| model.ground = Ground::Still;
    // Friction makes a negative stiffness of these at 60°, one way.
    let unlike = |model: &mut Model| {
        bear(model, 12_000.0, 400.0);
        (model.ground, model.impact.mu_kinetic) = (Ground::Still, 0.9);
    };
    for sign in [1.0, -1.0] {
        for preset in ["straight-abutment", "skew60-abutment", "skew45-abutment"] {
            agree(preset, &sliding(preset, |_| (), sign), 0.2);
            agree(&format!("{preset}, still"), &sliding(preset, still, sign), 0.2);
            agree(&format!("{preset}, stiff along x"), &sliding(preset, unlike, sign), 0.1);
        }
    }
}

#[test]
fn a_sliding_face_follows_a_record_and_resonates_as_the_integrator_does() {
    let samples = [0.0, 1.3, -2.0, 0.4, 3.0, -1.0, 0.2, 0.9, -0.7, 0.1];
    let axis = DVec3::new(0.6, 0.8, 0.0);
    let record = |model: &mut Model| model.ground = Ground::record(axis, 0.02, samples);
    agree("record", &sliding("skew60-abutment", record, 1.0), 0.25);
    // Without dashpots, and shaken at what friction makes of the frequency: there is no steady response.
    let resonance = |model: &mut Model| {
        bear(model, 400.0, 400.0);
        model.ground = Ground::Sine { amplitude: DVec3::Y, quadrature: DVec3::ZERO, omega: 200f64.sqrt(), phase: 0.3 };
    };
    agree("resonance", &sliding("straight-abutment", resonance, 1.0), 0.3);
}

#[test]
fn one_switching_function_is_the_same_as_among_all() {
    let (model, mut contact) = sliding("skew60-abutment", |_| (), 1.0);
    let piece = model.ground.piece(model.ground.piece_number(0.0));
    contact.plan(&model, [1e-12; 2], [0.0, 0.1]).expect("a step");
    let switches = contact.endings();
    assert_eq!(switches.len(), 5, "two for each end of the face, and the slip");
    let t = 0.3 * contact.until;
    let all = contact.switching_functions(&model, piece, &switches, t).expect("a solution");
    for (&switch, value) in switches.iter().zip(all) {
        assert_eq!(contact.switching_function(&model, piece, switch, t), value, "{:?}", switch.ending);
    }
}

#[test]
fn a_slip_ends_where_its_speed_does() {
    let still = |model: &mut Model| {
        model.ground = Ground::Still;
        bear(model, 400.0, 400.0);
        model.impact.mu_kinetic = 0.0;
        (model.bodies[0].push.x, model.bodies[0].push.y) = (40.0, 0.0);
    };
    let (model, mut contact) = sliding("straight-abutment", still, 1.0);
    while contact.ending.is_none() && contact.until < 1.0 {
        contact.plan(&model, [1e-12; 2], [0.0, 1.0]).expect("a step");
        if contact.ending.is_none() {
            contact.commit();
        }
    }
    assert_eq!(contact.ending, Some(Ending::SlipStops(0)), "nothing else ends it");
    // An undamped oscillator from rest in the middle stops after a quarter period.
    let quarter = std::f64::consts::FRAC_PI_2 / (400.0 / model.bodies[0].mass).sqrt();
    assert!((contact.until - quarter).abs() < 1e-14, "{} against {quarter}", contact.until);
}
