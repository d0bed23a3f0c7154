//! Free motion of an elastic girder in closed form, with bounds for the search of touches, (F7).

use glam::DVec2;
use nalgebra::DMatrix;

use super::girder::{ElasticGirder, RIGID};
use super::section::Section;
use super::section_bounds::SectionBounds;
use crate::dynamics::linear::{Complex, Flight, LineOrSine, LinearMotion, Parts, PowerForm, Spectrum};
use crate::dynamics::model::body::Body;
use crate::dynamics::model::closed_form::ClosedForm;
use crate::dynamics::model::coordinates::planar;
use crate::dynamics::model::motion_bounds::MotionBounds;
use crate::motion::Ground;

/// The free motion of an elastic girder, prepared once. Its linear block has the coordinates that are not held, each times the
/// root of its mass.
#[derive(Debug)]
pub(super) struct FreeGirder {
    motion: LinearMotion,
    ground: Ground,
    places: usize,
    /// Numbers of the block's coordinates among the state's.
    order: Vec<usize>,
    /// Roots of their masses.
    roots: Vec<f64>,
    /// Places of all coordinates at the start: of those that are held, for ever.
    start: Vec<f64>,
    lever: f64,
    /// How far each exponential moves a section: of G, of both ends, of links.
    sections: Vec<Vec<Reach>>,
    /// Constant generalised force of the push.
    push: Vec<f64>,
    losses: [PowerForm; 2],
}

/// What a unit coefficient of an exponential does to a section: |(x, y) + (u, v)|, |θ + φ|, |(u, v)|, |φ|, and |(x, y)|, |θ|.
#[derive(Clone, Copy, Debug)]
struct Reach {
    place: f64,
    turn: f64,
    moved: f64,
    turned: f64,
    base: [f64; 2],
}

impl FreeGirder {
    /// `None` where the motion has no closed form that can be relied on.
    pub(super) fn of(girder: &ElasticGirder, ground: &Ground) -> Option<Self> {
        let free = planar::free(&girder.rigid);
        let order: Vec<usize> = (0..girder.places()).filter(|&i| i >= RIGID || free[i]).collect();
        let all: Vec<f64> = girder.masses().map(f64::sqrt).collect();
        let roots: Vec<f64> = order.iter().map(|&i| all[i]).collect();
        let start = start(&girder.rigid, girder.places());
        let [stiffness, damping] = matrices(girder);
        let scaled = |m: &DMatrix<f64>| {
            let n = order.len();
            DMatrix::from_fn(n, n, |i, j| m[(order[i], order[j])] / (roots[i] * roots[j]))
        };
        let spectrum = Spectrum::of(&scaled(&stiffness), &scaled(&damping))?;
        let push = push(girder);
        // A coordinate that is held where it was displaced to loads the others.
        let held: Vec<usize> = (0..RIGID).filter(|&i| !free[i]).collect();
        let pulled = |i: usize| held.iter().map(|&h| stiffness[(i, h)] * start[h]).sum::<f64>();
        let load: Vec<f64> = order.iter().zip(&roots).map(|(&i, root)| (push[i] - pulled(i)) / root).collect();
        let by_ground = [0, 1].map(|axis| {
            order.iter().zip(&roots).map(|(&i, root)| if i == axis { -root } else { 0.0 }).collect::<Vec<f64>>()
        });
        let motion = LinearMotion::of(spectrum, &load, [&by_ground[0], &by_ground[1]], ground)?;
        let rows = |own: &dyn Fn(usize) -> f64| order.iter().zip(&roots).map(|(&i, root)| own(i) / root).collect();
        let on_bearings: Vec<(f64, Vec<f64>)> =
            girder.bearings.iter().map(|axis| (axis.damping, rows(&|i| axis.row[i]))).collect();
        let own: Vec<(f64, Vec<f64>)> = (girder.springs.iter().enumerate())
            .map(|(j, [_, c])| (*c, rows(&|i| if i == RIGID + j { 1.0 } else { 0.0 })))
            .collect();
        let losses = [PowerForm::of(&motion, &on_bearings), PowerForm::of(&motion, &own)];
        let shapes = Shapes { motion: &motion, order: &order, roots: &roots };
        let sections = (0..=girder.deforming.len()).map(|section| shapes.reaches(girder.deforming(section))).collect();
        let lever = girder.lever();
        let (ground, places) = (ground.clone(), girder.places());
        Some(Self { motion, ground, places, order, roots, start, lever, sections, push, losses })
    }

