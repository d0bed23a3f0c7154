//! Broad phase: which of many boxes are near each other, by a tree of boxes (parry's Bvh).
//!
//! The tree gives candidates only; the caller decides by its own rule. Results are in rising order of number, so that they do not depend
//! on how the tree was built. For one query of all pairs a sweep along one axis ([`pairs`], [`Along`]) is cheaper than building a tree.

use glam::DVec3;
use parry3d::bounding_volume::Aabb;
use parry3d::partitioning::{Bvh, BvhBuildStrategy, BvhNode};

use super::shape::AlignedBox;

/// A tree of numbered boxes.
pub struct Broad {
    tree: Bvh,
}

impl std::fmt::Debug for Broad {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Broad of {} boxes", self.tree.leaf_count())
    }
}

impl Broad {
    /// Tree of boxes that are numbered from 0; a box that is not finite is in no result.
    pub fn of(boxes: impl IntoIterator<Item = AlignedBox>) -> Self {
        let finite = |(_, b): &(usize, AlignedBox)| b.min.is_finite() && b.max.is_finite();
        let leaves: Vec<(usize, Aabb)> =
            boxes.into_iter().enumerate().filter(finite).map(|(n, b)| (n, Aabb::new(b.min, b.max))).collect();
        Self { tree: Bvh::from_iter(BvhBuildStrategy::Binned, leaves) }
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

/// Comparisons per box of a sweep along one axis, after which the tree is built instead \[–\]. Affects the work alone. Chosen.
const CROWD: usize = 32;

/// Every two of these boxes that meet, borders included: the lower number first, in rising order.
pub fn pairs(boxes: &[AlignedBox]) -> Vec<(usize, usize)> {
    let along = Along::of(boxes.iter().map(|b| b.min));
    let (axis, mut left) = (along.axis, CROWD * boxes.len());
    let meet = |a: &AlignedBox, b: &AlignedBox| a.min.cmple(b.max).all() && b.min.cmple(a.max).all();
    let mut found = Vec::new();
    for (n, &(_, one)) in along.order.iter().enumerate() {
        for &(from, other) in &along.order[n + 1..] {
            if from > boxes[one].max[axis] {
                break;
            }
            if left == 0 {
                return Broad::of(boxes.iter().copied()).pairs();
            }
            left -= 1;
            if meet(&boxes[one], &boxes[other]) {
                found.push((one.min(other), one.max(other)));
            }
        }
    }
    found.sort_unstable();
    found
}

/// Numbered places in order along the axis along which they spread most.
#[derive(Debug)]
pub struct Along {
    /// That axis: 0 is x.
    pub axis: usize,
    /// Coordinate and number, rising.
    order: Vec<(f64, usize)>,
    /// Place in the order of each number.
    place: Vec<usize>,
}

impl Along {
    /// Of places that are numbered from 0.
    pub fn of(places: impl Iterator<Item = DVec3> + Clone) -> Self {
        let spread = AlignedBox::around_all(places.clone());
        let spread = spread.max - spread.min;
        let axis = if spread.x >= spread.y && spread.x >= spread.z { 0 } else { 1 + usize::from(spread.z > spread.y) };
        let mut order: Vec<(f64, usize)> = places.enumerate().map(|(n, place)| (place[axis], n)).collect();
        order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut place = vec![0; order.len()];
        order.iter().enumerate().for_each(|(at, (_, n))| place[*n] = at);
        Self { axis, order, place }
    }

    /// All other numbers with their distance along the axis, nearest first.
    pub fn outward(&self, number: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let at = self.place[number];
        let here = self.order[at].0;
        let (mut below, mut above) = (at, at + 1);
        std::iter::from_fn(move || {
            let down = below.checked_sub(1).map(|at| (self.order[at].1, here - self.order[at].0));
            let up = self.order.get(above).map(|(to, n)| (*n, to - here));
            match (down, up) {
                (Some(down), up) if up.is_none_or(|up| down.1 <= up.1) => {
                    below -= 1;
                    Some(down)
                }
                (_, up) => {
                    above += 1;
                    up
                }
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn going_along_finds_whom_a_tree_finds() {
        // A row, a stack, a lattice, and a crowd of boxes as long as all of it.
        let row = |n: i32| unit(f64::from(n) * 0.7, 0.0);
        let stack = |n: i32| unit(0.0, f64::from(n) * 0.4);
        let lattice = |n: i32| unit(f64::from(n % 7) * 0.9 + f64::from(n) * 0.05, f64::from(n % 11) * 1.3);
        let crowd = |n: i32| {
            let AlignedBox { min, max } = unit(f64::from(n) * 0.01, f64::from(n % 90) * 0.6);
            AlignedBox { min, max: max.with_x(max.x + 50.0) }
        };
        for of in [row, stack, lattice, crowd] {
            let boxes: Vec<AlignedBox> = (0..300).map(of).collect();
            let tree = Broad::of(boxes.iter().copied()).pairs();
            assert!(tree.len() > 250, "they overlap: {}", tree.len());
            assert_eq!(pairs(&boxes), tree, "by numbers, in order");
        }
        assert_eq!(pairs(&[]), [], "nobody there");
    }

    #[test]
    fn the_nearest_along_the_axis_come_first() {
        let along = Along::of([3.0, -1.0, 2.5, 9.0].into_iter().map(|y| DVec3::new(0.1 * y, y, 0.0)));
        assert_eq!(along.axis, 1, "they spread along y");
        let seen: Vec<(usize, f64)> = along.outward(0).collect();
        assert_eq!(seen, [(2, 0.5), (1, 4.0), (3, 6.0)], "everyone but oneself");
    }

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
        let tree = Broad::of(boxes.iter().copied());
        assert_eq!(tree.pairs(), plain, "as built");
        let mut found = Vec::new();
        tree.meeting(&boxes[5], &mut found);
        assert_eq!(found, (0..300).filter(|&n| meet(&boxes[5], &boxes[n])).collect::<Vec<_>>(), "one against all");
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
