//! `hits.csv` and `transitions.csv`: what the impact model did, with the rows of the paper's tables that fired.

use std::io::Write;

use super::{number, to_csv};
use crate::sim::{GirderState, History, Hit, Row, Transition};

const HITS: [&str; 22] = [
    "t",
    "pair",
    "where",
    "nodes",
    "from",
    "to",
    "row",
    "conditions",
    "point.x",
    "point.y",
    "normal.x",
    "normal.y",
    "v_n",
    "v_s",
    "offset",
    "impulse_n",
    "impulse_s",
    "second_n",
    "second_s",
    "total_n",
    "total_s",
    "lost",
];

/// Every hit: where, the approach `v_n, v_s` \[m/s\], first, second and total impulse on the first side along the normal and
/// its tangent \[N·s\], energy lost \[J\]. Empty under the contact model.
///
/// # Errors
///
/// Those of the writer.
pub fn hits(history: &History, out: &mut dyn Write) -> std::io::Result<()> {
    let all = history.impact().map_or(&[][..], |record| &record.hits);
    to_csv(&HITS.map(str::to_owned), all.iter().map(|hit| hit_row(history, hit)), out)
}

fn hit_row(history: &History, hit: &Hit) -> Vec<String> {
    let model = history.model();
    let nodes: Vec<&str> = hit.sites.iter().map(|&site| model.sites[site].node.as_str()).collect();
    let impulses = &hit.impulses;
    let total = impulses.total();
    let second = impulses.second.map_or([0.0; 2], |(_, second)| second.impulse);
    let words = [
        number(hit.t),
        model.pairs[hit.pair].name.clone(),
        if hit.is_flush() { "face" } else { "corner" }.to_owned(),
        nodes.join(" "),
        letter(hit.from),
        letter(hit.to),
        row_label(hit.row),
        hit.row.map_or("", Row::conditions).to_owned(),
    ];
    let numbers = [
        hit.point.x,
        hit.point.y,
        impulses.normal.x,
        impulses.normal.y,
        impulses.approach[0],
        impulses.approach[1],
        impulses.offset,
        impulses.first[0],
        impulses.first[1],
        second[0],
        second[1],
        total[0],
        total[1],
        impulses.lost,
    ];
    words.into_iter().chain(numbers.map(number)).collect()
}

const TRANSITIONS: [&str; 10] = ["t", "girder", "pair", "from", "to", "state", "paper", "row", "conditions", "lost"];

/// Every change of state, each girder's state at the start first; with the paper's name of the state and the row of its
/// tables that fired. Empty under the contact model.
///
/// # Errors
///
/// Those of the writer.
pub fn transitions(history: &History, out: &mut dyn Write) -> std::io::Result<()> {
    let all = history.impact().map_or(&[][..], |record| &record.transitions);
    let rows = all.iter().filter(|change| change.from != change.to || change.t == 0.0);
    to_csv(&TRANSITIONS.map(str::to_owned), rows.map(|change| transition_row(history, change)), out)
}

fn transition_row(history: &History, change: &Transition) -> Vec<String> {
    let model = history.model();
    vec![
        number(change.t),
        model.bodies[change.body].name.clone(),
        change.pair.map_or(String::new(), |pair| model.pairs[pair].name.clone()),
        letter(change.from),
        letter(change.to),
        change.to.label().to_owned(),
        change.to.paper().to_owned(),
        row_label(change.row),
        change.row.map_or("", Row::conditions).to_owned(),
        number(change.lost),
    ]
}

fn letter(state: GirderState) -> String {
    state.letter().to_string()
}

fn row_label(row: Option<Row>) -> String {
    row.map_or(String::new(), Row::label)
}
