//! The motions of the ground of a scene: that of `[motion]` and those with names.

use super::shown::escaped;
use super::{GroundId, Motion, Scene};
use crate::language::{Message, message};

impl Scene {
    /// Every motion of the ground with its place in the file: `motion`, then `ground.NAME`.
    pub fn motions(&self) -> impl Iterator<Item = (String, &Motion)> {
        let named = self.grounds.iter().map(|ground| (format!("ground.{}", ground.name), &ground.motion));
        std::iter::once(("motion".to_owned(), &self.motion)).chain(named)
    }

    /// In words, each motion that the run cuts: a record that goes on after its end, an earthquake in its strong motion.
    pub(super) fn cut_motions(&self) -> Vec<Message> {
        let cut = |(place, motion): (String, &Motion)| {
            let (place, end) = (escaped(&place).into_owned(), self.duration);
            match motion {
                Motion::Record(record) => {
                    let (_, dt, samples) = record.extent()?;
                    let length = dt * samples.saturating_sub(1) as f64;
                    let words = || message!("record-cut", "place" => place, "length" => length, "end" => end);
                    (length > end + dt).then(words)
                }
                Motion::Synthetic(quake) => {
                    let length = quake.duration.min(quake.rise + quake.strong);
                    let words = || message!("strong-motion-cut", "place" => place, "length" => length, "end" => end);
                    (length > end).then(words)
                }
                Motion::None | Motion::Sine(_) | Motion::Sweep(_) => None,
            }
        };
        self.motions().filter_map(cut).collect()
    }

    /// The same, to be changed.
    pub fn motions_mut(&mut self) -> impl Iterator<Item = (String, &mut Motion)> {
        let named = self.grounds.iter_mut().map(|ground| (format!("ground.{}", ground.name), &mut ground.motion));
        std::iter::once(("motion".to_owned(), &mut self.motion)).chain(named)
    }

    /// Motion of a ground; `None` where the scene has none of that number.
    pub fn motion_of(&self, ground: GroundId) -> Option<&Motion> {
        match ground {
            GroundId::Reference => Some(&self.motion),
            GroundId::Named(number) => self.grounds.get(number).map(|named| &named.motion),
        }
    }

    /// The place of a ground's motion in the scene's file.
    pub fn motion_place(&self, ground: GroundId) -> String {
        match ground {
            GroundId::Reference => "motion".to_owned(),
            GroundId::Named(number) => {
                format!("ground.{}", self.grounds.get(number).map_or("", |named| named.name.as_str()))
            }
        }
    }

    /// The number of the ground of this name.
    pub fn ground_named(&self, name: &str) -> Option<usize> {
        self.grounds.iter().position(|ground| ground.name == name)
    }

    /// Whether an abutment or a pier stands on the ground of this name.
    pub fn stands_on_ground(&self, name: &str) -> bool {
        let abutments = self.abutments.iter().map(|abutment| &abutment.ground);
        abutments.chain(self.piers.iter().map(|pier| &pier.ground)).flatten().any(|ground| ground == name)
    }
}
