//! The draw list: everything in a picture, knowing no graphics library.
//!
//! World positions are f32 metres, screen positions pixels from the top left. A list prints as text, rounded well
//! above the last bits, so that tests can read it without a GPU.

use glam::{Mat4, Vec2, Vec3, Vec4};

/// A colour, eight bits a channel, sRGB, straight alpha.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rgba(pub [u8; 4]);

impl Rgba {
    /// Fully transparent.
    pub const CLEAR: Self = Self([0; 4]);

    /// With alpha.
    pub const fn new(r: u8, g: u8, b: u8, a: u8) -> Self {
        Self([r, g, b, a])
    }

    /// Opaque.
    pub const fn rgb(r: u8, g: u8, b: u8) -> Self {
        Self([r, g, b, 0xff])
    }

    /// The colour with a share of its alpha, from 0 to 1.
    #[must_use]
    #[expect(clippy::cast_sign_loss, reason = "the share is held within 0 and 1")]
    pub fn fainter(self, share: f64) -> Self {
        self.with_alpha((f64::from(self.0[3]) * share.clamp(0.0, 1.0)).round() as u8)
    }

    /// The colour with another alpha.
    #[must_use]
    pub const fn with_alpha(self, alpha: u8) -> Self {
        Self([self.0[0], self.0[1], self.0[2], alpha])
    }
}

/// Background behind the bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Background {
    /// Light and calm.
    #[default]
    Studio,
    /// For print.
    White,
    /// For pasting onto something else.
    Transparent,
    /// For dark slides.
    Dark,
}

/// Camera and light of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Clip space (z in `[0, 1]`, y up) from the world.
    pub clip_from_world: Mat4,
    /// The eye, homogeneous: a point in perspective, a direction (w = 0) in orthographic views.
    pub eye: Vec4,
    /// Distance by which lines are lifted towards the eye, off the bodies that they lie on \[m\].
    pub lift: f32,
    /// Unit vector towards the light.
    pub towards_light: Vec3,
    /// The light's clip space from the world.
    pub light_from_world: Mat4,
    /// Width of the square that the light's clip space covers \[m\].
    pub light_width: f32,
    /// Middle of the scene \[m\]; what lies farther from it in plan than `fade` begins fades out until it ends.
    pub middle: Vec2,
    /// Distances at which fading begins and ends \[m\].
    pub fade: [f32; 2],
    /// Top of the background.
    pub sky: Rgba,
    /// Bottom of the background.
    pub floor: Rgba,
}

/// The ground: catches shadows, carries the grid, fades out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Middle, at the ground's height \[m\].
    pub centre: Vec3,
    /// It has faded out here \[m\].
    pub radius: f32,
    /// Spacing of the grid, every fifth line stronger; no grid when absent \[m\].
    pub spacing: Option<f32>,
    /// Lines.
    pub grid: Rgba,
    /// Shadow.
    pub shadow: Rgba,
}

/// A solid with a flat four-sided face, swept.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Name of the body, for tests.
    pub name: String,
    /// The face, anticlockwise seen from outside \[m\].
    pub face: [Vec3; 4],
    /// From the face to the opposite one \[m\].
    pub sweep: Vec3,
    /// Its colour.
    pub color: Rgba,
}

/// A straight line in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Name of its group, for tests.
    pub group: &'static str,
    /// From \[m\].
    pub from: Vec3,
    /// To \[m\].
    pub to: Vec3,
    /// Pixels.
    pub width: f32,
    /// Its colour.
    pub color: Rgba,
}

/// A friction cone: apex at the contact, as high as `N(δ)` in the arrows' scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// Number of the contact.
    pub contact: usize,
    /// The contact \[m\].
    pub apex: Vec3,
    /// Unit normal of the face, towards the node's body.
    pub axis: Vec3,
    /// `N(δ)` in the arrows' scale \[m\].
    pub height: f32,
    /// `μ_s`: the thin outline's rim over its height.
    pub mu_static: f32,
    /// `μ_k`: the filled cone's rim over its height.
    pub mu_kinetic: f32,
    /// Colour of the filled cone.
    pub color: Rgba,
}

/// Quantity of an arrow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ArrowKind {
    /// `N(δ) n`.
    Normal,
    /// Tangential spring, or friction.
    Tangential,
    /// Normal and tangential, without dashpots.
    Resultant,
    /// Both dashpots.
    Damping,
    /// An impulse of the impact model, which fades.
    Impulse,
}

/// A force, drawn at the node that it acts on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrow {
    /// Number of the contact.
    pub contact: usize,
    /// Its quantity.
    pub kind: ArrowKind,
    /// The node \[m\].
    pub from: Vec3,
    /// The tip \[m\].
    pub to: Vec3,
    /// Radius of the shaft \[m\].
    pub radius: f32,
    /// Its colour.
    pub color: Rgba,
    /// The rim around it.
    pub halo: Rgba,
}

/// Something flat on the picture, in pixels from the top left.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A line of text; `x_y` is a subscript.
    Text {
        /// The point that `align` refers to.
        at: Vec2,
        /// Share of the text's own size that lies before the point: 0 starts there, 0.5 is centred, 1 ends there.
        align: Vec2,
        /// Height of the font.
        size: f32,
        /// Its text.
        text: String,
        /// Its colour.
        color: Rgba,
        /// Colour of the plate behind it.
        plate: Option<Rgba>,
    },
    /// A filled disk with a rim.
    Disk {
        /// Middle.
        at: Vec2,
        /// Radius.
        radius: f32,
        /// Its colour.
        color: Rgba,
        /// The rim's.
        halo: Rgba,
    },
    /// A ring.
    Ring {
        /// Middle.
        at: Vec2,
        /// Radius of the middle of the ring.
        radius: f32,
        /// Width of the ring.
        width: f32,
        /// Its colour.
        color: Rgba,
        /// The rim's.
        halo: Rgba,
    },
    /// A diagonal cross.
    Cross {
        /// Middle.
        at: Vec2,
        /// Half its width.
        radius: f32,
        /// Width of its strokes.
        width: f32,
        /// Its colour.
        color: Rgba,
        /// The rim's.
        halo: Rgba,
    },
    /// Straight strokes through points.
    Stroke {
        /// Its points.
        points: Vec<Vec2>,
        /// Its width.
        width: f32,
        /// Its colour.
        color: Rgba,
    },
    /// A filled convex polygon.
    Fill {
        /// Its corners.
        points: Vec<Vec2>,
        /// Its colour.
        color: Rgba,
    },
    /// A rectangle with round corners.
    Panel {
        /// Top left.
        min: Vec2,
        /// Bottom right.
        max: Vec2,
        /// Its colour.
        color: Rgba,
        /// Its rim's.
        rim: Rgba,
    },
}

/// Everything in a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawList {
    /// Width and height \[pixels\].
    pub size: [u32; 2],
    /// Pixels to a point.
    pub pixels_per_point: f32,
    /// Camera, light and background.
    pub frame: Frame,
    /// The ground, if it is to be seen.
    pub ground: Option<Ground>,
    /// Bodies.
    pub solids: Vec<Solid>,
    /// Bodies that are seen through: drawn over the others, casting no shadow.
    pub ghosts: Vec<Solid>,
    /// Lines that bodies hide.
    pub lines: Vec<Line>,
    /// Lines seen through bodies.
    pub xray_lines: Vec<Line>,
    /// Friction cones, seen through bodies.
    pub cones: Vec<Cone>,
    /// Forces, seen through bodies.
    pub arrows: Vec<Arrow>,
    /// On top of everything, in order.
    pub marks: Vec<Mark>,
}
