//! The list of files that were used last, in the file menu.

use std::path::{Path, PathBuf};

use egui::{Button, RichText, Ui};

use crate::app::command::{Command, FileCommand, KeepCommand};
use crate::app::text;

/// Shows the list: a file that is there can be opened, one that has gone can be forgotten.
pub(in crate::app) fn show(ui: &mut Ui, recent: &[PathBuf], out: &mut Vec<Command>) {
    if recent.is_empty() {
        ui.label(RichText::new(text::NO_RECENT).weak());
        return;
    }
    for file in recent {
        if file.is_file() {
            if ui.button(short(file)).on_hover_text(file.display().to_string()).clicked() {
                out.push(FileCommand::Open(file.clone()).into());
                ui.close();
            }
        } else {
            ui.horizontal(|ui| missing(ui, file, out));
        }
    }
    ui.separator();
    if ui.add(Button::new(text::FORGET_ALL)).on_hover_text(text::FORGET_HINT).clicked() {
        out.push(Command::Keep(KeepCommand::ForgetAll));
        ui.close();
    }
}

fn missing(ui: &mut Ui, file: &Path, out: &mut Vec<Command>) {
    let words = format!("{} ({})", short(file), text::MISSING);
    ui.label(RichText::new(words).weak()).on_hover_text(file.display().to_string());
    let forget = ui.small_button(text::FORGET).on_hover_text(text::FORGET_HINT);
    if forget.clicked() {
        out.push(Command::Keep(KeepCommand::Forget(file.to_owned())));
    }
}

/// Folder and name: scenes in different folders are often called the same.
fn short(file: &Path) -> String {
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    match file.parent().map(name).filter(|folder| !folder.is_empty()) {
        Some(folder) => format!("{folder}/{}", name(file)),
        None => name(file),
    }
}
