//! The shadow map: depth of the solids as the light sees them.

use crate::render::frame::Frame;
use crate::render::made::Thing;
use crate::render::pass::far::Far;
use crate::render::pipeline::{DEPTH, Depth, Recipe};
use crate::render::solids::{Prism, Solids};
use crate::render::{Gpu, Quality, Regions};

pub(in crate::render) const SHADER: &str = concat!(
    include_str!("../../../shaders/shared/frame.wgsl"),
    include_str!("../../../shaders/shared/prism.wgsl"),
    include_str!("../../../shaders/shadow.wgsl")
);

/// The shadow map and its pass.
#[derive(Debug)]
pub(in crate::render) struct Shadow {
    pipeline: wgpu::RenderPipeline,
    map: wgpu::TextureView,
    /// For the passes that look shadows up.
    pub(in crate::render) layout: wgpu::BindGroupLayout,
    /// For the passes that look shadows up.
    pub(in crate::render) group: wgpu::BindGroup,
    /// Override of these passes: root of the look-ups per pixel. In a loop of a length that is not known before, a processor takes a third
    /// longer for the ground (30 ns a pixel for one look-up, 54 for nine, where 22 and 37 do; llvmpipe).
    pub(in crate::render) look_ups: (&'static str, f64),
}

impl Shadow {
    pub(in crate::render) fn new(gpu: &Gpu, frame: &Frame, quality: Quality) -> Self {
        let attributes = Solids::attributes();
        let recipe = Recipe {
            label: "shadow",
            shader: SHADER,
            vertex: "vertex",
            fragment: "",
            groups: &[&frame.layout],
            buffers: &Solids::buffers(&attributes),
            depth: Depth::Write,
            cull: None,
            samples: 1,
            constants: &[],
        };
        let map = map(gpu, quality.shadow_map_size());
        // Pushed away by a little, so that a surface does not shade itself.
        let bias = wgpu::DepthBiasState { constant: 2, slope_scale: 1.5, clamp: 0.0 };
        let layout = layout(gpu);
        let group = group(gpu, &layout, &map);
        let look_ups = ("look_ups", f64::from(quality.shadow_taps.isqrt()));
        Self { pipeline: recipe.build_depth(gpu, bias), map, layout, group, look_ups }
    }

    /// Draws the solids' depth into the map, or into parts of it over the depths before.
    pub(in crate::render) fn draw(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        frame: &Frame,
        solids: Option<(&Prism, &Solids)>,
        parts: Option<(&Regions, &Far)>,
    ) {
        if parts.is_some_and(|(parts, _)| parts.is_empty()) {
            return;
        }
        let load = if parts.is_some() { wgpu::LoadOp::Load } else { wgpu::LoadOp::Clear(1.0) };
        gpu.count(Thing::Pass, "shadow", 1);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("shadow"),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.map,
                depth_ops: Some(wgpu::Operations { load, store: wgpu::StoreOp::Store }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        let draw = |pass: &mut wgpu::RenderPass<'_>| {
            if let Some((prism, solids)) = solids {
                pass.set_pipeline(&self.pipeline);
                pass.set_bind_group(0, &frame.group, &[]);
                solids.draw_casters(pass, prism);
            }
        };
        let Some((parts, far)) = parts else { return draw(&mut pass) };
        for part in parts.iter() {
            part.cut(&mut pass);
            far.draw(&mut pass);
            draw(&mut pass);
        }
    }
}

fn map(gpu: &Gpu, side: u32) -> wgpu::TextureView {
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
    let texture = gpu.texture("shadow map", [side, side], 1, DEPTH, usage);
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

fn layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let entry =
        |binding, ty| wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::FRAGMENT, ty, count: None };
    let map = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Depth,
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Comparison);
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("shadow map"),
        entries: &[entry(0, map), entry(1, sampler)],
    })
}

fn group(gpu: &Gpu, layout: &wgpu::BindGroupLayout, map: &wgpu::TextureView) -> wgpu::BindGroup {
    let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("shadow map"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        compare: Some(wgpu::CompareFunction::LessEqual),
        ..Default::default()
    });
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("shadow map"),
        layout,
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(map) },
            wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
        ],
    })
}
