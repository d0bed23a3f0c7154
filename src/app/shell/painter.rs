//! A device, and egui's renderer on it: draws a frame's shapes into whatever target it is given, and knows whether the
//! device still works. Needs no window.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use egui::{ClippedPrimitive, TexturesDelta};
use egui_wgpu::{
    RenderState, RendererOptions, ScreenDescriptor, WgpuConfiguration, WgpuError, WgpuSetup, WgpuSetupCreateNew,
};
use wgpu::{Adapter, CommandBuffer, CommandEncoder, DeviceDescriptor, Limits, PollType, TextureFormat, TextureView};

use crate::app::shell::textures::Textures;
use crate::render::{AdapterSummary, Fault, GpuError, Health};

/// One device and what draws the window on it.
pub(in crate::app) struct Painter {
    state: RenderState,
    health: Health,
}

/// One frame's shapes.
#[derive(Clone, Copy)]
pub(in crate::app) struct Shapes<'a> {
    /// Triangles and paint callbacks.
    pub(in crate::app) jobs: &'a [ClippedPrimitive],
    /// Pixels to a point.
    pub(in crate::app) pixels_per_point: f32,
    /// Whether they are drawn over what the target shows, and not over nothing.
    pub(in crate::app) over: bool,
}

/// Asks of a device what the renderer needs and no more, so that every adapter will do.
pub(in crate::app) fn modest(mut setup: WgpuSetupCreateNew) -> WgpuSetup {
    setup.device_descriptor = Arc::new(|adapter: &Adapter| DeviceDescriptor {
        label: Some("window"),
        required_limits: Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits()),
        ..Default::default()
    });
    setup.into()
}

impl Painter {
    /// Brings a device up that can draw on a surface, if there is one.
    ///
    /// # Errors
    /// No adapter, or no device.
    pub(in crate::app) async fn new(
        setup: WgpuSetup,
        instance: &wgpu::Instance,
        surface: Option<&wgpu::Surface<'static>>,
    ) -> Result<Self, GpuError> {
        let wanted = WgpuConfiguration { wgpu_setup: setup, ..WgpuConfiguration::default() };
        let made = RenderState::create(&wanted, instance, surface, RendererOptions::default());
        let state = made.await.map_err(in_words)?;
        Ok(Self { health: Health::of(&state.device), state })
    }

    /// Takes in all of egui's textures.
    ///
    /// # Errors
    /// A device that fails at once.
    pub(in crate::app) fn load(&self, textures: &Textures) -> Result<(), Fault> {
        for (id, image) in textures.all() {
            self.state.renderer.write().update_texture(&self.state.device, &self.state.queue, id, &image);
        }
        self.fault().map_or(Ok(()), Err)
    }

    /// The device.
    pub(in crate::app) fn device(&self) -> &wgpu::Device {
        &self.state.device
    }

    /// Its queue.
    pub(in crate::app) fn queue(&self) -> &wgpu::Queue {
        &self.state.queue
    }

    /// Where it comes from.
    pub(in crate::app) fn adapter(&self) -> &Adapter {
        &self.state.adapter
    }

    /// Adapter that draws.
    pub(in crate::app) fn summary(&self) -> AdapterSummary {
        AdapterSummary::of(&self.state.adapter.get_info())
    }

    /// Format of egui's target.
    pub(in crate::app) fn format(&self) -> TextureFormat {
        self.state.target_format
    }

    /// Fault of the device, if there is one; a lost one is noticed here.
    pub(in crate::app) fn fault(&self) -> Option<Fault> {
        if let Err(problem) = self.state.device.poll(PollType::Poll) {
            self.health.note(Fault::Lost(problem.to_string()));
        }
        self.health.fault()
    }

    /// Takes in textures that are new or have changed.
    #[expect(clippy::iter_over_hash_type, reason = "textures do not depend on each other")]
    pub(in crate::app) fn upload(&self, delta: &TexturesDelta) {
        let mut renderer = self.state.renderer.write();
        for (id, images) in &delta.set {
            for image in images {
                renderer.update_texture(&self.state.device, &self.state.queue, *id, image);
            }
        }
    }

    /// Lets go of textures that no later frame shows.
    pub(in crate::app) fn free(&self, delta: &TexturesDelta) {
        let mut renderer = self.state.renderer.write();
        delta.free.iter().for_each(|id| renderer.free_texture(id));
    }

