//! What needs no feature: the physics of both models, scenes, readings and studies.

#[path = "../support/mod.rs"]
mod support;

mod digests;
mod languages;

mod motion {
    mod components;
    mod figures;
    mod formats;
    mod mutations;
    mod sweep;
}

mod impact {
    mod lasting;
    mod limit;
    mod random;
    mod readings;
    mod reference;
    mod rules;
    mod runs;
    mod tables;
}

mod physics {
    mod backfill;
    mod bounds;
    mod cable;
    mod closed_forms_at_their_limits;
    mod contact_laws;
    mod device_starts;
    mod devices;
    mod drift;
    mod edge_nodes;
    mod energy;
    mod flexible;
    mod free_motion;
    mod hertz;
    mod long_runs;
    mod meeting;
    mod moving_supports;
    mod normal_laws;
    mod overlap;
    mod perfectly_plastic;
    mod piers;
    mod reference;
    mod rows;
    mod sliders;
    mod spatial;
    mod spatial_reference;
    mod stick_slip;
    mod supports;
    mod symmetry;
    mod tilt;
    mod tolerances;
    mod turns;
    mod two_coordinates;
    mod two_sections;
    mod viaduct;
    mod viscous_friction;
}

mod scene {
    mod bad_input;
    mod data;
    mod devices;
    mod domain;
    mod edits;
    mod facing;
    mod keys;
    mod mutations;
    mod overrides;
    mod piers;
    mod presets;
    mod runs;
    mod text;
}

mod study {
    mod accuracy;
    mod calibration;
    mod camera;
    mod experiment;
    mod identify;
    mod laws;
    mod measured_mutations;
    mod stability;
    mod sweep;
}

mod tables {
    mod mutations;
    mod readings;
    mod seats;
    mod uplift;
}
