//! A bar on springs before a wall, shaken: spectral elements on Gauss–Lobatto nodes, carried from instant to instant by the
//! exponential of its matrix, with the touch found by halving. Linear but for the touch, so that time has no error at all.

use nalgebra::{DMatrix, DVector};

use crate::study::accuracy::line::{Bar, Line};
use crate::study::accuracy::{Answer, Instants};

/// Nodes of an element on (−1, 1), and weights: Gauss–Lobatto of seven, exact to degree 11.
const NODES: [f64; 7] =
    [-1.0, -0.830_223_896_278_567, -0.468_848_793_470_714_2, 0.0, 0.468_848_793_470_714_2, 0.830_223_896_278_567, 1.0];
const WEIGHTS: [f64; 7] = [
    0.047_619_047_619_047_616,
    0.276_826_047_361_565_9,
    0.431_745_381_209_862_6,
    0.487_619_047_619_047_6,
    0.431_745_381_209_862_6,
    0.276_826_047_361_565_9,
    0.047_619_047_619_047_616,
];
/// Elements of the bar.
const ELEMENTS: usize = 6;
/// Looks at the gap to an interval of comparison: some forty to a touch.
const LOOKS: usize = 4;
/// Halvings of a look: the last is below 1e-12 s.
const HALVINGS: usize = 30;
/// Terms of the series of the shortest exponential.
const TERMS: usize = 12;

/// A state: displacements and speeds of the nodes, then the sine and the cosine of the ground, and 1.
struct March {
    /// `e^{A h/2^k} − 1` of the open and of the closed gap, k from 0.
    exponentials: [Vec<DMatrix<f64>>; 2],
    state: DVector<f64>,
    closed: bool,
    /// Number of the end's displacement, and of its speed.
    end: [usize; 2],
    line: Line,
    peak: f64,
}

impl March {
    fn of(line: &Line, look: f64) -> Self {
        let bar = &line.bars[0];
        let places = ELEMENTS * (NODES.len() - 1) + 1;
        let exponentials = [false, true].map(|closed| exponentials(&matrix(line, bar, closed), look));
        let mut state = DVector::zeros(2 * places + 3);
        (state[2 * places + 1], state[2 * places + 2]) = (1.0, 1.0);
        let end = [places - 1, 2 * places - 1];
        Self { exponentials, state, closed: false, end, line: line.clone(), peak: 0.0 }
    }

    fn depth(&self, state: &DVector<f64>) -> f64 {
        state[self.end[0]] - self.line.gap
    }

    fn after(&self, halvings: usize) -> DVector<f64> {
        &self.state + &self.exponentials[usize::from(self.closed)][halvings] * &self.state
    }

    /// Goes on by a look halved so often, through touches and ends of touches.
    fn advance(&mut self, halvings: usize) {
        let next = self.after(halvings);
        if (self.depth(&next) > 0.0) == self.closed {
            self.note_peak(&next, halvings);
            self.state = next;
        } else if halvings == HALVINGS {
            self.state = next;
            self.closed = !self.closed;
        } else {
            self.advance(halvings + 1);
            self.advance(halvings + 1);
        }
    }

    /// Notes the deepest place between the state and the next, where the end turns.
    fn note_peak(&mut self, next: &DVector<f64>, halvings: usize) {
        if !self.closed || self.state[self.end[1]] < 0.0 || next[self.end[1]] > 0.0 {
            return;
        }
        let mut at = self.state.clone();
        for matrix in &self.exponentials[1][halvings + 1..] {
            let middle = &at + matrix * &at;
            if middle[self.end[1]] > 0.0 {
                at = middle;
            }
        }
        self.peak = self.peak.max(self.line.stiffness * self.depth(&at) / self.line.nodes);
    }
}

/// The answer of one bar before a wall.
pub(super) fn answer(line: &Line, instants: Instants) -> Answer {
    let masses = masses(&line.bars[0]);
    let look = (instants.at(1) - instants.at(0)) / LOOKS as f64;
    let mut march = March::of(line, look);
    let mut places = Vec::new();
    for (i, _) in instants.all().enumerate() {
        if i > 0 {
            (0..LOOKS).for_each(|_| march.advance(0));
        }
        let sum: f64 = masses.iter().zip(march.state.iter()).map(|(mass, u)| mass * u).sum();
        places.push([sum / line.bars[0].mass, 0.0, 0.0, 0.0]);
    }
    Answer { places, bodies: 1, peak_force: march.peak, ..Answer::default() }
}

