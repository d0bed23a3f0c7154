//! Corners of two flush faces that slide past one another during a touch: the vertex that both bound stays pressed as it was, in plan as
//! in space.

use girderbench::sim::History;

use super::expect_carried;
use crate::support::{run, scene, within};

/// Speeds of the approach and across it \[m/s\].
const SPEED: [f64; 2] = [0.5, 0.05];
const RESTITUTION: f64 = 0.6;
/// Offsets across, of which the corners pass one another in the touch at all but the outer ones \[m\].
const ASIDE: [f64; 8] = [0.0, -2e-4, -3e-4, -4e-4, -5e-4, -6e-4, -8e-4, -2e-3];

const DECK: &str = "length_m = 30.0\nwidth_m = 10.0\nthickness_m = 1.5\nmass_kg = 6e5\n";

/// Two equal decks 5 mm apart, of which one moves towards the other and that one across: in line end to end, or side by side.
fn decks(kind: &str, side_by_side: bool, aside: f64) -> History {
    let across = |[along, across]: [f64; 2]| if side_by_side { [across, along] } else { [along, across] };
    let [x, y] = across([if side_by_side { 10.005 } else { 30.005 }, aside]);
    let ([towards_x, towards_y], [away_x, away_y]) = (across([SPEED[0], 0.0]), across([0.0, SPEED[1]]));
    run(&scene(&format!(
        "name = \"passing\"\nkind = \"{kind}\"\ngravity_m_s2 = 0.0\nduration_s = 0.3\n[contact]\nstiffness_n_per_m = 1e9\n\
         restitution_normal = {RESTITUTION}\ncalibration = \"exact\"\n\
         [[girder]]\nname = \"a\"\n{DECK}initial = {{ velocity_m_s = [{towards_x:?}, {towards_y:?}] }}\n\
         [[girder]]\nname = \"b\"\n{DECK}position_m = [{x:?}, {y:?}, 0.0]\ninitial = {{ velocity_m_s = [{away_x:?}, {away_y:?}] }}\n"
    )))
}

/// Speed of separation per speed of approach, and the spins of both.
fn outcome(history: &History, side_by_side: bool) -> [f64; 3] {
    let [a, b] = [0, 1].map(|girder| history.motion(girder, history.end()));
    let apart = b.velocity - a.velocity;
    [if side_by_side { apart.y } else { apart.x } / SPEED[0], a.spin.z, b.spin.z]
}

#[test]
fn ends_whose_corners_pass_one_another_return_the_restitution() {
    let [.., spin] = outcome(&decks("planar", false, ASIDE[7]), false);
    for aside in ASIDE {
        let [plan, space] = ["planar", "spatial"].map(|kind| {
            let history = decks(kind, false, aside);
            expect_carried(&history);
            assert!(history.contacts().dropped().is_none(), "{kind}, {aside} m: {:?}", history.contacts().dropped());
            outcome(&history, false)
        });
        // The girders turn, so that their ends part by a little more or less than their centres.
        within(&format!("restitution, {aside} m"), plan[0] - RESTITUTION, 2e-5);
        within("both turn alike", plan[1] - plan[2], 1e-9);
        // The friction at a vertex acts half a millimetre from where it would.
        within("spin", plan[1] / spin - 1.0, 1e-3);
        (0..3).for_each(|i| within("plan and space", plan[i] - space[i], 1e-9));
    }
}

#[test]
fn so_do_sides_that_meet() {
    for aside in ASIDE.map(|aside| -aside) {
        for kind in ["planar", "spatial"] {
            let history = decks(kind, true, aside);
            expect_carried(&history);
            within(&format!("{kind}, {aside} m"), outcome(&history, true)[0] - RESTITUTION, 2e-5);
        }
    }
}
