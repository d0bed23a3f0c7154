//! The window itself: its dialogs, its notice, whether it is about to close.

use crate::app::command::RowDraft;

/// Whether the window is about to close.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::app) enum Closing {
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
pub(in crate::app) struct WindowState {
    /// Whether the help is open.
    pub(in crate::app) help: bool,
    /// The row that is asked for, while its dialog is open.
    pub(in crate::app) row: Option<RowDraft>,
    /// What has happened, until it has been read.
    pub(in crate::app) notice: Option<String>,
    closing: Closing,
}

impl WindowState {
    /// Whether the window is about to close.
    pub(in crate::app) fn closing(&self) -> Closing {
        self.closing
    }

    /// Shows a notice.
    pub(in crate::app) fn say(&mut self, words: impl Into<String>) {
        self.notice = Some(words.into());
    }

    /// Shows why something failed.
    pub(in crate::app) fn say_failure<E: std::fmt::Display>(&mut self, done: Result<(), E>) {
        if let Err(problem) = done {
            self.say(problem.to_string());
        }
    }

    /// Closes, or asks first when something is not saved; `true` when it closes now.
    pub(in crate::app) fn close(&mut self, dirty: bool) -> bool {
        self.closing = if dirty { Closing::Asking } else { Closing::Now };
        !dirty
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
        assert!(!window.close(true) && window.closing() == Closing::Asking, "asked first");
        window.begin_saving();
        window.saved();
        assert_eq!(window.closing(), Closing::Now, "saved, then closed");
    }

    #[test]
    fn saving_alone_closes_nothing() {
        let mut window = WindowState::default();
        window.begin_saving();
        window.saved();
        assert_eq!(window.closing(), Closing::Open, "only saved");
        window.close(true);
        window.stay_open();
        window.saved();
        assert_eq!(window.closing(), Closing::Open, "kept open");
        assert!(window.close(false), "nothing to lose");
    }
}
