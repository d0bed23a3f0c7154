//! The window's surface, and the painter that draws on it: resized, minimised, out of date, lost, and lost with its
//! device.
//!
//! A device that fails takes everything on it with it: surface, pipelines, textures. All of that is made anew at the
//! next frames, a few times with growing pauses, since a driver that restarts takes its time. Nothing of the workbench
//! lives on the device.

use std::sync::Arc;
use std::time::Duration;

use egui::{Context, PaintCallback, Rect, TexturesDelta};
use egui_wgpu::WgpuSetupCreateNew;
use wgpu::{CurrentSurfaceTexture, SurfaceConfiguration, SurfaceTexture, TextureFormat, TextureViewDescriptor};
use winit::event_loop::{ActiveEventLoop, OwnedDisplayHandle};
use winit::window::Window;

use crate::app::host::{Instant, Later, Wake, now};
use crate::app::shell::painter::{Painter, Shapes, modest};
use crate::app::shell::pixels::Pixels;
use crate::app::shell::reading::Reading;
use crate::app::shell::redraw::{Frame, Redraw, Shown};
use crate::app::shell::textures::Textures;
use crate::render::{AdapterSummary, Fault, GpuError, Regions};

/// Failures in a row, no frame shown between them, after which it is given up.
const TRIES: u32 = 6;
/// Frames in a row without a texture to draw into after which the surface is made anew with its device.
const MISSES: u32 = 100;
/// When a frame is tried again that had no texture to draw into.
const SOON: Duration = Duration::from_millis(10);
/// When a frame is tried again that nobody would see.
const LATER: Duration = Duration::from_millis(100);

/// Outcome of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app) enum Painted {
    /// It is shown, or the window has no size to show it at.
    Shown,
    /// It is to be painted again after this time.
    Again(Duration),
    /// There is a new device: everything is to be drawn on it.
    Anew,
}

/// Input of a painter.
pub(in crate::app) struct Painting {
    pub(in crate::app) redraw: Redraw,
    pub(in crate::app) pixels_per_point: f32,
    /// Whether the display may have lost what it shows: the system has asked for a frame.
    pub(in crate::app) is_asked: bool,
}

/// Target of egui.
pub(in crate::app) struct Surface {
    window: Arc<Window>,
    display: OwnedDisplayHandle,
    textures: Textures,
    /// Absent before the first device, and between one that has failed and the next.
    on: Option<On>,
    /// The next one, while it comes up.
    coming: Option<Later<Result<On, GpuError>>>,
    /// Who is woken when it is there.
    wake: Wake,
    failures: u32,
    /// When the next one is tried.
    due: Option<Instant>,
    format: TextureFormat,
    largest: u32,
    adapter: Option<AdapterSummary>,
}

/// A surface and the device that draws on it.
struct On {
    // The surface goes first: a window has one at a time.
    target: wgpu::Surface<'static>,
    config: SurfaceConfiguration,
    painter: Painter,
    instance: wgpu::Instance,
    misses: u32,
    /// Keeps the frame before, so that the next is drawn over it in parts; none where a graphics card draws, which is done with all of
    /// it sooner, and where nothing can be copied to the display.
    canvas: Option<wgpu::Texture>,
    shown: Shown,
    /// The window where pixels of the canvas are sent to it; else the canvas is copied to the swapchain.
    pixels: Option<Pixels>,
    reading: Reading,
    /// Whether the display has what is shown.
    is_presented: bool,
}

impl Surface {
    /// No device yet.
    pub(in crate::app) fn new(event_loop: &ActiveEventLoop, window: &Arc<Window>, wake: Wake) -> Self {
        Self {
            window: window.clone(),
            display: event_loop.owned_display_handle(),
            textures: Textures::default(),
            on: None,
            coming: None,
            wake,
            failures: 0,
            due: None,
            format: TextureFormat::Rgba8Unorm,
            largest: 0,
            adapter: None,
        }
    }

    /// Format of egui's target.
    pub(in crate::app) fn format(&self) -> TextureFormat {
        self.format
    }

    /// Largest texture side \[pixels\].
    pub(in crate::app) fn largest(&self) -> usize {
        self.largest as usize
    }

    /// Adapter that draws; `None` before the first painter.
    pub(in crate::app) fn adapter(&self) -> Option<&AdapterSummary> {
        self.adapter.as_ref()
    }

    /// Whether a processor draws.
    pub(in crate::app) fn is_drawn_by_processor(&self) -> bool {
        self.adapter.as_ref().is_some_and(|adapter| adapter.is_cpu)
    }

