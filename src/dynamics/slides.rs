//! What turns within an implicit step faster than its one Jacobian can follow: forces of sliding in two directions.
//!
//! A slider is a place where a force of two components acts on the system and where a velocity of two components shows.
//! Its channels tell, at every stage, how the force answers to that velocity: at once (friction against a velocity that
//! turns), or by way of a component that follows (a slip angle). Newton's equations of the stages are the frozen Jacobian's
//! and a correction of as many ranks as there are channels and stages; the Sherman–Morrison–Woodbury formula solves
//! both together, so neither has to be slow against the other.

use glam::DVec2;
use num_complex::Complex64;

use super::dop853::System;
use super::lu::Lu;
use super::radau_coefficients::{COMPLEX_LEFT, COMPLEX_RIGHT, INVERSE, REAL, REAL_LEFT, REAL_RIGHT};

/// Stages of the method.
const STAGES: usize = 7;

/// One way in which a slider's force answers to its velocity.
#[derive(Clone, Copy, Debug)]
pub struct Channel {
    /// The slider's number.
    pub slider: usize,
    /// Change of the force per unit of what the channel carries.
    pub force: DVec2,
    /// What the channel carries, or the rate at which it changes, per unit of velocity.
    pub speed: DVec2,
    /// Number of the component that follows, if one carries it; else the velocity does so itself.
    pub follower: Option<usize>,
}

/// Sliders of a system with their responses, and the channels of all stages.
#[derive(Debug, Default)]
pub(super) struct Slides {
    sliders: usize,
    size: usize,
    /// Whether what follows is solved together with the rest: where it turns slowly against it, each by itself will do.
    together: bool,
    /// Rates of the state per unit of force, column by column, two a slider.
    push: Vec<f64>,
    /// Velocities per unit of the state, row by row, two a slider.
    view: Vec<f64>,
    /// Responses of the method's four systems to the columns of `push`.
    real: Vec<f64>,
    complex: [Vec<Complex64>; 3],
    /// Velocities at each stage per unit of force at another: `[stage][stage][row][column]`.
    between: Vec<f64>,
    /// Velocities per unit of force in the real system and as rates: `[row][column]`.
    within: Vec<f64>,
    at_once: Vec<f64>,
    channels: [Vec<Channel>; STAGES],
    /// Channels that do anything.
    live: Vec<usize>,
    lu: Lu<f64>,
    right: Vec<f64>,
    found: Vec<f64>,
}

impl Slides {
    /// Looks at the sliders of a system of `size` leading components whose state is `y`.
    pub(super) fn gather(&mut self, system: &impl System, y: &[f64], size: usize) {
        (self.sliders, self.size) = (system.sliders(), size);
        let length = 2 * self.sliders * size;
        self.push.clear();
        self.push.resize(length, 0.0);
        self.view.clear();
        self.view.resize(length, 0.0);
        for (slider, (push, view)) in
            self.push.chunks_exact_mut(2 * size).zip(self.view.chunks_exact_mut(2 * size)).enumerate()
        {
            system.slider(slider, y, push, view);
        }
        self.at_once = product(&self.view, &self.push, size);
    }

    /// Whether the sliders are solved together with the rest: always those that answer at once.
    pub(super) fn together(&mut self, system: &impl System) -> bool {
        self.together |= system.followers() < system.sliders();
        self.together
    }

    /// From now on solves together what was solved apart; whether that is news.
    pub(super) fn unite(&mut self, system: &impl System) -> bool {
        system.sliders() > 0 && !std::mem::replace(&mut self.together, true)
    }

    /// Begins anew with another system.
    pub(super) fn forget(&mut self) {
        (self.sliders, self.together) = (0, false);
        self.channels.iter_mut().for_each(Vec::clear);
    }

