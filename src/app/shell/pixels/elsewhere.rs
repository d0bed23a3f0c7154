//! Where no pixels are sent to a window: all frames go to its swapchain.

use winit::window::Window;

use crate::render::Region;

/// A window that takes pixels: none does.
pub(in crate::app) enum Pixels {}

impl Pixels {
    /// There is no way.
    pub(in crate::app) fn of(_: &Window) -> Option<Self> {
        None
    }

    /// Sends a part of the window.
    ///
    /// # Errors
    /// None.
    pub(in crate::app) fn put(&self, _: Region, _: &[u8]) -> Result<(), String> {
        match *self {}
    }
}
