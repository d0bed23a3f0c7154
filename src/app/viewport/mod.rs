//! The 3D view: camera, picture, mouse, handles.

pub(in crate::app) mod blit;
pub(in crate::app) mod gizmo;
pub(in crate::app) mod mouse;
pub(in crate::app) mod screen;
pub(in crate::app) mod tool;
pub(in crate::app) mod view;
pub(in crate::app) mod view_options;
