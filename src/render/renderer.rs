//! Draws lists: keeps targets and passes, builds each only when a list wants it.

use super::frame::{Frame, color};
use super::pass::Depth;
use super::pass::arrow::ArrowPass;
use super::pass::backdrop::Backdrop;
use super::pass::cone::ConePass;
use super::pass::ground::GroundPass;
use super::pass::line::LinePass;
use super::pass::overlay::Overlay;
use super::pass::shadow::Shadow;
use super::pass::solid::{SolidPass, Solids};
use super::target::Target;
use super::{Gpu, GpuError, Image, Quality, image};
use crate::view::DrawList;

/// Passes built so far.
#[derive(Debug, Default)]
struct Passes {
    backdrop: Option<Backdrop>,
    shadow: Option<Shadow>,
    ground: Option<GroundPass>,
    solids: Option<(SolidPass, Solids)>,
    ghosts: Option<(SolidPass, Solids)>,
    lines: Option<LinePass>,
    xray_lines: Option<LinePass>,
    cones: Option<ConePass>,
    arrows: Option<ArrowPass>,
    overlay: Option<Overlay>,
}

/// Draws lists. Two draws must not be recorded before the first is submitted: they share their buffers.
#[derive(Debug)]
pub struct Renderer {
    quality: Quality,
    frame: Frame,
    passes: Passes,
    target: Option<Target>,
}

impl Renderer {
    /// A renderer with no pass built yet.
    pub fn new(gpu: &Gpu, quality: Quality) -> Self {
        let quality = quality.checked();
        Self { quality, frame: Frame::new(gpu), passes: Passes::default(), target: None }
    }

    /// Draws a list into the renderer's own RGBA8 target (sRGB-encoded already, premultiplied) and gives that back.
    ///
    /// `size` is held within what the device draws.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        list: &DrawList,
        size: [u32; 2],
    ) -> &wgpu::TextureView {
        let limit = gpu.device.limits().max_texture_dimension_2d;
        let size = size.map(|s| s.clamp(1, limit));
        let kept = self.target.take().filter(|t| t.size == size);
        let target = kept.unwrap_or_else(|| Target::new(gpu, size, self.quality));
        self.frame.write(gpu, list, size, self.quality);
        self.passes.prepare(gpu, &self.frame, list, self.quality);
        self.passes.encode(encoder, &self.frame, list, &target);
        &self.target.insert(target).view
    }

    /// Draws a list and reads the picture back.
    ///
    /// # Errors
    /// When the size is not one that the device draws, or the read-back fails.
    pub fn picture(&mut self, gpu: &Gpu, list: &DrawList, size: [u32; 2]) -> Result<Image, GpuError> {
        image::check_size(gpu, size)?;
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.draw(gpu, &mut encoder, list, size);
        let target = self.target.as_ref().ok_or_else(|| GpuError::Readback("nothing was drawn".to_owned()))?;
        image::read_back(gpu, encoder, &target.texture)
    }

    /// The passes that have been built, by the stem of their file.
    pub fn built(&self) -> Vec<&'static str> {
        let p = &self.passes;
        let all = [
            ("backdrop", p.backdrop.is_some()),
            ("shadow", p.shadow.is_some()),
            ("ground", p.ground.is_some()),
            ("solid", p.solids.is_some() || p.ghosts.is_some()),
            ("line", p.lines.is_some() || p.xray_lines.is_some()),
            ("cone", p.cones.is_some()),
            ("arrow", p.arrows.is_some()),
            ("overlay", p.overlay.is_some()),
        ];
        all.into_iter().filter(|(_, built)| *built).map(|(stem, _)| stem).collect()
    }
}

impl Passes {
    /// Builds the passes that the list wants, and hands them what they draw.
    fn prepare(&mut self, gpu: &Gpu, frame: &Frame, list: &DrawList, quality: Quality) {
        let samples = quality.samples;
        if list.frame.sky != list.frame.floor {
            self.backdrop.get_or_insert_with(|| Backdrop::new(gpu, frame, samples));
        }
        if list.ground.is_some() || !list.solids.is_empty() || !list.ghosts.is_empty() {
            self.prepare_lit(gpu, frame, list, quality);
        }
        let lines = |depth| move || LinePass::new(gpu, frame, depth, samples);
        if !list.lines.is_empty() {
            self.lines.get_or_insert_with(lines(Depth::Test)).fill(gpu, &list.lines);
        }
        if !list.xray_lines.is_empty() {
            self.xray_lines.get_or_insert_with(lines(Depth::Ignore)).fill(gpu, &list.xray_lines);
        }
        if !list.cones.is_empty() {
            self.cones.get_or_insert_with(|| ConePass::new(gpu, frame, samples)).fill(gpu, &list.cones);
        }
        if !list.arrows.is_empty() {
            self.arrows.get_or_insert_with(|| ArrowPass::new(gpu, frame, samples)).fill(gpu, &list.arrows);
        }
        if !list.marks.is_empty() {
            self.overlay.get_or_insert_with(|| Overlay::new(gpu, frame, samples)).fill(gpu, list);
        }
    }

