//! Claims about draw lists, without a GPU: what is in a picture, where, and whether it is true.

#![expect(clippy::cast_possible_truncation, reason = "draw lists are f32")]

use girderbench::geometry::End;
use girderbench::scene::facing::Side;
use girderbench::scene::{ModelKind, Overlays, Scene, ViewPreset, presets};
use girderbench::sim::{ContactState, History, OfSection, SolidId};
use girderbench::view::list::{ArrowKind, Mark};
use girderbench::view::moment::OverlapNow;
use girderbench::view::{
    Background, Bending, Bent, Bounds, Camera, DrawList, Moment, Projection, Target, ViewInput, auto_force_scale,
    draw_list, gap, pick, scale,
};
use glam::{DVec3, Vec3};

use crate::handmade;

const SIZE: [u32; 2] = [1280, 720];
const ASPECT: f64 = 1280.0 / 720.0;

fn load(name: &str) -> Scene {
    presets::load(name).expect("a preset is valid")
}

fn run(name: &str) -> History {
    History::of(&load(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn input<'a>(scene: &'a Scene, history: Option<&'a History>, t: f64, camera: &'a Camera) -> ViewInput<'a> {
    ViewInput {
        scene,
        history,
        t,
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

fn at(history: &History, t: f64) -> DrawList {
    let scene = history.scene();
    let camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(scene), ASPECT);
    let overlays = Overlays { normal: true, tangential: true, damping: true, ..Overlays::default() };
    draw_list(&ViewInput { overlays, ..input(scene, Some(history), t, &camera) })
}

/// Compares a list with the blessed one of that name, which lies beside the blessed pictures.
fn check(name: &str, list: &DrawList) {
    insta::with_settings!({ snapshot_path => "../snapshots", prepend_module_to_snapshot => false }, {
        insta::assert_snapshot!(name, list);
    });
}

#[test]
fn presets_as_placed_are_drawn_like_this() {
    for name in ["skew45-abutment", "straight-straight", "deck-30m"] {
        let scene = load(name);
        let camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(&scene), ASPECT);
        check(&format!("{name}-as-placed"), &draw_list(&input(&scene, None, 0.0, &camera)));
    }
}

#[test]
fn first_hits_are_drawn_like_this() {
    for name in ["flush-free-hit", "skew45-abutment", "straight-straight"] {
        let history = run(name);
        let hit = history.hits().touches().first().expect("something touches");
        // Its peak may be where another corner parts, and rounding would choose the side.
        let hit = hit.start + 0.3 * (hit.end - hit.start);
        check(&format!("{name}-first-hit"), &at(&history, hit));
    }
}

#[test]
fn both_states_are_drawn_like_this() {
    let (scene, moment) = handmade::pressed([ContactState::Slip, ContactState::Stick]);
    check("slip-and-stick", &handmade::list(&scene, &moment, SIZE, 1.0, Overlays::default()));
}

/// The resultant's tip in its cone: height along the axis, and distance from it over that height.
fn in_the_cone(list: &DrawList, contact: usize) -> Option<(f32, f32, f32)> {
    let cone = list.cones.iter().find(|c| c.contact == contact)?;
    let arrow = list.arrows.iter().find(|a| a.contact == contact && a.kind == ArrowKind::Resultant)?;
    assert_eq!(cone.apex, arrow.from, "the arrow starts at the apex");
    let tip = arrow.to - cone.apex;
    let height = tip.dot(cone.axis);
    Some((height, cone.height, (tip - cone.axis * height).length() / cone.height))
}

#[test]
fn the_tip_lies_inside_the_outline_in_stick_and_on_the_filled_rim_in_slip() {
    // f32 positions of at most 100 m and cones of 1e-3 of a girder and more: some 1e-3 of their height.
    const TOLERANCE: f32 = 5e-3;
    let mut seen = [0usize; 2];
    for name in ["skew45-abutment", "skew60-abutment", "straight-straight", "row-of-5"] {
        let history = run(name);
        let longest = history.scene().girders[0].length as f32;
        let times = history
            .hits()
            .touches()
            .iter()
            .take(40)
            .flat_map(|u| (1..8).map(move |i| u.start + (u.end - u.start) * f64::from(i) / 8.0));
        for t in times {
            let list = at(&history, t);
            for contact in history.contacts().at(t) {
                let Some((height, full, ratio)) = in_the_cone(&list, contact.contact) else { continue };
                if full < 1e-2 * longest {
                    continue;
                }
                assert!((height - full).abs() < TOLERANCE * full, "{name}, t = {t}: the tip is as high as the cone");
                let (mu_s, mu_k) = (contact.mu_static as f32, contact.mu_kinetic as f32);
                if contact.state == ContactState::Slip {
                    seen[1] += 1;
                    assert!((ratio - mu_k).abs() < TOLERANCE, "{name}, t = {t}: slip at {ratio}, the rim is {mu_k}");
                } else {
                    seen[0] += 1;
                    assert!(ratio < mu_s + TOLERANCE, "{name}, t = {t}: stick at {ratio}, the outline is {mu_s}");
                }
            }
        }
    }
    assert!(seen.iter().all(|&n| n > 50), "both states were drawn often: {seen:?} in stick and slip");
}

#[test]
fn arrows_are_forces_in_one_scale() {
    let history = run("skew45-abutment");
    let scale = auto_force_scale(&history);
    for touch in history.hits().touches().iter().take(10) {
        let list = at(&history, touch.peak_time);
        let contacts = history.contacts().at(touch.peak_time);
        let contact = contacts.iter().find(|c| c.contact == touch.contact).expect("it is closed at its peak");
        let arrow = |kind| list.arrows.iter().find(|a| a.contact == touch.contact && a.kind == kind);
        let is = |kind, force: DVec3| {
            let Some(arrow) = arrow(kind) else {
                assert!(force.length() / scale < 2e-3, "only what is a few pixels long is left out: {force}");
                return;
            };
            let drawn = (arrow.to - arrow.from).as_dvec3() * scale;
            // f32 positions of 0.1 m.
            assert!((drawn - force).length() < 1e-7 * scale, "{kind:?}: {drawn} for {force}");
        };
        is(ArrowKind::Resultant, contact.elastic_force());
        is(ArrowKind::Normal, contact.normal * contact.normal_force);
        is(ArrowKind::Tangential, contact.tangential_force);
        is(ArrowKind::Damping, contact.normal * contact.normal_damping + contact.tangential_damping);
    }
}

#[test]
fn the_scale_is_round_fixed_and_can_be_chosen() {
    let history = run("skew45-abutment");
    let scene = history.scene();
    let scale = auto_force_scale(&history);
    assert_eq!(scale::round_down(scale), scale, "{scale} is 1, 2 or 5 times a power of ten");
    let peak = history.hits().hardest().expect("it hits").peak_force;
    let longest = peak / scale / scene.girders[0].length;
    assert!((0.1..=0.5).contains(&longest), "the longest arrow is {longest} of a girder");
    let camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(scene), ASPECT);
    let t = history.hits().touches()[0].peak_time;
    let length = |force_scale| {
        let list = draw_list(&ViewInput { force_scale, ..input(scene, Some(&history), t, &camera) });
        list.arrows[0].from.distance(list.arrows[0].to)
    };
    let doubled = length(Some(scale / 2.0)) / length(None);
    assert!((doubled - 2.0).abs() < 1e-5, "half the newtons per metre, twice the length: {doubled}");
}

