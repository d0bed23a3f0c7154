//! The comparison of normal laws: what a hit returns, how deep and how long, against closed forms.

use girderbench::study::laws;

use crate::support::within;

#[test]
fn a_hit_of_every_law_is_that_of_its_closed_form() {
    // e', greatest penetration [mm], contact time [ms] at 0.3 m/s, e = 0.4, exact calibration, 2 kg, K = 1.55e5 N/m.
    let known = [
        ("kelvin-voigt", 0.4, 0.740_368_332_179_9, 11.755_132_4),
        ("kelvin-voigt, clamp", 0.4, 0.681_554_201_096_5, 9.284_462_2),
        ("approach", 0.4, 0.431_052_724_864_3, 9.386_800_1),
        ("hertz", 1.0, 1.077_631_812_161, 10.572_556_6),
        ("hertz-damp", 0.4, 0.776_847_021_985_6, 12.506_290_2),
        ("hertz-viscous", 0.4, 0.798_090_880_286_1, 11.991_315_8),
        ("jankowski", 0.4, 0.517_747_960_168_7, 10.394_030_7),
        ("bilinear", 0.4, 0.792_642_939_878_9, 13.421_640_6),
    ];
    let outcomes = laws::study().unwrap_or_else(|errors| panic!("{errors}"));
    assert_eq!(outcomes.len(), known.len());
    for (name, returned, depth, lasting) in known {
        let found = outcomes.iter().find(|o| o.variant.name() == name).unwrap_or_else(|| panic!("{name}"));
        within(&format!("{name}: e'"), found.returned - returned, 1e-9);
        // The depth is that of 400 points: next to a maximum, (π/400)²/8 of it.
        within(&format!("{name}: depth"), found.depth * 1e3 / depth - 1.0, 1e-4);
        if !name.ends_with("clamp") {
            within(&format!("{name}: time"), found.lasting * 1e3 - lasting, 1e-6);
        }
        assert!(found.hits > 20 && found.touches.len() > 1000, "{name}: {} hits", found.hits);
        within(&format!("{name}: ledger"), found.residual, 1e-8);
    }
    let page = laws::page(&outcomes, &girderbench::study::Occasion::default(), "svg");
    assert!(page.matches("| `").count() == 16 && page.contains("laws-hit.svg"), "two tables");
    for (name, svg) in laws::pictures(&outcomes) {
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>") && !svg.contains("NaN"), "{name}");
    }
}
