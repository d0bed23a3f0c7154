//! Devices of a scene: where their points are, what they are without numbers, what is refused, and that two free girders keep
//! their momentum.

use girderbench::dynamics::Model;
use girderbench::scene::device::Joint;
use girderbench::scene::edit::Edit;
use girderbench::scene::validate::validate;
use girderbench::scene::{Device, DeviceId, DeviceKind, ModelKind, Scene, format, overrides};
use girderbench::sim::{History, Session};
use glam::DVec3;

use crate::support::{momenta_in_space, scene, within};

/// Two girders of 30 m, the second turned by 10°, and an abutment before the first one's -x end.
const BRIDGE: &str = r#"
name = "bridge"
duration_s = 1.0
[[girder]]
name = "west"
length_m = 30.0
width_m = 10.0
thickness_m = 1.5
skew_deg = 60.0
mass_kg = 6e5
heading_deg = 90.0
position_m = [1.0, 2.0, 0.0]
[[girder]]
name = "east"
length_m = 30.0
width_m = 10.0
thickness_m = 1.5
mass_kg = 6e5
heading_deg = 100.0
position_m = [0.0, 40.0, 0.0]
[[abutment]]
name = "wall"
faces = "west"
end = "-x"
gap_m = 0.1
"#;

fn with(words: &str) -> Scene {
    scene(&format!("{BRIDGE}{words}"))
}

fn joint(scene: &Scene) -> Joint {
    let devices = scene.devices();
    Joint::of(scene, &devices[0].1.ends()).expect("its bodies are there")
}

fn place(name: &str, found: DVec3, expected: [f64; 3]) {
    within(&format!("{name}: {found}"), (found - DVec3::from(expected)).length(), 1e-12);
}

#[test]
fn points_stand_in_the_frames_of_what_they_are_on() {
    let cable = "[[restrainer]]\nname = \"cable\"\ngirder = \"west\"\nat_m = [3.0, 1.0]\nstiffness_n_per_m = 1e7\n";
    // West lies along y: 3 m along, 1 m across is (−1, 3) from its G.
    let ground = joint(&with(&format!("{cable}to_m = [7.0, 8.0]\n")));
    place("first", ground.points[0], [0.0, 5.0, 0.0]);
    place("on the ground", ground.points[1], [7.0, 8.0, 0.0]);
    let east = joint(&with(&format!("{cable}to = \"east\"\nto_m = [2.0, 0.0]\n")));
    let turn = 100f64.to_radians();
    place("on the other girder", east.points[1], [2.0 * turn.cos(), 40.0 + 2.0 * turn.sin(), 0.0]);
    // The face looks along the girder's −x end: out of it (sin 60°, −cos 60°) in the girder's frame, (cos 60°, sin 60°) in the world.
    let wall = joint(&with(&format!("{cable}to = \"wall\"\nto_m = [-1.0, 0.0]\n")));
    let (sine, cosine) = 60f64.to_radians().sin_cos();
    let centre = DVec3::new(1.0, 2.0 - 15.0 - 0.1, 0.0);
    let out = wall.face.expect("an abutment has a face");
    place("out of the face", out, [cosine, sine, 0.0]);
    place("behind the face", wall.points[1], (centre - out).to_array());
    let along = joint(&with(&format!("{cable}to = \"wall\"\nto_m = [0.0, 2.0]\n"))).points[1] - centre;
    within("along the face", along.dot(out), 1e-12);
    within("as far", along.length() - 2.0, 1e-12);
}

