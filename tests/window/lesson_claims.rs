//! Every statement of the guided scenes, computed.

use girderbench::app::{Lesson, Try, lessons};
use girderbench::scene::{Scene, format};
use girderbench::sim::{ContactState, EventKind, History};

fn lesson(name: &str) -> &'static Lesson {
    lessons().iter().find(|lesson| lesson.name == name).expect("it is there")
}

/// The run of a lesson's own scene (nothing tried), or of the scene with one thing tried.
fn run(lesson: &Lesson, number: Option<usize>) -> History {
    let mut scene = lesson.scene().expect("a good scene");
    if let Some(number) = number {
        lesson.tries[number].edit().apply(&mut scene).expect("it fits the scene");
    }
    History::of(&scene).expect("it can be run")
}

/// The words that belong to such a run.
fn words(lesson: &Lesson, number: Option<usize>) -> String {
    number.map_or_else(|| lesson.text.join(" "), |number| lesson.tries[number].text.clone())
}

/// Says that these words stand there.
fn says(lesson: &Lesson, number: Option<usize>, phrase: &str) {
    let words = words(lesson, number);
    assert!(words.contains(phrase), "{}, {number:?}: computed \"{phrase}\", written \"{words}\"", lesson.name);
}

/// The lesson's scene and everything to try.
fn each(lesson: &Lesson) -> impl Iterator<Item = Option<usize>> {
    std::iter::once(None).chain((0..lesson.tries.len()).map(Some))
}

fn turn(history: &History) -> String {
    format!("{:.2}°", history.summary().max_rotation.to_degrees())
}

fn keys(set: &Try) -> Vec<&str> {
    set.set.iter().map(|set| set.split('=').next().unwrap_or(set)).collect()
}

#[test]
fn every_lesson_can_be_read_and_tried_in_any_order() {
    assert_eq!(lessons().len(), 8, "all of them are read");
    for lesson in lessons() {
        let scene = lesson.scene().expect("a good scene");
        assert_eq!(scene.name, lesson.name, "called like its file");
        assert!(lesson.at >= 0.0 && lesson.at <= scene.duration, "{} opens within its run", lesson.name);
        assert!(!lesson.text.is_empty() && lesson.tries.len() >= 3, "{} has words and things to try", lesson.name);
        for set in &lesson.tries {
            assert_eq!(keys(set), keys(&lesson.tries[0]), "{}: {} sets what all set", lesson.name, set.words);
            let mut tried = scene.clone();
            set.edit().apply(&mut tried).expect("it fits");
            assert_ne!(tried, scene, "{}: {} does something", lesson.name, set.words);
            assert_eq!(format::read(&format::write(&tried), "tried").expect("good"), tried, "and can be run and saved");
        }
    }
}

#[test]
fn why_a_skewed_deck_turns() {
    let lesson = lesson("skewed-deck");
    for number in each(lesson) {
        says(lesson, number, &turn(&run(lesson, number)));
    }
    // (6) with the deck's own length and width.
    let rule = |scene: &Scene| {
        let deck = &scene.girders[0];
        deck.length * (2.0 * deck.skew_deg.to_radians()).sin() / (2.0 * deck.width)
    };
    says(lesson, None, &format!("Here it is {:.2}", rule(run(lesson, None).scene())));
    says(lesson, Some(1), &format!("gives {:.2}", rule(run(lesson, Some(1)).scene())));
    assert!(rule(run(lesson, Some(0)).scene()).abs() < 1e-12, "a square face's push goes through the middle");
    // The line of a push square to the face, from anywhere on it, passes the middle on one side.
    let scene = lesson.scene().expect("a good scene");
    let deck = &scene.girders[0];
    let beta = deck.skew_deg.to_radians();
    let lever = |y: f64| {
        let along = y / beta.sin();
        let (x, y) = (deck.length / 2.0 + along * beta.cos(), along * beta.sin());
        x * beta.cos() + y * beta.sin()
    };
    let levers = [-0.5, -0.25, 0.0, 0.25, 0.5].map(|share| lever(share * deck.width));
    assert!(levers.iter().all(|lever| *lever > 0.0), "missed wherever it starts: {levers:?}");
}

