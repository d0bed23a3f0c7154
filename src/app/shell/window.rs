//! The window itself: winit's events into the workbench, its shapes onto the surface.
//!
//! A frame is drawn when something has happened, never otherwise: the event loop sleeps until an event, a thread's news
//! or the time that the workbench has asked to be woken at.

use std::sync::Arc;
use std::time::Duration;

use egui::{TexturesDelta, ViewportId};
use winit::application::ApplicationHandler;
use winit::event::{StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::{Window, WindowId};

use crate::app::bench::Workbench;
use crate::app::bench::dress_as_chosen;
use crate::app::command::LeaveCommand;
use crate::app::host::{Instant, Wake, now, users_folder};
use crate::app::panel::layout;
use crate::app::shell::app_error::AppError;
use crate::app::shell::between::Between;
use crate::app::shell::event_log::{EventLog, Part};
use crate::app::shell::outside::{self, Asked, Outside};
use crate::app::shell::redraw::{Frame, Redraw};
use crate::app::shell::surface::{Painted, Painting, Surface};
use crate::app::style::theme;
use crate::app::text;
use crate::files::SceneSource;
use crate::language::Language;
use crate::render::GpuError;
use crate::scene::Scene;

/// Shortest side of a window that anything is laid out for \[points\].
const LEAST: f32 = 100.0;

/// Time between two frames that nobody sees: enough for what is kept in files.
const UNSEEN: Duration = Duration::from_millis(250);

/// Least time from a frame to the next that only time asks for, where a processor draws: 30 frames a second.
const FRAME: Duration = Duration::from_micros(33_333);

/// Opens the workbench on a scene and returns when its window is closed. Its words are in this language; in the one that was
/// chosen in an earlier window, else in the system's, where none is given.
///
/// # Errors
/// [`AppError::NoDisplay`] when the machine has no display, [`AppError::NoWindow`] when none can be opened on it,
/// [`AppError::Ended`] when it was open and the display or the graphics device went away for good.
pub fn run(scene: Scene, source: SceneSource, language: Option<Language>) -> Result<(), AppError> {
    let event_loop = EventLoop::<News>::with_user_event().build().map_err(|_| AppError::NoDisplay)?;
    let proxy = event_loop.create_proxy();
    let bench = Workbench::new(scene, source);
    let mut shell = Shell { bench, proxy, language, open: None, failed: None };
    let ran = event_loop.run_app(&mut shell);
    shell.ended(ran.err().map(|problem| problem.to_string()))
}

/// Messages from outside the window.
#[derive(Debug)]
pub(super) enum News {
    /// A thread has something.
    Wake,
    /// Somebody asks for something.
    Asked(Asked),
}

impl From<Asked> for News {
    fn from(asked: Asked) -> Self {
        Self::Asked(asked)
    }
}

/// The event loop's state.
pub(super) struct Shell {
    pub(super) bench: Workbench,
    pub(super) proxy: EventLoopProxy<News>,
    /// The language that was asked for.
    pub(super) language: Option<Language>,
    pub(super) open: Option<Open>,
    pub(super) failed: Option<String>,
}

/// An open window.
pub(super) struct Open {
    window: Arc<Window>,
    egui: egui_winit::State,
    surface: Surface,
    title: String,
    /// Nothing of it can be seen, as far as the system tells.
    hidden: bool,
    /// A frame is asked for by the window itself: one that comes without is the system's, which may have lost what was shown.
    asks: bool,
    between: Between,
    log: Option<EventLog>,
    outside: Outside,
}

impl Open {
    fn new(event_loop: &ActiveEventLoop, bench: &mut Workbench, proxy: &EventLoopProxy<News>) -> Result<Self, String> {
        let title = bench.title();
        // Whoever listens wants to be there before the window is seen.
        let look = outside::look(Window::default_attributes().with_title(&title).with_visible(false));
        let window = Arc::new(event_loop.create_window(look).map_err(|e| e.to_string())?);
        let events = proxy.clone();
        let wake: Wake = Arc::new(move || {
            // The event loop has ended: nobody to wake.
            let _ = events.send_event(News::Wake);
        });
        let mut surface = Surface::new(event_loop, &window, wake.clone());
        let (scale, theme) = (Some(pixels_per_point(&window)), window.theme());
        let mut egui = egui_winit::State::new(theme::context(), ViewportId::ROOT, event_loop, scale, theme, None);
        let outside = Outside::new(event_loop, (&window, &mut egui), proxy);
        bench.set_wake(wake);
        let begun = surface.bring_up().map_err(|e| e.to_string())?;
        if let Some(folder) = users_folder() {
            bench.keep_in(&folder);
        }
        window.set_visible(true);
        let (between, log) = (Between::default(), EventLog::wanted());
        let mut open = Self { window, egui, surface, title, hidden: false, asks: false, between, log, outside };
        if begun == Painted::Anew {
            open.draw_on_it(bench);
        }
        Ok(open)
    }

    /// There is a device: the workbench is drawn on it from now on.
    fn draw_on_it(&mut self, bench: &mut Workbench) {
        self.egui.set_max_texture_side(self.surface.largest());
        bench.view.set_target(self.surface.format(), self.surface.adapter().cloned());
    }

    /// Asks for a frame.
    fn ask(&mut self) {
        self.asks = true;
        self.window.request_redraw();
    }

    /// Asks for a frame that is laid out: something has happened.
    fn ask_anew(&mut self) {
        self.between.end();
        self.ask();
    }

    /// Sees to it that a frame is drawn after a time.
    fn come_back(&mut self, event_loop: &ActiveEventLoop, again: Duration) {
        if again.is_zero() {
            self.ask();
        }
        // What does not fit a clock is never.
        let then = now().checked_add(again).filter(|_| !again.is_zero());
        event_loop.set_control_flow(then.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
    }

    /// Writes to the log, where there is one.
    fn log(&mut self, write: impl FnOnce(&mut EventLog)) {
        if let Some(log) = &mut self.log {
            write(log);
        }
    }

    /// Lays the window out: what of it has to be drawn, textures that change with it, and when it wants to be laid out again.
    fn lay_out(&mut self, began: Instant, bench: &mut Workbench) -> (Redraw, TexturesDelta, Duration) {
        self.between.lay_out(began);
        let mut input = self.egui.take_egui_input(&self.window);
        // Panels squeezed into next to nothing would not come back to their sizes; egui keeps to the last that it had.
        input.screen_rect = input.screen_rect.filter(|rect| rect.size().min_elem() >= LEAST);
        let context = self.egui.egui_ctx().clone();
        let output = context.run_ui(input, |ui| layout::show(bench, ui));
        self.log(|log| log.end(Part::LaidOut));
        self.outside.seen(bench, &output.platform_output);
        self.egui.handle_platform_output(&self.window, output.platform_output);
        let (shapes, pixels_per_point) = (output.shapes, output.pixels_per_point);
        let changes = bench.view.viewport.take_changes();
        let textures = &output.textures_delta;
        let redraw =
            self.surface.plan(Frame { context: &context, shapes, pixels_per_point, textures, changes: &changes });
        let wanted = output.viewport_output.get(&ViewportId::ROOT).map_or(Duration::MAX, |v| v.repaint_delay);
        (redraw, output.textures_delta, wanted)
    }

    /// Shows the workbench; answers when it wants to be shown again.
    fn draw(&mut self, bench: &mut Workbench) -> Result<Duration, GpuError> {
        if self.surface.adapter().is_none() {
            match self.surface.bring_up()? {
                Painted::Again(wait) => return Ok(wait),
                Painted::Shown | Painted::Anew => self.draw_on_it(bench),
            }
        }
        let began = now();
        self.log(EventLog::begin);
        let is_asked = !std::mem::take(&mut self.asks);
        let on = (&mut self.surface, self.egui.egui_ctx());
        let played_on = (!is_asked && !self.hidden).then(|| self.between.play_on(began, bench, on)).flatten();
        self.log(|log| log.end(Part::LaidOut));
        let (redraw, textures, wanted) = match played_on {
            Some(redraw) => (redraw, TexturesDelta::default(), Duration::ZERO),
            None => self.lay_out(began, bench),
        };
        self.log(|log| log.end(Part::Tessellated));
        let painting = Painting { redraw, pixels_per_point: self.egui.egui_ctx().pixels_per_point(), is_asked };
        let painted = self.surface.paint(&painting, textures)?;
        let shown = (bench.files.document.revision(), bench.replay.runner.answered());
        self.log(|log| {
            log.end(Part::Painted);
            log.shown(shown.0, shown.1);
        });
        if painted == Painted::Anew {
            self.draw_on_it(bench);
            bench.window.say(text::DRAWN_ANEW);
        }
        let title = bench.title();
        if title != self.title {
            self.window.set_title(&title);
            self.title = title;
        }
        let least = if self.surface.is_drawn_by_processor() { FRAME } else { Duration::ZERO };
        Ok(match painted {
            Painted::Shown if self.hidden => wanted.max(UNSEEN),
            // What only goes on with time goes on evenly, however long a frame takes.
            Painted::Shown => wanted.max(least).saturating_sub(began.elapsed()),
            Painted::Again(wait) => wait,
            Painted::Anew => Duration::ZERO,
        })
    }
}

impl Shell {
    /// How it all ended, once the event loop has: closed, never opened, or broken off.
    fn ended(self, problem: Option<String>) -> Result<(), AppError> {
        let Some(why) = self.failed.or(problem) else { return Ok(()) };
        if self.open.is_none() {
            return Err(AppError::NoWindow(why));
        }
        // The workbench keeps what is unsaved as it goes.
        let kept = self.bench.files.session.is_kept() && self.bench.files.document.is_dirty();
        Err(AppError::Ended { why, kept })
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a scale factor is a small number")]
fn pixels_per_point(window: &Window) -> f32 {
    window.scale_factor() as f32
}

impl ApplicationHandler<News> for Shell {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.open.is_some() {
            return;
        }
        match Open::new(event_loop, &mut self.bench, &self.proxy) {
            Ok(open) => {
                let chosen = self.language.or(self.bench.files.session.chosen().language);
                self.bench.window.language = chosen.unwrap_or_else(Language::of_system);
                let open = self.open.insert(open);
                dress_as_chosen(open.egui.egui_ctx(), self.bench.files.session.chosen());
                open.ask();
            }
            Err(reason) => {
                self.failed = Some(reason);
                event_loop.exit();
            }
        }
    }

    fn exiting(&mut self, _event_loop: &ActiveEventLoop) {
        self.failed.iter().for_each(|why| outside::give_up(why));
    }

    fn new_events(&mut self, _event_loop: &ActiveEventLoop, cause: StartCause) {
        if let (StartCause::ResumeTimeReached { .. }, Some(open)) = (cause, &mut self.open) {
            open.ask();
        }
    }

    fn user_event(&mut self, _event_loop: &ActiveEventLoop, news: News) {
        let Some(open) = &mut self.open else { return };
        if let News::Asked(asked) = news {
            Outside::answer(asked, (&mut open.egui, &mut self.bench));
        }
        open.ask_anew();
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _id: WindowId, event: WindowEvent) {
        let Some(open) = &mut self.open else { return };
        match &event {
            WindowEvent::RedrawRequested => match open.draw(&mut self.bench) {
                Ok(again) => open.come_back(event_loop, again),
                Err(reason) => {
                    self.failed = Some(reason.to_string());
                    event_loop.exit();
                }
            },
            WindowEvent::CloseRequested => {
                self.bench.apply(LeaveCommand::Close);
                open.ask_anew();
            }
            WindowEvent::Resized(size) => open.surface.resize(size.width, size.height),
            WindowEvent::Occluded(hidden) => {
                open.hidden = *hidden;
                open.surface.cover();
            }
            WindowEvent::CursorMoved { .. } | WindowEvent::MouseInput { .. } | WindowEvent::KeyboardInput { .. } => {
                open.log(EventLog::input);
            }
            _ => {}
        }
        if !matches!(event, WindowEvent::RedrawRequested) && open.egui.on_window_event(&open.window, &event).repaint {
            open.ask_anew();
        }
        if self.bench.window.closes() {
            event_loop.exit();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::command::{EditCommand, PlaceCommand};
    use crate::scene::presets;

    /// Frames shown before the device is taken away, and after it is back.
    const FRAMES: u32 = 5;
    /// Until when it has to be back \[s\]: frames that are asked for while there is none are as many as the processor makes.
    const BACK: u64 = 30;

    /// The window as it is, and somebody who takes its device away in the middle of an edit.
    struct Losing {
        shell: Shell,
        frames: u32,
        /// Frames shown since the device is back.
        back: u32,
        begun: std::time::Instant,
        seen: Vec<String>,
    }

    impl ApplicationHandler<News> for Losing {
        fn resumed(&mut self, event_loop: &ActiveEventLoop) {
            self.shell.resumed(event_loop);
            self.shell.bench.apply(PlaceCommand::AddGirder);
        }

        fn new_events(&mut self, event_loop: &ActiveEventLoop, cause: StartCause) {
            self.shell.new_events(event_loop, cause);
        }

        fn user_event(&mut self, event_loop: &ActiveEventLoop, news: News) {
            self.shell.user_event(event_loop, news);
        }

        fn window_event(&mut self, event_loop: &ActiveEventLoop, id: WindowId, event: WindowEvent) {
            let drawn = event == WindowEvent::RedrawRequested;
            self.shell.window_event(event_loop, id, event);
            let Some(open) = self.shell.open.as_ref().filter(|_| drawn) else { return };
            self.frames += 1;
            self.seen.extend(self.shell.bench.window.notice().map(str::to_owned));
            if self.frames == FRAMES {
                open.surface.lose();
            }
            let anew = self.seen.iter().any(|words| words == text::DRAWN_ANEW.as_str());
            self.back += u32::from(anew && open.surface.is_shown());
            if self.back == FRAMES || self.begun.elapsed().as_secs() > BACK {
                event_loop.exit();
            }
            open.window.request_redraw();
        }
    }

    #[test]
    #[ignore = "wants a display: tests/window/smoke.sh brings one"]
    fn a_real_window_goes_on_when_its_device_is_lost() {
        let event_loop = on_any_thread().build().expect("a display");
        let bench = Workbench::new(presets::load(presets::OPENING).expect("ships"), SceneSource::New);
        let girders = bench.files.document.scene().girders.len();
        let shell = Shell { bench, proxy: event_loop.create_proxy(), language: None, open: None, failed: None };
        let begun = now();
        let mut losing = Losing { shell, frames: 0, back: 0, begun, seen: Vec::new() };
        event_loop.run_app(&mut losing).expect("it ends when it is told to");
        let Losing { mut shell, seen, .. } = losing;
        assert_eq!(shell.failed, None, "nothing to give up for");
        assert!(
            seen.iter().any(|words| words == text::DRAWN_ANEW.as_str()),
            "it was lost, and that was said: {seen:?}"
        );
        assert!(shell.open.as_ref().is_some_and(|open| open.surface.is_shown()), "and it is shown again");
        assert_eq!(shell.bench.files.document.scene().girders.len(), girders + 1, "with the work");
        shell.bench.apply(EditCommand::Undo);
        assert_eq!(shell.bench.files.document.scene().girders.len(), girders, "and its past");
        // What is unsaved here is nobody's.
        shell.bench.files.forget_work();
    }

    /// Tests do not run on the main thread.
    fn on_any_thread() -> winit::event_loop::EventLoopBuilder<News> {
        let mut builder = EventLoop::<News>::with_user_event();
        #[cfg(target_os = "linux")]
        winit::platform::x11::EventLoopBuilderExtX11::with_any_thread(&mut builder, true);
        builder
    }
}