#[test]
fn a_stopper_without_a_second_point_has_it_where_its_first_is_and_stops_across() {
    let stopper = "[[stopper]]\nname = \"key\"\ngirder = \"west\"\nat_m = [3.0, 1.0]\nstiffness_n_per_m = 1e7\n";
    let scene = with(stopper);
    let found = joint(&scene);
    assert_eq!(found.points[0], found.points[1], "one place");
    let Some(Device::Stopper(key)) = scene.device(DeviceId { kind: DeviceKind::Stopper, number: 0 }) else { panic!() };
    place("across", key.direction(&found).expect("it has one"), [-1.0, 0.0, 0.0]);
    assert_eq!(Model::compile(&scene).expect("compiles").links.len(), 2, "a link a side");
    let one = Model::compile(&with(&format!("{stopper}sides = \"-\"\n"))).expect("compiles");
    assert_eq!(one.links.iter().map(|link| link.name.as_str()).collect::<Vec<_>>(), ["key-"], "one side");
}

#[test]
fn a_bumper_pushes_out_of_the_wall_and_its_gap_is_that_from_the_plane() {
    let words = "[[bumper]]\nname = \"rubber\"\ngirder = \"west\"\nto = \"wall\"\nat_m = [-15.0, 0.0]\nto_m = [0.0, 0.0]\n\
                 stiffness_n_per_m = 1e8\n";
    let scene = with(words);
    let found = joint(&scene);
    let Some(Device::Bumper(rubber)) = scene.device(DeviceId { kind: DeviceKind::Bumper, number: 0 }) else { panic!() };
    assert_eq!(rubber.normal(&found), found.face, "out of the face");
    let [gap, distance] = rubber.gaps(&found).expect("it has a normal");
    within("0.1 m along the axis, square to the face", gap - 0.1 * 60f64.to_radians().sin(), 1e-12);
    assert_eq!(gap.to_bits(), distance.to_bits(), "all of it");
}

#[test]
fn what_is_wrong_with_a_device_is_said_at_its_key() {
    let cable = "[[restrainer]]\nname = \"d\"\ngirder = \"west\"\nat_m = [3, 1]\nto_m = [7, 8]\n";
    let bumper = "[[bumper]]\nname = \"d\"\ngirder = \"west\"\nat_m = [3, 1]\nto_m = [7, 8]\n";
    let damper = "[[damper]]\nname = \"d\"\ngirder = \"west\"\nat_m = [3, 1]\nto_m = [7, 8]\ncoefficient = 1e5\n";
    let stopper = "[[stopper]]\nname = \"d\"\ngirder = \"west\"\nat_m = [3, 1]\nstiffness_n_per_m = 1e7\n";
    let cases = [
        (cable, "", "restrainer.d.stiffness_n_per_m", "axial_stiffness_n"),
        (
            cable,
            "stiffness_n_per_m = 1e7\naxial_stiffness_n = 1e7\n",
            "restrainer.d.stiffness_n_per_m",
            "one of the two",
        ),
        (cable, "stiffness_n_per_m = 1e7\nlength_m = 3\n", "restrainer.d.length_m", "axial_stiffness_n"),
        (cable, "stiffness_n_per_m = 1e7\nslack_m = -1\n", "restrainer.d.slack_m", "0 or a number"),
        (
            cable,
            "stiffness_n_per_m = 1e7\nyield_force_n = 1e6\npost_yield_stiffness_n_per_m = 1e7\n",
            "restrainer.d.post_yield_stiffness_n_per_m",
            "less than K",
        ),
        (
            cable,
            "stiffness_n_per_m = 1e7\npost_yield_stiffness_n_per_m = 1e5\n",
            "restrainer.d.post_yield_stiffness_n_per_m",
            "yield_force_n",
        ),
        (cable, "stiffness_n_per_m = 1e7\nto = \"nobody\"\n", "restrainer.d.to", "girders: west, east"),
        (cable, "stiffness_n_per_m = 1e7\nto = \"west\"\n", "restrainer.d.to", "one girder"),
        (
            cable,
            "stiffness_n_per_m = 1e7\nyield_force_n = 1e6\nbreak_elongation_m = 0.05\n",
            "restrainer.d.break_elongation_m",
            "yields at T_y/K = 0.1 m",
        ),
        (bumper, "", "bumper.d.stiffness_n_per_m", "depth_force_m_n"),
        (bumper, "depth_force_m_n = [[0.1, 5], [0.2, 4]]\n", "bumper.d.depth_force_m_n", "rise"),
        (bumper, "depth_force_m_n = []\n", "bumper.d.depth_force_m_n", "at least one"),
        (bumper, "stiffness_n_per_m = 1e7\nnormal = [0, 0]\n", "bumper.d.normal", "a length"),
        (bumper, "stiffness_n_per_m = 1e7\nnormal = [0, -1]\n", "bumper.d.to_m", "behind the plane"),
        (damper, "exponent = 0.05\n", "damper.d.exponent", "from 0.1 to 1"),
        (damper, "regularisation_speed_m_s = 0\n", "damper.d.regularisation_speed_m_s", "greater than 0"),
        (stopper, "break_force_n = 1\nyield_force_n = 1\n", "stopper.d.break_force_n", "one of the two"),
        (stopper, "break_displacement_m = 1\n", "stopper.d.yield_force_n", "ductile"),
        (stopper, "sides = \"+\"\nminus_gap_m = 1\n", "stopper.d.minus_gap_m", "both"),
        (stopper, "to_m = [1, 1, 1]\n", "stopper.d.to_m", "planar"),
        (stopper, "direction = [1, 1, 1]\n", "stopper.d.direction", "planar"),
    ];
    for (device, words, place, remedy) in cases {
        let text = format!("{BRIDGE}{device}{words}");
        let errors = format::read(&text, "bridge.toml").expect_err(words).0;
        assert_eq!(errors.len(), 1, "{words}: {errors:#?}");
        assert!(
            errors[0].place.plain() == place && errors[0].remedy.to_string().contains(remedy),
            "{words}: {}",
            errors[0]
        );
    }
    let named = format!("{BRIDGE}{}", damper.replace("\"d\"", "\"wall\""));
    let errors = format::read(&named, "bridge.toml").expect_err("a name twice").to_string();
    assert!(errors.contains("or a device"), "{errors}");
    let short = format!("{BRIDGE}{}", damper.replace("to_m = [7, 8]\n", ""));
    let errors = format::read(&short, "bridge.toml").expect_err("no length").to_string();
    assert!(errors.contains("damper.d.to_m") && errors.contains("1e-6"), "{errors}");
}

