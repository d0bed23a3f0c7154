// Bodies, lit by one sun and an even sky. Input: world space; output: clip space; one instance is one solid.

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) world: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) color: vec4<f32>,
};

@vertex
fn vertex(v: PrismVertex) -> Varying {
    var out: Varying;
    out.world = prism_world(v);
    out.normal = prism_normal(v);
    out.clip = frame.clip_from_world * vec4(out.world, 1.0);
    out.color = v.color;
    return out;
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    let normal = normalize(in.normal);
    let facing = max(dot(normal, frame.towards_light.xyz), 0.0);
    let sun = facing * select(0.0, sunlight(in.world, normal), facing > 0.0);
    let sky = mix(0.30, 0.58, normal.z * 0.5 + 0.5);
    return premultiplied(vec4(under_light(in.color.rgb, sky + 0.62 * sun), in.color.a * nearness(in.world)));
}
