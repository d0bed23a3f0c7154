//! One collision of a pair at a corner or along a face: first and second impulse, energy lost, conditions of Tables 8–10.

use glam::DVec2;

use crate::dynamics::impact2d::InlineVec;
use crate::dynamics::impact2d::constants::SINGULAR_PIVOT;
use crate::dynamics::impact2d::delassus::{Cluster, ContactPoint, centre};
use crate::dynamics::impact2d::impulse::corner::{Coefficients, SecondImpulse, first_impulse, second_impulse};
use crate::dynamics::impact2d::impulse::face::{Ends, centroid, two_corner};
use crate::dynamics::impact2d::state::GirderState;
use crate::dynamics::impact2d::tables::{HitConditions, Outcome};
use crate::dynamics::integrator::dense_lu::solve_regularised;
use crate::scene::{Flush, ImpactSettings};

/// Contact points of a pair: a corner, or the two outermost points of a face, the lesser along `s` first.
#[derive(Clone, Debug)]
pub struct ContactManifold {
    /// The pair, its number in the model.
    pub pair: usize,
    /// The declared contacts.
    pub sites: InlineVec<usize>,
    /// Their points.
    pub points: InlineVec<ContactPoint>,
}

/// Impulses of a hit on the first side, in axes `n`, `s` of the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HitImpulses {
    /// Unit normal, towards the first side.
    pub normal: DVec2,
    /// `[v_n, v_s]` before, where the first impulse acts \[m/s\].
    pub approach: [f64; 2],
    /// `ζ` (44) from the middle of the face along `s`; 0 at a corner \[m\].
    pub offset: f64,
    /// `[P_n, P_s]` of the first impulse \[N·s\].
    pub first: [f64; 2],
    /// The second impulse, and which of the contact points it acts at.
    pub second: Option<(usize, SecondImpulse)>,
    /// `[P_n, P_s]` of a plastic impulse along the whole face, where the second drives the other end in \[N·s\].
    pub last: Option<[f64; 2]>,
    /// Energy lost \[J\].
    pub lost: f64,
}

impl HitImpulses {
    /// `[P_n, P_s]` of all impulses \[N·s\].
    pub fn total(&self) -> [f64; 2] {
        let second = self.second.map_or([0.0; 2], |(_, s)| s.impulse);
        let last = self.last.unwrap_or([0.0; 2]);
        [0, 1].map(|i| self.first[i] + second[i] + last[i])
    }
}

/// Result of a collision.
#[derive(Clone, Debug, PartialEq)]
pub struct Collision {
    /// Point of action of the first impulse, from the first side's G \[m\].
    pub arm: DVec2,
    /// The impulses.
    pub impulses: HitImpulses,
    /// Conditions of the row of Tables 8–10.
    pub conditions: HitConditions,
}

/// Impact law in force at an instant.
#[derive(Clone, Copy, Debug)]
pub struct ImpactLaw<'a> {
    /// Coefficients of the scene.
    pub settings: &'a ImpactSettings,
    /// Speed that is round-off \[m/s\].
    pub speed_noise: f64,
    /// Whether restitution is 0, after many hits at one instant.
    pub inelastic: bool,
}

impl ImpactLaw<'_> {
    fn face(&self) -> Coefficients {
        let i = self.settings;
        Coefficients { e_n: i.restitution_normal, e_t: i.restitution_tangential, mu_s: i.mu_static, mu_k: i.mu_kinetic }
    }

    fn corner(&self) -> Coefficients {
        let [mu_s, mu_k] = self.settings.corner_friction();
        Coefficients { mu_s, mu_k, ..self.face() }
    }

    /// Without restitution below the stop speed.
    fn at_speed(&self, coefficients: Coefficients, speed: f64) -> Coefficients {
        if self.inelastic || speed < self.settings.stop_speed { coefficients.inelastic() } else { coefficients }
    }
}

/// Applies the impulses of a contact that approaches; `from` is the state of the first side's girder.
pub fn collide(cluster: &mut Cluster, manifold: &ContactManifold, from: GirderState, law: &ImpactLaw<'_>) -> Collision {
    match manifold.points[..] {
        [first, second] => {
            let ends = [first, second];
            let middle = centre(&manifold.points);
            if cluster.speed(&middle, middle.n) < 0.0 {
                return face(cluster, &ends, from, law);
            }
            // Parallel, but only one end approaches.
            let end = fastest_end(cluster, &ends);
            corner(cluster, &ends[end], end, from, law)
        }
        _ => corner(cluster, &manifold.points[0], 0, from, law),
    }
}

/// The end with the lesser normal velocity.
fn fastest_end(cluster: &Cluster, ends: &Ends) -> usize {
    let [v0, v1] = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    usize::from(v1 < v0)
}

