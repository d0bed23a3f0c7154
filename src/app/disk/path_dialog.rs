//! The dialog for a path that is asked for in the window.

use std::path::{Path, PathBuf};

use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditState;
use egui::{Button, Id, Key, Label, Modal, Response, RichText, ScrollArea, TextEdit, Ui};

use crate::app::command::{Command, FileCommand, PathCommand};
use crate::app::disk::path_field::{Asked, PathField, Question, in_folder};
use crate::app::text;

/// Width of the dialog \[points\].
const WIDTH: f32 = 520.0;

/// Height of the list of ways to go on \[points\].
const LIST: f32 = 150.0;

/// Most folders that were used lately.
const MOST_FOLDERS: usize = 4;

/// Shows the dialog while a path is asked for; `recent` are files that were used lately.
pub(in crate::app) fn show(ui: &mut Ui, field: &PathField, recent: &[PathBuf], out: &mut Vec<Command>) {
    let Some(asked) = field.asked() else { return };
    let mut commands = Vec::new();
    let modal = Modal::new(Id::unique("path")).show(ui, |ui| {
        ui.set_width(WIDTH.min(ui.ctx().content_rect().width() - 40.0));
        ui.heading(text::wish(asked.wish));
        path(ui, asked, &mut commands);
        folders(ui, field, asked, recent, &mut commands);
        offers(ui, asked, &mut commands);
        answer(ui, asked, &mut commands);
    });
    if modal.should_close() {
        commands.push(PathCommand::Leave);
    }
    out.extend(commands.into_iter().map(|command| Command::File(FileCommand::Path(command))));
}

fn path(ui: &mut Ui, asked: &Asked, out: &mut Vec<PathCommand>) {
    let id = Id::unique("path text");
    let goes_on = asked.completed();
    let mut text = asked.text.clone();
    let label = ui.label(text::PATH);
    let edit = TextEdit::singleline(&mut text).id(id).desired_width(f32::INFINITY).lock_focus(goes_on.is_some());
    let response = ui.add(edit).labelled_by(label.id);
    let pressed = |key| ui.input(|i| i.key_pressed(key));
    let entered = response.lost_focus() && pressed(Key::Enter);
    take_focus(ui, &response, &asked.text);
    let typed = text != asked.text;
    if entered {
        // Letters may come in one frame with the Enter after them; a question was about the text before them.
        let confirms = asked.question.is_some() && !typed;
        out.extend(typed.then_some(PathCommand::Type(text)));
        out.push(if confirms { PathCommand::Confirm } else { PathCommand::Take });
    } else if let Some(goes_on) = goes_on.filter(|_| response.has_focus() && pressed(Key::Tab)) {
        set_cursor(ui, &response, goes_on.chars().count());
        out.push(PathCommand::Type(goes_on));
    } else if typed {
        out.push(PathCommand::Type(text));
    }
    let whole = asked.path().display().to_string();
    let words = asked.problem.clone().unwrap_or(whole);
    let words = RichText::new(words).small();
    let words = if asked.problem.is_some() { words.color(ui.visuals().warn_fg_color) } else { words.weak() };
    ui.add(Label::new(words).wrap());
}

/// Typing goes to the path from the beginning, after its last letter.
fn take_focus(ui: &Ui, response: &Response, text: &str) {
    if ui.memory(|memory| memory.focused().is_none()) {
        response.request_focus();
        set_cursor(ui, response, text.chars().count());
    }
}

fn set_cursor(ui: &Ui, response: &Response, letters: usize) {
    let mut state = TextEditState::load(ui.ctx(), response.id).unwrap_or_default();
    state.cursor.set_char_range(Some(CCursorRange::one(CCursor::new(letters))));
    state.store(ui.ctx(), response.id);
}

/// Folders used lately, a press away.
fn folders(ui: &mut Ui, field: &PathField, asked: &Asked, recent: &[PathBuf], out: &mut Vec<PathCommand>) {
    let mut all: Vec<&Path> = vec![field.folder()];
    for folder in recent.iter().filter_map(|file| file.parent()) {
        if !all.contains(&folder) && !folder.as_os_str().is_empty() {
            all.push(folder);
        }
    }
    let name = asked.text.rsplit(std::path::is_separator).next().unwrap_or_default();
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(text::PATH_FOLDERS).weak());
        for folder in all.into_iter().take(MOST_FOLDERS) {
            let words = folder.file_name().unwrap_or(folder.as_os_str()).to_string_lossy().into_owned();
            if ui.small_button(words).on_hover_text(folder.display().to_string()).clicked() {
                let name = if asked.wish.extension().is_some() { name } else { "" };
                out.push(PathCommand::Type(in_folder(folder) + name));
            }
        }
    });
}

/// Ways to go on.
fn offers(ui: &mut Ui, asked: &Asked, out: &mut Vec<PathCommand>) {
    ScrollArea::vertical().id_salt("path offers").max_height(LIST).auto_shrink([false, true]).show(ui, |ui| {
        for offer in &asked.offers {
            if ui.add(Button::new(&offer.name).frame(false)).clicked() {
                out.push(PathCommand::Type(offer.text.clone()));
            }
        }
        if asked.offers.is_empty() {
            ui.label(RichText::new(text::PATH_NEW).weak());
        }
    });
}

/// The buttons; before something is replaced, the question.
fn answer(ui: &mut Ui, asked: &Asked, out: &mut Vec<PathCommand>) {
    ui.add_space(4.0);
    let question = asked.question.map(|question| match question {
        Question::Replace => (text::PATH_REPLACE_ASK, text::PATH_REPLACE),
        Question::Among => (text::PATH_AMONG_ASK, text::PATH_AMONG),
        Question::Make => (text::PATH_MAKE_ASK, text::PATH_MAKE),
    });
    if let Some((words, _)) = question {
        ui.label(words);
    }
    ui.horizontal(|ui| {
        let (words, command) = question
            .map_or((text::wish_done(asked.wish), PathCommand::Take), |(_, yes)| (yes.as_str(), PathCommand::Confirm));
        if ui.button(words).clicked() {
            out.push(command);
        }
        if ui.button(text::CLOSE).clicked() {
            out.push(PathCommand::Leave);
        }
    });
}