    /// A texture of egui's format that is drawn into, and copied from.
    pub(in crate::app) fn canvas(&self, [width, height]: [u32; 2]) -> wgpu::Texture {
        self.state.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("canvas"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: self.format(),
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        })
    }

    /// Copies a canvas to a texture of its size.
    pub(in crate::app) fn copy(&self, canvas: &wgpu::Texture, to: &wgpu::Texture) {
        let mut encoder =
            self.state.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("canvas") });
        encoder.copy_texture_to_texture(canvas.as_image_copy(), to.as_image_copy(), canvas.size());
        self.state.queue.submit([encoder.finish()]);
    }

    /// Draws a frame's shapes into a target.
    ///
    /// # Errors
    /// The device failed, now or before; it is not to be used again.
    pub(in crate::app) fn draw(&self, view: &TextureView, size: [u32; 2], shapes: Shapes<'_>) -> Result<(), Fault> {
        self.fault().map_or(Ok(()), Err)?;
        // egui's renderer panics where a buffer cannot be had; nothing of this device is used after that.
        let drawn = catch_unwind(AssertUnwindSafe(|| self.submit(view, size, shapes)));
        if drawn.is_err() {
            self.health.note(Fault::OutOfMemory("no buffer for the window's shapes".to_owned()));
        }
        self.health.fault().map_or(Ok(()), Err)
    }

    fn submit(&self, view: &TextureView, size: [u32; 2], shapes: Shapes<'_>) {
        let descriptor = wgpu::CommandEncoderDescriptor { label: Some("window") };
        let encoder = self.state.device.create_command_encoder(&descriptor);
        self.state.queue.submit(self.encode(encoder, view, size, shapes));
    }

    fn encode(
        &self,
        mut encoder: CommandEncoder,
        view: &TextureView,
        size: [u32; 2],
        shapes: Shapes<'_>,
    ) -> Vec<CommandBuffer> {
        let screen = ScreenDescriptor { size_in_pixels: size, pixels_per_point: shapes.pixels_per_point };
        let (device, queue) = (&self.state.device, &self.state.queue);
        let mut renderer = self.state.renderer.write();
        let mut buffers = renderer.update_buffers(device, queue, &mut encoder, shapes.jobs, &screen);
        let load = if shapes.over { wgpu::LoadOp::Load } else { wgpu::LoadOp::Clear(wgpu::Color::BLACK) };
        let ops = wgpu::Operations { load, store: wgpu::StoreOp::Store };
        let mut pass = encoder
            .begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("window"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view,
                    resolve_target: None,
                    ops,
                    depth_slice: None,
                })],
                ..Default::default()
            })
            .forget_lifetime();
        renderer.render(&mut pass, shapes.jobs, &screen);
        drop(pass);
        buffers.push(encoder.finish());
        buffers
    }
}

/// egui's words for what is missing, as the renderer says it everywhere else.
fn in_words(error: WgpuError) -> GpuError {
    match error {
        WgpuError::RequestAdapterError(none) => GpuError::NoAdapter(none.to_string()),
        WgpuError::RequestDeviceError(none) => GpuError::NoDevice(none.to_string()),
        other => GpuError::NoSurface(other.to_string()),
    }
}

#[cfg(test)]
pub(in crate::app::shell) mod tests {
    use super::*;
    use std::io::Write as _;

    use crate::app::bench::Workbench;
    use crate::app::command::{EditCommand, PlaceCommand};
    use crate::app::panel::layout;
    use crate::app::style::theme;
    use crate::scene::presets;
    use egui::{Context, FullOutput, RawInput, Rect, pos2, vec2};

    const SIZE: [u32; 2] = [640, 400];

    /// A painter without a window; none where there is no adapter and none is asked for.
    pub(in crate::app::shell) fn painter(textures: &Textures) -> Option<Painter> {
        let setup = modest(WgpuSetupCreateNew::without_display_handle());
        let instance = pollster::block_on(setup.new_instance());
        let made = pollster::block_on(Painter::new(setup, &instance, None));
        let made = made.and_then(|painter| painter.load(textures).map(|()| painter).map_err(GpuError::from));
        let asked = std::env::var_os("GIRDERBENCH_REQUIRE_GPU").is_some_and(|v| v == "1");
        let skipped = |none: GpuError| {
            assert!(!asked, "GIRDERBENCH_REQUIRE_GPU=1, but {none}");
            let _ = writeln!(std::io::stderr(), "skipped for want of an adapter: {none}");
        };
        made.map_err(skipped).ok()
    }

