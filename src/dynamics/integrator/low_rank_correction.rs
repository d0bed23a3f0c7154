//! What turns within an implicit step faster than its one Jacobian can follow: forces of sliding in two directions.
//!
//! A slider is a place where a force of two components acts on the system and where a velocity of two components shows.
//! Its channels tell, at every stage, how the force answers to that velocity: at once (friction against a velocity that
//! turns), or by way of a component that follows (a slip angle). Newton's equations of the stages are the frozen Jacobian's
//! and a correction of as many ranks as there are channels and stages; the Sherman–Morrison–Woodbury formula solves
//! both together, so neither has to be slow against the other.

use glam::DVec2;
use num_complex::Complex64;

use crate::dynamics::integrator::dense_lu;
use crate::dynamics::integrator::dense_lu::Lu;
use crate::dynamics::integrator::newton_matrix::{Jacobian, NewtonMatrix, StageSystems};
use crate::dynamics::integrator::radau_tableaus::RadauTableau;
use crate::dynamics::integrator::system::{ImplicitSystem, RankOneTerm};

/// Most stages of a method.
const RADAU_STAGES: usize = 7;

/// Sliders of a system with their responses, and the channels of all stages. A slider's force acts on speeds, and its
/// velocity shows in them: of the state, all here concerns the unknowns of [`Jacobian`] alone.
#[derive(Debug, Default)]
pub(in crate::dynamics) struct LowRankCorrection {
    sliders: usize,
    size: usize,
    /// Whether what follows is solved together with the rest: where it turns slowly against it, each by itself will do.
    together: bool,
    /// Rates of the speeds per unit of force, column by column, two a slider.
    push: Vec<f64>,
    /// Velocities per unit of the speeds, row by row, two a slider.
    view: Vec<f64>,
    /// Responses of the method's systems to the columns of `push`.
    real: Vec<f64>,
    complex: [Vec<Complex64>; 3],
    /// Velocities at each stage per unit of force at another: `[stage][stage][row][column]`.
    between: Vec<f64>,
    /// Velocities per unit of force in the real system and as rates: `[row][column]`.
    within: Vec<f64>,
    at_once: Vec<f64>,
    channels: [Vec<RankOneTerm>; RADAU_STAGES],
    /// Channels that do anything, and the same stage after stage, as `(stage, which of them, channel)`.
    live: Vec<usize>,
    unknowns: Vec<(usize, usize, RankOneTerm)>,
    lu: Lu<f64>,
    right: Vec<f64>,
    found: Vec<f64>,
    /// Velocities in the method's systems.
    seen: Vec<f64>,
    seen_complex: [Vec<Complex64>; 3],
}

impl LowRankCorrection {
    /// Looks at the sliders of a system of `n` leading components whose state is `y`.
    pub(in crate::dynamics) fn gather(&mut self, system: &impl ImplicitSystem, linear: &Jacobian, y: &[f64], n: usize) {
        (self.sliders, self.size) = (system.port_count(), linear.size());
        self.push.clear();
        self.view.clear();
        let (mut push, mut view) = (vec![0.0; 2 * n], vec![0.0; 2 * n]);
        for slider in 0..self.sliders {
            push.fill(0.0);
            view.fill(0.0);
            system.port(slider, y, &mut push, &mut view);
            for column in 0..2 {
                self.push.extend(linear.gather(&push[column * n..]));
                self.view.extend(linear.gather(&view[column * n..]));
            }
        }
        product(&self.view, &self.push, self.size, &mut self.at_once);
    }

    /// Whether the sliders are solved together with the rest: always those that answer at once.
    pub(in crate::dynamics) fn together(&mut self, system: &impl ImplicitSystem) -> bool {
        self.together |= system.auxiliary_count() < system.port_count();
        self.together
    }

    /// From now on solves together what was solved apart; whether that is news.
    pub(in crate::dynamics) fn unite(&mut self, system: &impl ImplicitSystem) -> bool {
        system.port_count() > 0 && !std::mem::replace(&mut self.together, true)
    }

    /// Begins anew with another system.
    pub(in crate::dynamics) fn forget(&mut self) {
        (self.sliders, self.together) = (0, false);
        self.channels.iter_mut().for_each(Vec::clear);
    }

