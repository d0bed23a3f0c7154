//! The program as a page in a browser: what runs when it has been loaded, and what scripts of the page may call.
//!
//! `globalThis.girderbench.presets()` gives the names of the presets, and `.answer(scene)` runs one of them, or the text of
//! a scene file: `{digest, tables}`, where `tables` holds the text of each table that `girderbench run --out` writes. Both
//! work without a window, so that a script under node can compare answers with those of the program.

use js_sys::{Array, Object, Reflect};
use wasm_bindgen::JsValue;
use wasm_bindgen::closure::Closure;

use crate::scene::{Scene, SceneErrors, format, presets};
use crate::sim::History;
use crate::tables::{TableOptions, all, in_memory};

/// Begins: gives the page's scripts what they may call, and opens the window where there is a page.
pub fn main() {
    // The result is dropped: where globalThis takes no property, no script can call these functions either.
    let _ = offer();
    #[cfg(feature = "gui")]
    if web_sys::window().is_some() {
        std::panic::set_hook(Box::new(|why| crate::app::give_up(&why.to_string())));
        if let Err(why) = crate::app::open_page() {
            crate::app::give_up(&why);
        }
    }
}

fn offer() -> Result<(), JsValue> {
    let calls = Object::new();
    let names =
        Closure::<dyn Fn() -> Array>::new(|| presets::all().iter().map(|preset| JsValue::from(preset.name)).collect());
    let answer = Closure::<dyn Fn(String) -> Result<Object, JsValue>>::new(|scene: String| answer(&scene));
    Reflect::set(&calls, &"presets".into(), &names.into_js_value())?;
    Reflect::set(&calls, &"answer".into(), &answer.into_js_value())?;
    Reflect::set(&js_sys::global(), &"girderbench".into(), &calls).map(|_| ())
}

/// The scene of a preset, or of a file's text.
fn scene_of(words: &str) -> Result<Scene, SceneErrors> {
    if presets::get(words).is_some() { presets::load(words) } else { format::parse(words, "scene") }
}

fn answer(words: &str) -> Result<Object, JsValue> {
    let complaint = |errors: SceneErrors| js_sys::Error::new(&errors.to_string());
    let history = scene_of(words).and_then(|scene| History::of(&scene)).map_err(complaint)?;
    let tables = Object::new();
    for table in all(&history, &TableOptions::default()) {
        let text = in_memory(|out| table.write(out));
        Reflect::set(&tables, &table.name.as_str().into(), &String::from_utf8_lossy(&text).as_ref().into())?;
    }
    let answer = Object::new();
    Reflect::set(&answer, &"digest".into(), &format!("{:016x}", history.digest()).into())?;
    Reflect::set(&answer, &"tables".into(), &tables)?;
    Ok(answer)
}
