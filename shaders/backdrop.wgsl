// Background of the picture, from sky at the top to floor at the bottom. Input: nothing (one triangle over the
// picture); output: clip space.

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) down: f32,
};

@vertex
fn vertex(@builtin(vertex_index) i: u32) -> Varying {
    let at = vec2(f32((i << 1u) & 2u), f32(i & 2u));
    var out: Varying;
    out.clip = vec4(at * 2.0 - 1.0, 0.0, 1.0);
    out.down = 1.0 - at.y;
    return out;
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    return premultiplied(mix(frame.sky, frame.floor, smoothstep(0.0, 1.0, in.down)));
}
