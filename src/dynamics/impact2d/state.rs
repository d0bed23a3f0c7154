//! The six states of a girder, a–f (Fig. 13).

/// State of a girder.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum GirderState {
    /// a) 並進回転: free, turning.
    FreeTurning,
    /// b) 並進: free, not turning.
    Free,
    /// c) 接触滑り回転: a corner slides along the wall, the girder turns.
    SlidingTurning,
    /// d) 接触回転: the girder turns about a corner that stays put.
    Turning,
    /// e) 接触滑り: the face lies on the wall and slides.
    Sliding,
    /// f) 接触静止: the face lies on the wall, at rest.
    Resting,
}

impl GirderState {
    /// All, a to f.
    pub const ALL: [Self; 6] =
        [Self::FreeTurning, Self::Free, Self::SlidingTurning, Self::Turning, Self::Sliding, Self::Resting];

    /// The paper's letter.
    pub fn letter(self) -> char {
        match self {
            Self::FreeTurning => 'a',
            Self::Free => 'b',
            Self::SlidingTurning => 'c',
            Self::Turning => 'd',
            Self::Sliding => 'e',
            Self::Resting => 'f',
        }
    }

    /// In words.
    pub fn label(self) -> &'static str {
        match self {
            Self::FreeTurning => "free, turning",
            Self::Free => "free",
            Self::SlidingTurning => "contact, sliding and turning",
            Self::Turning => "contact, turning",
            Self::Sliding => "contact, sliding",
            Self::Resting => "contact, resting",
        }
    }

    /// The paper's own name (Fig. 13).
    pub fn paper(self) -> &'static str {
        match self {
            Self::FreeTurning => "並進回転",
            Self::Free => "並進",
            Self::SlidingTurning => "接触滑り回転",
            Self::Turning => "接触回転",
            Self::Sliding => "接触滑り",
            Self::Resting => "接触静止",
        }
    }

    /// Whether the girder is in lasting contact.
    pub fn touches(self) -> bool {
        !matches!(self, Self::FreeTurning | Self::Free)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_run_from_a_to_f_and_contact_begins_at_c() {
        let letters: String = GirderState::ALL.iter().map(|state| state.letter()).collect();
        assert_eq!(letters, "abcdef", "the paper's order");
        let touching: String = GirderState::ALL.iter().filter(|s| s.touches()).map(|state| state.letter()).collect();
        assert_eq!(touching, "cdef", "states with lasting contact");
    }
}
