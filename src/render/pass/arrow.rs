//! Force arrows: a rim first, so that they stand out from anything, then the lit arrow.

use crate::render::Gpu;
use crate::render::buffer::Filled;
use crate::render::frame::Frame;
use crate::render::mesh::{ArrowVertex, arrow, count};
use crate::render::pipeline::{Depth, Recipe, per_instance, per_vertex};
use crate::view::list::Arrow;

pub(in crate::render) const SHADER: &str =
    concat!(include_str!("../../../shaders/shared/frame.wgsl"), include_str!("../../../shaders/arrow.wgsl"));

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Instance {
    from: [f32; 3],
    to: [f32; 3],
    radius: f32,
    color: [u8; 4],
    rim: [u8; 4],
}

/// The arrows' pass.
#[derive(Debug)]
pub(in crate::render) struct ArrowPass {
    rim: wgpu::RenderPipeline,
    body: wgpu::RenderPipeline,
    mesh: wgpu::Buffer,
    vertices: u32,
    instances: Filled,
}

impl ArrowPass {
    pub(in crate::render) fn new(gpu: &Gpu, frame: &Frame, samples: u32) -> Self {
        let vertex = wgpu::vertex_attr_array![0 => Float32x2, 1 => Float32x4, 2 => Float32x2];
        let instance =
            wgpu::vertex_attr_array![3 => Float32x3, 4 => Float32x3, 5 => Float32, 6 => Unorm8x4, 7 => Unorm8x4];
        let recipe = |vertex_entry, fragment_entry, depth| {
            Recipe {
                label: "arrow",
                shader: SHADER,
                vertex: vertex_entry,
                fragment: fragment_entry,
                groups: &[&frame.layout],
                buffers: &[per_vertex::<ArrowVertex>(&vertex), per_instance::<Instance>(&instance)],
                depth,
                cull: None,
                samples,
                constants: &[],
            }
            .build(gpu)
        };
        let mesh = arrow();
        let vertices = count(&mesh);
        Self {
            rim: recipe("vertex_rim", "fragment_rim", Depth::Ignore),
            body: recipe("vertex", "fragment", Depth::Write),
            mesh: gpu.mesh("arrow", &mesh),
            vertices,
            instances: Filled::vertices("arrows"),
        }
    }

    pub(in crate::render) fn fill(&mut self, gpu: &Gpu, arrows: &[&Arrow]) {
        let instance = |a: &&Arrow| Instance {
            from: a.from.to_array(),
            to: a.to.to_array(),
            radius: a.radius,
            color: a.color.0,
            rim: a.halo.0,
        };
        let instances: Vec<_> = arrows.iter().map(instance).collect();
        self.instances.fill(gpu, &instances);
    }

    pub(in crate::render) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(instances) = self.instances.filled() {
            pass.set_vertex_buffer(0, self.mesh.slice(..));
            pass.set_vertex_buffer(1, instances.slice(..));
            for pipeline in [&self.rim, &self.body] {
                pass.set_pipeline(pipeline);
                pass.draw(0..self.vertices, 0..self.instances.count());
            }
        }
    }
}
