//! Boxes that bodies sweep during a run: two whose boxes lie apart never come near. A body stays within the ball that its farthest corner
//! can reach, and, where a bound on its rotation is known, within its box as placed, grown by the way of its corners.

use super::motion;
use super::solid::Solids;
use crate::geometry::shape::AlignedBox;
use crate::sim::History;

/// The box that a body sweeps from t = 0 to the end of the answer \[m\].
pub(super) fn of(history: &History, solids: &Solids, number: usize) -> AlignedBox {
    let Some(body) = solids.body(number) else { return solids.fixed_box(number) };
    let (model, radius) = (history.model(), solids.radius(number));
    let reach = motion::reach(history, body, radius);
    let grown = |hull: AlignedBox, by: f64| AlignedBox { min: hull.min - by, max: hull.max + by };
    let home = model.bodies[body].home;
    let anyhow = grown(AlignedBox { min: home, max: home }, reach.place + radius);
    let turned_little = grown(solids.placed_box(model, number), reach.corner);
    let both = AlignedBox { min: anyhow.min.max(turned_little.min), max: anyhow.max.min(turned_little.max) };
    solids.flat(both)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, presets};

    /// Rounding of a corner's place \[m\].
    const ROUNDING: f64 = 1e-9;

    fn run(name: &str, duration: f64) -> History {
        let scene = Scene { duration, ..presets::load(name).expect("ships") };
        History::of(&scene).expect("a sound scene")
    }

    #[test]
    fn no_corner_leaves_the_box_of_its_body() {
        for (name, duration) in [("skew45-abutment", 2.0), ("deck-30m", 3.0), ("row-of-5", 2.0), ("span-as-built", 4.0)]
        {
            let history = run(name, duration);
            let solids = Solids::of(history.scene(), history.model());
            for number in 0..solids.len() {
                let hull = of(&history, &solids, number);
                for look in 0..=300 {
                    let corners = solids.corners(&history, number, history.end() * f64::from(look) / 300.0);
                    let at = solids.flat(AlignedBox::around(&corners));
                    let within = at.min.cmpge(hull.min - ROUNDING).all() && at.max.cmple(hull.max + ROUNDING).all();
                    assert!(within, "{name}, body {number}: {at:?} in {hull:?}");
                }
            }
        }
    }

    #[test]
    fn backwalls_that_move_do_not_come_near_each_other() {
        let history = run("span-as-built", 4.0);
        let solids = Solids::of(history.scene(), history.model());
        let walls = (0..solids.len()).filter(|&number| solids.body(number).is_some_and(|body| body > 0));
        let boxes: Vec<AlignedBox> = walls.map(|number| of(&history, &solids, number)).collect();
        assert_eq!(boxes.len(), 2, "one at either end");
        assert!(boxes[0].min.cmpgt(boxes[1].max).any() || boxes[1].min.cmpgt(boxes[0].max).any(), "{boxes:?}");
    }
}
