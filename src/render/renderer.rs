//! Draws lists: keeps targets and passes, builds each only when a list wants it.

use std::sync::Arc;

use super::changes::{changes, shadow_changes};
use super::cull::Seen;
use super::frame::{Frame, color};
use super::pass::arrow::ArrowPass;
use super::pass::backdrop::Backdrop;
use super::pass::cone::ConePass;
use super::pass::far::Far;
use super::pass::ground::GroundPass;
use super::pass::line::LinePass;
use super::pass::overlay::Overlay;
use super::pass::shadow::Shadow;
use super::pass::solid::SolidPass;
use super::pipeline::Depth;
use super::readback::{self, Readback};
use super::solids::{Prism, Solids};
use super::target::Target;
use super::{Gpu, GpuError, Image, Quality, Region, Regions};
use crate::view::DrawList;

/// Passes built so far.
#[derive(Debug, Default)]
struct Passes {
    backdrop: Option<Backdrop>,
    shadow: Option<Shadow>,
    ground: Option<GroundPass>,
    prism: Option<Prism>,
    solid: Option<SolidPass>,
    solids: Option<Solids>,
    ghost: Option<SolidPass>,
    ghosts: Option<Solids>,
    lines: Option<LinePass>,
    xray_lines: Option<LinePass>,
    cones: Option<ConePass>,
    arrows: Option<ArrowPass>,
    overlay: Option<Overlay>,
    /// Depth under arrows, which begins anew over the bodies.
    far: Option<Far>,
    /// Depth of the shadow map's parts.
    far_shadow: Option<Far>,
}

/// State of the recording of a picture.
struct Recording<'r> {
    encoder: &'r mut wgpu::CommandEncoder,
    frame: &'r Frame,
    target: &'r Target,
    /// Regions drawn anew over the picture before; the whole picture where `None`.
    parts: Option<&'r Parts>,
}

/// Regions in which a picture differs from the one before.
struct Parts {
    picture: Regions,
    /// Of the shadow map; all of it where nothing is said.
    shadow: Option<Regions>,
}

/// Draws lists. Two draws must not be recorded before the first is submitted: they share their buffers.
#[derive(Debug)]
pub struct Renderer {
    quality: Quality,
    culls: bool,
    frame: Frame,
    passes: Passes,
    target: Option<Target>,
    /// List shown by the target, as far as that is known.
    shown: Option<Arc<DrawList>>,
    readback: Option<Readback>,
}

impl Renderer {
    /// A renderer with no pass built yet.
    pub fn new(gpu: &Gpu, quality: Quality) -> Self {
        let quality = quality.checked();
        let (frame, passes) = (Frame::new(gpu), Passes::default());
        Self { quality, culls: true, frame, passes, target: None, shown: None, readback: None }
    }

    /// How finely it draws.
    pub fn quality(&self) -> Quality {
        self.quality
    }

    /// Whether instances out of view are left out, as they are unless told otherwise; the picture is the same.
    pub fn set_culling(&mut self, culls: bool) {
        self.culls = culls;
    }

    /// Whether it leaves out what is out of view.
    pub fn culls(&self) -> bool {
        self.culls
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
        self.shown = None;
        self.draw_parts(gpu, encoder, list, size, None)
    }

    /// Draws a list as [`Renderer::draw`] does, and of its picture only what differs from the one that it drew before in this way.
    /// Samples are not kept: with more than one a pixel all is drawn.
    pub fn draw_changes(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        list: &Arc<DrawList>,
    ) -> &wgpu::TextureView {
        let size = list.size;
        let before = self.shown.take().filter(|_| self.quality.samples == 1 && is_opaque(list));
        let before = before.filter(|_| self.target.as_ref().is_some_and(|target| target.size == size));
        let parts = before.map(|before| Parts {
            picture: changes(&before, list),
            shadow: shadow_changes(&before, list, self.quality),
        });
        let parts = parts.filter(|parts| parts.picture.are_a_part_of(size));
        self.shown = Some(list.clone());
        self.draw_parts(gpu, encoder, list, size, parts.as_ref())
    }

