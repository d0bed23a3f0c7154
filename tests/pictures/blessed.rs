//! Claims about pictures: every preset looks as blessed, and drawing is whole, lazy and repeatable.
//!
//! `GIRDERBENCH_BLESS=1 cargo test --test pictures blessed` blesses new pictures; look at each before committing it.

use crate::studio::studio;
use crate::{golden, handmade};
use girderbench::render::{Fault, GpuError, Image, Packing, Quality, Renderer};
use girderbench::scene::{ModelKind, Overlays, Scene, ViewPreset, presets};
use girderbench::sim::{ContactState, History};
use girderbench::snapshot::{Instant, Shot, Studio};
use girderbench::view::{Background, Bounds, Camera, DrawList, ViewInput, draw_moment};

const SIZE: [u32; 2] = [640, 360];
/// So that the repository stays light: two girders with contacts, circle and gauge take the most, 150 kB.
const LARGEST_FILE: usize = 151_000;

fn run(scene: &Scene) -> History {
    History::of(scene).unwrap_or_else(|e| panic!("{}: {e}", scene.name))
}

/// An instant well inside the first touch: its peak may be where another corner parts, and rounding would choose the side.
fn first_hit(history: &History) -> Instant {
    Instant::At(history.hits().touches().first().map_or(0.0, |touch| touch.start + 0.3 * (touch.end - touch.start)))
}

fn shot(history: &History) -> Shot {
    Shot { at: first_hit(history), size: SIZE, ..Shot::default() }
}

fn take(studio: &mut Studio, name: &str, history: &History, shot: &Shot) -> Result<(), String> {
    let image = studio.shoot(history, shot).unwrap_or_else(|e| panic!("{name}: {e}"));
    let texts = studio.texts(history.scene(), shot.at.of(history));
    let bytes = image.to_png(&texts, Packing::Small).len();
    assert!(bytes < LARGEST_FILE, "{name}: {bytes} bytes");
    golden::check(name, &image, &texts)
}

