//! One hit of a pair, whichever way it meets: corner or face, first and second impulse, the row that fired.

use glam::DVec2;

use crate::dynamics::impact2d::Few;
use crate::dynamics::impact2d::delassus::{Cluster, Point};
use crate::dynamics::impact2d::impulse::corner::{Coefficients, Second, first, second};
use crate::dynamics::impact2d::impulse::face::{Ends, centroid, two_corner};
use crate::dynamics::impact2d::lasting::constrained_motion::middle;
use crate::dynamics::impact2d::state::{After, Landing, State};
use crate::scene::{Flush, ImpactSettings};

/// Where a pair touches: a corner, or the two outermost points of a face, the one further back along `s` first.
#[derive(Clone, Debug)]
pub struct Edge {
    /// The pair, its number in the model.
    pub pair: usize,
    /// The declared contacts.
    pub sites: Few<usize>,
    /// Where they are.
    pub points: Few<Point>,
}

/// What a hit did.
#[derive(Clone, Debug, PartialEq)]
pub struct Blow {
    /// Where the first impulse acted, from the first side's G \[m\].
    pub arm: DVec2,
    /// Unit normal, towards the first side.
    pub normal: DVec2,
    /// `[v_n, v_s]` there before \[m/s\].
    pub approach: [f64; 2],
    /// `ζ`, from the middle of the face along `s`; 0 at a corner \[m\].
    pub offset: f64,
    /// `[P_n, P_s]` of the first impulse, on the first side \[N·s\].
    pub first: [f64; 2],
    /// Which end of the edge got a second impulse, and what it was.
    pub second: Option<(usize, Second)>,
    /// `[P_n, P_s]` that both ends of a face got last, where the second impulse drove the other end in; or a hit that
    /// ended without a bounce along the whole face \[N·s\].
    pub last: Option<[f64; 2]>,
    /// Energy lost \[J\].
    pub lost: f64,
    /// What the paper's tables ask about it.
    pub landing: Landing,
}

/// The rules in force for a hit.
#[derive(Clone, Copy, Debug)]
pub struct Rules<'a> {
    /// The scene's numbers.
    pub numbers: &'a ImpactSettings,
    /// A speed that is rounding \[m/s\].
    pub hush: f64,
    /// Whether this instant has had so many hits that there is no more bounce.
    pub dead: bool,
}

impl Rules<'_> {
    fn face(&self) -> Coefficients {
        let i = self.numbers;
        Coefficients { e_n: i.restitution_normal, e_t: i.restitution_tangential, mu_s: i.mu_static, mu_k: i.mu_kinetic }
    }

    fn corner(&self) -> Coefficients {
        let [mu_s, mu_k] = self.numbers.corner_friction();
        Coefficients { mu_s, mu_k, ..self.face() }
    }

    /// Without a bounce below the stop speed.
    fn at(&self, numbers: Coefficients, speed: f64) -> Coefficients {
        if self.dead || speed < self.numbers.stop_speed { numbers.dead() } else { numbers }
    }
}

/// Hits an edge that is driven in, coming from a state.
pub fn strike(cluster: &mut Cluster, edge: &Edge, from: State, rules: &Rules<'_>) -> Blow {
    match edge.points[..] {
        [first, second] => {
            let ends = [first, second];
            let middle = middle(&edge.points);
            if cluster.speed(&middle, middle.n) < 0.0 {
                return face(cluster, &ends, from, rules);
            }
            // Parallel, but only one end comes in.
            let end = driven_in(cluster, &ends);
            corner(cluster, &ends[end], end, from, rules)
        }
        _ => corner(cluster, &edge.points[0], 0, from, rules),
    }
}

/// The end with the lesser normal velocity.
fn driven_in(cluster: &Cluster, ends: &Ends) -> usize {
    let [v0, v1] = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    usize::from(v1 < v0)
}

fn corner(cluster: &mut Cluster, point: &Point, end: usize, from: State, rules: &Rules<'_>) -> Blow {
    let approach = cluster.speeds(point);
    let numbers = rules.at(rules.corner(), -approach[0]);
    let (impulse, mut work) = first(cluster, point, &numbers);
    let (again, after) = outcome(cluster, point, &numbers, rules.hush);
    work += again.map_or(0.0, |s| s.work);
    let landing = Landing { from, flush: false, turns: true, slides: true, e_n: numbers.e_n, e_t: numbers.e_t, after };
    Blow {
        arm: point.arms[0],
        normal: point.n,
        approach,
        offset: 0.0,
        first: impulse,
        second: again.map(|s| (end, s)),
        last: None,
        lost: -work,
        landing,
    }
}

/// What the first impulse has made of a point, with the second where it takes one.
fn outcome(cluster: &mut Cluster, point: &Point, numbers: &Coefficients, hush: f64) -> (Option<Second>, After) {
    let [v_n, v_s] = cluster.speeds(point);
    if v_n > hush {
        return (None, After::Free);
    }
    if v_n >= -hush {
        return (None, After::Contact { still: v_s.abs() <= hush });
    }
    let again = second(cluster, point, numbers);
    (Some(again), After::Again { held: again.held })
}

