//! Sequence of states without the components that equal those at rest: of a girder hit head-on, motion along one axis
//! remains.

/// States in the order of entry, stored bit for bit.
#[derive(Clone, Debug, Default)]
pub struct PackedStates {
    /// Stored components of each state, lowest bit first.
    masks: Vec<u16>,
    /// Offset in `numbers` of every [`MASKS_PER_OFFSET`]-th state; the masks between them give the others.
    places: Vec<u32>,
    numbers: Vec<f64>,
}

/// States between two stored offsets; the masks between them are counted. Tuned: half a byte of offset per state.
const MASKS_PER_OFFSET: usize = 8;
/// Largest number of components of a state, the bits of a mask.
const MOST_COMPONENTS: usize = 16;
/// Components that are not stored: those of a body at rest as placed. The seventh of a state with a quaternion is w =
/// 1.
const REST_STATE: [f64; MOST_COMPONENTS] = {
    let mut rest = [0.0; MOST_COMPONENTS];
    rest[6] = 1.0;
    rest
};

impl PackedStates {
    /// Whether states of this many components can be stored.
    pub fn fits(width: usize) -> bool {
        width <= MOST_COMPONENTS
    }

    /// Adds a state that [`fits`](Self::fits); its number, `None` where numbers are exhausted.
    pub fn push(&mut self, state: &[f64]) -> Option<u32> {
        debug_assert!(Self::fits(state.len()), "a mask has no bit for every component");
        let number = u32::try_from(self.masks.len()).ok()?;
        let at = u32::try_from(self.numbers.len()).ok()?;
        // Compared by bits, so that −0 is stored.
        let moved = state.iter().zip(REST_STATE).enumerate().filter(|(_, (x, rest))| x.to_bits() != rest.to_bits());
        let mask = moved.clone().fold(0, |mask, (i, _)| mask | 1 << i);
        self.numbers.extend(moved.map(|(_, (x, _))| x));
        if self.masks.len().is_multiple_of(MASKS_PER_OFFSET) {
            self.places.push(at);
        }
        self.masks.push(mask);
        Some(number)
    }

    /// Reserves memory for exactly one more state.
    pub fn reserve_one(&mut self) {
        self.masks.reserve_exact(1);
        self.places.reserve_exact(1);
    }

    /// Number of states.
    pub fn len(&self) -> usize {
        self.masks.len()
    }

    /// Whether there are no states.
    pub fn is_empty(&self) -> bool {
        self.masks.is_empty()
    }

    /// Writes a state to `out`.
    pub fn read(&self, number: u32, out: &mut [f64]) {
        let number = number as usize;
        let (mask, first) = (self.masks[number], number / MASKS_PER_OFFSET);
        let before =
            self.masks[first * MASKS_PER_OFFSET..number].iter().map(|mask| mask.count_ones() as usize).sum::<usize>();
        let mut numbers = self.numbers[self.places[first] as usize + before..].iter();
        for ((i, x), rest) in out.iter_mut().enumerate().zip(REST_STATE) {
            *x = if mask & 1 << i == 0 { rest } else { numbers.next().copied().unwrap_or(rest) };
        }
    }

    /// A state of `N` components.
    pub fn get<const N: usize>(&self, number: u32) -> [f64; N] {
        let mut state = [0.0; N];
        self.read(number, &mut state);
        state
    }

    /// Memory of the states \[bytes\].
    pub fn bytes(&self) -> usize {
        self.masks.len() * size_of::<u16>()
            + self.places.len() * size_of::<u32>()
            + self.numbers.len() * size_of::<f64>()
    }

    /// Releases reserved memory.
    pub fn shrink(&mut self) {
        self.masks.shrink_to_fit();
        self.places.shrink_to_fit();
        self.numbers.shrink_to_fit();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_come_back_bit_for_bit_and_rest_takes_nothing() {
        let few = [[0.0; 6], [1.0, 0.0, -0.0, 2.0, 0.0, 0.0], [1.0, 2.0, 3.0, 4.0, 5.0, f64::MIN_POSITIVE]];
        let states = [few, few, few, few, few, few].concat();
        let mut packed = PackedStates::default();
        let numbers: Vec<u32> = states.iter().map(|state| packed.push(state).expect("few")).collect();
        for (state, number) in states.iter().zip(numbers) {
            assert_eq!(state.map(f64::to_bits), packed.get::<6>(number).map(f64::to_bits), "state {number}");
        }
        assert_eq!(packed.bytes(), 18 * 2 + 3 * 4 + 6 * 9 * 8, "nine numbers of three states are not 0");
        let mut turned = PackedStates::default();
        let states = [REST_STATE[..7].to_vec(), vec![0.0; 7], [&REST_STATE[..7], &[0.5; 6]].concat()];
        for (number, state) in (0..).zip(&states) {
            assert_eq!(turned.push(state), Some(number));
        }
        let mut out = [9.0; 13];
        for (number, state) in (0..).zip(&states) {
            turned.read(number, &mut out[..state.len()]);
            assert_eq!(out[..state.len()], state[..], "state {number}");
        }
        assert_eq!(turned.numbers.len(), 7, "a w of 0 and six speeds");
    }
}
