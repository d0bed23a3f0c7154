//! Studies: many runs, one question.

pub mod stability;
