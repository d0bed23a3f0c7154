//! A linear block: assembled, decomposed, its flights.

use nalgebra::DMatrix;

use super::joint::Joint;
use super::part::{LinearPart, RIGID};
use super::reach::{Reach, Shapes};
use crate::dynamics::linear::{Complex, LinearMotion, ModalCoordinates, PowerForm, Spectrum};
use crate::motion::Ground;

/// Largest [`Spectrum::start_error`] of a decomposition that is relied on \[–\]; beyond it the bodies are integrated. Measured: 1e-14 of
/// decks on their bearings; 1e-11 of one that a second bearing of 1e-3 of the stiffness of its only other one keeps from turning, 8e-10 by
/// 1e-5, 4e-8 by 1e-7, and 29 by rounding alone.
const RELIED: f64 = 1e-11;

/// The free motion of the bodies of a block, prepared once. Its coordinates are those that are not held, each times the root of its
/// mass, member by member.
#[derive(Debug)]
pub struct LinearBlock {
    pub(super) motion: LinearMotion,
    pub(super) ground: Ground,
    pub(super) members: Vec<Member>,
    /// Power lost in bearings, and in the bodies themselves \[W\]; `None` without a dashpot.
    pub(super) losses: [Option<PowerForm>; 2],
    /// Fastest circular frequency of the bodies as rigid ones \[rad/s\].
    pub(super) fastest: f64,
}

/// A body of a block: its coordinates and loads in it.
#[derive(Debug)]
pub(super) struct Member {
    /// Its coordinates that are not held: number in the block, number in the body, root of the mass.
    pub coordinates: Vec<(usize, usize, f64)>,
    /// Places of all its coordinates at the start: of those that are held, for ever.
    pub start: Vec<f64>,
    /// Constant generalised force of the push.
    pub push: Vec<f64>,
    /// Distance of the ends from G, of a body that bends \[m\].
    pub lever: f64,
    /// Displacement of each section per unit of each exponential.
    pub sections: Vec<Vec<Reach>>,
}

impl Member {
    /// Whether a coordinate is not held.
    pub(super) fn moves(&self, coordinate: usize) -> bool {
        self.coordinates.iter().any(|(_, i, _)| *i == coordinate)
    }
}

/// Order of the coordinates of a block's parts, held ones included.
struct Order<'a> {
    parts: &'a [LinearPart],
    /// The first coordinate of each part.
    first: Vec<usize>,
    /// Number of all coordinates.
    count: usize,
}

impl<'a> Order<'a> {
    fn of(parts: &'a [LinearPart]) -> Self {
        let (mut first, mut count) = (Vec::with_capacity(parts.len()), 0);
        for part in parts {
            first.push(count);
            count += part.places();
        }
        Self { parts, first, count }
    }

    /// A value of each coordinate, in order.
    fn all<T: Copy>(&self, of: impl Fn(&LinearPart) -> &[T]) -> Vec<T> {
        self.parts.iter().flat_map(|part| of(part).to_vec()).collect()
    }

    /// Stiffness and the dashpots of all bearings.
    fn matrices(&self, joints: &[Joint]) -> [DMatrix<f64>; 2] {
        let mut both = [DMatrix::zeros(self.count, self.count), DMatrix::zeros(self.count, self.count)];
        for (part, &first) in self.parts.iter().zip(&self.first) {
            for (all, own) in both.iter_mut().zip([&part.stiffness, &part.damping]) {
                all.view_mut((first, first), own.shape()).copy_from(own);
            }
        }
        let [stiffness, damping] = &mut both;
        for joint in joints {
            let row =
                |member: usize, section, arm, axis| (self.first[member], self.parts[member].row(section, arm, axis));
            joint.add(row, [stiffness, damping]);
        }
        both
    }
}

