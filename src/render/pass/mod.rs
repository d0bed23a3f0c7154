//! Passes, one file each, each with the shader of the same stem.

pub(super) mod arrow;
pub(super) mod backdrop;
pub(super) mod cone;
pub(super) mod far;
pub(super) mod ground;
pub(super) mod line;
pub(super) mod overlay;
pub(super) mod shadow;
pub(super) mod solid;

/// Every pass's shader as it is compiled, by the stem of its file.
pub fn shaders() -> [(&'static str, &'static str); 9] {
    [
        ("arrow", arrow::SHADER),
        ("backdrop", backdrop::SHADER),
        ("cone", cone::SHADER),
        ("far", far::SHADER),
        ("ground", ground::SHADER),
        ("line", line::SHADER),
        ("overlay", overlay::SHADER),
        ("shadow", shadow::SHADER),
        ("solid", solid::SHADER),
    ]
}