/// Share of the run's contact time that is spent in stick.
fn stuck(history: &History) -> f64 {
    let summary = history.summary();
    summary.stick_time / (summary.stick_time + summary.slip_time)
}

#[test]
fn stick_and_slip() {
    let lesson = lesson("stick-and-slip");
    let hold = |number| {
        let scene = run(lesson, number).scene().clone();
        scene.contact.mu_static * scene.girders[0].push.force[0]
    };
    let in_g = |number| hold(number) / 2.0 / 9.806_65;
    assert_eq!(run(lesson, None).scene().girders[0].mass, 2.0, "2 kg");
    says(lesson, None, &format!("0.2 × 20 N = {} N", hold(None)));
    says(lesson, None, &format!("or {:.3} g", in_g(None)));
    says(lesson, Some(0), &format!("{:.3} g", in_g(Some(0))));
    says(lesson, Some(2), &format!("hold {} N, enough for {:.3} g", hold(Some(2)), in_g(Some(2))));
    says(lesson, Some(3), &format!("{} N can be held, enough for {:.3} g", hold(Some(3)), in_g(Some(3))));
    for (number, sticks) in [(None, true), (Some(0), false), (Some(1), false), (Some(2), true), (Some(3), false)] {
        let run = run(lesson, number);
        let slipped = run.events().iter().any(|event| event.kind == EventKind::StickToSlip);
        assert_eq!(!slipped, sticks, "{number:?}: slips when more is asked than can be held");
        assert_eq!(stuck(&run) == 1.0, sticks, "{number:?}: sticks all the time or not");
    }
    says(lesson, Some(0), &format!("{:.0} %", 100.0 * stuck(&run(lesson, Some(0)))));
    says(lesson, Some(1), &format!("{:.0} %", 100.0 * stuck(&run(lesson, Some(1)))));
    slips_in_every_cycle(&run(lesson, Some(1)));
}

fn slips_in_every_cycle(history: &History) {
    let slips = |from: f64| {
        let begins = |kind| matches!(kind, EventKind::StickToSlip | EventKind::OpenToSlip);
        history.events().iter().any(|event| begins(event.kind) && (from..from + 0.5).contains(&event.t))
    };
    assert!((0..8).all(|cycle| slips(f64::from(cycle) * 0.5)), "at 2 Hz, in each of 8 cycles");
}

#[test]
fn one_hit_or_two() {
    let lesson = lesson("one-hit-or-two");
    for number in each(lesson) {
        let hits = run(lesson, number).summary().hits;
        let phrase = if number.is_none() { format!("{hits} times") } else { format!("{hits} hits") };
        says(lesson, number, &phrase);
        assert_eq!(hits % 24, 0, "{number:?}: the same in each of the 24 cycles, got {hits}");
    }
    let moves = run(lesson, Some(4)).summary().max_displacement * 1e3;
    says(lesson, Some(4), &format!("{moves:.1} mm"));
    // "Before the ground turns round": both hits of a pair lie within half a cycle.
    let run = run(lesson, Some(0));
    let starts: Vec<f64> =
        run.hits().touches().iter().filter(|t| t.contact == run.hits().touches()[0].contact).map(|t| t.start).collect();
    assert_eq!(starts.len(), 48, "one corner's touches");
    assert!(starts.chunks(2).all(|two| two[1] - two[0] < 0.5 / 2.4), "in quick succession: {:?}", &starts[..4]);
}

