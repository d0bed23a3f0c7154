//! A beam that bends in plan and upwards and twists.

use glam::DMat3;

use super::beam::Beam;

/// A beam in space, uniform along its axis, with oblique sections in plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpaceBeam {
    /// Length, mass, and its stiffness along the axis and in plan.
    pub plan: Beam,
    /// J, rotary inertia of a section per mass \[m²\]: of the offsets `(Y cot β, Y, Z)`, so that ψ and `φ_y` are coupled where the
    /// sections are oblique.
    pub rotary: DMat3,
    /// `E I_y` \[N·m²\].
    pub bending: f64,
    /// `k_s G A` of vertical shear \[N\].
    pub shear: f64,
    /// `G J_t` of Saint-Venant's torsion \[N·m²\].
    pub torsion: f64,
}

impl SpaceBeam {
    /// J of sections of this width and thickness \[m\], oblique by `cot` = cot β.
    pub fn rotary_of(width: f64, thickness: f64, cot: f64) -> DMat3 {
        let [y2, z2] = [width, thickness].map(|side| side * side / 12.0);
        let (x2, xy) = (y2 * cot * cot, y2 * cot);
        DMat3::from_cols_array(&[y2 + z2, -xy, 0.0, -xy, x2 + z2, 0.0, 0.0, 0.0, x2 + y2])
    }
}
