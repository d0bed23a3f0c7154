//! Texts at bodies, gaps and contacts, and the picture's title and time.

use glam::{DVec3, Vec2};

use super::area::Area;
use super::block::{Block, abutment_block};
use super::gap::{Dimension, girder_block_at};
use super::ground_caption::ground_caption;
use super::input::pixel;
use super::labels::{BESIDE, Label, ON, Placer, text_size};
use super::list::{ArrowKind, Mark};
use super::moment::{Moment, period};
use super::palette::Palette;
use super::words::{contact_state, impact_state};
use super::{ViewInput, forces::Forces, scale};
use crate::language::{Text, values};
use crate::sim::History;

/// Height of ordinary text \[points\].
pub(super) const TEXT: f32 = 13.0;
/// Height of the title \[points\].
const TITLE: f32 = 20.0;
/// At most this many contacts carry a number: the hardest.
const MOST_NUMBERS: usize = 4;

/// Keeps glyphs and arrows free of labels.
pub(super) fn keep_clear(input: &ViewInput<'_>, moment: &Moment, forces: &Forces, placer: &mut Placer) {
    let ppp = input.pixels_per_point;
    let points = moment.contacts.iter().map(|c| c.point).chain(moment.opened.iter().map(|o| o.point));
    for at in points.filter_map(|p| pixel(input, p)) {
        placer.take(Area::about(at, Vec2::splat(8.0 * ppp)));
    }
    for arrow in &forces.arrows {
        if let (Some(from), Some(to)) = (pixel(input, arrow.from.as_dvec3()), pixel(input, arrow.to.as_dvec3())) {
            placer.take_stroke(from, to, 4.0 * ppp);
        }
    }
}

/// Title and time at the top left; their area is taken from the labels.
pub(super) fn heading(input: &ViewInput<'_>, moment: &Moment, palette: &Palette, placer: &mut Placer) -> Vec<Mark> {
    let ppp = input.pixels_per_point;
    let left = Vec2::new(18.0, 14.0) * ppp;
    let factor = factors(input);
    let title = one_line(input.title.unwrap_or(&input.scene.name));
    let rows = [
        (title, TITLE, palette.ink, 0.0),
        (time_stamp(input, moment), 15.0, palette.ink, 29.0),
        (ground_caption(input.scene), TEXT, palette.faint_ink, 51.0),
        (factor, TEXT, palette.ink, 70.0),
    ];
    rows.into_iter()
        .filter(|(text, ..)| !text.is_empty())
        .map(|(text, size, color, down)| {
            let at = left + Vec2::new(0.0, down * ppp);
            placer.take(Area { min: at, max: at + text_size(&text, size * ppp) });
            let plate = Some(palette.plate.with_alpha(0x90));
            Mark::Text { at, align: Vec2::ZERO, size: size * ppp, text, color, plate }
        })
        .collect()
}

/// Text of the magnification factors.
fn factors(input: &ViewInput<'_>) -> String {
    let one_digit = |factor: f64| (factor * 10.0).round() / 10.0;
    let motion = (input.exaggeration != 1.0 && input.exaggeration.is_finite())
        .then(|| Text::new("view-motion-times").with(&values!["factor" => one_digit(input.exaggeration).to_string()]));
    let bends = |history: &History| {
        (0..history.scene().girders.len()).any(|girder| history.sections().flexible(girder).is_some())
    };
    let bent = input.bent.filter(|_| input.history.is_some_and(bends));
    let deformation =
        bent.map(|bent| Text::new("view-bent-times").with(&values!["factor" => one_digit(bent.factor).to_string()]));
    motion.into_iter().chain(deformation).collect::<Vec<_>>().join(", ")
}

/// A text without line breaks and other control characters, which no glyph shows: spaces in their place.
fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