#[test]
fn a_device_is_set_by_its_name_and_goes_with_its_bodies() {
    let words = "[[damper]]\nname = \"north\"\ngirder = \"west\"\nto = \"east\"\nat_m = [15, 1]\nto_m = [-15, 1]\n\
                 coefficient = 1e5\n[[stopper]]\nname = \"key\"\ngirder = \"east\"\nat_m = [0, 1]\nstiffness_n_per_m = 1e7\n";
    let scene = with(words);
    assert_eq!(overrides::apply(&scene, "damper.north.exponent=0.3").expect("a key").dampers[0].exponent, 0.3);
    assert_eq!(format::parse(&format::write(&scene), "written").as_ref(), Ok(&scene), "written and read");
    let mut renamed = scene.clone();
    let back = Edit::Rename("west".into(), "left".into()).apply(&mut renamed).expect("a free name");
    assert_eq!((renamed.dampers[0].girder.as_str(), validate(&renamed)), ("left", Ok(())), "renamed with it");
    back.apply(&mut renamed).expect("back");
    assert_eq!(renamed, scene, "as it was");
    let mut without = scene.clone();
    Edit::RemoveGirder(0).apply(&mut without).expect("there");
    assert_eq!((without.dampers.len(), without.stoppers.len()), (0, 1), "what named it is gone");
    let mut less = scene.clone();
    let id = DeviceId { kind: DeviceKind::Damper, number: 0 };
    let back = Edit::RemoveDevice(id).apply(&mut less).expect("there");
    assert!(less.dampers.is_empty() && Edit::RemoveDevice(id).apply(&mut less).is_err(), "gone");
    back.apply(&mut less).expect("back");
    let mut device = less.device(id).expect("there");
    device.part_mut().ends_mut().at[0] = 14.0;
    let back = Edit::ReplaceDevice(id, Box::new(device.clone())).apply(&mut less).expect("one name");
    assert_eq!(less.dampers[0].at[0], 14.0, "changed");
    back.apply(&mut less).expect("back");
    assert_eq!(less, scene, "as it was");
    assert!(Edit::AddDevice(0, Box::new(device)).apply(&mut less).is_err(), "its name is taken");
}

