//! Each limit of the domain by itself: just inside, just outside, and what is said.

use super::*;
use crate::motion::format::{Channel, Record};
use crate::scene::{
    Bearing, Bearings, Direction, Kind, PairSettings, STANDARD_GRAVITY, Setting, SineMotion, keys, presets,
};

/// The paper's girder before its wall: 2 kg, K = 1.55e5 N/m, 10 s.
fn paper() -> Scene {
    presets::load("skew45-abutment").unwrap_or_else(|errors| panic!("{errors}"))
}

fn with(change: impl FnOnce(&mut Scene)) -> Vec<Departure> {
    let mut scene = paper();
    change(&mut scene);
    outside(&scene)
}

/// Place, value and limit of the one departure.
#[track_caller]
fn only(found: &[Departure]) -> (&str, f64, Limit) {
    let [one] = found else { panic!("one departure: {found:?}") };
    assert!(keys::of_place(&one.place).is_some(), "a key of the scene file: {}", one.place);
    (&one.place, one.value, one.limit)
}

const PLANAR: Setting = Setting { kind: Kind::Planar, gravity: STANDARD_GRAVITY };
const SPATIAL: Setting = Setting { kind: Kind::Spatial, gravity: STANDARD_GRAVITY };

#[test]
fn presets_are_inside() {
    for preset in presets::all() {
        let scene = presets::load(preset.name).unwrap_or_else(|errors| panic!("{errors}"));
        assert_eq!(outside(&scene), [], "{}", preset.name);
    }
}

#[test]
fn both_ends_of_a_range_are_inside() {
    for tolerance in TOLERANCE.range {
        assert!(with(|s| s.solver.tolerance = tolerance).is_empty(), "{tolerance:e}");
    }
    assert_eq!(only(&with(|s| s.solver.tolerance = 9e-13)), ("solver.tolerance", 9e-13, TOLERANCE));
    assert_eq!(only(&with(|s| s.solver.tolerance = 2e-4)), ("solver.tolerance", 2e-4, TOLERANCE));
}

#[test]
fn each_quantity_of_a_girder_is_named_by_its_key() {
    type Change = fn(&mut Girder);
    let cases: [(&str, Limit, Change); 11] = [
        ("mass_kg", MASS, |g| g.mass = 1.1e8),
        ("length_m", SIZE, |g| g.length = 1.1e3),
        ("width_m", SIZE, |g| g.width = 0.9e-3),
        ("thickness_m", SIZE, |g| g.thickness = 0.9e-3),
        ("position_m", PLACE, |g| g.position = [0.0, -1.1e6, 0.0]),
        ("skew_deg", SKEW, |g| g.skew_deg = 4.0),
        ("bearings", BEARING_PLACE, |g| {
            let Some(Bearings::Shared(bearings)) = &mut g.bearings else { return };
            bearings.at_skewed = Some(vec![[0.3, 0.0], [-0.3, 0.0]]);
        }),
        ("initial.velocity_m_s", SPEED, |g| g.initial.velocity = [0.0, -101.0, 0.0]),
        ("push.force_n", ACCELERATION, |g| g.push.force = [-150.0, 150.0, 0.0]),
        ("push.moment_n_m", ACCELERATION, |g| g.push.moment = -40.0),
        ("initial.spin_deg_s", SPEED, |g| g.initial.spin_deg_s = -6e4),
    ];
    for (key, limit, change) in cases {
        let mut scene = paper();
        // Alone: no pair whose K/M would leave the domain with the mass.
        scene.abutments.clear();
        change(&mut scene.girders[0]);
        let found = outside(&scene);
        let (place, _, broken) = only(&found);
        assert_eq!((place, broken), (format!("girder.deck.{key}").as_str(), limit), "{found:?}");
    }
}

#[test]
fn an_end_stands_on_a_pier_under_it() {
    let mut scene = presets::load("viaduct-5").unwrap_or_else(|errors| panic!("{errors}"));
    let Some(Bearings::Shared(bearings)) = &mut scene.girders[4].bearings else { panic!("shared") };
    bearings.on_plus_x = Some("p4".to_owned());
    let found = outside(&scene);
    let places: Vec<&str> = found.iter().map(|d| d.place.as_str()).collect();
    // The pier takes its place in the middle of its bearings: half a span from either end of g5.
    assert_eq!(places, ["girder.g4.bearings", "girder.g5.bearings"], "{found:?}");
    assert!(found.iter().all(|d| d.limit == PIER_PLACE && d.value > 0.4 && d.value < 0.6), "{found:?}");
}

