//! Girders that bend, shorten and ring: against an independent program, closed forms, and invariants.

mod closed_forms;
mod connections;
mod invariants;
mod joint;
mod peaks;
mod reference;
mod scenes;
mod side_hit;
mod space;
mod space_connections;

use girderbench::scene::{Degree, Elastic, Scene, Sharing, ShearFactor, Tension};
use girderbench::sim::History;
use glam::DVec3;
use serde_json::Value;

use crate::support::reference::{Case, load, value};
use crate::support::scene;

/// A case of the independent program as a scene, with polynomials of this degree; by none, of as many as its contacts need.
pub(super) fn case(name: &str, degree: Option<usize>) -> (Case, Value) {
    let name = format!("flexible/{name}");
    let (mut case, json) = (load(&name), value(&name));
    case.scene.contact.sharing = Sharing::Tributary;
    for (girder, body) in case.scene.girders.iter_mut().zip(json["case"]["bodies"].as_array().expect("bodies")) {
        let number = |key: &str| body[key].as_f64().unwrap_or_else(|| panic!("{key}"));
        girder.elastic = Some(Elastic {
            young_modulus: number("E"),
            poisson_ratio: number("nu"),
            area: Some(number("A")),
            second_moment: Some(number("Iz")),
            shear_factor: ShearFactor(Some(number("kappa"))),
            damping_ratio: Some(number("zeta")),
            modes: Degree(degree.map(|degree| degree as f64)),
            ..Elastic::default()
        });
    }
    case.scene.contact.tension = Tension::Keep;
    (case, json)
}

/// The same scene with polynomials of this degree.
pub(super) fn with_degree(scene: &Scene, degree: usize) -> Scene {
    let mut scene = scene.clone();
    for elastic in scene.girders.iter_mut().filter_map(|girder| girder.elastic.as_mut()) {
        elastic.modes = Degree(Some(degree as f64));
    }
    scene
}

/// Force of all contacts on girder 0 \[N\].
pub(super) fn force_on_first(history: &History, t: f64) -> DVec3 {
    history.contacts().at(t).iter().fold(DVec3::ZERO, |sum, now| {
        let site = &history.model().sites[now.contact];
        sum + if site.node_body == Some(0) { now.force } else { -now.force }
    })
}

/// A straight bar of concrete without damping.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bar {
    pub length: f64,
    pub mass: f64,
}

impl Bar {
    pub(super) const DECK: Self = Self { length: 30.0, mass: 6e5 };
    /// E A \[N\].
    pub(super) const AXIAL: f64 = 30e9 * 8.0;

    pub(super) fn wave_speed(self) -> f64 {
        (Self::AXIAL * self.length / self.mass).sqrt()
    }

    pub(super) fn impedance(self) -> f64 {
        self.mass * self.wave_speed() / self.length
    }

    /// T = 2L/c \[s\].
    pub(super) fn there_and_back(self) -> f64 {
        2.0 * self.length / self.wave_speed()
    }

    fn text(self, name: &str, x: f64, speed: f64) -> String {
        format!(
            "[[girder]]\nname = \"{name}\"\nlength_m = {:?}\nwidth_m = 10.0\nthickness_m = 1.5\nmass_kg = {:?}\n\
             position_m = [{x:?}, 0.0, 0.0]\ninitial = {{ velocity_m_s = [{speed:?}, 0.0] }}\n\
             elastic = {{ area_m2 = 8.0, damping_ratio = 0.0 }}\n",
            self.length, self.mass
        )
    }
}

fn smooth(girders: &str, stiffness: f64, duration: f64) -> Scene {
    scene(&format!(
        "name = \"bars\"\nduration_s = {duration:?}\n{girders}[contact]\nstiffness_n_per_m = {stiffness:?}\nrestitution_normal = 1.0\n\
         restitution_tangential = 1.0\nmu_static = 0.0\nmu_kinetic = 0.0\n[solver]\ntolerance = 1e-12\n"
    ))
}

/// Two bars in a row, 1 mm apart, the first under way.
pub(super) fn bars([one, other]: &[Bar; 2], stiffness: f64, speed: f64, duration: f64) -> Scene {
    let girders = [one.text("a", -0.5 * one.length - 5e-4, speed), other.text("b", 0.5 * other.length + 5e-4, 0.0)];
    smooth(&girders.concat(), stiffness, duration)
}

/// A bar under way to a wall 1 mm off.
pub(super) fn on_a_wall(bar: Bar, stiffness: f64, speed: f64, duration: f64) -> Scene {
    let wall = "[[abutment]]\nname = \"wall\"\nfaces = \"a\"\ngap_m = 0.001\nwidth_m = 40.0\n";
    smooth(&format!("{}{wall}", bar.text("a", 0.0, speed)), stiffness, duration)
}

/// Sets a girder's velocity.
pub(super) fn moving(scene: &mut Scene, girder: usize, [x, y]: [f64; 2]) {
    scene.girders[girder].initial.velocity = [x, y, 0.0];
}
