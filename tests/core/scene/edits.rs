//! Edits: what they keep whole, and that undoing gives back the scene as it was.

use girderbench::scene::edit::{Edit, EditError, General, UndoStack, free_name};
use girderbench::scene::keys::Editable as _;
use girderbench::scene::{
    Abutment, BearingKind, Bearings, DeckBearings, Girder, Kind, Motion, PairSettings, PerDirection, Scene, presets,
    validate,
};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};

fn preset(name: &str) -> Scene {
    presets::load(name).unwrap_or_else(|errors| panic!("{errors}"))
}

fn pair(a: &str, b: &str) -> PairSettings {
    let between = [a.to_owned(), b.to_owned()];
    PairSettings { between, restitution_normal: Some(0.5), ..PairSettings::default() }
}

/// A full-scale deck between two abutments, with numbers of their own for one pair.
fn deck() -> Scene {
    let mut scene = preset("deck-30m");
    scene.contact.pairs.push(pair("deck", "west"));
    scene
}

#[test]
fn removing_a_girder_takes_along_what_refers_to_it_as_one_step() {
    let before = deck();
    let (mut scene, mut steps) = (before.clone(), UndoStack::default());
    steps.perform(&mut scene, Edit::RemoveGirder(0), "remove deck").expect("there is a girder");
    assert!(
        scene.girders.is_empty() && scene.abutments.is_empty() && scene.contact.pairs.is_empty(),
        "nothing dangles"
    );
    assert_eq!(steps.depth(), 1, "one step");
    assert_eq!(steps.undo(&mut scene), Ok(true), "undone");
    assert_eq!(scene, before, "all of it is back, in its order");
    assert_eq!((steps.redo(&mut scene), scene.girders.len()), (Ok(true), 0), "and gone again");
}

#[test]
fn removing_an_abutment_takes_along_its_pairs() {
    let before = deck();
    let mut scene = before.clone();
    let back = Edit::RemoveAbutment(1).apply(&mut scene).expect("the west abutment");
    assert_eq!((scene.abutments.len(), scene.contact.pairs.len()), (1, 0), "its pair is gone");
    back.apply(&mut scene).expect("it can come back");
    assert_eq!(scene, before, "all of it is back");
}

#[test]
fn renaming_a_body_renames_every_reference() {
    let mut scene = deck();
    Edit::Rename("deck".into(), "span".into()).apply(&mut scene).expect("a free name");
    assert!(scene.abutments.iter().all(|a| a.faces == "span"), "abutments face it still");
    assert_eq!(scene.contact.pairs[0].between, ["span", "west"], "pairs name it still");
    assert_eq!(validate::validate(&scene), Ok(()), "a sound scene stays sound");
}

#[test]
fn an_edit_that_cannot_be_done_changes_nothing() {
    let before = deck();
    let mut scene = before.clone();
    let refused = [
        Edit::RemoveGirder(1),
        Edit::MoveGirder(9, [0.0; 3], 0.0),
        Edit::AddGirder(3, Box::new(before.girders[0].clone())),
        Edit::AddGirder(0, Box::new(before.girders[0].clone())),
        Edit::RemoveAbutment(2),
        Edit::Rename("deck".into(), "west".into()),
        Edit::Rename("nobody".into(), "somebody".into()),
        Edit::Set("girder.deck.mass_kg=heavy".into()),
        Edit::Batch(vec![
            Edit::Motion(Box::new(Motion::None)),
            Edit::Set("duration_s=3".into()),
            Edit::RemoveGirder(5),
        ]),
    ];
    for edit in refused {
        let error = edit.clone().apply(&mut scene).expect_err("it cannot be done");
        assert!(!error.to_string().is_empty(), "it says why");
        assert_eq!(scene, before, "{edit:?}");
    }
    let missing = Edit::RemoveGirder(1).apply(&mut scene);
    assert_eq!(missing, Err(EditError::Missing { what: "girder", index: 1, count: 1 }), "in numbers");
}

