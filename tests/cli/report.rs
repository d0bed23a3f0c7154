//! `report`: one page with everything inside, of runs with and without seats.

use girderbench::scene::{format, presets};

use crate::program::call;

/// The page of a preset's beginning with changes to it.
fn page(preset: &str, sets: &[&str]) -> String {
    page_until("2", preset, sets)
}

/// The same of a run of so many seconds.
fn page_until(until: &str, preset: &str, sets: &[&str]) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("page.html");
    let mut args = vec!["report", preset, "--until", until, "--out", out.to_str().expect("a UTF-8 path")];
    args.extend(sets.iter().flat_map(|set| ["--set", *set]));
    let said = call(&args);
    assert_eq!(said.status, Some(0), "{}", said.err);
    assert!(said.out.contains("written to "), "says where: {}", said.out);
    std::fs::read_to_string(out).expect("the page")
}

#[test]
fn a_report_has_every_section_and_nothing_outside() {
    let page = page("deck-30m", &["codes.column_height_m=8"]);
    for heading in [
        "Scene",
        "Assumptions",
        "Ground motion",
        "Hardest hit of a corner",
        "Motion of the girders",
        "Readings and limits",
        "Seats and codes",
        "How far to trust it",
        "The scene file",
    ] {
        assert!(page.contains(&format!("<h2>{heading}</h2>")), "{heading}");
    }
    let [outside, namespaces] = ["http", "xmlns=\"http://www.w3.org/2000/svg\""].map(|word| page.matches(word).count());
    assert_eq!(outside, namespaces, "no link to anything outside");
    assert!(!page.contains("NaN") && !page.contains("inf"), "nothing that is no number");
    assert!(page.contains("H = 8 m <span class=\"open\">(scene)</span>"), "a number of the scene");
    assert!(page.contains("α_E = 5° <span class=\"part\">(assumed)</span>"), "an assumed one");
    assert!(page.contains("not confirmed: quoted from memory"), "what is not confirmed");
    assert!(page.contains("front edge of the seat"), "the orbit over the seat");
    assert!(page.contains("<p>deck stays on its seats"), "the verdict");
}

#[test]
fn the_scene_in_a_report_is_the_one_that_was_run() {
    let page = page("two-components", &["motion.angle_deg=30"]);
    let text = page.split_once("<pre>").and_then(|(_, rest)| rest.split_once("</pre>")).expect("a file").0;
    let text = text.replace("&quot;", "\"").replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&");
    let scene = format::parse(&text, "report").unwrap_or_else(|errors| panic!("{errors}: {text}"));
    let run = presets::load("two-components").expect("ships");
    assert!(scene.motion != run.motion && scene.motion.angle_deg() == 30.0, "with what was set: {:?}", scene.motion);
    assert_eq!((scene.girders, scene.contact, scene.duration), (run.girders, run.contact, 2.0), "and all the rest");
}

#[test]
fn a_corner_that_comes_off_heads_the_page() {
    let short = page("skew45-abutment", &["girder.deck.seat_m={ \"+x\" = 0.002 }"]);
    assert!(short.contains("A corner comes off its seat: deck+x at "), "first of all");
    assert!(short.contains(">off at "), "in the picture");
    let none = page("skew45-abutment", &["girder.deck.name=\"a <b>\"", "abutment.wall.faces=\"a <b>\""]);
    assert!(none.contains("The scene gives no seats"), "without seats");
    assert!(!none.contains("a <b>"), "names cannot break the page");
}

#[test]
fn what_is_reached_while_an_end_off_its_seat_is_carried_has_a_sign() {
    let short = page("skew45-abutment", &["girder.deck.seat_m={ \"+x\" = 0.002 }"]);
    let off = short.split_once("comes off its seat: deck+x at ").expect("off").1;
    let off: f64 = off.split(' ').next().and_then(|t| t.parse().ok()).expect("a time");
    let row = short.split("largest rotation</th>").nth(1).expect("a row").split("</td>").next().expect("a cell");
    assert!(row.ends_with("° *"), "after {off} s: {row}");
    assert!(
        short.contains(&format!("* reached after the first corner came off its seat, at {off:.3} s")),
        "and says so"
    );
    let long = page("skew45-abutment", &["girder.deck.seat_m={ \"+x\" = 0.1 }"]);
    assert!(!long.contains("* reached after"), "nothing comes off");
}

