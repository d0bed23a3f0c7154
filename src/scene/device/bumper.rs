//! A bumper as placed.

use glam::DVec3;

use super::fault::{Fault, missing};
use super::joint::{Joint, no_direction};
use super::table::device_table;
use crate::language::{Text, message};
use crate::scene::keys::{Fallback, Range};

device_table! {
    /// A bumper or shock absorber: rubber that its first point is pushed against.
    struct Bumper, BUMPER {
        #[serde(default, with = "crate::scene::two_or_three::optional")]
        normal: Option<[f64; 3]> = "normal" as "field-normal", Range::Like("two or three numbers"),
            Fallback::Words("out of the abutment's face; otherwise from to_m towards at_m"),
            "direction of the force on the girder as placed, in its frame; it turns with the body of to_m";
        gap: Option<f64> = "gap_m" as "field-gap", Range::NotNegative, Fallback::Words("distance of at_m from the plane through to_m"),
            "distance along the normal as placed before the force begins, m";
        stiffness: Option<f64> = "stiffness_n_per_m" as "field-stiffness", Range::Positive, Fallback::Needed("this or depth_force_m_n"),
            "of a linear bumper, N/m";
        table: Option<Vec<[f64; 2]>> = "depth_force_m_n", Range::Like("rising pairs"),
            Fallback::Needed("this or stiffness_n_per_m"),
            "[[depth, force], …] from (0, 0) on, joined by straight lines of which the last goes on, m and N";
        #[serde(default)]
        damping: f64 = "damping_n_s_per_m" as "field-damping-c", Range::NotNegative, Fallback::Number(0.0),
            "c of the dashpot beside it, N·s/m";
    }
}

impl Bumper {
    /// Unit normal as placed, world axes: the direction of the force on the girder.
    pub fn normal(&self, joint: &Joint) -> Option<DVec3> {
        match self.normal {
            Some(given) => joint.direction(given),
            None => joint.face.or_else(|| joint.span().try_normalize()),
        }
    }

    /// Distance as placed before the force begins, and of the first point from the plane through the second \[m\].
    pub fn gaps(&self, joint: &Joint) -> Option<[f64; 2]> {
        let distance = joint.span().dot(self.normal(joint)?);
        Some([self.gap.unwrap_or(distance), distance])
    }

    /// Depths \[m\] and forces \[N\] beyond (0, 0).
    pub fn depths_and_forces(&self) -> Vec<[f64; 2]> {
        let table = self.table.as_deref().map(|table| beyond_zero(table).to_vec());
        table.or_else(|| self.stiffness.map(|k| vec![[1.0, k]])).unwrap_or_default()
    }

    fn own_faults(&self, joint: Option<&Joint>) -> Vec<Fault> {
        let mut faults: Vec<Fault> = no_direction("normal", self.normal).into_iter().collect();
        match (self.stiffness, &self.table) {
            (None, None) => faults.push(missing("stiffness_n_per_m", Text::new("wrong-bumper-no-stiffness"))),
            (Some(_), Some(_)) => {
                let both = message!("found-both", "one" => "stiffness_n_per_m", "other" => "depth_force_m_n");
                faults.push(("stiffness_n_per_m", both, Text::new("wrong-both").into()));
            }
            (None, Some(table)) => faults.extend(unsteady(table)),
            (Some(_), None) => {}
        }
        let Some(joint) = joint.filter(|_| faults.is_empty()) else { return faults };
        match self.gaps(joint) {
            None => faults.push(missing("normal", Text::new("wrong-points-coincide"))),
            Some([gap, _]) if gap < 0.0 => {
                let remedy = Text::new("wrong-bumper-behind");
                faults.push(("to_m", message!("found-distance", "gap" => format!("{gap:e}")), remedy.into()));
            }
            Some(_) => {}
        }
        faults
    }
}

/// A table of depths and forces without the beginning at (0, 0), which may be written out.
fn beyond_zero(table: &[[f64; 2]]) -> &[[f64; 2]] {
    match table {
        [[0.0, 0.0], beyond @ ..] => beyond,
        _ => table,
    }
}

/// Fault of a table of depths and forces.
fn unsteady(table: &[[f64; 2]]) -> Option<Fault> {
    let table = beyond_zero(table);
    let mut before = [0.0; 2];
    for point in table {
        if !(point[0] > before[0] && point[1] > before[1]) {
            let found = format!("[{:?}, {:?}]", point[0], point[1]).into();
            let remedy = Text::new("wrong-depths").into();
            return Some(("depth_force_m_n", found, remedy));
        }
        before = *point;
    }
    table.is_empty().then(|| ("depth_force_m_n", "[]".into(), Text::new("wrong-no-depths").into()))
}
