//! Parts of a canvas, read back from the device that draws.

use std::sync::mpsc::channel;

use wgpu::{
    BufferDescriptor, BufferUsages, COPY_BYTES_PER_ROW_ALIGNMENT, CommandEncoderDescriptor, Extent3d, MapMode,
    Origin3d, PollType, TexelCopyBufferInfo, TexelCopyBufferLayout, TexelCopyTextureInfo, Texture,
};

use crate::app::shell::painter::Painter;
use crate::render::{Fault, Region, Regions};

/// The buffer that parts come through.
#[derive(Default)]
pub(in crate::app) struct Reading {
    buffer: Option<wgpu::Buffer>,
}

impl Reading {
    /// Reads parts of a canvas of four bytes a pixel, and hands each on with its rows.
    ///
    /// # Errors
    /// The device failed, or whoever takes the parts.
    pub(in crate::app) fn read(
        &mut self,
        painter: &Painter,
        canvas: &Texture,
        parts: &Regions,
        mut take: impl FnMut(Region, &[u8]) -> Result<(), String>,
    ) -> Result<(), Fault> {
        if parts.is_empty() {
            return Ok(());
        }
        let lost = |words: &dyn std::fmt::Display| Fault::Lost(words.to_string());
        let (placed, size) = places(parts);
        let kept = self.buffer.take().filter(|buffer| buffer.size() >= size);
        let buffer = self.buffer.insert(kept.unwrap_or_else(|| {
            let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
            let (label, size) = (Some("parts"), size.next_power_of_two());
            painter.device().create_buffer(&BufferDescriptor { label, size, usage, mapped_at_creation: false })
        }));
        let mut encoder = painter.device().create_command_encoder(&CommandEncoderDescriptor { label: Some("parts") });
        for (part, offset) in &placed {
            let ([x, y], [width, height]) = (part.min, part.size());
            let from = TexelCopyTextureInfo { origin: Origin3d { x, y, z: 0 }, ..canvas.as_image_copy() };
            let layout =
                TexelCopyBufferLayout { offset: *offset, bytes_per_row: Some(row(*part)), rows_per_image: None };
            let extent = Extent3d { width, height, depth_or_array_layers: 1 };
            encoder.copy_texture_to_buffer(from, TexelCopyBufferInfo { buffer, layout }, extent);
        }
        painter.queue().submit([encoder.finish()]);
        let (sender, receiver) = channel();
        buffer.map_async(MapMode::Read, .., move |mapped| {
            // It is waited for below.
            let _ = sender.send(mapped);
        });
        painter.device().poll(PollType::wait_indefinitely()).map_err(|e| lost(&e))?;
        receiver.recv().map_err(|e| lost(&e))?.map_err(|e| lost(&e))?;
        let mapped = buffer.get_mapped_range(..).map_err(|e| lost(&e))?;
        let (bytes, mut rows): (&[u8], _) = (&mapped, Vec::new());
        for (part, offset) in placed {
            let [width, height] = part.size().map(|side| side as usize);
            rows.clear();
            let from = bytes.get(usize::try_from(offset).unwrap_or(usize::MAX)..).unwrap_or_default();
            from.chunks(row(part) as usize).take(height).for_each(|row| rows.extend_from_slice(&row[..4 * width]));
            take(part, &rows).map_err(|e| lost(&e))?;
        }
        drop(mapped);
        buffer.unmap();
        Ok(())
    }
}

/// Bytes from one row of a part to the next.
fn row(part: Region) -> u32 {
    (4 * part.size()[0]).next_multiple_of(COPY_BYTES_PER_ROW_ALIGNMENT)
}

/// Where parts are in the buffer, and how large that is \[bytes\].
fn places(parts: &Regions) -> (Vec<(Region, u64)>, u64) {
    let mut end = 0;
    let place = |part: Region| {
        let start = end;
        end += u64::from(row(part)) * u64::from(part.size()[1]);
        (part, start)
    };
    let placed = parts.iter().map(place).collect();
    (placed, end)
}