#[test]
fn a_corner_that_leaves_over_a_side_heads_the_page_too() {
    let narrow = page("skew45-abutment", &["girder.deck.seat_m={ \"+x\" = 0.2, side = 1e-5 }"]);
    assert!(narrow.contains("A corner comes off its seat: deck+x at "), "first of all");
    assert!(narrow.contains("leaves over the side at "), "at its corner");
}

/// The energies of a page, by the names of their rows \[J\].
fn energies(page: &str) -> Vec<(String, f64)> {
    let rows = page.split("<tr><th>").skip(1).filter_map(|row| {
        let (name, rest) = row.split_once("</th>")?;
        let value = rest.split_once(" J</td>")?.0.rsplit('>').next()?;
        Some((name.to_owned(), value.parse().ok()?))
    });
    rows.collect()
}

#[test]
fn the_energies_of_a_report_add_up() {
    // Devices, soil and bearings that yield: every row that there is.
    let page = page("span-as-built", &[]);
    let all = energies(&page);
    let of = |start: &[&str]| -> f64 {
        all.iter().filter(|(name, _)| start.iter().any(|s| name.contains(s))).map(|(_, energy)| energy).sum()
    };
    let work = of(&["work of"]);
    let rest = of(&["kinetic", "stored", "lost", "raised", "released"]);
    assert!(all.len() >= 6 && of(&["lost in devices"]) != 0.0, "{all:?}");
    assert!((work - rest).abs() < 1e-3 * work.abs(), "{work} J of work, {rest} J elsewhere: {all:?}");
    assert!(page.contains("<th>soil behind</th>"), "what the soil bears");
}

#[test]
fn a_report_of_a_viaduct_has_its_piers_and_their_height() {
    let page = page("viaduct-5", &[]);
    assert!(page.contains("<th>pier</th>"), "a row for each");
    assert!(page.contains("H = 9 m <span class=\"open\">(scene)</span>"), "columns as high as the piers of the scene");
    assert!(!page.contains("H = 0 m"), "at abutments too");
    let (plan, _) = page.split_once("</svg>").expect("the plan");
    for name in ["p1", "p4"] {
        assert!(plan.contains(&format!(">{name}</text>")), "{name} has its name in the plan");
    }
    assert_eq!(plan.matches(">50 mm</text>").count(), 6, "the gap at every joint");
    assert!(
        page.contains("caps of piers") && !page.contains("Thick, with squares: devices"),
        "what is drawn, in words"
    );
}

#[test]
fn a_plan_has_the_devices_of_its_scene() {
    let page = page("twin-span-restrained", &[]);
    let (plan, _) = page.split_once("</svg>").expect("the plan");
    assert!(plan.matches("stroke=\"#882255\"").count() >= 2, "two cables");
    assert!(page.contains("Thick, with squares: devices"), "in words");
}

#[test]
fn a_report_of_a_girder_that_bends_has_its_forces_and_says_where_it_is_not_elastic() {
    let [page, kept] = [&["girder.deck.elastic.strength_pa=1e6"][..], &[]].map(|sets| page("deck-30m-elastic", sets));
    for words in ["<th>girder that bends</th>", "<th>|M| at mid-span [MN·m]</th>", "Polynomials of degree"] {
        assert!(page.contains(words), "{words}");
    }
    let (head, rest) = page.split_once("<h2>").expect("headings");
    assert!(head.contains("passes its strength of 1 MPa"), "at the head of the page");
    assert!(!rest.contains("no longer elastic"), "once");
    assert!(!kept.contains("no longer elastic"), "without a strength");
}

