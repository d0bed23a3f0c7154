//! The dialog that asks for a film, and the progress of one that is being written.

use egui::{Align2, Area, Button, ComboBox, DragValue, Frame, Grid, Id, Modal, Order, ProgressBar, RichText, Ui, vec2};

use crate::app::command::{Command, FileCommand, FilmCommand, FilmFormat, FilmPlan, Wish};
use crate::app::disk::film::Films;
use crate::app::text;
use crate::app::time::clock::SPEEDS;

/// Sizes to choose from \[pixels\].
const SIZES: [[u32; 2]; 4] = [[640, 360], [854, 480], [1280, 720], [1920, 1080]];

/// Extent of a film.
#[derive(Clone, Copy, Debug)]
pub(in crate::app) struct Scope {
    /// End of the answer \[s\].
    pub(in crate::app) end: f64,
    /// Width and height of the view \[pixels\].
    pub(in crate::app) view: [u32; 2],
}

/// Shows the dialog while it is open, and the progress while there is some.
pub(in crate::app) fn show(ui: &mut Ui, films: &Films, scope: Scope, out: &mut Vec<Command>) {
    if let Some(plan) = films.plan {
        let modal = Modal::new(Id::unique("film")).show(ui, |ui| dialog(ui, scope, plan, out));
        if modal.should_close() {
            out.push(Command::Film(FilmCommand::Never));
        }
    }
    if let Some((done, count)) = films.progress() {
        let area = Area::new(Id::unique("filming")).order(Order::Foreground);
        area.anchor(Align2::CENTER_BOTTOM, vec2(0.0, -84.0)).show(ui, |ui| {
            Frame::popup(ui.style()).show(ui, |ui| progress(ui, done, count, out));
        });
    }
}

fn progress(ui: &mut Ui, done: usize, count: u32, out: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        ui.label(format!("{} {done}/{count}", text::FILMING));
        ui.add(ProgressBar::new(done as f32 / count as f32).desired_width(140.0));
        if ui.button(text::CANCEL_FILM).clicked() {
            out.push(Command::Film(FilmCommand::Cancel));
        }
    });
}

fn dialog(ui: &mut Ui, scope: Scope, plan: FilmPlan, out: &mut Vec<Command>) {
    let mut new = plan;
    ui.heading(text::FILM);
    Grid::new("film").num_columns(2).spacing([18.0, 6.0]).show(ui, |ui| {
        format(ui, &mut new.format);
        number(ui, text::FILM_FROM.as_str(), &mut new.from, " s", 0.0..=scope.end);
        number(ui, text::FILM_TO.as_str(), &mut new.to, " s", 0.0..=scope.end);
        speed(ui, &mut new.speed);
        number(ui, text::FILM_FPS.as_str(), &mut new.fps, " Hz", 1.0..=FilmPlan::fastest(new.format));
        size(ui, scope.view, &mut new.size);
    });
    ui.add_space(4.0);
    let frames = new.frames();
    let words = frames.map_or(text::FILM_IMPOSSIBLE.to_string(), |n| text::film_length(n, f64::from(n) / new.fps));
    ui.label(RichText::new(words).weak());
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        if ui.add_enabled(frames.is_some(), Button::new(text::FILM_WHERE)).clicked() {
            out.push(FileCommand::Ask(Wish::Film(plan.format)).into());
        }
        if ui.button(text::CLOSE).clicked() {
            out.push(Command::Film(FilmCommand::Never));
        }
    });
    if new != plan {
        new.fps = new.fps.min(FilmPlan::fastest(new.format));
        out.push(Command::Film(FilmCommand::Plan(new)));
    }
}

fn format(ui: &mut Ui, format: &mut FilmFormat) {
    ui.label(text::FILM_FORMAT);
    ui.horizontal(|ui| {
        ui.radio_value(format, FilmFormat::Gif, text::FILM_GIF);
        ui.radio_value(format, FilmFormat::Png, text::FILM_PNG);
    });
    ui.end_row();
}

fn number(ui: &mut Ui, words: &str, value: &mut f64, suffix: &str, range: std::ops::RangeInclusive<f64>) {
    let label = ui.label(words);
    ui.add(DragValue::new(value).suffix(suffix).range(range).speed(0.01).max_decimals(4)).labelled_by(label.id);
    ui.end_row();
}

fn speed(ui: &mut Ui, speed: &mut f64) {
    let label = ui.label(text::SPEED);
    let combo = ComboBox::from_id_salt("film speed").selected_text(text::speed(*speed)).show_ui(ui, |ui| {
        for option in SPEEDS {
            ui.selectable_value(speed, option, text::speed(option));
        }
    });
    combo.response.labelled_by(label.id);
    ui.end_row();
}

fn size(ui: &mut Ui, [width, height]: [u32; 2], size: &mut Option<[u32; 2]>) {
    let label = ui.label(text::FILM_SIZE);
    let words = |size: Option<[u32; 2]>| match size {
        Some([width, height]) => format!("{width} × {height}"),
        None => format!("{} ({width} × {height})", text::FILM_AS_VIEW),
    };
    let combo = ComboBox::from_id_salt("film size").width(190.0).selected_text(words(*size)).show_ui(ui, |ui| {
        for option in [None].into_iter().chain(SIZES.map(Some)) {
            ui.selectable_value(size, option, words(option));
        }
    });
    combo.response.labelled_by(label.id);
    ui.end_row();
}
