//! Ratio of the costs of an implicit and an explicit step, counted in operations: it grows with the number of components.

use crate::dynamics::model::coordinates::spatial;
use crate::dynamics::penalty3d::constants::SLOPE_OPERATIONS;

/// Components that are integrated of a rigid body in space: six places and their rates.
const RIGID_COMPONENTS: usize = 12;
/// Slopes of an explicit step (DOP853), and its sums over them per component: 78 products and as many additions.
const EXPLICIT_SLOPES: f64 = 12.0;
const EXPLICIT_SUMS: f64 = 156.0;
/// Stages of an implicit step (Radau IIA), and Newton iterations that it usually takes.
const STAGES: f64 = 5.0;
const ITERATIONS: f64 = 6.0;
/// Real eliminations by whose work one real and two complex ones are counted: a complex product is four real ones.
const ELIMINATIONS: f64 = 1.0 + 2.0 * 4.0;

/// Operations of an implicit step over those of an explicit one, by the number of components: eliminations of the positions, iterations of
/// all stages, a Jacobian by differences; against twelve slopes and their sums \[–\].
fn share(components: usize) -> f64 {
    let (all, half) = (components as f64, 0.5 * components as f64);
    let eliminations = ELIMINATIONS * 2.0 / 3.0 * half.powi(3) + ITERATIONS * ELIMINATIONS * 2.0 * half.powi(2);
    let slopes = (all + ITERATIONS * STAGES) * SLOPE_OPERATIONS * all;
    (eliminations + slopes) / ((EXPLICIT_SLOPES * SLOPE_OPERATIONS + EXPLICIT_SUMS) * all)
}

/// [`share`] over that of a rigid body in space, with which the constants of step control were measured; 1 where no body has more
/// components than one \[–\].
pub(super) fn over_rigid(components: usize, bodies: usize) -> f64 {
    if components > bodies * spatial::WIDTH { (share(components) / share(RIGID_COMPONENTS)).max(1.0) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_implicit_step_grows_dearer_with_the_components_of_bodies_that_bend_alone() {
        assert_eq!(over_rigid(2 * spatial::WIDTH, 2), 1.0, "two rigid bodies");
        let [one, two] = [52, 104].map(|components| over_rigid(components, 1));
        assert!(one > 1.0 && two > one, "{one} and {two}");
        // From the cube of the components on the explicit step's grow with the first power.
        assert!(share(1 << 14) / share(1 << 13) > 3.9, "the cube over the first power");
    }
}