#[test]
fn a_drag_is_one_step() {
    let before = preset("row-of-5");
    let (mut scene, mut steps) = (before.clone(), UndoStack::default());
    for n in 0..1000 {
        let edit = Edit::MoveGirder(1, [f64::from(n), 0.0, 0.0], 0.0);
        steps.drag(&mut scene, edit, "move g2", "g2").expect("it moves");
    }
    assert_eq!((steps.depth(), steps.undo_label()), (1, Some("move g2")), "one step");
    steps.seal();
    steps.drag(&mut scene, Edit::MoveGirder(1, [5.0, 1.0, 0.0], 0.0), "move g2", "g2").expect("it moves");
    steps.drag(&mut scene, Edit::MoveGirder(2, [6.0, 1.0, 0.0], 0.0), "move g3", "g3").expect("it moves");
    assert_eq!(steps.depth(), 3, "letting go, or dragging something else, begins another");
    while steps.undo(&mut scene) == Ok(true) {}
    assert_eq!(scene, before, "all undone");
    assert_eq!(steps.redo_label(), Some("move g2"), "and can be done again");
}

#[test]
fn a_drag_that_is_abandoned_has_never_been() {
    let before = preset("row-of-5");
    let (mut scene, mut steps) = (before.clone(), UndoStack::default());
    steps.perform(&mut scene, Edit::MoveGirder(2, [6.0, 1.0, 0.0], 0.0), "move g3").expect("it moves");
    let earlier = scene.clone();
    assert_eq!(steps.abandon(&mut scene, "g2"), Ok(false), "nothing was dragged yet");
    for n in 0..10 {
        let edit = Edit::MoveGirder(1, [f64::from(n), 0.0, 0.0], 0.0);
        steps.drag(&mut scene, edit, "move g2", "g2").expect("it moves");
    }
    assert_eq!(steps.abandon(&mut scene, "g4"), Ok(false), "another drag is not this one");
    assert_eq!((steps.abandon(&mut scene, "g2"), &scene), (Ok(true), &earlier), "put back");
    assert_eq!((steps.depth(), steps.redo_label()), (1, None), "and neither to be undone nor redone");
    while steps.undo(&mut scene) == Ok(true) {}
    assert_eq!(scene, before, "what was done before can be");
}

#[test]
fn a_drag_of_several_things_at_once_is_one_step_and_stays_small() {
    let before = deck();
    let (mut scene, mut steps) = (before.clone(), UndoStack::default());
    for n in 0..100_000 {
        let wall = Abutment { depth: Some(f64::from(n) + 1.0), ..scene.abutments[0].clone() };
        let both = vec![Edit::MoveGirder(0, [f64::from(n), 0.0, 0.0], 0.0), Edit::ReplaceAbutment(0, Box::new(wall))];
        steps.drag(&mut scene, Edit::Batch(both), "move", "both").expect("they move");
    }
    assert!(format!("{steps:?}").len() < 20_000, "what a later event would undo again is not kept");
    assert_eq!(steps.undo(&mut scene), Ok(true), "one step");
    assert_eq!(scene, before, "all undone");
}

#[test]
fn a_slider_that_sets_by_path_is_one_step() {
    let before = preset("skew45-abutment");
    let (mut scene, mut steps) = (before.clone(), UndoStack::default());
    for skew in 30..60 {
        let edit = Edit::Set(format!("girder.deck.skew_deg={skew}"));
        steps.drag(&mut scene, edit, "skew", "skew").expect("a skew");
    }
    assert_eq!((scene.girders[0].skew_deg, steps.depth()), (59.0, 1), "one step");
    assert_eq!((steps.undo(&mut scene), &scene), (Ok(true), &before), "undone");
}

