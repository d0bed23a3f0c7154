// Depth of solids as the light sees them. Input: world space; output: the light's clip space; one instance is one solid.

@vertex
fn vertex(v: PrismVertex) -> @builtin(position) vec4<f32> {
    return frame.light_from_world * vec4(prism_world(v), 1.0);
}
