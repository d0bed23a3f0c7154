//! Collinear islands against the general kind, of rigid girders and of girders that bend.

use super::*;
use crate::contact::normal::Linear;
use crate::contact::{FrictionLaw, Law};
use crate::dynamics::model::coordinates::planar::WIDTH;
use crate::dynamics::model::coordinates::state_layout::StateLayout;
use crate::dynamics::model::ground_now::GroundNow;
use crate::dynamics::penalty3d::contact_state::ClosedContact;
use crate::dynamics::penalty3d::coupled_system::Members;
use crate::dynamics::penalty3d::general_island;
use crate::dynamics::penalty3d::workspace::Workspace;
use crate::dynamics::{Body, ContactSite};
use crate::scene::{Motion, Scene, presets};

/// Two straight girders and their contacts in stick, all nodes closed.
fn pressed(scene: &Scene) -> (Model, Vec<ActiveContact>) {
    let model = Model::compile(scene).expect("a valid scene");
    let stick = |site: usize| {
        let here = crate::contact::locate(
            &model.sites[site].geometry,
            &frame(&model, model.sites[site].node_body, site),
            &frame(&model, model.sites[site].face_body, site),
        );
        let (k, c, c_t) = (4e4, 11.0, 7.0);
        let law = Law {
            normal: Normal::Linear(Linear { k, c }),
            k_t: k,
            c_t,
            mu_s: 0.2,
            mu_k: 0.15,
            friction: FrictionLaw::ReturnMapping.into(),
            clamp: false,
            v_stick: 0.0,
        };
        let mode = Mode::Stick { anchor: here.way };
        let closed = ClosedContact::new(law, mode, 0.0);
        let ContactSite { node_body: node, face_body: face, .. } = model.sites[site];
        let home = model.sites[site].geometry;
        ActiveContact::new(site, [node, face], closed, home)
    };
    let mut active: Vec<ActiveContact> = (0..model.sites.len()).map(stick).collect();
    for a in &mut active {
        a.find_sections(&model, &layout(&model));
    }
    (model, active)
}

fn straight_row() -> Scene {
    let mut scene = presets::load("row-of-5").expect("a preset");
    shake_along(&mut scene, 0.0);
    scene
}

fn shake_along(scene: &mut Scene, degrees: f64) {
    let Motion::Sine(sine) = &mut scene.motion else { panic!("it is shaken by a sine") };
    sine.angle_deg = degrees;
}

fn layout(model: &Model) -> StateLayout {
    StateLayout::of(model.bodies.iter())
}

fn system(model: &Model, active: &[ActiveContact]) -> CoupledSystem {
    let bodies: Vec<usize> = (0..model.bodies.len()).collect();
    let bases = model.bodies.iter().map(Body::placed).collect();
    let members = Members { bodies, bases, active: active.to_vec(), ..Members::default() };
    CoupledSystem::without_rates(members, layout(model), Vec::new())
}

/// The collinear island of all bodies of a model.
fn line(model: &Model, active: &[ActiveContact]) -> Option<CollinearIsland> {
    CollinearIsland::of(model, &system(model, active))
}

fn frame(model: &Model, body: Option<usize>, site: usize) -> Frame {
    body.map_or(model.sites[site].stand, |body| model.bodies[body].planar_frame(&[0.0; WIDTH]))
}

#[test]
fn in_line_the_rates_are_those_of_the_plan() {
    let scene = straight_row();
    let (model, active) = pressed(&scene);
    let line = line(&model, &active).expect("a straight row");
    let mut y = vec![0.0; WIDTH * model.bodies.len()];
    for (i, state) in y.chunks_exact_mut(WIDTH).enumerate() {
        (state[0], state[3]) = (1e-3 * (1.7 * i as f64).sin(), 0.2 * (2.9 * i as f64).cos());
    }
    assert!(line.holds(&y), "all else is 0");
    let (system, ground) = (system(&model, &active), model.ground.acceleration(0.3));
    let (mut short, mut whole) = (vec![9.0; y.len()], vec![9.0; y.len()]);
    line.rates(&model, &system, ground, &y, &mut short);
    general_island::rates(&model, &system, GroundNow::of(ground), &y, &mut Workspace::of(&active), &mut whole);
    let largest = whole.iter().fold(0.0f64, |most, rate| most.max(rate.abs()));
    for (i, (a, b)) in short.iter().zip(&whole).enumerate() {
        // The order of summation differs.
        assert!((a - b).abs() <= 1e-13 * largest, "component {i}: {a} against {b}");
    }
    y[2] = 1e-9;
    assert!(!line.holds(&y), "turned");
}

