//! Displacements of the sections of a member per unit of each exponential of a block.

use glam::DVec2;

use super::part::{LinearPart, RIGID, SectionShape};
use crate::dynamics::linear::{Complex, Spectrum};

/// Displacements of a section per unit coefficient of an exponential: |(x, y) + (u, v)|, |θ + φ|, |(u, v)|, |φ|, and |(x, y)|, |θ|.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    pub place: f64,
    pub turn: f64,
    pub moved: f64,
    pub turned: f64,
    pub base: [f64; 2],
}

/// A member's coordinates in the exponentials.
pub(super) struct Shapes<'a> {
    pub spectrum: &'a Spectrum,
    /// For each of the block's coordinates that are its own: number in the block, number in the member, root of its mass.
    pub own: &'a [(usize, usize, f64)],
}

impl Shapes<'_> {
    /// Of each section of a part.
    pub(super) fn of_sections(&self, part: &LinearPart) -> Vec<Vec<Reach>> {
        let count = self.spectrum.exponents.len();
        part.sections.iter().map(|section| (0..count).map(|k| self.reach(section, k)).collect()).collect()
    }

    fn reach(&self, section: &SectionShape, k: usize) -> Reach {
        let (mut base, mut field) = ([Complex::from(0.0); RIGID], [Complex::from(0.0); RIGID]);
        let (shape, share) = (self.spectrum.shapes.column(k), self.spectrum.share(k));
        for &(at, i, root) in self.own {
            let v = shape[at] / root * share;
            match (i.checked_sub(RIGID), section.fields.is_empty()) {
                (None, _) => base[i] = v,
                (Some(j), false) => {
                    let own = section.fields[j].to_array();
                    field.iter_mut().zip(own).for_each(|(sum, own)| *sum += v * own);
                }
                (Some(_), true) => {}
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
