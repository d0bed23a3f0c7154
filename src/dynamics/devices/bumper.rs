//! A bumper or shock absorber: a plane fixed to the second body, with a law of straight lines in the penetration of the first
//! point, and a dashpot. The first axis of its link is the plane's normal n, from the plane to the first point.
//!
//! `δ = −(X_P − X_S)·n − gap`, `F = max(0, F_s(δ) + c δ̇)`. Off, its rubber relaxes against the dashpot: the spring's energy is
//! dissipated.

use glam::DVec3;

use crate::dynamics::connection::{Connection, Device, Phase, Separation, SeparationBounds, Switch};

/// A bumper.
#[derive(Clone, Debug, PartialEq)]
pub struct Bumper {
    /// Distance from the plane at which the force begins \[m\].
    gap: f64,
    /// Penetrations δ \[m\] and forces \[N\] from (0, 0) on; the slope of the last line goes on.
    table: Vec<[f64; 2]>,
    /// c \[N·s/m\].
    damping: f64,
}

const OPEN: u32 = 0;
const OFF: u32 = 1;
/// The force acts on the first line of the table; the lines that follow have the numbers that follow.
const ON: u32 = 2;

impl Bumper {
    /// Of a gap \[m\], rising penetrations \[m\] with rising forces \[N\] beyond (0, 0), and a dashpot \[N·s/m\]; `None` where
    /// they are not so.
    pub fn new(gap: f64, table: &[[f64; 2]], damping: f64) -> Option<Self> {
        let table: Vec<[f64; 2]> = std::iter::once([0.0; 2]).chain(table.iter().copied()).collect();
        let rises = table.windows(2).all(|two| two[1][0] > two[0][0] && two[1][1] > two[0][1]);
        (rises && table.len() > 1 && damping >= 0.0 && gap.is_finite()).then_some(Self { gap, table, damping })
    }

    /// δ and δ̇.
    fn depth(&self, motion: &Separation) -> [f64; 2] {
        [-motion.vector().x - self.gap, -motion.rate.x]
    }

    fn lines(&self) -> usize {
        self.table.len() - 1
    }

    fn slope(&self, line: usize) -> f64 {
        let [from, to] = [self.table[line], self.table[line + 1]];
        (to[1] - from[1]) / (to[0] - from[0])
    }

    /// The line of the table at δ.
    fn line_at(&self, depth: f64) -> usize {
        self.table[1..self.lines()].partition_point(|point| point[0] <= depth)
    }

    fn line(&self, phase: &Phase, depth: f64) -> usize {
        if phase.law >= ON { (phase.law - ON) as usize } else { self.line_at(depth) }
    }

    /// `F_s(δ)` on a line.
    fn spring(&self, line: usize, depth: f64) -> f64 {
        let [from, force] = self.table[line];
        force + self.slope(line) * (depth - from)
    }

    /// `∫F_s dδ`.
    fn energy(&self, line: usize, depth: f64) -> f64 {
        let whole = |two: &[[f64; 2]]| 0.5 * (two[0][1] + two[1][1]) * (two[1][0] - two[0][0]);
        let before: f64 = self.table[..=line].windows(2).map(whole).sum();
        let [from, force] = self.table[line];
        before + 0.5 * (force + self.spring(line, depth)) * (depth - from)
    }

    fn on(line: usize) -> Phase {
        Phase { law: ON + u32::try_from(line).unwrap_or(u32::MAX - ON), ..Phase::default() }
    }
}

impl Connection for Bumper {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        if phase.law < ON {
            return DVec3::ZERO;
        }
        let [depth, rate] = self.depth(motion);
        DVec3::X * (self.spring(self.line(phase, depth), depth) + self.damping * rate)
    }

    fn stored_energy(&self, phase: &Phase, motion: &Separation) -> f64 {
        let [depth, _] = self.depth(motion);
        if phase.law == OPEN { 0.0 } else { self.energy(self.line(phase, depth), depth) }
    }

    fn dissipated_power(&self, phase: &Phase, motion: &Separation) -> f64 {
        let [depth, rate] = self.depth(motion);
        match phase.law {
            OPEN => 0.0,
            OFF => -self.spring(self.line_at(depth), depth) * rate,
            _ => self.damping * rate * rate,
        }
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        (0..self.lines()).map(|line| self.slope(line)).fold(0.0, f64::max)
    }

    fn damping_bound(&self, phase: &Phase) -> f64 {
        if phase.law < ON { 0.0 } else { self.damping }
    }
}

impl Device for Bumper {
    fn initial(&self, motion: &Separation) -> Phase {
        let [depth, _] = self.depth(motion);
        if depth > 0.0 { Self::on(self.line_at(depth)) } else { Phase { law: OPEN, ..Phase::default() } }
    }

    fn acts(&self, phase: &Phase) -> bool {
        phase.law != OPEN
    }

    fn state(&self, phase: &Phase) -> &'static str {
        match phase.law {
            OPEN => "open",
            OFF => "springs back",
            _ => "squeezed",
        }
    }

    fn gap(&self, _: &Phase, motion: &Separation) -> [f64; 2] {
        self.depth(motion).map(|x| -x)
    }

    fn gap_curvature(&self, _: &Phase, bounds: &SeparationBounds) -> f64 {
        bounds.acceleration
    }

    fn switches(&self, _: &Phase) -> usize {
        3
    }

    /// The line's beginning, where the first one opens; its end; the force vanishes. Off: opening; the force begins again.
    fn switch(&self, number: usize, phase: &Phase, motion: &Separation) -> f64 {
        let [depth, rate] = self.depth(motion);
        let line = self.line(phase, depth);
        let force = (self.spring(line, depth) + self.damping * rate) / self.slope(0);
        match (number, phase.law) {
            (0, OFF) => -depth,
            (0, _) => self.table[line][0] - depth,
            (1, OFF) => force,
            (1, _) if line + 1 < self.lines() => depth - self.table[line + 1][0],
            // Without a dashpot the force vanishes at the opening.
            (2, ON..) if self.damping > 0.0 => -force,
            _ => -1.0,
        }
    }

    fn next(&self, event: Switch, phase: &Phase, motion: &Separation) -> (Phase, f64) {
        let [depth, _] = self.depth(motion);
        let line = self.line(phase, depth);
        let next = match (event, phase.law) {
            (Switch::Closing, _) => Self::on(0),
            (Switch::Function(0), OFF) => Phase { law: OPEN, ..Phase::default() },
            (Switch::Function(_), OFF) => Self::on(self.line_at(depth)),
            (Switch::Function(0), _) if line > 0 => Self::on(line - 1),
            (Switch::Function(0), _) => Phase { law: OPEN, ..Phase::default() },
            (Switch::Function(1), _) => Self::on(line + 1),
            (Switch::Function(_), _) => Phase { law: OFF, ..Phase::default() },
        };
        (next, 0.0)
    }
}
