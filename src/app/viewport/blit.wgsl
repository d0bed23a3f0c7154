// Copies the finished 3D picture into egui's pass.
//
// Input: nothing but the vertex number; one triangle covers the viewport that egui has set to the view's rectangle.
// Output: the picture's texel; its bytes are sRGB-encoded already. `to_linear` undoes that for a target that encodes.

@group(0) @binding(0) var picture: texture_2d<f32>;

struct Corner {
    @builtin(position) clip: vec4<f32>,
    @location(0) uv: vec2<f32>,
}

@vertex
fn cover(@builtin(vertex_index) number: u32) -> Corner {
    let uv = vec2<f32>(f32((number << 1u) & 2u), f32(number & 2u));
    var corner: Corner;
    corner.clip = vec4<f32>(uv.x * 2.0 - 1.0, 1.0 - uv.y * 2.0, 0.0, 1.0);
    corner.uv = uv;
    return corner;
}

// The picture is as large as the rectangle: its texel is loaded, for a sampler works out first how fine a level to read.
fn texel(corner: Corner) -> vec4<f32> {
    return textureLoad(picture, vec2<i32>(corner.uv * vec2<f32>(textureDimensions(picture))), 0);
}

@fragment
fn as_is(corner: Corner) -> @location(0) vec4<f32> {
    return texel(corner);
}

@fragment
fn to_linear(corner: Corner) -> @location(0) vec4<f32> {
    let encoded = texel(corner);
    let low = encoded.rgb / 12.92;
    let high = pow((encoded.rgb + 0.055) / 1.055, vec3<f32>(2.4));
    return vec4<f32>(select(high, low, encoded.rgb <= vec3<f32>(0.04045)), encoded.a);
}
