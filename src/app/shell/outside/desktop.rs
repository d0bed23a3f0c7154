//! Surroundings of the window on a desktop: a frame of a size, and a screen reader that may ask.

use egui::PlatformOutput;
use egui_winit::State;
use egui_winit::accesskit_winit::{Event, WindowEvent};
use winit::dpi::LogicalSize;
use winit::event_loop::{ActiveEventLoop, EventLoopProxy};
use winit::window::{Window, WindowAttributes};

use crate::app::bench::Workbench;
use crate::app::shell::window::News;

/// Request of a screen reader.
pub(super) type Asked = Event;

/// Surroundings of the window.
pub(super) struct Outside;

/// The window as it is first seen.
pub(super) fn look(plain: WindowAttributes) -> WindowAttributes {
    let size = LogicalSize::new(1280.0, 720.0);
    plain.with_inner_size(size).with_min_inner_size(LogicalSize::new(800.0, 480.0))
}

/// The window ends for a reason; whoever has opened it tells why.
pub(super) fn give_up(_: &str) {}

impl Outside {
    /// Has whoever asks be heard.
    pub(super) fn new(
        event_loop: &ActiveEventLoop,
        (window, egui): (&Window, &mut State),
        proxy: &EventLoopProxy<News>,
    ) -> Self {
        egui.init_accesskit(event_loop, window, proxy.clone());
        Self
    }

    /// Does what was asked.
    pub(super) fn answer(asked: Asked, (egui, _): (&mut State, &mut Workbench)) {
        match asked.window_event {
            WindowEvent::InitialTreeRequested => egui.egui_ctx().enable_accesskit(),
            WindowEvent::ActionRequested(request) => egui.on_accesskit_action_request(request),
            WindowEvent::AccessibilityDeactivated => egui.egui_ctx().disable_accesskit(),
        }
    }

    /// A frame has been laid out; egui tells a screen reader by itself.
    #[expect(clippy::unused_self, reason = "a page has a state of its own")]
    pub(super) fn seen(&mut self, _: &Workbench, _: &PlatformOutput) {}
}
