//! The 3D view as a whole: where it is seen from, what is drawn over it, what the mouse holds, what it is painted on.

use wgpu::TextureFormat;

use crate::app::command::{HandCommand, ViewCommand};
use crate::app::edits::Document;
use crate::app::run::comparison::Pin;
use crate::app::time::replay::Replay;
use crate::app::viewport::display::Display;
use crate::app::viewport::hand::Keyed;
use crate::app::viewport::picture::{Viewport, bounds_of};
use crate::app::viewport::seen::Seen;
use crate::render::AdapterSummary;
use crate::scene::edit::EditError;
use crate::scene::{Scene, ViewPreset};
use crate::sim::OfSection;
use crate::snapshot::{Instant, Shot};
use crate::view::{Background, Camera};

/// Width of a picture for paper: 20 cm at 300 dots an inch \[pixels\].
const PRINT_WIDTH: u32 = 2400;

/// Camera, picture and hand; layers, sight and tool.
pub struct SceneView {
    /// Camera, picture, and what the mouse holds.
    pub viewport: Viewport,
    /// Layers, force scale, sight and tool.
    pub display: Display,
    /// Format that egui draws into.
    format: TextureFormat,
    /// Adapter that draws.
    adapter: Option<AdapterSummary>,
    /// Where to look from once the panels have taken their room.
    aim_next: Option<ViewPreset>,
    /// The camera before a command last turned it.
    before: Option<Camera>,
}

impl SceneView {
    /// As a scene wants to be looked at.
    pub(in crate::app) fn new(scene: &Scene) -> Self {
        Self {
            viewport: Viewport::new(scene.view.camera),
            display: Display::of(scene),
            format: TextureFormat::Rgba8Unorm,
            adapter: None,
            aim_next: None,
            before: None,
        }
    }

    /// Tells which format egui draws into, and with what.
    pub fn set_target(&mut self, format: TextureFormat, adapter: Option<AdapterSummary>) {
        (self.format, self.adapter) = (format, adapter);
    }

    /// Adapter that draws, as a text.
    pub(in crate::app) fn adapter(&self) -> String {
        self.adapter.as_ref().map(AdapterSummary::to_string).unwrap_or_default()
    }

    /// Looks at another scene as it wants to be looked at.
    pub(in crate::app) fn look_as(&mut self, scene: &Scene) {
        self.before = None;
        self.display.take_from(scene);
        self.viewport.want(scene.view.camera);
    }

    /// Goes to a standing place once more when the panels have taken their room.
    pub(in crate::app) fn aim_next(&mut self, preset: ViewPreset) {
        self.aim_next = Some(preset);
    }

    /// The panels have taken their room.
    pub(in crate::app) fn aim(&mut self) {
        if let Some(preset) = self.aim_next.take() {
            self.viewport.want(preset);
        }
    }