    fn draw_parts(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        list: &DrawList,
        size: [u32; 2],
        parts: Option<&Parts>,
    ) -> &wgpu::TextureView {
        let limit = gpu.device.limits().max_texture_dimension_2d;
        let size = size.map(|s| s.clamp(1, limit));
        let kept = self.target.take().filter(|t| t.size == size);
        let target = kept.unwrap_or_else(|| Target::new(gpu, size, self.quality));
        self.frame.write(gpu, list, size, self.quality);
        let seen = if self.culls { Seen::of(list, size, self.quality) } else { Seen::all(list) };
        seen.count(gpu, list);
        self.passes.prepare(gpu, &self.frame, (list, parts.is_some()), &seen, self.quality);
        self.passes.encode(gpu, &mut Recording { encoder, frame: &self.frame, target: &target, parts }, list, &seen);
        &self.target.insert(target).view
    }

    /// Draws a list and reads the picture back.
    ///
    /// # Errors
    /// When the size is not one that the device draws, or the read-back fails.
    pub fn picture(&mut self, gpu: &Gpu, list: &DrawList, size: [u32; 2]) -> Result<Image, GpuError> {
        pollster::block_on(self.picture_later(gpu, list, size))
    }

    /// The same where a thread must not wait for the device: on a page.
    ///
    /// # Errors
    /// As [`Renderer::picture`].
    pub async fn picture_later(&mut self, gpu: &Gpu, list: &DrawList, size: [u32; 2]) -> Result<Image, GpuError> {
        readback::check_size(gpu, size)?;
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.draw(gpu, &mut encoder, list, size);
        self.read_later(gpu, encoder).await
    }

    /// Draws what was recorded, and reads the picture back.
    ///
    /// # Errors
    /// When the read-back fails, or nothing was drawn.
    pub fn read(&mut self, gpu: &Gpu, encoder: wgpu::CommandEncoder) -> Result<Image, GpuError> {
        pollster::block_on(self.read_later(gpu, encoder))
    }

    async fn read_later(&mut self, gpu: &Gpu, encoder: wgpu::CommandEncoder) -> Result<Image, GpuError> {
        let target = self.target.as_ref().ok_or_else(|| GpuError::Readback("nothing was drawn".to_owned()))?;
        let kept = self.readback.take().filter(|readback| readback.size() == target.size);
        let readback = kept.unwrap_or_else(|| Readback::new(gpu, target.size));
        let image = readback.read(gpu, encoder, &target.texture).await;
        // What a device that has failed gives back is no picture, whether it says so or not.
        let image = gpu.fault().map_or(image, |fault| Err(fault.into()))?;
        self.readback = Some(readback);
        Ok(image)
    }

    /// The passes that have been built, by the stem of their file.
    pub fn built(&self) -> Vec<&'static str> {
        let p = &self.passes;
        let all = [
            ("backdrop", p.backdrop.is_some()),
            ("shadow", p.shadow.is_some()),
            ("ground", p.ground.is_some()),
            ("solid", p.solid.is_some() || p.ghost.is_some()),
            ("line", p.lines.is_some() || p.xray_lines.is_some()),
            ("cone", p.cones.is_some()),
            ("arrow", p.arrows.is_some()),
            ("far", p.far.is_some() || p.far_shadow.is_some()),
            ("overlay", p.overlay.is_some()),
        ];
        all.into_iter().filter(|(_, built)| *built).map(|(stem, _)| stem).collect()
    }
}