    /// Responses of the factored systems to forces on the sliders.
    pub(super) fn factor(&mut self, real: &Lu<f64>, complex: &[Lu<Complex64>; 3]) {
        let (n, columns) = (self.size, 2 * self.sliders);
        if columns == 0 || !self.together {
            return;
        }
        self.real.resize(columns * n, 0.0);
        for (push, found) in self.push.chunks_exact(n).zip(self.real.chunks_exact_mut(n)) {
            real.solve(push, found);
        }
        self.within = product(&self.view, &self.real, n);
        let mut right = vec![Complex64::ZERO; n];
        self.between.clear();
        self.between.resize(STAGES * STAGES * columns * columns, 0.0);
        for (responses, lu) in self.complex.iter_mut().zip(complex) {
            responses.resize(columns * n, Complex64::ZERO);
            for (push, found) in self.push.chunks_exact(n).zip(responses.chunks_exact_mut(n)) {
                right.iter_mut().zip(push).for_each(|(r, p)| *r = Complex64::new(*p, 0.0));
                lu.solve(&right, found);
            }
        }
        // Parts apart, so that whole rows are added at a time.
        let parts: [[Vec<f64>; 2]; 3] = std::array::from_fn(|m| {
            let kernel = product(&self.view, &self.complex[m], n);
            [kernel.iter().map(|z| 2.0 * z.re).collect(), kernel.iter().map(|z| -2.0 * z.im).collect()]
        });
        for (kl, out) in self.between.chunks_exact_mut(columns * columns).enumerate() {
            let (k, l) = (kl / STAGES, kl % STAGES);
            add(out, REAL_RIGHT[k] * REAL_LEFT[l], &self.within);
            for (m, [re, im]) in parts.iter().enumerate() {
                let (a, b) = (COMPLEX_RIGHT[m][k], COMPLEX_LEFT[m][l]);
                add(out, a.0 * b.0 - a.1 * b.1, re);
                add(out, a.0 * b.1 + a.1 * b.0, im);
            }
        }
    }

    /// Takes the channels of a stage as the system has them where its slope was last asked for.
    pub(super) fn record(&mut self, stage: usize, leading: usize, channels: &[Channel]) {
        self.size = leading;
        self.channels[stage].clear();
        self.channels[stage].extend_from_slice(channels);
    }

    /// Completes a Newton correction of the stages: `correction` holds, stage by stage, what the frozen Jacobian alone
    /// gives, and in the components that follow what is left of their own equations. `rate(stage, follower)` is theirs.
    pub(super) fn complete(
        &mut self,
        correction: &mut [f64],
        width: usize,
        h: f64,
        rate: impl Fn(usize, usize) -> f64,
    ) -> bool {
        let n = self.size;
        self.live.clear();
        let channels = &self.channels;
        let lives = |c: &usize| channels.iter().any(|stage| stage[*c].force != DVec2::ZERO);
        self.live.extend((0..self.channels[0].len()).filter(|c| self.channels[0][*c].follower.is_some() || lives(c)));
        let (count, columns) = (self.live.len(), 2 * self.sliders);
        if !self.together {
            return (0..count).all(|follower| self.alone(correction, width, follower, h, &rate));
        }
        if count == 0 {
            return true;
        }
        let live = &self.live;
        let channel = |i: usize| (i / count, &channels[i / count][live[i % count]]);
        let between = &self.between;
        let done = self.lu.factor(STAGES * count, |i, j| {
            let ((k, to), (l, from)) = (channel(i), channel(j));
            let own = if i % count != j % count {
                0.0
            } else if let Some(follower) = to.follower {
                INVERSE[k][l] / h - if k == l { rate(k, follower) } else { 0.0 }
            } else {
                f64::from(u8::from(k == l))
            };
            own - through(&between[(k * STAGES + l) * columns * columns..], columns, to, from)
        });
        if !done {
            return false;
        }
        self.right.clear();
        for i in 0..STAGES * count {
            let (k, to) = channel(i);
            let row = &correction[k * width..];
            let left = to.follower.map_or(0.0, |follower| row[n + follower]);
            self.right.push(left + to.speed.dot(seen(&self.view, n, to.slider, row)));
        }
        self.found.resize(STAGES * count, 0.0);
        self.lu.solve(&self.right, &mut self.found);
        for i in 0..STAGES * count {
            let (k, channel) = channel(i);
            if let Some(follower) = channel.follower {
                correction[k * width + n + follower] = self.found[i];
            }
        }
        self.respond(correction, width);
        true
    }

