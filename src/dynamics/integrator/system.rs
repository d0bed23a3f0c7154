//! Systems of ordinary differential equations `ẏ = f(t, y)`: the interface of the integrators.
//!
//! Explicit methods need the right-hand side and a norm ([`System`]); implicit ones also what their Newton matrix is
//! built from ([`ImplicitSystem`]): increments for difference quotients, the block structure, and the part of the
//! Jacobian that is evaluated at every stage, which is of low rank ([`RankOneTerm`]).

use glam::DVec2;

/// A first-order system `ẏ = f(t, y)` with the norm in which its errors are measured.
pub trait System {
    /// `ẏ` at `(t, y)`.
    fn slope(&mut self, t: f64, y: &[f64], out: &mut [f64]);
    /// Squared norm of a difference of states; 1 is the tolerance.
    fn size2(&self, difference: &[f64]) -> f64;
}

/// System for an implicit method. The defaults describe a system without structure: a dense Jacobian by difference quotients, no auxiliary
/// components, no term of low rank.
///
/// The last [`auxiliary_count`](Self::auxiliary_count) components are *auxiliary*: each obeys a scalar equation of
/// its own and is coupled to the leading components through one [`RankOneTerm`] only. A *port* is a pair of inputs
/// `u` (two components) and outputs `w = W y` (two components): the leading components obey `ẏ = … + B u`, and
/// rank-one terms give `u` from `w`.
pub trait ImplicitSystem: System {
    /// Scale of component `i`, whose value is `y`, for the increments of difference quotients: large against the
    /// rounding of `f`, small against the distance over which `f` is linear.
    fn increment_scale(&self, _i: usize, y: f64) -> f64 {
        y.abs().max(1.0)
    }
    /// Sets the components that never change to 0 in a difference of states.
    fn hold(&self, _difference: &mut [f64]) {}
    /// The blocks of the leading components, if the system is of second order: the rates of a block's positions are
    /// linear in its velocities, `ṗ = B v` with orthogonal columns of `B`, and `f` does not depend on changes of
    /// positions outside of the range of `B`.
    fn position_blocks(&self) -> impl Iterator<Item = PositionBlock> {
        std::iter::empty()
    }
    /// Upper bound of the rates of the system without its auxiliary components and ports, approximate \[1/s\].
    fn rate_bound(&self) -> f64 {
        f64::INFINITY
    }
    /// Relative tolerance to which the unit of the norm corresponds.
    fn relative_tolerance(&self) -> f64 {
        0.0
    }
    /// Cost of an implicit step over that of an explicit one, per the same ratio for a few bodies \[–\]: elimination grows with the cube of
    /// the number of components, the right-hand side in proportion to it.
    fn implicit_cost(&self) -> f64 {
        1.0
    }
    /// Number of auxiliary components.
    fn auxiliary_count(&self) -> usize {
        0
    }
    /// `∂ẏᵢ/∂yᵢ` of the auxiliary components at the last evaluation of the right-hand side \[1/s\].
    fn auxiliary_rates(&self) -> &[f64] {
        &[]
    }
    /// Number of ports.
    fn port_count(&self) -> usize {
        0
    }
    /// The terms of low rank at the last evaluation of the right-hand side: the same number and order at every state.
    fn rank_one_terms(&self) -> &[RankOneTerm] {
        &[]
    }
    /// While `frozen`, evaluations keep the inputs' directions of the last evaluation before, and all that switches
    /// with them its branch: difference quotients then leave the terms of low rank out of the Jacobian.
    fn freeze(&mut self, _frozen: bool) {}
    /// The columns of `B` and the rows of `W` of a port at `y`, over the leading components: two of each, all 0 as
    /// given, and 0 for positions.
    fn port(&self, _port: usize, _y: &[f64], _input: &mut [f64], _output: &mut [f64]) {}
}

/// Neighbouring components: positions, then the velocities that carry them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PositionBlock {
    /// First position.
    pub from: usize,
    /// First velocity.
    pub velocities: usize,
    /// Index after the last velocity.
    pub until: usize,
}

/// A rank-one part of the response of a port's input to its output, `du = input · z`, where `z = output · dw`, or
/// where `z` is an auxiliary component driven by that.
#[derive(Clone, Copy, Debug)]
pub struct RankOneTerm {
    /// Number of the port.
    pub port: usize,
    /// Change of the input per unit of `z`.
    pub input: DVec2,
    /// `z`, or the rate at which the auxiliary component changes, per unit of the output.
    pub output: DVec2,
    /// Number of the auxiliary component that is `z`; `None` where `z` is the output.
    pub auxiliary: Option<usize>,
}
