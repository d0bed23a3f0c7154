//! The study's tables as CSV and as a page, and its plots.

use std::fmt::Write as _;

use super::{Influence, Row};
use crate::plot::{COLORS, Marker, Plot, Series, Ticks};
use crate::study::Occasion;

/// Markers of the lines of a plot.
const MARKERS: [Marker; 3] = [Marker::Circle, Marker::Square, Marker::Triangle];

/// Every row: `influence,value,noise,mm_per_pixel,rms_pixel,rms_mm,largest_mm,rms_theta_deg,lost`.
pub fn csv(rows: &[Row]) -> String {
    let mut table = "influence,value,noise,mm_per_pixel,rms_pixel,rms_mm,largest_mm,rms_theta_deg,lost\n".to_owned();
    for Row { influence, value, noise, mm_per_pixel, found } in rows {
        let _ = write!(table, "{influence:?},{value},{noise},{mm_per_pixel}");
        let _ = match found {
            Ok(errors) => {
                let largest = errors.place[0].largest.max(errors.place[1].largest);
                let rms = errors.rms();
                writeln!(table, ",{},{rms},{largest},{},", rms / mm_per_pixel, errors.rotation.rms)
            }
            Err(lost) => writeln!(table, ",,,,,\"{lost}\""),
        };
    }
    table
}

/// The page: a table an influence.
pub fn page(rows: &[Row], occasion: &Occasion) -> String {
    let Occasion { date, machine, command } = occasion;
    let mut page = format!(
        "# Error of a film of marks\n\nMeasured {date} on {machine}: `{command}`.\n\n\
         Root mean square of measured less computed displacement, of x and y together, and of θ.\n"
    );
    for influence in Influence::ALL {
        let _ = writeln!(
            page,
            "\n| {} | noise | RMS [pixel] | RMS [mm] | largest [mm] | RMS of θ [°] |\n|---|---|---|---|---|---|",
            influence.words()
        );
        for row in rows.iter().filter(|row| row.influence == influence) {
            let _ = match &row.found {
                Ok(errors) => writeln!(
                    page,
                    "| {} | {} | {:.4} | {:.4} | {:.4} | {:.4} |",
                    row.value,
                    row.noise,
                    errors.rms() / row.mm_per_pixel,
                    errors.rms(),
                    errors.place[0].largest.max(errors.place[1].largest),
                    errors.rotation.rms
                ),
                Err(lost) => writeln!(page, "| {} | {} | {lost} | | | |", row.value, row.noise),
            };
        }
    }
    page
}

/// Plots with their names: error against the diameter of the marks, and against exposure.
pub fn plots(rows: &[Row]) -> Vec<(&'static str, Plot)> {
    [("camera-diameter", Influence::Diameter), ("camera-exposure", Influence::Exposure)]
        .into_iter()
        .map(|(name, influence)| (name, plot(rows, influence)))
        .collect()
}

fn plot(rows: &[Row], influence: Influence) -> Plot {
    let line = |(n, noise): (usize, &f64)| {
        let own = rows.iter().filter(|row| row.influence == influence && row.noise == *noise && row.value > 0.0);
        let point = |row: &Row| Some((row.value, row.found.as_ref().ok()?.rms() / row.mm_per_pixel));
        Series {
            name: if *noise == 0.0 { "no noise".to_owned() } else { format!("noise of {noise}") },
            color: COLORS[n % COLORS.len()],
            marker: MARKERS[n % MARKERS.len()],
            strong: n == 0,
            points: own.filter_map(point).collect(),
        }
    };
    Plot {
        title: format!("Error against {}", influence.words()),
        subtitle: "RMS of measured less computed displacement; noise in steps of 255".to_owned(),
        x: (influence.words().to_owned(), Ticks::Counts),
        y: ("RMS error [pixels]".to_owned(), Ticks::Powers),
        series: influence.noises().iter().enumerate().map(line).collect(),
        marks: Vec::new(),
        guides: Vec::new(),
        floor: None,
    }
}
