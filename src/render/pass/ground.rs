//! The ground: shadow and grid.

use super::shadow::Shadow;
use crate::render::Gpu;
use crate::render::frame::{Frame, color, uniform};
use crate::render::pipeline::{Depth, Recipe};
use crate::view::list::Ground;

pub(in crate::render) const SHADER: &str = concat!(
    include_str!("../../../shaders/shared/frame.wgsl"),
    include_str!("../../../shaders/shared/sun.wgsl"),
    include_str!("../../../shaders/ground.wgsl")
);

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct GroundUniform {
    place: [f32; 4],
    spacing: [f32; 4],
    grid: [f32; 4],
    shadow: [f32; 4],
}

/// The ground's pass.
#[derive(Debug)]
pub(in crate::render) struct GroundPass {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    buffer: wgpu::Buffer,
}

impl GroundPass {
    pub(in crate::render) fn new(gpu: &Gpu, frame: &Frame, shadow: &Shadow, samples: u32) -> Self {
        let (layout, group, buffer) = uniform(gpu, "ground", size_of::<GroundUniform>() as u64);
        let recipe = Recipe {
            label: "ground",
            shader: SHADER,
            vertex: "vertex",
            fragment: "fragment",
            groups: &[&frame.layout, &shadow.layout, &layout],
            buffers: &[],
            depth: Depth::Test,
            cull: None,
            samples,
            constants: &[shadow.look_ups],
        };
        Self { pipeline: recipe.build(gpu), group, buffer }
    }

    pub(in crate::render) fn fill(&self, gpu: &Gpu, ground: &Ground) {
        let data = GroundUniform {
            place: ground.centre.extend(ground.radius).to_array(),
            spacing: [ground.spacing.unwrap_or(0.0), 0.0, 0.0, 0.0],
            grid: color(ground.grid),
            shadow: color(ground.shadow),
        };
        gpu.queue.write_buffer(&self.buffer, 0, bytemuck::bytes_of(&data));
    }

    pub(in crate::render) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, shadow: &Shadow) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(1, &shadow.group, &[]);
        pass.set_bind_group(2, &self.group, &[]);
        pass.draw(0..6, 0..1);
    }
}
