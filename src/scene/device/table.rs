//! The table of a device, made from the keys of its two points and its own.

/// Number of the keys that every device begins with: its name, its two bodies, its two points.
pub(super) const SHARED: usize = 5;

/// States the table of a device: the keys of its two points before those of its law.
macro_rules! device_table {
    (
        $(#[$meta:meta])*
        struct $Name:ident, $KEYS:ident { $($rows:tt)+ }
    ) => {
        $crate::scene::keys::table! {
            $(#[$meta])*
            #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
            struct $Name, $KEYS {
                name: String = "name", Range::Like("unique"), Fallback::Needed("must be given"), "its name";
                girder: String = "girder", Range::Like("a girder"), Fallback::Needed("must be given"),
                    "the girder that its first point is on";
                to: Option<String> = "to", Range::Like("another girder, or an abutment"), Fallback::Words("the ground"),
                    "the body that its second point is on";
                #[serde(with = "crate::scene::two_or_three")]
                at: [f64; 3] = "at_m" as "field-at", Range::Like("two or three numbers"), Fallback::Needed("must be given"),
                    "its first point from the girder's G: along, across and up in its frame, m";
                #[serde(default, with = "crate::scene::two_or_three::optional")]
                to_at: Option<[f64; 3]> = "to_m" as "field-to", Range::Like("two or three numbers"),
                    Fallback::Words("where at_m is as placed"),
                    "its second point: of a girder from its G in its frame; of an abutment from the centre of its face, out of the \
                     face, along it to the right as seen from before it, and up; of the ground in the world, m";
                $($rows)+
            }
        }

        impl $crate::scene::device::Part for $Name {
            fn ends(&self) -> $crate::scene::device::Ends<'_> {
                $crate::scene::device::Ends {
                    name: &self.name,
                    girder: &self.girder,
                    to: self.to.as_deref(),
                    at: self.at,
                    to_at: self.to_at,
                }
            }

            fn ends_mut(&mut self) -> $crate::scene::device::EndsMut<'_> {
                $crate::scene::device::EndsMut {
                    name: &mut self.name,
                    girder: &mut self.girder,
                    to: &mut self.to,
                    at: &mut self.at,
                    to_at: &mut self.to_at,
                }
            }

            fn faults(&self, joint: Option<&$crate::scene::device::Joint>) -> Vec<$crate::scene::device::Fault> {
                self.own_faults(joint)
            }
        }
    };
}

pub(super) use device_table;
