//! Bodies: instances of one mesh, shared by the shadow map and the picture.

use std::ops::Range;

use super::Gpu;
use super::buffer::Filled;
use super::mesh::{PrismVertex, count, prism};
use super::pipeline::{per_instance, per_vertex};
use crate::view::list::Solid;

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Instance {
    face: [[f32; 3]; 4],
    sweep: [f32; 3],
    color: [u8; 4],
}

/// The mesh that every solid is an instance of.
#[derive(Debug)]
pub(super) struct Prism {
    mesh: wgpu::Buffer,
    vertices: u32,
}

impl Prism {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let mesh = prism();
        Self { vertices: count(&mesh), mesh: gpu.mesh("prism", &mesh) }
    }
}

/// Solids of the picture in hand: those in view, of which the opaque ones come first, then those that only throw shadows into it.
#[derive(Debug)]
pub(super) struct Solids {
    instances: Filled,
    opaque: u32,
    in_view: u32,
}

/// Attributes of a vertex and of an instance.
pub(super) type Attributes = ([wgpu::VertexAttribute; 3], [wgpu::VertexAttribute; 6]);

impl Solids {
    /// No solids; nothing is allocated.
    pub(super) fn new(label: &'static str) -> Self {
        Self { instances: Filled::vertices(label), opaque: 0, in_view: 0 }
    }

    pub(super) fn attributes() -> Attributes {
        (
            wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x4, 2 => Float32x2],
            wgpu::vertex_attr_array![
                3 => Float32x3, 4 => Float32x3, 5 => Float32x3, 6 => Float32x3, 7 => Float32x3, 8 => Unorm8x4
            ],
        )
    }

    pub(super) fn buffers((vertex, instance): &Attributes) -> [wgpu::VertexBufferLayout<'_>; 2] {
        [per_vertex::<PrismVertex>(vertex), per_instance::<Instance>(instance)]
    }

    /// Takes in the solids in view, of which the first `opaque` are opaque, and those that throw shadows.
    pub(super) fn fill(&mut self, gpu: &Gpu, (in_view, opaque): (&[&Solid], usize), casters: &[&Solid]) {
        let instance =
            |s: &&Solid| Instance { face: s.face.map(|p| p.to_array()), sweep: s.sweep.to_array(), color: s.color.0 };
        let instances: Vec<_> = in_view.iter().chain(casters).map(instance).collect();
        self.instances.fill(gpu, &instances);
        (self.opaque, self.in_view) = (count(&in_view[..opaque]), count(in_view));
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, prism: &Prism, which: Range<u32>) {
        if let Some(instances) = self.instances.filled().filter(|_| !which.is_empty()) {
            pass.set_vertex_buffer(0, prism.mesh.slice(..));
            pass.set_vertex_buffer(1, instances.slice(..));
            pass.draw(0..prism.vertices, which);
        }
    }

    /// Draws those in view that are opaque.
    pub(super) fn draw_opaque(&self, pass: &mut wgpu::RenderPass<'_>, prism: &Prism) {
        self.draw(pass, prism, 0..self.opaque);
    }

    /// Draws those in view that let something through.
    pub(super) fn draw_clear(&self, pass: &mut wgpu::RenderPass<'_>, prism: &Prism) {
        self.draw(pass, prism, self.opaque..self.in_view);
    }

    /// Draws those in view and those that throw shadows into it.
    pub(super) fn draw_casters(&self, pass: &mut wgpu::RenderPass<'_>, prism: &Prism) {
        self.draw(pass, prism, 0..self.instances.count());
    }
}