/// `t = 1.2500 s   3.250 periods`.
fn time_stamp(input: &ViewInput<'_>, moment: &Moment) -> String {
    let Some(t) = moment.t else { return Text::new("view-as-placed").into() };
    let stamp = format!("{t:.4}");
    match period(input.scene) {
        Some(period) => {
            let values = values!["t" => stamp, "periods" => format!("{:.3}", t / period)];
            Text::new("view-time-periods").with(&values)
        }
        None => Text::new("view-time").with(&values!["t" => stamp]),
    }
}

/// The middle of a block's upper side \[m\].
fn top_of(block: &Block) -> DVec3 {
    let corners = block.corners();
    let highest = corners.iter().map(|p| p.z).fold(f64::NEG_INFINITY, f64::max);
    let middle = corners.iter().sum::<DVec3>() / 8.0;
    middle.with_z(highest)
}

/// Least distance of a name from the edge of the picture \[points\].
const MARGIN: f32 = 30.0;
/// In scenes of more bodies those out of the picture have no name: seeking places for a long row would hold up a frame. Chosen.
const MOST_SOUGHT: usize = 16;
/// Cells of an upper side along and across, whose middles are looked for in the picture.
const TRIED: u32 = 64;

/// Place of a name on a block \[pixels\]: the middle of its upper side, or where that is out of the picture the middle of its visible part.
fn name_place(input: &ViewInput<'_>, block: &Block) -> Option<Vec2> {
    let middle = top_of(block);
    let margin = Vec2::splat(MARGIN * input.pixels_per_point);
    let size = Vec2::from(input.size.map(|side| side as f32));
    let within = |at: &Vec2| at.cmpge(margin).all() && at.cmple(size - margin).all();
    let wanted = pixel(input, middle);
    let bodies = input.scene.girders.len() + input.scene.abutments.len() + input.scene.piers.len();
    if wanted.as_ref().is_some_and(within) || bodies > MOST_SOUGHT {
        return wanted;
    }
    let mut upper = block.corners();
    upper.sort_by(|a, b| b.z.total_cmp(&a.z));
    // Around the side, so that the first two and the last two bound edges that face each other.
    let upper = &mut upper[..4];
    upper.sort_by(|a, b| (a.y - middle.y).atan2(a.x - middle.x).total_cmp(&(b.y - middle.y).atan2(b.x - middle.x)));
    let [a, b, c, d] = [upper[0], upper[1], upper[2], upper[3]];
    let part = |i: u32| (f64::from(i) + 0.5) / f64::from(TRIED);
    let across = |i: u32| (a.lerp(b, part(i)), d.lerp(c, part(i)));
    let tried = (0..TRIED).map(across).flat_map(|(from, to)| (0..TRIED).map(move |i| from.lerp(to, part(i))));
    let seen = tried.filter_map(|place| pixel(input, place)).filter(within);
    let (sum, count) = seen.fold((Vec2::ZERO, 0.0), |(sum, count), at| (sum + at, count + 1.0));
    if count > 0.0 { Some(sum / count) } else { wanted }
}

/// A girder's name, with its state under the impact model: `deck · c: contact, sliding and turning`.
fn with_state(name: &str, moment: &Moment, girder: usize) -> String {
    match moment.states.get(girder) {
        Some(state) => format!("{name} · {}: {}", state.letter(), impact_state(*state)),
        None => name.to_owned(),
    }
}

/// Names of girders and abutments, on their upper sides.
pub(super) fn names(input: &ViewInput<'_>, moment: &Moment, palette: &Palette, placer: &mut Placer) -> Vec<Mark> {
    let girders = input.scene.girders.iter().enumerate();
    let girders =
        girders.filter_map(|(i, g)| Some((with_state(&g.name, moment, i), girder_block_at(input.scene, moment, i)?)));
    let walls = input.scene.abutments.iter().filter_map(|a| Some((a.name.clone(), abutment_block(input.scene, a)?)));
    let piers = input.scene.piers.iter().zip(&moment.piers).map(|(pier, now)| (pier.name.clone(), now.cap()));
    let size = TEXT * input.pixels_per_point;
    girders
        .chain(walls)
        .chain(piers)
        .filter_map(|(name, block)| {
            let at = name_place(input, &block)?;
            let text = one_line(&name);
            let (color, plate) = (palette.ink, palette.plate.with_alpha(0xa8));
            Some(placer.place(&Label {
                at,
                clear: 8.0 * input.pixels_per_point,
                text,
                size,
                color,
                plate,
                directions: ON.to_vec(),
            }))
        })
        .flatten()
        .collect()
}

