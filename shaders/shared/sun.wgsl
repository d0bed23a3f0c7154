// How much of the sun reaches a point, from the shadow map.

@group(1) @binding(0) var shadow_map: texture_depth_2d;
@group(1) @binding(1) var shadow_sampler: sampler_comparison;

// Root of the look-ups per pixel, 1, 2 or 3.
override look_ups: i32 = 1;

// 1 in the sun, 0 in the shadow; `normal` lifts the point off its own surface.
fn sunlight(world: vec3<f32>, normal: vec3<f32>) -> f32 {
    let lifted = world + normal * frame.shadow.y;
    let light = frame.light_from_world * vec4(lifted, 1.0);
    let uv = light.xy * vec2(0.5, -0.5) + 0.5;
    let beside = any(uv < vec2(0.0)) || any(uv > vec2(1.0)) || light.z >= 1.0;
    let first = 0.5 - 0.5 * f32(look_ups);
    var sum = 0.0;
    for (var i = 0; i < look_ups; i++) {
        for (var j = 0; j < look_ups; j++) {
            let aside = (vec2(f32(i), f32(j)) + first) * frame.shadow.x * 1.4;
            sum += textureSampleCompareLevel(shadow_map, shadow_sampler, uv + aside, light.z);
        }
    }
    // The map ends softly.
    let inside = 1.0 - smoothstep(0.8, 1.0, max(abs(light.x), abs(light.y)));
    return select(mix(1.0, sum / f32(look_ups * look_ups), inside), 1.0, beside);
}