impl Passes {
    /// Builds the passes that the picture needs, and hands them what they draw.
    fn prepare(
        &mut self,
        gpu: &Gpu,
        frame: &Frame,
        (list, in_parts): (&DrawList, bool),
        seen: &Seen<'_>,
        quality: Quality,
    ) {
        let samples = quality.samples;
        if in_parts || list.frame.sky != list.frame.floor {
            self.backdrop.get_or_insert_with(|| Backdrop::new(gpu, frame, samples));
        }
        if needs_light(list, seen) {
            self.prepare_lit(gpu, frame, list, seen, quality);
            if in_parts {
                self.far_shadow.get_or_insert_with(|| Far::of_depth(gpu));
            }
        }
        let lines = |label, depth| move || LinePass::new(gpu, frame, label, depth, samples);
        if !seen.lines.is_empty() {
            self.lines.get_or_insert_with(lines("line", Depth::Test)).fill(gpu, &seen.lines);
        }
        if !seen.xray_lines.is_empty() {
            self.xray_lines.get_or_insert_with(lines("line seen through", Depth::Ignore)).fill(gpu, &seen.xray_lines);
        }
        if !seen.cones.is_empty() {
            self.cones.get_or_insert_with(|| ConePass::new(gpu, frame, samples)).fill(gpu, &seen.cones);
        }
        if !seen.arrows.is_empty() {
            self.arrows.get_or_insert_with(|| ArrowPass::new(gpu, frame, samples)).fill(gpu, &seen.arrows);
            self.far.get_or_insert_with(|| Far::new(gpu, samples));
        }
        if !seen.marks.is_empty() {
            self.overlay.get_or_insert_with(|| Overlay::new(gpu, frame, samples)).fill(gpu, &seen.marks);
        }
    }

    /// Bodies and ground, which share the shadow map.
    fn prepare_lit(&mut self, gpu: &Gpu, frame: &Frame, list: &DrawList, seen: &Seen<'_>, quality: Quality) {
        let samples = quality.samples;
        let shadow = &*self.shadow.get_or_insert_with(|| Shadow::new(gpu, frame, quality));
        if let Some(ground) = &list.ground {
            self.ground.get_or_insert_with(|| GroundPass::new(gpu, frame, shadow, samples)).fill(gpu, ground);
        }
        if !(seen.solids.is_empty() && seen.casters.is_empty() && seen.ghosts.is_empty()) {
            self.prism.get_or_insert_with(|| Prism::new(gpu));
        }
        let pass = |label, depth| move || SolidPass::new(gpu, frame, shadow, label, depth, samples);
        if !seen.solids.is_empty() {
            self.solid.get_or_insert_with(pass("solid", Depth::Write));
        }
        if !(seen.solids.is_empty() && seen.casters.is_empty()) {
            let solids = self.solids.get_or_insert_with(|| Solids::new("solids"));
            solids.fill(gpu, (&seen.solids, seen.opaque), &seen.casters);
        }
        if !seen.ghosts.is_empty() {
            self.ghost.get_or_insert_with(pass("ghost", Depth::Test));
            self.ghosts.get_or_insert_with(|| Solids::new("ghosts")).fill(gpu, (&seen.ghosts, 0), &[]);
        }
    }

    /// Records what the picture needs.
    fn encode(&self, gpu: &Gpu, to: &mut Recording<'_>, list: &DrawList, seen: &Seen<'_>) {
        let shadow = self.shadow.as_ref().filter(|_| needs_light(list, seen));
        if let Some(shadow) = shadow {
            let thrown = !(seen.solids.is_empty() && seen.casters.is_empty());
            let casters = self.prism.as_ref().zip(self.solids.as_ref()).filter(|_| thrown);
            let parts = to.parts.and_then(|parts| parts.shadow.as_ref()).zip(self.far_shadow.as_ref());
            shadow.draw(gpu, to.encoder, to.frame, casters, parts);
        }
        let clear = to.parts.is_none().then(|| clear_color(list));
        let (parts, in_parts) = (to.parts(), to.parts.is_some());
        let mut pass = to.target.begin(gpu, to.encoder, clear);
        pass.set_bind_group(0, &to.frame.group, &[]);
        for part in parts {
            part.cut(&mut pass);
            self.encode_bodies(&mut pass, (to.target.size, in_parts), shadow, list, seen);
            self.encode_on_top(&mut pass, seen);
        }
    }

