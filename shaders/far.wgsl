// Depth where nothing is, over which depth begins anew. Input: nothing (one triangle over the picture); output: clip space. The colour
// stays: no colour at no opacity.

@vertex
fn vertex(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
    return vec4(vec2(f32((i << 1u) & 2u), f32(i & 2u)) * 2.0 - 1.0, 1.0, 1.0);
}

@fragment
fn fragment() -> @location(0) vec4<f32> {
    return vec4(0.0);
}
