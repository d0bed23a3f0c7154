//! The window of an X server, and pixels that are sent to it. Of a frame that a processor has drawn these are the ones that have changed;
//! a swapchain sends all of it, 3.7 MB at 1280 × 720, once to its texture and once more through a socket.

use winit::raw_window_handle::{HasWindowHandle as _, RawWindowHandle};
use winit::window::Window;
use x11rb::connection::{Connection as _, RequestConnection as _};
use x11rb::errors::ConnectionError;
use x11rb::protocol::xproto::{ConnectionExt as _, CreateGCAux, ImageFormat, ImageOrder, Setup};
use x11rb::rust_connection::RustConnection;

use crate::render::Region;

/// Bytes of a request before its pixels: `PutImage` as a big request.
const HEAD: usize = 28;

/// A window of an X server.
pub(in crate::app) struct Pixels {
    connection: RustConnection,
    window: u32,
    context: u32,
    depth: u8,
}

impl Pixels {
    /// The way to a window; none where it is not one of an X server, or its pixels are not blue, green, red and one more byte.
    pub(in crate::app) fn of(window: &Window) -> Option<Self> {
        let window = match window.window_handle().ok()?.as_raw() {
            RawWindowHandle::Xlib(handle) => u32::try_from(handle.window).ok()?,
            RawWindowHandle::Xcb(handle) => handle.window.get(),
            _ => return None,
        };
        let (connection, _) = RustConnection::connect(None).ok()?;
        let depth = connection.get_geometry(window).ok()?.reply().ok()?.depth;
        let visual = connection.get_window_attributes(window).ok()?.reply().ok()?.visual;
        if !is_bgra(connection.setup(), depth, visual) {
            return None;
        }
        let context = connection.generate_id().ok()?;
        connection.create_gc(context, window, &CreateGCAux::new()).ok()?.check().ok()?;
        Some(Self { connection, window, context, depth })
    }

    /// Sends a part of the window, row after row from its top.
    ///
    /// # Errors
    /// In the server's or the system's words: it is not reached any more.
    pub(in crate::app) fn put(&self, part: Region, rows: &[u8]) -> Result<(), String> {
        self.send(part, rows).map_err(|e| e.to_string())
    }

    fn send(&self, part: Region, rows: &[u8]) -> Result<(), ConnectionError> {
        let ([left, top], [width, _]) = (part.min.map(short), part.size().map(short));
        let row = 4 * usize::from(width);
        let most = (self.connection.maximum_request_bytes().saturating_sub(HEAD) / row).max(1);
        for (number, band) in rows.chunks(most * row).enumerate() {
            let [height, below] = [band.len() / row, number * most].map(|rows| u16::try_from(rows).unwrap_or(u16::MAX));
            let [x, y] = [left, top + below].map(|at| i16::try_from(at).unwrap_or(i16::MAX));
            let (format, depth) = (ImageFormat::Z_PIXMAP, self.depth);
            let sent =
                self.connection.put_image(format, self.window, self.context, width, height, x, y, 0, depth, band)?;
            // A window that has just been closed.
            sent.ignore_error();
        }
        self.connection.flush()
    }
}

/// Sides of a window are no longer than that.
fn short(side: u32) -> u16 {
    u16::try_from(side).unwrap_or(u16::MAX)
}

/// Whether a server takes pixels of four bytes, blue, green and red from the first.
fn is_bgra(setup: &Setup, depth: u8, visual: u32) -> bool {
    let packed = setup.pixmap_formats.iter().any(|format| format.depth == depth && format.bits_per_pixel == 32);
    let mut visuals = setup.roots.iter().flat_map(|root| &root.allowed_depths).flat_map(|depth| &depth.visuals);
    let masks = |v: &x11rb::protocol::xproto::Visualtype| [v.red_mask, v.green_mask, v.blue_mask];
    let is_rgb = visuals.any(|v| v.visual_id == visual && masks(v) == [0x00ff_0000, 0xff00, 0xff]);
    packed && is_rgb && setup.image_byte_order == ImageOrder::LSB_FIRST
}
