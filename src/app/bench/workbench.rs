//! The whole window as one function of its state: `ui` shows it, commands change it.

use std::cell::RefCell;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

use egui::{CentralPanel, Frame, Margin, Panel, ScrollArea, Ui};
use wgpu::TextureFormat;

use crate::app::bench::document::Document;
use crate::app::bench::selection::Selection;
use crate::app::command::Command;
use crate::app::disk::dialogs::Dialogs;
use crate::app::disk::film::Films;
use crate::app::disk::film_dialog;
use crate::app::disk::session_files::Keeping;
use crate::app::learn::lesson_panel;
use crate::app::panel::pins::Pin;
use crate::app::panel::row_dialog::RowDraft;
use crate::app::panel::{
    file_questions, help, inspector, menu, notices, outliner, row_dialog, shortcuts, status, whatif,
};
use crate::app::plot::plots;
use crate::app::plot::traces::TraceCache;
use crate::app::plot::user_plots::PanelCache;
use crate::app::run::runner::{Runner, Wake};
use crate::app::style::theme::{self, Palette};
use crate::app::text;
use crate::app::time::clock::Clock;
use crate::app::time::{timeline, transport};
use crate::app::viewport::tool::Tool;
use crate::app::viewport::view::{self, Viewport};
use crate::app::viewport::view_options::{self, Sight};
use crate::scene::{Overlays, Scene, ViewPreset};

/// The workbench: a scene, its answer, and how both are looked at.
pub struct Workbench {
    pub(in crate::app) document: Document,
    pub(in crate::app) runner: Runner,
    pub(in crate::app) clock: Clock,
    pub(in crate::app) viewport: Viewport,
    pub(in crate::app) dialogs: Dialogs,
    pub(in crate::app) selection: Selection,
    pub(in crate::app) pins: Vec<Pin>,
    pub(in crate::app) pin_count: usize,
    pub(in crate::app) tool: Tool,
    pub(in crate::app) sight: Sight,
    pub(in crate::app) row: Option<RowDraft>,
    pub(in crate::app) overlays: Overlays,
    pub(in crate::app) force_scale: Option<f64>,
    pub(in crate::app) time_window: Option<[f64; 2]>,
    pub(in crate::app) help: bool,
    pub(in crate::app) closing: Closing,
    pub(in crate::app) notice: Option<String>,
    pub(in crate::app) notices: (Sender<String>, Receiver<String>),
    pub(in crate::app) traces: RefCell<TraceCache>,
    pub(in crate::app) panels: RefCell<PanelCache>,
    pub(in crate::app) automatic_scale: (u64, f64),
    pub(in crate::app) target_format: TextureFormat,
    pub(in crate::app) adapter: String,
    pub(in crate::app) lesson: Option<usize>,
    /// Where to look from once the panels have taken their room.
    pub(in crate::app) aim_next: Option<ViewPreset>,
    pub(in crate::app) films: Films,
    pub(in crate::app) keeping: Keeping,
    pub(in crate::app) wake: Wake,
    dressed: bool,
}

/// Whether the window is about to close.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) enum Closing {
    /// No.
    Open,
    /// Something is not saved: the user is asked.
    Asking,
    /// It is being saved first.
    Saving,
    /// Yes.
    Now,
}

impl Workbench {
    /// Opens on a scene and runs it.
    pub fn new(scene: Scene, file: Option<PathBuf>) -> Self {
        let wake: Wake = Arc::new(|| ());
        let mut bench = Self {
            runner: Runner::default(),
            clock: Clock::default(),
            viewport: Viewport::new(scene.view.camera),
            dialogs: Dialogs::new(wake.clone()),
            selection: Selection::default(),
            pins: Vec::new(),
            pin_count: 0,
            tool: Tool::default(),
            sight: Sight::default(),
            row: None,
            overlays: scene.view.overlays,
            force_scale: scene.view.force_scale,
            time_window: None,
            help: false,
            closing: Closing::Open,
            notice: None,
            notices: channel(),
            traces: RefCell::default(),
            panels: RefCell::default(),
            automatic_scale: (0, 1.0),
            target_format: TextureFormat::Rgba8Unorm,
            adapter: String::new(),
            lesson: None,
            aim_next: None,
            films: Films::default(),
            keeping: Keeping::default(),
            wake,
            dressed: false,
            document: Document::new(scene, file),
        };
        bench.run();
        bench
    }

    /// Tells who is to be woken when a thread has news; the window's event loop.
    pub fn set_wake(&mut self, wake: Wake) {
        self.runner.set_wake(wake.clone());
        self.dialogs.set_wake(wake.clone());
        self.wake = wake;
    }

    /// Tells which format egui draws into, and with what.
    pub fn set_target(&mut self, format: TextureFormat, adapter: String) {
        self.target_format = format;
        self.adapter = adapter;
    }

    /// Whether the error is estimated while the window is idle (it is unless told otherwise).
    pub fn set_estimates(&mut self, wanted: bool) {
        self.runner.set_estimates(wanted);
    }

