//! Claims about what pictures cost: nothing is made or drawn for what is off or out of view, and the picture is the
//! same to the last bit.

use std::sync::Arc;

use crate::studio::studio;
use crate::{handmade, row};
use girderbench::render::{Gpu, GpuError, Made, Packing, Quality, Renderer, Thing, changes};
use girderbench::scene::{Overlays, Scene, ViewPreset, presets};
use girderbench::sim::{ContactState, History};
use girderbench::snapshot::{Frame, Instant, Shot, Studio, film};
use girderbench::view::moment::at_rest;
use girderbench::view::{Background, Bounds, Camera, DrawList, Moment, ViewInput, draw_list, draw_moment};
use glam::DVec3;

const SIZE: [u32; 2] = [320, 180];
/// Frames of a moving picture.
const FRAMES: u32 = 30;

fn run(name: &str) -> History {
    History::of(&presets::load(name).expect("a preset is valid")).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// A renderer that has made nothing yet, and what it made of some lists.
fn made_of(gpu: &Gpu, lists: &[&DrawList]) -> Made {
    let before = gpu.made();
    let mut renderer = Renderer::new(gpu, Quality::DRAFT);
    for list in lists {
        renderer.picture(gpu, list, list.size).expect("it is drawn");
    }
    gpu.made().since(&before)
}

fn pressed(overlays: Overlays) -> DrawList {
    let (scene, moment) = handmade::pressed([ContactState::Slip, ContactState::Stick]);
    handmade::list(&scene, &moment, SIZE, 1.0, overlays)
}

const NONE: Overlays = Overlays {
    grid: false,
    bearings: false,
    gap: false,
    contacts: false,
    normal: false,
    tangential: false,
    resultant: false,
    damping: false,
    cones: false,
    axes: false,
    legend: false,
    title: false,
    names: false,
    decoration: false,
};

#[test]
fn an_overlay_that_is_off_has_no_pipeline_mesh_buffer_or_pass() {
    let Some(studio) = studio("an_overlay_that_is_off_has_no_pipeline_mesh_buffer_or_pass") else { return };
    let made = |overlays| made_of(&studio.gpu, &[&pressed(overlays)]);
    let bare = made(NONE);
    assert_eq!(bare.labels(Thing::Pipeline), ["backdrop", "ground", "line", "shadow", "solid"], "bodies alone");
    assert_eq!(bare.labels(Thing::Pass), ["picture", "shadow"], "one pass, and one for the shadow map");
    let buffers = ["frame", "ground", "line", "prism", "read back", "solids"];
    assert_eq!(bare.labels(Thing::Buffer), buffers, "one mesh, its instances, two uniforms");
    assert_eq!(bare.count(Thing::Texture, "font atlas"), 0, "no letters");
    for (overlays, pipeline) in [
        (Overlays { cones: true, ..NONE }, "cone"),
        (Overlays { resultant: true, ..NONE }, "arrow"),
        (Overlays { title: true, ..NONE }, "overlay"),
    ] {
        let with = made(overlays);
        assert!(with.count(Thing::Pipeline, pipeline) > 0, "{pipeline} is built when it is on");
        assert_eq!(bare.count(Thing::Pipeline, pipeline), 0, "and not when it is off");
        let more = with.total(Thing::Buffer) - bare.total(Thing::Buffer);
        assert!(more > 0, "{pipeline} brings its buffers along, {more}");
        assert_eq!(with.total(Thing::Pass), bare.total(Thing::Pass), "{pipeline} needs no pass of its own");
    }
}

#[test]
fn a_cone_out_of_view_is_no_reason_to_build_its_pipeline() {
    let Some(studio) = studio("a_cone_out_of_view_is_no_reason_to_build_its_pipeline") else { return };
    let mut list = pressed(Overlays { cones: true, ..NONE });
    list.xray_lines.clear();
    // Gauge and friction circle come with the cones.
    list.marks.clear();
    assert!(!list.cones.is_empty(), "there are cones");
    assert_eq!(made_of(&studio.gpu, &[&list]).count(Thing::Pipeline, "cone"), 1, "in view");
    list.cones.iter_mut().for_each(|cone| cone.apex.x += 1e3);
    let made = made_of(&studio.gpu, &[&list]);
    assert_eq!(made.count(Thing::Pipeline, "cone") + made.count(Thing::Buffer, "cones"), 0, "out of view");
}

#[test]
fn a_second_picture_makes_nothing_new() {
    let Some(studio) = studio("a_second_picture_makes_nothing_new") else { return };
    let gpu = &studio.gpu;
    let mut renderer = Renderer::new(gpu, Quality::DRAFT);
    let list = pressed(Overlays::default());
    renderer.picture(gpu, &list, SIZE).expect("it is drawn");
    let before = gpu.made();
    for _ in 0..3 {
        renderer.picture(gpu, &list, SIZE).expect("it is drawn again");
    }
    let more = gpu.made().since(&before);
    let made = [Thing::Pipeline, Thing::Buffer, Thing::Texture].map(|thing| more.total(thing));
    assert_eq!(made, [0; 3], "pipelines, buffers and textures are kept");
    assert_eq!(more.total(Thing::Pass), 6, "two passes each");
}

fn view<'a>(scene: &'a Scene, history: Option<&'a History>, camera: &'a Camera) -> ViewInput<'a> {
    ViewInput {
        scene,
        history,
        t: 0.7,
        camera,
        overlays: Overlays::default(),
        force_scale: None,
        selected: &[],
        kept: &[],
        exaggeration: 1.0,
        bent: None,
        clear: &[],
        size: SIZE,
        pixels_per_point: 1.0,
        background: Background::Studio,
        title: None,
    }
}

