//! Choice of the face with which a corner or an edge of a body touches: the one that faces the other body the most.

use glam::DVec3;

/// Least angle between two faces that are opposite \[rad\]: round-off of normals.
const OPPOSITE: f64 = std::f64::consts::PI - 1e-6;

/// A face by which a corner or an edge belongs to a pair, and the others that it could belong to: outward unit normals as placed,
/// world axes.
#[derive(Clone, Debug)]
pub struct FaceChoice {
    /// Of the face by which it belongs to its pair.
    pub own: DVec3,
    /// Of the others, and whether the own one has precedence over it where both look at a face equally.
    pub others: Vec<(DVec3, bool)>,
}

impl FaceChoice {
    /// Half of the largest angle between the own face's normal and that of another which is not its opposite \[rad\].
    pub fn reach(&self) -> f64 {
        let angles = self.others.iter().map(|(other, _)| self.own.dot(*other).clamp(-1.0, 1.0).acos());
        let largest = angles.filter(|angle| *angle < OPPOSITE).fold(0.0, f64::max);
        0.5 * largest
    }

    /// Whether the own face can be the most opposed to a direction that differs from `normal`, relative to the body, by at most half of
    /// `slack` \[rad\].
    pub fn may_be_opposed_most(&self, turn: impl Fn(DVec3) -> DVec3, normal: DVec3, slack: f64) -> bool {
        let own = turn(self.own).dot(normal) - slack;
        self.others.iter().all(|&(other, _)| own <= turn(other).dot(normal))
    }

    /// Whether of all these faces the own one is the most opposed to a direction `normal`: exactly one of them is. `turn` takes a
    /// vector of the body as placed to the axes of `normal`.
    pub fn is_opposed_most(&self, turn: impl Fn(DVec3) -> DVec3, normal: DVec3) -> bool {
        let facing = |own: DVec3| turn(own).dot(normal);
        let own = facing(self.own);
        self.others.iter().all(|&(other, precedes)| {
            let other = facing(other);
            own < other || (own == other && precedes)
        })
    }
}
