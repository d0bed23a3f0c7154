//! The six states of Fig. 13 and the rows of Tables 4–10 that lead from one to another.

/// What a girder does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum State {
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

impl State {
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

/// A row of the paper's Tables 4–10, counted from 1 from above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Row {
    /// The table, 4 to 10.
    pub table: u8,
    /// The row.
    pub row: u8,
}

/// How a hit left the point that decides: the corner hit, or the end of the face that the rotation drives in most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum After {
    /// It flies off, `ẋ0' < 0` in the paper's axes.
    Free,
    /// Its normal velocity is 0; whether its tangential one is.
    Contact {
        /// `ẏ0' = 0`.
        still: bool,
    },
    /// It was driven in again and got a second impulse; whether that held it.
    Again {
        /// `|Q_y'| ≤ μ_s Q_x'`.
        held: bool,
    },
}

/// What the rows for a hit ask about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landing {
    /// The state before.
    pub from: State,
    /// Whether the whole face hit, θ = 0.
    pub flush: bool,
    /// Whether the girder turns after the first impulse.
    pub turns: bool,
    /// Whether the centre of the face moves along the wall after the first impulse, `ẏ' ≠ 0`.
    pub slides: bool,
    /// `e_n` in force.
    pub e_n: f64,
    /// `e_t` in force.
    pub e_t: f64,
    /// How it ended.
    pub after: After,
}

impl Row {
    const fn of(table: u8, row: u8) -> Self {
        Self { table, row }
    }

    /// The row for a change without a hit (Tables 4–7): from a state in contact to another.
    pub fn between(from: State, to: State) -> Option<Self> {
        let table = match from {
            State::SlidingTurning => 4,
            State::Turning => 5,
            State::Sliding => 6,
            State::Resting => 7,
            State::Free | State::FreeTurning => return None,
        };
        let order =
            [State::Resting, State::Sliding, State::Turning, State::SlidingTurning, State::Free, State::FreeTurning];
        let row = order.iter().position(|state| *state == to);
        // A face that lies on the wall does not turn as it leaves: one row for both ways of being free.
        let last = if table >= 6 { 5 } else { 6 };
        let number = u8::try_from(row?).ok()? + 1;
        Some(Self::of(table, number.min(last)))
    }

    /// The row for a hit (Tables 8–10); none for hits that the paper's tables do not know: a resting face pushed, a corner
    /// hit while another end is in contact.
    pub fn landing(l: &Landing) -> Option<Self> {
        match (l.from, l.flush) {
            (State::FreeTurning | State::Free, false) => Some(Self::of(8, corner(l.after))),
            (State::FreeTurning, true) => Some(Self::of(8, 5 + face(l))),
            (State::Free, true) => Some(Self::of(9, translation(l))),
            (State::SlidingTurning | State::Turning, true) => Some(Self::of(10, face(l))),
            _ => None,
        }
    }

    /// The conditions of the row as the paper prints them, signs as settled: `ẋ0'` towards the wall, `R` in compression.
    pub fn conditions(self) -> &'static str {
        let table = match self.table {
            4 => &TABLE_4[..],
            5 => &TABLE_5,
            6 => &TABLE_6,
            7 => &TABLE_7,
            8 => &TABLE_8,
            9 => &TABLE_9,
            10 => &TABLE_10,
            _ => &[],
        };
        usize::from(self.row).checked_sub(1).and_then(|i| table.get(i)).copied().unwrap_or("")
    }

    /// `Table 8, row 4`.
    pub fn label(self) -> String {
        format!("Table {}, row {}", self.table, self.row)
    }
}

/// Rows 1–5 of Table 8.
fn corner(after: After) -> u8 {
    match after {
        After::Free => 1,
        After::Contact { still: true } => 2,
        After::Contact { still: false } => 3,
        After::Again { held: true } => 4,
        After::Again { held: false } => 5,
    }
}

/// Rows 6–11 of Table 8, less 5; rows of Table 10.
fn face(l: &Landing) -> u8 {
    match l.after {
        After::Free if !l.turns => 1,
        After::Free => 2,
        After::Contact { still: true } => 3,
        After::Contact { still: false } => 4,
        After::Again { held: true } => 5,
        After::Again { held: false } => 6,
    }
}

/// Rows of Table 9.
fn translation(l: &Landing) -> u8 {
    // Translation stays translation only where the impulse does not turn the girder.
    if !l.turns && (!l.slides || l.e_t == -1.0) {
        return if l.slides { 3 } else { 1 } + u8::from(l.e_n != 0.0);
    }
    match l.after {
        After::Free => 5,
        After::Contact { still: true } => 6,
        After::Contact { still: false } => 7,
        After::Again { held: true } => 8,
        After::Again { held: false } => 9,
    }
}

