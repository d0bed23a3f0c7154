//! Readings of bearings, of piers and of the soil behind backwalls, in `summary.json`.

use serde::Serialize;

use crate::language::said;
use crate::scene::FAILING_PUSH;
use crate::sim::{BackfillReading, BaseReading, BearingsReading, History, PierReading};

/// Second-order moment in parts of the first-order one up to which it may be left out (EN 1998-1, 4.4.2.2(2)) \[–\].
const NEGLIGIBLE_SECOND_ORDER: f64 = 0.1;

/// The bearings of a girder.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BearingsReport {
    /// The girder.
    pub girder: String,
    /// The bearing that deforms most in plan, counted from 1.
    pub bearing: usize,
    /// Its largest deformation, in plan \[m\].
    pub deformation: f64,
    /// Time of it \[s\].
    pub t: f64,
    /// The bearing that resists most in plan, counted from 1.
    pub force_bearing: usize,
    /// Its largest resistance in plan: spring, dashpot and what yields or slides \[N\].
    pub force: f64,
    /// Time of it \[s\].
    pub force_t: f64,
}

/// Soil behind one backwall.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BackfillReport {
    /// The abutment's name.
    pub abutment: String,
    /// Greatest push of the wall into the soil \[m\].
    pub push: f64,
    /// Time of it \[s\].
    pub t: f64,
    /// Greatest resistance of the soil \[N\].
    pub force: f64,
    /// Its ultimate force `F_ult` \[N\].
    pub ultimate: f64,
    /// Height of the wall \[m\].
    pub height: f64,
    /// Gap that stays between the wall as placed and the soil \[m\].
    pub remaining_gap: f64,
}

impl BackfillReport {
    /// Whether the soil pushes by more than its ultimate force, rounded to a percent: a hyperbolic envelope does.
    pub fn is_beyond(&self) -> bool {
        self.force > 1.005 * self.ultimate
    }

    /// In words, that the push is more than that at which granular soil fails; none where it is not.
    pub fn fails(&self) -> Option<String> {
        let share = self.push / self.height;
        (share > FAILING_PUSH).then(|| {
            said!(
                "soil-fails",
                "abutment" => self.abutment.as_str(),
                "share" => format!("{:.1}", 100.0 * share),
                "limit" => format!("{:.0}", 100.0 * FAILING_PUSH)
            )
        })
    }
}

/// A pier.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PierReport {
    /// Its name.
    pub name: String,
    /// Undamped periods of the pier alone along and across \[s\].
    pub periods: [f64; 2],
    /// Largest displacement of its cap against its foot, in plan \[m\].
    pub drift: f64,
    /// Time of it \[s\].
    pub drift_t: f64,
    /// Largest base shear \[N\].
    pub shear: f64,
    /// Time of it \[s\].
    pub shear_t: f64,
    /// Largest moment at its feet, of all its columns \[N·m\].
    pub moment: f64,
    /// Largest rotation of its cap in plan \[rad\].
    pub rotation: f64,
    /// Time at which its base first yielded \[s\].
    pub yielded_at: Option<f64>,
    /// Largest drift in parts of that at yield, along and across; on one yield circle that in any direction, twice; of a base that can
    /// yield.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ductility: Option<[f64; 2]>,
    /// Drift along and across that stays when the base is unloaded from the end of the run; of a base that can yield \[m\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub residual_drift: Option<[f64; 2]>,
    /// Second-order moment P Δ, which is left out, in parts of that of the base shear; of a pier with a height.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub second_order: Option<f64>,
}

impl PierReport {
    /// In words, that the second-order moment, which is left out, is more than may be left out; none where it is not.
    pub fn second_order_counts(&self) -> Option<String> {
        let share = self.second_order.filter(|share| *share > NEGLIGIBLE_SECOND_ORDER)?;
        let (share, limit) = (format!("{:.0}", 100.0 * share), format!("{:.0}", 100.0 * NEGLIGIBLE_SECOND_ORDER));
        Some(said!("pier-second-order", "pier" => self.name.as_str(), "share" => share, "limit" => limit))
    }

    /// Ductility of a base that yielded, along and across, or one of both directions.
    pub fn ductility_words(&self) -> Option<String> {
        let [along, across] = self.ductility.filter(|_| self.yielded_at.is_some())?;
        Some(if along == across { format!("{along:.2}") } else { format!("{along:.2}, {across:.2}") })
    }
}

pub(super) fn bearings(history: &History) -> Vec<BearingsReport> {
    let report = |BearingsReading { girder, deformation: (bearing, moved), force: (most, force) }: BearingsReading| {
        BearingsReport {
            girder: history.model().bodies[girder].name.clone(),
            bearing: bearing + 1,
            deformation: moved.value,
            t: moved.t,
            force_bearing: most + 1,
            force: force.value,
            force_t: force.t,
        }
    };
    history.connections().bearing_readings().into_iter().map(report).collect()
}

/// Readings of the soil behind every backwall that moves.
pub fn backfill(history: &History) -> Vec<BackfillReport> {
    let report = |BackfillReading { abutment, push, t, force, ultimate, height, remaining_gap }: BackfillReading| {
        let abutment = history.scene().abutments[abutment].name.clone();
        BackfillReport { abutment, push, t, force, ultimate, height, remaining_gap }
    };
    history.connections().backfill().into_iter().map(report).collect()
}

/// Readings of every pier.
pub fn piers(history: &History) -> Vec<PierReport> {
    let report =
        |PierReading { pier, periods, drift, shear, moment, turn, base, second_order }: PierReading| PierReport {
            name: history.scene().piers[pier].name.clone(),
            periods,
            drift: drift.value,
            drift_t: drift.t,
            shear: shear.value,
            shear_t: shear.t,
            moment: moment.value,
            rotation: turn,
            yielded_at: base.and_then(|base: BaseReading| base.yielded_at),
            ductility: base.map(|base| base.ductility),
            residual_drift: base.map(|base| base.residual),
            second_order,
        };
    history.connections().piers().into_iter().map(report).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_push_beyond_what_soil_holds_is_said() {
        let pushed = |push: f64| BackfillReport {
            abutment: "east".to_owned(),
            push,
            t: 1.0,
            force: 1e6,
            ultimate: 1e6,
            height: 1.7,
            remaining_gap: 0.0,
        };
        assert_eq!(pushed(0.08).fails(), None, "4.7 % of the wall's height");
        let words = pushed(0.17).fails().expect("10 %");
        assert!(words.contains("10.0 %") && words.contains("5 %") && words.contains("east"), "{words}");
    }

    #[test]
    fn a_second_order_moment_that_counts_is_said() {
        let pier = |second_order: Option<f64>| PierReport {
            name: "p1".to_owned(),
            periods: [1.0; 2],
            drift: 0.1,
            drift_t: 1.0,
            shear: 1e6,
            shear_t: 1.0,
            moment: 1e7,
            rotation: 0.0,
            yielded_at: Some(1.0),
            ductility: Some([2.0, 0.5]),
            residual_drift: Some([0.02, 0.0]),
            second_order,
        };
        assert_eq!(pier(Some(0.1)).second_order_counts(), None, "may be left out");
        assert_eq!(pier(None).second_order_counts(), None, "of no given height");
        let words = pier(Some(0.25)).second_order_counts().expect("a quarter");
        assert!(words.contains("p1") && words.contains("25 %"), "{words}");
        assert_eq!(pier(None).ductility_words().as_deref(), Some("2.00, 0.50"));
    }
}
