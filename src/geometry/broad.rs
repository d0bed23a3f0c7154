//! Who is near whom among many: a tree of boxes (parry's Bvh), so that a row of a thousand is not asked a million times.
//!
//! The tree only says who may matter; whoever asks decides by its own rule. Answers come in rising order of number, so
//! that nothing depends on how the tree was built.

use glam::DVec3;
use parry3d::bounding_volume::Aabb;
use parry3d::partitioning::{Bvh, BvhBuildStrategy, BvhNode, BvhWorkspace};

use super::shape::AlignedBox;

/// A tree of numbered boxes.
pub struct Broad {
    tree: Bvh,
    workspace: BvhWorkspace,
}

impl std::fmt::Debug for Broad {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Broad of {} boxes", self.tree.leaf_count())
    }
}

impl Broad {
    /// The tree of boxes that are numbered from 0; one that is not finite meets nobody.
    pub fn of(boxes: impl IntoIterator<Item = AlignedBox>) -> Self {
        let finite = |(_, b): &(usize, AlignedBox)| b.min.is_finite() && b.max.is_finite();
        let leaves: Vec<(usize, Aabb)> =
            boxes.into_iter().enumerate().filter(finite).map(|(n, b)| (n, Aabb::new(b.min, b.max))).collect();
        Self { tree: Bvh::from_iter(BvhBuildStrategy::Binned, leaves), workspace: BvhWorkspace::default() }
    }

    /// Moves a box; [`settle`](Self::settle) must follow before the next question.
    pub fn move_to(&mut self, number: u32, place: AlignedBox) {
        let _ = self.tree.insert_or_update_partially(Aabb::new(place.min, place.max), number, 0.0);
    }

    /// Takes in the moves since the last time: only boxes above those that moved are touched.
    pub fn settle(&mut self) {
        self.tree.refit(&mut self.workspace);
    }

    /// Boxes that meet this one, borders included, in rising order, written to `found`.
    pub fn meeting(&self, hull: &AlignedBox, found: &mut Vec<usize>) {
        found.clear();
        found.extend(self.tree.intersect_aabb(&Aabb::new(hull.min, hull.max)).map(|n| n as usize));
        found.sort_unstable();
    }

    /// Every two boxes that meet, borders included: the lower number first, in rising order.
    pub fn pairs(&self) -> Vec<(usize, usize)> {
        let both = self.tree.leaf_pairs(&self.tree, BvhNode::intersects);
        let mut pairs: Vec<(usize, usize)> =
            both.filter(|(a, b)| a < b).map(|(a, b)| (a as usize, b as usize)).collect();
        pairs.sort_unstable();
        pairs
    }

    /// The least `distance` that any box is given, where that is never less than the distance from `from` to the box;
    /// infinite when `distance` gives none. Boxes in a part of space that `may` refuses are not asked.
    pub fn least(
        &self,
        from: DVec3,
        may: impl Fn(&AlignedBox) -> bool,
        distance: impl Fn(usize) -> Option<f64>,
    ) -> f64 {
        let cost = |node: &BvhNode, _best: f64| {
            let (min, max) = (node.mins(), node.maxs());
            if may(&AlignedBox { min, max }) { from.distance(from.clamp(min, max)) } else { f64::MAX }
        };
        // A distance equal to the least found so far need not be asked for.
        let best = self.tree.find_best(f64::MAX, cost, |n, _| distance(n as usize));
        best.map_or(f64::INFINITY, |(_, least)| least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(at: f64, beside: f64) -> AlignedBox {
        let min = DVec3::new(at, beside, 0.0);
        AlignedBox { min, max: min + DVec3::ONE }
    }

    #[test]
    fn everyone_who_meets_is_found_as_by_asking_everyone() {
        // A lattice of period 7 × 11 with overlaps in both directions.
        let boxes: Vec<AlignedBox> =
            (0..300).map(|n| unit(f64::from(n % 7) * 0.9 + f64::from(n) * 0.05, f64::from(n % 11) * 1.3)).collect();
        let meet = |a: &AlignedBox, b: &AlignedBox| a.min.cmple(b.max).all() && b.min.cmple(a.max).all();
        let mut plain = Vec::new();
        for a in 0..boxes.len() {
            plain.extend((a + 1..boxes.len()).filter(|&b| meet(&boxes[a], &boxes[b])).map(|b| (a, b)));
        }
        assert!(plain.len() > 300, "the lattice overlaps: {}", plain.len());
        let mut tree = Broad::of(boxes.iter().copied());
        assert_eq!(tree.pairs(), plain, "as built");
        let mut found = Vec::new();
        tree.meeting(&boxes[5], &mut found);
        assert_eq!(found, (0..300).filter(|&n| meet(&boxes[5], &boxes[n])).collect::<Vec<_>>(), "one against all");
        tree.move_to(5, unit(1e3, 0.0));
        tree.settle();
        tree.meeting(&boxes[5], &mut found);
        assert!(!found.contains(&5), "it has moved away");
    }

    #[test]
    fn the_nearest_is_found_and_none_among_none() {
        let tree = Broad::of((0..50).map(|n| unit(f64::from(n) * 2.0, 0.0)));
        let from = DVec3::new(40.5, 0.5, 0.5);
        let ahead = |n: usize| (n > 22).then(|| (n as f64 * 2.0 - 40.5).abs());
        assert_eq!(tree.least(from, |_| true, ahead), 5.5, "number 23, at 46");
        assert_eq!(tree.least(from, |_| true, |_| None), f64::INFINITY, "nobody admitted");
        assert_eq!(tree.least(from, |_| false, ahead), f64::INFINITY, "nobody asked");
        assert_eq!(Broad::of([]).least(from, |_| true, ahead), f64::INFINITY, "nobody there");
        assert_eq!(Broad::of([unit(46.0, 0.0)]).least(from, |_| true, |_| Some(5.5)), 5.5, "one alone");
    }
}
