//! A number that can be typed or dragged, in a row of a two-column grid.

use std::cell::RefCell;

use egui::{DragValue, Id, Response, Ui, vec2};

use super::entry::{Done, Field};
use super::frame::{self, Own, SIGN, complain, reset_sign};
use super::parse::{self, read};
use super::place::{CLICK, Change, Named, Place, change};
use crate::app::style::theme::Palette;
use crate::app::text;
use crate::app::unit::Unit;
use crate::scene::keys::Key;

/// Width of a number with the sign behind it \[points\].
const WIDTH: f32 = 96.0;

/// A number that the scene always has.
pub(in crate::app) fn number(
    ui: &mut Ui,
    place: Place<'_>,
    names: Named<'_>,
    value: &mut f64,
    unit: Unit,
) -> Option<Change> {
    let field = Field::new(ui, place, names, unit);
    let default = field.known.and_then(Key::number);
    let own = Own { words: default.map(|v| unit.words(v)), differs: default.is_some_and(|v| v != *value) };
    match field.row(ui, *value, &own, true)? {
        Done::Set(new, change) => {
            *value = new;
            Some(change)
        }
        Done::Reset => {
            *value = default?;
            CLICK
        }
    }
}

/// A number that the scene may have; without it, it is `reckoned`.
pub(in crate::app) fn optional(
    ui: &mut Ui,
    place: Place<'_>,
    names: Named<'_>,
    (value, reckoned): (&mut Option<f64>, f64),
    unit: Unit,
) -> Option<Change> {
    let field = Field::new(ui, place, names, unit);
    let own = Own { words: Some(unit.words(reckoned)), differs: value.is_some() };
    field.option(ui, (value, reckoned), &own)
}

/// A number that an entry may have instead of what it is laid over; without it, it is `under`.
pub(in crate::app) fn laid_over(
    ui: &mut Ui,
    place: Place<'_>,
    names: Named<'_>,
    (value, under): (&mut Option<f64>, f64),
    unit: Unit,
) -> Option<Change> {
    let field = Field::new(ui, place, names, unit);
    // What it would be without its own is known only where it has none.
    let words = if value.is_some() { text::THE_SCENES.to_string() } else { unit.words(under) };
    let own = Own { words: Some(words), differs: value.is_some() };
    field.option(ui, (value, under), &own)
}

/// A number that the scene may have: a box switches it on, and then it begins with `first`.
pub(in crate::app) fn switched(
    ui: &mut Ui,
    place: Place<'_>,
    names: Named<'_>,
    (value, first): (&mut Option<f64>, f64),
    unit: Unit,
) -> Option<Change> {
    let field = Field::new(ui, place, names, unit);
    let mut on = value.is_some();
    let name = frame::named(ui, place, names);
    let switch = ui.checkbox(&mut on, name);
    if frame::tag(ui, &switch, place, names).changed() {
        *value = on.then_some(first);
        ui.end_row();
        return CLICK;
    }
    let Some(number) = value else {
        ui.end_row();
        return None;
    };
    match field.behind(ui, switch.id, *number, &Own { words: None, differs: false }, true)? {
        Done::Set(new, change) => {
            *number = new;
            Some(change)
        }
        Done::Reset => None,
    }
}

/// Text typed into a field: a number in its unit, nothing at all, or something else, with the fault.
pub(super) type Typed = RefCell<Option<Result<Option<f64>, String>>>;

/// Reads what is typed and keeps it, also where it is no number.
pub(super) fn reader(typed: &Typed, unit: Unit) -> impl Fn(&str) -> Option<f64> + '_ {
    move |text| {
        let read = parse::read(text, unit);
        let number = read.clone().ok().flatten();
        *typed.borrow_mut() = Some(read);
        number
    }
}

