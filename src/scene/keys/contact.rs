//! Keys of contact numbers and of the two models.

use super::{Fallback, Key, Range};
use crate::scene::facing::DEFAULT_YOUNG_MODULUS;

/// `[contact]`.
pub const CONTACT: &[Key] = &[
    Key::new(
        "stiffness_n_per_m",
        Range::Positive,
        Fallback::Words("E A / L"),
        "K of a pair (54), N/m; not together with the next two",
    ),
    Key::new(
        "young_modulus_pa",
        Range::Positive,
        Fallback::Number(DEFAULT_YOUNG_MODULUS),
        "E of K = E A / L (64), Pa; of two girders the smaller K counts",
    ),
    Key::new("area_m2", Range::Positive, Fallback::Words("width × thickness of the girder"), "A of (64), m²"),
    Key::new("restitution_normal", Range::Within([0.01, 1.0]), Fallback::Number(0.4), "e_n; 1 is no dashpot (65)"),
    Key::new("restitution_tangential", Range::Within([0.01, 1.0]), Fallback::Number(0.9), "e_t; 1 is no dashpot (65)"),
    Key::new("mu_static", Range::NotBelow("mu_kinetic"), Fallback::Number(0.2), "μ_s"),
    Key::new("mu_kinetic", Range::NotNegative, Fallback::Number(0.15), "μ_k"),
    Key::new(
        "law",
        Range::Words(&["paper", "return-mapping"]),
        Fallback::Word("return-mapping"),
        "friction: the paper's law taken literally, or elastic-plastic Coulomb, which holds a static load",
    ),
    Key::new(
        "sharing",
        Range::Words(&["tributary", "per-node"]),
        Fallback::Word("tributary"),
        "K and C divided by the nodes that face the other end when the pair closes, or whole for each node",
    ),
    Key::new(
        "tension",
        Range::Words(&["keep", "clamp"]),
        Fallback::Word("keep"),
        "whether the dashpot may pull just before a contact opens, or the normal force is held at 0",
    ),
    Key::new("pair", Range::Free, Fallback::Words("none"), "[[contact.pair]], see below"),
];

/// `[[contact.pair]]`.
pub const PAIR: &[Key] = &[
    Key::new(
        "between",
        Range::Like("two names"),
        Fallback::Needed("must be given"),
        "the two bodies, in either order; at least one is a girder",
    ),
    Key::new(
        "ends",
        Range::Like("two of \"+x\", \"-x\""),
        Fallback::Words("every pair between the two"),
        "only the pair of these ends, in the order of between; declares it if it is not found by itself. The \
         end of an abutment is not looked at",
    ),
    Key::new(
        "stiffness_n_per_m",
        Range::Positive,
        Fallback::Words("as in [contact]"),
        "K of a pair (54), N/m; not together with the next two",
    ),
    Key::new(
        "young_modulus_pa",
        Range::Positive,
        Fallback::Words("as in [contact]"),
        "E of K = E A / L (64), Pa; of two girders the smaller K counts",
    ),
    Key::new("area_m2", Range::Positive, Fallback::Words("as in [contact]"), "A of (64), m²"),
    Key::new(
        "restitution_normal",
        Range::Within([0.01, 1.0]),
        Fallback::Words("as in [contact]"),
        "e_n; 1 is no dashpot (65)",
    ),
    Key::new(
        "restitution_tangential",
        Range::Within([0.01, 1.0]),
        Fallback::Words("as in [contact]"),
        "e_t; 1 is no dashpot (65)",
    ),
    Key::new("mu_static", Range::NotBelow("mu_kinetic"), Fallback::Words("as in [contact]"), "μ_s"),
    Key::new("mu_kinetic", Range::NotNegative, Fallback::Words("as in [contact]"), "μ_k"),
    Key::new(
        "law",
        Range::Words(&["paper", "return-mapping"]),
        Fallback::Words("as in [contact]"),
        "friction: the paper's law taken literally, or elastic-plastic Coulomb, which holds a static load",
    ),
    Key::new(
        "sharing",
        Range::Words(&["tributary", "per-node"]),
        Fallback::Words("as in [contact]"),
        "K and C divided by the nodes that face the other end when the pair closes, or whole for each node",
    ),
    Key::new(
        "tension",
        Range::Words(&["keep", "clamp"]),
        Fallback::Words("as in [contact]"),
        "whether the dashpot may pull just before a contact opens, or the normal force is held at 0",
    ),
];

/// `[model]`.
pub const MODEL: &[Key] = &[Key::new(
    "kind",
    Range::Words(&["contact", "impact", "both"]),
    Fallback::Word("contact"),
    "the 3D contact-friction model, the 2D rigid-body impact model (planar scenes only), or both, to be \
         looked at together; the contact model leads",
)];

/// `[impact]`.
pub const IMPACT: &[Key] = &[
    Key::new("restitution_normal", Range::Within([0.0, 1.0]), Fallback::Number(0.4), "e_n (29)"),
    Key::new("restitution_tangential", Range::Within([-1.0, 1.0]), Fallback::Number(-0.9), "e_t (31); −1 is smooth"),
    Key::new("mu_static", Range::NotBelow("mu_kinetic"), Fallback::Number(0.2), "μ_s of a face"),
    Key::new("mu_kinetic", Range::NotNegative, Fallback::Number(0.15), "μ_k of a face"),
    Key::new("corner_mu_static", Range::NotBelow("corner_mu_kinetic"), Fallback::Words("mu_static"), "μ̄_s of a corner"),
    Key::new(
        "corner_mu_kinetic",
        Range::NotNegative,
        Fallback::Words("mu_kinetic, or μ̄_s where that is less"),
        "μ̄_k of a corner",
    ),
    Key::new(
        "flush",
        Range::Words(&["paper", "two-corner"]),
        Fallback::Word("paper"),
        "a hit along a whole face: the paper's impulse at the centroid of the approach (44), or an impulse at \
         each of its ends",
    ),
    Key::new("stop_speed_m_s", Range::Positive, Fallback::Number(0.0001), "slower than this there is no bounce, m/s"),
];
