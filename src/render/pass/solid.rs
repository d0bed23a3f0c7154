//! Bodies: instances of one mesh, shared by the shadow map and the picture.

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

/// The mesh that every solid is an instance of.
#[derive(Debug)]
pub(in crate::render) struct Prism {
    mesh: wgpu::Buffer,
    vertices: u32,
}

impl Prism {
    pub(in crate::render) fn new(gpu: &Gpu) -> Self {
        let mesh = prism();
        Self { vertices: count(&mesh), mesh: gpu.mesh("prism", &mesh) }
    }
}

/// Solids of the picture in hand: those in view, then those that only throw shadows into it.
#[derive(Debug)]
pub(in crate::render) struct Solids {
    instances: Filled,
    in_view: u32,
}

/// Attributes of a vertex and of an instance.
pub(in crate::render) type Attributes = ([wgpu::VertexAttribute; 3], [wgpu::VertexAttribute; 6]);

impl Solids {
    /// No solids; nothing is allocated.
    pub(in crate::render) fn new(label: &'static str) -> Self {
        Self { instances: Filled::vertices(label), in_view: 0 }
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

    pub(in crate::render) fn fill(&mut self, gpu: &Gpu, in_view: &[&Solid], casters: &[&Solid]) {
        let instance =
            |s: &&Solid| Instance { face: s.face.map(|p| p.to_array()), sweep: s.sweep.to_array(), color: s.color.0 };
        let instances: Vec<_> = in_view.iter().chain(casters).map(instance).collect();
        self.instances.fill(gpu, &instances);
        self.in_view = count(in_view);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, prism: &Prism, count: u32) {
        if let Some(instances) = self.instances.filled() {
            pass.set_vertex_buffer(0, prism.mesh.slice(..));
            pass.set_vertex_buffer(1, instances.slice(..));
            pass.draw(0..prism.vertices, 0..count);
        }
    }

    /// Draws those in view and those that throw shadows into it.
    pub(in crate::render) fn draw_casters(&self, pass: &mut wgpu::RenderPass<'_>, prism: &Prism) {
        self.draw(pass, prism, self.instances.count());
    }
}

/// The bodies' pass.
#[derive(Debug)]
pub(in crate::render) struct SolidPass {
    pipeline: wgpu::RenderPipeline,
}

impl SolidPass {
    /// `depth` says whether the solids hide what is behind them.
    pub(in crate::render) fn new(
        gpu: &Gpu,
        frame: &Frame,
        shadow: &Shadow,
        label: &'static str,
        depth: Depth,
        samples: u32,
    ) -> Self {
        let attributes = Solids::attributes();
        let recipe = Recipe {
            label,
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

    /// Draws those in view.
    pub(in crate::render) fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        shadow: &Shadow,
        prism: &Prism,
        solids: &Solids,
    ) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(1, &shadow.group, &[]);
        solids.draw(pass, prism, solids.in_view);
    }
}