#[test]
fn a_device_acts_on_its_girder() {
    let mut scene = presets::load("twin-span-restrained").unwrap_or_else(|errors| panic!("{errors}"));
    let (name, girder) = (scene.restrainers[0].name.clone(), scene.restrainers[0].girder.clone());
    let length = scene.girders.iter().find(|g| g.name == girder).expect("it").length;
    scene.restrainers[0].at = [1.5 * length, 0.0, 0.0];
    scene.restrainers[0].cable_length = Some(1.0);
    let found = outside(&scene);
    let (place, value, limit) = only(&found);
    assert_eq!((place, limit), (format!("restrainer.{name}.at_m").as_str(), DEVICE_PLACE));
    assert!(value > 2.0 && value < 3.0, "{value}");
    scene.restrainers[0].at = [1e3 * length, 0.0, 0.0];
    let refused = crate::scene::validate::validate(&scene).expect_err("in mm").to_string();
    assert!(
        refused.contains(&format!("restrainer.{name}.at_m")) && refused.contains("in m, relative to G"),
        "{refused}"
    );
}

#[test]
fn piers_dampers_and_factors_of_supports_are_looked_at() {
    let viaduct = |change: fn(&mut Scene)| {
        let mut scene = presets::load("viaduct-5").unwrap_or_else(|errors| panic!("{errors}"));
        change(&mut scene);
        outside(&scene)
    };
    let factor = viaduct(|s| s.abutments[0].motion_factor = Some(-1e3));
    let (place, value, limit) = only(&factor);
    assert!(place.ends_with(".motion_factor") && place.starts_with("abutment."), "{place}");
    assert!((value / (1e3 * 0.45 * STANDARD_GRAVITY) - 1.0).abs() < 0.2 && limit == ACCELERATION, "{value} m/s²");
    let light = viaduct(|s| s.piers[1].mass = 1e-9);
    assert!(light.iter().any(|d| d.limit == MASS && d.value == 1e-9), "its mass: {light:?}");
    assert!(light.iter().any(|d| d.limit == MOTION_PHASE && d.place.starts_with("pier.")), "its rate: {light:?}");
    let text = "name = \"two\"\nduration_s = 1.0\n[[girder]]\nname = \"deck\"\nlength_m = 1.0\nwidth_m = 0.3\nthickness_m = 0.1\n\
                mass_kg = 1.0\n[[damper]]\nname = \"d\"\ngirder = \"deck\"\nat_m = [0.3, 0.0]\nto_m = [0.9, 0.0]\ncoefficient = 2e5\n";
    let damped = crate::scene::format::parse(text, "two").unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!(only(&outside(&damped)), ("damper.d.coefficient", 2e5, MOTION_PHASE));
}

#[test]
fn a_pair_is_measured_by_its_reduced_mass() {
    let found = with(|s| s.contact.stiffness = Some(2.1e9));
    assert_eq!(only(&found), ("contact.stiffness_n_per_m", 1.05e9, STIFFNESS));
    assert_eq!(found[0].pair.as_deref(), Some("deck+x|wall"), "the pair is named");
    assert_eq!(only(&with(|s| s.contact.stiffness = Some(1.9))).1, 0.95, "too soft, against a wall the girder's mass");
    let mut row = presets::load("row-of-5").unwrap_or_else(|errors| panic!("{errors}"));
    row.contact.pairs.push(PairSettings {
        between: ["g1".into(), "g2".into()],
        stiffness: Some(4e14),
        ..PairSettings::default()
    });
    let found = outside(&row);
    let of = |limit: Limit| found.iter().filter(|d| d.limit == limit).collect::<Vec<_>>();
    let [one] = of(STIFFNESS)[..] else { panic!("one pair: {found:?}") };
    assert_eq!(one.pair.as_deref(), Some("g1+x|g2-x"), "the pair that has it");
    assert!((one.value / (4e14 / 3e5) - 1.0).abs() < 1e-12, "M is half of 600 t: {}", one.value);
}

#[test]
fn the_impact_model_has_no_stiffness() {
    let found = with(|s| {
        s.contact.stiffness = Some(1e12);
        s.model.kind = ModelKind::Impact;
    });
    assert_eq!(found, []);
}

#[test]
fn friction_belongs_to_a_pair() {
    assert_eq!(only(&with(|s| s.contact.mu_static = 2.1)), ("contact.mu_static", 2.1, FRICTION));
}