    /// Responses of the factored systems to forces on the sliders.
    pub(in crate::dynamics) fn factor(&mut self, table: &RadauTableau, systems: &StageSystems) {
        let (real, complex) = (&systems.real, &systems.complex[..table.complex.len()]);
        let (n, columns, stages) = (self.size, 2 * self.sliders, table.stages());
        if columns == 0 || !self.together {
            return;
        }
        self.real.resize(columns * n, 0.0);
        for (push, found) in self.push.chunks_exact(n).zip(self.real.chunks_exact_mut(n)) {
            real.respond(push, found);
        }
        product(&self.view, &self.real, n, &mut self.within);
        let mut right = vec![Complex64::ZERO; n];
        self.between.clear();
        self.between.resize(stages * stages * columns * columns, 0.0);
        for (responses, system) in self.complex.iter_mut().zip(complex) {
            responses.resize(columns * n, Complex64::ZERO);
            for (push, found) in self.push.chunks_exact(n).zip(responses.chunks_exact_mut(n)) {
                right.iter_mut().zip(push).for_each(|(r, p)| *r = Complex64::new(*p, 0.0));
                system.respond(&right, found);
            }
        }
        for (kernel, responses) in self.seen_complex.iter_mut().zip(&self.complex[..complex.len()]) {
            product(&self.view, responses, n, kernel);
        }
        for (kl, out) in self.between.chunks_exact_mut(columns * columns).enumerate() {
            let (k, l) = (kl / stages, kl % stages);
            let weight = table.real_right[k] * table.real_left[l];
            out.iter_mut().zip(&self.within).for_each(|(o, r)| *o += weight * r);
            for (m, kernel) in self.seen_complex[..complex.len()].iter().enumerate() {
                let (a, b) = (table.complex_right[m][k], table.complex_left[m][l]);
                let (re, im) = (2.0 * (a.0 * b.0 - a.1 * b.1), -2.0 * (a.0 * b.1 + a.1 * b.0));
                out.iter_mut().zip(kernel).for_each(|(o, z)| *o += re * z.re + im * z.im);
            }
        }
    }

    /// Takes the channels of a stage as the system has them where its slope was last asked for.
    pub(in crate::dynamics) fn record(&mut self, stage: usize, channels: &[RankOneTerm]) {
        self.channels[stage].clear();
        self.channels[stage].extend_from_slice(channels);
    }

    /// Completes a Newton correction of the stages: the systems have found what the frozen Jacobian alone gives; `follow`
    /// holds what is left of the equations of the components that follow, stage by stage, and then their corrections.
    /// `rate(stage, follower)` is theirs.
    pub(in crate::dynamics) fn complete(
        &mut self,
        table: &RadauTableau,
        systems: &mut StageSystems,
        follow: &mut [f64],
        h: f64,
        rate: impl Fn(usize, usize) -> f64,
    ) -> bool {
        let stages = table.stages();
        let width = follow.len() / stages;
        self.live.clear();
        let channels = &self.channels[..stages];
        let lives = |c: &usize| channels.iter().any(|stage| stage[*c].input != DVec2::ZERO);
        self.live.extend((0..channels[0].len()).filter(|c| channels[0][*c].auxiliary.is_some() || lives(c)));
        let (count, columns) = (self.live.len(), 2 * self.sliders);
        if !self.together {
            return (0..width).all(|follower| Self::alone(table, follow, follower, h, &rate));
        }
        if count == 0 {
            return true;
        }
        self.unknowns.clear();
        for (k, stage) in channels.iter().enumerate() {
            self.unknowns.extend(self.live.iter().enumerate().map(|(c, &number)| (k, c, stage[number])));
        }
        let (between, unknowns) = (&self.between, &self.unknowns);
        let done = self.lu.factor(stages * count, |i, j| {
            let ((k, which, ref to), (l, other, ref from)) = (unknowns[i], unknowns[j]);
            let own = if which != other {
                0.0
            } else if let Some(follower) = to.auxiliary {
                table.inverse[k][l] / h - if k == l { rate(k, follower) } else { 0.0 }
            } else {
                f64::from(u8::from(k == l))
            };
            own - through(&between[(k * stages + l) * columns * columns..], columns, to, from)
        });
        if !done {
            return false;
        }
        product(&self.view, &systems.real.found, self.size, &mut self.seen);
        for (seen, system) in self.seen_complex.iter_mut().zip(&systems.complex[..table.complex.len()]) {
            product(&self.view, &system.found, self.size, seen);
        }
        self.right.clear();
        for &(k, _, to) in &self.unknowns {
            let left = to.auxiliary.map_or(0.0, |follower| follow[k * width + follower]);
            let velocity = |row: usize| {
                let turning = self.seen_complex.iter().zip(table.complex_right);
                turning.fold(table.real_right[k] * self.seen[row], |sum, (seen, right)| {
                    sum + 2.0 * (right[k].0 * seen[row].re - right[k].1 * seen[row].im)
                })
            };
            self.right.push(left + to.output.x * velocity(2 * to.port) + to.output.y * velocity(2 * to.port + 1));
        }
        self.found.resize(stages * count, 0.0);
        self.lu.solve(&self.right, &mut self.found);
        for ((k, _, channel), found) in self.unknowns.iter().zip(&self.found) {
            if let Some(follower) = channel.auxiliary {
                follow[k * width + follower] = *found;
            }
        }
        self.respond(table, systems);
        true
    }

