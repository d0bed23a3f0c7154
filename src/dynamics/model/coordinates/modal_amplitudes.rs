//! Largest displacement and turn of any section of a girder by a unit of each of its modes, and the bounds that follow.

use std::ops::Range;

use crate::dynamics::model::section_bounds::SectionBounds;

/// Of each mode the largest displacement \[m\] and turn \[rad\] of a section by a unit of its coordinate.
#[derive(Clone, Debug)]
pub(super) struct ModalAmplitudes(Vec<[f64; 2]>);

impl ModalAmplitudes {
    /// Zero amplitudes of `count` modes.
    pub(super) fn of_modes(count: usize) -> Self {
        Self(vec![[0.0; 2]; count])
    }

    /// Raises them to those of a section where these are larger.
    pub(super) fn widen(&mut self, section: impl Iterator<Item = [f64; 2]>) {
        for (most, own) in self.0.iter_mut().zip(section) {
            *most = [0, 1].map(|i| most[i].max(own[i]));
        }
    }

    /// Bound on the displacement by the modes of a point at `arm` \[m\] from where a section turns \[m\]; the coordinates of the modes begin
    /// with component `first` of a state and change by `way` of a range of components.
    pub(super) fn excursion(&self, first: usize, arm: f64, way: &dyn Fn(Range<usize>) -> f64) -> f64 {
        let modal = |(j, [moved, turned]): (usize, &[f64; 2])| (moved + arm * turned) * way(first + j..first + j + 1);
        self.0.iter().enumerate().map(modal).sum()
    }

    /// Adds the rates and second derivatives of the modes, of which `rates` of a range of components are bounds, to the bounds of a section.
    pub(super) fn add_to(&self, section: &mut SectionBounds, first: usize, rates: &dyn Fn(Range<usize>) -> [f64; 2]) {
        for (j, [moved, turned]) in self.0.iter().enumerate() {
            let [rate, gain] = rates(first + j..first + j + 1);
            section.moved[0] += moved * rate;
            section.moved[1] += moved * gain;
            section.turned[0] += turned * rate;
            section.turned[1] += turned * gain;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_sums_over_the_modes_of_the_widest_section() {
        let mut amplitudes = ModalAmplitudes::of_modes(2);
        amplitudes.widen([[1.0, 0.5], [0.2, 4.0]].into_iter());
        amplitudes.widen([[0.5, 2.0], [3.0, 1.0]].into_iter());
        // (1 + 10 · 2) · 0.1 + (3 + 10 · 4) · 0.01, by components 3 and 4.
        let way = |range: Range<usize>| if range == (3..4) { 0.1 } else { 0.01 };
        assert!((amplitudes.excursion(3, 10.0, &way) - 2.53).abs() < 1e-15);
        let mut section = SectionBounds::default();
        amplitudes.add_to(&mut section, 3, &|range| if range == (3..4) { [1.0, 10.0] } else { [2.0, 20.0] });
        assert_eq!((section.moved, section.turned), ([7.0, 70.0], [10.0, 100.0]));
    }
}
