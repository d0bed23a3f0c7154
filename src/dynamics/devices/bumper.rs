//! A bumper or shock absorber: a plane fixed to the second body, with a law of straight lines in the penetration of the first
//! point, and a dashpot. The first axis of its link is the plane's normal n, from the plane to the first point.
//!
//! `δ = −(X_P − X_S)·n − gap`, `F = max(0, F_s(δ) + c δ̇)`. Off, its rubber relaxes against the dashpot: the spring's energy is
//! dissipated.

use glam::DVec3;

use crate::dynamics::connection::{
    Activity, Connection, Device, DeviceReadings, Phase, Separation, SeparationBounds, Switch,
};
use crate::language::Text;

/// A bumper.
#[derive(Clone, Debug, PartialEq)]
pub struct Bumper {
    /// Distance from the plane at which the force begins \[m\].
    gap: f64,
    /// Penetrations δ \[m\] and forces \[N\] from (0, 0) on; beyond the last point the last slope.
    table: Vec<[f64; 2]>,
    /// c \[N·s/m\].
    damping: f64,
}

const OPEN: u32 = 0;
/// On the first line of the table it springs back without force.
const OFF: u32 = 1;
/// On the first line of the table the force acts.
const ON: u32 = 2;
/// Laws of a line; those of the next line are so much further.
const BRANCHES_PER_LINE: u32 = 2;

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

    fn is_off(phase: &Phase) -> bool {
        phase.branch % BRANCHES_PER_LINE == OFF
    }

    /// Whether the force acts.
    fn is_on(phase: &Phase) -> bool {
        phase.branch != OPEN && !Self::is_off(phase)
    }

    /// The line of the table that a phase is on; the first one while open.
    fn line(phase: &Phase) -> usize {
        (phase.branch.saturating_sub(OFF) / BRANCHES_PER_LINE) as usize
    }

    /// A law of the first line, on another line.
    fn on_line(first: u32, line: usize) -> Phase {
        let beyond = BRANCHES_PER_LINE.saturating_mul(u32::try_from(line).unwrap_or(u32::MAX));
        Phase { branch: first.saturating_add(beyond), ..Phase::default() }
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
}

impl Connection for Bumper {
    type State = Phase;
    type Motion = Separation;

    fn force(&self, phase: &Phase, motion: &Separation) -> DVec3 {
        if !Self::is_on(phase) {
            return DVec3::ZERO;
        }
        let [depth, rate] = self.depth(motion);
        DVec3::X * (self.spring(Self::line(phase), depth) + self.damping * rate)
    }

    fn stored_energy(&self, phase: &Phase, motion: &Separation) -> f64 {
        let [depth, _] = self.depth(motion);
        if phase.branch == OPEN { 0.0 } else { self.energy(Self::line(phase), depth) }
    }

    fn dissipated_power(&self, phase: &Phase, motion: &Separation) -> f64 {
        let [depth, rate] = self.depth(motion);
        match phase.branch {
            OPEN => 0.0,
            _ if Self::is_off(phase) => -self.spring(Self::line(phase), depth) * rate,
            _ => self.damping * rate * rate,
        }
    }

    fn stiffness_bound(&self, _: &Phase) -> f64 {
        (0..self.lines()).map(|line| self.slope(line)).fold(0.0, f64::max)
    }

    fn damping_bound(&self, phase: &Phase) -> f64 {
        if Self::is_on(phase) { self.damping } else { 0.0 }
    }
}

impl Device for Bumper {
    fn initial(&self, motion: &Separation) -> Phase {
        let [depth, _] = self.depth(motion);
        if depth > 0.0 { Self::on_line(ON, self.line_at(depth)) } else { Phase { branch: OPEN, ..Phase::default() } }
    }

