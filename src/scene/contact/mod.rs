//! Contact numbers of a scene, and overrides for named pairs.

mod tables;

use crate::contact::{NormalLaw, PairNumbers, law_of_pair};
use crate::geometry::End;
use crate::scene::concrete::CONCRETE_MODULUS;
use crate::scene::keys::{Fallback, Range, Slot, Stands, Word, words};
use tables::contact_tables;

pub use crate::contact::{Calibration, FrictionLaw, NormalName};

/// Makes an enumeration of the contact laws a value of the scene.
macro_rules! law_words {
    ($($Name:ident),+) => {
        $(
            impl $Name {
                /// The default as the table of keys has it.
                pub(in crate::scene) const FALLBACK: Fallback = Fallback::Word(Self::DEFAULT.label());
            }

            impl Stands for $Name {
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
        )+
    };
}

law_words!(FrictionLaw, NormalName, Calibration);

words! {
    /// Division of a facing pair's stiffness among its nodes.
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
    /// Faces of the bodies of a scene that can touch under the contact model.
    Between, by default All {
        /// Any face of any two bodies that come near.
        All = "all",
        /// Facing ends and declared pairs alone, as in the paper (Fig. 24).
        Ends = "ends",
    }
}

/// Least coefficient of restitution: at 0, critical damping, a free contact never opens again \[–\].
pub(in crate::scene) const LEAST_RESTITUTION: f64 = 0.01;

// A number or a rule of contact is stated here and nowhere else: the two tables, their keys, defaults and ranges, what
// lies over what, the numbers in force for a pair and the rows of the inspector follow.
contact_tables! {
    elasticity {
        stiffness = "stiffness_n_per_m" as "field-contact-k", Range::Positive, Fallback::Words("E A / L"),
            "K of a pair (54), N/m; not together with the next three";
        young_modulus = "young_modulus_pa" as "field-contact-e", Range::Positive, Fallback::Number(CONCRETE_MODULUS),
            "E of K = E A / L (64), Pa, of a girder that bends its own; of two girders the smaller K counts";
        area = "area_m2" as "field-contact-a", Range::Positive, Fallback::Words("width × thickness of the girder"), "A of (64), m², of a girder that bends its own";
        contact_length = "contact_length_m" as "field-contact-l", Range::Positive,
            Fallback::Words("a₀; a₀/10 if elastic"), "L of K = E A / L (64), m; a₀ is the length of the girder";
    }
    given {
        hertz_stiffness = "hertz_stiffness_n_per_m1_5" as "field-hertz-k", Range::Positive, Fallback::Words("from K at the design speed"),
            "k_h of a Hertz spring, N/m^1.5; without stiffness_n_per_m, K of the tangential spring then follows from it";
        law_parameter = "law_parameter" as "field-law-parameter", Range::NotNegative, Fallback::Words("from restitution_normal"),
            "damping ratio ζ of kelvin-voigt and approach, ξ of hertz-viscous and jankowski, a of hertz-damp";
    }
    numbers {
        restitution_normal = "restitution_normal" as "field-e-normal", Range::Within([LEAST_RESTITUTION, 1.0]), 0.4, "e_n; 1 is no dashpot (65)",
            slider [LEAST_RESTITUTION, 1.0];
        restitution_tangential = "restitution_tangential" as "field-e-tangential", Range::Within([LEAST_RESTITUTION, 1.0]), 0.9,
            "e_t; 1 is no dashpot (65)", slider [LEAST_RESTITUTION, 1.0];
        mu_static = "mu_static" as "field-mu-static", Range::NotBelow("mu_kinetic"), 0.20, "μ_s", slider [0.0, 1.0];
        mu_kinetic = "mu_kinetic" as "field-mu-kinetic", Range::NotNegative, 0.15, "μ_k", slider [0.0, 1.0];
        design_speed = "design_speed_m_s" as "field-design-speed", Range::Positive, 0.3,
            "impact speed at which a Hertz spring is as deep as K, and at which bilinear returns e_n", slider [0.01, 2.0];
    }
    rules {
        normal_law: NormalName = "normal_law" as "field-normal-law", "force against penetration: see docs/physics.md";
        calibration: Calibration = "calibration" as "field-calibration",
            "parameter of the normal law from e_n: so that a head-on hit returns e_n, or by the formula in print; by-law is \
             published for kelvin-voigt, (65), and exact for the others";
        law: FrictionLaw = "law" as "field-friction-law",
            "friction: the paper's law taken literally, or elastic-plastic Coulomb, which holds a static load";
        sharing: Sharing = "sharing" as "field-sharing",
            "K and C divided by the nodes that face the other end when the pair closes, or whole for each node";
        tension: Tension = "tension" as "field-tension",
            "whether the dashpot may pull just before a contact opens, or the normal force is held at 0";
    }
}

impl PairContact {
    /// `k_h` in force for a pair of this reduced mass \[kg\] \[N/m^{3/2}\].
    pub fn hertz_stiffness_in_force(&self, mass: f64) -> f64 {
        self.law(mass, false).hertz_stiffness_in_force()
    }

    /// Parameter ζ, ξ or a in force \[–\]; 0 for laws without one.
    pub fn law_parameter_in_force(&self) -> f64 {
        // It does not depend on the mass.
        self.law(1.0, false).parameter_in_force()
    }

    /// Stiffness per mass of a pair of this reduced mass \[kg\], of a Hertz or bilinear spring that of the linear one with as
    /// short a hit at the default design speed \[1/s²\].
    pub fn stiffness_per_mass(&self, mass: f64) -> f64 {
        if self.normal_law.is_hertzian() {
            let speed = ContactSettings::default().design_speed;
            law_of_pair(&self.law(mass, false)).normal.frequency(mass, speed).powi(2)
        } else {
            self.stiffness / mass
        }
    }

    /// Parameters of the law of a pair of this reduced mass \[kg\]; `one_way` where sliding has one direction.
    pub fn law(&self, mass: f64, one_way: bool) -> PairNumbers {
        PairNumbers {
            stiffness: self.stiffness,
            normal: self.normal_law,
            hertz_stiffness: self.hertz_stiffness,
            design_speed: self.design_speed,
            calibration: self.calibration,
            parameter: self.law_parameter,
            mass,
            restitution_normal: self.restitution_normal,
            restitution_tangential: self.restitution_tangential,
            mu_static: self.mu_static,
            mu_kinetic: self.mu_kinetic,
            friction: self.law,
            clamp: self.tension == Tension::Clamp,
            one_way,
        }
    }
}
