//! Lines of a width in pixels, hidden by bodies or seen through them.

use crate::render::Gpu;
use crate::render::buffer::Filled;
use crate::render::frame::Frame;
use crate::render::pipeline::{Depth, Recipe, per_instance};
use crate::view::list::Line;

pub(in crate::render) const SHADER: &str =
    concat!(include_str!("../../../shaders/shared/frame.wgsl"), include_str!("../../../shaders/line.wgsl"));

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Instance {
    from: [f32; 3],
    to: [f32; 3],
    color: [u8; 4],
    width: f32,
}

/// A pass of lines.
#[derive(Debug)]
pub(in crate::render) struct LinePass {
    pipeline: wgpu::RenderPipeline,
    instances: Filled,
}

impl LinePass {
    /// `depth` says whether bodies hide the lines.
    pub(in crate::render) fn new(gpu: &Gpu, frame: &Frame, label: &'static str, depth: Depth, samples: u32) -> Self {
        let attributes = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4, 3 => Float32];
        let recipe = Recipe {
            label,
            shader: SHADER,
            vertex: "vertex",
            fragment: "fragment",
            groups: &[&frame.layout],
            buffers: &[per_instance::<Instance>(&attributes)],
            depth,
            cull: None,
            samples,
            constants: &[],
        };
        Self { pipeline: recipe.build(gpu), instances: Filled::vertices(label) }
    }

    pub(in crate::render) fn fill(&mut self, gpu: &Gpu, lines: &[&Line]) {
        let instance =
            |l: &&Line| Instance { from: l.from.to_array(), to: l.to.to_array(), color: l.color.0, width: l.width };
        let instances: Vec<_> = lines.iter().map(instance).collect();
        self.instances.fill(gpu, &instances);
    }

    pub(in crate::render) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(instances) = self.instances.filled() {
            pass.set_pipeline(&self.pipeline);
            pass.set_vertex_buffer(0, instances.slice(..));
            pass.draw(0..6, 0..self.instances.count());
        }
    }
}