fn corner(
    cluster: &mut Cluster,
    point: &ContactPoint,
    end: usize,
    from: GirderState,
    law: &ImpactLaw<'_>,
) -> Collision {
    let approach = cluster.speeds(point);
    let coefficients = law.at_speed(law.corner(), -approach[0]);
    let (first, mut work) = first_impulse(cluster, point, &coefficients);
    let (again, outcome) = outcome(cluster, point, &coefficients, law.speed_noise);
    work += again.map_or(0.0, |s| s.work);
    let second = again.map(|s| (end, s));
    let (e_n, e_t) = (coefficients.e_n, coefficients.e_t);
    Collision {
        arm: point.arms[0],
        impulses: HitImpulses { normal: point.n, approach, offset: 0.0, first, second, last: None, lost: -work },
        conditions: HitConditions { from, flush: false, turns: true, slides: true, e_n, e_t, outcome },
    }
}

/// Outcome of the first impulse at a point, with the second impulse where the point approaches again.
fn outcome(
    cluster: &mut Cluster,
    point: &ContactPoint,
    coefficients: &Coefficients,
    speed_noise: f64,
) -> (Option<SecondImpulse>, Outcome) {
    let [v_n, v_s] = cluster.speeds(point);
    if v_n > speed_noise {
        return (None, Outcome::Separates);
    }
    if v_n >= -speed_noise {
        return (None, Outcome::Contact { at_rest: v_s.abs() <= speed_noise });
    }
    let again = second_impulse(cluster, point, coefficients, speed_noise);
    (Some(again), Outcome::SecondImpulse { held: again.held })
}

fn face(cluster: &mut Cluster, ends: &Ends, from: GirderState, law: &ImpactLaw<'_>) -> Collision {
    let speeds = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    if speeds.iter().all(|v| v.abs() < law.settings.stop_speed) {
        return plastic_face(cluster, ends, from);
    }
    if law.inelastic || law.settings.flush == Flush::TwoCorner {
        return two_corner_face(cluster, ends, from, law);
    }
    let part = centroid(cluster, ends);
    let point = ends[0].towards(&ends[1], part);
    let approach = cluster.speeds(&point);
    let coefficients = law.face();
    let (first, mut work) = first_impulse(cluster, &point, &coefficients);
    let FaceMotion { turns, slides } = face_motion(cluster, ends, law.speed_noise);
    let end = fastest_end(cluster, ends);
    let (again, outcome) = outcome(cluster, &ends[end], &law.corner(), law.speed_noise);
    work += again.map_or(0.0, |s| s.work);
    let mut last = None;
    let other = &ends[1 - end];
    if cluster.speed(other, other.n) < -law.speed_noise {
        // The second impulse has turned the face so that its other end approaches: both are stopped.
        let both = two_corner(cluster, ends, &coefficients.inelastic());
        work += both.work;
        last = Some([both.normal[0] + both.normal[1], both.tangential]);
    }
    let offset = (part - 0.5) * (ends[1].along - ends[0].along);
    let second = again.map(|s| (end, s));
    let (e_n, e_t) = (coefficients.e_n, coefficients.e_t);
    Collision {
        arm: point.arms[0],
        impulses: HitImpulses { normal: point.n, approach, offset, first, second, last, lost: -work },
        conditions: HitConditions { from, flush: true, turns, slides, e_n, e_t, outcome },
    }
}

/// Impulse on a face slower than the stop speed at both ends: `e_n` = 0 at each end, `e_t` = −1.
fn plastic_face(cluster: &mut Cluster, ends: &Ends, from: GirderState) -> Collision {
    let middle = ends[0].towards(&ends[1], 0.5);
    let approach = cluster.speeds(&middle);
    let before = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    let entry = |r: usize, c: usize| cluster.mobility(&ends[r], ends[r].n, &ends[c], ends[c].n);
    // Two ends that are both held have no solution and take no impulse.
    let impulses = solve_regularised(2, entry, |r| -before[r], SINGULAR_PIVOT).unwrap_or_else(|| vec![0.0; 2]);
    cluster.push(&ends[0], [impulses[0], 0.0]);
    cluster.push(&ends[1], [impulses[1], 0.0]);
    let lost = 0.5 * (0..2).map(|i| -impulses[i] * before[i]).sum::<f64>();
    let at_rest = approach[1] == 0.0;
    let (outcome, slides) = (Outcome::Contact { at_rest }, !at_rest);
    let first = [impulses[0] + impulses[1], 0.0];
    Collision {
        arm: middle.arms[0],
        impulses: HitImpulses { normal: middle.n, approach, offset: 0.0, first, second: None, last: None, lost },
        conditions: HitConditions { from, flush: true, turns: false, slides, e_n: 0.0, e_t: -1.0, outcome },
    }
}

