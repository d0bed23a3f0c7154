//! Nodes of a vertex, where parts of stiffness and energy are known by hand.

use super::*;
use crate::dynamics::contact_model::example::AtEvent;
use crate::dynamics::contact_model::transitions::Transitions;
use crate::dynamics::penalty3d::due::Reason;
use crate::dynamics::penalty3d::example::{STIFFNESS, closed, row, stick};
use crate::scene::Between;

/// Penetration and stretch \[m\].
const DEPTH: f64 = 1e-3;
const STRETCH: f64 = 2e-4;

/// The corner of the first girder and that of the second at the vertex on the side of +y.
fn at_vertex(event: &AtEvent) -> [usize; 2] {
    [Some(0), Some(1)].map(|body| {
        let is_there = |&c: &usize| event.world.site(c).node_body == body && event.world.site(c).point.y > 0.0;
        (0..event.world.contacts.len()).find(is_there).expect("a corner")
    })
}

/// Two girders end to end with edge on edge, the first pressed in and moving along the end of the second at this speed; its corner
/// on the side of +y is closed in stick, stretched against +y, as one of the nodes that share K.
fn edge_on_edge(between: Between, speed: f64) -> AtEvent {
    let mut scene = row();
    scene.contact.between = between;
    let (model, active) = closed(&scene, stick);
    let mut event = AtEvent::of(model, &[], &[[DEPTH, 0.0, 0.0, 0.0, speed, 0.0], [0.0; 6]]);
    let [leaving, _] = at_vertex(&event);
    let contact = active.iter().find(|a| a.site == event.world.contacts[leaving].site).expect("over its face");
    let along = event.world.site(leaving).geometry.axes.x_axis.y;
    let anchor = DVec2::X * (-STRETCH * along);
    let closed = ClosedContact { mode: Mode::Stick { anchor }, ..contact.closed };
    let track = &mut event.world.contacts[leaving];
    (track.state, track.divisor, track.has_part) = (Contact::Closed(closed), STIFFNESS / closed.law.k_t, true);
    event.world.pairs[0].sharers = active.len();
    event
}

/// Energy of a spring of a part of K \[J\].
fn energy(divisor: f64) -> f64 {
    0.5 * STIFFNESS / divisor * (DEPTH * DEPTH + STRETCH * STRETCH)
}

/// Tangential force of a contact on the first girder along y \[N\].
fn force_on_first(event: &mut AtEvent, contact: usize) -> f64 {
    let closed = event.closed(contact).expect("closed");
    let here = event.states().here(contact);
    let site = event.world.site(contact);
    let sign = if site.node_body == Some(0) { 1.0 } else { -1.0 };
    sign * closed.forces(&here).tangential.x * site.geometry.axes.x_axis.y
}

fn close(got: f64, expected: f64, what: &str) {
    assert!((got - expected).abs() <= 1e-9 * expected.abs(), "{what}: {got} is not {expected}");
}

#[test]
fn a_corner_that_slides_past_another_hands_it_its_spring_with_its_energy() {
    let mut event = edge_on_edge(Between::All, 0.1);
    let [leaving, other] = at_vertex(&event);
    let divisor = event.world.contacts[leaving].divisor;
    let before = force_on_first(&mut event, leaving);
    close(before, -STIFFNESS / divisor * STRETCH, "it pulls the first girder back");
    Transitions { states: &mut event.states() }.change(leaving, Reason::Edge);
    assert_eq!(event.kinds(), [(leaving, EventKind::LeftFace), (other, EventKind::OpenToStick)]);
    assert_eq!(event.world.contacts[leaving].state, Contact::Open { armed: false });
    close(event.events[0].released, energy(divisor), "the energy of the one that leaves");
    close(event.events[1].released, -energy(divisor), "is that of the one that takes over");
    assert_eq!(event.world.contacts[other].divisor, divisor, "with its part of K");
    close(force_on_first(&mut event, other), before, "and its force");
    assert_eq!([leaving, other].map(|c| event.world.contacts[c].has_part), [false, true]);
}

#[test]
fn a_successor_with_a_part_of_its_own_adds_it_at_the_same_energy() {
    let mut event = edge_on_edge(Between::All, 0.1);
    let [leaving, other] = at_vertex(&event);
    let divisor = event.world.contacts[leaving].divisor;
    (event.world.contacts[other].divisor, event.world.contacts[other].has_part) = (divisor, true);
    Transitions { states: &mut event.states() }.change(leaving, Reason::Edge);
    assert_eq!(event.world.contacts[other].divisor, 0.5 * divisor, "both parts");
    close(event.events[1].released, -energy(divisor), "no energy appears");
    // Twice the stiffness at the same energy: deformations are smaller by √2.
    let here = event.states().here(other);
    close(here.penetration(), DEPTH / std::f64::consts::SQRT_2, "penetration");
}

#[test]
fn a_corner_without_a_node_at_its_vertex_hands_its_spring_to_none() {
    // Sliding away from +y the corner of the second girder leaves as well; faces declared to each other keep their nodes.
    for (between, speed) in [(Between::All, -0.1), (Between::Ends, 0.1)] {
        let mut event = edge_on_edge(between, speed);
        let [leaving, other] = at_vertex(&event);
        let state = event.closed(leaving).expect("closed");
        let has_successors = VertexNodes { states: &mut event.states() }.has_successors(leaving, &state);
        assert!(!has_successors, "{between:?} at {speed} m/s");
        Transitions { states: &mut event.states() }.change(leaving, Reason::Edge);
        assert_eq!(event.kinds(), [(leaving, EventKind::LeftFace)], "{between:?} at {speed} m/s");
        assert!(!event.world.is_closed(other));
    }
}

#[test]
fn an_open_corner_is_held_by_the_closed_one_at_its_vertex() {
    for (between, held) in [(Between::All, true), (Between::Ends, false)] {
        let mut event = edge_on_edge(between, 0.1);
        let [_, other] = at_vertex(&event);
        assert_eq!(VertexNodes { states: &mut event.states() }.is_held(other), held, "{between:?}");
    }
    let mut event = edge_on_edge(Between::All, 0.1);
    let [leaving, other] = at_vertex(&event);
    event.world.contacts[leaving].state = Contact::Open { armed: true };
    assert!(!VertexNodes { states: &mut event.states() }.is_held(other), "by a closed one only");
}

#[test]
fn nodes_of_a_vertex_together_have_the_energy_of_those_before_them() {
    let mut event = edge_on_edge(Between::All, 0.1);
    let [leaving, _] = at_vertex(&event);
    let (state, divisor) = (event.closed(leaving).expect("closed"), event.world.contacts[leaving].divisor);
    for count in [1.0, 2.0, 5.0] {
        let carried = VertexNodes { states: &mut event.states() }.carried(&[(leaving, state)], count / divisor);
        let together = 0.5 * count * STIFFNESS / divisor * (carried.depth.powi(2) + carried.stretch.powi(2));
        close(together, energy(divisor), "of all nodes");
        close(carried.depth / carried.stretch, DEPTH / STRETCH, "in the same proportion");
    }
}
