//! Target of a picture: colour, its samples, depth.

use super::made::Thing;
use super::pipeline::{COLOR, DEPTH};
use super::{Gpu, Quality};

/// Targets of one size.
#[derive(Debug)]
pub(super) struct Target {
    pub(super) size: [u32; 2],
    pub(super) texture: wgpu::Texture,
    pub(super) view: wgpu::TextureView,
    samples: Option<wgpu::TextureView>,
    depth: wgpu::TextureView,
}

fn texture(gpu: &Gpu, label: &'static str, size: [u32; 2], samples: u32, format: wgpu::TextureFormat) -> wgpu::Texture {
    let extra = if samples == 1 && format == COLOR {
        wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_SRC
    } else {
        wgpu::TextureUsages::empty()
    };
    gpu.texture(label, size, samples, format, wgpu::TextureUsages::RENDER_ATTACHMENT | extra)
}

impl Target {
    pub(super) fn new(gpu: &Gpu, size: [u32; 2], quality: Quality) -> Self {
        let view = |t: &wgpu::Texture| t.create_view(&wgpu::TextureViewDescriptor::default());
        let color = texture(gpu, "picture", size, 1, COLOR);
        let samples = (quality.samples > 1).then(|| view(&texture(gpu, "samples", size, quality.samples, COLOR)));
        let depth = view(&texture(gpu, "depth", size, quality.samples, DEPTH));
        Self { size, view: view(&color), texture: color, samples, depth }
    }

    /// Begins drawing: on a cleared picture, or on what is there; depth is always cleared, and samples are settled at the end.
    pub(super) fn begin<'e>(
        &self,
        gpu: &Gpu,
        encoder: &'e mut wgpu::CommandEncoder,
        clear: Option<wgpu::Color>,
    ) -> wgpu::RenderPass<'e> {
        let load = clear.map_or(wgpu::LoadOp::Load, wgpu::LoadOp::Clear);
        // Settled samples have done their work.
        let store = if self.samples.is_some() { wgpu::StoreOp::Discard } else { wgpu::StoreOp::Store };
        let color = wgpu::RenderPassColorAttachment {
            view: self.samples.as_ref().unwrap_or(&self.view),
            depth_slice: None,
            resolve_target: self.samples.as_ref().map(|_| &self.view),
            ops: wgpu::Operations { load, store },
        };
        let depth = wgpu::RenderPassDepthStencilAttachment {
            view: &self.depth,
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(1.0), store: wgpu::StoreOp::Discard }),
            stencil_ops: None,
        };
        gpu.count(Thing::Pass, "picture", 1);
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(color)],
            depth_stencil_attachment: Some(depth),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }
}