#[test]
fn a_new_edit_forgets_what_was_undone() {
    let (mut scene, mut steps) = (preset("row-of-5"), UndoStack::default());
    steps.perform(&mut scene, Edit::RemoveGirder(4), "remove").expect("five girders");
    assert_eq!(steps.undo(&mut scene), Ok(true), "undone");
    steps.perform(&mut scene, Edit::Motion(Box::new(Motion::None)), "still").expect("any time");
    assert_eq!((steps.redo(&mut scene), steps.redo_label()), (Ok(false), None), "nothing to redo");
}

#[test]
fn a_free_name_is_free() {
    let scene = preset("row-of-5");
    assert_eq!(free_name(&scene, "deck"), "deck", "free as it is");
    assert_eq!(free_name(&scene, "g1"), "g12", "the stem and the first free number");
}

/// Any edit, most of them possible in a scene of a few bodies.
fn any_edit() -> impl Strategy<Value = Edit> {
    let (row, deck) = (preset("row-of-5"), deck());
    let names = prop::sample::select(vec!["deck", "east", "west", "g1", "g2", "new", "other"]);
    let wall = deck.abutments[0].clone();
    let girder =
        (prop::sample::select(row.girders.clone()), names.clone(), -50.0..50.0_f64).prop_map(|(mut g, name, x)| {
            name.clone_into(&mut g.name);
            g.position[0] = x;
            Box::new(g)
        });
    let abutment = (names.clone(), names.clone(), 0.0..1.0_f64).prop_map(move |(name, faces, gap)| {
        Box::new(Abutment { name: name.to_owned(), faces: faces.to_owned(), gap: Some(gap), ..wall.clone() })
    });
    let settings = vec![
        "girder.deck.skew_deg=70",
        "contact.mu_static=0.5",
        "motion.kind=none",
        "motion.scale=2",
        "girder.0.seat_m.+x=1",
    ];
    let contact = deck.contact.clone();
    prop_oneof![
        (0..4_usize, girder.clone()).prop_map(|(at, girder)| Edit::AddGirder(at, girder)),
        (0..4_usize).prop_map(Edit::RemoveGirder),
        (0..3_usize, girder).prop_map(|(at, girder)| Edit::ReplaceGirder(at, girder)),
        (0..4_usize, prop::array::uniform3(-9.0..9.0_f64), 0.0..360.0_f64)
            .prop_map(|(at, to, turn)| Edit::MoveGirder(at, to, turn)),
        (0..4_usize, abutment.clone()).prop_map(|(at, abutment)| Edit::AddAbutment(at, abutment)),
        (0..4_usize).prop_map(Edit::RemoveAbutment),
        (0..3_usize, abutment).prop_map(|(at, abutment)| Edit::ReplaceAbutment(at, abutment)),
        (names.clone(), names.clone()).prop_map(|(from, to)| Edit::Rename(from.to_owned(), to.to_owned())),
        (names.clone(), names).prop_map(move |(a, b)| {
            let mut contact = contact.clone();
            contact.pairs.push(pair(a, b));
            Edit::Contact(Box::new(contact))
        }),
        Just(Edit::General(Box::new(General { kind: Kind::Planar, duration: 3.0, ..General::of(&deck) }))),
        prop::sample::select(settings).prop_map(|setting| Edit::Set(setting.to_owned())),
        Just(Edit::Scene(Box::new(row))),
    ]
}

