//! Draw lists to pixels with wgpu. Uses the view's lists, not the physics.
//!
//! One pass is one file in `pass/` and one shader of the same stem in `shaders/`. A [`Renderer`] builds a pass when a
//! list first has something for it in view, and runs it only then; [`Gpu::made`] counts what that took. Everything stays inside
//! `downlevel_webgl2_defaults`: instance vertex buffers, uniforms, a comparison sampler, sRGB encoded in the shader.

mod buffer;
mod changes;
mod cull;
mod flat;
mod frame;
mod gpu;
mod health;
mod image;
mod letters;
mod made;
mod mesh;
mod pass;
mod pipeline;
mod quality;
mod readback;
mod region;
mod renderer;
mod solids;
mod target;

pub use changes::changes;
pub use gpu::{AdapterSummary, Gpu, GpuError};
pub use health::{Fault, Health};
pub use image::{Image, Packing};
pub use letters::fonts;
pub use made::{Made, Thing};
pub use pass::shaders;
pub use quality::Quality;
pub use region::{Region, Regions};
pub use renderer::Renderer;
