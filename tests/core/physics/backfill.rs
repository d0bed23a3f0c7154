//! Backfill behind a backwall: against an independent program, closed forms, and the books.

use std::sync::Arc;

use girderbench::dynamics::connection::Kinematics;
use girderbench::dynamics::devices::{Backfill, Envelope};
use girderbench::scene::Scene;
use girderbench::sim::{History, Session};
use glam::DMat3;

use super::devices::{agrees, free, girder, run, supported};
use crate::support::{scene, within};

/// The soil of the reference cases between the girder's end and the ground, at this gap \[m\].
fn direct(gap: f64) -> super::devices::Placed {
    let soil = Backfill::new(0.0, Envelope::hyperbolic(1.5e4, 0.75, 60.0), 1.5e4).expect("a law");
    ([0.095, 0.0], [0.095 + gap, 0.0], DMat3::IDENTITY, Kinematics::Points, Arc::new(soil))
}

#[test]
fn soil_that_a_girder_hits_is_that_of_an_independent_program() {
    let scene = girder(90.0, &supported(0.29), [0.4, 2.4, 0.0], 5.0);
    let history = agrees("s_direct", &scene, vec![direct(0.003)], 1e-10);
    assert_eq!(history.connections().link_phases(0).len() - 1, 47, "changes of phase");
}

#[test]
fn soil_throws_a_mass_back_as_in_closed_form() {
    let history = run(&free(0.34, 0.2), vec![direct(0.01)]);
    let turned =
        history.connections().link_phases(0).windows(2).find(|two| two[0].1.branch == 2).expect("on the envelope")[1].0;
    within("greatest push", history.motion(0, turned).displacement.x - 0.01 - 4.942_912_219e-3, 1e-11);
    within("force", -history.connections().link(0, turned).expect("soil").force.x - 38.480_296_673, 1e-8);
    within("rebound", -history.motion(0, 0.2).velocity.x - 0.222_166_096_426, 1e-10);
}

/// The reference case of a wall of 0.2 kg on a slider before the same soil, in the direction of the girder's `heading` \[°\].
fn wall(heading: f64) -> Scene {
    let friction = 1.2 / (0.2 * 9.80665);
    let walled = format!(
        r#"{}
        heading_deg = {heading}
        [[abutment]]
        name = "wall"
        faces = "deck"
        end = "+x"
        gap_m = 0.003
        [abutment.backfill]
        law = "hyperbolic"
        stiffness_n_per_m = 1.5e4
        failure_ratio = 0.75
        ultimate_n = 60.0
        wall_mass_kg = 0.2
        base_friction = {friction:?}
        base_displacement_m = 0.0001
        [contact]
        stiffness_n_per_m = 1.55e5
        restitution_normal = 0.4
        "#,
        supported(0.29)
    );
    girder(90.0, &walled, [0.4, 2.4, heading], 5.0)
}

fn finished(scene: &Scene) -> History {
    let mut session = Session::new(scene).expect("a scene");
    session.advance(scene.duration, &mut |_| true);
    let history = session.finish();
    assert!(history.stop().is_none(), "{:?}", history.stop());
    history
}

#[test]
fn a_backwall_on_soil_and_a_slider_is_that_of_an_independent_program() {
    let history = agrees("s_wall", &wall(0.0), Vec::new(), 1e-8);
    assert_eq!(history.model().walls.iter().flatten().map(|wall| wall.body).collect::<Vec<_>>(), [1]);
    let at_end = history.motion(1, 5.0);
    within("the wall at the end", at_end.displacement.x - 2.112_479_100_269_766_5e-3, 1e-10);
    within("its velocity", at_end.velocity.x - 0.016_557_909_641_752_234, 1e-8);
}

#[test]
fn a_wall_in_another_direction_moves_along_its_normal() {
    let (along, turned) = (finished(&wall(0.0)), finished(&wall(30.0)));
    for i in 0..=50 {
        let t = 0.1 * f64::from(i);
        for body in 0..2 {
            let [one, other] = [&along, &turned].map(|history| history.motion(body, t).displacement);
            let back = glam::DQuat::from_rotation_z(-30f64.to_radians()) * other;
            within(&format!("body {body} at {t} s"), (one - back).length(), 1e-9);
        }
    }
}

