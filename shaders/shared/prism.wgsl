// A flat four-sided face swept along a vector. Mesh: per vertex the corner as weights of a, b, c, d and its place
// along the sweep, and the side that it belongs to. One instance is one solid, in world space.

struct PrismVertex {
    @location(0) corner: vec4<f32>,
    // The edge of the face under this side, as weights; zero on the face and its opposite.
    @location(1) edge: vec4<f32>,
    // x: place along the sweep, 0 or 1; y: +1 on the face, -1 on its opposite, 0 on the sides.
    @location(2) along_cap: vec2<f32>,
    @location(3) a: vec3<f32>,
    @location(4) b: vec3<f32>,
    @location(5) c: vec3<f32>,
    @location(6) d: vec3<f32>,
    @location(7) sweep: vec3<f32>,
    @location(8) color: vec4<f32>,
};

fn prism_world(v: PrismVertex) -> vec3<f32> {
    let on_face = v.corner.x * v.a + v.corner.y * v.b + v.corner.z * v.c + v.corner.w * v.d;
    return on_face + v.along_cap.x * v.sweep;
}

fn prism_normal(v: PrismVertex) -> vec3<f32> {
    let cap = cross(v.c - v.a, v.d - v.b) * v.along_cap.y;
    let edge = v.edge.x * v.a + v.edge.y * v.b + v.edge.z * v.c + v.edge.w * v.d;
    return normalize(cap + cross(v.sweep, edge));
}