#[test]
fn what_turns_or_slides_is_not_in_line() {
    let scene = straight_row();
    let (model, active) = pressed(&scene);
    assert!(line(&model, &active).is_some(), "all nodes of flush faces");
    assert!(line(&model, &active[1..]).is_none(), "a corner alone turns its girder");
    let mut dragged = active.clone();
    if let Mode::Stick { anchor } = &mut dragged[0].closed.mode {
        anchor.x += 1e-6;
    }
    assert!(line(&model, &dragged).is_none(), "a stretched spring pulls sideways");
    let mut aslant = scene.clone();
    shake_along(&mut aslant, 1.0);
    let (model, active) = pressed(&aslant);
    assert!(line(&model, &active).is_none(), "the ground drives it off");
    let (model, active) = pressed(&presets::load("skew45-abutment").expect("a preset"));
    assert!(line(&model, &active).is_none(), "a skewed face is not square to its girder");
}

/// Two decks that bend, on bearings, end to end; the second one with another degree, the last bearing of each at this station \[m\].
fn bending(last: f64) -> Scene {
    let deck = |name: &str, x: f64, degree: u32| {
        format!(
            "[[girder]]\nname = \"{name}\"\nposition_m = [{x}, 0.0, 0.0]\nlength_m = 30.0\nwidth_m = 10.0\n\
             thickness_m = 1.5\nmass_kg = 600e3\n[girder.bearings]\nfrequency_hz = 0.8\ndamping_ratio = 0.1\n\
             at_m = [[14.0, 4.0], [14.0, -4.0], [-11.0, 4.0], [{last}, -4.0]]\n\
             [girder.elastic]\nyoung_modulus_pa = 30e9\narea_m2 = 8.0\nmodes = {degree}\n"
        )
    };
    let text = format!(
        "name = \"bending\"\nduration_s = 1.0\n{}{}[contact]\nstiffness_n_per_m = 2e9\nrestitution_normal = 0.6\n\
         [motion]\nkind = \"sine\"\namplitude_g = 0.4\nfrequency_hz = 0.8\nangle_deg = 0.0\n",
        deck("one", 0.0, 5),
        deck("two", 30.0, 4)
    );
    crate::scene::format::parse(&text, "bending").unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn of_girders_that_bend_g_and_the_modes_along_the_axis_move() {
    let (model, active) = pressed(&bending(-11.0));
    let line = line(&model, &active).expect("a straight row");
    let width: usize = model.bodies.iter().map(Body::width).sum();
    let mut y = vec![0.0; width];
    let mut moving = Vec::new();
    for i in 0..width {
        y[i] = 1e-3;
        if line.holds(&y) {
            moving.push(i);
        }
        y[i] = 0.0;
    }
    assert_eq!(moving.len(), 2 * (1 + 5) + 2 * (1 + 4), "{moving:?}");
    for &i in &moving {
        y[i] = 1e-3 * (1.7 * i as f64).sin();
    }
    let (system, ground) = (system(&model, &active), model.ground.acceleration(0.3));
    let (mut short, mut whole) = (vec![9.0; y.len()], vec![9.0; y.len()]);
    line.rates(&model, &system, ground, &y, &mut short);
    general_island::rates(&model, &system, GroundNow::of(ground), &y, &mut Workspace::of(&active), &mut whole);
    let largest = whole.iter().fold(0.0f64, |most, rate| most.max(rate.abs()));
    assert!(moving.iter().all(|&i| whole[i] != 0.0), "all of these move");
    for (i, (a, b)) in short.iter().zip(&whole).enumerate() {
        // The order of summation differs.
        assert!((a - b).abs() <= 1e-12 * largest, "component {i}: {a} against {b}");
    }
    assert_eq!([line.components(0), line.components(1)], [None; 2], "its ends move apart");
}

#[test]
fn a_girder_that_bends_is_not_in_line_where_a_bearing_or_its_axis_leads_off() {
    let (model, active) = pressed(&bending(-12.0));
    assert!(line(&model, &active).is_none(), "one of two bearings is farther in");
    let mut across = bending(-11.0);
    shake_along(&mut across, 90.0);
    let (model, active) = pressed(&across);
    assert!(line(&model, &active).is_none(), "across its axis it bends");
}
