//! What one evaluation of a contact costs: a node against a face, each law in each state, and both with the forces carried
//! to the bodies.

use divan::{Bencher, black_box};
use girderbench::contact::normal::Linear;
use girderbench::contact::{Frame, FrictionLaw, Law, Local, Mode, Normal, locate};
use girderbench::dynamics::penalty3d::contact_force::act;
use girderbench::dynamics::penalty3d::contact_state::ClosedContact;
use girderbench::dynamics::{ContactSite, Model};
use girderbench::scene::presets;
use glam::{DVec2, DVec3};

fn main() {
    divan::main();
}

/// A contact of two girders, 1 µm deep and sliding.
fn touching() -> (ContactSite, [Frame; 2]) {
    let scene = presets::load("straight-straight").unwrap_or_else(|errors| panic!("{errors}"));
    let model = Model::compile(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    let pair = model.pairs.iter().find(|pair| pair.bodies.iter().all(Option::is_some));
    let site = pair.map(|pair| model.sites[pair.sites.start].clone());
    let site = site.unwrap_or_else(|| panic!("two girders that face each other"));
    let at = |body: Option<usize>, shift: DVec3| {
        let body = &model.bodies[body.unwrap_or(0)];
        Frame { shift, ..body.planar_frame(&[0.0, 0.0, 1e-4, 0.1, 0.05, 0.2]) }
    };
    let face = at(site.face_body, DVec3::ZERO);
    let gap = locate(&site.geometry, &at(site.node_body, DVec3::ZERO), &face).gap;
    let inwards = -face.turn(site.geometry.axes.z_axis) * (gap + 1e-6);
    let node = at(site.node_body, inwards);
    (site, [node, face])
}

fn law(friction: FrictionLaw) -> Law {
    let normal = Normal::Linear(Linear { k: 1.55e5, c: 220.0 });
    Law { normal, k_t: 1.55e5, c_t: 26.0, mu_s: 0.2, mu_k: 0.15, friction: friction.into(), clamp: false, v_stick: 0.0 }
}

const STICK: Mode = Mode::Stick { anchor: DVec2::new(0.01, 0.005) };
const SLIP: Mode = Mode::Slip { direction: DVec2::X };

#[divan::bench]
fn node_against_face(bencher: Bencher<'_, '_>) {
    let (site, [node, face]) = touching();
    bencher.bench(|| locate(black_box(&site.geometry), black_box(&node), black_box(&face)));
}

#[divan::bench(args = ["paper, stick", "paper, slip", "return mapping, stick", "return mapping, slip"])]
fn forces(bencher: Bencher<'_, '_>, case: &str) {
    let (site, [node, face]) = touching();
    let here: Local = locate(&site.geometry, &node, &face);
    let law = law(if case.starts_with("paper") { FrictionLaw::Paper } else { FrictionLaw::ReturnMapping });
    let mode = if case.ends_with("stick") { STICK } else { SLIP };
    bencher.bench(|| black_box(&law).forces(black_box(&mode), black_box(&here)));
}

/// Place, law, and the force and its levers in the world.
#[divan::bench]
fn one_contact(bencher: Bencher<'_, '_>) {
    let (site, [node, face]) = touching();
    let closed = ClosedContact::new(law(FrictionLaw::ReturnMapping), SLIP, 0.0);
    bencher.bench(|| act(&site, black_box(&closed), black_box(&node), black_box(&face)));
}
