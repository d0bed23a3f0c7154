//! From a handle and how far it was pulled to the edit, what is read beside the hand, and the lines it snapped to.

use glam::{DVec2, DVec3};

use super::snap::{self, Guide};
use crate::app::command::{Flank, Grip};
use crate::app::{edits, text, unit};
use crate::geometry::End;
use crate::scene::device::{Joint, point_on};
use crate::scene::edit::Edit;
use crate::scene::facing::{self, Side};
use crate::scene::{Abutment, DeviceId, Girder, PerDirection, Pier, Scene, placed};
use crate::view::Target;

/// Least length or width that a handle leaves, as a share of what it was.
const LEAST: f64 = 0.02;

/// A pull, from the scene as it was when the hand closed.
pub(in crate::app) struct Pull<'a> {
    /// The scene then.
    pub(super) scene: &'a Scene,
    pub(super) selected: &'a [Target],
    /// Where the hand was on its plane \[m\].
    pub(super) from: DVec3,
    /// Where it is \[m\].
    pub(super) to: DVec3,
    /// Numbers are rounded to this \[m\].
    pub(super) step: f64,
    /// How near a line must be to be snapped to \[m\]; none at all when 0.
    pub(super) reach: f64,
    /// Numbers typed instead, in the unit of the scene: those that are read beside the hand.
    pub(super) typed: Option<[f64; 2]>,
}

/// Result of a pull.
#[derive(Clone, Debug)]
pub(in crate::app) struct Pulled {
    pub(in crate::app) edit: Edit,
    /// Text beside the hand.
    pub(in crate::app) words: Vec<String>,
    /// Lines that it snapped to.
    pub(in crate::app) guides: Vec<Guide>,
}

impl Pull<'_> {
    /// How far along a direction, rounded \[m\].
    fn along(&self, direction: DVec3) -> f64 {
        unit::rounded((self.to - self.from).dot(direction), self.step)
    }

    /// The number that was typed, or else what the hand pulled it to.
    fn or_typed(&self, pulled: f64) -> f64 {
        self.typed.map_or(pulled, |[number, _]| number)
    }

    /// Whether the hand that pulls is to snap.
    fn snaps(&self) -> bool {
        self.reach > 0.0 && self.typed.is_none()
    }

    fn girder(&self, i: usize) -> Option<(&Girder, DVec3, DVec3)> {
        let girder = self.scene.girders.get(i)?;
        let axes = placed::axes(girder);
        Some((girder, axes.x_axis, axes.y_axis))
    }
}

/// Result of a pull on a handle; `None` when the scene has no such object.
pub(super) fn pulled(grip: Grip, pull: &Pull<'_>) -> Option<Pulled> {
    match grip {
        Grip::Bodies => {
            let way = pull.typed.map_or((pull.to - pull.from).truncate(), DVec2::from);
            bodies(pull, way, |way| {
                format!(
                    "{}   {}",
                    text::dragged(text::SHIFT_X, &text::length(way.x)),
                    text::dragged(text::SHIFT_Y, &text::length(way.y))
                )
            })
        }
        Grip::Along(i) => {
            let (_, x, _) = pull.girder(i)?;
            along(pull, x, text::ALONG.as_str())
        }
        Grip::Across(i) => {
            let (_, _, y) = pull.girder(i)?;
            along(pull, y, text::ACROSS.as_str())
        }
        Grip::Turn(i) => turn(pull, i),
        Grip::Length(i, end) => length(pull, i, end),
        Grip::Width(i, flank) => width(pull, i, flank),
        Grip::Skew(i, end, flank) => skew(pull, i, end, flank),
        Grip::Gap(n) => gap(pull, n),
        Grip::Offset(i) => offset(pull, i),
        Grip::FaceWidth(i, flank) => face_width(pull, i, flank),
        Grip::DevicePoint(id, which) => device_point(pull, id, which),
        Grip::PierHeight(i) => pier_height(pull, i),
        Grip::PierColumn(i) => pier_column(pull, i),
    }
}

fn plain(edit: Edit, words: String) -> Pulled {
    Pulled { edit, words: vec![words], guides: Vec::new() }
}

/// Moves all that is selected one way.
fn along(pull: &Pull<'_>, axis: DVec3, word: &str) -> Option<Pulled> {
    let way = (axis * pull.or_typed(pull.along(axis))).truncate();
    bodies(pull, way, |way| text::dragged(word, &text::exact_length(unit::rounded(way.dot(axis.truncate()), 1e-7))))
}

