//! Sweeps: what the page about them says of measures.

use girderbench::study::sweep::MEASURES;

#[test]
fn the_page_lists_every_measure() {
    let page = include_str!("../../../docs/sweep.md");
    let listed: Vec<String> = page
        .lines()
        .filter(|line| line.starts_with("| `") && line.matches(" | ").count() == 2)
        .map(str::to_owned)
        .collect();
    let row =
        |meaning: &str, name: &str, unit: &str| format!("| `{name}` | {unit} | {} |", meaning.replace('|', "\\|"));
    let wanted: Vec<String> = MEASURES.iter().map(|m| row(m.meaning, m.name, m.unit)).collect();
    assert_eq!(listed, wanted, "the same words in the same order");
}
