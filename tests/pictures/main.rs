//! Pictures: draw lists, which need no feature; what is drawn of them and at what cost (`render`); shaders (`ui-tests`).

mod draw_lists;
mod handmade;

#[cfg(feature = "render")]
mod blessed;
#[cfg(feature = "render")]
mod gauge;
#[cfg(feature = "render")]
mod golden;
#[cfg(feature = "render")]
mod labels;
#[cfg(feature = "render")]
#[path = "../support/row.rs"]
mod row;
#[cfg(feature = "render")]
mod studio;
#[cfg(feature = "render")]
mod work;

#[cfg(feature = "ui-tests")]
mod shaders;
