//! A linear bearing between two bodies of a block, or between one and the ground.

use glam::{DVec2, DVec3};
use nalgebra::DMatrix;

use crate::dynamics::connection::{Kinematics, Link};

/// A spring and a dashpot along each of its axes, between points of one or two members of a block.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its ends that are bodies of the block, the first with the sign +.
    ends: Vec<JointEnd>,
    /// Directions with k \[N/m\] and c \[N·s/m\].
    axes: Vec<(DVec2, [f64; 2])>,
}

#[derive(Clone, Copy, Debug)]
struct JointEnd {
    member: usize,
    section: usize,
    arm: DVec2,
    sign: f64,
}

impl Joint {
    /// Of a link, with the members of the block that its ends are; `None` where the link is not linear in plan.
    pub fn of(link: &Link, members: [Option<usize>; 2]) -> Option<Self> {
        let [stiffness, damping] = link.device.linear()?;
        if link.kinematics != Kinematics::Linear {
            return None;
        }
        let end = |(i, sign): (usize, f64)| {
            let (section, arm) = (link.sections[i], link.arms[i].truncate());
            Some(JointEnd { member: members[i]?, section, arm, sign })
        };
        let axis = |i: usize| {
            let along: DVec3 = link.axes.col(i);
            (along.truncate(), [stiffness[i], damping[i]])
        };
        let ends = [(0, 1.0), (1, -1.0)].into_iter().filter_map(end).collect();
        Some(Self { ends, axes: (0..3).map(axis).collect() })
    }

    /// Adds stiffness and damping over all coordinates; `row` gives a member's own row and the first of its coordinates.
    pub(super) fn add(
        &self,
        row: impl Fn(usize, usize, DVec2, DVec2) -> (usize, Vec<f64>),
        [stiffness, damping]: [&mut DMatrix<f64>; 2],
    ) {
        for (along, [k, c]) in &self.axes {
            let signed = |end: &JointEnd| {
                let (first, row) = row(end.member, end.section, end.arm, *along);
                row.into_iter().enumerate().map(move |(i, x)| (first + i, end.sign * x)).collect::<Vec<_>>()
            };
            let all: Vec<(usize, f64)> = self.ends.iter().flat_map(signed).filter(|(_, x)| *x != 0.0).collect();
            for (i, x) in &all {
                for (j, y) in &all {
                    stiffness[(*i, *j)] += k * x * y;
                    damping[(*i, *j)] += c * x * y;
                }
            }
        }
    }
}
