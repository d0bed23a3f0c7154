//! Rows of the paper's Tables 4–10: which change of state happened, under which conditions.
//!
//! The tables name a change after the fact. What decides it is [`mode_selection`](super::lasting::mode_selection) without a
//! hit and [`collision`](super::impulse::collision) with one.

use crate::dynamics::impact2d::state::GirderState;

/// A row of the paper's Tables 4–10, counted from 1 from above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Row {
    /// The table, 4 to 10.
    pub table: u8,
    /// The row.
    pub row: u8,
}

/// Velocity after the first impulse at the point that decides the row: the corner hit, or the end of the face that the
/// rotation drives in most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It separates, `ẋ0' < 0` in the paper's axes.
    Separates,
    /// Its normal velocity is 0.
    Contact {
        /// Whether its tangential velocity is 0 too, `ẏ0' = 0`.
        at_rest: bool,
    },
    /// It approaches again and takes a second impulse.
    SecondImpulse {
        /// Whether that holds it, `|Q_y'| ≤ μ_s Q_x'`.
        held: bool,
    },
}

/// Conditions of the rows for a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HitConditions {
    /// The state before.
    pub from: GirderState,
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
    /// Outcome at the point that decides.
    pub outcome: Outcome,
}

impl Row {
    const fn of(table: u8, row: u8) -> Self {
        Self { table, row }
    }

    /// The row for a change without a hit (Tables 4–7): from a state in contact to another.
    pub fn without_hit(from: GirderState, to: GirderState) -> Option<Self> {
        let table = match from {
            GirderState::SlidingTurning => 4,
            GirderState::Turning => 5,
            GirderState::Sliding => 6,
            GirderState::Resting => 7,
            GirderState::Free | GirderState::FreeTurning => return None,
        };
        let order = [
            GirderState::Resting,
            GirderState::Sliding,
            GirderState::Turning,
            GirderState::SlidingTurning,
            GirderState::Free,
            GirderState::FreeTurning,
        ];
        let row = order.iter().position(|state| *state == to);
        // A flush face does not turn as it leaves: states a and b share the last row of Tables 6 and 7.
        let last = if table >= 6 { 5 } else { 6 };
        let number = u8::try_from(row?).ok()? + 1;
        Some(Self::of(table, number.min(last)))
    }

    /// The row for a hit (Tables 8–10); none for hits that the tables do not cover: on a resting face, or at a corner while
    /// another end is in contact.
    pub fn of_hit(l: &HitConditions) -> Option<Self> {
        match (l.from, l.flush) {
            (GirderState::FreeTurning | GirderState::Free, false) => Some(Self::of(8, corner(l.outcome))),
            (GirderState::FreeTurning, true) => Some(Self::of(8, 5 + face(l))),
            (GirderState::Free, true) => Some(Self::of(9, translation(l))),
            (GirderState::SlidingTurning | GirderState::Turning, true) => Some(Self::of(10, face(l))),
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
fn corner(outcome: Outcome) -> u8 {
    match outcome {
        Outcome::Separates => 1,
        Outcome::Contact { at_rest: true } => 2,
        Outcome::Contact { at_rest: false } => 3,
        Outcome::SecondImpulse { held: true } => 4,
        Outcome::SecondImpulse { held: false } => 5,
    }
}

/// Rows 6–11 of Table 8, less 5; rows of Table 10.
fn face(l: &HitConditions) -> u8 {
    match l.outcome {
        Outcome::Separates if !l.turns => 1,
        Outcome::Separates => 2,
        Outcome::Contact { at_rest: true } => 3,
        Outcome::Contact { at_rest: false } => 4,
        Outcome::SecondImpulse { held: true } => 5,
        Outcome::SecondImpulse { held: false } => 6,
    }
}

/// Rows of Table 9.
fn translation(l: &HitConditions) -> u8 {
    // Translation stays translation only where the impulse does not turn the girder.
    if !l.turns && (!l.slides || l.e_t == -1.0) {
        return if l.slides { 3 } else { 1 } + u8::from(l.e_n != 0.0);
    }
    match l.outcome {
        Outcome::Separates => 5,
        Outcome::Contact { at_rest: true } => 6,
        Outcome::Contact { at_rest: false } => 7,
        Outcome::SecondImpulse { held: true } => 8,
        Outcome::SecondImpulse { held: false } => 9,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_has_its_conditions_and_no_other_number_has() {
        for (table, rows) in [(4, 6), (5, 6), (6, 5), (7, 5), (8, 11), (9, 9), (10, 6)] {
            let filled = |row: u8| !Row { table, row }.conditions().is_empty();
            assert!((1..=rows).all(filled), "Table {table} has {rows} rows");
            assert!(!filled(0) && !filled(rows + 1), "and no more");
        }
        assert_eq!(Row { table: 3, row: 1 }.conditions(), "", "no such table");
    }

    #[test]
    fn changes_without_a_hit_start_in_contact() {
        assert_eq!(Row::without_hit(GirderState::Free, GirderState::Resting), None, "a flight ends with a hit");
        assert_eq!(
            Row::without_hit(GirderState::SlidingTurning, GirderState::FreeTurning),
            Some(Row::of(4, 6)),
            "last of six"
        );
        assert_eq!(
            Row::without_hit(GirderState::Resting, GirderState::FreeTurning),
            Some(Row::of(7, 5)),
            "last of five"
        );
    }

    #[test]
    fn hits_that_the_tables_do_not_cover_have_no_row() {
        let outcome = Outcome::Separates;
        let hit = HitConditions {
            from: GirderState::Resting,
            flush: true,
            turns: true,
            slides: true,
            e_n: 0.4,
            e_t: 0.0,
            outcome,
        };
        assert_eq!(Row::of_hit(&hit), None, "a face that lies on the wall");
        assert_eq!(
            Row::of_hit(&HitConditions { from: GirderState::Turning, flush: false, ..hit }),
            None,
            "a second corner"
        );
        assert_eq!(
            Row::of_hit(&HitConditions { from: GirderState::Turning, ..hit }),
            Some(Row::of(10, 2)),
            "a landing face"
        );
    }
}
