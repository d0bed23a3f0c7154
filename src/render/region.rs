//! Parts of a picture, in whole pixels: what changes from one picture to the next is drawn anew, and nothing else.

/// A rectangle of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// Left and top; inside.
    pub min: [u32; 2],
    /// Right and bottom; outside.
    pub max: [u32; 2],
}

/// Most regions that are kept apart: each is drawn by itself, with every draw that reaches it.
const MOST_REGIONS: usize = 6;
/// Pixels that two regions drawn as one may take more than apart, for what beginning a region costs (tuned).
const WORTH: u64 = 4096;
/// Share of a picture below which regions of it are drawn, and not the whole. Of a frame by a processor 55 % are fragments and 9 % are
/// repeated for every region (`docs/cost.md`): two more regions cost less than the whole up to 1 − 2 · 9/55 = 0.67.
const PART: f64 = 0.7;

impl Region {
    /// The whole of a picture.
    pub fn whole(size: [u32; 2]) -> Self {
        Self { min: [0, 0], max: size }
    }

    /// The pixels of a picture that a rectangle touches; none where it lies beside it. What is not a number is everywhere.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held within the picture before")]
    pub fn of(min: [f32; 2], max: [f32; 2], size: [u32; 2]) -> Option<Self> {
        let side =
            |at: f32, otherwise: u32, of: u32| if at.is_nan() { otherwise } else { at.clamp(0.0, of as f32) as u32 };
        let low = [0, 1].map(|i| side(min[i].floor(), 0, size[i]));
        let high = [0, 1].map(|i| side(max[i].ceil(), size[i], size[i]));
        (low[0] < high[0] && low[1] < high[1]).then_some(Self { min: low, max: high })
    }

    /// Width and height \[pixels\].
    pub fn size(self) -> [u32; 2] {
        [0, 1].map(|i| self.max[i] - self.min[i])
    }

    /// How many pixels.
    pub fn area(self) -> u64 {
        self.size().map(u64::from).iter().product()
    }

    /// The least that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: [0, 1].map(|i| self.min[i].min(other.min[i])), max: [0, 1].map(|i| self.max[i].max(other.max[i])) }
    }

    /// Intersection of both.
    #[must_use]
    pub fn common(self, other: Self) -> Option<Self> {
        let (min, max) = ([0, 1].map(|i| self.min[i].max(other.min[i])), [0, 1].map(|i| self.max[i].min(other.max[i])));
        (min[0] < max[0] && min[1] < max[1]).then_some(Self { min, max })
    }

    /// Parts of it outside another: above, below, left and right.
    fn outside(self, other: Self) -> Vec<Self> {
        let Some(common) = self.common(other) else { return vec![self] };
        let ([left, top], [right, bottom]) = (self.min, self.max);
        let part = |min: [u32; 2], max: [u32; 2]| (min[0] < max[0] && min[1] < max[1]).then_some(Self { min, max });
        let parts = [
            part([left, top], [right, common.min[1]]),
            part([left, common.max[1]], [right, bottom]),
            part([left, common.min[1]], [common.min[0], common.max[1]]),
            part([common.max[0], common.min[1]], [right, common.max[1]]),
        ];
        parts.into_iter().flatten().collect()
    }

    /// Draws in it alone from here on.
    pub(super) fn cut(self, pass: &mut wgpu::RenderPass<'_>) {
        let ([x, y], [width, height]) = (self.min, self.size());
        pass.set_scissor_rect(x, y, width, height);
    }

    /// The same in another picture, in which this one begins at `by`.
    #[must_use]
    pub fn moved(self, by: [u32; 2]) -> Self {
        Self { min: [0, 1].map(|i| self.min[i] + by[i]), max: [0, 1].map(|i| self.max[i] + by[i]) }
    }
}

/// A few regions, none over another, that together hold all that were added.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Regions(Vec<Region>);

impl Regions {
    /// The whole of a picture.
    pub fn whole(size: [u32; 2]) -> Self {
        Self(vec![Region::whole(size)])
    }

    /// Adds one. Near ones become one; of two that overlap and would be much larger as one, the smaller is cut where the other lies.
    pub fn add(&mut self, region: Region) {
        let wasted = |other: &Region| {
            let common = region.common(*other)?;
            (added(region, *other) + i128::from(common.area()) > i128::from(WORTH)).then(|| common.area())
        };
        let overlaps = self.0.iter().enumerate().filter_map(|(i, other)| Some((wasted(other)?, i)));
        let Some((_, i)) = overlaps.max() else { return self.join(region) };
        let (kept, cut) = if self.0[i].area() < region.area() { (region, self.0[i]) } else { (self.0[i], region) };
        let outside = cut.outside(kept);
        if self.0.len() + outside.len() > MOST_REGIONS {
            return self.join(region);
        }
        self.0.swap_remove(i);
        self.join(kept);
        for part in outside {
            self.join(part);
        }
    }

