//! From the device's memory into a picture: one buffer, kept for as long as pictures keep their size.

use std::sync::mpsc::Receiver;
#[cfg(target_arch = "wasm32")]
use std::sync::mpsc::TryRecvError;

use super::image::straight;
use super::{Gpu, GpuError, Image};

/// Most pixels of one picture, so that its targets fit into memory.
const MOST_PIXELS: u64 = 1 << 25;

/// Between two looks at a buffer \[ms\].
#[cfg(target_arch = "wasm32")]
const PAUSE: i32 = 5;

/// Refuses sizes that the device does not draw.
pub(super) fn check_size(gpu: &Gpu, [width, height]: [u32; 2]) -> Result<(), GpuError> {
    let limit = gpu.device.limits().max_texture_dimension_2d;
    let fits = (1..=limit).contains(&width) && (1..=limit).contains(&height);
    if fits && u64::from(width) * u64::from(height) <= MOST_PIXELS {
        Ok(())
    } else {
        Err(GpuError::Size(width, height, limit))
    }
}

/// A buffer that pictures of one size come back through.
#[derive(Debug)]
pub(super) struct Readback {
    size: [u32; 2],
    /// Bytes from one row to the next.
    row: u32,
    buffer: wgpu::Buffer,
}

impl Readback {
    pub(super) fn new(gpu: &Gpu, size: [u32; 2]) -> Self {
        let row = (4 * size[0]).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
        let buffer = gpu.buffer("read back", u64::from(row) * u64::from(size[1]), usage);
        Self { size, row, buffer }
    }

    /// Width and height \[pixels\].
    pub(super) fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Finishes and submits an encoder, and reads a texture of this size back. After an error it is not to be used again.
    pub(super) async fn read(
        &self,
        gpu: &Gpu,
        mut encoder: wgpu::CommandEncoder,
        texture: &wgpu::Texture,
    ) -> Result<Image, GpuError> {
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(self.row), rows_per_image: None };
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo { buffer: &self.buffer, layout },
            texture.size(),
        );
        gpu.queue.submit([encoder.finish()]);
        let rgba = self.rows(gpu).await?;
        self.buffer.unmap();
        let [width, height] = self.size;
        Ok(Image { width, height, rgba: straight(rgba) })
    }

    /// Waits, and copies the rows without what lies between them.
    async fn rows(&self, gpu: &Gpu) -> Result<Vec<u8>, GpuError> {
        let failed = |e: &dyn std::fmt::Display| GpuError::Readback(e.to_string());
        let (sender, receiver) = std::sync::mpsc::channel();
        self.buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // Whoever waits may have gone; then nobody wants the answer.
            let _ = sender.send(result);
        });
        come(gpu, receiver).await?.map_err(|e| failed(&e))?;
        let mapped = self.buffer.get_mapped_range(..).map_err(|e| failed(&e))?;
        let used = 4 * self.size[0] as usize;
        let mut rgba = Vec::with_capacity(used * self.size[1] as usize);
        mapped.chunks_exact(self.row as usize).for_each(|row| rgba.extend_from_slice(&row[..used]));
        Ok(rgba)
    }
}

/// Result of a buffer's mapping.
type Mapped = Result<(), wgpu::BufferAsyncError>;

/// Waits until the device has mapped a buffer.
#[cfg(not(target_arch = "wasm32"))]
#[expect(clippy::unused_async, reason = "a page has to let go of its thread")]
async fn come(gpu: &Gpu, receiver: Receiver<Mapped>) -> Result<Mapped, GpuError> {
    let failed = |e: &dyn std::fmt::Display| GpuError::Readback(e.to_string());
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| failed(&e))?;
    receiver.recv().map_err(|e| failed(&e))
}

/// Asks again and again whether the device has mapped a buffer, which it does while the page does something else.
#[cfg(target_arch = "wasm32")]
async fn come(gpu: &Gpu, receiver: Receiver<Mapped>) -> Result<Mapped, GpuError> {
    let failed = |e: &dyn std::fmt::Display| GpuError::Readback(e.to_string());
    let soon = |resolve: &js_sys::Function| {
        web_sys::window().map(|w| w.set_timeout_with_callback_and_timeout_and_arguments_0(resolve, PAUSE))
    };
    loop {
        gpu.device.poll(wgpu::PollType::Poll).map_err(|e| failed(&e))?;
        match receiver.try_recv() {
            Ok(mapped) => return Ok(mapped),
            Err(TryRecvError::Disconnected) => return Err(failed(&"the device has forgotten it")),
            Err(TryRecvError::Empty) => {
                let pause = js_sys::Promise::new(&mut |resolve, _| drop(soon(&resolve)));
                let _ = wasm_bindgen_futures::JsFuture::from(pause).await;
            }
        }
    }
}
