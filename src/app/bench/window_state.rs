//! The window itself: its dialogs, its notice, whether it is about to close.

use std::path::Path;

use crate::app::command::{RowDraft, WindowCommand};
use crate::app::host::Told;

/// Whether the window is about to close.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Closing {
    /// No.
    #[default]
    Open,
    /// Something is not saved: the user is asked.
    Asking,
    /// It is being saved first.
    Saving,
    /// Yes.
    Now,
}

/// Dialogs, notice, closing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WindowState {
    /// Whether the help is open.
    pub help: bool,
    /// The row that is asked for, while its dialog is open.
    pub(in crate::app) row: Option<RowDraft>,
    notice: Option<Told>,
    closing: Closing,
}

impl WindowState {
    /// Whether the window is to close now.
    pub fn closes(&self) -> bool {
        self.closing == Closing::Now
    }

    /// Whether the question about unsaved changes is open.
    pub fn asks(&self) -> bool {
        self.closing == Closing::Asking
    }

    /// What has happened, until it has been read.
    pub fn notice(&self) -> Option<&str> {
        self.notice.as_ref().map(|told| told.words.as_str())
    }

    /// The file or folder that it is about.
    pub(in crate::app) fn place(&self) -> Option<&Path> {
        self.notice.as_ref()?.place.as_deref()
    }

    /// Does a command; `dirty` tells whether something is not saved. `true` when the window closes now.
    pub(super) fn apply(&mut self, command: WindowCommand, dirty: bool) -> bool {
        match command {
            // The context of egui keeps theme and size, the runner the run.
            WindowCommand::Theme(_) | WindowCommand::Scale(_) | WindowCommand::CancelRun => {}
            WindowCommand::Help(open) => self.help = open,
            WindowCommand::AskRow(draft) => self.row = draft,
            WindowCommand::Dismiss => self.notice = None,
            WindowCommand::Close => self.closing = if dirty { Closing::Asking } else { Closing::Now },
            WindowCommand::CloseAnyway => self.closing = Closing::Now,
            WindowCommand::KeepOpen => self.closing = Closing::Open,
        }
        self.closes()
    }

    /// Shows a notice.
    pub(in crate::app) fn say(&mut self, words: impl Into<Told>) {
        self.notice = Some(words.into());
    }

    /// Shows why something failed.
    pub(in crate::app) fn say_failure<T, E: std::fmt::Display>(&mut self, done: Result<T, E>) {
        if let Err(problem) = done {
            self.say(problem.to_string());
        }
    }

    /// Does not close after all.
    pub(in crate::app) fn stay_open(&mut self) {
        self.closing = Closing::Open;
    }

    /// The user is asked where to save; a window that asked whether to close waits for it.
    pub(in crate::app) fn begin_saving(&mut self) {
        if self.closing == Closing::Asking {
            self.closing = Closing::Saving;
        }
    }

    /// The scene has been saved: a window that waited for it closes.
    pub(in crate::app) fn saved(&mut self) {
        if matches!(self.closing, Closing::Asking | Closing::Saving) {
            self.closing = Closing::Now;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unsaved_work_is_asked_about_and_saving_it_closes_the_window() {
        let mut window = WindowState::default();
        assert!(!window.apply(WindowCommand::Close, true), "asked first");
        window.begin_saving();
        window.saved();
        assert!(window.closes(), "saved, then closed");
    }

    #[test]
    fn saving_alone_closes_nothing() {
        let mut window = WindowState::default();
        window.begin_saving();
        window.saved();
        assert!(!window.closes() && !window.asks(), "only saved");
        window.apply(WindowCommand::Close, true);
        window.apply(WindowCommand::KeepOpen, true);
        window.saved();
        assert!(!window.closes() && !window.asks(), "kept open");
        assert!(window.apply(WindowCommand::Close, false), "nothing to lose");
    }
}