    fn activity(&self, phase: &Phase) -> Activity {
        Activity::of(phase.branch != OPEN)
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

    /// 0: δ falls below the start of the line, on the first line an opening; 1: δ exceeds the end of the line; 2: the force falls to 0, or
    /// rises above 0 while it does not act.
    fn switch(&self, number: usize, phase: &Phase, motion: &Separation) -> f64 {
        let [depth, rate] = self.depth(motion);
        let line = Self::line(phase);
        let force = (self.spring(line, depth) + self.damping * rate) / self.slope(0);
        match number {
            0 => self.table[line][0] - depth,
            1 if line + 1 < self.lines() => depth - self.table[line + 1][0],
            2 if Self::is_off(phase) => force,
            // Without a dashpot the force vanishes at the opening.
            2 if self.damping > 0.0 => -force,
            _ => -1.0,
        }
    }

    fn next(&self, event: Switch, phase: &Phase, _: &Separation) -> (Phase, f64) {
        let line = Self::line(phase);
        let [same, other] = if Self::is_off(phase) { [OFF, ON] } else { [ON, OFF] };
        let next = match event {
            Switch::Closing => Self::on_line(ON, 0),
            Switch::Function(0) if line > 0 => Self::on_line(same, line - 1),
            Switch::Function(0) => Phase { branch: OPEN, ..Phase::default() },
            Switch::Function(1) => Self::on_line(same, line + 1),
            Switch::Function(_) => Self::on_line(other, line),
        };
        (next, 0.0)
    }
}

impl DeviceReadings for Bumper {
    fn state(&self, phase: &Phase) -> Text {
        match phase.branch {
            OPEN => Text::new("state-open"),
            _ if Self::is_off(phase) => Text::new("state-springs-back"),
            _ => Text::new("state-squeezed"),
        }
    }

