//! Records of several components: how they add up, and that runs under them are those of the same ground in one.

use std::sync::Arc;

use glam::DVec3;

use girderbench::dynamics::Model;
use girderbench::motion::format::{Channel, Record};
use girderbench::scene::{
    Component, Kind, ModelKind, Motion, Processing, RecordMotion, Scene, format, presets, validate,
};

use super::formats::{read, real};
use crate::support::{rows, run, within};

/// Noise of 12 s at 100 Hz, largest 3.924 m/s².
fn noise() -> (f64, Vec<f64>) {
    let Motion::Record(record) = rows::record(4000, 1e-9).motion else { panic!("a record") };
    let (dt, samples) = record.series().expect("its own");
    (dt, samples[400..1600].to_vec())
}

fn component(samples: &[f64], azimuth_deg: f64, scale: f64) -> Component {
    let (samples, dt, azimuth_deg) = (Some(samples.to_vec()), Some(0.01), Some(azimuth_deg));
    Component { samples, dt, azimuth_deg, scale, ..Component::default() }
}

/// A preset under these components, world x towards this azimuth.
fn shaken(preset: &str, components: Vec<Component>, x_azimuth_deg: f64) -> Scene {
    let mut scene = presets::load(preset).expect("a preset");
    scene.duration = 12.0;
    scene.solver.tolerance = 1e-12;
    let x_azimuth_deg = Some(x_azimuth_deg);
    scene.motion = Motion::Record(RecordMotion { components, x_azimuth_deg, ..RecordMotion::default() });
    validate::validate(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    scene
}

fn ground(scene: &Scene, t: f64) -> DVec3 {
    Model::compile(scene).expect("a sound scene").ground.acceleration(t)
}

#[test]
fn azimuths_turn_against_that_of_world_x() {
    let pulse = [0.0, 1.0, 0.0];
    for (x_azimuth, azimuth, expected) in [
        (0.0, 0.0, DVec3::X),
        // Azimuths run clockwise, world angles anticlockwise: east of a bridge that runs north is on its right.
        (0.0, 90.0, DVec3::NEG_Y),
        (90.0, 90.0, DVec3::X),
        (90.0, 0.0, DVec3::Y),
        (65.0, 35.0, DVec3::new(0.75f64.sqrt(), 0.5, 0.0)),
    ] {
        let scene = shaken("straight-abutment", vec![component(&pulse, azimuth, 1.0)], x_azimuth);
        within("direction", (ground(&scene, 0.01) - expected).length(), 1e-15);
    }
}

#[test]
fn the_same_record_twice_is_one_along_the_resultant() {
    let (dt, samples) = noise();
    for (preset, kind) in [
        ("straight-abutment", ModelKind::Contact),
        ("skew45-abutment", ModelKind::Contact),
        ("skew45-abutment", ModelKind::Impact),
        ("straight-straight", ModelKind::Impact),
    ] {
        // 3 along world x and 4 along y: 5 along atan(4/3).
        let mut several = shaken(preset, vec![component(&samples, 90.0, 0.6), component(&samples, 0.0, 0.8)], 90.0);
        let mut one = several.clone();
        let angle_deg = 0.8_f64.atan2(0.6).to_degrees();
        let own = RecordMotion { samples: Some(samples.clone()), dt: Some(dt), angle_deg, ..RecordMotion::default() };
        one.motion = Motion::Record(own);
        for scene in [&mut several, &mut one] {
            scene.model.kind = kind;
            scene.duration = 4.0;
        }
        for t in [0.0, 0.873, 2.345, 11.99, 13.0] {
            within("the ground", (ground(&several, t) - ground(&one, t)).length(), 1e-14);
        }
        let [several, one] = [run(&several), run(&one)];
        assert_eq!(several.events().len(), one.events().len(), "{preset}, {kind:?}: the same events");
        let apart = several.motion(0, 4.0).displacement - one.motion(0, 4.0).displacement;
        // A hair of the ground grows from hit to hit.
        within(&format!("{preset}, {kind:?}"), apart.length(), 1e-9);
    }
}

#[test]
fn two_components_of_their_own_balance_the_ledger() {
    let (_, samples) = noise();
    let backwards: Vec<f64> = samples.iter().rev().copied().collect();
    let mut scene =
        shaken("skew45-abutment", vec![component(&samples, 90.0, 0.6), component(&backwards, 0.0, 0.5)], 90.0);
    let history = run(&scene);
    let ledger = history.energy().ledger(history.end());
    assert!(ledger.loss_normal > 0.0, "it hits the wall");
    within("contact model", ledger.residual / ledger.scale, 5e-13);
    let a = ground(&scene, 3.21);
    within("x", a.x - 0.6 * (samples[321]), 1e-12);
    within("y", a.y - 0.5 * (backwards[321]), 1e-12);
    scene.model.kind = ModelKind::Impact;
    let history = run(&scene);
    assert!(history.events().len() > 5, "the impact model hits too");
}

#[test]
fn an_upward_component_shakes_spatial_scenes_only() {
    let (_, samples) = noise();
    let up = Component { vertical: Some(true), azimuth_deg: None, ..component(&samples, 0.0, 0.3) };
    let scene = shaken("deck-30m", vec![component(&samples, 90.0, 0.2), up], 90.0);
    let a = ground(&scene, 2.0);
    within("upwards", a.z - 0.3 * samples[200], 1e-14);
    let history = run(&Scene { duration: 3.0, ..scene.clone() });
    let ledger = history.energy().ledger(3.0);
    within("ledger", ledger.residual / ledger.scale, 5e-12);
    let errors = validate::validate(&Scene { kind: Kind::Planar, ..scene }).expect_err("in plan");
    assert!(errors.to_string().contains("motion.component[1].vertical"), "{errors}");
}

#[test]
fn el_centro_shakes_in_its_own_directions() {
    let names = ["RSN6_IMPVALL.I_I-ELC180-hor1.AT2", "RSN6_IMPVALL.I_I-ELC270-hor2.AT2"];
    let read = |name: &str| Some(read(&real(name)?, name).expect("a record"));
    let (Some(south), Some(west)) = (read(names[0]), read(names[1])) else { return };
    let parts = [south, west].map(|record| record.channels[0].clone());
    let mut scene = shaken("skew45-abutment", vec![component(&[0.0; 2], 0.0, 1.0); 2], 90.0);
    let Motion::Record(record) = &mut scene.motion else { panic!("a record") };
    for (component, name) in record.components.iter_mut().zip(names) {
        *component = Component { file: Some(name.to_owned()), ..Component::default() };
    }
    let loaded = |channel: &Channel| Some(Arc::new(Record { format: "PEER AT2", channels: vec![channel.clone()] }));
    record.loaded_components = parts.iter().map(loaded).collect();
    validate::validate(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    // World x points east: south is −y, west is −x.
    let a = ground(&scene, 2.18);
    within("south", a.y + parts[0].samples[218], 1e-12);
    within("west", a.x + parts[1].samples[218], 1e-12);
    for kind in [ModelKind::Contact, ModelKind::Impact] {
        scene.model.kind = kind;
        let history = run(&scene);
        assert!(history.stop().is_none() && history.events().len() > 5, "{kind:?}: it runs and hits");
    }
}

#[test]
fn components_that_do_not_fit_together_are_refused() {
    let (_, samples) = noise();
    let good = shaken("straight-abutment", vec![component(&samples, 0.0, 1.0), component(&samples, 90.0, 1.0)], 0.0);
    let refused = |change: &dyn Fn(&mut RecordMotion), place: &str, remedy: &str| {
        let mut scene = good.clone();
        let Motion::Record(record) = &mut scene.motion else { panic!("a record") };
        change(record);
        let errors = validate::validate(&scene).expect_err(place).to_string();
        assert!(errors.contains(place) && errors.contains(remedy), "{place}: {errors}");
    };
    refused(&|r| r.x_azimuth_deg = None, "motion.component[0].azimuth_deg", "x_azimuth_deg");
    refused(&|r| r.components[1].azimuth_deg = None, "motion.component[1].azimuth_deg", "states no direction");
    refused(&|r| r.components[1].dt = Some(0.02), "motion.component[1].dt_s", "one interval");
    refused(&|r| r.components[1].samples = None, "motion.component[1].samples_m_s2", "or file");
    refused(&|r| r.components[0].file = Some("a.AT2".into()), "motion.component[0].samples_m_s2", "one of the two");
    refused(&|r| r.angle_deg = 3.0, "motion.angle_deg", "[[motion.component]]");
    refused(&|r| r.file = Some("a.AT2".into()), "motion.file", "[[motion.component]]");
    refused(&|r| r.components.extend(r.components.clone()), "motion.component", "three components");
    refused(&|r| r.components[0].scale = f64::NAN, "motion.component[0].scale", "finite");
    refused(&|r| r.processing.taper = 7.0, "motion.processing.taper_s", "fit into");
    refused(&|r| r.processing.pad = 1e9, "motion.processing.pad_s", "at most 1e7");
    refused(&|r| r.processing.from = Some(20.0), "motion.processing.from_s", "at least 2 samples");
    refused(&|r| r.processing.time_scale = 0.0, "motion.processing.time_scale", "greater than 0");
}

#[test]
fn a_scene_of_components_is_written_as_it_was_read() {
    let (_, samples) = noise();
    let mut scene =
        shaken("straight-abutment", vec![component(&samples, 0.0, 1.0), component(&samples, 90.0, 0.5)], 30.0);
    if let Motion::Record(record) = &mut scene.motion {
        record.processing = Processing { taper: 0.5, peak_g: Some(0.3), ..Processing::default() };
    }
    let text = format::write(&scene);
    assert_eq!(format::read(&text, "again").as_ref(), Ok(&scene), "{text}");
}

#[test]
fn processing_is_done_in_its_order_to_every_component() {
    let ramp: Vec<f64> = (0..101).map(f64::from).collect();
    let mut scene = shaken("straight-abutment", vec![component(&ramp, 0.0, 1.0)], 0.0);
    let Motion::Record(record) = &mut scene.motion else { panic!("a record") };
    // Cut from 0.2 to 0.6 s: 20 … 60, less their mean −20 … 20; padded by 0.1 s; at half the interval; to 0.5 g.
    record.processing = Processing {
        from: Some(0.2),
        until: Some(0.6),
        baseline: girderbench::scene::Baseline::Mean,
        pad: 0.1,
        time_scale: 0.5,
        peak_g: Some(0.5),
        ..Processing::default()
    };
    record.scale = 2.0;
    let unit = 9.80665 / 20.0;
    for (t, expected) in [(0.0, 0.0), (0.05, -20.0), (0.15, 0.0), (0.25, 20.0), (0.30, 0.0)] {
        within(&format!("at {t} s"), ground(&scene, t).x - expected * unit, 1e-12);
    }
}

#[test]
fn a_synthetic_earthquake_is_matched_to_a_spectrum_and_shakes_in_up_to_three_directions() {
    let set = |settings: &[&str]| {
        let base = presets::load("two-components").expect("a preset");
        let settings: Vec<String> = settings.iter().map(|setting| format!("motion.{setting}")).collect();
        girderbench::scene::overrides::apply_all(&base, &settings).expect("it fits")
    };
    let alone = set(&["across=0"]);
    let both = set(&["across=0.5", "angle_deg=0"]);
    let (a, b) = (ground(&alone, 5.0), ground(&both, 5.0));
    assert!(a.y == 0.0 && a.x == b.x && b.y != 0.0, "the first stays, the second is its own: {a} {b}");
    let across = set(&["seed=3", "across=0"]);
    within("of the next seed", b.y - 0.5 * ground(&across, 5.0).x, 1e-15);
    let target = "target_psa_g=[[0.05, 0.3], [0.15, 0.75], [0.5, 0.75], [2.0, 0.19]]";
    let matched = set(&[target, "across=0"]);
    assert_eq!(validate::validate(&matched), Ok(()), "sound");
    let Motion::Synthetic(quake) = &matched.motion else { panic!("synthetic") };
    let found = girderbench::motion::spectrum::response(&quake.samples(0), quake.dt, 0.3, 0.05).pseudo_acceleration();
    assert!((found / (0.75 * 9.80665) - 1.0).abs() < 0.2, "on the plateau: {found} m/s²");
    for wrong in
        ["seed=1.5", "dt_s=0.2", "length_s=1e9", "target_psa_g=[[1.0, 0.2]]", "target_psa_g=[[1, 0.2], [0.5, 0.1]]"]
    {
        let errors = validate::validate(&set(&[wrong])).expect_err(wrong).to_string();
        assert!(errors.contains(wrong.split('=').next().expect("a key")), "{wrong}: {errors}");
    }
}