    /// A component that follows by itself, all of its stages at once.
    fn alone(
        table: &RadauTableau,
        follow: &mut [f64],
        follower: usize,
        h: f64,
        rate: impl Fn(usize, usize) -> f64,
    ) -> bool {
        let stages = table.stages();
        let width = follow.len() / stages;
        let mut rows = [[0.0; RADAU_STAGES + 1]; RADAU_STAGES];
        for (k, row) in rows[..stages].iter_mut().enumerate() {
            row.iter_mut().zip(table.inverse[k]).for_each(|(entry, a)| *entry = a / h);
            row[k] -= rate(k, follower);
            row[stages] = follow[k * width + follower];
        }
        let found = dense_lu::eliminate(&mut rows[..stages]);
        (0..stages).for_each(|k| follow[k * width + follower] = rows[k][stages]);
        found
    }

    /// Adds the response to the forces that the channels just found carry at all stages.
    fn respond(&self, table: &RadauTableau, StageSystems { real, complex, .. }: &mut StageSystems) {
        let (n, count) = (self.size, self.live.len());
        for column in 0..2 * self.sliders {
            let mut forces = [0.0; RADAU_STAGES];
            for (k, force) in forces[..table.stages()].iter_mut().enumerate() {
                for (c, &number) in self.live.iter().enumerate() {
                    let channel = &self.channels[k][number];
                    if channel.port == column / 2 {
                        *force += channel.input[column % 2] * self.found[k * count + c];
                    }
                }
            }
            let range = column * n..(column + 1) * n;
            let sum = table.real_left.iter().zip(&forces).map(|(left, force)| left * force).sum::<f64>();
            real.found.iter_mut().zip(&self.real[range.clone()]).for_each(|(d, r)| *d += sum * r);
            for ((system, responses), left) in complex.iter_mut().zip(&self.complex).zip(table.complex_left) {
                let sum: Complex64 = left.iter().zip(&forces).map(|(&(a, b), f)| Complex64::new(a, b) * *f).sum();
                system.found.iter_mut().zip(&responses[range.clone()]).for_each(|(d, r)| *d += sum * r);
            }
        }
    }

    /// The same for the error's filter, with the channels of the first stage: the real system has found what it alone
    /// gives, and `follow` holds what drives the components that follow, and then what they come to.
    pub(in crate::dynamics) fn filter(
        &mut self,
        shift: f64,
        real: &mut NewtonMatrix<f64>,
        follow: &mut [f64],
        rate: impl Fn(usize) -> f64,
    ) -> bool {
        let (n, columns, count) = (self.size, 2 * self.sliders, self.channels[0].len());
        if !self.together {
            follow.iter_mut().enumerate().for_each(|(follower, f)| *f /= shift - rate(follower));
            return true;
        }
        if count == 0 {
            return true;
        }
        let (channels, within) = (&self.channels[0], &self.within);
        let own = |c: &RankOneTerm| c.auxiliary.map_or(1.0, |follower| shift - rate(follower));
        let done = self.lu.factor(count, |i, j| {
            let (to, from) = (&channels[i], &channels[j]);
            (if i == j { own(to) } else { 0.0 }) - through(within, columns, to, from)
        });
        if !done {
            return false;
        }
        product(&self.view, &real.found, n, &mut self.seen);
        self.right.clear();
        for to in channels {
            let left = to.auxiliary.map_or(0.0, |follower| follow[follower]);
            self.right.push(left + to.output.dot(DVec2::from_slice(&self.seen[2 * to.port..])));
        }
        self.found.resize(count, 0.0);
        self.lu.solve(&self.right, &mut self.found[..count]);
        for (channel, carried) in channels.iter().zip(&self.found) {
            for (axis, force) in (channel.input * *carried).to_array().into_iter().enumerate() {
                let column = &self.real[(2 * channel.port + axis) * n..][..n];
                real.found.iter_mut().zip(column).for_each(|(d, r)| *d += force * r);
            }
            if let Some(follower) = channel.auxiliary {
                follow[follower] = *carried;
            }
        }
        true
    }

