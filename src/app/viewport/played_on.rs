//! The views between two layouts of the window: the same pictures at another time.

use std::sync::Arc;

use egui::PaintCallback;

use crate::app::viewport::picture::{Viewport, listed};
use crate::app::viewport::seen::Seen;

impl Viewport {
    /// Shows the pictures that were laid out last at the time shown now, and gives the callbacks that paint them. None where more than
    /// bodies moves with the time: the camera, what a hand holds, handles, the section of a gap, which are laid out.
    pub(in crate::app) fn play_on(&mut self, seen: &Seen<'_>) -> Option<Vec<PaintCallback>> {
        let sight = &seen.display.sight;
        let moves = self.glide.is_on_its_way() || self.hand.held.is_some() || sight.follow.is_some() || sight.section;
        let (key, list) = self.picture.as_mut().filter(|(key, _)| !moves && key.clear.is_empty())?;
        key.t = seen.t();
        *list = Arc::new(listed(seen, &key.camera, key));
        self.number += 1;
        let mut views = vec![(0, list.clone(), self.number)];
        if let (Some((key, list)), number) = (self.plan.0.as_mut().filter(|_| sight.plan), &mut self.plan.1) {
            key.t = seen.t();
            *list = Arc::new(listed(seen, &key.camera, key));
            *number += 1;
            views.push((1, list.clone(), *number));
        }
        Some(views.into_iter().filter_map(|(place, list, number)| self.panes.moved(place, list, number)).collect())
    }
}