    /// Begins to bring up a device that can draw on the window, or goes on with it. On a page it is not there at once: the
    /// window is woken then.
    ///
    /// # Errors
    /// No adapter, no device, no surface.
    pub(in crate::app) fn bring_up(&mut self) -> Result<Painted, GpuError> {
        let begin = || Later::of(On::new(self.window.clone(), self.display.clone()), self.wake.clone());
        let Some(made) = self.coming.get_or_insert_with(begin).take() else {
            // Woken when it is there.
            return Ok(Painted::Again(Duration::MAX));
        };
        self.coming = None;
        let mut on = made?;
        on.painter.load(&self.textures)?;
        self.format = on.config.format;
        self.largest = on.painter.device().limits().max_texture_dimension_2d;
        let size = self.window.inner_size();
        on.resize([size.width, size.height].map(|side| side.min(self.largest)));
        on.painter.fault().map_or(Ok(()), Err)?;
        self.adapter = Some(on.painter.summary());
        self.on = Some(on);
        Ok(Painted::Anew)
    }

    /// The window has another size; a minimised one may have none, and nothing is drawn on it.
    pub(in crate::app) fn resize(&mut self, width: u32, height: u32) {
        if let Some(on) = &mut self.on {
            on.resize([width, height].map(|side| side.min(self.largest)));
        }
    }

    /// Finds out what of a frame has to be drawn.
    pub(in crate::app) fn plan(&mut self, frame: Frame<'_>) -> Redraw {
        let Some(on) = &mut self.on else { return Redraw::Nothing };
        on.shown.show(frame, [on.config.width, on.config.height], on.canvas.is_some())
    }

    /// Whether it is known which frame is shown, so that other pictures can go into it.
    pub(in crate::app) fn has_known_frame(&self) -> bool {
        self.on.as_ref().is_some_and(|on| on.is_presented && on.shown.is_of([on.config.width, on.config.height]))
    }

    /// Finds out what has to be drawn so that other pictures are shown in the frame before; none where that is not known to be shown.
    pub(in crate::app) fn plan_pictures(
        &mut self,
        context: &Context,
        pictures: &[PaintCallback],
        changes: &[(Rect, Regions)],
    ) -> Option<Redraw> {
        let on = self.on.as_mut().filter(|on| on.is_presented)?;
        let size = [on.config.width, on.config.height];
        on.shown.show_pictures(context, (pictures, changes), size, on.canvas.is_some())
    }

    /// Paints a frame, or goes on with bringing a device up to paint it on.
    ///
    /// # Errors
    /// There is no way to paint any more: the last of the reasons.
    pub(in crate::app) fn paint(&mut self, painting: &Painting, mut delta: TexturesDelta) -> Result<Painted, GpuError> {
        self.textures.take_in(&delta);
        let tried = match &mut self.on {
            Some(on) => on.paint(&self.window, painting, &delta).map_err(GpuError::from),
            None => match self.due.and_then(|due| due.checked_duration_since(now())) {
                Some(wait) => Ok(Painted::Again(wait)),
                None => self.bring_up(),
            },
        };
        // Whatever became of the frame: its textures are known.
        delta.clear();
        match tried {
            Ok(painted) => {
                self.failures = if painted == Painted::Shown { 0 } else { self.failures };
                Ok(painted)
            }
            Err(why) => self.failed(why),
        }
    }

    /// Gives up what is there, and later everything.
    fn failed(&mut self, why: GpuError) -> Result<Painted, GpuError> {
        self.on = None;
        self.failures += 1;
        if self.failures > TRIES {
            return Err(why);
        }
        let wait = Duration::from_millis(20 << self.failures);
        self.due = now().checked_add(wait);
        Ok(Painted::Again(wait))
    }

    /// Has the next frame shown whole, after the window was covered: the display may have lost the one before, and the system's own request
    /// for a frame can become one with the window's, so that it is not known.
    pub(in crate::app) fn cover(&mut self) {
        self.on.iter_mut().for_each(|on| on.is_presented = false);
    }

    /// Whether the last frame was shown.
    #[cfg(test)]
    pub(in crate::app) fn is_shown(&self) -> bool {
        self.on.is_some() && self.failures == 0
    }

    /// Takes the device away, as a driver that restarts does.
    #[cfg(test)]
    pub(in crate::app) fn lose(&self) {
        self.on.iter().for_each(|on| on.painter.device().destroy());
    }
}

impl On {
    async fn new(window: Arc<Window>, display: OwnedDisplayHandle) -> Result<Self, GpuError> {
        let setup = modest(WgpuSetupCreateNew::from_display_handle(display));
        let instance = setup.new_instance().await;
        let target = match instance.create_surface(window.clone()) {
            Ok(target) => target,
            Err(why) => return Err(no_surface(&instance, &why).await),
        };
        let painter = Painter::new(setup, &instance, Some(&target)).await?;
        let size = window.inner_size();
        let mut config = target
            .get_default_config(painter.adapter(), size.width.max(1), size.height.max(1))
            .ok_or_else(|| GpuError::NoSurface("the adapter and the display do not go together".to_owned()))?;
        config.format = painter.format();
        config.view_formats = vec![painter.format()];
        config.present_mode = wgpu::PresentMode::AutoVsync;
        let copies = target.get_capabilities(painter.adapter()).usages.contains(wgpu::TextureUsages::COPY_DST);
        if copies && painter.summary().is_cpu {
            config.usage |= wgpu::TextureUsages::COPY_DST;
        }
        let (shown, reading, is_presented) = (Shown::default(), Reading::default(), false);
        let is_bgra = painter.format() == TextureFormat::Bgra8Unorm;
        let pixels = (is_bgra && painter.summary().is_cpu).then(|| Pixels::of(&window)).flatten();
        Ok(Self { target, config, painter, instance, misses: 0, canvas: None, shown, pixels, reading, is_presented })
    }

