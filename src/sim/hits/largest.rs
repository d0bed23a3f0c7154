//! Hits of a run in numbers: the largest force and impulse, how many hits, how long contacts are closed, and which pairs to list.

use std::collections::BTreeMap;

use super::view::Hits;
use crate::sim::Touch;

/// Times that contacts are closed, summed over contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactTimes {
    /// In stick \[s\].
    pub stick: f64,
    /// In slip \[s\].
    pub slip: f64,
}

impl Hits<'_> {
    /// Largest |`R_k`| of any contact \[N\].
    pub fn largest_force(self) -> f64 {
        self.touches().iter().map(|touch| touch.peak_force).fold(0.0, f64::max)
    }

    /// Largest impulse of a hit; none under the contact model \[N·s\].
    pub fn largest_impulse(self) -> Option<f64> {
        self.history.impact().map(|_| self.touches().iter().map(|touch| touch.impulse).fold(0.0, f64::max))
    }

    /// Hits: touches of a pair, from its first contact closing to its last opening.
    pub fn count(self) -> usize {
        count(self.touches())
    }

    /// Contact times in stick and in slip, summed over contacts.
    pub fn contact_times(self) -> ContactTimes {
        let add = |sum: ContactTimes, touch: &Touch| ContactTimes {
            stick: sum.stick + touch.stick,
            slip: sum.slip + touch.slip,
        };
        self.touches().iter().fold(ContactTimes::default(), add)
    }

    /// Numbers of the pairs that are listed, in order: those that face each other or are declared, and of those between other
    /// faces of bodies that met the ones that touched.
    pub fn listed_pairs(self) -> Vec<usize> {
        let pairs = &self.history.model().pairs;
        let mut touched = vec![false; pairs.len()];
        if pairs.iter().any(|pair| pair.met) {
            self.touches().iter().for_each(|touch| touched[touch.pair] = true);
        }
        (0..pairs.len()).filter(|&number| !pairs[number].met || touched[number]).collect()
    }
}

/// Touches of pairs: contacts of one pair whose touches overlap in time are one hit.
fn count(touches: &[Touch]) -> usize {
    let mut until: BTreeMap<usize, f64> = BTreeMap::new();
    let mut count = 0;
    for touch in touches {
        let end = until.entry(touch.pair).or_insert(f64::NEG_INFINITY);
        if touch.start > *end {
            count += 1;
        }
        *end = end.max(touch.end);
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn touches_of_one_pair_that_overlap_are_one_hit() {
        let touch = |pair, start, end| Touch {
            pair,
            contact: 0,
            start,
            end,
            peak_time: start,
            peak_force: 1.0,
            impulse: 0.0,
            stick: 0.0,
            slip: 0.0,
        };
        let first = [touch(0, 0.0, 1.0), touch(0, 0.5, 2.0)];
        assert_eq!(count(&first), 1, "they overlap");
        assert_eq!(count(&[first[0], first[1], touch(0, 2.0, 2.5)]), 1, "one begins as the other ends");
        assert_eq!(count(&[first[0], first[1], touch(0, 2.1, 2.5)]), 2, "apart in between");
        assert_eq!(count(&[first[0], touch(1, 0.5, 2.0)]), 2, "of two pairs");
    }
}
