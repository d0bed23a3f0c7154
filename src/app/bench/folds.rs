//! Which panels are folded to a strip: as the user said, else as there is room for the view.

use crate::app::command::Pane;
use crate::files::FoldedPanels;

/// Widths that the panels beside the view begin with, their margins with them \[points\].
const WIDTHS: [f32; 3] = [262.0, 282.0, 286.0];

/// Width that is left to the view before panels fold by themselves \[points\].
const VIEW: f32 = 440.0;

/// Width that the view keeps whatever panels the user opens; the one opened last stays \[points\]. Chosen: a girder's name has room.
const LEAST_VIEW: f32 = 220.0;

/// Height of a window below which the plots fold by themselves \[points\].
const LOW: f32 = 480.0;

/// Folded or opened by the user, per panel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::app) struct Folds {
    said: [Option<bool>; 4],
    /// The panel that the user opened last.
    opened: Option<Pane>,
}

/// Which panels are folded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::app) struct Folded([bool; 4]);

impl Folds {
    /// Folds a panel, or opens it.
    pub(super) fn set(&mut self, pane: Pane, folded: bool) {
        self.said[pane as usize] = Some(folded);
        self.opened = (!folded).then_some(pane);
    }

    /// As in an earlier window.
    pub(super) fn as_in(panels: FoldedPanels) -> Self {
        let FoldedPanels { placed, what_if, lesson, plots } = panels;
        Self { said: [placed, what_if, lesson, plots], opened: None }
    }

    /// Initial state of a later window.
    pub(super) fn panels(self) -> FoldedPanels {
        let [placed, what_if, lesson, plots] = self.said;
        FoldedPanels { placed, what_if, lesson, plots }
    }

    /// Folds every panel, or opens all.
    pub(super) fn set_all(&mut self, folded: bool) {
        *self = Self { said: [Some(folded); 4], opened: None };
    }

    /// Which panels are folded in a window of this size \[points\]; `lesson` tells whether one is open. Where the view has too
    /// little room, what is placed goes first, then the sliders, and the lesson stays. What was opened before
    /// yields to what was opened last.
    pub(in crate::app) fn in_window(self, [width, height]: [f32; 2], lesson: bool) -> Folded {
        let there = |pane: Pane| pane != Pane::Lesson || lesson;
        let mut folded = [false, false, false, height < LOW];
        for (own, said) in folded.iter_mut().zip(self.said) {
            *own = said.unwrap_or(*own);
        }
        for pane in [Pane::Placed, Pane::WhatIf, Pane::Lesson] {
            let open = Pane::ALL.into_iter().zip(WIDTHS).filter(|(pane, _)| there(*pane) && !folded[*pane as usize]);
            let taken: f32 = open.map(|(_, width)| width).sum();
            let least = match (self.said[pane as usize], pane) {
                (None, Pane::Placed | Pane::WhatIf) => VIEW,
                // A lesson yields to what is opened beside it alone.
                (None, _) if self.opened.is_none() => 0.0,
                _ => LEAST_VIEW,
            };
            if self.opened != Some(pane) && width - taken < least {
                folded[pane as usize] = true;
            }
        }
        Folded(folded)
    }
}

impl Folded {
    /// Whether a panel is.
    pub(in crate::app) fn has(self, pane: Pane) -> bool {
        self.0[pane as usize]
    }

    /// Whether every panel is.
    pub(in crate::app) fn is_all(self) -> bool {
        self.0 == [true; 4]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_fold_by_themselves_where_the_view_has_no_room() {
        let folds = Folds::default();
        let open = |size, lesson| Pane::ALL.map(|pane| !folds.in_window(size, lesson).has(pane));
        assert_eq!(open([1280.0, 720.0], true), [true; 4], "room for all of them");
        assert_eq!(open([1024.0, 640.0], false), [true; 4], "without a lesson too");
        assert_eq!(open([1024.0, 640.0], true), [false, true, true, true], "the lesson and its sliders stay");
        assert_eq!(
            open([730.0, 400.0], false),
            [false, true, true, false],
            "a small one: 730 less the sliders are 448"
        );
        assert_eq!(open([480.0, 400.0], true), [false, false, true, false], "a very small one");
    }

    #[test]
    fn a_panel_that_is_opened_leaves_room_for_the_view() {
        let mut folds = Folds::default();
        let open = |folds: Folds, lesson| Pane::ALL.map(|pane| !folds.in_window([800.0, 600.0], lesson).has(pane));
        folds.set(Pane::WhatIf, false);
        folds.set(Pane::Placed, false);
        assert_eq!(open(folds, false), [true, true, true, true], "both leave 256 points");
        assert_eq!(open(folds, true), [true, false, true, true], "beside a lesson the one opened last");
        folds.set(Pane::WhatIf, false);
        assert_eq!(open(folds, true), [false, true, true, true], "of the two");
    }

    #[test]
    fn what_the_user_said_stays() {
        let mut folds = Folds::default();
        folds.set(Pane::Placed, false);
        assert!(!folds.in_window([600.0, 640.0], true).has(Pane::Placed), "open, however narrow");
        folds.set(Pane::Plots, true);
        assert!(folds.in_window([2560.0, 1440.0], false).has(Pane::Plots), "folded, however large");
        folds.set_all(false);
        assert!(!folds.in_window([1280.0, 720.0], true).is_all(), "open again");
        folds.set_all(true);
        assert!(folds.in_window([2560.0, 1440.0], false).is_all(), "all of them");
    }

    #[test]
    fn a_later_window_has_the_panels_that_this_one_had() {
        for pane in Pane::ALL {
            let mut folds = Folds::default();
            folds.set(pane, true);
            let later = Folds::as_in(folds.panels()).in_window([2560.0, 1440.0], true);
            assert_eq!(Pane::ALL.map(|other| later.has(other)), Pane::ALL.map(|other| other == pane), "{pane:?} alone");
        }
    }
}
