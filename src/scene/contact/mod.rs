//! Contact numbers of a scene, and overrides for named pairs.

mod tables;

use crate::geometry::End;
use crate::scene::keys::{Fallback, Range, Slot, Stands, Word, words};
use tables::contact_tables;

pub use crate::contact::FrictionLaw;

impl FrictionLaw {
    /// The default as the table of keys has it.
    pub(in crate::scene) const FALLBACK: Fallback = Fallback::Word(Self::DEFAULT.label());
}

impl Stands for FrictionLaw {
    fn by_default(_: Fallback) -> Self {
        Self::DEFAULT
    }

    fn slot(&mut self) -> Slot<'_> {
        Slot::Word(Word::new(self, (Self::ALL, Self::WORDS), Self::DEFAULT))
    }

    fn optional_slot(value: &mut Option<Self>) -> Slot<'_> {
        Slot::Word(Word::optional(value, (Self::ALL, Self::WORDS)))
    }
}

words! {
    /// How the stiffness of a facing pair is shared between its nodes.
    Sharing, by default Tributary {
        /// K and C divided by the number of declared nodes inside the facing polygon when the pair first closes.
        Tributary = "tributary",
        /// Each node has the whole K and C.
        PerNode = "per-node",
    }
}

words! {
    /// Whether a contact may pull just before it opens.
    Tension, by default Keep {
        /// The dashpot may pull; restitution is exact.
        Keep = "keep",
        /// The normal force is held at 0 or above.
        Clamp = "clamp",
    }
}

words! {
    /// Which faces of the bodies of a scene can touch under the contact model.
    Between, by default All {
        /// Any face of any two bodies that come near.
        All = "all",
        /// Facing ends and declared pairs alone, as in the paper (Fig. 24).
        Ends = "ends",
    }
}

/// `E` where neither `K` nor `E` is given: ordinary concrete \[Pa\].
pub const DEFAULT_YOUNG_MODULUS: f64 = 30e9;

// A number or a rule of contact is stated here and nowhere else: the two tables, their keys, defaults and ranges, what
// lies over what, the numbers in force for a pair and the rows of the inspector follow.
contact_tables! {
    elasticity {
        stiffness = "stiffness_n_per_m" as "K", Range::Positive, Fallback::Words("E A / L"),
            "K of a pair (54), N/m; not together with the next two";
        young_modulus = "young_modulus_pa" as "E", Range::Positive, Fallback::Number(DEFAULT_YOUNG_MODULUS),
            "E of K = E A / L (64), Pa; of two girders the smaller K counts";
        area = "area_m2" as "A", Range::Positive, Fallback::Words("width × thickness of the girder"), "A of (64), m²";
    }
    numbers {
        restitution_normal = "restitution_normal" as "e normal", Range::Within([0.01, 1.0]), 0.4, "e_n; 1 is no dashpot (65)",
            slider [0.01, 1.0];
        restitution_tangential = "restitution_tangential" as "e tangential", Range::Within([0.01, 1.0]), 0.9,
            "e_t; 1 is no dashpot (65)", slider [0.01, 1.0];
        mu_static = "mu_static" as "μ static", Range::NotBelow("mu_kinetic"), 0.20, "μ_s", slider [0.0, 1.0];
        mu_kinetic = "mu_kinetic" as "μ kinetic", Range::NotNegative, 0.15, "μ_k", slider [0.0, 1.0];
    }
    rules {
        law: FrictionLaw = "law" as "Friction law",
            "friction: the paper's law taken literally, or elastic-plastic Coulomb, which holds a static load";
        sharing: Sharing = "sharing" as "Sharing",
            "K and C divided by the nodes that face the other end when the pair closes, or whole for each node";
        tension: Tension = "tension" as "Tension",
            "whether the dashpot may pull just before a contact opens, or the normal force is held at 0";
    }
}
