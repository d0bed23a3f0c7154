//! The words of a guided scene beside the view: what is to be seen, things to try, and the way back.

use egui::{Button, Label, RichText, Ui};

use crate::app::command::{Command, LearnCommand};
use crate::app::learn::lessons::{Learning, Lesson, lessons};
use crate::app::text;

/// The menu of guided scenes.
pub(in crate::app) fn menu(ui: &mut Ui, learning: Learning, out: &mut Vec<Command>) {
    for (number, lesson) in lessons().iter().enumerate() {
        let chosen = learning.lesson().is_some_and(|open| open.name == lesson.name);
        if ui.add(Button::selectable(chosen, lesson.title.as_str())).clicked() {
            out.push(Command::Learn(LearnCommand::Open(number)));
            ui.close();
        }
    }
}

/// Shows the words of a guided scene; what was `tried` and is in force is marked.
pub(in crate::app) fn show(ui: &mut Ui, lesson: &Lesson, tried: Option<usize>, out: &mut Vec<Command>) {
    ui.add(Label::new(RichText::new(&lesson.title).heading()).wrap());
    ui.horizontal(|ui| {
        if ui.button(text::RESET).on_hover_text(text::RESET_HINT).clicked() {
            out.push(Command::Learn(LearnCommand::Reset));
        }
        if ui.button(text::CLOSE_LESSON).clicked() {
            out.push(Command::Learn(LearnCommand::Close));
        }
    });
    for paragraph in &lesson.text {
        ui.add_space(6.0);
        ui.add(Label::new(paragraph).wrap());
    }
    ui.add_space(10.0);
    ui.label(RichText::new(text::TRY).strong());
    for (number, try_it) in lesson.tries.iter().enumerate() {
        ui.add_space(4.0);
        let label = format!("{}  {}", number + 1, try_it.words);
        if ui.add(Button::new(label).selected(tried == Some(number)).wrap()).clicked() {
            out.push(Command::Learn(LearnCommand::Try(number)));
        }
        ui.add(Label::new(&try_it.text).wrap());
    }
}