/// Mass at each node.
fn masses(bar: &Bar) -> Vec<f64> {
    let per = NODES.len() - 1;
    let mut masses = vec![0.0; ELEMENTS * per + 1];
    for element in 0..ELEMENTS {
        for (i, weight) in WEIGHTS.iter().enumerate() {
            masses[element * per + i] += 0.5 * weight * bar.mass / ELEMENTS as f64;
        }
    }
    masses
}

/// The polynomial that is 1 at node `j` and 0 at the others, at `x`.
fn shape(j: usize, x: f64) -> f64 {
    let others = NODES.iter().enumerate().filter(|&(k, _)| k != j);
    others.map(|(_, node)| (x - node) / (NODES[j] - node)).product()
}

/// Its slope at `x`.
fn slope(j: usize, x: f64) -> f64 {
    let of = |k: usize| {
        let others = NODES.iter().enumerate().filter(|&(l, _)| l != j && l != k);
        others.map(|(_, node)| (x - node) / (NODES[j] - node)).product::<f64>() / (NODES[j] - NODES[k])
    };
    (0..NODES.len()).filter(|&k| k != j).map(of).sum()
}

/// A of ż = A z.
fn matrix(line: &Line, bar: &Bar, closed: bool) -> DMatrix<f64> {
    let (masses, per, size) = (masses(bar), NODES.len() - 1, ELEMENTS as f64);
    let places = masses.len();
    let [mut stiffness, mut damping] = [DMatrix::<f64>::zeros(places, places), DMatrix::zeros(places, places)];
    for element in 0..ELEMENTS {
        for i in 0..=per {
            for j in 0..=per {
                let product = |(x, w): (&f64, &f64)| w * slope(i, *x) * slope(j, *x);
                let sum: f64 = NODES.iter().zip(&WEIGHTS).map(product).sum();
                stiffness[(element * per + i, element * per + j)] += sum * 2.0 * size * bar.axial / bar.length;
            }
        }
    }
    damping += &stiffness * bar.retardation;
    for [at, k, c] in &bar.legs {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the bar")]
        let element = ((at / bar.length * size) as usize).min(ELEMENTS - 1);
        let x = 2.0 * (at / bar.length * size - element as f64) - 1.0;
        for i in 0..=per {
            for j in 0..=per {
                let both = shape(i, x) * shape(j, x);
                stiffness[(element * per + i, element * per + j)] += k * both;
                damping[(element * per + i, element * per + j)] += c * both;
            }
        }
    }
    let mut all = DMatrix::zeros(2 * places + 3, 2 * places + 3);
    let [sine, one] = [2 * places, 2 * places + 2];
    for i in 0..places {
        all[(i, places + i)] = 1.0;
        for j in 0..places {
            all[(places + i, j)] = -stiffness[(i, j)] / masses[i];
            all[(places + i, places + j)] = -damping[(i, j)] / masses[i];
        }
        all[(places + i, sine)] = -line.drive[0];
    }
    if closed {
        let last = places - 1;
        all[(places + last, last)] -= line.stiffness / masses[last];
        all[(places + last, one)] += line.stiffness * line.gap / masses[last];
    }
    (all[(sine, sine + 1)], all[(sine + 1, sine)]) = (line.drive[1], -line.drive[1]);
    all
}

/// `e^{A h/2^k} − 1`, k from 0: the shortest by its series, the others by `(1 + D)² − 1 = 2D + D²`, which loses nothing beside 1.
fn exponentials(matrix: &DMatrix<f64>, h: f64) -> Vec<DMatrix<f64>> {
    let short = matrix * (h / f64::powi(2.0, i32::try_from(HALVINGS).unwrap_or(i32::MAX)));
    let (mut term, mut sum) = (short.clone(), short.clone());
    for k in 2..=TERMS {
        term = &term * &short / k as f64;
        sum += &term;
    }
    let mut all = vec![sum];
    for k in 0..HALVINGS {
        let longer = &all[k] * 2.0 + &all[k] * &all[k];
        all.push(longer);
    }
    all.reverse();
    all
}
