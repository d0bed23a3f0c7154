//! A scene as its fields show it: its values, and the complaints about them.

use super::place::Place;
use super::table::Look;
use crate::app::unit::Size;
use crate::scene::{Scene, SceneErrors};

/// A scene, and the complaints about it.
#[derive(Clone, Copy)]
pub(in crate::app) struct Form<'a> {
    /// The scene as it is edited.
    pub(in crate::app) scene: &'a Scene,
    /// Complaints that keep it from being run.
    pub(in crate::app) problems: Option<&'a SceneErrors>,
}

impl<'a> Form<'a> {
    /// Where the fields of a table stand; the top of the file has no name.
    pub(in crate::app) fn place(self, table: &'a str) -> Place<'a> {
        Place { problems: self.problems, assumed: &self.scene.assumed, differing: &[], table }
    }

    /// Fields of a table, with the scene's own size.
    pub(in crate::app) fn look(self, table: &'a str) -> Look<'a> {
        self.look_of(table, Size::of_scene(self.scene))
    }

    /// Fields of a table about something of this size.
    pub(in crate::app) fn look_of(self, table: &'a str, size: Size) -> Look<'a> {
        Look::new(self.place(table), self.scene.kind, size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{SceneError, presets};

    #[test]
    fn fields_of_a_table_show_the_complaints_about_it() {
        let scene = presets::load(presets::OPENING).expect("ships");
        let (file, place) = ("f".into(), "solver.tolerance".into());
        let errors = SceneErrors(vec![SceneError { file, place, value: "-1".into(), remedy: "more than 0".into() }]);
        let form = Form { scene: &scene, problems: Some(&errors) };
        assert_eq!(form.look("solver").place.complaint("tolerance").as_deref(), Some("-1: more than 0"), "its own");
        assert_eq!(form.look("contact").place.complaint("tolerance"), None, "another table's");
        assert_eq!(form.look("solver").kind, scene.kind, "as many directions as the scene has");
        assert_eq!(form.place("").path("duration_s"), "duration_s", "the top of the file");
    }
}