const TABLE_4: [&str; 6] = [
    "ẏ0 = 0, θ = 0, θ̇ = 0, R_x ≥ 0",
    "ẏ0 ≠ 0, θ = 0, θ̇ = 0, R_x ≥ 0",
    "ẏ0 = 0, |θ| < π/2, R_x ≥ 0",
    "ẏ0 ≠ 0, |θ| < π/2, R_x ≥ 0",
    "θ = 0, θ̇ = 0, R_x < 0",
    "|θ| < π/2, R_x < 0",
];
const TABLE_5: [&str; 6] = [
    "θ = 0, θ̇ = 0, R_x ≥ 0, |R_y| ≤ μ̄_s R_x",
    "θ = 0, θ̇ = 0, R_x ≥ 0, |R_y| > μ̄_s R_x",
    "|θ| < π/2, R_x ≥ 0, |R_y| ≤ μ̄_s R_x",
    "|θ| < π/2, R_x ≥ 0, |R_y| > μ̄_s R_x",
    "θ = 0, θ̇ = 0, R_x < 0",
    "|θ| < π/2, R_x < 0",
];
const TABLE_6: [&str; 5] = [
    "ẏ = 0, a|R_y| ≤ b R_x, R_x ≥ 0",
    "ẏ ≠ 0, a|R_y| ≤ b R_x, R_x ≥ 0",
    "ẏ = 0, a|R_y| > b R_x, R_x ≥ 0",
    "ẏ ≠ 0, a|R_y| > b R_x, R_x ≥ 0",
    "R_x < 0",
];
const TABLE_7: [&str; 5] = [
    "|R_y| ≤ μ_s R_x, a|R_y| ≤ b R_x, R_x ≥ 0",
    "|R_y| > μ_s R_x, μ_k < b/a, R_x ≥ 0",
    "|R_y| ≤ μ_s R_x, a|R_y| > b R_x, R_x ≥ 0",
    "|R_y| > μ_s R_x, μ_k ≥ b/a, R_x ≥ 0",
    "R_x < 0",
];
const TABLE_8: [&str; 11] = [
    "θ ≠ 0, ẋ0' < 0",
    "θ ≠ 0, ẋ0' = 0, ẏ0' = 0",
    "θ ≠ 0, ẋ0' = 0, ẏ0' ≠ 0",
    "θ ≠ 0, ẋ0' > 0, |Q_y'| ≤ μ̄_s Q_x'",
    "θ ≠ 0, ẋ0' > 0, |Q_y'| > μ̄_s Q_x'",
    "θ = 0, ẋ0' < 0, θ̇' = 0",
    "θ = 0, ẋ0' < 0, θ̇' ≠ 0",
    "θ = 0, ẋ0' = 0, ẏ0' = 0",
    "θ = 0, ẋ0' = 0, ẏ0' ≠ 0",
    "θ = 0, ẋ0' > 0, |Q_y'| ≤ μ̄_s Q_x'",
    "θ = 0, ẋ0' > 0, |Q_y'| > μ̄_s Q_x'",
];
const TABLE_9: [&str; 9] = [
    "ẏ' = 0, e_x = 0",
    "ẏ' = 0, e_x ≠ 0",
    "ẏ' ≠ 0, e_y = −1, e_x = 0",
    "ẏ' ≠ 0, e_y = −1, e_x ≠ 0",
    "ẏ' ≠ 0, e_y ≠ −1, ẋ0' < 0",
    "ẏ' ≠ 0, e_y ≠ −1, ẋ0' = 0, ẏ0' = 0",
    "ẏ' ≠ 0, e_y ≠ −1, ẋ0' = 0, ẏ0' ≠ 0",
    "ẏ' ≠ 0, e_y ≠ −1, ẋ0' > 0, |Q_y'| ≤ μ̄_s Q_x'",
    "ẏ' ≠ 0, e_y ≠ −1, ẋ0' > 0, |Q_y'| > μ̄_s Q_x'",
];
const TABLE_10: [&str; 6] = [
    "ẋ0' < 0, θ̇' = 0",
    "ẋ0' < 0, θ̇' ≠ 0",
    "ẋ0' = 0, ẏ0' = 0",
    "ẋ0' = 0, ẏ0' ≠ 0",
    "ẋ0' > 0, |Q_y'| ≤ μ̄_s Q_x'",
    "ẋ0' > 0, |Q_y'| > μ̄_s Q_x'",
];
