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

    /// Responses of the factored systems to forces on the sliders.
    pub(super) fn factor(&mut self, real: &Lu<f64>, complex: &[Lu<Complex64>; 3]) {
        let (n, columns) = (self.size, 2 * self.sliders);
        if columns == 0 {
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
        for m in 0..3 {
            self.complex[m].resize(columns * n, Complex64::ZERO);
            for (push, found) in self.push.chunks_exact(n).zip(self.complex[m].chunks_exact_mut(n)) {
                right.iter_mut().zip(push).for_each(|(r, p)| *r = Complex64::new(*p, 0.0));
                complex[m].solve(&right, found);
            }
        }
        let kernels: [Vec<Complex64>; 3] = std::array::from_fn(|m| product(&self.view, &self.complex[m], n));
        for (k, l) in (0..STAGES * STAGES).map(|kl| (kl / STAGES, kl % STAGES)) {
            let real = REAL_RIGHT[k] * REAL_LEFT[l];
            let weights: [Complex64; 3] = std::array::from_fn(|m| {
                let (a, b) = (COMPLEX_RIGHT[m][k], COMPLEX_LEFT[m][l]);
                2.0 * Complex64::new(a.0, a.1) * Complex64::new(b.0, b.1)
            });
            let out = &mut self.between[(k * STAGES + l) * columns * columns..][..columns * columns];
            for (i, out) in out.iter_mut().enumerate() {
                *out = real * self.within[i] + (0..3).map(|m| (weights[m] * kernels[m][i]).re).sum::<f64>();
            }
        }
    }

    /// Takes the channels of a stage as the system has them where its slope was last asked for.
    pub(super) fn record(&mut self, stage: usize, channels: &[Channel]) {
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