/// The list drawn with and without what is out of view; the same, and how many instances were left out.
fn culled_of(studio: &mut Studio, list: &DrawList, what: &str) -> u64 {
    studio.set_culling(false);
    let whole = studio.draw(list).expect("it is drawn");
    studio.set_culling(true);
    let before = studio.gpu.made();
    let seen = studio.draw(list).expect("it is drawn");
    assert!(seen == whole, "{what}: the same picture to the last bit");
    studio.gpu.made().since(&before).total(Thing::Culled)
}

#[test]
fn what_is_out_of_view_changes_no_pixel() {
    let Some(mut studio) = studio("what_is_out_of_view_changes_no_pixel") else { return };
    let mut culled = 0;
    for name in ["skew45-abutment", "row-of-5", "deck-30m"] {
        let history = run(name);
        let bounds = Bounds::of_scene(history.scene());
        for preset in [ViewPreset::Iso, ViewPreset::Top, ViewPreset::Side, ViewPreset::Contact] {
            // From all of it to a thousandth of it, off the middle, low and from behind.
            for (nearer, aside, yaw) in [(1.0, 0.0, 0.0), (0.3, 0.3, 1.0), (0.05, -0.4, 2.5), (1e-3, 0.1, 4.0)] {
                let mut camera = Camera::preset(preset, bounds, 16.0 / 9.0);
                camera.zoom(nearer);
                camera.target += DVec3::new(aside, -0.2 * aside, 0.1 * aside) * bounds.radius();
                camera.yaw += yaw;
                let list = draw_list(&view(history.scene(), Some(&history), &camera));
                culled += culled_of(&mut studio, &list, &format!("{name} {preset:?} at {nearer}"));
            }
        }
    }
    assert!(culled > 100, "something was left out, {culled}");
}

/// A moving picture of a preset, drawn in parts, is compared with each of its frames drawn whole; the pixels drawn, as a share of all.
fn drawn_of(gpu: &Gpu, name: &str, preset: ViewPreset) -> f64 {
    let history = run(name);
    let size = [960, 540];
    let camera = Camera::preset(preset, Bounds::of_scene(history.scene()), 16.0 / 9.0);
    let [mut parts, mut whole] = [(); 2].map(|()| Renderer::new(gpu, Quality::DRAFT));
    let encoder = || gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut before: Option<Arc<DrawList>> = None;
    let (mut drawn, mut all) = (0.0, 0.0);
    for number in 0..FRAMES {
        let t = 0.033 * f64::from(number);
        let list = Arc::new(draw_list(&ViewInput { t, size, ..view(history.scene(), Some(&history), &camera) }));
        let mut recorded = encoder();
        parts.draw_changes(gpu, &mut recorded, &list);
        let in_parts = parts.read(gpu, recorded).expect("it is drawn");
        let at_once = whole.picture(gpu, &list, size).expect("it is drawn");
        let pixels = in_parts.rgba.chunks_exact(4).zip(at_once.rgba.chunks_exact(4));
        let differing = pixels.enumerate().filter(|(_, (one, other))| one != other).map(|(i, _)| i);
        let places: Vec<_> = differing.map(|i| [i % size[0] as usize, i / size[0] as usize]).collect();
        assert!(places.is_empty(), "{name} {preset:?} at {t:.3} s: {} pixels differ, {:?}", places.len(), places[0]);
        if let Some(before) = before {
            drawn += changes(&before, &list).area() as f64;
            all += f64::from(size[0]) * f64::from(size[1]);
        }
        before = Some(list);
    }
    drawn / all
}