    /// Writes places and rates of a flight's parts.
    fn write(&self, parts: &Parts, out: &mut [f64]) {
        let n = self.order.len();
        let mut read = vec![0.0; 2 * n];
        let (places, rates) = read.split_at_mut(n);
        self.motion.read(parts, places, rates);
        out[..self.places].copy_from_slice(&self.start);
        out[self.places..].fill(0.0);
        for (k, (&i, root)) in self.order.iter().zip(&self.roots).enumerate() {
            (out[i], out[self.places + i]) = (read[k] / root, read[n + k] / root);
        }
    }

    /// Bounds on one section.
    fn section_bounds(&self, section: usize, parts: &Parts, window: f64) -> MotionBounds {
        let mut sum = SectionBounds::default();
        let (mut reach, mut turn, mut apart) = (0.0, 0.0, 0.0);
        for (k, r) in self.sections[section].iter().enumerate() {
            let [c, rate, gain] = self.motion.largest(parts, k, window);
            reach += r.place * c;
            turn += r.turn * c;
            apart += (r.moved + self.lever * r.turned) * c;
            sum.speed += r.place * rate;
            sum.acceleration += r.place * gain;
            sum.spin += r.base[1] * rate;
            sum.spin_rate += r.base[1] * gain;
            sum.turned[0] += r.turned * rate;
            sum.turned[1] += r.turned * gain;
            sum.moved[0] += r.moved * rate;
        }
        sum.acceleration += self.motion.unsteady_peak();
        for (i, &drift) in self.motion.spectrum.drifts.iter().enumerate() {
            let [place, speed, gain] = self.motion.drift_bounds(parts, i, window).map(|b| b / self.roots[drift]);
            if self.order[drift] == 2 {
                turn += place;
                sum.spin += speed;
                sum.spin_rate += gain;
            } else {
                reach += place;
                sum.speed += speed;
                sum.acceleration += gain;
            }
        }
        self.with_held(&mut reach, &mut turn);
        // Place and (u, v) are summed as one: what `of_frame` adds of the latter is theirs already.
        let speeds = sum.moved[0];
        sum.moved = [0.0; 2];
        let mut frame = sum.of_frame(self.lever, apart, window);
        frame.acceleration += 2.0 * sum.spin * speeds;
        MotionBounds { reach: reach + apart, turn, ..frame }
    }

    fn with_held(&self, reach: &mut f64, turn: &mut f64) {
        for i in (0..RIGID).filter(|i| !self.order.contains(i)) {
            *(if i == 2 { &mut *turn } else { &mut *reach }) += self.start[i].abs();
        }
    }

    /// Work of the ground's inertia forces within one piece of its motion \[J\].
    fn ground_work(&self, flight: Flight<'_>, [from, until]: [f64; 2]) -> f64 {
        let axis = |axis: usize| {
            let Some(at) = self.order.iter().position(|&i| i == axis) else { return 0.0 };
            let acceleration = self.line(axis, from);
            if let Some(drift) = self.motion.spectrum.drifts.iter().position(|&i| i == at) {
                let [a, b] = [from, until].map(|t| self.motion.at(flight, t).drifts[drift]);
                // What moves freely gains what is done to it, the push's work taken off.
                return 0.5 * (b[1] * b[1] - a[1] * a[1]) - self.push[axis] / self.roots[at] * (b[0] - a[0]);
            }
            let mut row = vec![0.0; self.order.len()];
            row[at] = -self.roots[at];
            self.motion.moved_by(flight, &row, [from, until], &acceleration)
        };
        axis(0) + axis(1)
    }

    /// The ground's acceleration along an axis from `t` on, within a piece.
    fn line(&self, axis: usize, t: f64) -> LineOrSine {
        match &self.ground {
            Ground::Still => LineOrSine::Line(0.0, 0.0),
            Ground::Sine { amplitude, omega, phase, .. } => {
                LineOrSine::Sine(amplitude[axis], *omega, omega * t + phase)
            }
            Ground::Record { .. } => {
                let piece = self.ground.piece(self.ground.piece_number(t));
                LineOrSine::Line(piece.acceleration(t)[axis], piece.rate()[axis])
            }
        }
    }
}

impl ClosedForm for FreeGirder {
    fn begin(&self, start: f64, state: &[f64]) -> Vec<f64> {
        let (places, rates) = state.split_at(self.places);
        let scaled =
            |half: &[f64]| self.order.iter().zip(&self.roots).map(|(&i, root)| half[i] * root).collect::<Vec<f64>>();
        self.motion.begin(start, &scaled(places), &scaled(rates))
    }