    fn resize(&mut self, [width, height]: [u32; 2]) {
        (self.config.width, self.config.height) = (width, height);
        self.shown.forget();
        if width > 0 && height > 0 {
            if self.pixels.is_none() {
                self.target.configure(self.painter.device(), &self.config);
            }
            let is_kept = self.pixels.is_some() || self.config.usage.contains(wgpu::TextureUsages::COPY_DST);
            self.canvas = is_kept.then(|| self.painter.canvas([width, height]));
        }
    }

    fn paint(&mut self, window: &Arc<Window>, painting: &Painting, delta: &TexturesDelta) -> Result<Painted, Fault> {
        self.painter.fault().map_or(Ok(()), Err)?;
        self.painter.upload(delta);
        let rests = matches!(painting.redraw, Redraw::Nothing) && self.is_presented && !painting.is_asked;
        let painted = if rests || self.config.width == 0 || self.config.height == 0 {
            Ok(Painted::Shown)
        } else {
            self.draw(window, painting)
        };
        self.painter.free(delta);
        painted
    }

    fn draw(&mut self, window: &Arc<Window>, painting: &Painting) -> Result<Painted, Fault> {
        let size = [self.config.width, self.config.height];
        let has_before = std::mem::take(&mut self.is_presented) && !painting.is_asked;
        let over = matches!(painting.redraw, Redraw::Parts(..));
        let shapes = Shapes { jobs: painting.redraw.jobs(), pixels_per_point: painting.pixels_per_point, over };
        let changes = !matches!(painting.redraw, Redraw::Nothing);
        if let Some(canvas) = self.canvas.as_ref().filter(|_| changes) {
            self.painter.draw(&canvas.create_view(&TextureViewDescriptor::default()), size, shapes)?;
        }
        if let (Some(pixels), Some(canvas)) = (&self.pixels, &self.canvas) {
            let parts = if has_before { painting.redraw.parts(size) } else { Regions::whole(size) };
            window.pre_present_notify();
            self.reading.read(&self.painter, canvas, &parts, |part, rows| pixels.put(part, rows))?;
            self.is_presented = true;
            return self.painter.fault().map_or(Ok(Painted::Shown), Err);
        }
        let frame = match self.acquire(window)? {
            Ok(frame) => frame,
            Err(again) => {
                if self.canvas.is_none() {
                    self.shown.forget();
                }
                return Ok(Painted::Again(again));
            }
        };
        match &self.canvas {
            Some(canvas) => self.painter.copy(canvas, &frame.texture),
            None => self.painter.draw(&frame.texture.create_view(&TextureViewDescriptor::default()), size, shapes)?,
        }
        window.pre_present_notify();
        self.painter.queue().present(frame);
        self.misses = 0;
        self.is_presented = true;
        self.painter.fault().map_or(Ok(Painted::Shown), Err)
    }

    /// The next frame's texture, or when to ask again; a surface that is out of date or lost is made anew for that.
    fn acquire(&mut self, window: &Arc<Window>) -> Result<Result<SurfaceTexture, Duration>, Fault> {
        match self.target.get_current_texture() {
            CurrentSurfaceTexture::Success(frame) | CurrentSurfaceTexture::Suboptimal(frame) => return Ok(Ok(frame)),
            CurrentSurfaceTexture::Timeout | CurrentSurfaceTexture::Occluded => return Ok(Err(LATER)),
            CurrentSurfaceTexture::Outdated | CurrentSurfaceTexture::Validation => {}
            CurrentSurfaceTexture::Lost => {
                let made = self.instance.create_surface(window.clone());
                self.target = made.map_err(|gone| Fault::Lost(gone.to_string()))?;
            }
        }
        self.target.configure(self.painter.device(), &self.config);
        self.misses += 1;
        if self.misses > MISSES {
            return Err(Fault::Lost("its surface gives nothing to draw into".to_owned()));
        }
        self.painter.fault().map_or(Ok(Err(SOON)), Err)
    }
}

/// Why there is no surface: most often since there is no adapter.
async fn no_surface(instance: &wgpu::Instance, why: &wgpu::CreateSurfaceError) -> GpuError {
    match instance.request_adapter(&wgpu::RequestAdapterOptions::default()).await {
        Ok(_) => GpuError::NoSurface(why.to_string()),
        Err(none) => GpuError::NoAdapter(none.to_string()),
    }
}