fn no_complaint(results: impl IntoIterator<Item = Result<(), String>>) {
    let complaints: Vec<String> = results.into_iter().filter_map(Result::err).collect();
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

#[test]
fn both_models_look_as_blessed() {
    let Some(mut studio) = studio("both_models_look_as_blessed") else { return };
    let mut scene = presets::load("skew45-abutment").expect("a preset is valid");
    scene.model.kind = ModelKind::Both;
    let history = run(&scene);
    let later = Shot { at: Instant::At(0.68), view: Some(ViewPreset::Top), size: SIZE, ..Shot::default() };
    no_complaint([take(&mut studio, "skew45-both-models", &history, &later)]);
}

#[test]
#[expect(clippy::print_stdout, reason = "which adapter drew is worth a line")]
fn every_preset_looks_as_blessed() {
    let Some(mut studio) = studio("every_preset_looks_as_blessed") else { return };
    println!("drawn by {}", studio.gpu.adapter);
    let results = presets::all().iter().map(|preset| {
        let name = preset.name;
        let history = run(&presets::load(name).expect("a preset is valid"));
        take(&mut studio, name, &history, &shot(&history))
    });
    no_complaint(results.collect::<Vec<_>>());
}

#[test]
fn every_view_and_background_looks_as_blessed() {
    let Some(mut studio) = studio("every_view_and_background_looks_as_blessed") else { return };
    let history = run(&presets::load("skew45-abutment").expect("a preset is valid"));
    let all = Overlays { normal: true, tangential: true, damping: true, ..Overlays::default() };
    let cases = [
        ("skew45-contact-peak", Shot { at: Instant::Peak, view: Some(ViewPreset::Contact), ..shot(&history) }),
        (
            "skew45-top-dark",
            Shot { view: Some(ViewPreset::Top), background: Background::Dark, overlays: Some(all), ..shot(&history) },
        ),
        ("skew45-side-white", Shot { view: Some(ViewPreset::Side), background: Background::White, ..shot(&history) }),
        ("skew45-transparent", Shot { size: [480, 270], background: Background::Transparent, ..shot(&history) }),
    ];
    no_complaint(cases.map(|(name, shot)| take(&mut studio, name, &history, &shot)));
}

#[test]
fn both_states_look_as_blessed() {
    let Some(mut studio) = studio("both_states_look_as_blessed") else { return };
    let (scene, moment) = handmade::pressed([ContactState::Slip, ContactState::Stick]);
    let list = handmade::list(&scene, &moment, SIZE, 0.72, Overlays::default());
    let image = studio.draw(&list).expect("it is drawn");
    let texts = studio.texts(&scene, 0.0);
    no_complaint([golden::check("handmade-slip-and-stick", &image, &texts)]);
}

fn pixel(image: &Image, x: u32, y: u32) -> [u8; 4] {
    let at = ((y * image.width + x) * 4) as usize;
    [0, 1, 2, 3].map(|i| image.rgba[at + i])
}

#[test]
fn a_background_is_what_it_says() {
    let Some(mut studio) = studio("a_background_is_what_it_says") else { return };
    let history = run(&presets::load("flush-free-hit").expect("a preset is valid"));
    let bare = Overlays { legend: false, title: false, axes: false, grid: false, ..Overlays::default() };
    let mut corner = |background| {
        let shot = Shot { background, overlays: Some(bare), view: Some(ViewPreset::Side), ..shot(&history) };
        let image = studio.shoot(&history, &shot).expect("it is drawn");
        pixel(&image, 2, 2)
    };
    assert_eq!(corner(Background::White), [0xff; 4], "white");
    assert_eq!(corner(Background::Transparent)[3], 0, "nothing at all");
    assert!(corner(Background::Studio)[..3].iter().all(|&v| v > 0xe0), "light");
    assert!(corner(Background::Dark)[..3].iter().all(|&v| v < 0x40), "dark");
}

#[test]
fn a_picture_is_the_same_twice_and_on_a_second_device() {
    let Some(mut studio) = studio("a_picture_is_the_same_twice_and_on_a_second_device") else { return };
    let history = run(&presets::load("skew60-abutment").expect("a preset is valid"));
    let shot = Shot { view: Some(ViewPreset::Contact), ..shot(&history) };
    let first = studio.shoot(&history, &shot).expect("it is drawn");
    let other = Shot { size: [200, 120], background: Background::Dark, ..shot.clone() };
    studio.shoot(&history, &other).expect("another picture in between is drawn");
    let second = studio.shoot(&history, &shot).expect("it is drawn again");
    assert!(first == second, "the same device draws the same list the same");
    let third = Studio::open(None).expect("a second device").shoot(&history, &shot).expect("it is drawn there");
    assert!(first == third, "so does a second device on the same adapter");
}

#[test]
fn a_lost_device_is_replaced_in_the_middle_of_a_film() {
    let Some(_shared) = studio("a_lost_device_is_replaced_in_the_middle_of_a_film") else { return };
    let mut studio = Studio::open(None).expect("a device of its own, to be lost");
    let list = empty_list();
    let before = studio.draw(&list).expect("it is drawn");
    studio.gpu.device.destroy();
    assert!(studio.draw(&list).expect("it is drawn on another device") == before, "the same picture");
    let (gpu, mut renderer) = (studio.gpu.clone(), Renderer::new(&studio.gpu, Quality::DRAFT));
    gpu.device.destroy();
    let error = renderer.picture(&gpu, &list, list.size).expect_err("by itself a renderer has one device");
    assert!(matches!(error, GpuError::Fault(Fault::Lost(_))), "which it says is lost: {error}");
}

#[test]
fn draft_and_fine_show_the_same_scene() {
    let Some(mut studio) = studio("draft_and_fine_show_the_same_scene") else { return };
    let history = run(&presets::load("skew45-abutment").expect("a preset is valid"));
    let shot = shot(&history);
    let fine = studio.shoot(&history, &shot).expect("it is drawn");
    let mut draft = Studio::open(Some(Quality::DRAFT)).expect("a second device");
    let draft = draft.shoot(&history, &shot).expect("it is drawn");
    let far = fine.rgba.iter().zip(&draft.rgba).filter(|(a, b)| a.abs_diff(**b) > 64).count();
    // Edges and the rim of the shadow; a lost body or legend would be tens of per cent.
    let share = far as f64 / fine.rgba.len() as f64;
    assert!(share < 0.02, "{:.2} % of the channels differ by a quarter", 100.0 * share);
}

fn empty_list() -> DrawList {
    let (scene, moment) = handmade::pressed([ContactState::Stick; 2]);
    let mut list = handmade::list(&scene, &moment, [64, 64], 1.0, Overlays::default());
    list.ground = None;
    list.frame.floor = list.frame.sky;
    list.solids.clear();
    list.ghosts.clear();
    list.lines.clear();
    list.xray_lines.clear();
    list.cones.clear();
    list.arrows.clear();
    list.marks.clear();
    list
}

#[test]
fn a_pass_is_built_only_when_a_list_has_something_for_it() {
    let Some(studio) = studio("a_pass_is_built_only_when_a_list_has_something_for_it") else { return };
    let gpu = &studio.gpu;
    let mut renderer = Renderer::new(gpu, Quality::DRAFT);
    let mut list = empty_list();
    let (_, moment) = handmade::pressed([ContactState::Stick; 2]);
    let (scene, _) = handmade::pressed([ContactState::Stick; 2]);
    let full = handmade::list(&scene, &moment, [64, 64], 1.0, Overlays::default());
    let mut built = |list: &DrawList| {
        renderer.picture(gpu, list, [64, 64]).expect("it is drawn");
        renderer.built()
    };
    assert_eq!(built(&list), Vec::<&str>::new(), "an empty list needs no pass");
    list.cones.clone_from(&full.cones);
    assert_eq!(built(&list), ["cone"], "cones alone");
    list.arrows.clone_from(&full.arrows);
    assert_eq!(built(&list), ["cone", "arrow", "far"], "arrows too, with a depth of their own");
    list.solids.clone_from(&full.solids);
    assert_eq!(built(&list), ["shadow", "solid", "cone", "arrow", "far"], "bodies need their shadow");
    let all = ["backdrop", "shadow", "ground", "solid", "line", "cone", "arrow", "far", "overlay"];
    assert_eq!(built(&full), all, "everything");
}

#[test]
fn an_empty_list_is_a_picture_of_the_background() {
    let Some(mut studio) = studio("an_empty_list_is_a_picture_of_the_background") else { return };
    let list = empty_list();
    let image = studio.draw(&list).expect("it is drawn");
    let [r, g, b, a] = list.frame.sky.0;
    assert!(image.rgba.chunks_exact(4).all(|p| p == [r, g, b, a]), "one colour");
}

#[test]
fn a_png_holds_the_picture_and_says_how_it_was_made() {
    let Some(mut studio) = studio("a_png_holds_the_picture_and_says_how_it_was_made") else { return };
    let history = run(&presets::load("flush-free-hit").expect("a preset is valid"));
    for background in [Background::Studio, Background::Transparent] {
        let image = studio.shoot(&history, &Shot { background, ..shot(&history) }).expect("it is drawn");
        let png = image.to_png(&studio.texts(history.scene(), 0.0125), Packing::Small);
        assert!(Image::from_png(&png).expect("it is a PNG") == image, "every pixel comes back");
        let reader = png::Decoder::new(std::io::Cursor::new(&png)).read_info().expect("it is a PNG");
        let texts = &reader.info().utf8_text;
        let said: Vec<String> = texts.iter().map(|t| t.get_text().expect("a text")).collect();
        for wanted in [&studio.gpu.adapter.name, "flush-free-hit", "0.0125 s", env!("CARGO_PKG_VERSION")] {
            assert!(said.iter().any(|t| t.contains(wanted)), "{wanted} in {said:?}");
        }
    }
}

#[test]
fn a_size_that_no_device_draws_is_refused_in_words() {
    let Some(mut studio) = studio("a_size_that_no_device_draws_is_refused_in_words") else { return };
    for size in [[0, 10], [10, 0], [1_000_000, 10], [16_000, 16_000]] {
        let mut list = empty_list();
        list.size = size;
        let error = studio.draw(&list).expect_err("such a picture cannot be");
        assert!(error.to_string().contains(&size[0].to_string()), "the size is named: {error}");
    }
}

#[test]
fn a_renderer_can_be_handed_to_another_thread() {
    fn holds<T: Send + Sync>() {}
    holds::<Renderer>();
    holds::<Studio>();
}

#[test]
fn extreme_cameras_and_numbers_draw_without_a_complaint() {
    let Some(mut studio) = studio("extreme_cameras_and_numbers_draw_without_a_complaint") else { return };
    let (scene, mut moment) = handmade::pressed([ContactState::Slip, ContactState::Stick]);
    moment.contacts[0].tangential_force = glam::DVec3::NAN;
    moment.contacts[1].normal_force = f64::INFINITY;
    let home = Camera::preset(ViewPreset::Iso, Bounds::of_scene(&scene), 1.0);
    let inside = Camera { distance: 1e-6, ..home };
    let far = Camera { distance: 1e6, ..home };
    let below = Camera { pitch: -1.5, ..home };
    for camera in [home, inside, far, below] {
        let input = ViewInput {
            scene: &scene,
            history: None,
            t: f64::NAN,
            camera: &camera,
            overlays: Overlays::default(),
            force_scale: Some(f64::NAN),
            selected: &[],
            kept: &[],
            exaggeration: 1.0,
            bent: None,
            clear: &[],
            size: [64, 64],
            pixels_per_point: 1.0,
            background: Background::Studio,
            title: Some("∀ \u{0} 橋"),
        };
        studio.draw(&draw_moment(&input, &moment)).expect("it is drawn");
    }
}
