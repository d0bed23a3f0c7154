//! From the device's memory into a picture: one buffer, kept for as long as pictures keep their size.

use super::image::straight;
use super::{Gpu, GpuError, Image};

/// Most pixels of one picture, so that its targets fit into memory.
const MOST_PIXELS: u64 = 1 << 25;

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
    pub(super) fn read(
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
        let rgba = self.rows(gpu)?;
        self.buffer.unmap();
        let [width, height] = self.size;
        Ok(Image { width, height, rgba: straight(rgba) })
    }

    /// Waits, and copies the rows without what lies between them.
    fn rows(&self, gpu: &Gpu) -> Result<Vec<u8>, GpuError> {
        let failed = |e: &dyn std::fmt::Display| GpuError::Readback(e.to_string());
        let (sender, receiver) = std::sync::mpsc::channel();
        self.buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // Whoever waits may have gone; then nobody wants the answer.
            let _ = sender.send(result);
        });
        gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| failed(&e))?;
        receiver.recv().map_err(|e| failed(&e))?.map_err(|e| failed(&e))?;
        let mapped = self.buffer.get_mapped_range(..).map_err(|e| failed(&e))?;
        let used = 4 * self.size[0] as usize;
        let mut rgba = Vec::with_capacity(used * self.size[1] as usize);
        mapped.chunks_exact(self.row as usize).for_each(|row| rgba.extend_from_slice(&row[..used]));
        Ok(rgba)
    }
}
