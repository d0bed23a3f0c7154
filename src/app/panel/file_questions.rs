//! Questions about files: unsaved work that was found, a file that another program has changed.

use std::path::Path;
use std::time::{Duration, SystemTime};

use egui::{Id, Modal, ScrollArea, Ui};

use crate::app::command::{Command, KeepCommand};
use crate::app::disk::scene_files::SceneFiles;
use crate::app::disk::session_files::FoundWork;
use crate::app::text;

/// Shows the question there is, one at a time.
pub(in crate::app) fn show(ui: &mut Ui, files: &SceneFiles, out: &mut Vec<Command>) {
    let found = files.session.found_work();
    if !found.is_empty() {
        Modal::new(Id::unique("files")).show(ui, |ui| unsaved(ui, found, out));
    } else if files.session.file_has_changed() {
        let mut words = format!("{} {}", files.name(), text::FILE_CHANGED);
        if files.document.is_dirty() {
            words.push_str(text::RELOAD_REPLACES.as_str());
        }
        ask(
            ui,
            &words,
            [(text::RELOAD.as_str(), KeepCommand::Reload), (text::KEEP_MINE.as_str(), KeepCommand::KeepMine)],
            out,
        );
    }
}

/// All that was found, each by its name, asked about once.
fn unsaved(ui: &mut Ui, found: &[FoundWork], out: &mut Vec<Command>) {
    ui.set_max_width(460.0);
    ui.label(text::WORK_FOUND);
    ScrollArea::vertical().max_height(260.0).show(ui, |ui| {
        for (number, work) in found.iter().enumerate() {
            ui.add_space(4.0);
            ui.label(found_words(work, SystemTime::now()));
            ui.horizontal(|ui| {
                for (words, wish) in
                    [(text::RECOVER, KeepCommand::Recover(number)), (text::DISCARD, KeepCommand::Discard(number))]
                {
                    let button = if found.len() == 1 {
                        words.to_string()
                    } else {
                        text::of_work(&words, number + 1, &work.name)
                    };
                    if ui.button(button).clicked() {
                        out.push(Command::Keep(wish));
                    }
                }
            });
        }
    });
    ui.separator();
    if ui.button(text::LATER).clicked() {
        out.push(Command::Keep(KeepCommand::Later));
    }
}

fn ask<const N: usize>(ui: &Ui, words: &str, answers: [(&str, KeepCommand); N], out: &mut Vec<Command>) {
    Modal::new(Id::unique("files")).show(ui, |ui| {
        ui.set_max_width(420.0);
        ui.label(words);
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            for (words, wish) in answers {
                if ui.button(words).clicked() {
                    out.push(Command::Keep(wish));
                }
            }
        });
    });
}

/// Whose work, from when, and whether the file has been written since.
fn found_words(work: &FoundWork, now: SystemTime) -> String {
    let found = &work.found;
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let whose = found.file.as_deref().map_or_else(|| text::WITHOUT_FILE.to_string(), name);
    let called = &work.name;
    let ago = now.duration_since(found.written).unwrap_or(Duration::ZERO);
    let file = found.file.as_deref().and_then(crate::files::Stamp::of);
    let older = file.is_some_and(|stamp| stamp.modified() > found.written);
    let age = if older { text::WORK_IS_OLDER.as_str() } else { "" };
    format!("{called}: {whose}, {}.{age}", text::ago(ago))
}
