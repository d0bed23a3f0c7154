//! Bodies: instances of one mesh, shared by the shadow map and the picture.

use wgpu::util::DeviceExt;

use super::shadow::Shadow;
use super::{Depth, Recipe, per_instance, per_vertex};
use crate::render::Gpu;
use crate::render::buffer::Filled;
use crate::render::frame::Frame;
use crate::render::mesh::{PrismVertex, count, prism};
use crate::view::list::Solid;

pub(in crate::render) const SHADER: &str = concat!(
    include_str!("../../../shaders/shared/frame.wgsl"),
    include_str!("../../../shaders/shared/sun.wgsl"),
    include_str!("../../../shaders/shared/prism.wgsl"),
    include_str!("../../../shaders/solid.wgsl")
);

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Instance {
    face: [[f32; 3]; 4],
    sweep: [f32; 3],
    color: [u8; 4],
}

/// Solids of the picture in hand.
#[derive(Debug)]
pub(in crate::render) struct Solids {
    mesh: wgpu::Buffer,
    vertices: u32,
    instances: Filled,
}

/// Attributes of a vertex and of an instance.
pub(in crate::render) type Attributes = ([wgpu::VertexAttribute; 3], [wgpu::VertexAttribute; 6]);

impl Solids {
    pub(in crate::render) fn new(gpu: &Gpu) -> Self {
        let mesh = prism();
        let vertices = count(&mesh);
        let mesh = gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("prism"),
            contents: bytemuck::cast_slice(&mesh),
            usage: wgpu::BufferUsages::VERTEX,
        });
        Self { mesh, vertices, instances: Filled::vertices("solids") }
    }

    pub(in crate::render) fn attributes() -> Attributes {
        (
            wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x4, 2 => Float32x2],
            wgpu::vertex_attr_array![
                3 => Float32x3, 4 => Float32x3, 5 => Float32x3, 6 => Float32x3, 7 => Float32x3, 8 => Unorm8x4
            ],
        )
    }

    pub(in crate::render) fn buffers((vertex, instance): &Attributes) -> [wgpu::VertexBufferLayout<'_>; 2] {
        [per_vertex::<PrismVertex>(vertex), per_instance::<Instance>(instance)]
    }

    pub(in crate::render) fn fill(&mut self, gpu: &Gpu, solids: &[Solid]) {
        let instance =
            |s: &Solid| Instance { face: s.face.map(|p| p.to_array()), sweep: s.sweep.to_array(), color: s.color.0 };
        let instances: Vec<_> = solids.iter().map(instance).collect();
        self.instances.fill(gpu, &instances);
    }

    pub(in crate::render) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(instances) = self.instances.filled() {
            pass.set_vertex_buffer(0, self.mesh.slice(..));
            pass.set_vertex_buffer(1, instances.slice(..));
            pass.draw(0..self.vertices, 0..self.instances.count());
        }
    }
}

/// The bodies' pass.
#[derive(Debug)]
pub(in crate::render) struct SolidPass {
    pipeline: wgpu::RenderPipeline,
}

impl SolidPass {
    /// `depth` says whether the solids hide what is behind them.
    pub(in crate::render) fn new(gpu: &Gpu, frame: &Frame, shadow: &Shadow, depth: Depth, samples: u32) -> Self {
        let attributes = Solids::attributes();
        let recipe = Recipe {
            label: "solid",
            shader: SHADER,
            vertex: "vertex",
            fragment: "fragment",
            groups: &[&frame.layout, &shadow.layout],
            buffers: &Solids::buffers(&attributes),
            depth,
            cull: Some(wgpu::Face::Back),
            samples,
        };
        Self { pipeline: recipe.build(gpu) }
    }

    pub(in crate::render) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, shadow: &Shadow, solids: &Solids) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(1, &shadow.group, &[]);
        solids.draw(pass);
    }
}