#[test]
fn which_way_to_shake() {
    let lesson = lesson("which-way-to-shake");
    for number in each(lesson) {
        says(lesson, number, &turn(&run(lesson, number)));
    }
    says(lesson, Some(0), &format!("{} hits", run(lesson, Some(0)).summary().hits));
    let turned = |number| run(lesson, number).summary().max_rotation;
    assert!(turned(Some(2)) < turned(None) && turned(None) < turned(Some(3)), "less one way, more the other");
}

#[test]
fn what_the_paper_saw() {
    // Beside the preset of its straight girder.
    let lesson = lesson("straight-abutment");
    let own = run(lesson, None);
    says(lesson, None, &format!("{} hits in 24 cycles", own.summary().hits));
    assert_eq!(own.scene().duration * 2.4, 24.0, "cycles");
    for number in 0..lesson.tries.len() {
        says(lesson, Some(number), &turn(&run(lesson, Some(number))));
    }
    let history = run(lesson, Some(0));
    let sideways =
        (0..=20_000).map(|i| history.motion(0, history.end() * f64::from(i) / 20_000.0).displacement.y.abs());
    says(lesson, Some(0), &format!("{:.1} mm", 1e3 * sideways.fold(0.0, f64::max)));
    let turned = |number| run(lesson, Some(number)).summary().max_rotation;
    assert!(turned(4) < turned(3) && turned(4) > 0.5 * turned(3), "less than the 45° deck, not much less");
    assert!(run(lesson, Some(2)).impact().is_some(), "the other model");
}

/// Least that remains of any seat, in whole millimetres as the words say it.
fn seat_left(history: &History) -> String {
    let all = history.seats().of_girder(0);
    let least = all.iter().map(|seat| seat.least().value).fold(f64::INFINITY, f64::min);
    let mm = (1e3 * least).abs();
    if least < 0.0 { format!("{mm:.0} mm beyond the edge") } else { format!("{mm:.0} mm of seat are left") }
}

#[test]
fn what_holds_a_skewed_deck_on_its_seat() {
    let lesson = lesson("skewed-seat");
    for number in each(lesson) {
        let history = run(lesson, number);
        says(lesson, number, &turn(&history));
        says(lesson, number, &seat_left(&history));
        let seats = history.seats().of_girder(0);
        let least = seats.iter().map(girderbench::sim::seats::Seat::least).min_by(|a, b| a.value.total_cmp(&b.value));
        let shown = number.map_or(Some(lesson.at), |number| lesson.tries[number].at);
        let off = shown.zip(least).map(|(at, least)| (at - least.t).abs());
        assert!(off.is_some_and(|off| off < 0.01), "{number:?}: seen when least is left, {off:?} s from it");
    }
    let own = run(lesson, None);
    let seats = own.seats().of_girder(0);
    says(lesson, None, &format!("{:.2} m square", seats[0].ledge.placed()));
    let phases = |history: &History| {
        (0..history.model().links.len()).all(|link| history.connections().link_phases(link).len() <= 1)
    };
    assert!(phases(&own), "cable and keys do nothing yet");
    let hits = |number| run(lesson, number).summary().hits;
    says(lesson, Some(0), &format!("{} hits instead of {}", hits(Some(0)), hits(None)));
    let yields = |number| run(lesson, number).connections().link_phases(0).iter().any(|(_, phase)| phase.branch == 2);
    assert!(yields(Some(0)), "the tight cable yields");
}

/// How long the first hit lasts, pauses of less than a wave's way there and back included \[s\], and the speed at which the girders part
/// over that at which they met.
fn hit(history: &History) -> (f64, f64) {
    let touches = history.hits().touches();
    let (start, pause) = (touches[0].start, 0.0173);
    let end = touches.iter().fold(touches[0].end, |end, t| if t.start < end + pause { end.max(t.end) } else { end });
    let speed = |t: f64| history.motion(0, t).velocity.x - history.motion(1, t).velocity.x;
    (end - start, -speed(end) / speed(0.0))
}

