//! The window itself: its dialogs, its notice, whether it is about to close.

use std::path::Path;

use super::folds::Folds;
use crate::app::command::{BridgeDraft, FileCommand, LearnCommand, LeaveCommand, RowDraft, WindowCommand};
use crate::app::host::Told;
use crate::language::Language;

/// Command that would leave the scene in work.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) enum Next {
    /// The window closes.
    Close,
    /// Another scene is opened.
    File(FileCommand),
    /// A lesson is opened.
    Learn(LearnCommand),
}

/// Whether the scene that is worked on is about to be left.
#[derive(Clone, Debug, Default, PartialEq)]
enum Leaving {
    /// No.
    #[default]
    Not,
    /// Something is not saved: the user is asked.
    Asking(Next),
    /// It is being saved first.
    Saving(Next),
    /// The window closes now.
    Closed,
}

/// Dialogs, notice, closing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WindowState {
    /// Whether the help is open.
    pub help: bool,
    /// The language of its words.
    pub language: Language,
    /// The row that is asked for, while its dialog is open.
    pub(in crate::app) row: Option<RowDraft>,
    /// Numbers that a new bridge begins with.
    pub(in crate::app) bridge: BridgeDraft,
    /// Which panels are folded.
    pub(in crate::app) folds: Folds,
    notice: Option<Told>,
    /// How many notices there have been: the same words told again are another one.
    notices: u64,
    leaving: Leaving,
}

impl WindowState {
    /// Whether the window is to close now.
    pub fn closes(&self) -> bool {
        self.leaving == Leaving::Closed
    }

    /// Whether the question about unsaved changes is open.
    pub fn asks(&self) -> bool {
        self.asked_before().is_some()
    }

    /// Command that waits for the answer to the question about unsaved changes, while it is open.
    pub(in crate::app) fn asked_before(&self) -> Option<&Next> {
        if let Leaving::Asking(next) = &self.leaving { Some(next) } else { None }
    }

    /// Message, until it has been read.
    pub fn notice(&self) -> Option<&str> {
        self.notice.as_ref().map(|told| told.words.as_str())
    }

    /// Its number, for as long as it is there.
    pub(in crate::app) fn notice_number(&self) -> Option<u64> {
        self.notice.as_ref().map(|_| self.notices)
    }

    /// The file or folder that it is about.
    pub(in crate::app) fn place(&self) -> Option<&Path> {
        self.notice.as_ref()?.place.as_deref()
    }

    /// Does a command.
    pub(super) fn apply(&mut self, command: WindowCommand) {
        match command {
            WindowCommand::Help(open) => self.help = open,
            WindowCommand::AskRow(draft) => self.row = draft,
            WindowCommand::Bridge(draft) => self.bridge = draft,
            WindowCommand::Fold(pane, folded) => self.folds.set(pane, folded),
            WindowCommand::FoldAll(folded) => self.folds.set_all(folded),
            WindowCommand::Say(words) => self.say(words),
            WindowCommand::Dismiss => self.notice = None,
        }
    }

    /// Leaves the scene, or stays; `dirty` tells whether something is not saved. `true` when the window closes now.
    pub(super) fn leave(&mut self, command: LeaveCommand, dirty: bool) -> bool {
        match command {
            LeaveCommand::Close if dirty => self.ask_before(Next::Close),
            LeaveCommand::Close | LeaveCommand::CloseAnyway => self.leaving = Leaving::Closed,
            // What waited goes on by `go_on`.
            LeaveCommand::GiveUp => {}
            LeaveCommand::Stay => self.leaving = Leaving::Not,
        }
        self.closes()
    }

    /// Shows a notice.
    pub(in crate::app) fn say(&mut self, words: impl Into<Told>) {
        self.notice = Some(words.into());
        self.notices += 1;
    }

    /// Shows why something failed.
    pub(in crate::app) fn say_failure<T, E: std::fmt::Display>(&mut self, done: Result<T, E>) {
        if let Err(problem) = done {
            self.say(problem.to_string());
        }
    }

    /// Asks what becomes of unsaved work before something else is opened.
    pub(in crate::app) fn ask_before(&mut self, next: Next) {
        self.leaving = Leaving::Asking(next);
    }

    /// Stays with the scene after all.
    pub(in crate::app) fn stay_open(&mut self) {
        self.leaving = Leaving::Not;
    }

    /// The user is asked where to save; what was asked before waits for it.
    pub(in crate::app) fn begin_saving(&mut self) {
        if let Leaving::Asking(next) = std::mem::take(&mut self.leaving) {
            self.leaving = Leaving::Saving(next);
        }
    }

    /// The scene has been saved, or is given up: what waited for that, unless it is that the window closes now.
    pub(in crate::app) fn go_on(&mut self) -> Option<Next> {
        match std::mem::take(&mut self.leaving) {
            Leaving::Asking(Next::Close) | Leaving::Saving(Next::Close) | Leaving::Closed => {
                self.leaving = Leaving::Closed;
                None
            }
            Leaving::Asking(next) | Leaving::Saving(next) => Some(next),
            Leaving::Not => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unsaved_work_is_asked_about_and_saving_it_closes_the_window() {
        let mut window = WindowState::default();
        assert!(!window.leave(LeaveCommand::Close, true), "asked first");
        window.begin_saving();
        assert!(window.go_on().is_none() && window.closes(), "saved, then closed");
    }

    #[test]
    fn saving_alone_closes_nothing() {
        let mut window = WindowState::default();
        window.begin_saving();
        assert!(window.go_on().is_none() && !window.closes() && !window.asks(), "only saved");
        window.leave(LeaveCommand::Close, true);
        window.leave(LeaveCommand::Stay, true);
        assert!(window.go_on().is_none() && !window.closes() && !window.asks(), "kept open");
        assert!(window.leave(LeaveCommand::Close, false), "nothing to lose");
    }

    #[test]
    fn what_would_replace_unsaved_work_waits_until_it_is_saved() {
        let mut window = WindowState::default();
        window.ask_before(Next::Learn(LearnCommand::Open(1)));
        assert!(window.asks() && !window.closes(), "asked first");
        window.begin_saving();
        assert_eq!(window.go_on(), Some(Next::Learn(LearnCommand::Open(1))), "then the lesson");
        assert_eq!(window.go_on(), None, "once");
        window.ask_before(Next::File(FileCommand::New));
        window.stay_open();
        assert_eq!(window.go_on(), None, "stayed");
    }
}