    fn distance_left(&self, phase: &Phase, motion: &Separation) -> f64 {
        self.gap(phase, motion)[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn springing_back_it_loses_on_each_line_what_the_rubber_gives_up() {
        let bumper = Bumper::new(0.0, &[[0.002, 3.0], [0.005, 12.0], [0.008, 30.0]], 30.0).expect("rising");
        let at = |depth: f64, rate: f64| Separation {
            moved: -DVec3::X * depth,
            rate: -DVec3::X * rate,
            ..Separation::default()
        };
        // Thrown out faster than the rubber follows.
        let (mut phase, rate) = (Bumper::on_line(ON, 2), -0.5);
        phase = bumper.next(Switch::Function(2), &phase, &at(0.0065, rate)).0;
        for (line, depth) in [(2, 0.006), (1, 0.004), (0, 0.001)] {
            assert_eq!((Bumper::is_off(&phase), Bumper::line(&phase)), (true, line), "at {depth} m");
            assert_eq!(bumper.force(&phase, &at(depth, rate)), DVec3::ZERO);
            let stored = |t: f64| bumper.stored_energy(&phase, &at(depth + rate * t, rate));
            let (gained, lost) =
                ((stored(1e-6) - stored(-1e-6)) / 2e-6, bumper.dissipated_power(&phase, &at(depth, rate)));
            assert!((gained + lost).abs() < 1e-8 * lost, "{gained} W stored, {lost} W lost");
            let passed = at(bumper.table[line][0] - 1e-12, rate);
            assert!(bumper.switch(0, &phase, &passed) > 0.0, "the line's beginning is an event");
            let (next, released) = bumper.next(Switch::Function(0), &phase, &passed);
            assert!((bumper.stored_energy(&next, &passed) - stored(0.0)).is_sign_negative() && released == 0.0);
            phase = next;
        }
        assert_eq!(phase.branch, OPEN);
    }

    /// Two straight lines, of 1500 and 3000 N/m, behind 10 mm.
    fn bumper(damping: f64) -> Bumper {
        Bumper::new(0.01, &[[0.002, 3.0], [0.005, 12.0]], damping).expect("rising")
    }

    /// Pressed in by `depth` at a rate.
    fn pressed(depth: f64, rate: f64) -> Separation {
        let (placed, moved) = (DVec3::X * 0.02, DVec3::X * (-0.03 - depth));
        Separation { placed, moved, rate: -DVec3::X * rate }
    }

    #[test]
    fn its_force_is_the_table_and_the_dashpot_and_its_energy_the_area_under_the_table() {
        let bumper = bumper(30.0);
        // The last line goes on beyond the table.
        for (line, depth, force, energy) in
            [(0, 0.001, 1.5, 0.75e-3), (1, 0.004, 9.0, 3e-3 + 12e-3), (1, 0.006, 15.0, 3e-3 + 36e-3)]
        {
            let (phase, motion) = (Bumper::on_line(ON, line), pressed(depth, 0.1));
            assert_eq!(bumper.initial(&motion), phase, "at {depth} m");
            let [got, stored] = [bumper.force(&phase, &motion).x - 3.0, bumper.stored_energy(&phase, &motion)];
            assert!((got - force).abs() < 1e-12, "{got} N of the rubber at {depth} m, beside 3 N of the dashpot");
            assert!((stored - energy).abs() < 1e-15, "{stored} J at {depth} m");
            assert!((bumper.dissipated_power(&phase, &motion) - 0.3).abs() < 1e-15, "c v² W");
        }
        assert_eq!(bumper.initial(&pressed(-1e-6, 1.0)).branch, OPEN);
    }

    #[test]
    fn it_lets_go_where_dashpot_and_rubber_are_equal_and_takes_hold_there_again() {
        let bumper = bumper(30.0);
        // 9 N at 4 mm against 30 N s/m.
        let (on, off) = (Bumper::on_line(ON, 1), Bumper::on_line(OFF, 1));
        for (rate, lets_go) in [(-0.29, false), (-0.31, true)] {
            assert_eq!(bumper.switch(2, &on, &pressed(0.004, rate)) > 0.0, lets_go, "{rate} m/s");
            assert_eq!(bumper.switch(2, &off, &pressed(0.004, rate)) < 0.0, lets_go, "{rate} m/s");
        }
        let balance = pressed(0.004, -0.3);
        assert!(bumper.force(&on, &balance).length() < 1e-12, "without a step in its force");
        assert_eq!(bumper.next(Switch::Function(2), &on, &balance), (off, 0.0));
        assert_eq!(bumper.next(Switch::Function(2), &off, &balance), (on, 0.0));
        assert_eq!(bumper.force(&off, &balance), DVec3::ZERO);
        let rubber = self::bumper(0.0);
        assert!(rubber.switch(2, &on, &pressed(0.004, -9.0)) < 0.0, "rubber alone does not let go before it is open");
    }

    #[test]
    fn it_goes_from_line_to_line_of_its_table_both_ways() {
        let bumper = bumper(30.0);
        let (first, second) = (Bumper::on_line(ON, 0), Bumper::on_line(ON, 1));
        assert_eq!(bumper.next(Switch::Closing, &Phase::default(), &pressed(0.0, 0.1)).0, first);
        assert!(bumper.switch(1, &first, &pressed(0.0019, 0.1)) < 0.0);
        assert!(bumper.switch(1, &first, &pressed(0.0021, 0.1)) > 0.0);
        assert_eq!(bumper.next(Switch::Function(1), &first, &pressed(0.002, 0.1)).0, second);
        assert!(bumper.switch(1, &second, &pressed(9.0, 0.1)) < 0.0, "the last line has no end");
        assert!(bumper.switch(0, &second, &pressed(0.0021, -0.1)) < 0.0);
        assert!(bumper.switch(0, &second, &pressed(0.0019, -0.1)) > 0.0);
        assert_eq!(bumper.next(Switch::Function(0), &second, &pressed(0.002, -0.1)).0, first);
        let opened = bumper.next(Switch::Function(0), &first, &pressed(0.0, -0.01)).0;
        assert_eq!((opened.branch, bumper.activity(&opened)), (OPEN, Activity::Idle));
        let [gap, rate] = bumper.gap(&opened, &pressed(-0.004, -0.01));
        assert!((gap - 0.004).abs() < 1e-15 && rate == 0.01, "{gap} m apart, opening at {rate} m/s");
    }

    #[test]
    fn a_table_that_does_not_rise_is_none() {
        for table in [&[][..], &[[0.0, 1.0]], &[[0.1, 0.0]], &[[0.1, 2.0], [0.2, 2.0]], &[[0.1, 2.0], [0.1, 3.0]]] {
            assert_eq!(Bumper::new(0.0, table, 1.0), None, "{table:?}");
        }
        let line = &[[0.1, 2.0]];
        assert_eq!([Bumper::new(0.0, line, -1.0), Bumper::new(f64::NAN, line, 1.0)], [None, None]);
    }
}
