//! The paper's experiment: every case of Tables 2 and 3 under both models, its figures redrawn, its findings checked.

mod cases;
mod earthquake;
pub mod findings;
mod observe;
pub mod report;
mod results;
mod scan;
mod states;
mod unit;

pub use cases::{Case, Shaking, Specimen};
pub use earthquake::Earthquake;
pub use observe::{FRAME, GirderSeen, HitSeen, Observed};
pub use results::{CaseResult, MODELS, Results, ScanResult, SeriesResult};
pub use states::Stretch;
pub use unit::Unit;
