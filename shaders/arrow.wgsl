// Force arrows, seen through bodies. Mesh: stations along the arrow (tail, neck, head's rim, tip) as weights. Input:
// world space; output: clip space; one instance is one arrow. Drawn twice: grown in the rim's colour, then itself.

struct Vertex {
    // Direction around the axis.
    @location(0) around: vec2<f32>,
    // x: of the length; y: of the head's length, backwards; z: of the shaft's radius; w: of the head's radius.
    @location(1) station: vec4<f32>,
    // x: of the normal around the axis; y: along it.
    @location(2) slope: vec2<f32>,
    @location(3) start: vec3<f32>,
    @location(4) end: vec3<f32>,
    @location(5) radius: f32,
    @location(6) color: vec4<f32>,
    @location(7) rim: vec4<f32>,
};

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) normal: vec3<f32>,
    @location(1) color: vec4<f32>,
    @location(2) rim: vec4<f32>,
};

// The head is this many shaft radii long and half as wide; it shortens on an arrow shorter than it.
const HEAD_LENGTH: f32 = 9.5;
const HEAD_RADIUS: f32 = 3.4;

fn placed(in: Vertex, grown: f32) -> Varying {
    let way = in.end - in.start;
    let length = max(length(way), 1e-12);
    let axis = way / length;
    let helper = select(vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), abs(axis.z) > 0.9);
    let u = normalize(cross(helper, axis));
    let v = cross(axis, u);
    let head = min(HEAD_LENGTH * in.radius, 0.85 * length);
    // A shortened head narrows with its length, and the shaft with it.
    let slim = head / (HEAD_LENGTH * in.radius);
    let radial = u * in.around.x + v * in.around.y;
    let r = in.radius * slim * (in.station.z + HEAD_RADIUS * in.station.w);
    let along = length * in.station.x - head * in.station.y;
    let normal = normalize(radial * in.slope.x + axis * in.slope.y);
    let world = in.start + axis * along + radial * r + normal * grown * in.radius;
    var out: Varying;
    out.clip = frame.clip_from_world * vec4(world, 1.0);
    out.normal = normal;
    out.color = in.color;
    out.rim = in.rim;
    return out;
}

@vertex
fn vertex_rim(in: Vertex) -> Varying {
    return placed(in, 0.75);
}

@fragment
fn fragment_rim(in: Varying) -> @location(0) vec4<f32> {
    return vec4(in.rim.rgb, 1.0);
}

@vertex
fn vertex(in: Vertex) -> Varying {
    return placed(in, 0.0);
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    let facing = max(dot(normalize(in.normal), frame.towards_light.xyz), 0.0);
    return premultiplied(vec4(under_light(in.color.rgb, 0.72 + 0.38 * facing), in.color.a));
}