/// Two free girders that fly apart in space, turning, with devices between them.
fn in_space(devices: &str) -> History {
    let girder = |name: &str, mass: f64, x: f64, motion: &str| {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = 0.2\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = {mass:?}\n\
             position_m = [{x:?}, 0, 0]\ninitial = {{ {motion} }}\n"
        )
    };
    let one = girder("one", 2.0, 0.0, "velocity_m_s = [-0.2, 0.1, 0.05], spin_deg_s = 40, roll_deg_s = 30");
    let two = girder("two", 3.0, 0.5, "velocity_m_s = [0.1, 0, 0], pitch_deg_s = 50");
    let text = format!(
        "name = \"space\"\nkind = \"spatial\"\nduration_s = 1.0\ngravity_m_s2 = 0\n{one}{two}{devices}\
         [solver]\ntolerance = 1e-11\n"
    );
    let scene = scene(&text);
    validate(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    let mut session = Session::new(&scene).expect("a scene");
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    assert!(history.stop().is_none(), "{:?}", history.stop());
    history
}

#[test]
fn devices_between_two_free_girders_in_space_keep_momentum_angular_momentum_and_energy() {
    let ends = "name = \"d\"\ngirder = \"one\"\nto = \"two\"\nat_m = [0.1, 0.03, 0.01]\n";
    let to = "to_m = [-0.1, -0.02, -0.01]\n";
    let cases = [
        format!("[[restrainer]]\n{ends}{to}slack_m = 0.01\nstiffness_n_per_m = 2e4\nyield_force_n = 8\n"),
        format!("[[damper]]\n{ends}{to}coefficient = 4\nexponent = 0.4\n"),
        format!("[[damper]]\n{ends}{to}coefficient = 4\nexponent = 0.5\nbrace_stiffness_n_per_m = 1e4\n"),
        format!(
            "[[bumper]]\n{ends}{to}normal = [1, 0.2, 0.1]\ngap_m = 0\nstiffness_n_per_m = 1e3\ndamping_n_s_per_m = 2\n"
        ),
        format!(
            "[[stopper]]\n{ends}direction = [1, 0, 0.1]\ngap_m = 0.01\nstiffness_n_per_m = 1e3\nyield_force_n = 3\n"
        ),
    ];
    for words in cases {
        let history = in_space(&words);
        let pushed = history.motion(1, 1.0);
        assert!((pushed.velocity - DVec3::X * 0.1).length() > 1e-3, "a force acted: {words}{}", pushed.velocity);
        let [before, after] = [0.0, 1.0].map(|t| momenta_in_space(&history, t));
        for n in 0..2 {
            within(&format!("{words}: momentum {n}"), (after[n] - before[n]).length(), 1e-9);
        }
        let books = history.energy().ledger(1.0);
        within(&format!("{words}: ledger"), books.residual / books.scale, 1e-8);
    }
}

#[test]
fn the_impact_model_refuses_devices_in_words() {
    let mut scene =
        with("[[damper]]\nname = \"d\"\ngirder = \"west\"\nat_m = [0, 0]\nto_m = [9, 0]\ncoefficient = 1e5\n");
    scene.model.kind = ModelKind::Impact;
    let errors = Session::new(&scene).expect_err("refused").to_string();
    assert!(errors.contains("model.kind") && errors.contains("knows no devices"), "{errors}");
    scene.model.kind = ModelKind::Both;
    assert!(Session::new(&scene).is_err(), "beside the contact model too");
}