    /// A component that follows by itself, all of its stages at once.
    fn alone(
        &mut self,
        correction: &mut [f64],
        width: usize,
        follower: usize,
        h: f64,
        rate: impl Fn(usize, usize) -> f64,
    ) -> bool {
        let i = self.size + follower;
        let rate = |k: usize| rate(k, follower);
        if !self.lu.factor(STAGES, |k, l| INVERSE[k][l] / h - if k == l { rate(k) } else { 0.0 }) {
            return false;
        }
        let right: [f64; STAGES] = std::array::from_fn(|k| correction[k * width + i]);
        let mut found = [0.0; STAGES];
        self.lu.solve(&right, &mut found);
        found.iter().enumerate().for_each(|(k, d)| correction[k * width + i] = *d);
        true
    }

    /// Adds the response of all stages to the forces that the channels just found carry.
    fn respond(&self, correction: &mut [f64], width: usize) {
        let (n, count) = (self.size, self.live.len());
        for column in 0..2 * self.sliders {
            let mut forces = [0.0; STAGES];
            for (k, force) in forces.iter_mut().enumerate() {
                for (c, &number) in self.live.iter().enumerate() {
                    let channel = &self.channels[k][number];
                    if channel.slider == column / 2 {
                        *force += channel.force[column % 2] * self.found[k * count + c];
                    }
                }
            }
            let real = REAL_LEFT.iter().zip(&forces).map(|(left, force)| left * force).sum::<f64>();
            let complex: [Complex64; 3] = std::array::from_fn(|m| {
                COMPLEX_LEFT[m].iter().zip(&forces).map(|(&(a, b), force)| Complex64::new(a, b) * *force).sum()
            });
            let range = column * n..(column + 1) * n;
            for (k, row) in correction.chunks_exact_mut(width).enumerate() {
                let weight = REAL_RIGHT[k] * real;
                row.iter_mut().zip(&self.real[range.clone()]).for_each(|(d, r)| *d += weight * r);
                for m in 0..3 {
                    let (a, b) = COMPLEX_RIGHT[m][k];
                    let weight = 2.0 * Complex64::new(a, b) * complex[m];
                    row.iter_mut().zip(&self.complex[m][range.clone()]).for_each(|(d, r)| *d += (weight * r).re);
                }
            }
        }
    }

    /// The same for the error's filter, with the channels of the first stage: `found` holds what the real system alone
    /// gives, and in the components that follow what drives them.
    pub(super) fn filter(&mut self, found: &mut [f64], h: f64, rate: impl Fn(usize) -> f64) {
        let (n, columns, count) = (self.size, 2 * self.sliders, self.channels[0].len());
        if count == 0 {
            return;
        }
        if !self.together {
            return (0..count).for_each(|follower| found[n + follower] /= REAL / h - rate(follower));
        }
        let (channels, within) = (&self.channels[0], &self.within);
        let own = |c: &Channel| c.follower.map_or(1.0, |follower| REAL / h - rate(follower));
        let done = self.lu.factor(count, |i, j| {
            let (to, from) = (&channels[i], &channels[j]);
            (if i == j { own(to) } else { 0.0 }) - through(within, columns, to, from)
        });
        self.right.clear();
        for channel in channels {
            let left = channel.follower.map_or(0.0, |follower| found[n + follower]);
            self.right.push(left + channel.speed.dot(seen(&self.view, n, channel.slider, found)));
        }
        self.found.resize(count, 0.0);
        if !done {
            return found.fill(f64::NAN);
        }
        self.lu.solve(&self.right, &mut self.found);
        for (channel, carried) in channels.iter().zip(&self.found) {
            for (axis, force) in (channel.force * *carried).to_array().into_iter().enumerate() {
                let column = &self.real[(2 * channel.slider + axis) * n..][..n];
                found.iter_mut().zip(column).for_each(|(d, r)| *d += force * r);
            }
            if let Some(follower) = channel.follower {
                found[n + follower] = *carried;
            }
        }
    }