    fn state(&self, start: f64, numbers: &[f64], t: f64, out: &mut [f64]) {
        self.write(&self.motion.at(Flight { start, numbers }, t), out);
    }

    fn bounds(&self, start: f64, numbers: &[f64], t: f64, horizon: f64) -> MotionBounds {
        let (parts, window) = (self.motion.at(Flight { start, numbers }, t), self.motion.window(horizon));
        let all: Vec<MotionBounds> =
            (0..self.sections.len()).map(|section| self.section_bounds(section, &parts, window)).collect();
        let most = |of: fn(&MotionBounds) -> f64| all.iter().map(of).fold(0.0, f64::max);
        MotionBounds {
            window,
            reach: most(|b| b.reach),
            turn: most(|b| b.turn),
            speed: most(|b| b.speed),
            spin: most(|b| b.spin),
            acceleration: most(|b| b.acceleration),
            spin_rate: most(|b| b.spin_rate),
        }
    }

    fn works(&self, start: f64, numbers: &[f64], span: [f64; 2]) -> Option<[f64; 4]> {
        let flight = Flight { start, numbers };
        let [mut a, mut b] = [vec![0.0; 2 * self.places], vec![0.0; 2 * self.places]];
        self.write(&self.motion.at(flight, span[0]), &mut a);
        self.write(&self.motion.at(flight, span[1]), &mut b);
        let push = self.push.iter().zip(a.iter().zip(&b)).map(|(force, (a, b))| force * (b - a)).sum();
        let [bearings, own] = [0, 1].map(|i| self.losses[i].work(&self.motion, flight, span));
        Some([self.ground_work(flight, span), push, bearings, own])
    }
}

/// Places at the start.
fn start(rigid: &Body, places: usize) -> Vec<f64> {
    let mut start = vec![0.0; places];
    start[..RIGID].copy_from_slice(&[rigid.start[0], rigid.start[1], rigid.start[5]]);
    start
}

/// The push as a generalised force.
fn push(girder: &ElasticGirder) -> Vec<f64> {
    let Body { push, moment, .. } = &girder.rigid;
    [push.x, push.y, moment.z].into_iter().chain(girder.pushed.iter().copied()).collect()
}

/// Stiffness and damping over all coordinates.
fn matrices(girder: &ElasticGirder) -> [DMatrix<f64>; 2] {
    let n = girder.places();
    let mut both = [DMatrix::zeros(n, n), DMatrix::zeros(n, n)];
    for axis in &girder.bearings {
        for (matrix, factor) in both.iter_mut().zip([axis.stiffness, axis.damping]) {
            for j in 0..n {
                for i in 0..n {
                    matrix[(i, j)] += factor * axis.row[i] * axis.row[j];
                }
            }
        }
    }
    for (j, spring) in girder.springs.iter().enumerate() {
        for (matrix, own) in both.iter_mut().zip(spring) {
            matrix[(RIGID + j, RIGID + j)] += own;
        }
    }
    both
}

/// Shapes of the exponentials.
struct Shapes<'a> {
    motion: &'a LinearMotion,
    order: &'a [usize],
    roots: &'a [f64],
}

impl Shapes<'_> {
    fn reaches(&self, section: Option<&Section>) -> Vec<Reach> {
        let spectrum = &self.motion.spectrum;
        (0..spectrum.exponents.len()).map(|k| self.reach(section, k, spectrum.share(k))).collect()
    }

    fn reach(&self, section: Option<&Section>, k: usize, share: f64) -> Reach {
        let (mut base, mut field) = ([Complex::from(0.0); 3], [Complex::from(0.0); 3]);
        let shape = self.motion.spectrum.shapes.column(k);
        for ((&i, root), v) in self.order.iter().zip(self.roots).zip(shape.iter()) {
            let v = v / root * share;
            match (i.checked_sub(RIGID), section) {
                (None, _) => base[i] = v,
                (Some(j), Some(section)) => {
                    let own = section.fields[j].to_array();
                    field.iter_mut().zip(own).for_each(|(sum, own)| *sum += v * own);
                }
                (Some(_), None) => {}
            }
        }
        let length = |x: Complex, y: Complex| DVec2::new(x.norm(), y.norm()).length();
        Reach {
            place: length(base[0] + field[0], base[1] + field[1]),
            turn: (base[2] + field[2]).norm(),
            moved: length(field[0], field[1]),
            turned: field[2].norm(),
            base: [length(base[0], base[1]), base[2].norm()],
        }
    }
}
