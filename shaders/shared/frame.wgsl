// What every pass knows of the picture: camera, light, background. World space is metres, z up; clip space has z in
// [0, 1] and y up. Colours leave every pass sRGB-encoded and premultiplied.

struct Frame {
    clip_from_world: mat4x4<f32>,
    light_from_world: mat4x4<f32>,
    // Homogeneous: a point in perspective, a direction (w = 0) in orthographic views.
    eye: vec4<f32>,
    // xyz: unit vector towards the light.
    towards_light: vec4<f32>,
    // Width and height in pixels; z: how far lines are lifted towards the eye [m].
    viewport: vec4<f32>,
    // x: size of a texel in [0, 1] of the map; y: half as much again in the world [m].
    shadow: vec4<f32>,
    // xy: middle of the scene in plan; z, w: how far from it fading begins and ends [m].
    fade: vec4<f32>,
    sky: vec4<f32>,
    floor: vec4<f32>,
};

@group(0) @binding(0) var<uniform> frame: Frame;

// An encoded colour under a light that multiplies it in linear terms. As 1.055 x^(1/2.4) - 0.055 encodes x, the factor acts on c + 0.055.
// The straight piece of the encoding near black is left out: 3 of 255 at the most, less than half of one for colours above 18 of 255.
fn under_light(c: vec3<f32>, light: f32) -> vec3<f32> {
    return clamp((c + 0.055) * pow(light, 1.0 / 2.4) - 0.055, vec3(0.0), vec3(1.0));
}

fn premultiplied(c: vec4<f32>) -> vec4<f32> {
    return vec4(c.rgb * c.a, c.a);
}

// 1 near the scene, 0 far from it.
fn nearness(world: vec3<f32>) -> f32 {
    return 1.0 - smoothstep(frame.fade.z, frame.fade.w, distance(world.xy, frame.fade.xy));
}

fn towards_eye(world: vec3<f32>) -> vec3<f32> {
    return normalize(frame.eye.xyz - world * frame.eye.w);
}