#[test]
#[expect(clippy::print_stdout, reason = "how much is spared is worth a line")]
fn a_moving_picture_drawn_in_parts_is_the_picture_to_the_last_bit() {
    let Some(studio) = studio("a_moving_picture_drawn_in_parts_is_the_picture_to_the_last_bit") else { return };
    for name in ["skew45-abutment", "deck-30m", "row-of-5"] {
        for preset in [ViewPreset::Iso, ViewPreset::Top, ViewPreset::Side] {
            let drawn = drawn_of(&studio.gpu, name, preset);
            println!("{name} {preset:?}: {:.0} % of the pixels are drawn", 100.0 * drawn);
        }
    }
}

#[test]
fn a_body_out_of_view_still_throws_its_shadow_into_it() {
    let Some(mut studio) = studio("a_body_out_of_view_still_throws_its_shadow_into_it") else { return };
    let history = run("row-of-5");
    let bounds = Bounds::of_scene(history.scene());
    let mut camera = Camera::preset(ViewPreset::Top, bounds, 16.0 / 9.0);
    // 0.4 m of the ground beside the row, on the side away from the light, where 2.7 m under the girders' tops the
    // shadow is 0.9 m wide.
    camera.target += DVec3::new(0.0, bounds.size().y / 2.0 + 0.45, 0.0);
    camera.zoom(0.4 / camera.visible_height());
    let list = draw_list(&ViewInput { t: 0.0, overlays: NONE, ..view(history.scene(), Some(&history), &camera) });
    culled_of(&mut studio, &list, "beside the row");
    let before = studio.gpu.made();
    studio.draw(&list).expect("it is drawn");
    let more = studio.gpu.made().since(&before);
    assert_eq!(more.count(Thing::Drawn, "solids"), 0, "no body is in view");
    assert_eq!(more.count(Thing::Drawn, "casters"), 1, "one throws its shadow into it");
    let lit = DrawList { solids: Vec::new(), ..list.clone() };
    let (shaded, lit) = (studio.draw(&list).expect("it is drawn"), studio.draw(&lit).expect("it is drawn"));
    assert!(shaded != lit, "their shadow is not");
}

#[test]
#[expect(clippy::print_stdout, reason = "how much is spared is worth a line")]
fn of_a_thousand_girders_seen_close_up_few_are_drawn() {
    let Some(mut studio) = studio("of_a_thousand_girders_seen_close_up_few_are_drawn") else { return };
    let scene = row::of(1000);
    // As placed, but for the search of who faces whom, which is not what this is about.
    let motions = scene.girders.iter().map(at_rest).collect();
    let moment = Moment { motions, ..Moment::placed(&row::of(1)) };
    let mut camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(&scene), 16.0 / 9.0);
    let drawn = |studio: &mut Studio, camera: &Camera, what: &str| {
        let list = draw_moment(&view(&scene, None, camera), &moment);
        assert!(list.solids.len() >= 1000, "every girder is in the list, {}", list.solids.len());
        culled_of(studio, &list, what);
        let before = studio.gpu.made();
        studio.draw(&list).expect("it is drawn");
        let more = studio.gpu.made().since(&before);
        let (drawn, culled) = (more.total(Thing::Drawn), more.total(Thing::Culled));
        println!("{what}: {drawn} instances drawn, {culled} left out; marks: {}", list.marks.len());
        more.count(Thing::Drawn, "solids")
    };
    let all = drawn(&mut studio, &camera, "the whole row");
    assert!(all >= 1000, "from afar everything is in view, {all}");
    camera.frame(Bounds::of_points(row::corners_of(&scene, 500)), 16.0 / 9.0);
    let few = drawn(&mut studio, &camera, "one girder of 1000");
    assert!(
        (1..all / 200).contains(&few),
        "one girder of 1000 and its neighbours: fewer than the parts of five, {few} of {all}"
    );
}

