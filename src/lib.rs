//! Bridge girders that pound, stick, slip and turn.
//!
//! Girderbench computes how the decks of a bridge move in an earthquake when they hit each other and their abutments:
//! rigid girders on bearings, shaken by the ground, with three-dimensional contact and dry friction at their ends
//! (Abe, Fujino, Yoshida, Zhu and Yanagino, "Multi-dimensional models of pounding of girders for elevated bridges and
//! their experimental verification", JSCE, 2004; equation and table numbers in these pages are that paper's). A run is
//! driven by its events, so an answer is exact to a stated tolerance and can be asked for anything at any time.
//!
//! ```no_run
//! use girderbench::{scene::presets, sim::History};
//!
//! let scene = presets::load("skew45-abutment")?;
//! let history = History::of(&scene)?;
//! let hardest = history.hits().hardest().expect("the girder hits the abutment");
//! println!("{} N at t = {} s", hardest.peak_force, hardest.peak_time);
//! println!("rotation there: {} rad", history.motion(0, hardest.peak_time).theta);
//! # Ok::<(), girderbench::scene::SceneErrors>(())
//! ```
//!
//! # Conventions
//!
//! - SI everywhere inside; another unit is in the name (`_deg`, `_mm`, `_hz`).
//! - The world moves with the shaking ground. X runs along the bridge axis, Y across it, Z up, right-handed; θ turns
//!   anticlockwise about Z. Displacements are relative to the ground.
//! - **Skew angle β**: between the bridge axis and the support line; 90° is a straight bridge (American texts count
//!   90° − β). An end face runs along `(cos β, sin β)` in plan.
//! - **Gap**: measured along the bridge axis; `gap > 0` is apart, `penetration = −gap`.
//! - A contact's **normal** points out of the face, towards the body that owns the node; forces shown are those on
//!   that body.
//!
//! # Glossary
//!
//! - **girder**: a prism of parallelogram plan, rigid unless the scene makes it elastic; **G** its centroid, **i** its
//!   radius of gyration about Z.
//! - **abutment**: a backwall, fixed unless it has backfill or its ground moves otherwise. **Facing pair**: two ends that
//!   can touch, such as `deck+x|wall`.
//! - **node**: a corner that may touch a **face**; a **contact** is a declared node and face (Fig. 24).
//! - **anchor** `X_p`: the point of the face that holds a node.
//! - **stick**, **slip**: whether the anchor stays on the face or is dragged; **open** is neither.
//! - **touch**: one contact from closing to opening; **hit**: a pair, from its first contact's closing to its last
//!   one's opening. **Event**: any change of a contact's state.
//! - **law**: `paper` is the paper's friction, `return-mapping` the elastic-plastic one that also holds a static push.
//! - **ledger**: where the energy is and where it went; its **residual** is what is not accounted for.
//! - **digest**: a hash of a whole answer, bit for bit.
//!
//! # Rooms
//!
//! Each uses only rooms listed before it.
//!
//! | room | what is in it |
//! |---|---|
//! | [`language`] | texts by their keys, in the language of the user |
//! | [`geometry`] | prisms, faces, and the one door to parry |
//! | [`plot`] | charts that draw themselves as SVG, and numbers as colours |
//! | [`contact`] | laws at one point, knowing no bodies |
//! | [`motion`] | ground motion as functions of time, record parsers |
//! | [`identify`] | natural frequency and damping from measured histories |
//! | [`measure`] | the motion of bodies from pictures of marks on them |
//! | [`scene`] | what a user places: file format, presets, overrides, validation, edits |
//! | [`dynamics`] | bodies, bearings, flight, integrators, the event loop |
//! | [`sim`] | a run: session, dense history, events, ledger, error estimate |
//! | [`codes`] | seat lengths that design codes require, beside those of a run |
//! | [`study`] | many runs: work against error, cost against size, random scenes, sweeps over keys |
//! | [`tables`] | an answer as CSV and JSON |
//! | [`report`] | an answer on one page of HTML |
//! | [`view`] | an answer as a list of things to draw |
//! | `render` | draw lists as pixels, on or off screen (feature `render`) |
//! | `snapshot` | scene in, picture out (feature `render`) |
//! | [`files`] | opens scenes and records, writes files whole or not at all |
//! | `app` | the workbench window (feature `gui`) |
//! | [`cli`] | the command line |
//! | `page` | the program as a page in a browser (target `wasm32-unknown-unknown`) |
//!
//! The first eleven are the core: they know no clock, no file, no window and no GPU, and build without any feature.

#[cfg(not(target_arch = "wasm32"))]
pub mod cli;
pub mod codes;
pub mod contact;
pub mod dynamics;
pub mod files;
pub mod geometry;
pub mod identify;
pub mod language;
pub mod measure;
pub mod motion;
#[cfg(target_arch = "wasm32")]
pub mod page;
pub mod plot;
pub mod report;
pub mod scene;
pub mod sim;
pub mod study;
pub mod tables;
pub mod view;

#[cfg(feature = "gui")]
pub mod app;
#[cfg(feature = "render")]
pub mod render;
#[cfg(feature = "render")]
pub mod snapshot;