impl LinearBlock {
    /// Of these bodies with the bearings between them, in a run of this duration \[s\]; `None` where their motion has no closed form
    /// that can be relied on.
    pub fn of(parts: &[LinearPart], joints: &[Joint], (ground, duration): (&Ground, f64)) -> Option<Self> {
        let order = Order::of(parts);
        let free: Vec<bool> = order.all(|part| &part.free);
        let kept: Vec<usize> = (0..order.count).filter(|&i| free[i]).collect();
        let roots: Vec<f64> = order.all(|part| &part.masses).into_iter().map(f64::sqrt).collect();
        let (start, push) = (order.all(|part| &part.start), order.all(|part| &part.push));
        let [stiffness, bearings] = order.matrices(joints);
        let n = kept.len();
        let scaled =
            |m: &DMatrix<f64>| DMatrix::from_fn(n, n, |i, j| m[(kept[i], kept[j])] / (roots[kept[i]] * roots[kept[j]]));
        let own_damping = DMatrix::from_diagonal(&order.all(|part| &part.own_damping).into());
        let stiffness_scaled = scaled(&stiffness);
        let spectrum = Spectrum::of(&stiffness_scaled, &scaled(&(&bearings + &own_damping)))?;
        if spectrum.start_error(duration) > RELIED {
            return None;
        }
        // A coordinate that is held where it was displaced to loads the others.
        let pulled =
            |i: usize| (0..order.count).filter(|&h| !free[h]).map(|h| stiffness[(i, h)] * start[h]).sum::<f64>();
        let load: Vec<f64> = kept.iter().map(|&i| (push[i] - pulled(i)) / roots[i]).collect();
        let numbers: Vec<usize> = parts.iter().flat_map(|part| 0..part.places()).collect();
        let by_ground = [0, 1]
            .map(|axis| kept.iter().map(|&i| if numbers[i] == axis { -roots[i] } else { 0.0 }).collect::<Vec<f64>>());
        let motion = LinearMotion::of(spectrum, &load, [&by_ground[0], &by_ground[1]], (ground, duration))?;
        let member = |(number, part): (usize, &LinearPart)| {
            let range = order.first[number]..order.first[number] + part.places();
            let own = kept.iter().enumerate().filter(|(_, i)| range.contains(i));
            let coordinates: Vec<_> = own.map(|(at, &i)| (at, numbers[i], roots[i])).collect();
            let sections = Shapes { spectrum: &motion.spectrum, own: &coordinates }.of_sections(part);
            Member { coordinates, start: part.start.clone(), push: part.push.clone(), lever: part.lever, sections }
        };
        let members = parts.iter().enumerate().map(member).collect();
        let losses = [&bearings, &own_damping].map(|damping| PowerForm::of(&motion, &scaled(damping)));
        let rigid: Vec<usize> = (0..n).filter(|&i| numbers[kept[i]] < RIGID).collect();
        let fastest =
            fastest(&DMatrix::from_fn(rigid.len(), rigid.len(), |i, j| stiffness_scaled[(rigid[i], rigid[j])]));
        Some(Self { motion, ground: ground.clone(), members, losses, fastest })
    }

    /// Parameters of one flight of all members from these states at `start`, one state a member.
    pub(super) fn begin_all(&self, start: f64, states: &[&[f64]]) -> Vec<f64> {
        let size = self.motion.spectrum.size;
        let (mut places, mut speeds) = (vec![0.0; size], vec![0.0; size]);
        for (member, state) in self.members.iter().zip(states) {
            let (place, speed) = state.split_at(member.start.len());
            for &(at, i, root) in &member.coordinates {
                (places[at], speeds[at]) = (place[i] * root, speed[i] * root);
            }
        }
        self.motion.begin(start, &places, &speeds)
    }

    /// States of a member by a unit coefficient of each exponential, 1 and i, beside that at rest.
    pub(super) fn shapes(&self, member: usize) -> Vec<[Vec<f64>; 2]> {
        let own = &self.members[member];
        let rest = own.start.iter().copied().chain(own.start.iter().map(|_| 0.0));
        let spectrum = &self.motion.spectrum;
        let (drifts, count) = (vec![[0.0; 2]; spectrum.drifts.len()], spectrum.exponents.len());
        let state = |k: usize, unit: Complex| {
            let mut parts =
                ModalCoordinates { drifts: drifts.clone(), free: Vec::new(), all: vec![Complex::from(0.0); count] };
            parts.all[k] = unit;
            let mut state = vec![0.0; 2 * own.start.len()];
            self.write(member, &parts, &mut state);
            state.iter_mut().zip(rest.clone()).for_each(|(x, rest)| *x -= rest);
            state
        };
        (0..count).map(|k| [Complex::from(1.0), Complex::i()].map(|unit| state(k, unit))).collect()
    }

    /// Writes places and rates of a member from a flight's parts.
    pub(super) fn write(&self, member: usize, parts: &ModalCoordinates, out: &mut [f64]) {
        let own = &self.members[member];
        let (places, rates) = out.split_at_mut(own.start.len());
        places.copy_from_slice(&own.start);
        rates.fill(0.0);
        let Some(first) = own.coordinates.first().map(|(at, ..)| *at) else { return };
        let count = own.coordinates.len();
        let mut read = vec![0.0; 2 * count];
        let (place, rate) = read.split_at_mut(count);
        self.motion.read(parts, first, place, rate);
        for (k, &(_, i, root)) in own.coordinates.iter().enumerate() {
            (places[i], rates[i]) = (place[k] / root, rate[k] / root);
        }
    }
}

/// Root of the largest eigenvalue of a symmetric matrix \[rad/s\].
fn fastest(stiffness: &DMatrix<f64>) -> f64 {
    if stiffness.is_empty() { 0.0 } else { stiffness.symmetric_eigenvalues().max().max(0.0).sqrt() }
}