/// Moves all that is selected; the girder that leads is what snaps.
fn bodies(pull: &Pull<'_>, way: DVec2, say: impl Fn(DVec2) -> String) -> Option<Pulled> {
    let lead = pull.selected.iter().rev().find_map(|t| if let Target::Girder(i) = t { Some(*i) } else { None });
    let rounded = DVec2::new(unit::rounded(way.x, pull.step), unit::rounded(way.y, pull.step));
    let snapped = match lead {
        _ if pull.typed.is_some() => snap::Snapped::free(way),
        Some(i) if pull.reach > 0.0 => {
            let gaps = snap::usual_gaps(pull.scene);
            snap::moved(pull.scene, pull.selected, i, rounded, (pull.reach, &gaps))
        }
        _ => snap::Snapped::free(rounded),
    };
    let way = snapped.way;
    let edits = pull.selected.iter().filter_map(|t| edits::shifted(pull.scene, *t, way.to_array(), 0.0));
    let mut edits: Vec<Edit> = edits.collect();
    let edit = if edits.len() == 1 { edits.pop()? } else { Edit::Batch(edits) };
    let mut words = vec![say(way)];
    words.extend(snapped.words);
    Some(Pulled { edit, words, guides: snapped.guides })
}

fn turn(pull: &Pull<'_>, i: usize) -> Option<Pulled> {
    let (girder, ..) = pull.girder(i)?;
    let middle = DVec3::from(girder.position);
    let angle = |p: DVec3| (p - middle).y.atan2((p - middle).x);
    let way = (angle(pull.to) - angle(pull.from)).to_degrees();
    let free = pull.or_typed(unit::rounded(wrapped(girder.heading_deg + way), 0.1));
    let (heading, to) = if pull.snaps() { snap::heading(pull.scene, i, free) } else { (free, None) };
    let mut words = vec![text::dragged(text::TURNED_TO.as_str(), &format!("{}°", unit::trimmed(heading)))];
    words.extend(to);
    Some(Pulled { edit: Edit::MoveGirder(i, girder.position, heading), words, guides: Vec::new() })
}

/// Between −180° and 180°.
fn wrapped(angle: f64) -> f64 {
    let turned = angle.rem_euclid(360.0);
    if turned > 180.0 { turned - 360.0 } else { turned }
}

fn length(pull: &Pull<'_>, i: usize, end: End) -> Option<Pulled> {
    let (girder, x, _) = pull.girder(i)?;
    let outward = x * end.sign();
    let length = pull.or_typed((girder.length + pull.along(outward)).max(girder.length * LEAST));
    // The other end stays where it is.
    let position = edits::tidy(DVec3::from(girder.position) + outward * ((length - girder.length) / 2.0));
    let new = Girder { length, position, ..edits::stretched(girder, length / girder.length, 1.0, girder.skew_deg) };
    Some(plain(edits::reshaped(pull.scene, i, new), text::dragged(text::LONG.as_str(), &text::exact_length(length))))
}

fn width(pull: &Pull<'_>, i: usize, flank: Flank) -> Option<Pulled> {
    let (girder, _, y) = pull.girder(i)?;
    let width = pull.or_typed((girder.width + 2.0 * pull.along(y * flank.sign())).max(girder.width * LEAST));
    let new = Girder { width, ..edits::stretched(girder, 1.0, width / girder.width, girder.skew_deg) };
    Some(plain(edits::reshaped(pull.scene, i, new), text::dragged(text::WIDE.as_str(), &text::exact_length(width))))
}

fn skew(pull: &Pull<'_>, i: usize, end: End, flank: Flank) -> Option<Pulled> {
    let (girder, x, _) = pull.girder(i)?;
    let half = flank.sign() * girder.width / 2.0;
    // The corner slides along the girder: cot β = (shift of the corner) / (its distance from the axis).
    let shear = girder.prism().shear() + (pull.to - pull.from).dot(x) / half;
    let free = pull.or_typed(unit::rounded(1f64.atan2(shear).to_degrees().clamp(5.0, 175.0), 0.1));
    let (skew, to) = if pull.snaps() { snap::skew(pull.scene, i, free) } else { (free, None) };
    let new = Girder { skew_deg: skew, ..edits::stretched(girder, 1.0, 1.0, skew) };
    let mut words = vec![text::skewed_to(&unit::trimmed(skew), end)];
    words.extend(to);
    Some(Pulled { edit: edits::reshaped(pull.scene, i, new), words, guides: Vec::new() })
}

fn gap(pull: &Pull<'_>, n: usize) -> Option<Pulled> {
    let pair = facing::find(pull.scene).ok()?.into_iter().nth(n)?;
    let Side::Girder(first, end) = pair.first else { return None };
    let (_, x, _) = pull.girder(first)?;
    let outward = x * end.sign();
    let free = pull.or_typed((pair.gap + pull.along(outward)).max(0.0));
    let (gap, to) = if pull.snaps() { snap::gap(pull.scene, n, free, pull.reach) } else { (free, None) };
    let edit = match pair.second {
        Side::Abutment(i) => {
            edits::abutment(i, Abutment { gap: Some(edits::micrometres(gap)), ..pull.scene.abutments.get(i)?.clone() })
        }
        Side::Girder(second, _) => edits::row_shifted(pull.scene, first, second, outward * (gap - pair.gap)),
        Side::Flank(..) | Side::Rear(..) => return None,
    };
    let mut words = vec![text::dragged(text::APART.as_str(), &text::exact_length(gap))];
    words.extend(to);
    Some(Pulled { edit, words, guides: Vec::new() })
}

