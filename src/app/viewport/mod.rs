//! The 3D view: camera, picture, mouse, handles.

pub(in crate::app) mod blit;
pub(in crate::app) mod display;
pub(in crate::app) mod eye;
pub(in crate::app) mod gizmo;
mod glide;
pub(in crate::app) mod hand;
mod looking;
pub(in crate::app) mod mouse;
mod pane;
pub(in crate::app) mod picture;
mod played_on;
pub(in crate::app) mod scene_view;
pub(in crate::app) mod screen;
pub(in crate::app) mod section;
pub(in crate::app) mod seen;
pub(in crate::app) mod show;
pub(in crate::app) mod tool;
