//! Hundreds of random inputs: nothing panics, and undo brings the first scene back exactly.

use super::harness::{builder, settle, show};
use egui::{Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, TouchPhase, Vec2};
use egui_kittest::Harness;
use girderbench::app::{EditCommand, LeaveCommand, RunCommand, Workbench};
use girderbench::files::SceneSource;
use girderbench::scene::presets;

/// Inputs of one monkey in every run of the tests, and of one that has time.
const INPUTS: [usize; 2] = [800, 10_000];

/// Inputs that arrive between two frames at the most.
const A_FRAME: u64 = 4;

/// Vigna's `SplitMix64`.
struct Random(u64);

impl Random {
    fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        self.roll() % n
    }

    fn one<T: Copy>(&mut self, of: &[T]) -> T {
        let count = u64::try_from(of.len()).expect("small");
        of[usize::try_from(self.below(count)).expect("small")]
    }

    #[expect(clippy::cast_precision_loss, reason = "points on the screen")]
    fn place(&mut self) -> Pos2 {
        egui::pos2(self.below(1296) as f32, self.below(736) as f32)
    }
}

const KEYS: [Key; 34] = [
    Key::Space,
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::Home,
    Key::End,
    Key::Comma,
    Key::Period,
    Key::L,
    Key::M,
    Key::F,
    Key::Num1,
    Key::Num2,
    Key::Num3,
    Key::Num4,
    Key::G,
    Key::B,
    Key::Delete,
    Key::Escape,
    Key::P,
    Key::I,
    Key::O,
    Key::X,
    Key::OpenBracket,
    Key::CloseBracket,
    Key::Tab,
    Key::Enter,
    Key::Z,
    Key::Y,
    Key::D,
    Key::A,
    Key::R,
    Key::F1,
];

const TEXTS: [&str; 10] = ["0", "-1", "12.5 mm", "1e9", "60°", "0.4 g", "nonsense", "1e-300", "45", " "];

const MODIFIERS: [Modifiers; 6] =
    [Modifiers::NONE, Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND, Modifiers::ALT, Modifiers::NONE];

/// One act of a hand: a key, a text, a move, a press, a release, a turn of the wheel.
fn act(harness: &Harness<'_, Workbench>, random: &mut Random, at: &mut Pos2) {
    let modifiers = random.one(&MODIFIERS);
    let button = random.one(&[PointerButton::Primary, PointerButton::Primary, PointerButton::Secondary]);
    match random.below(12) {
        0..=2 => harness.key_press_modifiers(modifiers, random.one(&KEYS)),
        3 => harness.event(Event::Text(random.one(&TEXTS).into())),
        4 => {
            let delta = Vec2::new(0.0, random.one(&[-120.0, -20.0, 20.0, 120.0]));
            let (unit, phase, source) = (MouseWheelUnit::Point, TouchPhase::Move, MouseWheelSource::Wheel);
            harness.event(Event::MouseWheel { unit, delta, modifiers, phase, source });
        }
        5..=7 => {
            *at = random.place();
            harness.event(Event::PointerMoved(*at));
        }
        8 => {
            // A little on: the middle of a drag.
            *at += Vec2::splat(7.0);
            harness.event(Event::PointerMoved(*at));
        }
        9 | 10 => harness.event(Event::PointerButton { pos: *at, button, pressed: true, modifiers }),
        _ => harness.event(Event::PointerButton { pos: *at, button, pressed: false, modifiers }),
    }
}

fn monkey(seed: u64, preset: &str, inputs: usize) {
    let mut first = presets::load(preset).expect("ships");
    // Every input may run the scene anew.
    first.duration = 2.0;
    let mut workbench = Workbench::new(first.clone(), SceneSource::New);
    workbench.replay.runner.set_estimates(false);
    workbench.tasks.set_silent();
    let mut harness = builder([1280.0, 720.0]).build_ui_state(show, workbench);
    settle(&mut harness);
    let mut random = Random(seed);
    let mut at = egui::pos2(640.0, 360.0);
    let mut done = 0;
    while done < inputs {
        let together = usize::try_from(1 + random.below(A_FRAME)).expect("small");
        for _ in 0..together {
            act(&harness, &mut random, &mut at);
        }
        done += together;
        harness.step();
        if harness.state().window.asks() {
            harness.state_mut().apply(LeaveCommand::Stay);
        }
    }
    let mut steps = 0;
    while harness.state().files.document.undo_label().is_some() {
        harness.state_mut().apply(EditCommand::Undo);
        steps += 1;
        assert!(steps < 100_000, "seed {seed}: undo comes to an end");
    }
    assert_eq!(*harness.state().files.document.scene(), first, "seed {seed}: {steps} steps back is the first scene");
    assert!(steps > 5, "seed {seed}: the monkey did something, {steps} steps");
    harness.state_mut().apply(RunCommand::Cancel);
    harness.step();
}

#[test]
fn a_monkey_breaks_nothing_1() {
    monkey(1, presets::OPENING, INPUTS[0]);
}

#[test]
fn a_monkey_breaks_nothing_2() {
    monkey(2, "straight-straight", INPUTS[0]);
}

#[test]
fn a_monkey_breaks_nothing_3() {
    monkey(3, "deck-30m", INPUTS[0]);
}

#[test]
fn a_monkey_breaks_nothing_4() {
    monkey(4, "flush-free-hit", INPUTS[0]);
}

#[test]
#[ignore = "an hour"]
fn monkeys_with_time_break_nothing() {
    let presets = [presets::OPENING, "straight-straight", "deck-30m", "flush-free-hit"];
    for (seed, preset) in (5..).zip(presets) {
        monkey(seed, preset, INPUTS[1]);
    }
}