    /// The fastest rate at which a channel of the first stage answers at once \[1/s\].
    pub(in crate::dynamics) fn fastest(&self) -> f64 {
        let columns = 2 * self.sliders;
        let at_once = self.channels[0].iter().filter(|c| c.auxiliary.is_none());
        at_once.map(|c| through(&self.at_once, columns, c, c).abs()).fold(0.0, f64::max)
    }
}

/// What a unit in the channel `from` adds to the channel `to`, by velocities per unit of force.
fn through(velocities: &[f64], columns: usize, to: &RankOneTerm, from: &RankOneTerm) -> f64 {
    let entry = |row: usize, column: usize| velocities[(2 * to.port + row) * columns + 2 * from.port + column];
    let row = |row: usize| entry(row, 0) * from.input.x + entry(row, 1) * from.input.y;
    to.output.x * row(0) + to.output.y * row(1)
}

/// Rows times columns, each `n` long.
fn product<T>(rows: &[f64], columns: &[T], n: usize, out: &mut Vec<T>)
where
    T: Copy + std::ops::Mul<f64, Output = T> + std::iter::Sum,
{
    out.clear();
    let columns = || columns.chunks_exact(n.max(1));
    for row in rows.chunks_exact(n.max(1)) {
        out.extend(columns().map(|column| column.iter().zip(row).map(|(c, r)| *c * *r).sum::<T>()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::integrator::radau_iia::Radau;
    use crate::dynamics::integrator::system::System;

    /// Far below the velocity by which a Jacobian is differenced.
    const LEAST: f64 = 1e-10;

    /// A unit mass that a force of 0.9, turning once in 2π, pushes against friction of 1: it creeps at 0.9 of the least
    /// speed, along the force.
    struct Creep {
        channels: Vec<RankOneTerm>,
        held: Option<DVec2>,
    }

    impl System for Creep {
        fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
            let v = DVec2::new(y[0], y[1]);
            let against = self.held.unwrap_or(v / v.length().max(LEAST));
            let force = DVec2::new(t.cos(), t.sin()) * 0.9 - against;
            out.copy_from_slice(&force.to_array());
            let (along, speed) = (v.try_normalize().unwrap_or(DVec2::X), v.length());
            let channel = |direction: DVec2, slope: f64| RankOneTerm {
                port: 0,
                input: direction * slope,
                output: direction,
                auxiliary: None,
            };
            let slowing = if speed < LEAST { -1.0 / LEAST } else { 0.0 };
            self.channels = vec![channel(along.perp(), -1.0 / speed.max(LEAST)), channel(along, slowing)];
        }

        fn size2(&self, d: &[f64]) -> f64 {
            d.iter().map(|x| (x / (1e-6 * LEAST)).powi(2)).sum()
        }
    }

    impl ImplicitSystem for Creep {
        fn port_count(&self) -> usize {
            1
        }

        fn rank_one_terms(&self) -> &[RankOneTerm] {
            &self.channels
        }

        fn freeze(&mut self, held: bool) {
            self.held = held.then_some(DVec2::X * 0.9);
        }

        fn port(&self, _: usize, _: &[f64], push: &mut [f64], view: &mut [f64]) {
            push.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
            view.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
        }
    }

    #[test]
    fn creeping_friction_is_stepped_over_in_a_billion_of_its_time_constants() {
        let mut system = Creep { channels: Vec::new(), held: None };
        let (mut radau, mut y, mut slope) = (Radau::default(), vec![0.9 * LEAST, 0.0], vec![0.0; 2]);
        radau.resize(2);
        for i in 0..10 {
            let (t, h) = (0.1 * f64::from(i), 0.1);
            system.slope(t, &y, &mut slope);
            let error = radau.attempt(&mut system, t, &y, &slope, h);
            assert!(error.is_finite(), "Newton's method ends at {t}");
            radau.accept(t, &mut y, h);
            let wanted = DVec2::new((t + h).cos(), (t + h).sin()) * (0.9 * LEAST);
            assert!((DVec2::new(y[0], y[1]) - wanted).length() < 1e-6 * LEAST, "{y:?} is not {wanted} at {t}");
        }
    }
}
