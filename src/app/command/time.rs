//! Commands about the time of the answer that is shown.

/// Which way to go in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Later.
    Forward,
    /// Earlier.
    Back,
}

/// Playing, seeking, and the stretch of time that is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimeCommand {
    /// Play or pause.
    TogglePlay,
    /// Move the playhead by so many steps.
    Step(f64),
    /// To the next event, or the one before.
    StepEvent(Way),
    /// To a time \[s\].
    Seek(f64),
    /// To a time that a reading names, and stand there \[s\].
    StandAt(f64),
    /// Playing speed \[s of the answer per s\].
    Speed(f64),
    /// The next faster (+1) or slower (−1) playing speed.
    StepSpeed(i32),
    /// Begin again at the end, or not.
    Loop(bool),
    /// Play only a stretch, or everything \[s\].
    PlaySpan(Option<[f64; 2]>),
    /// Begin the stretch that is played at the time shown.
    SpanFrom,
    /// End it there.
    SpanTo,
    /// Slow down around hits, or not.
    SlowAtHits(bool),
    /// Show a stretch of time in the timeline and the plots \[s\].
    Window(Option<[f64; 2]>),
}
