//! The dialog that asks for a film, and the progress of one that is being written.

use std::path::PathBuf;

use egui::{Align2, Area, Button, ComboBox, DragValue, Frame, Grid, Id, Modal, Order, ProgressBar, RichText, Ui, vec2};

use crate::app::bench::Workbench;
use crate::app::command::Command;
use crate::app::disk::film::{self, FilmFormat, FilmPlan, Filming};
use crate::app::text;
use crate::app::time::clock::SPEEDS;
use crate::snapshot::Shot;

/// Sizes to choose from \[pixels\].
const SIZES: [[u32; 2]; 4] = [[640, 360], [854, 480], [1280, 720], [1920, 1080]];

impl Workbench {
    /// Frames written and frames in all, while a film is being written.
    pub fn filming(&self) -> Option<(usize, u32)> {
        self.films.progress()
    }

    /// What the film dialog shows, while it is open.
    pub fn film_plan(&self) -> Option<&FilmPlan> {
        self.films.plan.as_ref()
    }

    /// Does what is wished.
    pub(in crate::app) fn apply_film(&mut self, wish: Filming) {
        match wish {
            Filming::Ask => {
                let [from, to] = self.time_window.unwrap_or([0.0, self.end()]);
                self.films.plan = Some(FilmPlan::of(from, to));
            }
            Filming::Plan(plan) => self.films.plan = Some(plan),
            Filming::Never => self.films.plan = None,
            Filming::Choose => {
                if let Some(plan) = self.films.plan {
                    self.dialogs.film(plan.format, &self.file_stem());
                }
            }
            Filming::Shoot(path) => self.shoot(path),
            Filming::Cancel => {
                self.films.cancel();
                self.notice = Some(text::FILM_CANCELLED.into());
            }
        }
    }

    fn shoot(&mut self, path: PathBuf) {
        let (Some(plan), Some(answer)) = (self.films.plan.take(), self.answer().cloned()) else { return };
        let shot = Shot {
            camera: self.camera().copied(),
            size: plan.size.unwrap_or(self.viewport.size()),
            overlays: Some(self.overlays),
            background: self.viewport.background(),
            force_scale: self.force_scale,
            ..Shot::default()
        };
        let order = film::Order { answer, plan, shot, name: self.file_stem() };
        self.films.shoot(order, path, self.wake.clone());
    }

    /// The scene's name as a file's name can be.
    fn file_stem(&self) -> String {
        self.scene().name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' }).collect()
    }
}

/// Shows the dialog while it is open, and the progress while there is some.
pub(in crate::app) fn show(ui: &mut Ui, bench: &Workbench, out: &mut Vec<Command>) {
    if let Some(plan) = bench.film_plan() {
        let modal = Modal::new(Id::unique("film")).show(ui, |ui| dialog(ui, bench, *plan, out));
        if modal.should_close() {
            out.push(Command::Film(Filming::Never));
        }
    }
    if let Some((done, count)) = bench.filming() {
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
            out.push(Command::Film(Filming::Cancel));
        }
    });
}

fn dialog(ui: &mut Ui, bench: &Workbench, plan: FilmPlan, out: &mut Vec<Command>) {
    let mut new = plan;
    ui.heading(text::FILM);
    Grid::new("film").num_columns(2).spacing([18.0, 6.0]).show(ui, |ui| {
        format(ui, &mut new.format);
        let end = bench.end();
        number(ui, text::FILM_FROM, &mut new.from, " s", 0.0..=end);
        number(ui, text::FILM_TO, &mut new.to, " s", 0.0..=end);
        speed(ui, &mut new.speed);
        number(ui, text::FILM_FPS, &mut new.fps, " Hz", 1.0..=FilmPlan::fastest(new.format));
        size(ui, bench, &mut new.size);
    });
    ui.add_space(4.0);
    let frames = new.frames();
    let words = frames.map_or(text::FILM_IMPOSSIBLE.to_owned(), |n| text::film_length(n, f64::from(n) / new.fps));
    ui.label(RichText::new(words).weak());
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        if ui.add_enabled(frames.is_some(), Button::new(text::FILM_WHERE)).clicked() {
            out.push(Command::Film(Filming::Choose));
        }
        if ui.button(text::CLOSE).clicked() {
            out.push(Command::Film(Filming::Never));
        }
    });
    if new != plan {
        new.fps = new.fps.min(FilmPlan::fastest(new.format));
        out.push(Command::Film(Filming::Plan(new)));
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

fn size(ui: &mut Ui, bench: &Workbench, size: &mut Option<[u32; 2]>) {
    let label = ui.label(text::FILM_SIZE);
    let words = |size: Option<[u32; 2]>| match size {
        Some([width, height]) => format!("{width} × {height}"),
        None => format!("{} ({} × {})", text::FILM_AS_VIEW, bench.viewport.size()[0], bench.viewport.size()[1]),
    };
    let combo = ComboBox::from_id_salt("film size").width(190.0).selected_text(words(*size)).show_ui(ui, |ui| {
        for option in [None].into_iter().chain(SIZES.map(Some)) {
            ui.selectable_value(size, option, words(option));
        }
    });
    combo.response.labelled_by(label.id);
    ui.end_row();
}