/// A skewed deck of 30 m between walls of both kinds of envelope, in plan or in space.
fn span(kind: &str) -> Scene {
    let backwall = |name: &str, end: &str, law: &str| {
        format!(
            "[[abutment]]\nname = \"{name}\"\nfaces = \"deck\"\nend = \"{end}\"\ngap_m = 0.05\nheight_m = 2.0\n\
             [abutment.backfill]\nlaw = \"{law}\"\n"
        )
    };
    scene(&format!(
        r#"
        name = "span"
        kind = "{kind}"
        duration_s = 6.0
        [[girder]]
        name = "deck"
        length_m = 30.0
        width_m = 10.0
        thickness_m = 1.7
        skew_deg = 60.0
        mass_kg = 6e5
        bearings = {{ frequency_hz = 0.6, damping_ratio = 0.05, vertical_frequency_hz = 10.0,
            at_skewed_m = [[13, 4], [13, -4], [-13, 4], [-13, -4]] }}
        {}{}
        [contact]
        stiffness_n_per_m = 1e9
        restitution_normal = 0.6
        [motion]
        kind = "sine"
        amplitude_g = 0.4
        frequency_hz = 0.6
        angle_deg = 20
        [solver]
        tolerance = 1e-10
        "#,
        backwall("east", "+x", "mean-stiffness"),
        backwall("west", "-x", "bilinear")
    ))
}

#[test]
fn the_books_of_a_skewed_deck_between_walls_on_soil_balance_and_the_soil_never_pulls() {
    for kind in ["planar", "spatial"] {
        let history = finished(&span(kind));
        let soil = history.connections().backfill();
        assert!(soil.len() == 2 && soil.iter().all(|soil| soil.push > 1e-3), "{kind}: both are pushed: {soil:?}");
        for soil in soil {
            assert!(soil.force <= soil.ultimate * (1.0 + 1e-12) && soil.remaining_gap < soil.push, "{kind}: {soil:?}");
        }
        for i in 1..=600 {
            let t = 0.01 * f64::from(i);
            for abutment in 0..2 {
                let force = history
                    .connections()
                    .wall(abutment, t)
                    .and_then(|wall| wall.soil)
                    .expect("soil behind a wall")
                    .force;
                assert!(force >= -1e-3, "{kind}: {force} N at {t} s");
            }
            let books = history.energy().ledger(t);
            within(&format!("{kind}: ledger at {t}"), books.residual / books.scale, 1e-8);
        }
        assert!(history.overlaps().is_empty(), "{kind}: {:?}", history.overlaps());
    }
}

#[test]
fn a_wall_that_slides_on_its_base_is_followed_in_steps_of_its_motion() {
    // Under a record the wall's base yields where no spring acts: a bound on its speed by an oscillation has none to go by, and the
    // search for bodies that meet went on by the last bit of the time.
    let scene = scene(
        "name = \"slides\"\nduration_s = 1.2\n[contact]\nstiffness_n_per_m = 1e9\n\
         [[girder]]\nname = \"deck\"\nlength_m = 30\nwidth_m = 10\nthickness_m = 1.7\nskew_deg = 60\nmass_kg = 3e5\n\
         bearings = { frequency_hz = 0.4, damping_ratio = 0.03, at_m = [[10, 3], [-10, -3]] }\n\
         [[abutment]]\nname = \"east\"\nfaces = \"deck\"\nend = \"+x\"\ngap_m = 0.05\n\
         [abutment.backfill]\nlaw = \"hyperbolic\"\nunloading_stiffness_n_per_m = 3e8\n\
         [[abutment]]\nname = \"west\"\nfaces = \"deck\"\nend = \"-x\"\ngap_m = 0.5\n\
         [motion]\nkind = \"record\"\nangle_deg = 25\ndt_s = 0.17\n\
         samples_m_s2 = [0.26, 3.25, -1.95, -5.85, 2.86, 6.24, -1.3, -6.5, -1.56]\n",
    );
    let history = finished(&scene);
    assert_eq!(history.overlaps(), [], "walls 30 m apart");
    assert!(history.energy().balance().holds(), "{:?}", history.energy().balance());
}
