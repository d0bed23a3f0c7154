// How much of the sun reaches a point, from the shadow map.

@group(1) @binding(0) var shadow_map: texture_depth_2d;
@group(1) @binding(1) var shadow_sampler: sampler_comparison;

// 1 in the sun, 0 in the shadow; `normal` lifts the point off its own surface.
fn sunlight(world: vec3<f32>, normal: vec3<f32>) -> f32 {
    let lifted = world + normal * frame.shadow.z;
    let light = frame.light_from_world * vec4(lifted, 1.0);
    let uv = light.xy * vec2(0.5, -0.5) + 0.5;
    if any(uv < vec2(0.0)) || any(uv > vec2(1.0)) || light.z >= 1.0 {
        return 1.0;
    }
    let side = i32(frame.shadow.x);
    let first = 0.5 - 0.5 * frame.shadow.x;
    var sum = 0.0;
    for (var i = 0; i < side; i++) {
        for (var j = 0; j < side; j++) {
            let aside = (vec2(f32(i), f32(j)) + first) * frame.shadow.y * 1.4;
            sum += textureSampleCompareLevel(shadow_map, shadow_sampler, uv + aside, light.z);
        }
    }
    // The map ends softly.
    let inside = 1.0 - smoothstep(0.8, 1.0, max(abs(light.x), abs(light.y)));
    return mix(1.0, sum / f32(side * side), inside);
}
