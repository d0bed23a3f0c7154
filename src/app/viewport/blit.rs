//! Puts the 3D picture, drawn into its own target, into egui's pass.

use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor, BindGroupLayoutEntry,
    BindingResource, BindingType, Device, RenderPass, RenderPipeline, RenderPipelineDescriptor, ShaderStages,
    TextureFormat, TextureSampleType, TextureView, TextureViewDimension,
};

const SHADER: &str = include_str!("blit.wgsl");

/// A pipeline that copies a texture into the viewport.
pub(in crate::app) struct Blit {
    pipeline: RenderPipeline,
    layout: BindGroupLayout,
}

impl Blit {
    /// Builds the pipeline for a pass whose target has `format`.
    pub(in crate::app) fn new(device: &Device, format: TextureFormat) -> Self {
        let layout = layout(device);
        let pipeline = pipeline(device, &layout, format);
        Self { pipeline, layout }
    }

    /// Binds the picture that is to be copied.
    pub(in crate::app) fn bind(&self, device: &Device, picture: &TextureView) -> BindGroup {
        device.create_bind_group(&BindGroupDescriptor {
            label: Some("blit"),
            layout: &self.layout,
            entries: &[BindGroupEntry { binding: 0, resource: BindingResource::TextureView(picture) }],
        })
    }

    /// Copies it.
    pub(in crate::app) fn paint(&self, pass: &mut RenderPass<'static>, picture: &BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, picture, &[]);
        pass.draw(0..3, 0..1);
    }
}

fn layout(device: &Device) -> BindGroupLayout {
    let picture = BindingType::Texture {
        sample_type: TextureSampleType::Float { filterable: false },
        view_dimension: TextureViewDimension::D2,
        multisampled: false,
    };
    let entry = BindGroupLayoutEntry { binding: 0, visibility: ShaderStages::FRAGMENT, ty: picture, count: None };
    device.create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some("blit"), entries: &[entry] })
}

fn pipeline(device: &Device, layout: &BindGroupLayout, format: TextureFormat) -> RenderPipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("blit"),
        source: wgpu::ShaderSource::Wgsl(SHADER.into()),
    });
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("blit"),
        bind_group_layouts: &[Some(layout)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&RenderPipelineDescriptor {
        label: Some("blit"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("cover"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some(if format.is_srgb() { "to_linear" } else { "as_is" }),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(format.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

#[cfg(all(test, feature = "ui-tests"))]
mod tests {
    #[test]
    fn the_shader_is_valid() {
        let module = naga::front::wgsl::parse_str(super::SHADER).expect("it parses");
        let mut validator =
            naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
        validator.validate(&module).expect("it validates");
    }
}
