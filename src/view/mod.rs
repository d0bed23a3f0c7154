//! From an answer to a picture's contents: a draw list without any graphics library.
//!
//! Here f64 becomes f32. [`draw_list`] is a pure function of a [`ViewInput`]: the scene, its history, an instant, a
//! camera and the layers wanted. The renderer draws the list; tests read it as text.

#![expect(clippy::cast_possible_truncation, reason = "f64 becomes f32 in this room, for the renderer's sake")]

mod area;
mod bearings;
mod bending;
mod bent;
pub mod block;
mod bodies;
mod bounds;
mod camera;
mod crowd;
mod decoration;
mod devices;
mod exaggerated;
mod forces;
mod framing;
mod friction_circle;
mod friction_cone;
pub mod gap;
pub mod gauge;
mod ground_caption;
mod ground_line;
mod hiding;
mod input;
mod labels;
mod legend;
mod light;
pub mod list;
pub mod marks;
pub mod moment;
mod overlap;
mod palette;
mod pick;
mod piers;
mod print;
pub mod scale;
mod scale_bar;
mod seat_edges;
mod seats;
mod texts;
mod walls;
mod words;

pub use bending::{Bending, Bent};
pub use bounds::Bounds;
pub use camera::{Basis, Camera, Projection};
pub use framing::{InView, in_view};
pub use input::{MOST_KEPT, Target, ViewInput};
pub use list::{Background, DrawList};
pub use moment::Moment;
pub use palette::KEPT;
pub use pick::pick;
pub use scale::auto_force_scale;
pub use words::{contact_state, impact_state, section_force};

use area::Area;
use labels::Placer;
use palette::Palette;

/// Distances at which bodies far from the scene, mainly long backwalls, begin and end to fade, in radii of the scene \[–\].
const FADE: [f64; 2] = [1.1, 2.1];

/// Everything that the picture shows.
pub fn draw_list(input: &ViewInput<'_>) -> DrawList {
    draw_moment(input, &shown(input))
}

/// The instant as drawn: displacements and rotations times `input.exaggeration`.
fn shown(input: &ViewInput<'_>) -> Moment {
    let moment = Moment::of(input);
    match input.history.filter(|_| input.is_exaggerated()) {
        Some(history) => moment.exaggerated(history, input.exaggeration),
        None => moment,
    }
}

/// Everything that the picture shows of one instant that is already gathered.
pub fn draw_moment(input: &ViewInput<'_>, moment: &Moment) -> DrawList {
    let palette = Palette::of(input.background);
    let bounds = Bounds::of_scene(input.scene);
    let bodies = bodies::bodies(input, moment, &palette);
    let forces = forces::forces(input, moment, &palette);
    let devices = devices::lines(input, moment, &palette);
    let overlaps = overlap::lines(input, moment);
    let seat_edges = seat_edges::lines(input, moment);
    let gaps = if input.overlays.gap { gap::gaps(input.scene, moment) } else { Vec::new() };
    let real = |i: usize, g: &gap::GapNow| moment.true_gaps.get(i).copied().flatten().unwrap_or(g.gap);
    let gaps = gaps.into_iter().enumerate();
    let gaps: Vec<_> = gaps.map(|(i, g)| g.map(|g| gap::GapNow { gap: real(i, &g), ..g })).collect();
    let pairs = gap::pairs(input);
    let drawn = gaps.iter().enumerate().filter_map(|(i, g)| Some((g.as_ref()?, pairs.get(i).copied())));
    let gaps: Vec<_> = drawn.map(|(g, pair)| gap::dimension(input, (g, pair), &palette)).collect();
    let marks = marks(input, moment, &palette, &forces, &gaps);
    let gap_lines = gaps.into_iter().flat_map(|g| g.lines);
    let ground = bodies::ground(input.scene, bounds, &palette, input.overlays.grid);
    let ground_line = ground_line::lines(input, f64::from(ground.centre.z), palette.edge);
    DrawList {
        size: input.size,
        pixels_per_point: input.pixels_per_point,
        frame: frame(input, bounds, &palette),
        ground: Some(ground),
        solids: bodies.solids,
        ghosts: bodies.ghosts,
        lines: bodies.lines.into_iter().chain(ground_line).collect(),
        xray_lines: bodies
            .outline
            .into_iter()
            .chain(gap_lines)
            .chain(forces.lines)
            .chain(devices)
            .chain(overlaps)
            .chain(seat_edges)
            .collect(),
        cones: forces.cones,
        arrows: forces.arrows,
        marks,
    }
}