#[test]
fn energy_that_a_contact_leaves_with_is_said_in_a_line_of_the_page() {
    let page = page_until("6.5", "viaduct-5", &["contact.between=ends", "motion.angle_deg=35"]);
    assert!(page.contains("<p>g1.corner2 left g2-x over its edge"), "too little to alarm");
    assert!(!page.contains("&lt;p"), "a line, not its text");
}

#[test]
fn a_report_is_a_file_of_html() {
    let said = call(&["report", "skew45-abutment", "--out", "page.pdf"]);
    assert_eq!(said.status, Some(2), "{}", said.out);
    assert!(said.err.contains("page.pdf") && said.err.contains(".html"), "what would do: {}", said.err);
}

#[test]
fn a_report_is_in_the_language_that_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("page.html");
    let path = out.to_str().expect("a UTF-8 path");
    let said = call(&["report", "deck-30m", "--until", "2", "--lang", "ja", "--out", path]);
    assert_eq!(said.status, Some(0), "{}", said.err);
    let page = std::fs::read_to_string(&out).expect("the page");
    for words in ["<html lang=\"ja\">", "<h2>仮定</h2>", "<h2>桁かかりと設計基準</h2>", "桁かかりの前縁", "反発係数"]
    {
        assert!(page.contains(words), "{words}");
    }
    assert!(page.contains(">接触、立体<") && page.contains("<p>実橋の大きさ"), "model and description, too");
    for left in ["Assumptions", "front edge", "girder<", "report-"] {
        assert!(!page.contains(left), "{left} is not Japanese");
    }
    assert_eq!(call(&["report", "deck-30m", "--lang", "xx", "--out", path]).status, Some(2), "no such language");
}

#[test]
fn numbers_in_force_of_piers_and_soil_stand_among_the_assumptions() {
    let viaduct = page("viaduct-5", &[]);
    let assumptions = |page: &str| {
        let from = page.find("<h2>Assumptions</h2>").expect("a section");
        page[from..].split_once("<h2>Ground motion</h2>").expect("the next").0.to_owned()
    };
    let piers = assumptions(&viaduct);
    for number in 1..=4 {
        assert!(piers.contains(&format!("<li>pier p{number}: at ")), "{piers}");
    }
    assert!(piers.contains("k along, across = "), "{piers}");
    let soil = assumptions(&page("span-as-built", &[]));
    assert!(soil.contains("<li>backfill ") && soil.contains(" <b class=\"part\">assumed</b>, F_ult "), "{soil}");
}

#[test]
fn the_ground_motion_is_named_with_its_direction_and_scale() {
    let page = page("two-components", &[]);
    let from = page.find("<h2>Ground motion</h2>").expect("a section");
    let ground = page[from..].split_once("<table>").expect("the peaks").0;
    assert!(ground.contains("synthetic") && ground.contains("0.313 g"), "{ground}");
}

#[test]
fn a_report_of_lead_rubber_has_its_loop_and_how_far_it_goes() {
    let page = page("span-as-built", &[]);
    for words in ["k₁, k₂ = ", "T_eff = ", "h_eq = ", "largest movement in plan", "Arias intensity"] {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn a_seat_longer_than_its_cap_is_warned_of() {
    let sets = ["pier.p1.cap_m=[0.8, 9, 1]"];
    let page = page("viaduct-5", &sets);
    assert!(page.contains("and its cap 0.8 m"), "in the report");
    let said = call(&["check", "viaduct-5", "--set", sets[0]]);
    assert!(
        said.err.contains("the seats on p1 (g1+x, g2-x) are together 1.55885 m long") && said.status == Some(0),
        "{}",
        said.err
    );
}

#[test]
fn a_device_beside_its_girder_is_warned_of() {
    let set = "restrainer.east-left.at_m=[25, 0]";
    let said = call(&["check", "span-as-built", "--set", set]);
    assert!(said.err.contains("restrainer.east-left.at_m is 10 m outside of deck in plan"), "{}", said.err);
    let as_built = call(&["check", "span-as-built"]);
    assert!(!as_built.err.contains("outside of deck"), "{}", as_built.err);
}
