//! Bodies, lit and shaded.

use super::shadow::Shadow;
use crate::render::Gpu;
use crate::render::frame::Frame;
use crate::render::pipeline::{Depth, Recipe};
use crate::render::solids::Solids;

pub(in crate::render) const SHADER: &str = concat!(
    include_str!("../../../shaders/shared/frame.wgsl"),
    include_str!("../../../shaders/shared/sun.wgsl"),
    include_str!("../../../shaders/shared/prism.wgsl"),
    include_str!("../../../shaders/solid.wgsl")
);

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
            constants: &[shadow.look_ups],
        };
        Self { pipeline: recipe.build(gpu) }
    }

    /// Begins with drawing bodies.
    pub(in crate::render) fn begin(&self, pass: &mut wgpu::RenderPass<'_>, shadow: &Shadow) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(1, &shadow.group, &[]);
    }
}
