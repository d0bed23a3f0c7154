//! Properties common to all devices: a name, two bodies, two points.

use super::fault::Fault;
use super::joint::Joint;

/// The two points of a device, as a file has them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ends<'a> {
    /// Its name.
    pub name: &'a str,
    /// The girder of its first point.
    pub girder: &'a str,
    /// The girder or abutment of its second point; the ground without.
    pub to: Option<&'a str>,
    /// Its first point in the girder's frame \[m\].
    pub at: [f64; 3],
    /// Its second point in the frame of what it is on \[m\]; where the first one is as placed without.
    pub to_at: Option<[f64; 3]>,
}

/// The same, to be changed.
#[derive(Debug)]
pub struct EndsMut<'a> {
    /// Its name.
    pub name: &'a mut String,
    /// The girder of its first point.
    pub girder: &'a mut String,
    /// The girder or abutment of its second point; the ground without.
    pub to: &'a mut Option<String>,
    /// Its first point in the girder's frame \[m\].
    pub at: &'a mut [f64; 3],
    /// Its second point in the frame of what it is on \[m\].
    pub to_at: &'a mut Option<[f64; 3]>,
}

/// A device of any kind.
pub trait Part: std::fmt::Debug {
    /// Its two points.
    fn ends(&self) -> Ends<'_>;

    /// The same, to be changed.
    fn ends_mut(&mut self) -> EndsMut<'_>;

    /// Faults beyond the ranges of its keys; those of its points once these are known.
    fn faults(&self, joint: Option<&Joint>) -> Vec<Fault>;
}