    /// The fastest rate at which a channel of the first stage answers at once \[1/s\].
    pub(super) fn fastest(&self) -> f64 {
        let columns = 2 * self.sliders;
        let at_once = self.channels[0].iter().filter(|c| c.follower.is_none());
        at_once.map(|c| through(&self.at_once, columns, c, c).abs()).fold(0.0, f64::max)
    }
}

fn add(out: &mut [f64], weight: f64, row: &[f64]) {
    out.iter_mut().zip(row).for_each(|(o, r)| *o += weight * r);
}

/// What a unit in the channel `from` adds to the channel `to`, by velocities per unit of force.
fn through(velocities: &[f64], columns: usize, to: &Channel, from: &Channel) -> f64 {
    let entry = |row: usize, column: usize| velocities[(2 * to.slider + row) * columns + 2 * from.slider + column];
    let row = |row: usize| entry(row, 0) * from.force.x + entry(row, 1) * from.force.y;
    to.speed.x * row(0) + to.speed.y * row(1)
}

/// A slider's velocity in a change of the state.
fn seen(view: &[f64], n: usize, slider: usize, state: &[f64]) -> DVec2 {
    let row = |row: usize| view[(2 * slider + row) * n..][..n].iter().zip(state).map(|(v, s)| v * s).sum();
    DVec2::new(row(0), row(1))
}

/// Rows times columns, each `n` long.
fn product<T>(rows: &[f64], columns: &[T], n: usize) -> Vec<T>
where
    T: Copy + std::ops::Mul<f64, Output = T> + std::iter::Sum,
{
    let columns: Vec<&[T]> = columns.chunks_exact(n.max(1)).collect();
    let entry = |row: &[f64], column: &[T]| column.iter().zip(row).map(|(c, r)| *c * *r).sum();
    rows.chunks_exact(n.max(1)).flat_map(|row| columns.iter().map(move |column| entry(row, column))).collect()
}

#[cfg(test)]
mod tests {
    use super::super::radau::Radau;
    use super::*;

    /// Far below the velocity by which a Jacobian is differenced.
    const LEAST: f64 = 1e-10;

    /// A unit mass that a force of 0.9, turning once in 2π, pushes against friction of 1: it creeps at 0.9 of the least
    /// speed, along the force.
    struct Creep {
        channels: Vec<Channel>,
        held: Option<DVec2>,
    }

    impl System for Creep {
        fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]) {
            let v = DVec2::new(y[0], y[1]);
            let against = self.held.unwrap_or(v / v.length().max(LEAST));
            let force = DVec2::new(t.cos(), t.sin()) * 0.9 - against;
            out.copy_from_slice(&force.to_array());
            let (along, speed) = (v.try_normalize().unwrap_or(DVec2::X), v.length());
            let channel = |direction: DVec2, slope: f64| Channel {
                slider: 0,
                force: direction * slope,
                speed: direction,
                follower: None,
            };
            let slowing = if speed < LEAST { -1.0 / LEAST } else { 0.0 };
            self.channels = vec![channel(along.perp(), -1.0 / speed.max(LEAST)), channel(along, slowing)];
        }

        fn size2(&self, d: &[f64]) -> f64 {
            d.iter().map(|x| (x / (1e-6 * LEAST)).powi(2)).sum()
        }

        fn sliders(&self) -> usize {
            1
        }

        fn channels(&self) -> &[Channel] {
            &self.channels
        }

        fn hold(&mut self, held: bool) {
            self.held = held.then_some(DVec2::X * 0.9);
        }

        fn slider(&self, _: usize, _: &[f64], push: &mut [f64], view: &mut [f64]) {
            push.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
            view.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
        }
    }

    #[test]
    fn creeping_friction_is_stepped_over_in_a_billion_of_its_time_constants() {
        let mut system = Creep { channels: Vec::new(), held: None };
        let (mut radau, mut y, mut slope) = (Radau::new(2), vec![0.9 * LEAST, 0.0], vec![0.0; 2]);
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