/// Impulse along the face with unilateral conditions at both ends.
fn two_corner_face(cluster: &mut Cluster, ends: &Ends, from: GirderState, law: &ImpactLaw<'_>) -> Collision {
    let coefficients = if law.inelastic { law.face().inelastic() } else { law.face() };
    let middle = ends[0].towards(&ends[1], 0.5);
    let approach = cluster.speeds(&middle);
    let impulse = two_corner(cluster, ends, &coefficients);
    let FaceMotion { turns, slides } = face_motion(cluster, ends, law.speed_noise);
    let worst = ends[fastest_end(cluster, ends)];
    let separates = cluster.speed(&worst, worst.n) > law.speed_noise;
    let outcome = if separates { Outcome::Separates } else { Outcome::Contact { at_rest: !slides } };
    let total = impulse.normal[0] + impulse.normal[1];
    let part = if total > 0.0 { impulse.normal[1] / total } else { 0.5 };
    let offset = (part - 0.5) * (ends[1].along - ends[0].along);
    let (first, lost) = ([total, impulse.tangential], -impulse.work);
    Collision {
        arm: ends[0].towards(&ends[1], part).arms[0],
        impulses: HitImpulses { normal: middle.n, approach, offset, first, second: None, last: None, lost },
        conditions: HitConditions { from, flush: true, turns, slides, e_n: coefficients.e_n, e_t: -1.0, outcome },
    }
}

/// Motion of a face after its first impulse.
struct FaceMotion {
    /// Whether it turns relative to the other face.
    turns: bool,
    /// Whether its middle moves along the other face.
    slides: bool,
}

fn face_motion(cluster: &Cluster, ends: &Ends, speed_noise: f64) -> FaceMotion {
    let [v0, v1] = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    let middle = ends[0].towards(&ends[1], 0.5);
    FaceMotion { turns: (v1 - v0).abs() > speed_noise, slides: cluster.speed(&middle, middle.s).abs() > speed_noise }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::dynamics::impact2d::example::{cluster, touch};

    /// A girder of 1 kg, 0.19 × 0.07 m, flush at a wall with normal −x.
    fn at_wall(velocity: [f64; 3]) -> (Cluster, ContactManifold) {
        let n = DVec2::NEG_X;
        let i2 = (0.19 * 0.19 + 0.07 * 0.07) / 12.0;
        let girder = cluster([DVec3::new(1.0, 1.0, 1.0 / i2)], [velocity]);
        let end = |along: f64| {
            let arms = [DVec2::new(0.095, -along), DVec2::ZERO];
            touch([Some(0), None], n, arms, along)
        };
        let points = [end(-0.035), end(0.035)].into_iter().collect();
        (girder, ContactManifold { pair: 0, sites: [0, 1].into_iter().collect(), points })
    }

    fn hit(velocity: [f64; 3], flush: Flush, inelastic: bool) -> (Collision, [Cluster; 2]) {
        let (mut cluster, manifold) = at_wall(velocity);
        let before = cluster.clone();
        let settings = ImpactSettings { flush, ..ImpactSettings::default() };
        let law = ImpactLaw { settings: &settings, speed_noise: 1e-14, inelastic };
        let collision = collide(&mut cluster, &manifold, GirderState::Free, &law);
        (collision, [before, cluster])
    }

    #[test]
    fn all_impulses_together_are_the_change_of_momentum_and_their_work_that_of_energy() {
        for (flush, inelastic) in [(Flush::Paper, false), (Flush::TwoCorner, false), (Flush::Paper, true)] {
            for velocity in [[1.0, 0.3, 0.0], [1.0, -0.4, 5.0], [0.2, 0.5, 5.0], [0.2, 0.1, 5.9], [1e-5, 0.2, 0.0]] {
                let (collision, [before, after]) = hit(velocity, flush, inelastic);
                let [p_n, p_s] = collision.impulses.total();
                let change = (after.velocity[0] - before.velocity[0]).truncate();
                let impulse = DVec2::NEG_X * p_n + DVec2::NEG_Y * p_s;
                assert!((change - impulse).length() < 1e-14, "{flush:?}, {velocity:?}: {change} by {impulse}");
                let lost = before.kinetic_energy() - after.kinetic_energy();
                assert!((lost - collision.impulses.lost).abs() < 1e-14, "{flush:?}, {velocity:?}: {lost} J");
            }
        }
    }

    #[test]
    fn a_face_of_which_one_end_separates_is_hit_at_the_other() {
        // v_n = −ẋ ± b θ̇: the middle separates.
        let (collision, _) = hit([-0.1, 0.0, 10.0], Flush::Paper, false);
        assert!(!collision.conditions.flush && collision.impulses.offset == 0.0, "{collision:?}");
    }

    #[test]
    fn below_the_stop_speed_a_face_comes_to_rest_along_the_normal() {
        let stop = ImpactSettings::default().stop_speed;
        let (collision, [_, after]) = hit([0.5 * stop, 0.2, 0.0], Flush::Paper, false);
        assert!((after.velocity[0] - DVec3::new(0.0, 0.2, 0.0)).length() < 1e-18, "{:?}", after.velocity);
        assert_eq!(collision.impulses.first[1], 0.0, "no tangential impulse");
        assert_eq!(collision.conditions.outcome, Outcome::Contact { at_rest: false }, "it slides");
    }
}
