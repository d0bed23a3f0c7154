//! The system's file dialogs, on threads: the window goes on while one is open.

use std::future::Future;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};

use rfd::{AsyncFileDialog, FileHandle};

use crate::app::command::{Command, Export, FileCommand, FilmFormat, Filming};
use crate::app::host::Wake;
use crate::app::text;
use crate::files::RECORD_FORMATS;

/// Dialogs that are open, and what was chosen in them.
pub(in crate::app) struct Dialogs {
    send: Sender<Command>,
    chosen: Receiver<Command>,
    wake: Wake,
    /// There is no user to answer: no dialog is opened.
    pub(super) silent: bool,
}

impl Dialogs {
    /// No dialog yet.
    pub(in crate::app) fn new(wake: Wake) -> Self {
        let (send, chosen) = channel();
        Self { send, chosen, wake, silent: false }
    }

    /// Who is to be told when something was chosen.
    pub(in crate::app) fn set_wake(&mut self, wake: Wake) {
        self.wake = wake;
    }

    /// What was chosen since the last time.
    pub(in crate::app) fn take(&self) -> Vec<Command> {
        self.chosen.try_iter().collect()
    }

    /// Which scene to open.
    pub(in crate::app) fn open(&self) {
        self.wait(scenes().pick_file(), FileCommand::Open);
    }

    /// Which record shakes the ground.
    pub(in crate::app) fn record(&self) {
        let all: Vec<&str> = RECORD_FORMATS.iter().flat_map(|format| format.extensions).copied().collect();
        let dialog = AsyncFileDialog::new().add_filter(text::RECORDS, &all);
        let dialog = RECORD_FORMATS.iter().fold(dialog, |dialog, f| dialog.add_filter(f.name, f.extensions));
        self.wait(dialog.pick_file(), FileCommand::Record);
    }

    /// Where to save the scene.
    pub(in crate::app) fn save(&self, name: &str) {
        self.wait(scenes().set_file_name(format!("{name}.toml")).save_file(), |path| {
            FileCommand::SaveTo(with_extension(path, "toml"))
        });
    }

    /// Where to export to.
    pub(in crate::app) fn export(&self, what: Export, name: &str) {
        match what {
            Export::Picture => {
                let dialog = AsyncFileDialog::new().add_filter("PNG", &["png"]).set_file_name(format!("{name}.png"));
                self.wait(dialog.save_file(), move |path| FileCommand::Export(what, with_extension(path, "png")));
            }
            Export::Report => {
                let dialog = AsyncFileDialog::new().add_filter("HTML", &["html"]).set_file_name(format!("{name}.html"));
                self.wait(dialog.save_file(), move |path| FileCommand::Export(what, with_extension(path, "html")));
            }
            Export::Tables => {
                self.wait(AsyncFileDialog::new().pick_folder(), move |path| FileCommand::Export(what, path));
            }
        }
    }

    /// Where to write the plots.
    pub(in crate::app) fn plots(&self, format: &'static str, name: &str) {
        let dialog = AsyncFileDialog::new().add_filter(format, &[format]).set_file_name(format!("{name}.{format}"));
        self.wait(dialog.save_file(), move |path| FileCommand::Plots(with_extension(path, format)));
    }

    /// Where a film is to go.
    pub(in crate::app) fn film(&self, format: FilmFormat, name: &str) {
        let then = Filming::Shoot;
        match format {
            FilmFormat::Gif => {
                let dialog = AsyncFileDialog::new().add_filter("GIF", &["gif"]).set_file_name(format!("{name}.gif"));
                self.wait(dialog.save_file(), move |path| then(with_extension(path, "gif")));
            }
            FilmFormat::Png => self.wait(AsyncFileDialog::new().pick_folder(), then),
        }
    }

    fn wait<C: Into<Command>>(
        &self,
        dialog: impl Future<Output = Option<FileHandle>> + Send + 'static,
        then: impl FnOnce(PathBuf) -> C + Send + 'static,
    ) {
        if self.silent {
            return;
        }
        let (send, wake) = (self.send.clone(), self.wake.clone());
        std::thread::spawn(move || {
            if let Some(file) = pollster::block_on(dialog) {
                // Nobody listens any more when the window has closed: nothing to do then.
                let _ = send.send(then(file.path().to_owned()).into());
                wake();
            }
        });
    }
}

fn scenes() -> AsyncFileDialog {
    AsyncFileDialog::new().add_filter("Girderbench scene", &["toml"])
}

/// Some dialogs leave the extension to the program.
fn with_extension(path: PathBuf, extension: &str) -> PathBuf {
    if path.extension().is_some() { path } else { path.with_extension(extension) }
}
