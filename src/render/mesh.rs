//! The three meshes that instances are made of: swept face, cone, arrow.

use std::f32::consts::TAU;

/// Segments around a cone or an arrow.
const AROUND: u16 = 32;

/// A vertex of the swept face: see `shaders/shared/prism.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct PrismVertex {
    corner: [f32; 4],
    edge: [f32; 4],
    along_cap: [f32; 2],
}

/// A vertex of an arrow: see `shaders/arrow.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct ArrowVertex {
    around: [f32; 2],
    station: [f32; 4],
    slope: [f32; 2],
}

/// How many vertices a mesh has, as draws count them.
pub(super) fn count<T>(mesh: &[T]) -> u32 {
    u32::try_from(mesh.len()).unwrap_or(u32::MAX)
}

fn weight(corner: usize) -> [f32; 4] {
    std::array::from_fn(|i| if i == corner { 1.0 } else { 0.0 })
}

/// The swept face: face, its opposite, and the sides under ab, bc, cd, da, two triangles each.
pub(super) fn prism() -> Vec<PrismVertex> {
    let cap = |corner, sign: f32| PrismVertex {
        corner: weight(corner),
        edge: [0.0; 4],
        along_cap: [if sign > 0.0 { 0.0 } else { 1.0 }, sign],
    };
    let face = [0, 1, 2, 0, 2, 3].map(|k| cap(k, 1.0));
    let opposite = [0, 2, 1, 0, 3, 2].map(|k| cap(k, -1.0));
    let sides = (0..4).flat_map(|k| {
        let next = (k + 1) % 4;
        let edge = std::array::from_fn(|i| weight(next)[i] - weight(k)[i]);
        let at = move |corner, along| PrismVertex { corner: weight(corner), edge, along_cap: [along, 0.0] };
        // Anticlockwise seen from outside, the sweep leading away from the face.
        [at(k, 0.0), at(k, 1.0), at(next, 1.0), at(k, 0.0), at(next, 1.0), at(next, 0.0)]
    });
    face.into_iter().chain(opposite).chain(sides).collect()
}

fn around(i: u16) -> [f32; 2] {
    let angle = TAU * f32::from(i % AROUND) / f32::from(AROUND);
    [angle.cos(), angle.sin()]
}

/// A unit cone, apex at 0, open at its rim at z = 1.
pub(super) fn cone() -> Vec<[f32; 3]> {
    let rim = |i| {
        let [x, y] = around(i);
        [x, y, 1.0]
    };
    (0..AROUND).flat_map(|i| [[0.0; 3], rim(i), rim(i + 1)]).collect()
}

/// Stations of an arrow from tail to tip, as (share of the length, of the head's length, of the shaft's radius, of the
/// head's radius), and the slope of the surface up to the next.
const STATIONS: [([f32; 4], [f32; 4], [f32; 2]); 4] = [
    // The tail's disk.
    ([0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, -1.0]),
    // The shaft.
    ([0.0, 0.0, 1.0, 0.0], [1.0, 1.0, 1.0, 0.0], [1.0, 0.0]),
    // The head's underside.
    ([1.0, 1.0, 1.0, 0.0], [1.0, 1.0, 0.0, 1.0], [0.0, -1.0]),
    // The head.
    ([1.0, 1.0, 0.0, 1.0], [1.0, 0.0, 0.0, 0.0], [0.94, 0.34]),
];

/// An arrow from tail to tip.
pub(super) fn arrow() -> Vec<ArrowVertex> {
    let band = |(from, to, slope): ([f32; 4], [f32; 4], [f32; 2])| {
        (0..AROUND).flat_map(move |i| {
            let at = |station, j| ArrowVertex { around: around(j), station, slope };
            [at(from, i), at(from, i + 1), at(to, i + 1), at(from, i), at(to, i + 1), at(to, i)]
        })
    };
    STATIONS.into_iter().flat_map(band).collect()
}
