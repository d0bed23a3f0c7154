//! Solver and view settings of a scene.

use serde::{Deserialize, Serialize};

pub(super) fn format_version() -> u32 {
    1
}

pub(super) fn standard_gravity() -> f64 {
    super::STANDARD_GRAVITY
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]
pub(super) fn is_standard_gravity(g: &f64) -> bool {
    *g == super::STANDARD_GRAVITY
}

pub(super) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// How a run is integrated between events.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SolverMethod {
    /// Closed-form flight where it exists, Dormand–Prince 8(5,3) with dense output elsewhere, every event root-found.
    #[default]
    EventDriven,
}

/// `[solver]`: how exactly a run is computed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SolverSettings {
    /// Local error per step, relative to the motion in hand, in \[1e-13, 1e-2\].
    pub tolerance: f64,
    /// The integrator.
    pub method: SolverMethod,
}

impl Default for SolverSettings {
    fn default() -> Self {
        Self { tolerance: 1e-10, method: SolverMethod::EventDriven }
    }
}

/// A standing place for the camera.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ViewPreset {
    /// From above and one side.
    #[default]
    Iso,
    /// Straight from above, orthographic.
    Top,
    /// Square to the bridge axis, from −y.
    Side,
    /// Close to the hardest hit.
    Contact,
}

/// Which layers the view draws over the bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[expect(clippy::struct_excessive_bools, reason = "each is an independent switch a user sets")]
pub struct Overlays {
    /// Ground grid.
    pub grid: bool,
    /// Bearings.
    pub bearings: bool,
    /// Gap dimension at each facing pair.
    pub gap: bool,
    /// Contact points with their state.
    pub contacts: bool,
    /// Normal force arrows (K δ).
    pub normal: bool,
    /// Tangential force arrows (friction or tangential spring).
    pub tangential: bool,
    /// Resultant arrows (without dashpots).
    pub resultant: bool,
    /// Dashpot force arrows.
    pub damping: bool,
    /// Friction cones.
    pub cones: bool,
    /// World axes.
    pub axes: bool,
    /// Legend: force scale, states, cone.
    pub legend: bool,
    /// Title and time stamp.
    pub title: bool,
    /// Names at the bodies.
    pub names: bool,
}

impl Default for Overlays {
    fn default() -> Self {
        Self {
            grid: true,
            bearings: true,
            gap: true,
            contacts: true,
            normal: false,
            tangential: false,
            resultant: true,
            damping: false,
            cones: true,
            axes: true,
            legend: true,
            title: true,
            names: true,
        }
    }
}

/// `[[view.plot]]`: a plot panel.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlotSettings {
    /// Against what: the name of a quantity; against time when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x: Option<String>,
    /// Names of the quantities that are drawn, all of one unit.
    pub y: Vec<String>,
}

/// `[view]`: how the scene is first shown.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ViewSettings {
    /// Where the camera stands first.
    pub camera: ViewPreset,
    /// Layers.
    #[serde(skip_serializing_if = "is_default")]
    pub overlays: Overlays,
    /// Force scale of the arrows \[N per m\]; from the run's peak when absent.
    #[serde(rename = "force_scale_n_per_m", skip_serializing_if = "Option::is_none")]
    pub force_scale: Option<f64>,
    /// Plot panels beside the standing ones.
    #[serde(rename = "plot", skip_serializing_if = "Vec::is_empty")]
    pub plots: Vec<PlotSettings>,
}