#[test]
fn the_legend_bar_is_as_long_as_a_force_of_its_number() {
    let history = run("skew45-abutment");
    let camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(history.scene()), ASPECT);
    let bar_of = |list: &DrawList| {
        let bar = list.marks.iter().find_map(|m| match m {
            Mark::Stroke { points, width, .. } if *width == 2.4 && points[0].y == points[1].y => {
                Some(points[1].x - points[0].x)
            }
            _ => None,
        });
        f64::from(bar.expect("the legend has a bar"))
    };
    let list = at(&history, history.hits().touches()[0].peak_time);
    let bar = bar_of(&list);
    assert_eq!(bar, bar_of(&at(&history, 0.0)), "one bar for a whole film");
    let newtons = list.marks.iter().find_map(|m| match m {
        Mark::Text { text, at, .. } if at.x > 1000.0 => text.strip_suffix(" N").and_then(|n| n.parse::<f64>().ok()),
        _ => None,
    });
    let newtons = newtons.expect("the bar has a number");
    assert_eq!(scale::round_down(newtons), newtons, "a round number");
    let focus = history.model().sites[history.hits().hardest().expect("it hits").contact].point;
    let pixels = newtons / auto_force_scale(&history) / camera.metres_per_pixel(focus, 720.0);
    // Pixels near 100 held as f32.
    assert!((bar - pixels).abs() < 1e-3, "a bar of {bar} pixels for {newtons} N, which are {pixels}");
}

