//! Buffers that are filled anew for every picture and grow when they must.

use super::{Gpu, mesh};

/// A buffer of plain values, filled anew for every picture.
#[derive(Debug)]
pub(super) struct Filled {
    label: &'static str,
    usage: wgpu::BufferUsages,
    buffer: Option<wgpu::Buffer>,
    count: u32,
}

impl Filled {
    /// An empty buffer of vertices or instances; nothing is allocated.
    pub(super) fn vertices(label: &'static str) -> Self {
        Self { label, usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST, buffer: None, count: 0 }
    }

    /// An empty buffer of indices; nothing is allocated.
    pub(super) fn indices(label: &'static str) -> Self {
        Self { usage: wgpu::BufferUsages::INDEX | wgpu::BufferUsages::COPY_DST, ..Self::vertices(label) }
    }

    /// Replaces the contents.
    pub(super) fn fill<T: bytemuck::Pod>(&mut self, gpu: &Gpu, values: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(values);
        self.count = mesh::count(values);
        if bytes.is_empty() {
            return;
        }
        let size = bytes.len() as u64;
        let room = self.buffer.take().filter(|b| b.size() >= size);
        let buffer = room.unwrap_or_else(|| gpu.buffer(self.label, size.next_power_of_two().max(256), self.usage));
        gpu.queue.write_buffer(&buffer, 0, bytes);
        self.buffer = Some(buffer);
    }

    /// How many values it holds.
    pub(super) fn count(&self) -> u32 {
        self.count
    }

    /// The buffer, unless it holds nothing.
    pub(super) fn filled(&self) -> Option<&wgpu::Buffer> {
        self.buffer.as_ref().filter(|_| self.count > 0)
    }
}
