//! Claims about the shaders: each is valid, stays inside what every backend can do, and has its pass.

use std::collections::BTreeSet;
use std::path::Path;

use girderbench::render::shaders;
use naga::valid::{Capabilities, ValidationFlags, Validator};

fn stems(folder: &str, extension: &str) -> BTreeSet<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = std::fs::read_dir(&root).unwrap_or_else(|e| panic!("{}: {e}", root.display()));
    let paths = entries.map(|entry| entry.expect("a folder can be listed").path());
    let files = paths.filter(|p| p.extension().is_some_and(|e| e == extension));
    files.filter_map(|p| Some(p.file_stem()?.to_str()?.to_owned())).collect()
}

#[test]
fn every_shader_parses_and_validates() {
    for (stem, source) in shaders() {
        let module =
            naga::front::wgsl::parse_str(source).unwrap_or_else(|e| panic!("{stem}: {}", e.emit_to_string(source)));
        // No capability beyond the base: the same code then runs on Vulkan, GLES and in a browser.
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        validator.validate(&module).unwrap_or_else(|e| panic!("{stem}: {}", e.emit_to_string(source)));
    }
}

#[test]
fn every_shader_has_its_pass_and_every_pass_its_shader() {
    let compiled: BTreeSet<String> = shaders().iter().map(|(stem, _)| (*stem).to_owned()).collect();
    let mut passes = stems("src/render/pass", "rs");
    passes.remove("mod");
    assert_eq!(stems("shaders", "wgsl"), compiled, "shaders/*.wgsl against render::shaders()");
    assert_eq!(passes, compiled, "src/render/pass/*.rs against render::shaders()");
}

#[test]
fn every_shader_says_its_spaces_and_its_instance() {
    for stem in stems("shaders", "wgsl") {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders").join(format!("{stem}.wgsl"));
        let source = std::fs::read_to_string(&path).expect("a shader can be read");
        let header: String = source.lines().take_while(|l| l.starts_with("//")).collect();
        for word in ["nput:", "utput:", "ne "] {
            assert!(header.contains(word), "{stem}.wgsl opens with its input, its output and what one instance is");
        }
    }
}

#[test]
fn every_shared_part_is_used() {
    for part in stems("shaders/shared", "wgsl") {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders/shared").join(format!("{part}.wgsl"));
        let text = std::fs::read_to_string(&path).expect("a shared part can be read");
        assert!(shaders().iter().any(|(_, source)| source.contains(&text)), "shared/{part}.wgsl is part of a shader");
    }
}