#[test]
fn a_state_is_never_said_by_colour_alone() {
    let (scene, moment) = handmade::pressed([ContactState::Slip, ContactState::Stick]);
    let bare = Overlays { legend: false, axes: false, ..Overlays::default() };
    let list = handmade::list(&scene, &moment, SIZE, 1.0, bare);
    let disks = list.marks.iter().filter(|m| matches!(m, Mark::Disk { .. })).count();
    let rings = list.marks.iter().filter(|m| matches!(m, Mark::Ring { .. })).count();
    assert_eq!((disks, rings), (1, 1), "a disk for stick, a ring for slip");
}

#[test]
fn a_contact_that_opened_a_moment_ago_has_a_cross_and_soon_none() {
    let history = run("skew45-abutment");
    let tenth = 0.1 / 2.6;
    let crosses = |t| at(&history, t).marks.iter().filter(|m| matches!(m, Mark::Cross { .. })).count();
    let legend = crosses(0.0);
    let opened = |t: f64| history.hits().touches().iter().filter(|u| u.end <= t && u.end > t - tenth).count();
    let touch = history.hits().touches().first().expect("it hits");
    assert!(crosses(touch.end + 1e-4) > legend, "just after opening");
    assert_eq!(crosses(touch.start - 1e-4), legend, "before the first touch");
    let calm =
        history.hits().touches().iter().map(|u| u.end + 1.01 * tenth).find(|&t| t < history.end() && opened(t) == 0);
    assert_eq!(crosses(calm.expect("it is calm at times")), legend, "a tenth of a period later");
}

/// A layer, how it is turned off, and what it leaves in a list's text.
type Without = (&'static str, fn(&mut Overlays), &'static str);

#[test]
fn every_layer_can_be_left_out() {
    let (scene, moment) = handmade::pressed([ContactState::Slip, ContactState::Stick]);
    let all = Overlays { normal: true, tangential: true, damping: true, ..Overlays::default() };
    let text = |o| handmade::list(&scene, &moment, SIZE, 1.0, o).to_string();
    let full = text(all);
    let without: [Without; 12] = [
        ("grid", |o| o.grid = false, ", grid 0"),
        ("bearings", |o| o.bearings = false, "deck bearing 1"),
        ("gap", |o| o.gap = false, "gap "),
        ("normal", |o| o.normal = false, ": Normal"),
        ("tangential", |o| o.tangential = false, ": Tangential"),
        ("resultant", |o| o.resultant = false, ": Resultant"),
        ("damping", |o| o.damping = false, ": Damping"),
        ("cones", |o| o.cones = false, "cone"),
        ("axes", |o| o.axes = false, "\"z\""),
        ("legend", |o| o.legend = false, "friction law"),
        ("title", |o| o.title = false, "skew45-abutment"),
        ("names", |o| o.names = false, "\"deck\""),
    ];
    for (layer, turn_off, trace) in without {
        assert!(full.contains(trace), "{layer}: {trace:?} is in the whole picture");
        let mut overlays = all;
        turn_off(&mut overlays);
        assert!(!text(overlays).contains(trace), "{layer}: {trace:?} is gone without it");
    }
}

#[test]
fn the_gap_shown_is_the_gap_placed_along_the_axis() {
    for (name, wanted) in [("skew45-abutment", 0.003), ("straight-straight", 0.003), ("deck-30m", 0.05)] {
        let scene = load(name);
        let moment = Moment::placed(&scene);
        let gaps = gap::gaps(&scene, &moment);
        assert!(!gaps.is_empty(), "{name}: there is a pair");
        for now in gaps {
            let now = now.unwrap_or_else(|| panic!("{name}: every pair here has a gap"));
            assert!((now.gap - wanted).abs() < 1e-12, "{name}: {} m, rounding aside {wanted}", now.gap);
            assert!(((now.to - now.from).length() - wanted).abs() < 1e-12, "{name}: drawn as long as it is");
        }
        assert!(matches!(moment.facings[0].first, Side::Girder(0, End::Plus)), "{name}: the first pair is deck+x");
    }
}