/// With more gaps than this, those that have a text are the least, the largest and those of selected bodies. Chosen: more values than these
/// are not read in a picture, and leave no room for names.
const MANY_GAPS: usize = 8;

/// The gaps with a text.
fn told<'a>(input: &ViewInput<'_>, dimensions: &'a [Dimension]) -> Vec<&'a Dimension> {
    if dimensions.len() <= MANY_GAPS {
        return dimensions.iter().collect();
    }
    let gaps = || dimensions.iter().map(|d| d.gap).enumerate();
    let least = gaps().min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i);
    let largest = gaps().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i);
    let told = |(i, d): &(usize, &Dimension)| least == Some(*i) || largest == Some(*i) || d.is_selected(input);
    dimensions.iter().enumerate().filter(told).map(|(_, d)| d).collect()
}

/// The values of the gaps.
pub(super) fn gap_values(
    input: &ViewInput<'_>,
    dimensions: &[Dimension],
    palette: &Palette,
    placer: &mut Placer,
) -> Vec<Mark> {
    let ppp = input.pixels_per_point;
    let label = |d: &Dimension| {
        let text = d.words(input);
        let (color, plate) = (palette.ink, palette.plate);
        let at = pixel(input, d.ends[0])?;
        Some(Label { at, clear: 5.0 * ppp, text, size: TEXT * ppp, color, plate, directions: BESIDE.to_vec() })
    };
    for d in dimensions {
        if let [Some(from), Some(to)] = d.ends.map(|end| pixel(input, end)) {
            placer.take_stroke(from, to, 4.0 * ppp);
        }
    }
    told(input, dimensions).into_iter().filter_map(label).flat_map(|l| placer.place(&l)).collect()
}

/// The force at the hardest contacts, all of it, beside the tip of the arrow or the contact; where the arrow, without
/// dashpots, is another, that is said too.
pub(super) fn force_values(
    input: &ViewInput<'_>,
    moment: &Moment,
    forces: &Forces,
    palette: &Palette,
    placer: &mut Placer,
) -> Vec<Mark> {
    let ppp = input.pixels_per_point;
    let mut hardest: Vec<_> = moment.contacts.iter().collect();
    hardest.sort_by(|a, b| b.force.length().total_cmp(&a.force.length()));
    let label = |c: &&crate::sim::ContactNow| {
        let tip = forces.arrows.iter().find(|a| a.contact == c.contact && a.kind == ArrowKind::Resultant);
        let node = pixel(input, c.point)?;
        let at = tip.and_then(|a| pixel(input, a.to.as_dvec3())).unwrap_or(node);
        // Beyond the tip, else beside it.
        let beyond = (at - node).try_normalize();
        let directions = beyond.into_iter().chain(BESIDE.iter().copied()).collect();
        let [whole, without] = [c.force, c.elastic_force()].map(|force| scale::force(force.length()));
        let aside = || Text::new("view-without-dashpots").with(&values!["force" => without.as_str()]);
        let aside = if whole == without { String::new() } else { aside() };
        let text = format!("{whole}, {}{aside}", contact_state(c.state));
        let (color, plate) = (palette.ink, palette.plate);
        Some(Label { at, clear: 6.0 * ppp, text, size: TEXT * ppp, color, plate, directions })
    };
    hardest.iter().take(MOST_NUMBERS).filter_map(label).flat_map(|l| placer.place(&l)).collect()
}
