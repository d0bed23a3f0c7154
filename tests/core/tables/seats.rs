//! Remaining seats against closed forms: a free deck that moves and turns at a steady rate, its mirror image, and the numbers of
//! the worked example of docs/seats.md.

use girderbench::codes::{self, Source};
use girderbench::geometry::{End, Prism};
use girderbench::scene::{EuropeanGround, Girder, Initial, Motion, Scene, Seat, presets};
use girderbench::sim::seats::{self, Departure};
use girderbench::sim::{History, readings};

/// The deck of docs/seats.md: 30 m × 10 m, β = 60°, seats of 0.85 m along the axis, free, on a still ground.
fn deck(initial: Initial) -> Scene {
    let mut scene = presets::load("flush-free-hit").expect("ships");
    let girder = Girder { skew_deg: 60.0, initial, ..Girder::straight("deck", [30.0, 10.0, 1.5], 3e5) };
    let seat = Seat { plus: Some(0.85), minus: Some(0.85), side: None };
    (scene.girders, scene.abutments) = (vec![Girder { seat, ..girder }], Vec::new());
    scene.contact.pairs.clear();
    (scene.motion, scene.duration) = (Motion::None, 4.0);
    scene
}

fn run(scene: &Scene) -> [seats::Seat; 2] {
    let history = History::of(scene).expect("runs");
    history.seats().of_girder(0).try_into().expect("both ends")
}

fn near(got: f64, wanted: f64, within: f64, what: &str) {
    assert!((got - wanted).abs() <= within, "{what}: {wanted}, got {got} (off by {:e})", got - wanted);
}

/// cos and sin of 60°, sin 60° · 0.85.
fn sixty() -> [f64; 3] {
    let (sine, cosine) = 60f64.to_radians().sin_cos();
    [cosine, sine, 0.85 * sine]
}

/// What remains at a corner of a deck turned about G by an angle, by hand: `placed + (R − 1)p·ν`.
fn turned(corner: usize, degrees: f64) -> f64 {
    let [cosine, sine, placed] = sixty();
    let prism = Prism { length: 30.0, width: 10.0, thickness: 1.5, skew: 60f64.to_radians() };
    let p = prism.plan_corners()[corner];
    let sign = if corner == 1 || corner == 2 { 1.0 } else { -1.0 };
    let (s, c) = degrees.to_radians().sin_cos();
    placed + sign * ((c * p.x - s * p.y - p.x) * sine - (s * p.x + c * p.y - p.y) * cosine)
}

#[test]
fn a_free_deck_comes_off_when_its_displacement_is_the_seat_square_to_the_edge() {
    let velocity = [-0.5, 0.2, 0.0];
    let [cosine, sine, placed] = sixty();
    let speed = 0.5 * sine + 0.2 * cosine;
    let [plus, minus] = run(&deck(Initial { velocity, ..Initial::default() }));
    near(plus.ledge.placed(), 0.736_121_593_216_772_8, 1e-15, "0.85 sin 60°");
    let t = placed / speed;
    for (which, corner) in plus.corners.iter().enumerate() {
        let Departure { t: off, along } = corner.off.expect("it comes off");
        near(off, t, 1e-14, "r_c = 0");
        let half = 5.0 / sine;
        let placed_at = if which == 0 { -half } else { half };
        near(along, placed_at + t * (0.2 * sine - 0.5 * cosine), 1e-13, "along the edge");
        near(corner.least.value, placed - 4.0 * speed, 1e-13, "least at the end");
    }
    near(plus.lost_at.expect("both"), t, 1e-14, "together: the deck does not turn");
    near(plus.used(), 4.0 * speed, 1e-13, "placed less least");
    assert!(minus.off_at().is_none() && minus.lost_at.is_none(), "the other end moves onto its support");
    near(minus.least().value, placed, 1e-13, "as placed");
    assert_eq!(minus.least_share.value, 1.0, "all of it seated");
}

#[test]
fn a_turning_deck_loses_its_acute_corner_first() {
    // One degree a second. Angles at which r = 0 by bisection of the closed form.
    let scene = Scene { duration: 20.0, ..deck(Initial { spin_deg_s: 1.0, ..Initial::default() }) };
    let zero = |corner: usize| {
        let (mut low, mut high) = (0.0, 20.0);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if turned(corner, middle) > 0.0 { low = middle } else { high = middle }
        }
        high
    };
    let [plus, minus] = run(&scene);
    near(zero(2), 3.097, 5e-4, "the acute corner, as docs/seats.md has it");
    near(zero(1), 13.183, 5e-4, "the obtuse corner");
    for (seat, [obtuse, acute]) in [(plus, [1, 2]), (minus, [3, 0])] {
        let of = |corner: usize| *seat.corners.iter().find(|c| c.corner == corner).expect("its corner");
        near(of(acute).off.expect("off").t, zero(2), 1e-12, "acute");
        near(of(obtuse).off.expect("off").t, zero(1), 1e-12, "obtuse");
        near(seat.lost_at.expect("lost"), zero(1), 1e-12, "with the second corner");
        near(seat.off_at().expect("off"), zero(2), 1e-12, "with the first");
    }
}

#[test]
fn five_degrees_take_what_the_worked_example_says() {
    let [plus, minus] = run(&deck(Initial { rotation_deg: 5.0, ..Initial::default() }));
    let [_, _, placed] = sixty();
    let lost = plus.corners.map(|corner| placed - corner.least.value);
    near(lost[1], 1.2063, 5e-5, "the acute corner of +x");
    near(lost[0], 0.1999, 5e-5, "the obtuse one");
    near(f64::midpoint(lost[0], lost[1]), 0.7031, 5e-5, "the middle");
    near(f64::midpoint(lost[0], lost[1]), 15.0 * (60f64.to_radians().sin() - 55f64.to_radians().sin()), 1e-12, "S_Eθ");
    near(placed - minus.corners[0].least.value, lost[1], 1e-12, "the same at the other end, by symmetry");
    assert_eq!(plus.off_at(), Some(0.0), "off from the beginning");
    let seated = turned(1, 5.0) / (turned(1, 5.0) - turned(2, 5.0));
    near(plus.least_share.value, seated, 1e-12, "r₁/(r₁ − r₂)");
}