#[test]
fn long_runs_are_measured_by_what_is_fastest() {
    // 2.6 Hz is 16.3 rad/s of the ground, and √(K/m) 278 rad/s: 1e5 rad are 6121 s, 1e7 rad 35,921 s.
    let shaken = |duration: f64| {
        with(|s| {
            s.girders[0].bearings = None;
            s.duration = duration;
        })
    };
    assert_eq!(shaken(6100.0), []);
    assert_eq!((only(&shaken(6150.0)).0, only(&shaken(6150.0)).2), ("motion.frequency_hz", MOTION_PHASE));
    // The bearings, which turn the girder faster than they swing it, reach 1e5 rad before the ground does.
    assert_eq!(only(&with(|s| s.duration = 6100.0)).0, "girder.deck.bearings");
    let still = |duration: f64| {
        with(|s| {
            s.motion = Motion::None;
            s.girders[0].bearings = None;
            s.duration = duration;
        })
    };
    assert_eq!(still(35_900.0), []);
    assert_eq!(only(&still(36_000.0)).2, CONTACT_PHASE);
    let spinning = with(|s| {
        s.motion = Motion::None;
        s.girders[0].bearings = None;
        s.girders[0].initial.spin_deg_s = 1e4;
        s.duration = 600.0;
    });
    assert_eq!((only(&spinning).0, only(&spinning).2), ("girder.deck.initial.spin_deg_s", MOTION_PHASE));
}

#[test]
fn the_ground_is_measured_by_its_peak_and_its_samples() {
    let sine = |amplitude_g: Option<f64>, amplitude: Option<f64>| {
        with(|s| {
            let motion = SineMotion {
                amplitude_g,
                amplitude,
                frequency_hz: 2.6,
                phase_deg: 0.0,
                angle_deg: 0.0,
                vertical_amplitude_g: None,
                vertical_amplitude: None,
                vertical_phase_deg: None,
            };
            s.motion = Motion::Sine(motion);
        })
    };
    assert_eq!(sine(Some(10.0), None), [], "ten g");
    assert_eq!(only(&sine(Some(11.0), None)).0, "motion.amplitude_g");
    assert_eq!(only(&sine(None, Some(-101.0))), ("motion.amplitude_m_s2", 101.0, ACCELERATION));
    let record = |samples: Vec<f64>, dt: f64, scale: f64, file: Option<String>| {
        with(|s| {
            let own = RecordMotion { scale, ..RecordMotion::default() };
            s.motion = Motion::Record(match file {
                Some(_) => {
                    let read = Record { format: "CSV", channels: vec![Channel::plain(dt, samples)] };
                    RecordMotion { file, loaded: Some(std::sync::Arc::new(read)), ..own }
                }
                None => RecordMotion { samples: Some(samples), dt: Some(dt), ..own },
            });
        })
    };
    let name = || Some("quake.csv".to_owned());
    assert_eq!(record(vec![0.0, -51.0], 0.01, 1.9, None), []);
    assert_eq!(only(&record(vec![0.0, -51.0], 0.01, 2.0, None)), ("motion.samples_m_s2", 102.0, ACCELERATION));
    assert_eq!(only(&record(vec![0.0, -51.0], 0.01, -2.0, name())).0, "motion.file");
    assert_eq!(only(&record(vec![0.0; 200_000], 5e-5, 1.0, None)).0, "motion.dt_s", "200,000 samples in 10 s");
    assert_eq!(record(vec![0.0; 99_000], 1e-5, 1.0, None), [], "fewer, however close");
}

#[test]
fn a_displaced_start_counts_by_the_speed_that_it_leads_to() {
    let alone = |change: fn(&mut Girder)| {
        with(|s| {
            s.abutments.clear();
            change(&mut s.girders[0]);
        })
    };
    // The fastest rate of the bearings is that of turning, below 25 rad/s.
    assert_eq!(alone(|g| g.initial.displacement = [0.0, 4.0, 0.0]), []);
    let found = alone(|g| g.initial.displacement = [0.0, 7.0, 0.0]);
    assert_eq!((only(&found).0, only(&found).2), ("girder.deck.initial.displacement_m", SPEED));
    let found = alone(|g| g.initial.rotation_deg = -181.0);
    assert_eq!(only(&found), ("girder.deck.initial.rotation_deg", 181.0, TURN));
    let long = alone(|g| {
        g.length = 40.0;
        g.bearings = Some(Bearings::Each(vec![Bearing::linear([20.0, 0.0], [0.0, 8e2, 0.0], [0.0; 3])]));
        g.initial.rotation_deg = 170.0;
    });
    assert_eq!((only(&long).0, only(&long).2), ("girder.deck.initial.rotation_deg", SPEED));
    // 278 rad/s: 100 m/s at a depth of 0.36 m.
    let pressed = |x: f64| with(|s| s.girders[0].initial.displacement[0] = x);
    assert_eq!((pressed(0.35), pressed(-0.4)), (Vec::new(), Vec::new()), "less deep, or off the wall");
    let found = pressed(0.37);
    assert_eq!((only(&found).0, found[0].pair.as_deref()), ("girder.deck.initial.displacement_m", Some("deck+x|wall")));
}