    /// The view's own state, and what it is a picture of.
    pub(in crate::app) fn parts<'a>(
        &'a mut self,
        document: &'a Document,
        replay: &'a Replay,
        pins: &'a [Pin],
    ) -> (&'a mut Viewport, Seen<'a>) {
        let seen = Seen {
            scene: document.scene(),
            revision: document.revision(),
            runner: &replay.runner,
            playback: &replay.playback,
            selection: document.selection().all(),
            display: &self.display,
            pins,
            format: self.format,
            is_drawn_by_processor: self.adapter.as_ref().is_some_and(|adapter| adapter.is_cpu),
        };
        (&mut self.viewport, seen)
    }

    /// Does a command about the view of a scene and its answer.
    pub(in crate::app) fn apply(&mut self, command: ViewCommand, document: &Document, replay: &Replay) {
        if matches!(command, ViewCommand::Preset(_) | ViewCommand::Frame | ViewCommand::Look(_)) {
            self.before = self.viewport.camera().copied();
        }
        match command {
            ViewCommand::Preset(preset) => self.viewport.want(preset),
            ViewCommand::Camera(camera) => self.viewport.set_camera(camera),
            ViewCommand::Frame => {
                let (viewport, seen) = self.parts(document, replay, &[]);
                viewport.frame(bounds_of(&seen, seen.selection));
            }
            ViewCommand::Look(look) => {
                let (viewport, seen) = self.parts(document, replay, &[]);
                viewport.look(&seen, look);
            }
            ViewCommand::Back => {
                if let Some(camera) = self.before {
                    self.before = self.viewport.camera().copied();
                    self.viewport.set_camera(camera);
                }
            }
            ViewCommand::Overlays(overlays) => self.display.overlays = overlays,
            ViewCommand::ForceScale(scale) => self.display.set_force_scale(scale),
            ViewCommand::Sight(sight) => {
                self.display.sight = sight;
                // What is followed is taken from where it is now.
                self.viewport.followed = None;
            }
            ViewCommand::Tool(tool) => self.display.tool = tool,
        }
    }

    /// Does a command about what is held; what is held may change the document.
    ///
    /// # Errors
    /// As [`Document::edit`] and [`Document::abandon`].
    pub(in crate::app) fn apply_hand(
        &mut self,
        command: &HandCommand,
        document: &mut Document,
    ) -> Result<bool, EditError> {
        match self.viewport.hand.apply(command, document.scene(), document.selection().all()) {
            Some(Keyed::Change(edit, gesture)) => document.edit(edit, Some(gesture)),
            Some(Keyed::Abandon(gesture)) => document.abandon(gesture),
            None => Ok(false),
        }
    }

    /// The section force that colours girders that bend; N where none does.
    pub(in crate::app) fn section_force(&self) -> OfSection {
        self.display.sight.bent.and_then(|bent| bent.force).unwrap_or(OfSection::Axial)
    }

    /// Whether there is a camera to go back to.
    pub(in crate::app) fn has_been_turned(&self) -> bool {
        self.before.is_some()
    }

    /// A picture of the view as it is, but for its instant.
    pub(in crate::app) fn shot(&self) -> Shot {
        Shot {
            camera: self.viewport.camera().copied(),
            size: self.viewport.size(),
            overlays: Some(self.display.overlays),
            background: self.viewport.background(),
            force_scale: self.display.force_scale(),
            bent: self.display.sight.bent,
            ..Shot::default()
        }
    }

    /// The view at an instant \[s\] for paper: on white, [`PRINT_WIDTH`] wide.
    pub(in crate::app) fn shot_for_print(&self, t: f64) -> Shot {
        let shot = self.shot();
        let [width, height] = shot.size.map(f64::from);
        let height =
            (f64::from(PRINT_WIDTH) * height / width.max(1.0)).round().clamp(1.0, 4.0 * f64::from(PRINT_WIDTH));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped above")]
        let size = [PRINT_WIDTH, height as u32];
        Shot { size, background: Background::White, at: Instant::At(t), ..shot }
    }

    /// Everything of it that commands can change and a frame shows.
    pub(in crate::app) fn shown(&self) -> impl PartialEq + use<> {
        let viewport = (self.viewport.camera().copied(), self.viewport.wanted(), self.viewport.hand.seen());
        (viewport, self.display.seen(), self.aim_next, self.before)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::app::command::{Flank, Grip, HandKey, Look, Sight, Tool};
    use crate::files::SceneSource;
    use crate::scene::presets;

    fn opened() -> (SceneView, Document) {
        let scene = presets::load(presets::OPENING).expect("ships");
        (SceneView::new(&scene), Document::new(scene, SceneSource::New))
    }

    #[test]
    fn a_command_changes_what_a_frame_shows() {
        let (mut view, document) = opened();
        let mut overlays = view.display.overlays;
        overlays.grid = !overlays.grid;
        let sight = Sight { plan: true, ..Sight::default() };
        let preset = if document.scene().view.camera == ViewPreset::Top { ViewPreset::Iso } else { ViewPreset::Top };
        for command in [
            ViewCommand::Overlays(overlays),
            ViewCommand::ForceScale(Some(5.0)),
            ViewCommand::Sight(sight),
            ViewCommand::Tool(Tool::Girder),
            ViewCommand::Preset(preset),
        ] {
            let before = view.shown();
            view.apply(command, &document, &Replay::default());
            assert!(view.shown() != before, "{command:?} is seen");
        }
        let shot = view.shot();
        assert_eq!((shot.overlays, shot.force_scale), (Some(overlays), Some(5.0)), "a picture of it is the same");
    }

    #[test]
    fn a_scene_is_looked_at_as_it_wants_and_again_when_there_is_room() {
        let (mut view, document) = opened();
        view.viewport.want(ViewPreset::Side);
        view.look_as(document.scene());
        assert_eq!(view.viewport.wanted(), Some(document.scene().view.camera), "as it wants");
        view.aim_next(ViewPreset::Top);
        assert_ne!(view.viewport.wanted(), Some(ViewPreset::Top), "not yet");
        view.aim();
        assert_eq!(view.viewport.wanted(), Some(ViewPreset::Top), "now");
    }

    #[test]
    fn a_view_that_a_reading_has_turned_goes_back_and_forth() {
        let (mut view, document) = opened();
        let camera = |view: &SceneView| view.viewport.camera().copied();
        let bounds = crate::view::Bounds::of_scene(document.scene());
        let own = Camera { yaw: 0.3, ..Camera::preset(ViewPreset::Iso, bounds, 1.5) };
        view.viewport.set_camera(own);
        assert!(!view.has_been_turned(), "by nothing yet");
        view.apply(ViewCommand::Look(Look::Girder(0)), &document, &Replay::default());
        let turned = camera(&view);
        assert_ne!(turned, Some(own), "to the girder");
        view.apply(ViewCommand::Back, &document, &Replay::default());
        assert_eq!(camera(&view), Some(own), "as the hand had left it");
        view.apply(ViewCommand::Back, &document, &Replay::default());
        assert_eq!(camera(&view), turned, "and to the girder again");
        view.look_as(document.scene());
        assert!(!view.has_been_turned(), "another scene has no camera before");
    }

    #[test]
    fn a_typed_width_changes_the_document_and_cancelling_puts_it_back() {
        let (mut view, mut document) = opened();
        let before = document.scene().clone();
        let take = HandCommand::Take(Grip::Width(0, Flank::Left), DVec3::ZERO);
        assert!(!view.apply_hand(&take, &mut document).expect("no edit"), "held, and nothing else");
        let typed = HandCommand::Type(HandKey::Text("12".into()));
        assert!(view.apply_hand(&typed, &mut document).expect("fits"), "another width");
        assert_ne!(document.scene().girders[0].width, before.girders[0].width, "of the girder");
        assert!(view.apply_hand(&HandCommand::Type(HandKey::Cancel), &mut document).expect("known"), "put back");
        assert_eq!(document.scene(), &before, "as it was");
    }
}