    /// Bodies and ground, which share the shadow map.
    fn prepare_lit(&mut self, gpu: &Gpu, frame: &Frame, list: &DrawList, quality: Quality) {
        let samples = quality.samples;
        let shadow = &*self.shadow.get_or_insert_with(|| Shadow::new(gpu, frame, quality));
        if let Some(ground) = &list.ground {
            self.ground.get_or_insert_with(|| GroundPass::new(gpu, frame, shadow, samples)).fill(gpu, ground);
        }
        let build = |depth| move || (SolidPass::new(gpu, frame, shadow, depth, samples), Solids::new(gpu));
        if !list.solids.is_empty() {
            self.solids.get_or_insert_with(build(Depth::Write)).1.fill(gpu, &list.solids);
        }
        if !list.ghosts.is_empty() {
            self.ghosts.get_or_insert_with(build(Depth::Test)).1.fill(gpu, &list.ghosts);
        }
    }

    /// Records what the list has something for.
    fn encode(&self, encoder: &mut wgpu::CommandEncoder, frame: &Frame, list: &DrawList, target: &Target) {
        let solids = self.solids.as_ref().filter(|_| !list.solids.is_empty());
        let ghosts = self.ghosts.as_ref().filter(|_| !list.ghosts.is_empty());
        let shadow = self.shadow.as_ref().filter(|_| list.ground.is_some() || solids.or(ghosts).is_some());
        if let Some(shadow) = shadow {
            shadow.draw(encoder, frame, solids.map(|(_, solids)| solids));
        }
        let on_top =
            !(list.xray_lines.is_empty() && list.cones.is_empty() && list.arrows.is_empty() && list.marks.is_empty());
        let mut pass = target.begin(encoder, "bodies", Some(clear_color(list)), !on_top);
        pass.set_bind_group(0, &frame.group, &[]);
        if let Some(backdrop) = self.backdrop.as_ref().filter(|_| list.frame.sky != list.frame.floor) {
            backdrop.draw(&mut pass);
        }
        if let (Some(ground), Some(shadow), true) = (&self.ground, shadow, list.ground.is_some()) {
            ground.draw(&mut pass, shadow);
        }
        for (solid, solids) in solids.into_iter().chain(ghosts) {
            if let Some(shadow) = shadow {
                solid.draw(&mut pass, shadow, solids);
            }
        }
        if let Some(lines) = self.lines.as_ref().filter(|_| !list.lines.is_empty()) {
            lines.draw(&mut pass);
        }
        drop(pass);
        if on_top {
            self.encode_on_top(encoder, frame, list, target);
        }
    }

    /// What is seen through bodies, with a depth of its own, and what is flat.
    fn encode_on_top(&self, encoder: &mut wgpu::CommandEncoder, frame: &Frame, list: &DrawList, target: &Target) {
        let mut pass = target.begin(encoder, "seen through bodies", None, true);
        pass.set_bind_group(0, &frame.group, &[]);
        if let Some(cones) = self.cones.as_ref().filter(|_| !list.cones.is_empty()) {
            cones.draw(&mut pass);
        }
        if let Some(lines) = self.xray_lines.as_ref().filter(|_| !list.xray_lines.is_empty()) {
            lines.draw(&mut pass);
        }
        if let Some(arrows) = self.arrows.as_ref().filter(|_| !list.arrows.is_empty()) {
            arrows.draw(&mut pass);
        }
        if let Some(overlay) = self.overlay.as_ref().filter(|_| !list.marks.is_empty()) {
            overlay.draw(&mut pass);
        }
    }
}

fn clear_color(list: &DrawList) -> wgpu::Color {
    let [r, g, b, a] = color(list.frame.floor).map(f64::from);
    wgpu::Color { r: r * a, g: g * a, b: b * a, a }
}
