//! The window's surface and egui's renderer on it: resized, lost, minimised.

use std::sync::Arc;

use egui::{ClippedPrimitive, TexturesDelta};
use egui_wgpu::{RenderState, RendererOptions, ScreenDescriptor, WgpuConfiguration, WgpuSetup};
use wgpu::{CurrentSurfaceTexture, SurfaceConfiguration, SurfaceTexture, TextureFormat};
use winit::event_loop::ActiveEventLoop;
use winit::window::Window;

use crate::render::Gpu;

/// What egui draws on.
pub(super) struct Surface {
    target: wgpu::Surface<'static>,
    config: SurfaceConfiguration,
    state: RenderState,
}

impl Surface {
    /// Brings up a device that can draw on a window.
    ///
    /// # Errors
    /// In words: no adapter, no device, no surface.
    pub(super) fn new(event_loop: &ActiveEventLoop, window: &Arc<Window>) -> Result<Self, String> {
        let setup = WgpuSetup::from_display_handle(event_loop.owned_display_handle());
        let instance = pollster::block_on(setup.new_instance());
        let surface = instance.create_surface(window.clone()).map_err(|e| e.to_string())?;
        let wanted = WgpuConfiguration { wgpu_setup: setup, ..WgpuConfiguration::default() };
        let options = RendererOptions::default();
        let state = pollster::block_on(RenderState::create(&wanted, &instance, Some(&surface), options))
            .map_err(|e| e.to_string())?;
        let size = window.inner_size();
        let mut config = surface
            .get_default_config(&state.adapter, size.width.max(1), size.height.max(1))
            .ok_or("the adapter cannot draw on this window")?;
        config.format = state.target_format;
        config.view_formats = vec![state.target_format];
        config.present_mode = wgpu::PresentMode::AutoVsync;
        surface.configure(&state.device, &config);
        Ok(Self { target: surface, config, state })
    }

    /// What egui draws into.
    pub(super) fn format(&self) -> TextureFormat {
        self.config.format
    }

    /// Largest texture side \[pixels\].
    pub(super) fn largest(&self) -> usize {
        self.state.device.limits().max_texture_dimension_2d as usize
    }

    /// What draws, in words.
    pub(super) fn adapter(&self) -> String {
        Gpu::from_parts(self.state.adapter.get_info(), self.state.device.clone(), self.state.queue.clone())
            .adapter
            .to_string()
    }

    /// The window has another size; a minimised one has none, and nothing is drawn on it.
    pub(super) fn resize(&mut self, width: u32, height: u32) {
        let largest = self.state.device.limits().max_texture_dimension_2d;
        (self.config.width, self.config.height) = (width.min(largest), height.min(largest));
        if width > 0 && height > 0 {
            self.target.configure(&self.state.device, &self.config);
        }
    }

    /// Draws a frame. `false` when there was nothing to draw on and it is worth trying again.
    pub(super) fn paint(
        &mut self,
        window: &Arc<Window>,
        jobs: &[ClippedPrimitive],
        mut textures: TexturesDelta,
        pixels_per_point: f32,
    ) -> bool {
        self.upload(&mut textures);
        let drawn = self.config.width == 0 || self.config.height == 0 || self.draw(window, jobs, pixels_per_point);
        self.free(&mut textures);
        drawn
    }

    #[expect(clippy::iter_over_hash_type, reason = "textures do not depend on each other")]
    fn free(&self, textures: &mut TexturesDelta) {
        let mut renderer = self.state.renderer.write();
        for id in textures.free.drain() {
            renderer.free_texture(&id);
        }
    }

    #[expect(clippy::iter_over_hash_type, reason = "textures do not depend on each other")]
    fn upload(&self, textures: &mut TexturesDelta) {
        let mut renderer = self.state.renderer.write();
        for (id, images) in textures.set.drain() {
            for image in images {
                renderer.update_texture(&self.state.device, &self.state.queue, id, &image);
            }
        }
    }

    fn draw(&mut self, window: &Arc<Window>, jobs: &[ClippedPrimitive], pixels_per_point: f32) -> bool {
        let Some(frame) = self.acquire(window) else { return false };
        let screen = ScreenDescriptor { size_in_pixels: [self.config.width, self.config.height], pixels_per_point };
        let (device, queue) = (&self.state.device, &self.state.queue);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("window") });
        let mut renderer = self.state.renderer.write();
        let mut buffers = renderer.update_buffers(device, queue, &mut encoder, jobs, &screen);
        let view = frame.texture.create_view(&wgpu::TextureViewDescriptor::default());
        let mut pass = encoder
            .begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("window"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &view,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                        store: wgpu::StoreOp::Store,
                    },
                    depth_slice: None,
                })],
                ..Default::default()
            })
            .forget_lifetime();
        renderer.render(&mut pass, jobs, &screen);
        drop(pass);
        buffers.push(encoder.finish());
        queue.submit(buffers);
        window.pre_present_notify();
        queue.present(frame);
        true
    }

    /// The next frame's texture; a surface that is out of date or lost is made anew, for the next try.
    fn acquire(&mut self, window: &Arc<Window>) -> Option<SurfaceTexture> {
        match self.target.get_current_texture() {
            CurrentSurfaceTexture::Success(frame) | CurrentSurfaceTexture::Suboptimal(frame) => return Some(frame),
            CurrentSurfaceTexture::Lost => {
                if let Ok(surface) = self.state.instance.create_surface(window.clone()) {
                    self.target = surface;
                }
                self.target.configure(&self.state.device, &self.config);
            }
            CurrentSurfaceTexture::Outdated | CurrentSurfaceTexture::Validation => {
                self.target.configure(&self.state.device, &self.config);
            }
            CurrentSurfaceTexture::Timeout | CurrentSurfaceTexture::Occluded => {}
        }
        None
    }
}
