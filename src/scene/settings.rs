//! Solver and view settings of a scene.

use serde::{Deserialize, Serialize};

use super::keys::{Fallback, Range, table, words};

words! {
    /// Method of integration between events.
    SolverMethod, by default EventDriven {
        /// Closed-form flight where it exists, Dormand–Prince 8(5,3) with dense output elsewhere, every event
        /// root-found.
        EventDriven = "event-driven",
    }
}

/// Finest tolerance that a scene can ask for \[–\]: below, errors of steps with contact are round-off.
pub const FINEST_TOLERANCE: f64 = 1e-13;

table! {
    /// `[solver]`: how exactly a run is computed.
    #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
    default struct SolverSettings, SOLVER {
        tolerance: f64 = "tolerance" as "field-tolerance", Range::Within([FINEST_TOLERANCE, 0.01]), Fallback::Number(1e-10),
            "local error a step, relative to the motion in hand";
        method: SolverMethod = "method" as "field-method", Range::Words(SolverMethod::WORDS), SolverMethod::FALLBACK,
            "closed-form flight where it exists, elsewhere an embedded pair of order 8 or, where contacts are stiff, Radau IIA of five stages; every event root-found";
    }
}

words! {
    /// A standing place for the camera.
    ViewPreset, by default Iso {
        /// From above and one side.
        Iso = "iso",
        /// Straight from above, orthographic.
        Top = "top",
        /// Square to the bridge axis, from −y.
        Side = "side",
        /// Close to the hardest hit.
        Contact = "contact",
    }
}

words! {
    /// Representation of a plot panel's quantities.
    PlotShows, by default History {
        /// Their course over time, or over another quantity.
        History = "history",
        /// Fourier amplitudes over frequency.
        Fourier = "fourier",
        /// 5 % response spectrum over period.
        Response = "response",
    }
}

table! {
    /// `[[view.plot]]`: a plot panel.
    #[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
    struct PlotSettings, PLOT {
        y: Vec<String> = "y", Range::Like("names of quantities of one unit"), Fallback::Needed("must be given"),
            "what is drawn; only energies against time: one upon the other";
        x: Option<String> = "x", Range::Like("the name of a quantity"), Fallback::Words("time"),
            "what it is drawn against";
        #[serde(default)]
        shows: PlotShows = "shows" as "field-shows", Range::Words(PlotShows::WORDS), PlotShows::FALLBACK,
            "their course, their Fourier amplitudes over frequency, or their 5 % response spectrum over period";
        #[serde(default)]
        log: bool = "log" as "field-logarithmic", Range::Switch, Fallback::Switch(false),
            "whether the upright axis is logarithmic, of the magnitude; of spectra both axes";
    }
}

impl PlotSettings {
    /// Curves of these quantities over time.
    pub fn over_time(y: Vec<String>) -> Self {
        Self { y, ..Self::default() }
    }
}

table! {
    /// `[view]`: how the scene is first shown.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    default struct ViewSettings, VIEW {
        camera: ViewPreset = "camera", Range::Words(ViewPreset::WORDS), ViewPreset::FALLBACK,
            "where the camera stands first";
        overlays: Overlays = "overlays", Range::Free, Fallback::Words("as below"), "[view.overlays]";
        force_scale: Option<f64> = "force_scale_n_per_m", Range::Positive, Fallback::Words("from the run's peak"),
            "scale of the force arrows, N per metre";
        plots: Vec<PlotSettings> = "plot", Range::Free, Fallback::Words("none"), "[[view.plot]]";
    }
}

/// A layer that the view draws over the bodies.
#[derive(Clone, Copy, Debug)]
pub struct Layer {
    /// Its key.
    pub key: &'static str,
    /// The text that says what its switch in the window is called.
    pub label: &'static str,
    /// Its switch.
    pub switch: fn(&mut Overlays) -> &mut bool,
}

/// States the layers of the view: one line a switch.
macro_rules! overlays {
    ($( $layer:ident = $key:literal, $label:literal, $on:literal, $meaning:literal; )+) => {
        table! {
            /// Layers that the view draws over the bodies.
            #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
            default struct Overlays, OVERLAYS {
                $( $layer: bool = $key as $label, Range::Switch, Fallback::Switch($on), $meaning; )+
            }
        }

        impl Overlays {
            /// Every layer, in the order of the documentation.
            pub const ALL: &'static [Layer] =
                &[$( Layer { key: $key, label: $label, switch: |overlays| &mut overlays.$layer }, )+];
        }
    };
}

overlays! {
    grid = "grid", "layer-grid", true, "ground grid";
    bearings = "bearings", "layer-bearings", true, "bearings";
    gap = "gap", "layer-gap", true, "gap of each facing pair";
    contacts = "contacts", "layer-contacts", true, "contact points with their state";
    normal = "normal", "layer-normal", false, "arrows of the normal force";
    tangential = "tangential", "layer-tangential", false, "arrows of the tangential force";
    resultant = "resultant", "layer-resultant", true, "arrows of the resultant, dashpots left out";
    damping = "damping", "layer-damping", false, "arrows of the dashpots";
    cones = "cones", "layer-cones", true, "friction cones";
    axes = "axes", "layer-axes", true, "world axes";
    legend = "legend", "layer-legend", true, "force scale, states, cone";
    title = "title", "layer-title", true, "title and time";
    names = "names", "layer-names", true, "names at the bodies";
    decoration = "decoration", "layer-decoration", true,
        "of decks of 2 m and longer what is drawn and not computed: section, parapets, seats, wing walls, embankment";
}
