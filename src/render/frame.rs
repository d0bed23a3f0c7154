//! Data of a picture common to all passes: the counterpart of `shaders/shared/frame.wgsl`.

use glam::{Mat4, Vec4};

use super::{Gpu, Quality};
use crate::view::DrawList;
use crate::view::list::Rgba;

/// `Frame` of `shaders/shared/frame.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct FrameUniform {
    clip_from_world: [[f32; 4]; 4],
    light_from_world: [[f32; 4]; 4],
    eye: [f32; 4],
    towards_light: [f32; 4],
    viewport: [f32; 4],
    shadow: [f32; 4],
    fade: [f32; 4],
    sky: [f32; 4],
    floor: [f32; 4],
}

/// A colour as shaders take it: sRGB-encoded, straight alpha.
pub(super) fn color(c: Rgba) -> [f32; 4] {
    c.0.map(|v| f32::from(v) / 255.0)
}

/// The uniform of the picture in hand.
#[derive(Debug)]
pub(super) struct Frame {
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) group: wgpu::BindGroup,
    buffer: wgpu::Buffer,
}

impl Frame {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let (layout, group, buffer) = uniform(gpu, "frame", size_of::<FrameUniform>() as u64);
        Self { layout, group, buffer }
    }

    /// Takes over a list's camera, light and background.
    pub(super) fn write(&self, gpu: &Gpu, list: &DrawList, size: [u32; 2], quality: Quality) {
        let frame = &list.frame;
        let matrix = |m: Mat4| m.to_cols_array_2d();
        let map = quality.shadow_map_size() as f32;
        let data = FrameUniform {
            clip_from_world: matrix(frame.clip_from_world),
            light_from_world: matrix(frame.light_from_world),
            eye: frame.eye.to_array(),
            towards_light: frame.towards_light.extend(0.0).to_array(),
            viewport: Vec4::new(size[0] as f32, size[1] as f32, frame.lift, 0.0).to_array(),
            shadow: [1.0 / map, 1.5 * frame.light_width / map, 0.0, 0.0],
            fade: [frame.middle.x, frame.middle.y, frame.fade[0], frame.fade[1]],
            sky: color(frame.sky),
            floor: color(frame.floor),
        };
        gpu.queue.write_buffer(&self.buffer, 0, bytemuck::bytes_of(&data));
    }
}

/// A uniform buffer with its own bind group at binding 0.
pub(super) fn uniform(
    gpu: &Gpu,
    label: &'static str,
    size: u64,
) -> (wgpu::BindGroupLayout, wgpu::BindGroup, wgpu::Buffer) {
    let buffer = gpu.buffer(label, size, wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST);
    let layout = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(label),
        entries: &[wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        }],
    });
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(label),
        layout: &layout,
        entries: &[wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }],
    });
    (layout, group, buffer)
}