impl Field<'_> {
    fn option(&self, ui: &mut Ui, (value, without): (&mut Option<f64>, f64), own: &Own) -> Option<Change> {
        match self.row(ui, value.unwrap_or(without), own, value.is_some())? {
            Done::Set(new, change) => {
                *value = Some(new);
                Some(change)
            }
            Done::Reset => {
                *value = None;
                CLICK
            }
        }
    }

    /// The row; `given` numbers are written plainly, reckoned ones quietly.
    fn row(&self, ui: &mut Ui, value: f64, own: &Own, given: bool) -> Option<Done> {
        let name = ui.label(frame::named(ui, self.place, self.names)).id;
        self.behind(ui, name, value, own, given)
    }

    /// The row behind its name.
    fn behind(&self, ui: &mut Ui, name: Id, value: f64, own: &Own, given: bool) -> Option<Done> {
        let (done, refusal) = ui
            .horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 2.0;
                let (response, shown, typed) = self.drag(ui, value, given);
                let response = response.labelled_by(name);
                if ui.data_mut(|data| data.remove_temp::<()>(awaited())).is_some() {
                    let led_to = (response.id, ui.cumulative_pass_nr());
                    ui.data_mut(|data| data.insert_temp(awaited(), led_to));
                    ui.request_repaint();
                }
                let menu = frame::menu(&response, own);
                let sign = reset_sign(ui, self.names.label, own.words.as_deref().filter(|_| own.differs));
                let done =
                    if menu || sign { Some(Done::Reset) } else { self.done(ui, &response, (value, shown), own, typed) };
                (done, refusal(ui, self.refused()))
            })
            .inner;
        ui.end_row();
        for words in refusal.into_iter().chain(self.place.complaint(self.names.key)) {
            complain(ui, &words);
            ui.end_row();
        }
        done
    }

    /// Under what a refusal is remembered; a slider and its number are two widgets, of which one or the other answers.
    pub(super) fn refused(&self) -> Id {
        self.scope.with(("refused", self.place.path(self.names.key), self.names.label))
    }

    fn drag(&self, ui: &mut Ui, value: f64, given: bool) -> (Response, f64, Typed) {
        // A number selects its digits where it has the keyboard before it is shown.
        let frame = ui.cumulative_pass_nr();
        let led_to = ui.data(|data| data.get_temp::<(Id, u64)>(awaited()));
        if let Some((id, _)) = led_to.filter(|(_, known)| *known < frame) {
            ui.data_mut(|data| data.remove::<(Id, u64)>(awaited()));
            ui.memory_mut(|memory| memory.request_focus(id));
        }
        let (unit, typed) = (self.unit, Typed::default());
        let mut shown = value * unit.factor;
        // A part of a part is dragged by parts of itself.
        let speed = if unit.decimals > 6 { (shown.abs() * 0.02).max(1e-15) } else { unit.speed };
        let drag = DragValue::new(&mut shown)
            .speed(speed)
            .suffix(unit.suffix)
            .max_decimals(unit.decimals)
            .custom_formatter(|v, _| unit.written(v))
            .custom_parser(reader(&typed, unit))
            .clamp_existing_to_range(false)
            .update_while_editing(false);
        let response = ui
            .scope(|ui| {
                if !given {
                    ui.visuals_mut().override_text_color = Some(Palette::of(ui).weak);
                }
                ui.add_sized(vec2(WIDTH - SIGN - 2.0, 20.0), drag)
            })
            .inner;
        (response, shown, typed)
    }

    /// Entry by the hand: typed numbers are taken as they are, and complained about; a drag stops at the limit.
    pub(super) fn done(
        &self,
        ui: &Ui,
        response: &Response,
        (before, shown): (f64, f64),
        own: &Own,
        typed: Typed,
    ) -> Option<Done> {
        let taken = change(ui, response);
        let path = self.place.path(self.names.key);
        frame::say(ui, response, &path, self.names.label, || self.hint(own));
        let wanted = shown / self.unit.factor;
        match typed.into_inner() {
            Some(Ok(Some(number))) => {
                forget(ui, self.refused());
                // A field that is entered and left has given the digits that it showed, and changes none of those that it did not.
                if read(&self.unit.written(before * self.unit.factor), self.unit) == Ok(Some(number)) {
                    return None;
                }
                let number = decimal(number / self.unit.factor);
                (!same(number, before)).then_some(Done::Set(number, Change { gesture: None }))
            }
            Some(Ok(None)) if own.words.is_some() => own.differs.then_some(Done::Reset),
            Some(Ok(None)) => {
                refuse(ui, self.refused(), text::MUST_BE_GIVEN.to_string());
                None
            }
            Some(Err(why)) => {
                refuse(ui, self.refused(), why);
                None
            }
            None => {
                if response.gained_focus() || taken.is_some() {
                    forget(ui, self.refused());
                }
                let number = self.range().nearest(decimal(wanted), before);
                let moved = wanted.is_finite() && !same(number, before);
                taken.filter(|_| moved).map(|change| Done::Set(number, change))
            }
        }
    }
}

/// Gives the keyboard to the number that is shown next, from the next frame on.
pub(in crate::app) fn focus_next(ui: &Ui) {
    ui.data_mut(|data| data.insert_temp(awaited(), ()));
}

/// Under what it is remembered that a number awaits the keyboard.
fn awaited() -> Id {
    Id::unique("number that awaits the keyboard")
}

/// To 15 significant digits: 700 mm are 0.7 m in the file, not 0.7000000000000001.
fn decimal(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

/// The same but for the rounding of two conversions.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-13 * b.abs()
}

fn refuse(ui: &Ui, id: Id, why: String) {
    ui.data_mut(|d| d.insert_temp(id, why));
}

fn forget(ui: &Ui, id: Id) {
    ui.data_mut(|d| d.remove::<String>(id));
}

/// Why the text that was typed last was not taken.
pub(super) fn refusal(ui: &Ui, id: Id) -> Option<String> {
    ui.data(|d| d.get_temp::<String>(id))
}
