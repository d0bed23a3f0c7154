// The ground: shadow and grid on a disk that fades out, the background showing through. Input: one square in world
// space; output: clip space; one instance is the ground.

struct Ground {
    // xyz: middle [m]; w: radius [m].
    place: vec4<f32>,
    // x: spacing of the grid [m], 0 for none.
    spacing: vec4<f32>,
    grid: vec4<f32>,
    shadow: vec4<f32>,
};

@group(2) @binding(0) var<uniform> ground: Ground;

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) world: vec3<f32>,
};

@vertex
fn vertex(@builtin(vertex_index) i: u32) -> Varying {
    let corner = vec2(select(-1.0, 1.0, i == 1u || i == 2u || i == 4u), select(-1.0, 1.0, i == 2u || i == 4u || i == 5u));
    var out: Varying;
    out.world = ground.place.xyz + vec3(corner * ground.place.w, 0.0);
    out.clip = frame.clip_from_world * vec4(out.world, 1.0);
    return out;
}

// Coverage of lines at whole numbers of `p`, about `width` pixels wide; fades before they merge.
fn lines(p: vec2<f32>, step: vec2<f32>, width: f32) -> f32 {
    let away = abs(fract(p - 0.5) - 0.5) / step;
    let on = clamp(vec2(0.5 * width + 0.5) - away, vec2(0.0), vec2(1.0)) * clamp(1.5 - 3.0 * step, vec2(0.0), vec2(1.0));
    return max(on.x, on.y);
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    let cell = in.world.xy / max(ground.spacing.x, 1e-9);
    let step = max(fwidth(cell), vec2(1e-6));
    let fine = lines(cell, step, 1.0) * 0.5;
    let strong = lines(cell / 5.0, step / 5.0, 1.3);
    let away = distance(in.world.xy, ground.place.xy) / ground.place.w;
    let fade = 1.0 - smoothstep(0.3, 1.0, away);
    let line = select(0.0, max(fine, strong) * ground.grid.a, ground.spacing.x > 0.0);
    let dark = (1.0 - sunlight(in.world, vec3(0.0, 0.0, 1.0))) * ground.shadow.a;
    let shade = vec4(ground.shadow.rgb * dark, dark);
    let grid = vec4(ground.grid.rgb * line, line);
    return (grid + shade * (1.0 - line)) * fade;
}
