//! Filled friction cones.

use crate::render::Gpu;
use crate::render::buffer::Filled;
use crate::render::frame::Frame;
use crate::render::mesh::{cone, count};
use crate::render::pipeline::{Depth, Recipe, per_instance, per_vertex};
use crate::view::list::Cone;

pub(in crate::render) const SHADER: &str =
    concat!(include_str!("../../../shaders/shared/frame.wgsl"), include_str!("../../../shaders/cone.wgsl"));

/// Alpha of each wall of a filled cone, 0 to 255 (chosen).
const THIN: u8 = 0x34;

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Instance {
    apex: [f32; 3],
    axis: [f32; 3],
    shape: [f32; 2],
    color: [u8; 4],
}

/// The filled cones' pass.
#[derive(Debug)]
pub(in crate::render) struct ConePass {
    pipeline: wgpu::RenderPipeline,
    mesh: wgpu::Buffer,
    vertices: u32,
    instances: Filled,
}

impl ConePass {
    pub(in crate::render) fn new(gpu: &Gpu, frame: &Frame, samples: u32) -> Self {
        let vertex = wgpu::vertex_attr_array![0 => Float32x3];
        let instance = wgpu::vertex_attr_array![1 => Float32x3, 2 => Float32x3, 3 => Float32x2, 4 => Unorm8x4];
        let recipe = Recipe {
            label: "cone",
            shader: SHADER,
            vertex: "vertex",
            fragment: "fragment",
            groups: &[&frame.layout],
            buffers: &[per_vertex::<[f32; 3]>(&vertex), per_instance::<Instance>(&instance)],
            depth: Depth::Ignore,
            cull: None,
            samples,
            constants: &[],
        };
        let mesh = cone();
        let vertices = count(&mesh);
        let mesh = gpu.mesh("cone", &mesh);
        Self { pipeline: recipe.build(gpu), mesh, vertices, instances: Filled::vertices("cones") }
    }

    pub(in crate::render) fn fill(&mut self, gpu: &Gpu, cones: &[&Cone]) {
        let instance = |c: &&Cone| Instance {
            apex: c.apex.to_array(),
            axis: c.axis.to_array(),
            shape: [c.height, c.mu_kinetic],
            color: c.color.with_alpha(THIN).0,
        };
        let instances: Vec<_> = cones.iter().map(instance).collect();
        self.instances.fill(gpu, &instances);
    }

    pub(in crate::render) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(instances) = self.instances.filled() {
            pass.set_pipeline(&self.pipeline);
            pass.set_vertex_buffer(0, self.mesh.slice(..));
            pass.set_vertex_buffer(1, instances.slice(..));
            pass.draw(0..self.vertices, 0..self.instances.count());
        }
    }
}
