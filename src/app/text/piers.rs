//! Texts on piers: the ways to give their stiffness, and their readings.

use crate::language::Text;

pub(in crate::app) const PIER_MORE: Text = Text::new("pier-more");
pub(in crate::app) const PIER_WAY: Text = Text::new("pier-way");
pub(in crate::app) const PIER_BY_STIFFNESS: Text = Text::new("pier-by-stiffness");
pub(in crate::app) const PIER_BY_FREQUENCY: Text = Text::new("pier-by-frequency");
pub(in crate::app) const PIER_BY_ROUND_COLUMNS: Text = Text::new("pier-by-round-columns");
pub(in crate::app) const PIER_BY_RECTANGULAR_COLUMNS: Text = Text::new("pier-by-rectangular-columns");
pub(in crate::app) const PIER_K_ALONG: Text = Text::new("pier-k-along");
pub(in crate::app) const PIER_K_ACROSS: Text = Text::new("pier-k-across");
pub(in crate::app) const PIER_F_ALONG: Text = Text::new("pier-f-along");
pub(in crate::app) const PIER_F_ACROSS: Text = Text::new("pier-f-across");
pub(in crate::app) const PIER_COLUMN_DIAMETER: Text = Text::new("pier-column-diameter");
pub(in crate::app) const PIER_COLUMN_ALONG: Text = Text::new("pier-column-along");
pub(in crate::app) const PIER_COLUMN_ACROSS: Text = Text::new("pier-column-across");
pub(in crate::app) const PIER_YIELD: Text = Text::new("pier-yield");
pub(in crate::app) const PIER_X: Text = Text::new("pier-x");
pub(in crate::app) const PIER_Y: Text = Text::new("pier-y");
pub(in crate::app) const PIER_CAP_ALONG: Text = Text::new("pier-cap-along");
pub(in crate::app) const PIER_CAP_ACROSS: Text = Text::new("pier-cap-across");
pub(in crate::app) const PIER_CAP_DEPTH: Text = Text::new("pier-cap-depth");
pub(in crate::app) const PIER_PERIODS: Text = Text::new("pier-periods");
pub(in crate::app) const PIER_DRIFT: Text = Text::new("pier-drift");
pub(in crate::app) const PIER_SHEAR: Text = Text::new("pier-shear");
pub(in crate::app) const PIER_YIELDS: Text = Text::new("pier-yields");
pub(in crate::app) const PIER_DUCTILITY: Text = Text::new("pier-ductility");