    /// Adds one; those that it overlaps and near ones become one with it.
    fn join(&mut self, region: Region) {
        let mut grown = region;
        let near = |one: Region, other: Region| one.common(other).is_some() || added(one, other) <= i128::from(WORTH);
        while let Some(near) = self.0.iter().position(|other| near(grown, *other)) {
            grown = grown.union(self.0.swap_remove(near));
        }
        self.0.push(grown);
        if self.0.len() > MOST_REGIONS {
            self.join_two();
        }
    }

    /// Joins the two that cost least to be joined.
    fn join_two(&mut self) {
        let pairs = (0..self.0.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        if let Some((i, j)) = pairs.min_by_key(|(i, j)| added(self.0[*i], self.0[*j])) {
            let (one, other) = (self.0.swap_remove(i), self.0.swap_remove(j));
            self.join(one.union(other));
        }
    }

    /// Each of them.
    pub fn iter(&self) -> impl Iterator<Item = Region> + '_ {
        self.0.iter().copied()
    }

    /// Whether they are sooner drawn than the whole of a picture of this size.
    pub fn are_a_part_of(&self, [width, height]: [u32; 2]) -> bool {
        (self.area() as f64) < PART * f64::from(width) * f64::from(height)
    }

    /// Whether nothing was added.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many pixels.
    pub fn area(&self) -> u64 {
        self.iter().map(Region::area).sum()
    }
}

impl Extend<Region> for Regions {
    fn extend<T: IntoIterator<Item = Region>>(&mut self, regions: T) {
        regions.into_iter().for_each(|region| self.add(region));
    }
}

/// Pixels that two take more as one than apart.
fn added(one: Region, other: Region) -> i128 {
    i128::from(one.union(other).area()) - i128::from(one.area()) - i128::from(other.area())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn region(x: u32, y: u32, width: u32, height: u32) -> Region {
        Region { min: [x, y], max: [x + width, y + height] }
    }

    #[test]
    fn every_pixel_touched_belongs_to_it_and_none_beside_the_picture() {
        let size = [100, 50];
        assert_eq!(Region::of([1.2, 3.0], [4.1, 5.0], size), Some(region(1, 3, 4, 2)), "touched in part is touched");
        assert_eq!(Region::of([-9.0, -1e30], [1e30, 7.0], size), Some(region(0, 0, 100, 7)), "held within the picture");
        assert_eq!(Region::of([f32::NAN, 1.0], [4.0, f32::NAN], size), Some(region(0, 1, 4, 49)), "may be anywhere");
        for beside in [[-9.0, 1.0, -1.0, 2.0], [100.0, 1.0, 120.0, 2.0], [5.0, 5.0, 5.0, 9.0]] {
            assert_eq!(Region::of([beside[0], beside[1]], [beside[2], beside[3]], size), None, "{beside:?}");
        }
    }

    #[test]
    fn few_regions_hold_all_that_were_added() {
        let added: Vec<_> = (0..40).map(|i| region(31 * i % 997, 57 * i % 691, 10 + i, 5 + i % 7)).collect();
        let mut regions = Regions::default();
        regions.extend(added.iter().copied());
        assert!(regions.iter().count() <= MOST_REGIONS, "{regions:?}");
        let over = regions.iter().flat_map(|one| regions.iter().map(move |other| (one, other)));
        assert!(
            over.filter(|(one, other)| one != other).all(|(one, other)| one.common(other).is_none()),
            "{regions:?}"
        );
        for one in added {
            // None lies over another: what they hold of it adds up.
            let held: u64 = regions.iter().filter_map(|region| region.common(one)).map(Region::area).sum();
            assert_eq!(held, one.area(), "all of {one:?} is in {regions:?}");
        }
    }

    #[test]
    fn of_two_that_overlap_the_smaller_is_cut_where_both_would_be_much_larger_as_one() {
        // A body of 200 by 240 pixels, and a label of 210 by 25 that begins 85 to its left.
        let (body, label) = (region(300, 100, 200, 240), region(215, 130, 210, 25));
        for order in [[body, label], [label, body]] {
            let mut regions = Regions::default();
            regions.extend(order);
            assert_eq!(regions.area(), 200 * 240 + 85 * 25, "{regions:?}, not {}", body.union(label).area());
        }
        let beside = region(490, 110, 20, 220);
        let mut regions = Regions::default();
        regions.extend([body, beside]);
        assert_eq!(regions.area(), body.union(beside).area(), "as one they are hardly larger");
    }

    #[test]
    fn near_ones_become_one_and_far_ones_stay_apart() {
        let mut regions = Regions::default();
        regions.extend([region(0, 0, 50, 20), region(60, 0, 50, 20), region(900, 600, 50, 20)]);
        assert_eq!(regions.iter().count(), 2, "{regions:?}");
        assert_eq!(regions.area(), 110 * 20 + 50 * 20);
    }
}