#[test]
fn every_side_of_every_body_looks_outwards() {
    // The renderer leaves out sides that look away from the eye: one turned inside out would be a hole.
    for name in presets::all().iter().map(|p| p.name) {
        let list = draw_list(&input(&load(name), None, 0.0, &Camera::preset(ViewPreset::Iso, Bounds::UNIT, ASPECT)));
        assert!(!list.solids.is_empty(), "{name}: there are bodies");
        for solid in list.solids.iter().chain(&list.ghosts) {
            let block =
                girderbench::view::block::Block { face: solid.face.map(Vec3::as_dvec3), sweep: solid.sweep.as_dvec3() };
            let middle = block.corners().iter().sum::<DVec3>() / 8.0;
            for (normal, point) in block.sides() {
                assert!(normal.dot(point - middle) > 0.0, "{name}, {}: a side looks inwards", solid.name);
            }
        }
    }
}

#[test]
fn a_standing_view_sees_every_girder_whole() {
    for name in presets::all().iter().map(|p| p.name) {
        let scene = load(name);
        let bounds = Bounds::of_scene(&scene);
        for view in [ViewPreset::Iso, ViewPreset::Top, ViewPreset::Side, ViewPreset::Contact] {
            for aspect in [0.5, 1.0, ASPECT, 3.0] {
                let camera = Camera::preset(view, bounds, aspect);
                let size = [1000.0 * aspect, 1000.0];
                for girder in &scene.girders {
                    for corner in girderbench::view::block::girder_block(girder).corners() {
                        let [x, y] = camera.project(corner, size).expect("before the eye");
                        let inside = (0.0..=size[0]).contains(&x) && (0.0..=size[1]).contains(&y);
                        assert!(inside, "{name}, {view:?}, aspect {aspect}: {corner} falls on ({x:.0}, {y:.0})");
                    }
                }
            }
        }
    }
}

#[test]
fn picking_undoes_projecting() {
    let size = SIZE.map(f64::from);
    let place = DVec3::new(0.3, -0.2, 0.1);
    for projection in [Projection::Perspective { fov_y: 0.6 }, Projection::Orthographic] {
        let camera = Camera { target: DVec3::new(0.1, 0.2, 0.0), yaw: 1.0, pitch: 0.4, distance: 3.0, projection };
        let [x, y] = camera.project(place, size).expect("before the eye");
        let ndc = [2.0 * x / size[0] - 1.0, 1.0 - 2.0 * y / size[1]];
        let (from, along) = camera.ray(ndc, ASPECT);
        let off = (place - from).reject_from(along).length();
        assert!(off < 1e-12 * 3e3, "{projection:?}: the line of sight passes {off} m beside the point");
        let clip = camera.clip_from_world(ASPECT, Bounds::UNIT) * place.extend(1.0);
        let [cx, cy] = [clip.x / clip.w, clip.y / clip.w];
        assert!((cx - ndc[0]).hypot(cy - ndc[1]) < 1e-12, "{projection:?}: the renderer's matrix agrees");
    }
}

#[test]
fn what_is_seen_is_what_is_picked() {
    let history = run("skew45-abutment");
    let scene = history.scene();
    let camera = Camera::preset(ViewPreset::Top, Bounds::of_scene(scene), ASPECT);
    let t = history.hits().touches()[0].peak_time;
    let input = input(scene, Some(&history), t, &camera);
    let size = SIZE.map(f64::from);
    let at = |place: DVec3| {
        let [x, y] = camera.project(place, size).expect("before the eye");
        pick(&input, [2.0 * x / size[0] - 1.0, 1.0 - 2.0 * y / size[1]])
    };
    assert_eq!(at(history.motion(0, t).place), Some(Target::Girder(0)), "the middle of the girder");
    assert_eq!(at(DVec3::new(0.2, 0.0, 0.0)), Some(Target::Abutment(0)), "well behind the wall's face");
    assert_eq!(at(DVec3::new(-0.1, 0.1, 0.0)), None, "beside the girder there is nothing");
    let touched = history.contacts().at(t)[0];
    assert_eq!(at(touched.point), Some(Target::Contact(touched.contact)), "a contact before the body under it");
}