fn frame(input: &ViewInput<'_>, bounds: Bounds, palette: &Palette) -> list::Frame {
    let walls = input.scene.abutments.iter().filter_map(|a| block::abutment_block(input.scene, a));
    let ground = bodies::ground(input.scene, bounds, palette, false);
    let about = Bounds { min: ground.centre.as_dvec3(), max: ground.centre.as_dvec3() }.grown(f64::from(ground.radius));
    let everything = Bounds::of_points(walls.flat_map(|b| b.corners()).chain(about.corners()).chain(bounds.corners()));
    let lit = bounds.grown(0.35 * bounds.radius());
    let (towards_light, light_from_world) = light::light(lit);
    list::Frame {
        clip_from_world: input.camera.clip_from_world(input.aspect(), everything).as_mat4(),
        eye: input.camera.homogeneous_eye().as_vec4(),
        lift: (1.2e-3 * input.camera.distance) as f32,
        towards_light: towards_light.as_vec3(),
        light_from_world: light_from_world.as_mat4(),
        light_width: (2.0 * lit.radius()) as f32,
        middle: bounds.centre().truncate().as_vec2(),
        fade: FADE.map(|share| (share * bounds.radius()) as f32),
        sky: palette.sky,
        floor: palette.floor,
    }
}

/// Half of the square about a gap's end, or about what is drawn over the picture, that is kept clear \[points\]: that in which a handle is
/// taken.
const KEPT_CLEAR: f32 = 9.0;

/// Everything flat: panels first, since labels keep clear of them, then labels, glyphs on top.
fn marks(
    input: &ViewInput<'_>,
    moment: &Moment,
    palette: &Palette,
    forces: &forces::Forces,
    gaps: &[gap::Dimension],
) -> Vec<list::Mark> {
    let o = input.overlays;
    let mut placer = Placer::new(input.size, input.pixels_per_point, palette.faint_ink);
    let mut marks = Vec::new();
    let spacing = o.grid.then(|| bodies::grid_spacing(Bounds::of_scene(input.scene)));
    let legend = o.legend.then(|| legend::legend(input, moment, palette, spacing)).flatten();
    let axes = o.axes.then(|| legend::axes(input, palette));
    let bar = o.axes.then(|| scale_bar::scale_bar(input, palette)).flatten();
    let mut taken: Vec<_> = legend.iter().chain(&axes).chain(&bar).map(|(_, area)| *area).collect();
    let mut gauges = Vec::new();
    for contact in gauge::told(input, moment) {
        let drawn = gauge::gauge(input, contact, &taken, palette);
        taken.extend(drawn.iter().map(|(_, area)| *area));
        gauges.extend(drawn);
    }
    let ends = gaps.iter().flat_map(|gap| gap.ends).filter_map(|at| input::pixel(input, at));
    let kept: Vec<_> = ends.map(|at| Area::about(at, glam::Vec2::splat(KEPT_CLEAR * input.pixels_per_point))).collect();
    let clear = input.clear.iter().map(|at| Area::about(*at, glam::Vec2::splat(KEPT_CLEAR * input.pixels_per_point)));
    let clear: Vec<_> = clear.collect();
    let circles = friction_circle::friction_circles(input, moment, &[&taken[..], &kept, &clear].concat(), palette);
    let heading = if o.title { texts::heading(input, moment, palette, &mut placer) } else { Vec::new() };
    let panels: Vec<_> = legend.into_iter().chain(axes).chain(bar).chain(circles).chain(gauges).collect();
    for (_, area) in &panels {
        placer.take(*area);
    }
    for area in clear {
        placer.take(area);
    }
    texts::keep_clear(input, moment, forces, &mut placer);
    marks.extend(overlap::labels(input, moment, palette, &mut placer));
    marks.extend(seat_edges::labels(input, moment, palette, &mut placer));
    if o.bearings {
        marks.extend(bearings::labels(input, moment, palette, &mut placer));
    }
    if o.contacts {
        marks.extend(texts::force_values(input, moment, forces, palette, &mut placer));
    }
    marks.extend(texts::gap_values(input, gaps, palette, &mut placer));
    if o.names {
        marks.extend(texts::names(input, moment, palette, &mut placer));
    }
    // Leaders under every text.
    marks.sort_by_key(|mark| !matches!(mark, list::Mark::Stroke { .. }));
    marks.extend(forces.marks.iter().cloned());
    marks.extend(panels.into_iter().flat_map(|(marks, _)| marks));
    marks.extend(heading);
    marks
}
