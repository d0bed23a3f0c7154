//! How the passes' pipelines are built: formats, depth, layouts of buffers.

use super::Gpu;

/// Format of pictures: encoded as sRGB by the shaders, so that every backend blends alike.
pub(super) const COLOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Format of depth.
pub(super) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Use of the depth buffer by a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Depth {
    /// Hides what is behind it.
    Write,
    /// Hides whatever is there.
    Set,
    /// Is hidden, hides nothing.
    Test,
    /// Neither.
    Ignore,
}

/// How a pass's pipeline is built.
#[derive(Debug)]
pub(super) struct Recipe<'a> {
    pub(super) label: &'static str,
    pub(super) shader: &'static str,
    pub(super) vertex: &'static str,
    pub(super) fragment: &'static str,
    pub(super) groups: &'a [&'a wgpu::BindGroupLayout],
    pub(super) buffers: &'a [wgpu::VertexBufferLayout<'a>],
    pub(super) depth: Depth,
    pub(super) cull: Option<wgpu::Face>,
    pub(super) samples: u32,
    /// Values of the shader's overrides.
    pub(super) constants: &'a [(&'a str, f64)],
}

impl Recipe<'_> {
    /// The pipeline, drawing into pictures.
    pub(super) fn build(&self, gpu: &Gpu) -> wgpu::RenderPipeline {
        let module = self.module(gpu);
        let target = wgpu::ColorTargetState {
            format: COLOR,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::ALL,
        };
        let fragment = wgpu::FragmentState {
            module: &module,
            entry_point: Some(self.fragment),
            compilation_options: self.options(),
            targets: &[Some(target)],
        };
        self.pipeline(gpu, &module, Some(fragment), wgpu::DepthBiasState::default())
    }

    /// The pipeline, drawing depth alone.
    pub(super) fn build_depth(&self, gpu: &Gpu, bias: wgpu::DepthBiasState) -> wgpu::RenderPipeline {
        self.pipeline(gpu, &self.module(gpu), None, bias)
    }

    fn options(&self) -> wgpu::PipelineCompilationOptions<'_> {
        wgpu::PipelineCompilationOptions { constants: self.constants, ..Default::default() }
    }

    fn module(&self, gpu: &Gpu) -> wgpu::ShaderModule {
        let source = wgpu::ShaderSource::Wgsl(self.shader.into());
        gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(self.label), source })
    }

    fn pipeline(
        &self,
        gpu: &Gpu,
        module: &wgpu::ShaderModule,
        fragment: Option<wgpu::FragmentState<'_>>,
        bias: wgpu::DepthBiasState,
    ) -> wgpu::RenderPipeline {
        let groups: Vec<_> = self.groups.iter().map(|g| Some(*g)).collect();
        let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.label),
            bind_group_layouts: &groups,
            immediate_size: 0,
        });
        let buffers: Vec<_> = self.buffers.iter().cloned().map(Some).collect();
        let descriptor = wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some(self.vertex),
                compilation_options: self.options(),
                buffers: &buffers,
            },
            primitive: wgpu::PrimitiveState { cull_mode: self.cull, ..Default::default() },
            depth_stencil: Some(self.depth.state(bias)),
            multisample: wgpu::MultisampleState { count: self.samples, ..Default::default() },
            fragment,
            multiview_mask: None,
            cache: None,
        };
        gpu.pipeline(self.label, &descriptor)
    }
}

impl Depth {
    fn state(self, bias: wgpu::DepthBiasState) -> wgpu::DepthStencilState {
        let (compare, writes) = match self {
            Self::Write => (wgpu::CompareFunction::LessEqual, true),
            Self::Set => (wgpu::CompareFunction::Always, true),
            Self::Test => (wgpu::CompareFunction::LessEqual, false),
            Self::Ignore => (wgpu::CompareFunction::Always, false),
        };
        wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(writes),
            depth_compare: Some(compare),
            stencil: wgpu::StencilState::default(),
            bias,
        }
    }
}

/// The layout of a buffer of instances.
pub(super) fn per_instance<T>(attributes: &[wgpu::VertexAttribute]) -> wgpu::VertexBufferLayout<'_> {
    let array_stride = size_of::<T>() as u64;
    wgpu::VertexBufferLayout { array_stride, step_mode: wgpu::VertexStepMode::Instance, attributes }
}

/// The layout of a buffer of vertices.
pub(super) fn per_vertex<T>(attributes: &[wgpu::VertexAttribute]) -> wgpu::VertexBufferLayout<'_> {
    let array_stride = size_of::<T>() as u64;
    wgpu::VertexBufferLayout { array_stride, step_mode: wgpu::VertexStepMode::Vertex, attributes }
}
