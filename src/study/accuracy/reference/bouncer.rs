//! P1, P1d and P3: the straight girder head-on. One degree of freedom, linear in flight and in contact:
//!
//! flight `ẍ = −ω²x − 2hω ẋ − A sin Ωt`, contact the same with `−(K (x − g) + C ẋ)/m`.
//!
//! In P3 the wall is rigid: where the gap closes, `ẋ` becomes `−e_n ẋ`.
//!
//! Each stretch is a Taylor series in 32-digit arithmetic, its end a root of the gap to as many digits. The numbers are
//! those of the problem's statement, not of the program; nothing else is shared with it either.

use super::wide::{TAU, Wide, ratio};
use crate::study::accuracy::{Answer, Instants};

/// Terms of a series: the last is below 0.25^24/24! ≈ 1e-38 of the first.
const TERMS: usize = 24;
/// Length of a stretch times the fastest circular frequency in it.
const REACH: f64 = 0.25;
/// Looks at the gap in a stretch.
const LOOKS: usize = 32;
/// Nodes of a flush end; each carries its part of the force.
const NODES: f64 = 2.0;

type Series = [Wide; TERMS];

struct Bouncer {
    /// `ω²`, `2hω` of the bearings [1/s², 1/s].
    bearing: [Wide; 2],
    /// `K/m`, `C/m`.
    contact: [Wide; 2],
    gap: Wide,
    amplitude: Wide,
    drive: Wide,
    mass: f64,
    touching: bool,
    /// `e_n` of a rigid wall.
    rigid: Option<f64>,
    /// x, ẋ, sin Ωt, cos Ωt.
    state: [Wide; 4],
    t: Wide,
    peak: f64,
}

/// The answer for a restitution `e_n` of the dashpot, or of a rigid wall.
pub(super) fn answer(restitution: f64, rigid: bool, instants: Instants) -> Answer {
    let omega = TAU * ratio(12.0, 5.0);
    let (mass, k) = (2.0, Wide::from(1.55e5));
    let log = restitution.ln();
    let ratio_of_critical = -log / std::f64::consts::PI.hypot(log);
    let c = (k * Wide::from(mass)).sqrt() * Wide::from(2.0 * ratio_of_critical);
    let mut bouncer = Bouncer {
        bearing: [omega * omega, omega * ratio(58.0, 100.0)],
        contact: [k.over(mass), c.over(mass)],
        gap: ratio(5.0, 1000.0),
        amplitude: ratio(3924.0, 1000.0),
        drive: omega,
        mass,
        touching: false,
        rigid: rigid.then_some(restitution),
        state: [Wide::default(), Wide::default(), Wide::default(), Wide::from(1.0)],
        t: Wide::default(),
        peak: 0.0,
    };
    let mut places = Vec::new();
    let mut next = 0;
    while next <= super::super::answer::INTERVALS {
        bouncer.stretch(&mut |from, until, x| {
            while next <= super::super::answer::INTERVALS && instants.at(next) < until {
                let tau = Wide::from(instants.at(next)) - from;
                places.push([horner(x, tau).value(), 0.0, 0.0, 0.0]);
                next += 1;
            }
        });
    }
    Answer { places, bodies: 1, peak_force: bouncer.peak, ..Answer::default() }
}

fn horner(series: &Series, tau: Wide) -> Wide {
    series.iter().rev().fold(Wide::default(), |sum, term| sum * tau + *term)
}

impl Bouncer {
    /// Coefficients of x, ẋ, sin and cos.
    fn series(&self) -> [Series; 4] {
        let zero = Wide::default();
        let on = |v: Wide| if self.touching { v } else { zero };
        let stiffness = self.bearing[0] + on(self.contact[0]);
        let damping = self.bearing[1] + on(self.contact[1]);
        let push = on(self.contact[0]) * self.gap;
        let mut series = [[zero; TERMS]; 4];
        (0..4).for_each(|i| series[i][0] = self.state[i]);
        for n in 0..TERMS - 1 {
            let [x, v, s, c] = [0, 1, 2, 3].map(|i| series[i][n]);
            let mut rate = zero - stiffness * x - damping * v - self.amplitude * s;
            if n == 0 {
                rate = rate + push;
            }
            for (i, rate) in [v, rate, self.drive * c, zero - self.drive * s].into_iter().enumerate() {
                series[i][n + 1] = rate.over((n + 1) as f64);
            }
        }
        series
    }

    /// One stretch, to its end or to where it meets or leaves the wall; `seen` is given its start, its end and x.
    fn stretch(&mut self, seen: &mut dyn FnMut(Wide, f64, &Series)) {
        let series = self.series();
        let fastest = if self.touching { self.contact[0].hi.sqrt() } else { self.drive.hi };
        let length = REACH / fastest;
        let depth = |tau: Wide| horner(&series[0], tau) - self.gap;
        let outside = |tau: f64| (depth(Wide::from(tau)).hi > 0.0) != self.touching;
        let look = |i: usize| length * i as f64 / LOOKS as f64;
        // At the very start the gap is rounding.
        let crossing = (2..=LOOKS).find(|&i| outside(look(i)));
        let end = crossing.map_or(Wide::from(length), |i| root(&series, self.gap, look(i - 1), look(i)));
        if self.touching {
            self.peak = self.peak.max(self.largest_force(&series, end.hi));
        }
        seen(self.t, (self.t + end).value(), &series[0]);
        self.state = [0, 1, 2, 3].map(|i| horner(&series[i], end));
        self.t = self.t + end;
        match (crossing, self.rigid) {
            (Some(_), Some(restitution)) => {
                self.state[0] = self.gap;
                self.state[1] = Wide::default() - self.state[1] * Wide::from(restitution);
            }
            (Some(_), None) => self.touching = !self.touching,
            (None, _) => {}
        }
    }

    /// Largest force of one node within a stretch.
    fn largest_force(&self, series: &[Series; 4], until: f64) -> f64 {
        let [k, c] = self.contact.map(|v| v.hi * self.mass);
        let force = |tau: f64| {
            let at = |i: usize| horner(&series[i], Wide::from(tau));
            (k * (at(0) - self.gap).value() + c * at(1).value()).abs() / NODES
        };
        let looks: Vec<f64> = (0..=LOOKS).map(|i| until * i as f64 / LOOKS as f64).collect();
        let best = (0..=LOOKS).max_by(|&a, &b| force(looks[a]).total_cmp(&force(looks[b]))).unwrap_or(0);
        let (mut a, mut b) = (looks[best.saturating_sub(1)], looks[(best + 1).min(LOOKS)]);
        for _ in 0..60 {
            let third = (b - a) / 3.0;
            if force(a + third) < force(b - third) { a += third } else { b -= third }
        }
        force(a).max(force(looks[best]))
    }
}

/// The root of the gap between two looks: bisection to 16 digits, then Newton's steps to 32.
fn root(series: &[Series; 4], gap: Wide, mut a: f64, mut b: f64) -> Wide {
    let depth = |tau: Wide| horner(&series[0], tau) - gap;
    let sign = depth(Wide::from(b)).hi > 0.0;
    for _ in 0..60 {
        let middle = f64::midpoint(a, b);
        if (depth(Wide::from(middle)).hi > 0.0) == sign { b = middle } else { a = middle }
    }
    let mut tau = Wide::from(f64::midpoint(a, b));
    for _ in 0..3 {
        let speed = horner(&series[1], tau).hi;
        tau = tau - depth(tau).over(speed);
    }
    tau
}
