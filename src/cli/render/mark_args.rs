//! Flags of `girderbench render` for a film of marks.

use crate::cli::args::{not_negative, positive};
use crate::cli::digits::six;
use crate::cli::failure::Failure;
use crate::language::said;
use crate::scene::Scene;
use crate::view::marks::diameter;

/// Pixels of the paper's camera (Table 1).
pub(super) const PAPERS_CAMERA: [u32; 2] = [720, 465];

/// Least and largest diameter of marks in parts of the usual one \[–\]. Chosen: a mark of two pixels where the usual one has eight, and a
/// quarter of the narrowest girder's width.
const DIAMETERS: [f64; 2] = [0.25, 3.0];

/// A film of marks
#[derive(Clone, Copy, Debug, clap::Args)]
pub(super) struct MarkArgs {
    /// A film from straight above of white marks on decks and table, with their layout, for `girderbench measure`
    #[arg(long, conflicts_with_all = ["at", "background", "show", "hide", "force_scale", "title", "fps"], group = "film")]
    marks: bool,
    /// Diameter of the marks [mm]; 0.08 of the narrowest girder's width when left out
    #[arg(long, value_name = "MM", value_parser = positive, requires = "marks", allow_negative_numbers = true)]
    mark_mm: Option<f64>,
    /// Pictures a second of the film of marks [Hz]
    #[arg(long, value_name = "HZ", value_parser = positive, requires = "marks", default_value_t = 30.0, allow_negative_numbers = true)]
    rate: f64,
    /// Time for which each picture of the film of marks is exposed, about its instant: what moves is blurred [ms]
    #[arg(long, value_name = "MS", value_parser = not_negative, requires = "marks", default_value_t = 0.0, allow_negative_numbers = true)]
    exposure_ms: f64,
}

impl MarkArgs {
    pub(super) fn given(self) -> bool {
        self.marks
    }

    /// Pictures a second \[Hz\].
    pub(super) fn rate(self) -> f64 {
        self.rate
    }

    /// Time of exposure \[s\]; none that is longer than the time between pictures.
    pub(super) fn exposure(self) -> Result<f64, Failure> {
        let (ms, most) = (self.exposure_ms, 1e3 / self.rate);
        if ms > most {
            let [ms, most] = [ms, most].map(six);
            return Err(Failure::Input(said!("wrong-exposure", "ms" => ms, "most" => most)));
        }
        Ok(1e-3 * ms)
    }

    /// Refuses marks that no picture shows, or that run into one another.
    ///
    /// # Errors
    /// A diameter outside of [`DIAMETERS`].
    pub(super) fn check(self, scene: &Scene) -> Result<(), Failure> {
        let [least, most] = DIAMETERS.map(|times| 1e3 * times * diameter(scene));
        match self.mark_mm {
            Some(mm) if !(least..=most).contains(&mm) => {
                let [mm, least, most] = [mm, least, most].map(six);
                Err(Failure::Input(said!("wrong-mark-mm", "mm" => mm, "least" => least, "most" => most)))
            }
            _ => Ok(()),
        }
    }

    /// Diameter of the marks, where they are drawn \[m\].
    pub(super) fn diameter(self, scene: &Scene) -> Option<f64> {
        self.marks.then(|| self.mark_mm.map_or_else(|| diameter(scene), |mm| 1e-3 * mm))
    }
}
