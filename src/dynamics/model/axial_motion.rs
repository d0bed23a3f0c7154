//! The motion of a body along one world axis: what of its state changes, all else staying 0.

use std::sync::Arc;

use smallvec::SmallVec;

/// Sums over bearings below this part of the sum of their terms' sizes are rounding \[–\]: of some ten terms, each of three factors.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Components of a body's state that change while it moves along a world axis.
#[derive(Clone, Debug, PartialEq)]
pub struct AxialMotion {
    /// Components that are the displacement of G along the axis \[m\], and its rate.
    pub components: [usize; 2],
    /// Modes along the axis, of a girder that has any.
    pub modes: Option<Arc<AxialModes>>,
}

/// The modes of a girder that displace its sections along the axis and do not turn them, each of unit modal mass, and the bearings as
/// they resist G and these modes.
#[derive(Clone, Debug, PartialEq)]
pub struct AxialModes {
    /// Number of the first rate in the state.
    rates: usize,
    /// Component of each mode's coordinate in the state.
    coordinates: Vec<usize>,
    /// Spring \[1/s²\] and dashpot \[1/s\] of each mode, and the constant load on it \[N/√kg\].
    springs: Vec<[f64; 3]>,
    /// Displacement along the axis by each mode, of the −x end and of the +x end \[1/√kg\].
    ends: [Vec<f64>; 2],
    /// Bearings along the axis, those with one row as one.
    bearings: Vec<AxialBearing>,
    /// Of each component of the state: the bits that are 0 while it stays 0, all but that of the sign; none of one that moves.
    still: Vec<u64>,
}

/// Bearings along the axis.
#[derive(Clone, Debug, PartialEq)]
struct AxialBearing {
    /// Displacement by each mode; by G it is `unit`.
    row: Vec<f64>,
    unit: f64,
    /// k \[N/m\] and c \[N·s/m\].
    stiffness: f64,
    damping: f64,
}

/// A girder with modes, as what [`AxialModes::of`] finds those along an axis in.
#[derive(Debug)]
pub struct AxialParts<'a> {
    /// Coordinate of G along the axis.
    pub along: usize,
    /// Number of the first modal coordinate.
    pub first: usize,
    /// Number of positions in a state.
    pub places: usize,
    /// Of each end and mode: displacement along the axis, across it, and turn.
    pub ends: [Vec<[f64; 3]>; 2],
    /// Spring, dashpot and constant load of each mode.
    pub springs: Vec<[f64; 3]>,
    /// Displacement of each bearing by all positions, with k and c.
    pub bearings: Vec<(&'a [f64], [f64; 2])>,
}

impl AxialModes {
    /// Those of a girder; `None` where an end's force along the axis, or a bearing, leads off it.
    pub fn of(parts: &AxialParts<'_>) -> Option<Self> {
        let is_along = |j: &usize| parts.ends.iter().all(|end| end[*j][1] == 0.0 && end[*j][2] == 0.0);
        let (own, others): (Vec<usize>, Vec<usize>) = (0..parts.springs.len()).partition(is_along);
        let is_off = |j: usize| parts.ends.iter().all(|end| end[j][0] == 0.0) && parts.springs[j][2] == 0.0;
        if !others.into_iter().all(is_off) {
            return None;
        }
        let coordinates: Vec<usize> = own.iter().map(|j| parts.first + j).collect();
        let moves = |i: &usize| *i == parts.along || coordinates.binary_search(i).is_ok();
        let (moving, still): (Vec<usize>, Vec<usize>) = (0..parts.places).partition(moves);
        let couples = |i: usize, a: usize, which: usize| {
            let terms = parts.bearings.iter().map(|(row, factors)| factors[which] * row[i] * row[a]);
            let (sum, size) = terms.fold((0.0, 0.0), |(sum, size), term| (sum + term, size + f64::abs(term)));
            f64::abs(sum) > ROUNDING * size
        };
        if still.iter().any(|&i| moving.iter().any(|&a| couples(i, a, 0) || couples(i, a, 1))) {
            return None;
        }
        let mut bearings: Vec<AxialBearing> = Vec::new();
        for (row, [stiffness, damping]) in &parts.bearings {
            let (unit, row): (f64, Vec<f64>) = (row[parts.along], coordinates.iter().map(|&i| row[i]).collect());
            match bearings.iter_mut().find(|known| known.unit == unit && known.row == row) {
                Some(known) => {
                    known.stiffness += stiffness;
                    known.damping += damping;
                }
                None if unit == 0.0 && row.iter().all(|x| *x == 0.0) => {}
                None => bearings.push(AxialBearing { row, unit, stiffness: *stiffness, damping: *damping }),
            }
        }
        let mut bits = vec![0; 2 * parts.places];
        still.iter().flat_map(|&i| [i, parts.places + i]).for_each(|i| bits[i] = !(1 << 63));
        let ends = [0, 1].map(|end| own.iter().map(|&j| parts.ends[end][j][0]).collect());
        let springs = own.iter().map(|&j| parts.springs[j]).collect();
        Some(Self { rates: parts.places, coordinates, springs, ends, bearings, still: bits })
    }

    /// Whether all else is 0 in a state.
    #[inline]
    pub fn hold(&self, state: &[f64]) -> bool {
        state.iter().zip(&self.still).fold(0, |all, (x, bits)| all | (x.to_bits() & bits)) == 0
    }

    fn shape(&self, section: usize) -> &[f64] {
        section.checked_sub(1).and_then(|end| self.ends.get(end)).map_or(&[], Vec::as_slice)
    }

    /// Displacement of a section by the modes along the axis \[m\], and its rate; nothing of the section that moves with G.
    #[inline]
    pub fn displaced(&self, section: usize, state: &[f64]) -> [f64; 2] {
        let both = self.shape(section).iter().zip(&self.coordinates);
        both.fold([0.0; 2], |[q, v], (shape, &at)| [q + shape * state[at], v + shape * state[self.rates + at]])
    }

    /// Adds what a force along the axis on a section does to the modes, to their accelerations.
    #[inline]
    pub fn push(&self, section: usize, force: f64, out: &mut [f64]) {
        for (shape, &at) in self.shape(section).iter().zip(&self.coordinates) {
            out[self.rates + at] += shape * force;
        }
    }

    /// Adds springs, dashpots, bearings and constant loads to the accelerations of the modes, writes the rates of their coordinates, and
    /// answers with the force of the bearings on G \[N\], where that is displaced by `place` since the girder was placed and moves at
    /// `speed`.
    #[inline]
    pub fn resist(&self, [place, speed]: [f64; 2], state: &[f64], out: &mut [f64]) -> f64 {
        let mut on_body = 0.0;
        let force = |bearing: &AxialBearing| {
            let (mut moved, mut moving) = (bearing.unit * place, bearing.unit * speed);
            for (row, &at) in bearing.row.iter().zip(&self.coordinates) {
                moved += row * state[at];
                moving += row * state[self.rates + at];
            }
            let force = bearing.stiffness * moved + bearing.damping * moving;
            on_body -= bearing.unit * force;
            force
        };
        let forces: SmallVec<[f64; 4]> = self.bearings.iter().map(force).collect();
        for (j, (&at, [k, c, load])) in self.coordinates.iter().zip(&self.springs).enumerate() {
            let (q, v) = (state[at], state[self.rates + at]);
            let held: f64 = self.bearings.iter().zip(&forces).map(|(bearing, force)| bearing.row[j] * force).sum();
            out[self.rates + at] += load - k * q - c * v - held;
            out[at] = v;
        }
        on_body
    }
}
