//! Transparency of backwalls that hide a girder from the camera.

use glam::DVec3;

use super::Camera;
use super::block::Block;

/// Samples of a girder along each of its three directions (chosen).
const SAMPLES: usize = 4;
/// Hidden shares of a girder at which a wall begins to fade and has faded \[–\] (chosen).
const TURNS: [f64; 2] = [0.3, 0.7];
/// Alpha of a wall that has faded, as a share of its own (chosen).
const GLASS: f64 = 0.2;

/// Opacity of a wall, from 1 down to a fifth, by the part that it hides of the girder that it hides most.
///
/// It depends continuously on the camera, so that nothing jumps while orbiting.
pub(super) fn solidity(wall: &Block, girders: &[Block], camera: &Camera) -> f64 {
    let hidden = girders.iter().map(|g| hidden_share(wall, g, camera)).fold(0.0, f64::max);
    let t = ((hidden - TURNS[0]) / (TURNS[1] - TURNS[0])).clamp(0.0, 1.0);
    1.0 - (1.0 - GLASS) * t * t * (3.0 - 2.0 * t)
}

/// Share of a girder that lies behind the wall.
fn hidden_share(wall: &Block, girder: &Block, camera: &Camera) -> f64 {
    let eye = camera.homogeneous_eye();
    let points = samples(girder);
    let hidden = points.iter().filter(|&&p| {
        let way = eye.truncate() - p * eye.w;
        wall.entry(p, way).is_some_and(|at| at > 1e-9 && (eye.w == 0.0 || at < 1.0))
    });
    hidden.count() as f64 / points.len() as f64
}

fn samples(block: &Block) -> Vec<DVec3> {
    let [a, b, _, d] = block.face;
    let share = |i: usize| (i as f64 + 0.5) / SAMPLES as f64;
    let count = SAMPLES.pow(3);
    let at = |i: usize| [i % SAMPLES, i / SAMPLES % SAMPLES, i / SAMPLES / SAMPLES].map(share);
    (0..count).map(at).map(|[u, v, w]| a + (b - a) * u + (d - a) * v + block.sweep * w).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Projection;

    fn block(x: f64, y: f64) -> Block {
        let face = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(u, v)| DVec3::new(x + u, y, v));
        Block { face, sweep: DVec3::Y }
    }

    fn from_the_side(projection: Projection) -> Camera {
        let yaw = -std::f64::consts::FRAC_PI_2;
        Camera { target: DVec3::ZERO, yaw, pitch: 0.0, distance: 50.0, projection }
    }

    #[test]
    fn only_a_wall_before_the_girder_turns_to_glass() {
        for projection in [Projection::Orthographic, Projection::Perspective { fov_y: 0.5 }] {
            let camera = from_the_side(projection);
            let solid = |x, y| solidity(&block(x, y), &[block(0.0, 0.0)], &camera);
            assert_eq!(solid(0.0, 5.0), 1.0, "a wall behind the girder hides nothing");
            assert_eq!(solid(4.0, -5.0), 1.0, "a wall beside it hides nothing");
            // Lines of sight that are parallel come from everywhere on that side.
            let behind_the_eye = if projection == Projection::Orthographic { GLASS } else { 1.0 };
            assert!((solid(0.0, -100.0) - behind_the_eye).abs() < 1e-12, "a wall behind the eye");
            assert!((solid(0.0, -5.0) - GLASS).abs() < 1e-12, "a wall before all of it is glass");
        }
    }
}
