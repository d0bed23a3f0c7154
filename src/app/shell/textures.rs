//! egui's textures as they are now: egui says only what changes, and a new device wants all of them.

use std::collections::BTreeMap;
use std::sync::Arc;

use egui::epaint::ImageDelta;
use egui::{ColorImage, ImageData, TextureId, TextureOptions, TexturesDelta};

/// A copy of every texture.
#[derive(Default)]
pub(in crate::app) struct Textures(BTreeMap<TextureId, (Arc<ColorImage>, TextureOptions)>);

impl Textures {
    /// Takes in what has changed.
    #[expect(clippy::iter_over_hash_type, reason = "textures do not depend on each other")]
    pub(in crate::app) fn take_in(&mut self, delta: &TexturesDelta) {
        for (id, changes) in &delta.set {
            changes.iter().for_each(|change| self.change(*id, change));
        }
        for id in &delta.free {
            self.0.remove(id);
        }
    }

    fn change(&mut self, id: TextureId, change: &ImageDelta) {
        let ImageData::Color(image) = &change.image;
        match (change.pos, self.0.get_mut(&id)) {
            (Some(at), Some((whole, _))) => patch(Arc::make_mut(whole), image, at),
            _ => drop(self.0.insert(id, (image.clone(), change.options))),
        }
    }

    /// Changes that make them all on a device that has none.
    pub(in crate::app) fn all(&self) -> impl Iterator<Item = (TextureId, ImageDelta)> {
        self.0.iter().map(|(id, (image, options))| (*id, ImageDelta::full(image.clone(), *options)))
    }
}

/// Puts a part where it belongs.
fn patch(whole: &mut ColorImage, part: &ColorImage, [left, top]: [usize; 2]) {
    let ([width, _], [part_width, _]) = (whole.size, part.size);
    let rows = whole.pixels.chunks_mut(width.max(1)).skip(top);
    for (row, new) in rows.zip(part.pixels.chunks(part_width.max(1))) {
        row.iter_mut().skip(left).zip(new).for_each(|(pixel, new)| *pixel = *new);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::Color32;

    fn image(size: [usize; 2], color: Color32) -> ColorImage {
        ColorImage::filled(size, color)
    }

    fn delta(id: TextureId, change: ImageDelta) -> TexturesDelta {
        let mut delta = TexturesDelta::default();
        delta.set.entry(id).or_default().push(change);
        delta
    }

    #[test]
    fn parts_are_put_into_the_whole_and_what_is_freed_goes() {
        let (id, options) = (TextureId::Managed(0), TextureOptions::LINEAR);
        let mut textures = Textures::default();
        let full = ImageDelta::full(image([4, 3], Color32::BLACK), options);
        for change in [full, ImageDelta::partial([1, 1], image([2, 2], Color32::WHITE), options)] {
            let mut delta = delta(id, change);
            textures.take_in(&delta);
            delta.clear();
        }
        let (_, whole) = textures.all().next().expect("one");
        let ImageData::Color(whole) = whole.image;
        let white: Vec<usize> = (0..12).filter(|i| whole.pixels[*i] == Color32::WHITE).collect();
        assert_eq!(white, [5, 6, 9, 10], "two by two, from the second of the second row");
        let mut gone = TexturesDelta::default();
        gone.free.insert(id);
        textures.take_in(&gone);
        gone.clear();
        assert_eq!(textures.all().count(), 0, "freed");
    }
}