#[test]
fn a_start_above_a_wall_is_not_pressed_into_it() {
    let mut deck = presets::load("deck-30m").unwrap_or_else(|errors| panic!("{errors}"));
    deck.girders[0].bearings = None;
    let mut started = |z: f64, roll: f64| {
        let initial = &mut deck.girders[0].initial;
        (initial.displacement, initial.roll_deg) = ([20.0, 0.0, z], Some(roll));
        outside(&deck).into_iter().filter(|departure| departure.pair.is_some()).count()
    };
    assert_eq!([started(0.0, 0.0), started(50.0, 0.0), started(50.0, 90.0)], [1, 0, 0], "beside, and above, the wall");
    assert_eq!(started(10.0, 60.0), 1, "a corner may be lower");
}

#[test]
fn gravity_counts_in_a_spatial_scene() {
    assert_eq!(with(|s| s.gravity = -200.0), [], "a planar scene has none");
    let mut deck = presets::load("deck-30m").unwrap_or_else(|errors| panic!("{errors}"));
    deck.gravity = -200.0;
    assert_eq!(only(&outside(&deck)), ("gravity_m_s2", 200.0, ACCELERATION));
}

#[test]
fn a_bearings_rate_is_that_of_its_stiffness_its_damping_and_its_lever() {
    let bearings = |stiffness: [f64; 3], damping: [f64; 3]| {
        let at = |x: f64| Bearing::linear([x, 0.0], stiffness, damping);
        Some(Bearings::Each(vec![at(0.07), at(-0.07)]))
    };
    let mut girder = paper().girders.remove(0);
    let close = |rate: f64, wanted: f64| assert!((rate / wanted - 1.0).abs() < 1e-12, "{rate} against {wanted}");
    girder.bearings = bearings([100.0, 0.0, 0.0], [0.0; 3]);
    close(measures::bearing_rate(&girder, PLANAR), 10.0);
    girder.bearings = bearings([100.0, 0.0, 0.0], [30.0, 0.0, 0.0]);
    close(measures::bearing_rate(&girder, PLANAR), 30.0);
    // Along y the levers turn it: 2 k l² over m i², faster than 10 rad/s where l exceeds i.
    girder.bearings = bearings([0.0, 100.0, 0.0], [0.0; 3]);
    let i2 = girder.prism().inertia_per_mass().z_axis.z;
    close(measures::bearing_rate(&girder, PLANAR), 10.0 * (0.07_f64.powi(2) / i2).sqrt().max(1.0));
    girder.bearings = bearings([1.0, 1.0, 900.0], [0.0; 3]);
    assert!(measures::bearing_rate(&girder, PLANAR) < 2.0, "nothing moves up");
    assert!(measures::bearing_rate(&girder, SPATIAL) >= 30.0, "straight up, or pitching");
    girder.held = vec![Direction::Z, Direction::Roll, Direction::Pitch, Direction::Yaw];
    close(measures::bearing_rate(&girder, SPATIAL), 1.0);
    girder.bearings = None;
    assert_eq!(measures::bearing_rate(&girder, SPATIAL), 0.0, "it stands on nothing");
}

#[test]
fn a_departure_says_place_value_bound_consequence_and_remedy() {
    let said = with(|s| s.contact.stiffness = Some(6e9))[0].to_string();
    for word in ["contact.stiffness_n_per_m", "deck+x|wall", "3e9 1/s²", "above 1e9", "rounds", "set stiffness_n_per_m"]
    {
        assert!(said.contains(word), "{word}: {said}");
    }
    let said = with(|s| s.solver.tolerance = 2.5e-13)[0].to_string();
    assert!(said.contains("tolerance = 2.5e-13 is below 1e-12,"), "no unit, no space for one: {said}");
}

#[test]
fn every_end_of_a_range_that_can_be_passed_has_its_consequence() {
    for limit in LIMITS {
        let [low, high] = limit.range;
        assert!(low < high && limit.beyond[1].is_some(), "{limit:?}");
        assert_eq!(limit.beyond[0].is_none(), low == 0.0, "{limit:?}");
    }
}
