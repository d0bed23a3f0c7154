//! The window itself: winit's events into the workbench, its shapes onto the surface.
//!
//! A frame is drawn when something has happened, never otherwise: the event loop sleeps until an event, a thread's news
//! or the time that the workbench has asked to be woken at.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use egui::ViewportId;
use egui_winit::accesskit_winit;
use winit::application::ApplicationHandler;
use winit::dpi::LogicalSize;
use winit::event::{StartCause, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::{Window, WindowId};

use super::clock::now;
use super::command::Command;
use super::keeping;
use super::surface::Surface;
use super::workbench::Workbench;
use crate::scene::Scene;

/// Why there is no window.
#[derive(Debug, thiserror::Error)]
pub enum AppError {
    /// There is no display to open a window on: work without one.
    #[error("no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY leads to one)")]
    NoDisplay,
    /// There is a display, but nothing that could draw on it.
    #[error("no window could be opened: {0}")]
    NoWindow(String),
}

/// Opens the workbench on a scene and returns when its window is closed.
///
/// # Errors
/// [`AppError::NoDisplay`] when the machine has no display, [`AppError::NoWindow`] when none can be opened on it.
pub fn run(scene: Scene, file: Option<PathBuf>) -> Result<(), AppError> {
    let event_loop = EventLoop::<News>::with_user_event().build().map_err(|_| AppError::NoDisplay)?;
    let proxy = event_loop.create_proxy();
    let mut shell = Shell { bench: Workbench::new(scene, file), proxy, open: None, failed: None };
    event_loop.run_app(&mut shell).map_err(|e| AppError::NoWindow(e.to_string()))?;
    shell.failed.map_or(Ok(()), |reason| Err(AppError::NoWindow(reason)))
}

/// What comes from elsewhere than the window.
#[derive(Debug)]
enum News {
    /// A thread has something.
    Wake,
    /// A screen reader asks.
    Accesskit(accesskit_winit::Event),
}

impl From<accesskit_winit::Event> for News {
    fn from(event: accesskit_winit::Event) -> Self {
        Self::Accesskit(event)
    }
}

/// The event loop's state.
struct Shell {
    bench: Workbench,
    proxy: EventLoopProxy<News>,
    open: Option<Open>,
    failed: Option<String>,
}

/// An open window.
struct Open {
    window: Arc<Window>,
    egui: egui_winit::State,
    surface: Surface,
    title: String,
}

impl Open {
    fn new(event_loop: &ActiveEventLoop, bench: &mut Workbench, proxy: &EventLoopProxy<News>) -> Result<Self, String> {
        let title = bench.title();
        let size = LogicalSize::new(1280.0, 720.0);
        // Accessibility wants to be there before the window is seen.
        let look = Window::default_attributes().with_title(&title).with_inner_size(size).with_visible(false);
        let look = look.with_min_inner_size(LogicalSize::new(800.0, 480.0));
        let window = Arc::new(event_loop.create_window(look).map_err(|e| e.to_string())?);
        let surface = Surface::new(event_loop, &window)?;
        let (scale, theme) = (Some(pixels_per_point(&window)), window.theme());
        let (context, largest) = (egui::Context::default(), Some(surface.largest()));
        let mut egui = egui_winit::State::new(context, ViewportId::ROOT, event_loop, scale, theme, largest);
        egui.init_accesskit(event_loop, &window, proxy.clone());
        bench.set_target(surface.format(), surface.adapter());
        let wake = proxy.clone();
        bench.set_wake(Arc::new(move || {
            // The event loop has ended: nobody to wake.
            let _ = wake.send_event(News::Wake);
        }));
        if let Some(folder) = keeping::users_folder() {
            bench.keep_in(&folder);
        }
        window.set_visible(true);
        Ok(Self { window, egui, surface, title })
    }

    /// Shows the workbench; answers when it wants to be shown again.
    fn draw(&mut self, bench: &mut Workbench) -> Duration {
        let input = self.egui.take_egui_input(&self.window);
        let context = self.egui.egui_ctx().clone();
        let output = context.run_ui(input, |ui| bench.ui(ui));
        self.egui.handle_platform_output(&self.window, output.platform_output);
        let jobs = context.tessellate(output.shapes, output.pixels_per_point);
        let retry = !self.surface.paint(&self.window, &jobs, output.textures_delta, output.pixels_per_point);
        let title = bench.title();
        if title != self.title {
            self.window.set_title(&title);
            self.title = title;
        }
        let wanted = output.viewport_output.get(&ViewportId::ROOT).map_or(Duration::MAX, |v| v.repaint_delay);
        if retry { wanted.min(Duration::from_millis(10)) } else { wanted }
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
                open.window.request_redraw();
                self.open = Some(open);
            }
            Err(reason) => {
                self.failed = Some(reason);
                event_loop.exit();
            }
        }
    }

    fn new_events(&mut self, _event_loop: &ActiveEventLoop, cause: StartCause) {
        if let (StartCause::ResumeTimeReached { .. }, Some(open)) = (cause, &self.open) {
            open.window.request_redraw();
        }
    }

    fn user_event(&mut self, _event_loop: &ActiveEventLoop, news: News) {
        let Some(open) = &mut self.open else { return };
        if let News::Accesskit(event) = news {
            match event.window_event {
                accesskit_winit::WindowEvent::InitialTreeRequested => open.egui.egui_ctx().enable_accesskit(),
                accesskit_winit::WindowEvent::ActionRequested(request) => {
                    open.egui.on_accesskit_action_request(request);
                }
                accesskit_winit::WindowEvent::AccessibilityDeactivated => open.egui.egui_ctx().disable_accesskit(),
            }
        }
        open.window.request_redraw();
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _id: WindowId, event: WindowEvent) {
        let Some(open) = &mut self.open else { return };
        match &event {
            WindowEvent::RedrawRequested => {
                let again = open.draw(&mut self.bench);
                if again.is_zero() {
                    open.window.request_redraw();
                }
                // What does not fit a clock is never.
                let then = now().checked_add(again).filter(|_| !again.is_zero());
                event_loop.set_control_flow(then.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
            }
            WindowEvent::CloseRequested => {
                self.bench.apply(Command::Close);
                open.window.request_redraw();
            }
            WindowEvent::Resized(size) => open.surface.resize(size.width, size.height),
            _ => {}
        }
        if !matches!(event, WindowEvent::RedrawRequested) && open.egui.on_window_event(&open.window, &event).repaint {
            open.window.request_redraw();
        }
        if self.bench.wants_to_close() {
            event_loop.exit();
        }
    }
}
