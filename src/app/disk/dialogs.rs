//! The system's file dialogs: the window goes on while one is open.
//!
//! A system without a dialog answers as one whose dialog was cancelled does, but at once or without having taken the keyboard from the
//! window: then the window asks itself.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use crate::app::command::{Command, FileCommand, FilmCommand, PathCommand, Wish};
use crate::app::host::{Choice, Filter, Wake, choose, now};
use crate::app::text;
use crate::files::{RECORD_FORMATS, as_file_name};

/// Nobody reads a dialog and cancels it within this: none has come.
const NO_DIALOG: Duration = Duration::from_millis(400);

/// Dialogs that are open, and what was chosen in them.
pub(in crate::app) struct Dialogs {
    send: Sender<Command>,
    chosen: Receiver<Command>,
    wake: Wake,
    /// Whether the window has lost the keyboard since a path was asked for last.
    left: Arc<AtomicBool>,
    /// There is no user to answer: no dialog is opened.
    pub(super) silent: bool,
}

impl Dialogs {
    /// No dialog yet.
    pub(in crate::app) fn new(wake: Wake) -> Self {
        let (send, chosen) = channel();
        Self { send, chosen, wake, left: Arc::default(), silent: false }
    }

    /// Who is to be told when something was chosen.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.wake = wake;
    }

    /// The keyboard goes to another window: to the dialog, if there is one.
    pub(in crate::app) fn leave(&self) {
        self.left.store(true, Ordering::Relaxed);
    }

    /// Choices since the last call.
    pub(in crate::app) fn take(&self) -> Vec<Command> {
        self.chosen.try_iter().collect()
    }

    /// Asks for a path; a new file is called `name`.
    pub(in crate::app) fn ask(&self, wish: Wish, name: &str) {
        if self.silent {
            return;
        }
        let choice = match wish.file_name(&as_file_name(name)) {
            _ if wish.is_for_reading() => Choice::File,
            None => Choice::Folder,
            Some(file) => Choice::New(file),
        };
        self.left.store(false, Ordering::Relaxed);
        let (send, wake, begun, left) = (self.send.clone(), self.wake.clone(), now(), Arc::clone(&self.left));
        choose(choice, &filters(wish), move |chosen| {
            let has_come = begun.elapsed() >= NO_DIALOG && left.load(Ordering::Relaxed);
            if let Some(command) = after(wish, chosen, has_come) {
                // Nobody listens any more when the window has closed: nothing to do then.
                let _ = send.send(command);
                wake();
            }
        });
    }
}

/// Filters of the offered files; empty for a folder.
fn filters(wish: Wish) -> Vec<Filter> {
    match (wish, wish.extension()) {
        (Wish::Open | Wish::Save, _) => vec![(text::SCENES.to_string(), vec!["toml"])],
        (Wish::Record(_) | Wish::Component(..), _) => {
            let each = RECORD_FORMATS.iter().map(|format| (format.name.to_owned(), format.extensions.to_vec()));
            [(text::RECORDS.to_string(), extensions(wish))].into_iter().chain(each).collect()
        }
        (_, Some(extension)) => vec![(extension.to_uppercase(), vec![extension])],
        (_, None) => Vec::new(),
    }
}

/// Command after a dialog's answer, where one `has_come`.
fn after(wish: Wish, chosen: Option<PathBuf>, has_come: bool) -> Option<Command> {
    let here = || FileCommand::Path(PathCommand::Ask(wish)).into();
    chosen.map(|path| then(wish, path)).or_else(|| (!has_come).then(here))
}

/// Command for a path that was asked for.
pub(super) fn then(wish: Wish, path: PathBuf) -> Command {
    let path = wish.complete(path);
    match wish {
        Wish::Open => FileCommand::Open(path).into(),
        Wish::Record(ground) => FileCommand::Record(ground, path).into(),
        Wish::Component(ground, number) => FileCommand::Component(ground, number, path).into(),
        Wish::Save => FileCommand::SaveTo(path).into(),
        Wish::Export(what) => FileCommand::Export(what, path).into(),
        Wish::Plots(_) => FileCommand::Plots(path).into(),
        Wish::Film(_) => FilmCommand::Shoot(path).into(),
    }
}

/// Extensions of files that can be chosen; empty for a folder.
pub(super) fn extensions(wish: Wish) -> Vec<&'static str> {
    match wish {
        Wish::Open => vec!["toml"],
        Wish::Record(_) | Wish::Component(..) => {
            RECORD_FORMATS.iter().flat_map(|format| format.extensions).copied().collect()
        }
        _ => wish.extension().into_iter().collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_of_nothing_without_a_dialog_has_the_window_ask_and_of_one_that_came_is_a_cancel() {
        let asked = after(Wish::Save, None, false);
        let here = FileCommand::Path(PathCommand::Ask(Wish::Save));
        assert!(matches!(asked, Some(Command::File(command)) if command == here), "the window asks");
        assert!(after(Wish::Save, None, true).is_none(), "cancelled");
        let chosen = after(Wish::Save, Some("east".into()), false);
        let saved = FileCommand::SaveTo("east.toml".into());
        assert!(matches!(chosen, Some(Command::File(command)) if command == saved), "with its extension");
    }
}
