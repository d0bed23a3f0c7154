//! An abutment as placed: a fixed backwall before the end of a girder.

use serde::{Deserialize, Serialize};

use crate::geometry::End;

/// A fixed backwall: either it faces the end of a girder, or its face is given as a polygon.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Abutment {
    /// Its name, unique in the scene.
    pub name: String,
    /// The girder that it stands before.
    pub faces: String,
    /// The end that it stands before.
    #[serde(default = "plus")]
    pub end: End,
    /// Distance to that end as placed, along the girder's axis; not with `polygon_m` \[m\].
    #[serde(rename = "gap_m", default, skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// Extent along the face; not with `polygon_m` \[m\]. Default: three times the girder's end.
    #[serde(rename = "width_m", default, skip_serializing_if = "Option::is_none")]
    pub width: Option<f64>,
    /// Height of the face, about the mid-depth of the girder; not with `polygon_m` \[m\]. Default: three times the
    /// girder's thickness.
    #[serde(rename = "height_m", default, skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
    /// Sideways shift of the face's centre from the girder's, along the face \[m\].
    #[serde(rename = "offset_m", default, skip_serializing_if = "Option::is_none")]
    pub offset: Option<f64>,
    /// Four corners of the face in the world, anticlockwise seen from the girder \[m\].
    #[serde(rename = "polygon_m", default, skip_serializing_if = "Option::is_none")]
    pub polygon: Option<Vec<[f64; 3]>>,
    /// How far the abutment reaches behind its face \[m\]. Default: the girder's length.
    #[serde(rename = "depth_m", default, skip_serializing_if = "Option::is_none")]
    pub depth: Option<f64>,
}

fn plus() -> End {
    End::Plus
}
