//! `trajectory.csv`: where every girder is and how fast, at a constant rate.

use std::io::Write;

use super::{number, sample_times, to_csv};
use crate::scene::{Kind, ModelKind, Scene};
use crate::sim::{History, Motion};

/// Columns of a planar girder: displacement of G \[m\], rotation since placed \[rad\], their rates.
const PLANAR: [&str; 6] = ["x", "y", "theta", "vx", "vy", "omega"];
/// Further columns of a spatial girder: height \[m\], attitude (unit quaternion, body to world), the other rates.
const SPATIAL: [&str; 8] = ["z", "qx", "qy", "qz", "qw", "vz", "wx", "wy"];

/// The table: `t`, then per girder `NAME.x, NAME.y, NAME.theta, NAME.vx, NAME.vy, NAME.omega`; a spatial girder adds
/// `z, qx, qy, qz, qw, vz, wx, wy`; under the impact model `state` follows, a letter from a to f. Last, of a run that lost supports, how many
/// until then.
///
/// # Errors
///
/// Those of the writer.
pub fn trajectory(history: &History, sample_hz: f64, out: &mut dyn Write) -> std::io::Result<()> {
    let spatial = history.scene().kind == Kind::Spatial;
    let bodies = &history.model().bodies;
    let losses: Vec<f64> = history.seats().lost_supports(history.end()).iter().map(|lost| lost.t).collect();
    let rows = sample_times(history.end(), sample_hz).map(|t| {
        let mut row = vec![number(t)];
        for girder in 0..bodies.len() {
            row.extend(columns(&history.motion(girder, t), spatial));
            row.extend(history.impact().map(|record| record.state(girder, t).letter().to_string()));
        }
        row.extend((!losses.is_empty()).then(|| losses.partition_point(|lost| *lost <= t).to_string()));
        row
    });
    let state = history.impact().is_some();
    let mut columns = header(bodies.iter().map(|body| body.name.as_str()), spatial, state);
    columns.extend((!losses.is_empty()).then(|| "lost_supports".to_owned()));
    to_csv(&columns, rows, out)
}

/// Columns of the table of a scene, without those of supports whose ground moves otherwise.
pub fn trajectory_columns(scene: &Scene) -> usize {
    let spatial = scene.kind == Kind::Spatial;
    let state = scene.model.kind.models().contains(&ModelKind::Impact);
    let walls = scene.abutments.iter().filter(|abutment| abutment.backfill.is_some());
    let bodies = scene.girders.len() + scene.piers.len() + walls.count();
    1 + bodies * header(std::iter::once(""), spatial, state).len().saturating_sub(1)
}

fn header<'a>(names: impl Iterator<Item = &'a str>, spatial: bool, state: bool) -> Vec<String> {
    let mut more = if spatial { SPATIAL.to_vec() } else { Vec::new() };
    more.extend(state.then_some("state"));
    let of_girder =
        |name: &str| PLANAR.iter().chain(&more).map(|column| format!("{name}.{column}")).collect::<Vec<_>>();
    std::iter::once("t".to_owned()).chain(names.flat_map(of_girder)).collect()
}

fn columns(m: &Motion, spatial: bool) -> Vec<String> {
    let planar = [m.displacement.x, m.displacement.y, m.theta, m.velocity.x, m.velocity.y, m.spin.z];
    let (q, more) = (m.attitude, [m.displacement.z, m.velocity.z, m.spin.x, m.spin.y]);
    let [z, vz, wx, wy] = more;
    let spatial = if spatial { vec![z, q.x, q.y, q.z, q.w, vz, wx, wy] } else { Vec::new() };
    planar.into_iter().chain(spatial).map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_header_names_the_body_and_the_quantity() {
        assert_eq!(
            header(["deck"].into_iter(), false, false).join(","),
            "t,deck.x,deck.y,deck.theta,deck.vx,deck.vy,deck.omega",
            "planar"
        );
        assert_eq!(
            header(["a", "b"].into_iter(), true, false).len(),
            1 + 2 * (6 + 8),
            "spatial girders have more columns"
        );
    }
}
