//! A device to draw with: brought up without a window, or handed over by one.
//!
//! Pipelines, buffers and textures are made here and nowhere else, so that each is counted ([`Made`]).

use super::health::{Fault, Health};
use super::made::{Made, Tally, Thing};
use crate::language::{Text, said};

/// The adapter that draws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterSummary {
    /// The adapter's own name.
    pub name: String,
    /// The graphics interface, `vulkan`, `gl`, …
    pub backend: String,
    /// Whether a processor does a graphics card's work.
    pub is_cpu: bool,
}

impl AdapterSummary {
    /// From what wgpu says of an adapter.
    pub fn of(info: &wgpu::AdapterInfo) -> Self {
        // A GLES adapter does not say that it is software; its name does.
        let named = ["llvmpipe", "softpipe", "SwiftShader"].iter().any(|n| info.name.contains(n));
        Self {
            name: info.name.clone(),
            backend: info.backend.to_str().to_owned(),
            is_cpu: info.device_type == wgpu::DeviceType::Cpu || named,
        }
    }
}

impl std::fmt::Display for AdapterSummary {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({})", self.name, self.backend)
    }
}

/// Why nothing can be drawn.
#[derive(Debug, thiserror::Error)]
pub enum GpuError {
    /// There is no adapter, not even in software.
    #[error("{}", no_adapter(.0))]
    NoAdapter(String),
    /// An adapter would not give a device.
    #[error("{}", said!("gpu-no-device", "why" => .0.as_str()))]
    NoDevice(String),
    /// An adapter draws, but not on this display.
    #[error("{}", said!("gpu-no-surface", "why" => .0.as_str()))]
    NoSurface(String),
    /// A picture larger than the device draws.
    #[error("{}", said!("gpu-size", "width" => *.0, "height" => *.1, "most" => *.2))]
    Size(u32, u32, u32),
    /// The picture could not be read back.
    #[error("{}", said!("gpu-readback", "why" => .0.as_str()))]
    Readback(String),
    /// The device is of no more use; another may be.
    #[error(transparent)]
    Fault(#[from] Fault),
}

/// Text on the adapters looked for, and on variables to set and packages to install.
fn no_adapter(looked: &str) -> String {
    let set = |name: &str| {
        let value = std::env::var(name).ok()?;
        Some(said!("gpu-without", "name" => name, "value" => value) + " ")
    };
    let set: String = ["WGPU_BACKEND", "VK_ICD_FILENAMES", "VK_DRIVER_FILES"].into_iter().filter_map(set).collect();
    let install = if cfg!(target_arch = "wasm32") {
        "gpu-install-browser"
    } else if cfg!(target_os = "linux") {
        "gpu-install-mesa"
    } else {
        "gpu-install-driver"
    };
    said!("gpu-none", "set" => set, "install" => Text::new(install).as_str(), "looked" => looked)
}

#[cfg(not(target_arch = "wasm32"))]
async fn adapter() -> Result<wgpu::Adapter, GpuError> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter = instance.request_adapter(&wgpu::RequestAdapterOptions::default());
    adapter.await.map_err(|e| GpuError::NoAdapter(e.to_string()))
}

/// WebGPU's, or WebGL's, which there is only together with a canvas.
#[cfg(target_arch = "wasm32")]
async fn adapter() -> Result<wgpu::Adapter, GpuError> {
    let wanted = wgpu::InstanceDescriptor::new_without_display_handle();
    let instance = wgpu::util::new_instance_with_webgpu_detection(wanted).await;
    let canvas = web_sys::OffscreenCanvas::new(1, 1).map_err(|e| GpuError::NoSurface(format!("{e:?}")))?;
    let target = wgpu::SurfaceTarget::OffscreenCanvas(canvas);
    let surface = instance.create_surface(target).map_err(|e| GpuError::NoAdapter(e.to_string()))?;
    let options = wgpu::RequestAdapterOptions { compatible_surface: Some(&surface), ..Default::default() };
    instance.request_adapter(&options).await.map_err(|e| GpuError::NoAdapter(e.to_string()))
}

/// A device to draw with.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// The device.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
    /// Adapter of the device.
    pub adapter: AdapterSummary,
    tally: Tally,
    health: Health,
}

impl Gpu {
    /// Takes over a window's device.
    #[expect(clippy::needless_pass_by_value, reason = "all three are handed over together")]
    pub fn from_parts(info: wgpu::AdapterInfo, device: wgpu::Device, queue: wgpu::Queue) -> Self {
        let (adapter, tally, health) = (AdapterSummary::of(&info), Tally::default(), Health::default());
        Self { device, queue, adapter, tally, health }
    }

    /// Brings up a device with no window and no display: Vulkan, or GLES over EGL where there is none.
    ///
    /// # Errors
    /// When there is no adapter (the missing packages are named) or it gives no device.
    pub fn headless() -> Result<Self, GpuError> {
        pollster::block_on(Self::bring_up())
    }

    /// The same where a thread must not wait for the device: on a page.
    ///
    /// # Errors
    /// As [`Gpu::headless`].
    pub async fn bring_up() -> Result<Self, GpuError> {
        let adapter = adapter().await?;
        let info = adapter.get_info();
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("girderbench"),
            required_limits: wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits()),
            ..Default::default()
        };
        let (device, queue) = adapter
            .request_device(&descriptor)
            .await
            .map_err(|e| GpuError::NoDevice(format!("{}, {e}", AdapterSummary::of(&info))))?;
        let health = Health::of(&device);
        Ok(Self { health, ..Self::from_parts(info, device, queue) })
    }

    /// Fault of the device; `None` of a device that was taken over.
    pub fn fault(&self) -> Option<Fault> {
        // A lost device says so when it is asked for news; what else is wrong with it is known by then.
        let _ = self.device.poll(wgpu::PollType::Poll);
        self.health.fault()
    }

    /// Counts of resources made and pictures drawn on this device, through any copy of it.
    pub fn made(&self) -> Made {
        self.tally.so_far()
    }

    /// Counts what was done.
    pub(super) fn count(&self, thing: Thing, label: &'static str, count: usize) {
        self.tally.add(thing, label, count);
    }

    /// A buffer with nothing in it yet.
    pub(super) fn buffer(&self, label: &'static str, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
        self.count(Thing::Buffer, label, 1);
        let descriptor = wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false };
        self.device.create_buffer(&descriptor)
    }

    /// A mesh.
    pub(super) fn mesh<T: bytemuck::Pod>(&self, label: &'static str, vertices: &[T]) -> wgpu::Buffer {
        // Not mapped at its creation: a device without room for it would panic there.
        let bytes: &[u8] = bytemuck::cast_slice(vertices);
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        let buffer = self.buffer(label, bytes.len() as u64, usage);
        self.queue.write_buffer(&buffer, 0, bytes);
        buffer
    }

    /// A flat texture without mip levels.
    pub(super) fn texture(
        &self,
        label: &'static str,
        [width, height]: [u32; 2],
        samples: u32,
        format: wgpu::TextureFormat,
        usage: wgpu::TextureUsages,
    ) -> wgpu::Texture {
        self.count(Thing::Texture, label, 1);
        self.device.create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: samples,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage,
            view_formats: &[],
        })
    }

    /// A pipeline.
    pub(super) fn pipeline(
        &self,
        label: &'static str,
        descriptor: &wgpu::RenderPipelineDescriptor<'_>,
    ) -> wgpu::RenderPipeline {
        self.count(Thing::Pipeline, label, 1);
        self.device.create_render_pipeline(descriptor)
    }
}
