//! Entries of the energy ledger as quantities: `energy.friction`.

use crate::sim::History;

/// A quantity of the energy ledger (`docs/physics.md#energy-ledger`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfEnergy {
    /// Kinetic.
    Kinetic,
    /// Strain of the bearings.
    Bearings,
    /// Strain of elastic girders.
    Girders,
    /// Strain of the contacts.
    Contacts,
    /// Stored in devices.
    Devices,
    /// Potential of gravity.
    Gravity,
    /// Work of the ground and of pushes.
    Work,
    /// Lost in the bearings: dashpots, yield, sliding.
    LostBearings,
    /// Lost in elastic girders.
    LostGirders,
    /// Lost in the contacts' dashpots and hits.
    LostContacts,
    /// Lost in devices, and released where their phases change.
    LostDevices,
    /// Lost in friction.
    Friction,
    /// Residual of the balance.
    Residual,
}

const OF_ENERGY: [(&str, OfEnergy); 13] = [
    ("kinetic", OfEnergy::Kinetic),
    ("bearings", OfEnergy::Bearings),
    ("girders", OfEnergy::Girders),
    ("contacts", OfEnergy::Contacts),
    ("devices", OfEnergy::Devices),
    ("gravity", OfEnergy::Gravity),
    ("work", OfEnergy::Work),
    ("lost-bearings", OfEnergy::LostBearings),
    ("lost-girders", OfEnergy::LostGirders),
    ("lost-contacts", OfEnergy::LostContacts),
    ("lost-devices", OfEnergy::LostDevices),
    ("friction", OfEnergy::Friction),
    ("residual", OfEnergy::Residual),
];

/// Every entry that the run has, with its name.
pub(in crate::sim) fn named(history: &History) -> impl Iterator<Item = (&'static str, OfEnergy)> + use<> {
    let model = history.model();
    let has_devices = model.links.iter().any(|link| !link.device.is_linear());
    let bends = (0..model.girders().len()).any(|girder| history.sections().flexible(girder).is_some());
    let has = move |what: OfEnergy| match what {
        OfEnergy::Devices | OfEnergy::LostDevices => has_devices,
        OfEnergy::Girders | OfEnergy::LostGirders => bends,
        _ => true,
    };
    OF_ENERGY.into_iter().filter(move |(_, what)| has(*what))
}

/// An entry at `t` \[J\].
pub(in crate::sim) fn at(history: &History, what: OfEnergy, t: f64) -> f64 {
    let e = history.energy().ledger(t);
    match what {
        OfEnergy::Kinetic => e.kinetic,
        OfEnergy::Bearings => e.bearing,
        OfEnergy::Girders => e.girder,
        OfEnergy::Contacts => e.contact,
        OfEnergy::Devices => e.device,
        OfEnergy::Gravity => e.gravity,
        OfEnergy::Work => e.work_ground + e.work_push,
        OfEnergy::LostBearings => e.loss_bearing,
        OfEnergy::LostGirders => e.loss_girder,
        OfEnergy::LostContacts => e.loss_normal + e.loss_tangential + e.loss_hits,
        OfEnergy::LostDevices => e.loss_device + e.jump_device,
        OfEnergy::Friction => e.loss_friction,
        OfEnergy::Residual => e.residual,
    }
}
