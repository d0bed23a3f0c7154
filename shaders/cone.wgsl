// Filled friction cones, seen through bodies. Mesh: a unit cone, apex at 0, rim at z = 1. Input: world space; output:
// clip space; one instance is one cone.

struct Vertex {
    @location(0) unit: vec3<f32>,
    @location(1) apex: vec3<f32>,
    @location(2) axis: vec3<f32>,
    // x: height [m]; y: rim over height.
    @location(3) shape: vec2<f32>,
    @location(4) color: vec4<f32>,
};

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) color: vec4<f32>,
};

@vertex
fn vertex(in: Vertex) -> Varying {
    let helper = select(vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), abs(in.axis.z) > 0.9);
    let u = normalize(cross(helper, in.axis));
    let v = cross(in.axis, u);
    let aside = (u * in.unit.x + v * in.unit.y) * in.shape.y;
    let world = in.apex + (in.axis * in.unit.z + aside) * in.shape.x;
    var out: Varying;
    out.clip = frame.clip_from_world * vec4(world, 1.0);
    out.color = in.color;
    return out;
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    return premultiplied(in.color);
}
