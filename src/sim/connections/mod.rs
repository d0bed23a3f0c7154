//! Bearings, devices, soil and piers: state and force at any instant, loops, and what a run did to them.

pub mod backfill;
pub mod bearing_quantities;
pub mod bearing_readings;
pub mod device_readings;
pub mod hysteresis;
pub mod link;
pub mod piers;
pub mod view;
