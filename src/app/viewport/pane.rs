//! A view's paint callback, the same one for as long as its picture is, and what changes in the picture when it is another one.

use std::sync::Arc;

use egui::{PaintCallback, Rect};

use crate::app::viewport::screen::Screen;
use crate::render::{Region, Regions, changes};
use crate::view::DrawList;

/// The views of a window: the picture, and the plan beside it.
#[derive(Default)]
pub(super) struct Panes([Option<Pane>; 2]);

/// One of them, as it was shown last.
struct Pane {
    screen: Screen,
    callback: PaintCallback,
    /// Regions of the picture that have changed since they were last asked for.
    changed: Option<Regions>,
}

impl Panes {
    /// The callback that shows a picture in a rectangle.
    pub(super) fn callback(&mut self, rect: Rect, screen: Screen) -> PaintCallback {
        let Some(kept) = self.0.get_mut(screen.place) else {
            return egui_wgpu::Callback::new_paint_callback(rect, screen);
        };
        let before = kept.take();
        let pane = match before {
            Some(same) if same.callback.rect == rect && same.screen.is_same(&screen) => same,
            before => {
                let callback = egui_wgpu::Callback::new_paint_callback(rect, screen.clone());
                let mut changed = before.as_ref().and_then(|pane| pane.changed.clone()).unwrap_or_default();
                let comparable = before.filter(|pane| pane.callback.rect == rect && pane.screen.is_drawn_like(&screen));
                match comparable {
                    Some(before) => changed.extend(changes(&before.screen.list, &screen.list).iter()),
                    None => changed.add(Region::whole(screen.size)),
                }
                Pane { screen, callback, changed: Some(changed) }
            }
        };
        kept.insert(pane).callback.clone()
    }

    /// The callback that shows another picture of what moves where a view was shown last.
    pub(super) fn moved(&mut self, place: usize, list: Arc<DrawList>, number: u64) -> Option<PaintCallback> {
        let pane = self.0.get(place)?.as_ref()?;
        let screen = Screen { list, number, moves: true, ..pane.screen.clone() };
        Some(self.callback(pane.callback.rect, screen))
    }

    /// Where pictures have changed since this was last asked \[points\], and what in them \[pixels of theirs\].
    pub(super) fn take_changes(&mut self) -> Vec<(Rect, Regions)> {
        let panes = self.0.iter_mut().flatten();
        panes.filter_map(|pane| Some((pane.callback.rect, pane.changed.take()?))).collect()
    }
}

impl Screen {
    /// Whether it is the same picture, drawn the same way.
    fn is_same(&self, other: &Self) -> bool {
        self.is_drawn_like(other) && Arc::ptr_eq(&self.list, &other.list)
    }

    /// Whether equal lists would be equal pictures.
    fn is_drawn_like(&self, other: &Self) -> bool {
        let how = |screen: &Self| (screen.size, screen.format, screen.place, screen.moves);
        how(self) == how(other)
    }
}
