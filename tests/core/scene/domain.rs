//! The page on stability states the domain as the code has it.

use girderbench::scene::domain::{LIMITS, Limit};

/// A number as the page writes it: `5`, `1e-12`.
fn number(value: f64) -> String {
    if (1.0..1000.0).contains(&value) && value % 100.0 != 0.0 || value == 0.0 {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

#[test]
fn the_page_lists_every_limit_with_its_range() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/stability.md");
    let page = std::fs::read_to_string(path).expect("the page");
    let rows: Vec<&str> = page.lines().skip_while(|line| !line.starts_with("## Domain")).collect();
    let rows: Vec<&str> = rows.into_iter().filter(|line| line.starts_with("| ")).take(LIMITS.len() + 1).collect();
    let row = |limit: &Limit| {
        let [low, high] = limit.range.map(number);
        let unit = if limit.unit.is_empty() { String::new() } else { format!(" {}", limit.unit) };
        format!("| {} |{unit} | {low} | {high} | ", limit.quantity)
    };
    for (limit, written) in LIMITS.iter().zip(&rows[1..]) {
        assert!(written.starts_with(&row(limit)), "{} in {written}", row(limit));
    }
}
