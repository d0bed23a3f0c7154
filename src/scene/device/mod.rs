//! Devices as placed: restrainers, bumpers, dampers and stoppers between two points of two bodies, one file each.

mod bumper;
mod damper;
mod fault;
mod joint;
mod part;
mod placing;
mod restrainer;
mod stopper;
mod table;

pub use bumper::{BUMPER, Bumper};
pub use damper::{DAMPER, Damper};
pub use fault::Fault;
pub use joint::Joint;
pub use part::{Ends, EndsMut, Part};
pub use placing::point_on;
pub use restrainer::{RESTRAINER, Restrainer};
pub use stopper::{STOPPER, Sides, Stopper};

use super::Scene;
use super::keys::Key;

/// The keys that every device begins with.
pub const ENDS: &[Key] = RESTRAINER.split_at(table::SHARED).0;

/// From one list: the kinds of devices, one device of any kind, and the devices of a scene.
macro_rules! devices {
    ($( $(#[$about:meta])* $Kind:ident in $list:ident as $word:literal, $KEYS:ident; )+) => {
        /// A kind of device.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum DeviceKind {
            $( $(#[$about])* $Kind, )+
        }

        impl DeviceKind {
            /// Every kind, in the order of the documentation.
            pub const ALL: &'static [Self] = &[$( Self::$Kind, )+];

            /// The name of its table in the file.
            pub const fn label(self) -> &'static str {
                match self { $( Self::$Kind => $word, )+ }
            }

            /// The keys of its table.
            pub const fn keys(self) -> &'static [Key] {
                match self { $( Self::$Kind => $KEYS, )+ }
            }
        }

        /// A device.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Device {
            $( $(#[$about])* $Kind($Kind), )+
        }

        impl Device {
            /// Its kind.
            pub fn kind(&self) -> DeviceKind {
                match self { $( Self::$Kind(_) => DeviceKind::$Kind, )+ }
            }

            /// Properties common to all devices.
            pub fn part(&self) -> &dyn Part {
                match self { $( Self::$Kind(one) => one, )+ }
            }

            /// The same, to be changed.
            pub fn part_mut(&mut self) -> &mut dyn Part {
                match self { $( Self::$Kind(one) => one, )+ }
            }
        }

        impl Scene {
            /// Devices, kind by kind in the order of the file.
            pub fn devices(&self) -> Vec<(DeviceId, &dyn Part)> {
                let mut all: Vec<(DeviceId, &dyn Part)> = Vec::new();
                $(
                    let own = self.$list.iter().enumerate();
                    all.extend(own.map(|(number, one)| (DeviceId { kind: DeviceKind::$Kind, number }, one as &dyn Part)));
                )+
                all
            }

            /// Devices, to be changed.
            pub fn devices_mut(&mut self) -> Vec<&mut dyn Part> {
                let mut all: Vec<&mut dyn Part> = Vec::new();
                $( all.extend(self.$list.iter_mut().map(|one| one as &mut dyn Part)); )+
                all
            }

            /// The device of this number, whole.
            pub fn device(&self, id: DeviceId) -> Option<Device> {
                match id.kind { $( DeviceKind::$Kind => self.$list.get(id.number).cloned().map(Device::$Kind), )+ }
            }

            /// Number of devices of a kind.
            pub fn count_of(&self, kind: DeviceKind) -> usize {
                match kind { $( DeviceKind::$Kind => self.$list.len(), )+ }
            }

            /// Puts a device in at a number of its kind, up to their count; any larger one is the last.
            pub fn insert_device(&mut self, at: usize, device: Device) {
                match device { $( Device::$Kind(one) => self.$list.insert(at.min(self.$list.len()), one), )+ }
            }

            /// Takes a device out.
            pub fn remove_device(&mut self, id: DeviceId) -> Option<Device> {
                match id.kind {
                    $( DeviceKind::$Kind => (id.number < self.$list.len()).then(|| Device::$Kind(self.$list.remove(id.number))), )+
                }
            }

            /// Keeps the devices that a rule holds for.
            pub fn retain_devices(&mut self, keep: impl Fn(&dyn Part) -> bool) {
                $( self.$list.retain(|one| keep(one)); )+
            }
        }
    };
}

devices! {
    /// A cable.
    Restrainer in restrainers as "restrainer", RESTRAINER;
    /// A bumper or shock absorber.
    Bumper in bumpers as "bumper", BUMPER;
    /// A viscous damper.
    Damper in dampers as "damper", DAMPER;
    /// A shear key or stopper.
    Stopper in stoppers as "stopper", STOPPER;
}

/// A device of a scene, by its kind and its number among those.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DeviceId {
    /// Its kind.
    pub kind: DeviceKind,
    /// Its number in the file.
    pub number: usize,
}
