//! Depth where nothing is: a part of a picture or of the shadow map whose depth begins anew.

use crate::render::Gpu;
use crate::render::pipeline::{Depth, Recipe};

pub(in crate::render) const SHADER: &str = include_str!("../../../shaders/far.wgsl");

/// The pass that sets depth.
#[derive(Debug)]
pub(in crate::render) struct Far(wgpu::RenderPipeline);

impl Far {
    /// In a picture.
    pub(in crate::render) fn new(gpu: &Gpu, samples: u32) -> Self {
        Self(recipe("fragment", samples).build(gpu))
    }

    /// In a target that has depth alone.
    pub(in crate::render) fn of_depth(gpu: &Gpu) -> Self {
        Self(recipe("", 1).build_depth(gpu, wgpu::DepthBiasState::default()))
    }

    pub(in crate::render) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.0);
        pass.draw(0..3, 0..1);
    }
}

fn recipe(fragment: &'static str, samples: u32) -> Recipe<'static> {
    Recipe {
        label: "far",
        shader: SHADER,
        vertex: "vertex",
        fragment,
        groups: &[],
        buffers: &[],
        depth: Depth::Set,
        cull: None,
        samples,
        constants: &[],
    }
}
