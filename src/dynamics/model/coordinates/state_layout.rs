//! Offsets of the states of several bodies in one vector.

use std::ops::Range;

use crate::dynamics::model::body::Body;

/// States of bodies one after the other, each as wide as its degrees of freedom.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::dynamics) struct StateLayout {
    /// Component and section at which each begins, and at which the last one ends.
    offsets: Vec<[usize; 2]>,
    /// Whether any has parts of given length.
    has_unit_parts: bool,
}

/// A component of one of several bodies.
#[derive(Clone, Copy, Debug)]
pub(in crate::dynamics) struct BodyComponent {
    /// Number of the body.
    pub body: usize,
    /// Number of the component in the body's state.
    pub component: usize,
}

impl StateLayout {
    /// Of bodies in this order.
    pub(in crate::dynamics) fn of<'a>(bodies: impl ExactSizeIterator<Item = &'a Body>) -> Self {
        let mut layout = Self { offsets: Vec::with_capacity(bodies.len() + 1), has_unit_parts: false };
        let mut at = [0; 2];
        layout.offsets.push(at);
        for body in bodies {
            at = [at[0] + body.width(), at[1] + body.sections()];
            layout.offsets.push(at);
            layout.has_unit_parts |= body.has_unit_parts();
        }
        layout
    }

    /// Components of body `index`.
    #[inline]
    pub(in crate::dynamics) fn range(&self, index: usize) -> Range<usize> {
        self.offsets[index][0]..self.offsets[index + 1][0]
    }

    /// Sections of body `index`, among those of all bodies.
    #[inline]
    pub(in crate::dynamics) fn sections(&self, index: usize) -> Range<usize> {
        self.offsets[index][1]..self.offsets[index + 1][1]
    }

    /// Components of all bodies.
    #[inline]
    pub(in crate::dynamics) fn len(&self) -> usize {
        self.offsets.last().map_or(0, |end| end[0])
    }

    /// Sections of all bodies.
    #[inline]
    pub(in crate::dynamics) fn section_count(&self) -> usize {
        self.offsets.last().map_or(0, |end| end[1])
    }

    /// The body's component that is component `i` of the vector; `None` beyond the bodies.
    pub(in crate::dynamics) fn component(&self, i: usize) -> Option<BodyComponent> {
        let body = self.offsets.partition_point(|from| from[0] <= i).checked_sub(1)?;
        (body + 1 < self.offsets.len()).then(|| BodyComponent { body, component: i - self.offsets[body][0] })
    }

    /// Whether any body has parts of given length.
    #[inline]
    pub(in crate::dynamics) fn has_unit_parts(&self) -> bool {
        self.has_unit_parts
    }

    /// State by state.
    pub(in crate::dynamics) fn states<'a>(&self, y: &'a [f64]) -> impl ExactSizeIterator<Item = &'a [f64]> {
        self.offsets.windows(2).map(|ends| &y[ends[0][0]..ends[1][0]])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::Model;
    use crate::scene::presets;

    #[test]
    fn states_follow_one_another_each_as_wide_as_its_body() {
        let body =
            |name: &str| Model::compile(&presets::load(name).expect("a preset")).expect("a scene").bodies.remove(0);
        let (planar, spatial) = (body("skew45-abutment"), body("deck-30m"));
        let layout = StateLayout::of([&planar, &spatial, &planar].into_iter());
        assert_eq!([0, 1, 2].map(|index| layout.range(index)), [0..6, 6..19, 19..25], "offsets");
        assert_eq!((layout.len(), layout.has_unit_parts()), (25, true), "one has a quaternion");
        assert_eq!((layout.section_count(), layout.sections(1)), (3, 1..2), "a rigid body is one section");
        let y: Vec<f64> = (0..26).map(f64::from).collect();
        assert_eq!(
            layout.states(&y).map(<[f64]>::len).collect::<Vec<_>>(),
            [6, 13, 6],
            "what follows them is no state"
        );
        assert_eq!(
            [0, 5, 6, 18, 24, 25].map(|i| layout.component(i).map(|of| (of.body, of.component))),
            [Some((0, 0)), Some((0, 5)), Some((1, 0)), Some((1, 12)), Some((2, 5)), None]
        );
    }
}
