//! The entries of the energy ledger (`docs/physics.md#energy-ledger`).

/// Energy at one instant, and where it went since t = 0 (`docs/physics.md#energy-ledger`) \[J\].
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Ledger {
    /// Kinetic energy, relative to the ground.
    pub kinetic: f64,
    /// Stored in the bearings.
    pub bearing: f64,
    /// Potential of gravity, relative to the placed pose (spatial).
    pub gravity: f64,
    /// Strain energy of the contacts.
    pub contact: f64,
    /// Energy stored in devices, the soil behind backwalls and the bases of piers that yield.
    #[serde(skip_serializing_if = "is_zero")]
    pub device: f64,
    /// Strain energy of elastic girders.
    #[serde(skip_serializing_if = "is_zero")]
    pub girder: f64,
    /// Work of the ground: of inertia forces, and of supports that move against the ground of reference.
    pub work_ground: f64,
    /// Work of given pushes.
    pub work_push: f64,
    /// Lost in the bearings: in dashpots, in yield, in sliding.
    pub loss_bearing: f64,
    /// Lost in elastic girders.
    #[serde(skip_serializing_if = "is_zero")]
    pub loss_girder: f64,
    /// Lost in the normal dashpots of contacts.
    pub loss_normal: f64,
    /// Lost in the tangential dashpots of contacts.
    pub loss_tangential: f64,
    /// Lost in friction.
    pub loss_friction: f64,
    /// Lost in hits (impact model).
    pub loss_hits: f64,
    /// Lost in devices.
    #[serde(skip_serializing_if = "is_zero")]
    pub loss_device: f64,
    /// Released by jumps of the anchor at breakaway and re-stick.
    pub jump_slip: f64,
    /// Released at opening.
    pub jump_open: f64,
    /// Released over an edge of the face.
    pub jump_edge: f64,
    /// Released by changes of a device's phase.
    #[serde(skip_serializing_if = "is_zero")]
    pub jump_device: f64,
    /// Brought in by a start or an entry with overlap (negative: energy that appeared).
    pub jump_entry: f64,
    /// Residual of the balance: stored + lost + released − worked − initial \[J\]. 0 but for rounding and integration error.
    pub residual: f64,
    /// Largest energy in play, to compare the residual with.
    pub scale: f64,
}

impl Ledger {
    /// Kinetic and stored energy \[J\].
    pub fn stored(&self) -> f64 {
        self.kinetic + self.bearing + self.girder + self.gravity + self.contact + self.device
    }

    /// Lost since t = 0 \[J\].
    pub fn lost(&self) -> f64 {
        self.loss_bearing
            + self.loss_girder
            + self.loss_normal
            + self.loss_tangential
            + self.loss_friction
            + self.loss_hits
            + self.loss_device
    }

    /// Released at changes of contacts and devices since t = 0 \[J\].
    pub fn released(&self) -> f64 {
        self.jump_slip + self.jump_open + self.jump_edge + self.jump_entry + self.jump_device
    }

    /// Energy at t = 0 \[J\].
    pub fn initial(&self) -> f64 {
        self.stored() + self.lost() + self.released() - self.work_ground - self.work_push - self.residual
    }
}

/// Whether a scene without devices, or without elastic girders, leaves it out.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(energy: &f64) -> bool {
    *energy == 0.0
}
