//! The shell of a page in HTML that opens by itself: style, head and body, every picture inside.

const STYLE: &str = "
body { font: 15px/1.5 system-ui, sans-serif; color: #222; max-width: 1100px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.7em; } h2 { margin-top: 2.2em; border-bottom: 1px solid #ccc; } h3 { margin-top: 1.8em; }
table { border-collapse: collapse; margin: 0.8em 0; font-size: 0.93em; }
th, td { border-bottom: 1px solid #ddd; padding: 0.25em 0.6em; text-align: left; vertical-align: top; }
th { background: #f4f4f4; } .number { font-variant-numeric: tabular-nums; } .word { white-space: nowrap; }
.yes { color: #00694d; font-weight: 600; } .part { color: #8a5a00; font-weight: 600; }
.no { color: #a83f00; font-weight: 600; } .open { color: #6b6b6b; }
td .yes, td .no { white-space: nowrap; }
.picture { overflow-x: auto; } .picture svg { max-width: 100%; height: auto; }
figure { margin: 1.4em 0; } figcaption { color: #444; font-size: 0.93em; }
details { border-bottom: 1px solid #ddd; } summary { padding: 0.35em 0; cursor: pointer; }
code { background: #f4f4f4; padding: 0 0.25em; }
@media print { details { break-inside: avoid; } .picture { break-inside: avoid; } }
";

/// Begins a page of this title, which is HTML already.
pub fn begin(title: &str, language: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">\
         <title>{title}</title><style>{STYLE}</style></head><body>\n"
    )
}

/// Ends it.
pub const END: &str = "</body></html>\n";