    /// Bodies, and what they hide. Opaque ones come before the background and the ground, which then are shaded only where they are seen.
    fn encode_bodies(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        (size, in_parts): ([u32; 2], bool),
        shadow: Option<&Shadow>,
        list: &DrawList,
        seen: &Seen<'_>,
    ) {
        let lit = shadow.zip(self.prism.as_ref());
        let solids = self.solid.as_ref().zip(self.solids.as_ref()).filter(|_| !seen.solids.is_empty());
        let solids = solids.zip(lit);
        if let Some(((solid, solids), (shadow, prism))) = solids {
            solid.begin(pass, shadow);
            solids.draw_opaque(pass, prism);
        }
        at_depth(pass, size, [1.0, 1.0]);
        if let Some(backdrop) = self.backdrop.as_ref().filter(|_| in_parts || list.frame.sky != list.frame.floor) {
            backdrop.draw(pass);
        }
        if let (Some(ground), Some(shadow), true) = (&self.ground, shadow, list.ground.is_some()) {
            ground.draw(pass, shadow);
        }
        at_depth(pass, size, [0.0, 1.0]);
        let ghosts = self.ghost.as_ref().zip(self.ghosts.as_ref()).filter(|_| !seen.ghosts.is_empty());
        for ((solid, solids), (shadow, prism)) in solids.into_iter().chain(ghosts.zip(lit)) {
            solid.begin(pass, shadow);
            solids.draw_clear(pass, prism);
        }
        if let Some(lines) = self.lines.as_ref().filter(|_| !seen.lines.is_empty()) {
            lines.draw(pass);
        }
    }

    /// Encodes marks that are seen through bodies, arrows with a depth of their own, and flat marks.
    fn encode_on_top(&self, pass: &mut wgpu::RenderPass<'_>, seen: &Seen<'_>) {
        if let Some(cones) = self.cones.as_ref().filter(|_| !seen.cones.is_empty()) {
            cones.draw(pass);
        }
        if let Some(lines) = self.xray_lines.as_ref().filter(|_| !seen.xray_lines.is_empty()) {
            lines.draw(pass);
        }
        if let Some((far, arrows)) = self.far.as_ref().zip(self.arrows.as_ref()).filter(|_| !seen.arrows.is_empty()) {
            far.draw(pass);
            arrows.draw(pass);
        }
        if let Some(overlay) = self.overlay.as_ref().filter(|_| !seen.marks.is_empty()) {
            overlay.draw(pass);
        }
    }
}

impl Recording<'_> {
    /// Regions to draw, one after the other.
    fn parts(&self) -> Vec<Region> {
        self.parts.map_or_else(|| vec![Region::whole(self.target.size)], |parts| parts.picture.iter().collect())
    }
}

/// Maps depth from the near to the far plane into this range: with 1 at both ends, what is drawn is behind all that has depth.
fn at_depth(pass: &mut wgpu::RenderPass<'_>, [width, height]: [u32; 2], [near, far]: [f32; 2]) {
    pass.set_viewport(0.0, 0.0, width as f32, height as f32, near, far);
}

/// Whether the background hides what it is drawn over.
fn is_opaque(list: &DrawList) -> bool {
    [list.frame.sky, list.frame.floor].iter().all(|color| color.0[3] == 0xff)
}

/// Whether anything in the picture is lit, and so asks the shadow map.
fn needs_light(list: &DrawList, seen: &Seen<'_>) -> bool {
    list.ground.is_some() || !(seen.solids.is_empty() && seen.ghosts.is_empty())
}

fn clear_color(list: &DrawList) -> wgpu::Color {
    let [r, g, b, a] = color(list.frame.floor).map(f64::from);
    wgpu::Color { r: r * a, g: g * a, b: b * a, a }
}