#[test]
fn a_girder_that_is_drawn_exaggerated_is_picked_where_it_is_drawn() {
    let history = run("skew45-abutment");
    let scene = history.scene();
    let camera = Camera::preset(ViewPreset::Top, Bounds::of_scene(scene), ASPECT);
    let t = history.hits().touches()[0].peak_time;
    let place = history.motion(0, t).place;
    let shift = history.motion(0, t).displacement;
    // Near the end away from the wall, 10 mm inside: drawn 30 times as far, the girder has left it.
    let end = place - DVec3::X * 0.085;
    assert!(30.0 * shift.x > 0.02, "towards the wall: {shift} m");
    let [x, y] = camera.project(end, SIZE.map(f64::from)).expect("before the eye");
    let ndc = [2.0 * x / f64::from(SIZE[0]) - 1.0, 1.0 - 2.0 * y / f64::from(SIZE[1])];
    let at = |exaggeration: f64| pick(&ViewInput { exaggeration, ..input(scene, Some(&history), t, &camera) }, ndc);
    assert_eq!(at(1.0), Some(Target::Girder(0)), "as it is");
    assert_eq!(at(30.0), None, "as it is drawn");
}

#[test]
fn orbiting_panning_and_zooming_do_what_hands_expect() {
    let mut camera = Camera::preset(ViewPreset::Iso, Bounds::UNIT, 1.0);
    let before = camera;
    camera.orbit(0.0, 100.0);
    assert!(camera.pitch < std::f64::consts::FRAC_PI_2, "never over the top");
    camera = before;
    let mark = camera.target;
    camera.pan(30.0, 20.0, 500.0);
    let [x, y] = camera.project(mark, [500.0, 500.0]).expect("before the eye");
    assert!((x - 280.0).abs() < 1e-9 && (y - 270.0).abs() < 1e-9, "the ground follows the hand: ({x}, {y})");
    camera = before;
    camera.zoom(0.5);
    assert_eq!(camera.distance, before.distance / 2.0, "half as far");
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        camera.zoom(factor);
    }
    assert_eq!(camera.distance, before.distance / 2.0, "nonsense changes nothing");
}

#[test]
fn a_contact_camera_sees_the_hardest_hit_and_its_arrow() {
    for name in ["skew45-abutment", "straight-straight", "deck-30m", "row-of-5"] {
        let history = run(name);
        let touch = *history.hits().hardest().expect("it hits");
        // Asked far from any hit, it still frames the hardest.
        let camera = Camera::contact(&history, 0.0, ASPECT);
        let contacts = history.contacts().at(touch.peak_time);
        let hit = contacts.iter().find(|c| c.contact == touch.contact).expect("closed at its peak");
        let tip = hit.point + hit.elastic_force() / auto_force_scale(&history);
        let on = |p| camera.project(p, [1280.0, 720.0]).expect("before the eye");
        let (a, b) = (on(hit.point), on(tip));
        for [x, y] in [a, b] {
            assert!((0.0..1280.0).contains(&x) && (0.0..720.0).contains(&y), "{name}: ({x:.0}, {y:.0})");
        }
        let length = (a[0] - b[0]).hypot(a[1] - b[1]);
        assert!(length > 100.0, "{name}: the arrow is {length:.0} pixels long and can be read");
    }
}

#[test]
fn a_list_prints_alike_and_without_negative_zeros() {
    let (scene, moment) = handmade::pressed([ContactState::Slip, ContactState::Stick]);
    let print = || handmade::list(&scene, &moment, SIZE, 1.0, Overlays::default()).to_string();
    assert_eq!(print(), print(), "a pure function");
    assert!(!print().contains("-0.0000"), "zero has no sign");
    let list = handmade::list(&scene, &moment, SIZE, 1.0, Overlays::default());
    assert!(list.solids.iter().all(|s| s.face.iter().all(|p: &Vec3| p.is_finite())), "every corner is a number");
}

#[test]
fn a_text_stays_on_its_line_whatever_it_says() {
    let mut scene = load("skew45-abutment");
    scene.girders[0].name = "a\nb".to_owned();
    let camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(&scene), 1.5);
    for force_scale in [1e-280, 1e300] {
        let input = ViewInput {
            title: Some("two\r\nlines\tand a tab"),
            force_scale: Some(force_scale),
            ..input(&scene, None, 0.0, &camera)
        };
        let list = draw_list(&input);
        let texts = list.marks.iter().filter_map(|m| if let Mark::Text { text, .. } = m { Some(text) } else { None });
        let texts: Vec<&String> = texts.collect();
        assert!(texts.iter().any(|t| *t == "two  lines and a tab"), "spaces for breaks: {texts:?}");
        assert!(texts.iter().any(|t| *t == "a b"), "in names too: {texts:?}");
        assert!(texts.iter().all(|t| t.chars().count() < 60 && !t.contains(char::is_control)), "short: {texts:?}");
    }
}