fn face(cluster: &mut Cluster, ends: &Ends, from: State, rules: &Rules<'_>) -> Blow {
    let speeds = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    if speeds.iter().all(|v| v.abs() < rules.numbers.stop_speed) {
        return lie_down(cluster, ends, from);
    }
    if rules.dead || rules.numbers.flush == Flush::TwoCorner {
        return spread(cluster, ends, from, rules, rules.dead);
    }
    let part = centroid(cluster, ends);
    let point = ends[0].towards(&ends[1], part);
    let approach = cluster.speeds(&point);
    let numbers = rules.face();
    let (impulse, mut work) = first(cluster, &point, &numbers);
    let (turns, slides) = goes_on(cluster, ends, rules.hush);
    let end = driven_in(cluster, ends);
    let (again, after) = outcome(cluster, &ends[end], &rules.corner(), rules.hush);
    work += again.map_or(0.0, |s| s.work);
    let mut last = None;
    let other = &ends[1 - end];
    if cluster.speed(other, other.n) < -rules.hush {
        // The second impulse has turned it the other way: both ends are in.
        let both = two_corner(cluster, ends, &numbers.dead());
        work += both.work;
        last = Some([both.normal[0] + both.normal[1], both.tangential]);
    }
    let landing = Landing { from, flush: true, turns, slides, e_n: numbers.e_n, e_t: numbers.e_t, after };
    Blow {
        arm: point.arms[0],
        normal: point.n,
        approach,
        offset: (part - 0.5) * (ends[1].along - ends[0].along),
        first: impulse,
        second: again.map(|s| (end, s)),
        last,
        lost: -work,
        landing,
    }
}

/// A face slower than the stop speed at both ends lies down: no bounce, `e_t` = −1, no rocking on.
fn lie_down(cluster: &mut Cluster, ends: &Ends, from: State) -> Blow {
    let middle = ends[0].towards(&ends[1], 0.5);
    let approach = cluster.speeds(&middle);
    let before = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    let entry = |r: usize, c: usize| cluster.mobility(&ends[r], ends[r].n, &ends[c], ends[c].n);
    // Two ends that give way have an answer; one that is held takes no push.
    let pushes = crate::dynamics::impact2d::dense::solve(2, entry, |r| -before[r]).unwrap_or_else(|| vec![0.0; 2]);
    cluster.push(&ends[0], [pushes[0], 0.0]);
    cluster.push(&ends[1], [pushes[1], 0.0]);
    let lost = 0.5 * (0..2).map(|i| -pushes[i] * before[i]).sum::<f64>();
    let still = approach[1] == 0.0;
    let after = After::Contact { still };
    Blow {
        arm: middle.arms[0],
        normal: middle.n,
        approach,
        offset: 0.0,
        first: [pushes[0] + pushes[1], 0.0],
        second: None,
        last: None,
        lost,
        landing: Landing { from, flush: true, turns: false, slides: !still, e_n: 0.0, e_t: -1.0, after },
    }
}

/// A hit along the face with unilateral conditions at both ends.
fn spread(cluster: &mut Cluster, ends: &Ends, from: State, rules: &Rules<'_>, dead: bool) -> Blow {
    let numbers = if dead { rules.face().dead() } else { rules.face() };
    let middle = ends[0].towards(&ends[1], 0.5);
    let approach = cluster.speeds(&middle);
    let spread = two_corner(cluster, ends, &numbers);
    let (turns, slides) = goes_on(cluster, ends, rules.hush);
    let worst = ends[driven_in(cluster, ends)];
    let free = cluster.speed(&worst, worst.n) > rules.hush;
    let after = if free { After::Free } else { After::Contact { still: !slides } };
    let total = spread.normal[0] + spread.normal[1];
    let part = if total > 0.0 { spread.normal[1] / total } else { 0.5 };
    let landing = Landing { from, flush: true, turns, slides, e_n: numbers.e_n, e_t: -1.0, after };
    Blow {
        arm: ends[0].towards(&ends[1], part).arms[0],
        normal: middle.n,
        approach,
        offset: (part - 0.5) * (ends[1].along - ends[0].along),
        first: [total, spread.tangential],
        second: None,
        last: None,
        lost: -spread.work,
        landing,
    }
}

/// Whether the face turns, and whether its middle goes along the other.
fn goes_on(cluster: &Cluster, ends: &Ends, hush: f64) -> (bool, bool) {
    let [v0, v1] = [0, 1].map(|i| cluster.speed(&ends[i], ends[i].n));
    let middle = ends[0].towards(&ends[1], 0.5);
    ((v1 - v0).abs() > hush, cluster.speed(&middle, middle.s).abs() > hush)
}