fn offset(pull: &Pull<'_>, i: usize) -> Option<Pulled> {
    let [a, b, ..] = placed::abutment_face(pull.scene, pull.scene.abutments.get(i)?)?;
    let side = (b - a).normalize_or_zero();
    let far = pull.or_typed(pull.along(side));
    let edit = edits::shifted(pull.scene, Target::Abutment(i), (side * far).truncate().to_array(), 0.0)?;
    Some(plain(edit, text::dragged(text::SIDEWAYS.as_str(), &text::length(far))))
}

fn face_width(pull: &Pull<'_>, i: usize, flank: Flank) -> Option<Pulled> {
    let abutment = pull.scene.abutments.get(i)?;
    let [a, b, ..] = placed::abutment_face(pull.scene, abutment)?;
    let (side, before) = ((b - a).normalize_or_zero(), (b - a).length());
    let width = pull.or_typed((before + 2.0 * pull.along(side * flank.sign())).max(before * LEAST));
    let new = Abutment { width: Some(edits::micrometres(width)), ..abutment.clone() };
    Some(plain(edits::abutment(i, new), text::dragged(text::FACE_WIDE.as_str(), &text::exact_length(width))))
}

/// The foot goes down; where the columns say how stiff the pier is, it becomes softer.
fn pier_height(pull: &Pull<'_>, i: usize) -> Option<Pulled> {
    let before = pull.scene.piers.get(i).map(|_| pull.scene.pier(i).height)?;
    let height = pull.or_typed((before + pull.along(DVec3::NEG_Z)).max(before * LEAST));
    let new = Pier { height: Some(edits::micrometres(height)), ..pull.scene.piers.get(i)?.clone() };
    pier(pull, i, new, text::dragged(text::HIGH.as_str(), &text::exact_length(height)))
}

/// Columns grow along the pier, round ones both ways.
fn pier_column(pull: &Pull<'_>, i: usize) -> Option<Pulled> {
    let old = pull.scene.piers.get(i)?;
    let column = old.column?;
    let [before, across] = column.xy();
    let axis = pull.scene.pier(i).axes.x_axis;
    let side = edits::micrometres(pull.or_typed((before + 2.0 * pull.along(axis)).max(before * LEAST)));
    let column = Some(match column {
        PerDirection::Both(_) => PerDirection::Both(side),
        PerDirection::Each(_) => PerDirection::Each([side, across]),
    });
    pier(pull, i, Pier { column, ..old.clone() }, text::dragged(text::COLUMN.as_str(), &text::exact_length(side)))
}

/// Another pier at this number; its stiffness is read below what was dragged.
fn pier(pull: &Pull<'_>, i: usize, new: Pier, words: String) -> Option<Pulled> {
    let mut changed = pull.scene.clone();
    *changed.piers.get_mut(i)? = new.clone();
    let stiffness = changed.pier(i).stiffness;
    Some(Pulled { edit: edits::pier(i, new), words: vec![words, text::pier_stiffness(stiffness)], guides: Vec::new() })
}

/// A point of a device, over the ground; the girder that it is on may have moved since it was placed, by which its point moves too.
fn device_point(pull: &Pull<'_>, id: DeviceId, which: usize) -> Option<Pulled> {
    let way = pull.typed.map_or((pull.to - pull.from).truncate(), DVec2::from);
    let way = DVec2::new(unit::rounded(way.x, pull.step), unit::rounded(way.y, pull.step));
    let mut device = pull.scene.device(id)?;
    let joint = Joint::of(pull.scene, &device.part().ends())?;
    let to = device.part().ends().to.map(str::to_owned);
    let there = joint.points[which] + way.extend(0.0);
    let ends = device.part_mut().ends_mut();
    if which == 0 {
        let girder = ends.girder.clone();
        *ends.at = edits::tidy(point_on(pull.scene, Some(&girder), there)?.into());
        // The other one stays where it is.
        let other = point_on(pull.scene, to.as_deref(), joint.points[1])?;
        ends.to_at.get_or_insert(edits::tidy(other.into()));
    } else {
        *ends.to_at = Some(edits::tidy(point_on(pull.scene, to.as_deref(), there)?.into()));
    }
    let words =
        [(text::SHIFT_X, way.x), (text::SHIFT_Y, way.y)].map(|(word, way)| text::dragged(word, &text::length(way)));
    Some(plain(edits::device(id, device), words.join("   ")))
}