proptest! {
    #![proptest_config(Config { cases: 300, rng_seed: RngSeed::Fixed(0x6769_7264), failure_persistence: None, ..Config::default() })]

    #[test]
    fn undoing_any_edits_gives_back_the_first_scene_and_redoing_the_last(
        edits in prop::collection::vec((any_edit(), prop::option::of(0..2_u8)), 1..20),
    ) {
        let before = deck();
        let (mut scene, mut steps) = (before.clone(), UndoStack::default());
        let mut done = 0;
        for (edit, drag) in edits {
            let as_it_was = scene.clone();
            let result = match drag {
                None => steps.perform(&mut scene, edit, "edit"),
                Some(key) => steps.drag(&mut scene, edit, "drag", &key.to_string()),
            };
            done += usize::from(result.is_ok());
            prop_assert!(result.is_ok() || scene == as_it_was, "a refused edit changes nothing");
        }
        prop_assert!(steps.depth() <= done, "a drag joins, nothing is invented");
        let after = scene.clone();
        while steps.undo(&mut scene).map_err(|error| TestCaseError::fail(error.to_string()))? {}
        prop_assert_eq!(&scene, &before, "all undone");
        while steps.redo(&mut scene).map_err(|error| TestCaseError::fail(error.to_string()))? {}
        prop_assert_eq!(&scene, &after, "all done again");
    }
}

/// What a second girder is after a change to the first that goes to both.
fn alike(scene: &Scene, change: impl Fn(&mut Girder)) -> [Girder; 2] {
    let (old, mut other) = (&scene.girders[0], scene.girders[1].clone());
    let mut new = old.clone();
    change(&mut new);
    other.carry(old, &new);
    [new, other]
}

#[test]
fn a_number_that_goes_to_several_girders_takes_no_other_along() {
    let twin = preset("twin-span-restrained");
    let damped = |girder: &mut Girder| match &mut girder.bearings {
        Some(Bearings::Deck(deck)) => deck.damping_ratio = Some(0.03),
        other => panic!("{other:?}"),
    };
    let mut wanted = twin.girders[1].clone();
    damped(&mut wanted);
    assert_eq!(alike(&twin, damped)[1], wanted, "its period stays its own");

    let row = preset("viaduct-5");
    let shared = |girder: &mut Girder| match girder.bearings.clone() {
        Some(Bearings::Shared(shared)) => shared,
        other => panic!("{other:?}"),
    };
    let moved = |girder: &mut Girder| {
        let mut own = shared(girder);
        own.at_skewed.as_mut().or(own.at.as_mut()).expect("places")[1][0] = 13.0;
        own.frequency_hz = PerDirection::Each([3.0, own.frequency_hz.xy()[1]]);
        girder.bearings = Some(Bearings::Shared(own));
    };
    let mut wanted = row.girders[1].clone();
    moved(&mut wanted);
    assert_eq!(alike(&row, moved)[1], wanted, "one coordinate of one bearing, one direction, and its own piers");

    let fewer = |girder: &mut Girder| {
        let mut own = shared(girder);
        own.at.as_mut().or(own.at_skewed.as_mut()).expect("places").pop();
        girder.bearings = Some(Bearings::Shared(own));
    };
    let mut wanted = row.girders[1].clone();
    fewer(&mut wanted);
    assert_eq!(alike(&row, fewer)[1], wanted, "the same places before");
    let mut elsewhere = row.clone();
    moved(&mut elsewhere.girders[1]);
    assert_eq!(alike(&elsewhere, fewer)[1], elsewhere.girders[1], "other places");

    let stands = |girder: &Girder| match girder.bearings.clone().expect("bearings") {
        Bearings::Shared(s) => (s.at, s.at_skewed, s.on_minus_x, s.on_plus_x),
        Bearings::Deck(d) => (d.at, d.at_skewed, d.on_minus_x, d.on_plus_x),
        Bearings::Each(_) => panic!("equal ones"),
    };
    let on_rubber = |girder: &mut Girder| {
        let rubber = Bearings::Deck(DeckBearings::proposed(BearingKind::LeadRubber, Vec::new()));
        girder.bearings = girder.bearings.as_ref().map(|now| rubber.where_stand(now));
    };
    let both = alike(&row, on_rubber);
    for (girder, before) in both.iter().zip(&row.girders) {
        assert!(matches!(girder.bearings, Some(Bearings::Deck(_))), "other bearings");
        assert_eq!(stands(girder), stands(before), "where the others stood");
    }
}