#[test]
fn how_long_a_hit_lasts() {
    let lesson = lesson("how-long-a-hit");
    for number in each(lesson) {
        let history = run(lesson, number);
        let (time, returned) = hit(&history);
        if number != Some(3) {
            says(lesson, number, &format!("{:.1} ms", 1e3 * time));
        }
        says(lesson, number, &format!("{returned:.3} of their speed"));
    }
    let own = run(lesson, None);
    let beam = own.sections().flexible(0).expect("it bends").beam;
    says(lesson, None, &format!("to the far end and back in {:.1} ms", 2e3 * beam.transit_time()));
    let ringing = |number, girder| run(lesson, number).sections().elastic_hit(girder).expect("a hit").ringing / 1e3;
    says(lesson, None, &format!("{:.1} kJ are left ringing in each", ringing(None, 1)));
    says(lesson, Some(3), &format!("{:.1} kJ are left ringing in the long one", ringing(Some(3), 0)));
    assert!(run(lesson, Some(0)).sections().flexible(0).is_none(), "rigid decks");
}

/// Whether a corner begins its touch in stick.
fn sticks_at_first(history: &History) -> bool {
    let first = history.events().first().expect("it hits").kind;
    assert!(matches!(first, EventKind::OpenToStick | EventKind::OpenToSlip), "a beginning: {first:?}");
    first == EventKind::OpenToStick
}

/// Where the arrows lie through a hit: how far inside the outline in stick, how far off the filled cone in slip, as
/// shares of the normal force; without dashpots, as the arrows are drawn.
fn off_the_cone(history: &History) -> (f64, f64) {
    let contact = &history.scene().contact;
    let end = history.end();
    let (mut stick, mut slip) = (0.0_f64, 0.0_f64);
    for state in (0..=20_000).flat_map(|i| history.contacts().at(end * f64::from(i) / 20_000.0)) {
        if state.normal_force < 1e-6 {
            // The arrow has no length.
            continue;
        }
        let tilt = state.tangential_force.length() / state.normal_force;
        match state.state {
            ContactState::Stick => stick = stick.max(tilt - contact.mu_static),
            ContactState::Slip => slip = slip.max((tilt - contact.mu_kinetic).abs()),
            ContactState::Open => {}
        }
    }
    (stick, slip)
}

#[test]
fn the_friction_cone() {
    let lesson = lesson("friction-cone");
    let degrees = |tangent: f64| format!("{:.1}°", tangent.atan().to_degrees());
    for (number, sticks) in [(None, true), (Some(0), false), (Some(1), true), (Some(2), true), (Some(3), false)] {
        let run = run(lesson, number);
        let [x, y, _] = run.scene().girders[0].initial.velocity;
        let mu = run.scene().contact.mu_static;
        assert_eq!(sticks_at_first(&run), sticks, "{number:?}");
        assert_eq!(y / x < mu, sticks, "{number:?}: sticks when it comes in within the cone");
        let (stick, slip) = off_the_cone(&run);
        assert!(stick < 1e-6, "{number:?}: inside the outline while it sticks, {stick}");
        assert!(slip < 1e-6, "{number:?}: on the filled cone while it slips, {slip}");
        if number.is_none() || number == Some(1) {
            says(lesson, number, &degrees(y / x));
            says(lesson, number, &degrees(mu));
        }
    }
    says(lesson, None, &degrees(run(lesson, None).scene().contact.mu_kinetic));
    assert_eq!(lesson.tries[0].words, "Come in at 26.6°", "{}", degrees(0.5));
    assert_eq!(degrees(0.5), "26.6°", "0.25 in 0.5");
    for (number, share) in [(Some(0), 0.0), (Some(2), 1.0), (Some(3), 0.0)] {
        assert_eq!(stuck(&run(lesson, number)), share, "{number:?}: through the whole hit");
    }
    let last = run(lesson, Some(3));
    says(lesson, Some(3), &format!("{:.2} m/s", last.motion(0, last.end()).velocity.y));
}
