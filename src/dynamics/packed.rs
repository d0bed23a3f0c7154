//! States in a row, without the components that are 0: a girder hit head-on moves along one axis and never turns.

/// States in the order they were put in, bit for bit.
#[derive(Clone, Debug, Default)]
pub struct Packed {
    /// Which components of a state are kept, lowest bit first.
    masks: Vec<u16>,
    /// Where they begin.
    places: Vec<u32>,
    numbers: Vec<f64>,
}

/// Bytes of a state beside its numbers.
const ENTRY: usize = size_of::<u16>() + size_of::<u32>();

impl Packed {
    /// Puts a state of at most 16 components in; its number. Nothing where more numbers are kept than can be counted.
    pub fn push(&mut self, state: &[f64]) -> Option<u32> {
        let number = u32::try_from(self.masks.len()).ok()?;
        let at = u32::try_from(self.numbers.len()).ok()?;
        // By its bits: −0 is kept.
        let kept = |i: &usize| state[*i].to_bits() != 0;
        let mask = (0..state.len()).filter(kept).fold(0, |mask, i| mask | 1 << i);
        self.numbers.extend(state.iter().filter(|x| x.to_bits() != 0));
        self.masks.push(mask);
        self.places.push(at);
        Some(number)
    }

    /// Makes room for one state, exactly.
    pub fn reserve_one(&mut self) {
        self.masks.reserve_exact(1);
        self.places.reserve_exact(1);
    }

    /// How many states there are.
    pub fn len(&self) -> usize {
        self.masks.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.masks.is_empty()
    }

    /// A state, written to `out`.
    pub fn read(&self, number: u32, out: &mut [f64]) {
        let mask = self.masks[number as usize];
        let mut numbers = self.numbers[self.places[number as usize] as usize..].iter();
        for (i, x) in out.iter_mut().enumerate() {
            *x = if mask & 1 << i == 0 { 0.0 } else { numbers.next().copied().unwrap_or(0.0) };
        }
    }

    /// A state of so many components.
    pub fn get<const N: usize>(&self, number: u32) -> [f64; N] {
        let mut state = [0.0; N];
        self.read(number, &mut state);
        state
    }

    /// What it takes \[bytes\].
    pub fn bytes(&self) -> usize {
        self.masks.len() * ENTRY + self.numbers.len() * size_of::<f64>()
    }

    /// Gives back the memory that more states would have taken.
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
    fn states_come_back_bit_for_bit_and_zeros_take_nothing() {
        let states = [[0.0; 6], [1.0, 0.0, -0.0, 2.0, 0.0, 0.0], [1.0, 2.0, 3.0, 4.0, 5.0, f64::MIN_POSITIVE]];
        let mut packed = Packed::default();
        let numbers: Vec<u32> = states.iter().map(|state| packed.push(state).expect("few")).collect();
        for (state, number) in states.iter().zip(numbers) {
            assert_eq!(state.map(f64::to_bits), packed.get::<6>(number).map(f64::to_bits), "state {number}");
        }
        assert_eq!(packed.bytes(), 3 * ENTRY + 9 * 8, "nine numbers are not 0");
    }
}
