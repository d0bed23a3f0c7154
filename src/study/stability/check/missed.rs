//! No touch is missed: a node inside a face has a closed contact.

use super::finding::{Check, Complaint, Figures};
use super::looks::early_or_late;
use crate::contact::{Frame, Local, locate};
use crate::scene::Between;
use crate::sim::{EventKind, History};

pub(super) const CLAIM: &str = "no node is deeper than 1e-9 of the face's size behind a face and inside its polygon \
                                without a closed contact, beyond what it moves while events count as one, unless it \
                                went in beside the polygon, left it over its edge, or touches another face; of bodies \
                                with contact between all faces, no overlap is without a contact as deep";

/// Depth without a contact, in parts of the face's size.
const DEPTH: f64 = 1e-9;
/// A node is in front again when it is so far off, in parts of the face's size.
const FRONT: f64 = 1e-12;
/// Rounding of a gap, in parts of how far its two sides have come.
const PLACES: f64 = 16.0 * f64::EPSILON;
/// Rounding of an event's time, in parts of it.
const CLOCK: f64 = 16.0 * f64::EPSILON;

pub(super) fn check(history: &History, times: &[f64], figures: &mut Figures, complaints: &mut Vec<Complaint>) {
    let model = history.model();
    let frames: Vec<Vec<Frame>> =
        times.iter().map(|&t| (0..model.bodies.len()).map(|body| history.frame(body, t)).collect()).collect();
    if history.scene().contact.between == Between::All
        && let Some(overlap) = history.overlaps().first()
    {
        let [one, other] = overlap.bodies.map(|body| body.name(history.scene()));
        let (depth, t) = (overlap.depth.value, overlap.depth.t);
        figures.missed = figures.missed.max(depth);
        let detail = format!("{one} and {other} overlap by {depth:e} m more than a contact carries at t = {t} s");
        return complaints.push(Complaint::new(Check::Missed, detail));
    }
    // Between all faces of two bodies a node may be deep behind one face and in by another: the overlap tells.
    // Of an open edge node only the crossing is anywhere.
    let of_one_face = |&contact: &usize| model.sites[contact].corner.is_none() && model.sites[contact].edge.is_none();
    for contact in (0..model.sites.len()).filter(of_one_face) {
        if let Some((t, depth)) = deepest(history, contact, times, &frames) {
            figures.missed = figures.missed.max(depth);
            let site = &model.sites[contact];
            if depth > DEPTH * site.face.size() {
                let detail = format!("{} is {depth:e} m inside {} at t = {t} s", site.node, site.face_name);
                return complaints.push(Complaint::new(Check::Missed, detail));
            }
        }
    }
}

/// Time at which a contact's node is deepest in its face while open, and that depth \[s, m\].
fn deepest(history: &History, contact: usize, times: &[f64], frames: &[Vec<Frame>]) -> Option<(f64, f64)> {
    let site = &history.model().sites[contact];
    let side = |body: Option<usize>, all: &[Frame]| body.map_or(Frame::fixed(site.fixed), |b| all[b]);
    let size = site.face.size();
    let passed: Vec<f64> =
        history.events().iter().filter(|e| e.site() == contact && passes(e.kind)).map(|e| e.t).collect();
    let (mut ignored, mut next, mut worst) = (false, 0, None::<(f64, f64)>);
    for (i, (&t, all)) in times.iter().zip(frames).enumerate() {
        let (node, face) = (side(site.node_body, all), side(site.face_body, all));
        let here: Local = locate(&site.geometry, &node, &face);
        // Rounding at the crossing, of places or of the clock, makes a node neither before the face nor behind it.
        let moved = node.shift.length() + face.shift.length();
        let front = FRONT * size + PLACES * moved + CLOCK * t * here.gap_rate.abs();
        ignored = (ignored || (i == 0 && here.gap < 0.0)) && here.gap <= front;
        while passed.get(next).is_some_and(|at| *at <= t) {
            (ignored, next) = (here.gap <= front, next + 1);
        }
        // Contacts that open together do so when the first of them does.
        let depth = here.penetration() - early_or_late(history, site.pair, here.gap_rate);
        let inside = depth > 0.0 && here.penetration() < site.face.depth && site.face.inset_at(here.at) > DEPTH * size;
        let open = history.contacts().contact_at(contact, t).is_none();
        if open && inside && !ignored && !elsewhere(history, contact, t) && worst.is_none_or(|(_, d)| depth > d) {
            worst = Some((t, depth));
        }
    }
    worst
}

/// Whether a node is behind its face without touching it from here on.
fn passes(kind: EventKind) -> bool {
    matches!(kind, EventKind::Missed | EventKind::LeftFace)
}

/// Whether the same node touches another face.
fn elsewhere(history: &History, contact: usize, t: f64) -> bool {
    let sites = &history.model().sites;
    let mine = &sites[contact];
    history
        .contacts()
        .at(t)
        .iter()
        .map(|now| &sites[now.contact])
        .any(|s| s.node == mine.node && s.node_body == mine.node_body)
}