#[test]
fn nonsense_in_a_view_is_no_panic() {
    let history = run("flush-free-hit");
    let scene = history.scene();
    let camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(scene), ASPECT);
    for t in [f64::NAN, f64::INFINITY, -1.0, 1e9] {
        for force_scale in [None, Some(f64::NAN), Some(0.0), Some(-1.0), Some(1e-300)] {
            for size in [[1, 1], [0, 0], [7, 3000]] {
                let selected = Some(Target::Contact(usize::MAX));
                let input = ViewInput {
                    t,
                    force_scale,
                    size,
                    selected: selected.as_slice(),
                    ..input(scene, Some(&history), t, &camera)
                };
                let _ = draw_list(&input).to_string();
                let _ = pick(&input, [f64::NAN, 2.0]);
            }
        }
    }
    let empty = Scene { girders: Vec::new(), abutments: Vec::new(), ..scene.clone() };
    let _ = draw_list(&input(&empty, None, 0.0, &camera)).to_string();
}

#[test]
fn both_models_are_drawn_together_and_told_apart() {
    let mut scene = load("skew45-abutment");
    scene.model.kind = ModelKind::Both;
    let history = History::of(&scene).expect("a preset runs");
    let hit = history.beside().and_then(|beside| beside.impact()?.hits.first().cloned()).expect("it hits");
    let list = at(&history, hit.t + 1e-3);
    // Twelve edges of twelve dashes.
    assert_eq!(list.xray_lines.iter().filter(|line| line.group == "ghost").count(), 144, "the other model's girder");
    let texts: Vec<&str> = list
        .marks
        .iter()
        .filter_map(|m| if let Mark::Text { text, .. } = m { Some(text.as_str()) } else { None })
        .collect();
    for words in [
        "deck · c: contact, sliding and turning",
        "contact model",
        "impact model, and its states",
        "impulse of a hit, fading",
    ] {
        assert!(texts.contains(&words), "{words} is said: {texts:?}");
    }
    let impulse = list.arrows.iter().find(|arrow| arrow.kind == ArrowKind::Impulse).expect("the hit's impulse");
    let scale = f64::from((impulse.to - impulse.from).length());
    let size = hit.impulses.total()[0].hypot(hit.impulses.total()[1]);
    let unit = girderbench::view::scale::auto_impulse_scale(history.beside().expect("both")).expect("there are hits");
    assert!((scale - size / unit).abs() < 1e-6, "as long as it was large");
    let later = at(&history, hit.t + 0.02);
    let faded = later.arrows.iter().find(|arrow| arrow.kind == ArrowKind::Impulse).expect("still there");
    assert!(faded.color.0[3] < impulse.color.0[3], "it fades");
    assert!(at(&history, hit.t + 0.3).arrows.iter().all(|arrow| arrow.kind != ArrowKind::Impulse), "and is gone");
}

#[test]
fn one_model_alone_is_drawn_as_before() {
    let history = run("skew45-abutment");
    let list = at(&history, 0.29);
    assert!(list.xray_lines.iter().all(|line| line.group != "ghost"), "no ghost");
    assert!(list.arrows.iter().all(|arrow| arrow.kind != ArrowKind::Impulse), "no impulse");
}

#[test]
fn an_overlap_without_contact_is_hatched_over_what_both_bodies_share() {
    // Two girders of 0.19 × 0.07 m, the second 0.15 m and 0.05 m away: they share 0.04 × 0.02 m.
    let mut scene = load("straight-straight");
    for (girder, place) in scene.girders.iter_mut().zip([[0.0; 3], [0.15, 0.05, 0.0]]) {
        (girder.position, girder.length, girder.width, girder.skew_deg) = (place, 0.19, 0.07, 90.0);
    }
    let mut moment = Moment::placed(&scene);
    let shared = OverlapNow {
        bodies: [SolidId::Girder(0), SolidId::Girder(1)],
        depth: 0.02,
        place: DVec3::new(0.075, 0.025, 0.0),
    };
    let list = |moment: &Moment| handmade::list(&scene, moment, SIZE, 1.0, Overlays::default());
    let words = |list: &DrawList| {
        let texts =
            list.marks.iter().filter_map(|m| if let Mark::Text { text, .. } = m { Some(text.clone()) } else { None });
        texts.filter(|text| text.contains("overlap")).collect::<Vec<_>>()
    };
    assert_eq!(words(&list(&moment)), [""; 0], "nothing to say where nothing overlaps");
    moment.overlaps.push(shared);
    let drawn = list(&moment);
    assert_eq!(words(&drawn), ["overlap 20.0 mm, no contact", "overlap that no contact carries"], "label and legend");
    let lines: Vec<_> = drawn.xray_lines.iter().filter(|line| line.group == "overlap").collect();
    assert!(lines.len() > 4, "an outline and a hatching: {lines:?}");
    let ends = || lines.iter().flat_map(|line| [line.from, line.to]);
    let [min, max] = [ends().fold(Vec3::INFINITY, Vec3::min), ends().fold(Vec3::NEG_INFINITY, Vec3::max)];
    let top = scene.girders[0].thickness as f32 / 2.0;
    assert!(min.distance(Vec3::new(0.055, 0.015, top)) < 1e-6, "{min}");
    assert!(max.distance(Vec3::new(0.095, 0.035, top)) < 1e-6, "{max}");
}

