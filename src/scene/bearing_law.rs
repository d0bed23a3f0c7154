//! Yield of a bearing and friction of a slider, with everything filled in.

/// Yield of a bearing: a spring `Q/u_y` beside its own up to the force Q.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingYield {
    /// Q \[N\].
    pub force: f64,
    /// `u_y` \[m\].
    pub displacement: f64,
    /// Whether each axis yields for itself; otherwise on one circle.
    pub per_axis: bool,
}

impl BearingYield {
    /// k₁ − k₂ \[N/m\].
    pub fn stiffness(&self) -> f64 {
        self.force / self.displacement
    }
}

/// Displacement at which the friction of a slider is fully there: a regularisation, full scale \[m\].
pub(super) const SLIDER_DISPLACEMENT: f64 = 5e-4;

/// A slider, flat or in a dish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingSlide {
    /// μ \[–\].
    pub friction: f64,
    /// 1/R; 0 of a flat slider \[1/m\].
    pub curvature: f64,
    /// `u_y` \[m\].
    pub displacement: f64,
    /// N at rest \[N\].
    pub load: f64,
}

impl BearingSlide {
    /// Under a constant load: Q = μN up to `u_y`, on one circle.
    pub fn yielding(&self) -> BearingYield {
        BearingYield { force: self.friction * self.load, displacement: self.displacement, per_axis: false }
    }

    /// N/R \[N/m\].
    pub fn restoring(&self) -> f64 {
        self.load * self.curvature
    }
}
