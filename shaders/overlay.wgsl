// Text and flat marks: triangles with a coverage atlas, premultiplied. Input: pixels from the top left; output: clip
// space; one draw is the whole overlay.

@group(1) @binding(0) var atlas: texture_2d<f32>;
@group(1) @binding(1) var atlas_sampler: sampler;

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) uv: vec2<f32>,
    @location(1) color: vec4<f32>,
};

@vertex
fn vertex(@location(0) at: vec2<f32>, @location(1) uv: vec2<f32>, @location(2) color: vec4<f32>) -> Varying {
    var out: Varying;
    out.clip = vec4(at / frame.viewport.xy * vec2(2.0, -2.0) + vec2(-1.0, 1.0), 0.0, 1.0);
    out.uv = uv;
    out.color = color;
    return out;
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    return in.color * textureSampleLevel(atlas, atlas_sampler, in.uv, 0.0);
}
