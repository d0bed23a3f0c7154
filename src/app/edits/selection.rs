//! Selection: any number of objects, in the order in which they were taken; the last one leads.

use crate::app::command::SelectCommand;
use crate::scene::Scene;
use crate::view::Target;

/// Selection.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection(Vec<Target>);

impl Selection {
    /// Does a command.
    pub(super) fn apply(&mut self, command: SelectCommand, scene: &Scene) {
        match command {
            SelectCommand::Only(target) => self.only(target),
            SelectCommand::Also(target) => self.toggle(target),
            SelectCommand::All => self.everything(scene),
        }
    }

    /// The one whose numbers are shown.
    pub fn lead(&self) -> Option<Target> {
        self.0.last().copied()
    }

    /// All of it.
    pub fn all(&self) -> &[Target] {
        &self.0
    }

    /// Whether it is among them.
    pub(in crate::app) fn has(&self, target: Target) -> bool {
        self.0.contains(&target)
    }

    /// Selects this alone, or nothing.
    pub(in crate::app) fn only(&mut self, target: Option<Target>) {
        self.0.clear();
        self.0.extend(target);
    }

    /// Takes something in, or lets go of it when it was in. Bodies and contacts are not mixed: what is done to the one
    /// kind means nothing to the other.
    fn toggle(&mut self, target: Target) {
        if self.has(target) {
            self.0.retain(|t| *t != target);
        } else {
            self.0.retain(|t| is_body(*t) == is_body(target));
            self.0.push(target);
        }
    }

    /// Selects these.
    pub(super) fn these(&mut self, targets: impl IntoIterator<Item = Target>) {
        self.0 = targets.into_iter().collect();
    }

    /// Girders and abutments among them.
    pub(in crate::app) fn bodies(&self) -> impl Iterator<Item = Target> + '_ {
        self.0.iter().copied().filter(|t| is_body(*t))
    }

    /// Numbers of the girders among them.
    pub(in crate::app) fn girders(&self) -> impl Iterator<Item = usize> + '_ {
        self.0.iter().filter_map(|t| if let Target::Girder(i) = t { Some(*i) } else { None })
    }

    /// Selects every girder, abutment and pier.
    fn everything(&mut self, scene: &Scene) {
        let girders = (0..scene.girders.len()).map(Target::Girder);
        let abutments = (0..scene.abutments.len()).map(Target::Abutment);
        self.these(girders.chain(abutments).chain((0..scene.piers.len()).map(Target::Pier)));
    }

    /// The girder, abutment or pier that leads.
    pub(in crate::app) fn lead_body(&self) -> Option<Target> {
        self.lead().filter(|t| is_body(*t))
    }

    /// The girder whose curves stand out: the one that leads, or the one that its abutment faces; else the first.
    pub(super) fn girder_shown(&self, scene: &Scene) -> usize {
        match self.lead() {
            Some(Target::Girder(i)) => i,
            Some(Target::Abutment(i)) => {
                let faces = scene.abutments.get(i).map(|a| &a.faces);
                scene.girders.iter().position(|g| Some(&g.name) == faces).unwrap_or(0)
            }
            Some(Target::Device(id)) => {
                let device = scene.device(id);
                let name = device.as_ref().map(|device| device.part().ends().girder);
                scene.girders.iter().position(|g| Some(g.name.as_str()) == name).unwrap_or(0)
            }
            _ => 0,
        }
    }

    /// Lets go of what is not there any more; contacts belong to an answer that is gone.
    pub(super) fn keep_in(&mut self, scene: &Scene) {
        self.0.retain(|t| match t {
            Target::Girder(i) => *i < scene.girders.len(),
            Target::Abutment(i) => *i < scene.abutments.len(),
            Target::Pier(i) => *i < scene.piers.len(),
            Target::Device(id) => id.number < scene.count_of(id.kind),
            Target::Contact(_) => false,
        });
    }
}

fn is_body(target: Target) -> bool {
    !matches!(target, Target::Contact(_))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_one_taken_leads_and_is_let_go_first() {
        let mut selection = Selection::default();
        selection.toggle(Target::Girder(0));
        selection.toggle(Target::Abutment(1));
        assert_eq!(selection.lead(), Some(Target::Abutment(1)), "the last");
        selection.toggle(Target::Abutment(1));
        assert_eq!(selection.all(), [Target::Girder(0)], "taken twice is let go");
    }

    #[test]
    fn bodies_and_contacts_are_not_mixed() {
        let mut selection = Selection::default();
        selection.toggle(Target::Girder(0));
        selection.toggle(Target::Contact(3));
        assert_eq!(selection.all(), [Target::Contact(3)], "the contact alone");
    }
}
