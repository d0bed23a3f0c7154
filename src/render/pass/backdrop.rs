//! The background where it is not one colour.

use crate::render::Gpu;
use crate::render::frame::Frame;
use crate::render::pipeline::{Depth, Recipe};

pub(in crate::render) const SHADER: &str =
    concat!(include_str!("../../../shaders/shared/frame.wgsl"), include_str!("../../../shaders/backdrop.wgsl"));

/// The background's pass.
#[derive(Debug)]
pub(in crate::render) struct Backdrop {
    pipeline: wgpu::RenderPipeline,
}

impl Backdrop {
    pub(in crate::render) fn new(gpu: &Gpu, frame: &Frame, samples: u32) -> Self {
        let recipe = Recipe {
            label: "backdrop",
            shader: SHADER,
            vertex: "vertex",
            fragment: "fragment",
            groups: &[&frame.layout],
            buffers: &[],
            depth: Depth::Test,
            cull: None,
            samples,
            constants: &[],
        };
        Self { pipeline: recipe.build(gpu) }
    }

    pub(in crate::render) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline);
        pass.draw(0..3, 0..1);
    }
}