#[test]
fn the_mirror_image_loses_the_mirrored_corners() {
    let initial = Initial { velocity: [-0.1, 0.3, 0.0], spin_deg_s: 1.5, ..Initial::default() };
    let scene = deck(initial);
    let mut mirrored = deck(Initial { velocity: [-0.1, -0.3, 0.0], spin_deg_s: -1.5, ..Initial::default() });
    mirrored.girders[0].skew_deg = 120.0;
    for (seat, image) in run(&scene).iter().zip(run(&mirrored)) {
        for (corner, other) in seat.corners.iter().zip([image.corners[1], image.corners[0]]) {
            near(corner.least.value, other.least.value, 1e-12, "least");
            assert_eq!(corner.off.is_some(), other.off.is_some(), "both or neither");
            let Some((off, image)) = corner.off.zip(other.off) else { continue };
            near(off.t, image.t, 1e-12, "when");
            near(off.along, -image.along, 1e-12, "where");
        }
    }
    assert!(run(&scene).iter().any(|seat| seat.off_at().is_some()), "a corner comes off");
}

#[test]
fn a_corner_leaves_the_seat_over_its_side() {
    let mut scene = deck(Initial { velocity: [0.25, 0.25 * 3f64.sqrt(), 0.0], ..Initial::default() });
    scene.girders[0].seat.side = Some(0.6);
    // Along the edge at 0.5 m/s: no seat is lost square to it, the corner at +y is over the side after 1.2 s.
    let [plus, _] = run(&scene);
    near(plus.corners[1].off_side.expect("over the side").t, 1.2, 1e-12, "0.6 m at 0.5 m/s");
    near(plus.corners[1].side.expect("watched").value, 0.6 - 2.0, 1e-12, "least at the end");
    assert!(plus.corners.iter().all(|corner| corner.off.is_none()), "not over the front edge");
    near(plus.off_at().expect("off"), 1.2, 1e-12, "the first way by which a corner comes off");
    near(plus.least().value, sixty()[2], 1e-12, "nothing used");
    near(plus.corners[0].side.expect("watched").value, 0.6, 1e-12, "the other corner moves inwards");
}

#[test]
fn a_seat_far_from_the_origin_and_turned_is_the_same() {
    let initial = Initial { velocity: [-0.5, 0.2, 0.0], ..Initial::default() };
    let [here, _] = run(&deck(initial));
    let mut far = deck(Initial { velocity: [-0.2, -0.5, 0.0], ..Initial::default() });
    (far.girders[0].heading_deg, far.girders[0].position) = (90.0, [1e5, -2e5, 10.0]);
    let [there, _] = run(&far);
    near(here.off_at().expect("off"), there.off_at().expect("off"), 1e-12, "when");
    near(here.least().value, there.least().value, 1e-12, "least");
}

#[test]
fn only_ends_with_a_seat_are_read() {
    let mut scene = deck(Initial::default());
    scene.girders[0].seat = Seat { minus: Some(0.3), ..Seat::default() };
    let history = History::of(&scene).expect("runs");
    let reading = readings::reading(&history, 0);
    assert_eq!(reading.seats.iter().map(|seat| seat.ledge.end).collect::<Vec<_>>(), [End::Minus], "the -x end alone");
}

#[test]
fn the_columns_of_an_end_are_those_up_to_the_next_joint() {
    let mut scene = presets::load("viaduct-5").expect("ships");
    scene.duration = 0.01;
    let heights = [15.0, 12.0, 9.0, 6.0];
    scene.piers.iter_mut().zip(heights).for_each(|(pier, height)| pier.height = Some(height));
    let history = History::of(&scene).expect("runs");
    let height = |seat: &codes::SeatDemands| {
        let inputs = seat.demands.iter().flat_map(|demand| &demand.inputs);
        inputs.into_iter().find(|input| input.symbol == "H").map(|input| input.value)
    };
    let seats = codes::of(&history);
    assert_eq!(seats.len(), 10, "both ends of five girders");
    for seat in &seats {
        // An end on an abutment has the pier at the other end.
        let pier = match seat.seat.ledge.end {
            End::Plus => seat.girder.min(3),
            End::Minus => seat.girder.saturating_sub(1),
        };
        assert_eq!(height(seat), Some(heights[pier]), "{:?} of girder {}", seat.seat.ledge.end, seat.girder);
    }
}

#[test]
fn what_follows_from_the_ground_type_that_a_scene_gives_is_not_assumed() {
    let sources = |ground: Option<EuropeanGround>| {
        let mut scene = deck(Initial::default());
        scene.codes.european_ground = ground;
        let history = History::of(&scene).expect("runs");
        let seat = codes::of(&history).into_iter().next().expect("a seat");
        let demand = seat.demands.into_iter().find(|d| d.inputs.iter().any(|i| i.symbol == "L_g")).expect("EN 1998-2");
        ["S", "T_C", "T_D", "L_g"].map(|symbol| demand.inputs.iter().find(|i| i.symbol == symbol).map(|i| i.source))
    };
    assert_eq!(sources(None), [Some(Source::Assumed); 4], "no ground type");
    assert_eq!(sources(Some(EuropeanGround::C)), [Some(Source::Scene); 4], "ground of type C");
}
