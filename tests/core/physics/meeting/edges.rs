//! Edges of bodies in space that meet at any attitude: closed forms of hits.

use std::f64::consts::PI;

use girderbench::scene::Scene;
use girderbench::sim::History;
use glam::DVec3;

use super::{damping_ratio, expect_carried, restitution, velocity};
use crate::support::{run, scene, within};

/// Vertices of the polygon in which two faces overlap that lie across each other, seen along the normal.
const VERTICES: f64 = 4.0;
/// Approach \[m/s\].
const SPEED: f64 = 0.5;

/// A bar along x and one that comes down (z) at it along y turned by `heading`; both rolled, the second is above `along` on the
/// first one's axis.
fn bars(stiffness: f64, rolls: [f64; 2], [heading, along]: [f64; 2]) -> Scene {
    let bar = "length_m = 0.6\nwidth_m = 0.1\nthickness_m = 0.08\nmass_kg = 2.0\n";
    scene(&format!(
        "name = \"bars\"\nkind = \"spatial\"\ngravity_m_s2 = 0.0\nduration_s = 0.2\n[contact]\nstiffness_n_per_m = {stiffness:e}\n\
         restitution_normal = 0.6\nrestitution_tangential = 1.0\nmu_static = 0.0\nmu_kinetic = 0.0\n[solver]\ntolerance = 1e-10\n\
         [[girder]]\nname = \"lying\"\n{bar}initial = {{ roll_deg = {} }}\n\
         [[girder]]\nname = \"thrown\"\n{bar}position_m = [{along}, 0.0, 0.15]\nheading_deg = {heading}\n\
         initial = {{ roll_deg = {}, velocity_m_s = [0, 0, {}] }}\n",
        rolls[0], rolls[1], -SPEED
    ))
}

/// Sum of the angular momenta about the origin \[kg·m²/s\] at `t`.
pub(super) fn angular_momentum(history: &History, t: f64) -> DVec3 {
    let own = |(girder, body): (usize, &girderbench::dynamics::Body)| {
        let m = history.motion(girder, t);
        let spin = m.attitude * (body.inertia * (m.attitude.inverse() * m.spin));
        body.mass * m.place.cross(m.velocity) + spin
    };
    history.model().bodies.iter().enumerate().map(own).sum()
}

/// Mobility of both bodies at the point of a touch along its normal, here z \[1/kg\].
fn mobility(history: &History) -> f64 {
    let touch = &history.hits().touches()[0];
    let at = history.contacts().contact_at(touch.contact, touch.start + 1e-7).expect("closed");
    let of = |girder: usize| {
        let (m, body) = (history.motion(girder, touch.start), &history.model().bodies[girder]);
        let turn = (at.point - m.place).cross(DVec3::Z);
        let own = m.attitude.inverse() * turn;
        1.0 / body.mass + own.dot(body.inverse_inertia * own)
    };
    of(0) + of(1)
}

#[test]
fn edges_that_cross_at_their_middles_return_the_restitution() {
    // Square bars would stand on their edges; these lean, and turn about their axes.
    for (rolls, heading) in [([45.0, 45.0], 90.0), ([40.0, 45.0], 90.0), ([52.0, -48.0], 60.0), ([30.0, 60.0], 35.0)] {
        let miss = |stiffness: f64| {
            let history = run(&bars(stiffness, rolls, [heading, 0.02]));
            expect_carried(&history);
            assert!(history.events().iter().all(|event| !event.kind.is_touch() || event.t < 0.1), "one hit");
            let nodes = history.hits().touches().len() as f64;
            assert!(nodes <= 2.0, "one point of contact, of either edge");
            let w = mobility(&history);
            // K and C are divided among the vertices of the polygon in which the two faces overlap, of which one touches; C was
            // made for all of them and for the masses of both at their centres, m/2 = 1 kg (65).
            let damping = damping_ratio(0.6) * (w / VERTICES).sqrt();
            let frequency = (stiffness / VERTICES * w * (1.0 - damping * damping)).sqrt();
            let touch = &history.hits().touches()[0];
            within("time of the touch", (touch.end - touch.start) * frequency / PI - 1.0, 20.0 / stiffness.sqrt());
            let returned = restitution(damping);
            let impulse = (1.0 + returned) * SPEED / w;
            let [one, other] = [0, 1].map(|girder| velocity(&history, girder));
            within("momentum", (one + other + DVec3::Z * SPEED).length(), 1e-12);
            let turned = angular_momentum(&history, history.end()) - angular_momentum(&history, 0.0);
            within("angular momentum", turned.length(), 1e-9);
            (2.0 * (other.z + SPEED) / impulse - 1.0).abs()
        };
        let [soft, hard] = [1e6, 1e8].map(miss);
        // They turn by the time of the touch, which falls with the root of the stiffness.
        within("short touch", hard, 2e-3);
        assert!(hard < 0.2 * soft || hard < 1e-6, "{rolls:?}: {soft:e} and, ten times as short, {hard:e}");
    }
}

/// Two slabs of which the second comes at an angle of 45° to all faces, one long edge over another, turned by heading, pitch and roll \[°\]
/// and displaced along and across the edges \[m\].
fn ridges([heading, pitch, roll]: [f64; 3], [x, y, z]: [f64; 3]) -> Scene {
    let slab = "length_m = 0.19\nwidth_m = 0.07\nthickness_m = 0.02\nmass_kg = 2.0\n";
    scene(&format!(
        "name = \"ridges\"\nkind = \"spatial\"\ngravity_m_s2 = 0.0\nduration_s = 0.06\n[contact]\nstiffness_n_per_m = 1.55e5\n\
         restitution_normal = 0.4\nrestitution_tangential = 0.9\nmu_static = 0.2\nmu_kinetic = 0.15\n[solver]\ntolerance = 1e-12\n\
         [[girder]]\nname = \"lying\"\n{slab}\
         [[girder]]\nname = \"thrown\"\n{slab}position_m = [{x}, {}, {}]\nheading_deg = {heading}\n\
         initial = {{ pitch_deg = {pitch}, roll_deg = {roll}, velocity_m_s = [0, -0.3, -0.3] }}\n",
        0.0765 + y,
        0.0265 + z
    ))
}

#[test]
fn edges_that_cross_at_a_degree_do_not_pass_through_each_other() {
    // At 0.9° and 1.1°: no corner comes in before the edges have passed each other by a millimetre.
    for (turned, beside) in
        [([-0.608, -0.624, 1.327], [-0.01, -2e-4, 3e-4]), ([-0.436, -1.014, -0.511], [-0.02, -1e-4, -2e-4])]
    {
        let history = run(&ridges(turned, beside));
        expect_carried(&history);
        assert!(history.events().iter().any(|event| event.kind.is_touch()), "they touch");
        let scale = history.energy().ledger(history.end()).scale;
        let appeared = history.events().iter().map(|event| -event.released).fold(0.0, f64::max);
        within("energy that appears", appeared / scale, 1e-9);
    }
}
