//! Text and flat marks: one mesh of triangles with the font atlas.

use epaint::{ImageDelta, Mesh, Vertex};

use crate::render::Gpu;
use crate::render::buffer::Filled;
use crate::render::flat::Flat;
use crate::render::frame::Frame;
use crate::render::pipeline::{Depth, Recipe, per_vertex};
use crate::view::list::Mark;

pub(in crate::render) const SHADER: &str =
    concat!(include_str!("../../../shaders/shared/frame.wgsl"), include_str!("../../../shaders/overlay.wgsl"));

/// The overlay's pass, with its fonts.
pub(in crate::render) struct Overlay {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    atlas: Option<(wgpu::Texture, wgpu::BindGroup)>,
    vertices: Filled,
    indices: Filled,
    flat: Flat,
}

impl std::fmt::Debug for Overlay {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Overlay").field("vertices", &self.vertices).finish_non_exhaustive()
    }
}

impl Overlay {
    pub(in crate::render) fn new(gpu: &Gpu, frame: &Frame, samples: u32) -> Self {
        let layout = layout(gpu);
        let attributes = wgpu::vertex_attr_array![0 => Float32x2, 1 => Float32x2, 2 => Unorm8x4];
        let recipe = Recipe {
            label: "overlay",
            shader: SHADER,
            vertex: "vertex",
            fragment: "fragment",
            groups: &[&frame.layout, &layout],
            buffers: &[per_vertex::<Vertex>(&attributes)],
            depth: Depth::Ignore,
            cull: None,
            samples,
            constants: &[],
        };
        Self {
            pipeline: recipe.build(gpu),
            layout,
            atlas: None,
            vertices: Filled::vertices("overlay"),
            indices: Filled::indices("overlay"),
            flat: Flat::new(),
        }
    }

    pub(in crate::render) fn fill(&mut self, gpu: &Gpu, marks: &[&Mark]) {
        let Mesh { vertices, indices, .. } = self.flat.mesh(marks);
        if let Some(delta) = self.flat.atlas_change() {
            self.update_atlas(gpu, &delta);
        }
        self.vertices.fill(gpu, &vertices);
        self.indices.fill(gpu, &indices);
    }

    /// Takes over what changed in the font atlas; a whole one replaces the texture.
    fn update_atlas(&mut self, gpu: &Gpu, delta: &ImageDelta) {
        let small = |v: usize| u32::try_from(v).unwrap_or(u32::MAX);
        let [width, height] = delta.image.size().map(small);
        if delta.pos.is_none() || self.atlas.is_none() {
            self.atlas = Some(atlas(gpu, &self.layout, width, height));
        }
        let epaint::ImageData::Color(image) = &delta.image;
        let [x, y] = delta.pos.unwrap_or([0, 0]).map(small);
        if let Some((texture, _)) = &self.atlas {
            gpu.queue.write_texture(
                wgpu::TexelCopyTextureInfo {
                    texture,
                    mip_level: 0,
                    origin: wgpu::Origin3d { x, y, z: 0 },
                    aspect: wgpu::TextureAspect::All,
                },
                bytemuck::cast_slice(&image.pixels),
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * width), rows_per_image: None },
                wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            );
        }
    }

    pub(in crate::render) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let (Some(vertices), Some(indices)) = (self.vertices.filled(), self.indices.filled()) else { return };
        let Some((_, group)) = &self.atlas else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(1, group, &[]);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.indices.count(), 0, 0..1);
    }
}

fn layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let entry =
        |binding, ty| wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::FRAGMENT, ty, count: None };
    let atlas = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: true },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("font atlas"),
        entries: &[entry(0, atlas), entry(1, sampler)],
    })
}

fn atlas(gpu: &Gpu, layout: &wgpu::BindGroupLayout, width: u32, height: u32) -> (wgpu::Texture, wgpu::BindGroup) {
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    let texture = gpu.texture("font atlas", [width, height], 1, wgpu::TextureFormat::Rgba8Unorm, usage);
    let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("font atlas"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    });
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("font atlas"),
        layout,
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) },
            wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
        ],
    });
    (texture, group)
}
