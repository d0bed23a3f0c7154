//! An elastic girder as part of a linear block.

use nalgebra::DMatrix;

use super::girder::ElasticGirder;
use crate::dynamics::model::body::Body;
use crate::dynamics::model::coordinates::planar;
use crate::dynamics::model::linear_block::part::{LinearPart, RIGID, SectionShape};

impl ElasticGirder {
    /// The girder's matrices, loads and sections as a part of a linear block.
    pub(super) fn part(&self) -> LinearPart {
        let n = self.places();
        let Body { push, moment, start: [x, y, .., turn], .. } = &self.rigid;
        let mut start = vec![0.0; n];
        start[..RIGID].copy_from_slice(&[*x, *y, *turn]);
        let [stiffness, damping] = self.matrices();
        let of_links = self.deforming.iter().map(|own| SectionShape { lever: own.lever, fields: own.fields.clone() });
        LinearPart {
            masses: self.masses().collect(),
            free: planar::free(&self.rigid).into_iter().chain(std::iter::repeat_n(true, self.count())).collect(),
            stiffness,
            damping,
            own_damping: [0.0; RIGID].into_iter().chain(self.springs.iter().map(|[_, c]| *c)).collect(),
            push: [push.x, push.y, moment.z].into_iter().chain(self.pushed.iter().copied()).collect(),
            start,
            lever: self.lever(),
            sections: std::iter::once(SectionShape::default()).chain(of_links).collect(),
        }
    }

    /// Stiffness over all coordinates, and the dashpots of the bearings.
    fn matrices(&self) -> [DMatrix<f64>; 2] {
        let n = self.places();
        let mut both = [DMatrix::zeros(n, n), DMatrix::zeros(n, n)];
        for axis in &self.bearings {
            for (matrix, factor) in both.iter_mut().zip([axis.stiffness, axis.damping]) {
                for j in 0..n {
                    for i in 0..n {
                        matrix[(i, j)] += factor * axis.row[i] * axis.row[j];
                    }
                }
            }
        }
        for (j, [k, _]) in self.springs.iter().enumerate() {
            both[0][(RIGID + j, RIGID + j)] += k;
        }
        both
    }
}
