//! How the plots are looked at: which values of each chart are shown.

use std::collections::BTreeMap;

use crate::app::command::PlotCommand;

/// Values shown of charts, by their names; of others all.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlotViews {
    values: BTreeMap<String, [f64; 2]>,
}

impl PlotViews {
    /// Does a command.
    pub(in crate::app) fn apply(&mut self, command: PlotCommand) {
        match command {
            PlotCommand::Values(name, Some(range)) if range[0] < range[1] => {
                self.values.insert(name, range);
            }
            PlotCommand::Values(name, _) => {
                self.values.remove(&name);
            }
        }
    }

    /// Values that are shown of a chart over time, least and greatest, in its unit; all of them when `None`.
    pub fn values(&self, name: &str) -> Option<[f64; 2]> {
        self.values.get(name).copied()
    }
}