#[test]
fn an_end_off_its_seat_is_drawn_with_the_edge_that_it_left() {
    let mut scene = presets::load("skew60-abutment").expect("ships");
    scene.duration = 2.0;
    let drawn = |scene: &Scene| {
        let history = History::of(scene).expect("runs");
        let seat = history.seats().of_girder(0).first().copied();
        let t = seat.map_or(1.0, |seat| seat.least().t);
        let camera = Camera::preset(ViewPreset::Iso, Bounds::of_scene(scene), ASPECT);
        let list = draw_list(&input(scene, Some(&history), t, &camera));
        (list.xray_lines.iter().filter(|line| line.group == "seat edge").count(), seat)
    };
    scene.girders[0].seat.plus = Some(0.001);
    let (lines, seat) = drawn(&scene);
    assert!(seat.is_some_and(|seat| seat.off_at().is_some()), "it comes off: {seat:?}");
    assert_eq!(lines, 2, "front edge, and the part of the end beyond it");
    scene.girders[0].seat.plus = Some(0.5);
    assert_eq!(drawn(&scene).0, 0, "on its seat nothing is marked");
}

#[test]
fn a_girder_that_bends_keeps_the_end_that_faces_something_where_it_is() {
    let mut scene = load("deck-30m-elastic");
    scene.duration = 1.2;
    let history = History::of(&scene).unwrap_or_else(|errors| panic!("{errors}"));
    let t = history.hits().touches()[0].peak_time;
    let camera = Camera::preset(ViewPreset::Top, Bounds::of_scene(&scene), ASPECT);
    let drawn = |factor: f64| {
        let bending = Bending { factor: Some(factor), force: Some(OfSection::Axial) };
        let bent = Bent::of(&history, bending).expect("it bends");
        draw_list(&ViewInput { bent: Some(bent), ..input(&scene, Some(&history), t, &camera) })
    };
    let ends = |list: &DrawList| {
        let slices: Vec<_> = list.solids.iter().filter(|solid| solid.name == "deck").collect();
        assert!(slices.len() > 20, "in slices");
        (slices[0].face[0], slices[slices.len() - 1].face[3], slices[slices.len() - 1].face[2])
    };
    let ((far, ..), (far_50, ..)) = (ends(&drawn(1.0)), ends(&drawn(50.0)));
    let ((_, a, b), (_, a_50, b_50)) = (ends(&drawn(1.0)), ends(&drawn(50.0)));
    assert!((a - a_50).length() < 1e-5 && (b - b_50).length() < 1e-5, "corners before the wall are where they are");
    assert!((far - far_50).length() > 0.02, "the other end is drawn farther off: {far} and {far_50}");
    // Corners of the end by the run itself.
    let place = history.sections().end_displacement(0, End::Plus, t);
    let centre = 0.5 * (a + b);
    let placed = DVec3::new(15.0, 0.0, 0.0) + place;
    assert!((centre.as_dvec3().truncate() - placed.truncate()).length() < 1e-5, "{centre} against {placed}");
    let words = drawn(50.0).to_string();
    assert!(words.contains("deformation drawn × 50"), "the factor is in the picture");
    assert!(
        words.contains("normal force N, tension +") && words.contains("MN"),
        "what the colours mean is in the picture"
    );
    let auto = Bent::of(&history, Bending::default()).expect("it bends");
    assert!(auto.factor > 10.0 && auto.colored.is_none(), "{auto:?}");
}