fn frames_of(studio: &mut Studio, history: &History, shots: &[Shot]) -> (usize, Vec<Vec<u8>>) {
    let mut frames = vec![Vec::new(); shots.len()];
    let mut put = |Frame { number, png }: Frame| {
        assert!(frames[number].is_empty(), "frame {number} comes once");
        frames[number] = png;
        Ok::<_, GpuError>(())
    };
    let drawn = film(studio, history, shots, Packing::Quick, &mut put).expect("it is filmed");
    (drawn, frames)
}

fn shots(n: u32, overlays: Overlays) -> Vec<Shot> {
    let at = |i| Instant::At(0.02 * f64::from(i));
    (0..n).map(|i| Shot { at: at(i), size: SIZE, overlays: Some(overlays), ..Shot::default() }).collect()
}

#[test]
fn a_film_is_its_pictures_and_makes_them_with_one_set_of_things() {
    let Some(mut studio) = studio("a_film_is_its_pictures_and_makes_them_with_one_set_of_things") else { return };
    let history = run("skew45-abutment");
    let shots = shots(12, Overlays::default());
    // Once, so that everything is there that is needed.
    frames_of(&mut studio, &history, &shots);
    let before = studio.gpu.made();
    let (drawn, frames) = frames_of(&mut studio, &history, &shots);
    let more = studio.gpu.made().since(&before);
    assert_eq!(drawn, 12, "every instant is another picture");
    assert_eq!(more.total(Thing::Pipeline) + more.total(Thing::Buffer), 0, "nothing is made for a frame");
    for (shot, frame) in shots.iter().zip(&frames) {
        let alone = studio.shoot(&history, shot).expect("it is drawn");
        assert!(
            alone.to_png(&studio.texts(history.scene(), shot.at.of(&history)), Packing::Quick) == *frame,
            "the same"
        );
    }
}

#[test]
fn a_frame_in_which_nothing_moves_is_not_drawn_again() {
    let Some(mut studio) = studio("a_frame_in_which_nothing_moves_is_not_drawn_again") else { return };
    let mut scene = presets::load("skew45-abutment").expect("a preset is valid");
    scene.motion = girderbench::scene::Motion::None;
    let history = History::of(&scene).expect("it runs");
    // Without the title, which shows the time.
    let shots = shots(8, Overlays { title: false, ..Overlays::default() });
    let before = studio.gpu.made();
    let (drawn, frames) = frames_of(&mut studio, &history, &shots);
    assert_eq!(drawn, 1, "eight frames of a girder at rest");
    assert_eq!(studio.gpu.made().since(&before).count(Thing::Pass, "picture"), 1, "one pass");
    assert!(frames.iter().all(|f| !f.is_empty()), "eight files all the same");
}

#[test]
fn a_film_that_cannot_be_kept_ends_with_the_reason() {
    let Some(mut studio) = studio("a_film_that_cannot_be_kept_ends_with_the_reason") else { return };
    let history = run("flush-free-hit");
    let mut kept = 0;
    let ended = film(&mut studio, &history, &shots(6, NONE), Packing::Quick, &mut |_| {
        kept += 1;
        if kept == 2 { Err(GpuError::Readback("the disk is full".to_owned())) } else { Ok(()) }
    });
    assert!(ended.is_err_and(|e| e.to_string().contains("the disk is full")), "it says why");
    assert_eq!(kept, 2, "and goes no further");
}

#[test]
fn however_a_picture_is_packed_it_is_the_same() {
    let Some(mut studio) = studio("however_a_picture_is_packed_it_is_the_same") else { return };
    let image = studio.draw(&pressed(Overlays::default())).expect("it is drawn");
    for packing in [Packing::Small, Packing::Quick] {
        let back = girderbench::render::Image::from_png(&image.to_png(&[], packing)).expect("a PNG");
        assert!(back == image, "{packing:?}: every pixel comes back");
    }
}

#[test]
fn things_are_made_where_they_are_counted() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src/render");
    let passes = root.join("pass");
    for folder in [root, passes] {
        for entry in std::fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() || path.ends_with("gpu.rs") {
                continue;
            }
            let text = std::fs::read_to_string(&path).expect("source is text");
            for maker in ["create_buffer", "create_texture", "create_render_pipeline"] {
                assert!(!text.contains(maker), "{}: {maker} is called in gpu.rs alone", path.display());
            }
        }
    }
}
