//! Commands about lessons.

/// Lessons: scenes with words and things to try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LearnCommand {
    /// Open the lesson of this number.
    Open(usize),
    /// Do the thing to try of this number.
    Try(usize),
    /// Put the lesson's scene back.
    Reset,
    /// Close the words; the scene stays.
    Close,
}
