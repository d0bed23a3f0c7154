//! Length, mass and stiffness of a beam, (F3).

/// A Timoshenko beam with oblique sections in plan, uniform along its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// `a0` \[m\].
    pub length: f64,
    /// `m` \[kg\].
    pub mass: f64,
    /// `J_z`, rotary inertia of a section about the vertical per mass \[m²\].
    pub rotary: f64,
    /// `E A` \[N\].
    pub axial: f64,
    /// `E I_z` \[N·m²\].
    pub bending: f64,
    /// `k_s G A` \[N\].
    pub shear: f64,
}

impl Beam {
    /// Speed of axial waves `c = √(E A a0/m)` \[m/s\].
    pub fn wave_speed(&self) -> f64 {
        (self.axial * self.length / self.mass).sqrt()
    }

    /// Time in which an axial wave goes from end to end \[s\].
    pub fn transit_time(&self) -> f64 {
        self.length / self.wave_speed()
    }
}