    /// A workbench, and what of egui outlives a device.
    struct Shown {
        bench: Workbench,
        context: Context,
        textures: Textures,
    }

    impl Shown {
        fn frame(&mut self) -> FullOutput {
            let screen = Rect::from_min_size(pos2(0.0, 0.0), vec2(SIZE[0] as f32, SIZE[1] as f32));
            let input = RawInput { screen_rect: Some(screen), ..RawInput::default() };
            let output = self.context.run_ui(input, |ui| layout::show(&mut self.bench, ui));
            self.textures.take_in(&output.textures_delta);
            output
        }

        /// A frame as bytes, or why there is none.
        fn paint(&mut self, painter: &Painter) -> Result<Vec<u8>, Fault> {
            let mut output = self.frame();
            let target = painter.canvas(SIZE);
            let view = target.create_view(&wgpu::TextureViewDescriptor::default());
            painter.upload(&output.textures_delta);
            let jobs = self.context.tessellate(std::mem::take(&mut output.shapes), 1.0);
            let drawn = painter.draw(&view, SIZE, Shapes { jobs: &jobs, pixels_per_point: 1.0, over: false });
            painter.free(&output.textures_delta);
            output.textures_delta.clear();
            drawn.map(|()| bytes(painter, &target))
        }
    }

    pub(in crate::app::shell) fn bytes(painter: &Painter, texture: &wgpu::Texture) -> Vec<u8> {
        let (width, device) = (4 * texture.width(), painter.device());
        let row = width.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let usage = wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ;
        let size = u64::from(row * texture.height());
        let buffer =
            device.create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false });
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
        let into = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        encoder.copy_texture_to_buffer(texture.as_image_copy(), into, texture.size());
        painter.queue().submit([encoder.finish()]);
        buffer.map_async(wgpu::MapMode::Read, .., |_| ());
        device.poll(PollType::wait_indefinitely()).expect("it works");
        let mapped = buffer.get_mapped_range(..).expect("mapped");
        mapped.chunks(row as usize).flat_map(|line| &line[..width as usize]).copied().collect()
    }

    /// A window that has come to rest after an edit.
    fn shown() -> Shown {
        let mut bench = Workbench::new(presets::load(presets::OPENING).expect("ships"), crate::files::SceneSource::New);
        bench.replay.runner.set_estimates(false);
        bench.apply(PlaceCommand::AddGirder);
        bench.replay.runner.wait();
        let mut shown = Shown { bench, context: theme::context(), textures: Textures::default() };
        // Panels grow and things fade in for some frames.
        (0..40).for_each(|_| shown.frame().textures_delta.clear());
        shown
    }

    #[test]
    fn a_lost_device_costs_a_frame_and_nothing_else() {
        let mut shown = shown();
        let Some(first) = painter(&shown.textures) else { return };
        shown.bench.view.set_target(first.format(), Some(first.summary()));
        let before = shown.paint(&first).expect("it draws");
        assert!(shown.paint(&first).expect("it draws") == before, "at rest");
        let colors: std::collections::BTreeSet<&[u8]> = before.chunks_exact(4).collect();
        assert!(colors.len() > 300, "panels, letters and bodies: {} colours", colors.len());
        first.device().destroy();
        assert!(matches!(shown.paint(&first), Err(Fault::Lost(_))), "said, not drawn");
        assert!(matches!(shown.paint(&first), Err(Fault::Lost(_))), "as long as nothing is done about it");
        let second = painter(&shown.textures).expect("there was one before");
        assert!(shown.paint(&second).expect("it draws") == before, "the same picture to the last bit");
        let girders = shown.bench.files.document.scene().girders.len();
        shown.bench.apply(EditCommand::Undo);
        assert_eq!(
            shown.bench.files.document.scene().girders.len() + 1,
            girders,
            "the work and its past are where they were"
        );
    }

    #[test]
    fn what_a_device_refuses_is_said_and_no_panic() {
        let mut shown = shown();
        let Some(painter) = painter(&shown.textures) else { return };
        let size = painter.device().limits().max_buffer_size + 4;
        let usage = wgpu::BufferUsages::COPY_DST;
        let wanted = wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
        drop(painter.device().create_buffer(&wanted));
        let fault = shown.paint(&painter).expect_err("not on this device any more");
        assert!(matches!(&fault, Fault::Refused(words) if words.contains("buffer")), "in its words: {fault}");
        painter.health.note(Fault::OutOfMemory("later".into()));
        assert_eq!(painter.fault(), Some(fault), "the first is what matters");
    }
}
