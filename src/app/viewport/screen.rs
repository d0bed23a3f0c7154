//! The 3D view's paint callback: draws the list into its own target when the list has changed, and copies it in.

use std::sync::Arc;

use egui_wgpu::{CallbackResources, CallbackTrait, ScreenDescriptor};
use wgpu::{BindGroup, CommandBuffer, CommandEncoder, Device, Queue, RenderPass, TextureFormat};

use crate::app::viewport::blit::Blit;
use crate::render::{Gpu, Quality, Renderer};
use crate::view::DrawList;

/// One picture to be shown.
#[derive(Clone)]
pub(in crate::app) struct Screen {
    pub(in crate::app) list: Arc<DrawList>,
    /// Counts the pictures of this window: the same number is the same picture.
    pub(in crate::app) number: u64,
    /// Width and height \[pixels\].
    pub(in crate::app) size: [u32; 2],
    /// Format of egui's own target.
    pub(in crate::app) format: TextureFormat,
    /// Which of the views it is in.
    pub(in crate::app) place: usize,
    /// Whether it moves: it is drawn coarser where a processor draws, and anew when it has come to rest.
    pub(in crate::app) moves: bool,
}

/// State that a window keeps between frames.
struct Kept {
    gpu: Gpu,
    blit: Blit,
    format: TextureFormat,
    places: Vec<Place>,
}

/// State that a view of the window keeps.
struct Place {
    /// One at rest, one for what moves; the same where a graphics card draws both as finely.
    renderers: [Option<Renderer>; 2],
    shown: Option<(u64, [u32; 2], Quality)>,
    picture: Option<BindGroup>,
}

impl Kept {
    fn new(device: &Device, queue: &Queue, format: TextureFormat) -> Self {
        let gpu = Gpu::from_parts(device.adapter_info(), device.clone(), queue.clone());
        Self { blit: Blit::new(device, format), gpu, format, places: Vec::new() }
    }

    fn draw(&mut self, encoder: &mut CommandEncoder, screen: &Screen) {
        // A second view has its pipelines and targets from the first time that it is asked for.
        while self.places.len() <= screen.place {
            self.places.push(Place { renderers: [None, None], shown: None, picture: None });
        }
        let Some(place) = self.places.get_mut(screen.place) else { return };
        let adapter = &self.gpu.adapter;
        let [rest, moving] = [Quality::for_stills(adapter), Quality::for_adapter(adapter)];
        let quality = if screen.moves { moving } else { rest };
        let wanted = (screen.number, screen.size, quality);
        if place.shown == Some(wanted) {
            return;
        }
        let slot = &mut place.renderers[usize::from(quality != rest)];
        let renderer = slot.get_or_insert_with(|| Renderer::new(&self.gpu, quality));
        let target = renderer.draw_changes(&self.gpu, encoder, &screen.list);
        place.picture = Some(self.blit.bind(&self.gpu.device, target));
        place.shown = Some(wanted);
    }
}

impl CallbackTrait for Screen {
    fn prepare(
        &self,
        device: &Device,
        queue: &Queue,
        _screen: &ScreenDescriptor,
        encoder: &mut CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<CommandBuffer> {
        if resources.get::<Kept>().is_none_or(|kept| kept.format != self.format) {
            resources.insert(Kept::new(device, queue, self.format));
        }
        if let Some(kept) = resources.get_mut::<Kept>() {
            kept.draw(encoder, self);
        }
        Vec::new()
    }

    fn paint(&self, _info: egui::PaintCallbackInfo, pass: &mut RenderPass<'static>, resources: &CallbackResources) {
        if let Some(kept) = resources.get::<Kept>()
            && let Some(picture) = kept.places.get(self.place).and_then(|p| p.picture.as_ref())
        {
            kept.blit.paint(pass, picture);
        }
    }
}