    /// Opens no dialogs of the system's: nobody is there to answer them.
    pub fn set_silent(&mut self) {
        self.dialogs.silent = true;
    }

    /// Shows everything and does what is asked.
    pub fn ui(&mut self, ui: &mut Ui) {
        if !self.dressed {
            theme::install(ui.ctx());
            self.dressed = true;
        }
        self.listen(ui);
        self.look_at_disk(ui);
        let mut out = Vec::new();
        shortcuts::keys(ui, self, &mut out);
        self.panels(ui, &mut out);
        help::show(ui, self, &mut out);
        row_dialog::show(ui, self, &mut out);
        notices::over_all(ui, self, &mut out);
        film_dialog::show(ui, self, &mut out);
        file_questions::show(ui, self, &mut out);
        self.apply_all(ui, out);
        let view = Frame::new().fill(Palette::of(ui).view);
        CentralPanel::no_frame().frame(view).show(ui, |ui| view::show(ui, self));
        self.go_on(ui);
    }

    /// Takes in what threads, dialogs and dropped files have brought, and lets the clock run.
    fn listen(&mut self, ui: &Ui) {
        self.runner.poll();
        if let Some(preset) = self.aim_next.take() {
            self.viewport.want(preset);
        }
        if let Ok(words) = self.notices.1.try_recv() {
            self.notice = Some(words);
        }
        if let Some(words) = self.films.poll() {
            self.notice = Some(words);
        }
        let mut brought = self.dialogs.take();
        let dropped = ui.input(|i| i.raw.dropped_files.clone());
        brought.extend(dropped.iter().map(|file| dropped_on(file.path())));
        self.apply_all(ui, brought);
        let dt = f64::from(ui.input(|i| i.stable_dt));
        if let Some(answer) = self.runner.answer() {
            self.clock.advance(dt, answer.history.end(), &answer.touches);
        }
    }

    fn panels(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        if self.sight.lecture {
            self.lecture_panels(ui, out);
            return;
        }
        Panel::top("bar").resizable(false).show(ui, |ui| menu::show(ui, self, out));
        Panel::bottom("status").resizable(false).show(ui, |ui| status::show(ui, self));
        let room = ui.available_height();
        Panel::bottom("time").resizable(true).default_size(room * 0.37).min_size(180.0).max_size(room * 0.7).show(
            ui,
            |ui| {
                transport::show(ui, self, out);
                timeline::show(ui, self, plots::AXIS_WIDTH, out);
                plots::show(ui, self, out);
            },
        );
        let side = Frame::side_top_panel(ui.style()).inner_margin(Margin::same(8));
        Panel::left("placed").frame(side).default_size(244.0).size_range(220.0..=420.0).show(ui, |ui| {
            outliner::show(ui, self, out);
            ui.separator();
            ScrollArea::vertical()
                .id_salt("inspector")
                .auto_shrink(false)
                .show(ui, |ui| inspector::show(ui, self, out));
        });
        Panel::right("what if").frame(side).default_size(264.0).size_range(240.0..=440.0).show(ui, |ui| {
            ScrollArea::vertical().id_salt("what if").auto_shrink(false).show(ui, |ui| whatif::show(ui, self, out));
        });
        lesson_panel::show(ui, self, out);
    }

    /// The view and the time, and the way back.
    fn lecture_panels(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        Panel::top("bar").resizable(false).show(ui, |ui| {
            ui.menu_button(text::VIEWS, |ui| view_options::menu(ui, self, out));
        });
        Panel::bottom("lecture time").resizable(false).show(ui, |ui| {
            transport::show(ui, self, out);
            timeline::show(ui, self, plots::AXIS_WIDTH, out);
        });
    }

    /// Asks for another frame only when there is a reason.
    fn go_on(&mut self, ui: &Ui) {
        if self.clock.playing {
            ui.request_repaint();
        } else if let Some(wait) = self.runner.when_idle() {
            ui.request_repaint_after(wait);
        }
        if let Some(wait) = self.keep_work() {
            ui.request_repaint_after(wait);
        }
        if self.runner.progress().is_some() || self.filming().is_some() {
            ui.request_repaint_after(std::time::Duration::from_millis(50));
        }
    }

    /// Runs the scene as it is now.
    pub(in crate::app) fn run(&mut self) {
        self.runner.start(self.document.scene());
    }

    /// Lets a thread say something at the bottom of the window.
    pub(in crate::app) fn in_background(&self, work: impl FnOnce() -> Result<String, String> + Send + 'static) {
        let (send, wake) = (self.notices.0.clone(), self.wake.clone());
        std::thread::spawn(move || {
            let words = work().unwrap_or_else(|problem| problem);
            // Nobody listens any more when the window has closed: nothing to do then.
            let _ = send.send(words);
            wake();
        });
    }
}

/// What a file that is dropped onto the window is for: a table is a record, anything else a scene.
fn dropped_on(path: &std::path::Path) -> Command {
    let is_table = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    if is_table { Command::Record(path.to_owned()) } else { Command::OpenFile(path.to_owned()) }
}
