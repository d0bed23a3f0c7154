//! Commands about the plots.

/// How the plots are looked at.
#[derive(Clone, Debug, PartialEq)]
pub enum PlotCommand {
    /// Show these values of a chart, by its name, in its unit; all of them when none.
    Values(String, Option<[f64; 2]>),
}
