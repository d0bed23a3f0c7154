// Straight lines of a width in pixels, smooth at their sides without multisampling. Input: world space; output: clip
// space; one instance is one line, six vertices each.

struct Instance {
    @builtin(vertex_index) index: u32,
    @location(0) start: vec3<f32>,
    @location(1) end: vec3<f32>,
    @location(2) color: vec4<f32>,
    @location(3) width: f32,
};

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) color: vec4<f32>,
    // Distance from the axis and half the width [pixels], times w so that they run evenly on the picture; w.
    @location(1) across: vec3<f32>,
    @location(2) world: vec3<f32>,
};

// Towards the eye by a hair, so that an edge lies on its body and not in it.
fn lifted(world: vec3<f32>) -> vec4<f32> {
    return frame.clip_from_world * vec4(world + towards_eye(world) * frame.viewport.z, 1.0);
}

// How far from `a` on the way to `b` the line comes before the near plane.
fn clipped(a: vec4<f32>, b: vec4<f32>) -> f32 {
    return select(0.0, a.z / (a.z - b.z), a.z < 0.0 && b.z > 0.0);
}

@vertex
fn vertex(in: Instance) -> Varying {
    let start = lifted(in.start);
    let end = lifted(in.end);
    let first = clipped(start, end);
    let last = 1.0 - clipped(end, start);
    let a = mix(start, end, first);
    let b = mix(start, end, last);
    let half_size = frame.viewport.xy * 0.5;
    let way = b.xy / b.w * half_size - a.xy / a.w * half_size;
    let along = select(vec2(1.0, 0.0), normalize(way), dot(way, way) > 1e-12);
    let aside = vec2(-along.y, along.x);
    let at_end = in.index == 1u || in.index == 2u || in.index == 4u;
    let side = select(-1.0, 1.0, in.index == 2u || in.index == 4u || in.index == 5u);
    // Thinner than a pixel is a pixel, paler.
    let half_width = max(in.width, 1.0) * 0.5;
    let reach = half_width + 1.0;
    let here = select(a, b, at_end);
    let shift = aside * side * reach + along * select(-half_width, half_width, at_end) * 0.5;
    var out: Varying;
    out.clip = vec4(here.xy + shift / half_size * here.w, here.zw);
    out.world = mix(in.start, in.end, select(first, last, at_end));
    out.color = vec4(in.color.rgb, in.color.a * min(in.width, 1.0));
    out.across = vec3(side * reach * here.w, half_width * here.w, here.w);
    return out;
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    let away = abs(in.across.x) / in.across.z;
    let cover = clamp(in.across.y / in.across.z + 0.5 - away, 0.0, 1.0);
    return premultiplied(vec4(in.color.rgb, in.color.a * cover * nearness(in.world)));
}
