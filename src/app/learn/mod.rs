//! Lessons: scenes with words and things to try.

pub(in crate::app) mod lesson_panel;
pub(in crate::app) mod lessons;
