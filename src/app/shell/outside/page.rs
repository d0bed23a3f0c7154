//! Surroundings of the window on a page: a canvas as large as the page, links, and scripts that may ask for readings.
//!
//! `globalThis.girderbench.readings()` gives what the window shows, and `.widgets()` what a screen reader would be told of: role,
//! name, value and place of each \[CSS pixels\], empty at the first call.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

use egui::accesskit::{Node, NodeId, TreeUpdate};
use egui::{Context, PlatformOutput};
use egui_winit::State;
use js_sys::{JSON, Object, Reflect};
use serde_json::{Value, json};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{BeforeUnloadEvent, Document, HtmlCanvasElement};
use winit::event_loop::{ActiveEventLoop, EventLoop, EventLoopProxy};
use winit::platform::web::{EventLoopExtWebSys as _, WindowAttributesExtWebSys as _};
use winit::window::{Window, WindowAttributes};

use crate::app::bench::Workbench;
use crate::app::run::answer::Answer;
use crate::app::shell::window::{News, Shell};
use crate::files::SceneSource;
use crate::scene::{SceneErrors, presets};

/// Of the elements of the page.
const CANVAS: &str = "girderbench";
const MESSAGE: &str = "message";

/// Requests from outside.
#[derive(Clone, Copy, Debug)]
pub(super) enum Asked {
    /// The page's address leads elsewhere.
    Link,
    /// A script wants to know of widgets.
    Widgets,
}

/// Surroundings of the window.
pub(super) struct Outside {
    seen: Rc<RefCell<Seen>>,
}

/// Readings for scripts.
#[derive(Default)]
struct Seen {
    values: Value,
    answer: Option<Arc<Answer>>,
    dirty: bool,
    title: String,
    widgets: Option<TreeUpdate>,
    /// When the first frame had been drawn, since the page was asked for \[ms\].
    first: Option<f64>,
}

/// Opens the workbench on the canvas of the page, where the page's address leads.
///
/// # Errors
/// None but in words: the browser takes no events.
pub fn open_page() -> Result<(), String> {
    let scene = presets::load(presets::OPENING).map_err(|errors: SceneErrors| errors.to_string())?;
    let event_loop = EventLoop::<News>::with_user_event().build().map_err(|error| error.to_string())?;
    let proxy = event_loop.create_proxy();
    let bench = Workbench::new(scene, SceneSource::of(presets::OPENING));
    event_loop.spawn_app(Shell { bench, proxy, language: None, open: None, failed: None });
    Ok(())
}

/// Tells on the page why there is no window.
pub fn give_up(words: &str) {
    if let Some(message) = document().and_then(|document| document.get_element_by_id(MESSAGE)) {
        message.set_text_content(Some(words));
    }
}

fn document() -> Option<Document> {
    web_sys::window()?.document()
}

fn canvas() -> Option<HtmlCanvasElement> {
    document()?.get_element_by_id(CANVAS)?.dyn_into().ok()
}

/// Text after the `#` of the page's address.
fn fragment() -> String {
    web_sys::window().and_then(|window| window.location().hash().ok()).unwrap_or_default()
}

/// The window as it is first seen.
pub(super) fn look(plain: WindowAttributes) -> WindowAttributes {
    plain.with_canvas(canvas())
}

impl Outside {
    /// Has whoever asks be heard.
    pub(super) fn new(_: &ActiveEventLoop, (_, egui): (&Window, &mut State), proxy: &EventLoopProxy<News>) -> Self {
        let seen = Rc::new(RefCell::new(Seen::default()));
        // A page without these is one that nobody asks.
        let _ = offer(&seen, egui.egui_ctx(), proxy);
        let _ = listen(&seen, proxy);
        let _ = canvas().map(|canvas| canvas.focus());
        // Where the page's address leads is the first thing that is asked.
        let _ = proxy.send_event(News::Asked(Asked::Link));
        Self { seen }
    }

    /// Does what was asked.
    pub(super) fn answer(asked: Asked, (egui, bench): (&mut State, &mut Workbench)) {
        match asked {
            Asked::Link => bench.follow(&fragment()),
            Asked::Widgets => egui.egui_ctx().enable_accesskit(),
        }
    }

    /// A frame has been laid out.
    pub(super) fn seen(&mut self, bench: &Workbench, output: &PlatformOutput) {
        let mut seen = self.seen.borrow_mut();
        let (scene, runner) = (bench.files.document.scene(), &bench.replay.runner);
        seen.values = json!({
            "scene": scene.name,
            "lesson": bench.learning.lesson().map(|lesson| lesson.name),
            "t": bench.replay.t(),
            "end": bench.replay.end(),
            "playing": bench.replay.playback.clock.playing,
            "language": bench.window.language.code(),
            "notice": bench.window.notice(),
            "adapter": bench.view.adapter(),
            "stale": runner.is_stale() || runner.is_coarse(),
            "problems": runner.problems().map(ToString::to_string),
        });
        seen.answer = runner.answer().cloned();
        seen.dirty = bench.files.document.is_dirty();
        if output.accesskit_update.is_some() {
            seen.widgets.clone_from(&output.accesskit_update);
        }
        let title = bench.title();
        if let Some(document) = document().filter(|_| seen.title != title) {
            document.set_title(&title);
            seen.title = title;
        }
        if seen.first.is_none() {
            drop(seen);
            self.first();
        }
    }

    /// The first frame is about to be drawn; the next one is asked for when it has been.
    fn first(&self) {
        let seen = self.seen.clone();
        let shown = Closure::once_into_js(move || {
            let at = web_sys::window().and_then(|window| window.performance()).map(|clock| clock.now());
            seen.borrow_mut().first = at;
            give_up("");
        });
        let _ = web_sys::window().map(|window| window.request_animation_frame(shown.unchecked_ref()));
    }
}

/// Gives scripts of the page what they may call.
fn offer(seen: &Rc<RefCell<Seen>>, context: &Context, proxy: &EventLoopProxy<News>) -> Result<(), JsValue> {
    let calls: Object = Reflect::get(&js_sys::global(), &"girderbench".into())?.dyn_into()?;
    let asked = seen.clone();
    let readings = Closure::<dyn Fn() -> Result<JsValue, JsValue>>::new(move || object(&asked.borrow().readings()));
    let (asked, context, proxy) = (seen.clone(), context.clone(), proxy.clone());
    let widgets = Closure::<dyn Fn() -> Result<JsValue, JsValue>>::new(move || {
        // The window has ended: nothing to be told.
        let _ = proxy.send_event(News::Asked(Asked::Widgets));
        object(&asked.borrow().widgets(context.zoom_factor()))
    });
    Reflect::set(&calls, &"readings".into(), &readings.into_js_value())?;
    Reflect::set(&calls, &"widgets".into(), &widgets.into_js_value())?;
    Ok(())
}

/// Follows the page's address, and has the browser ask before unsaved work is left.
fn listen(seen: &Rc<RefCell<Seen>>, proxy: &EventLoopProxy<News>) -> Result<(), JsValue> {
    let window = web_sys::window().ok_or(JsValue::NULL)?;
    let proxy = proxy.clone();
    let leads = Closure::<dyn Fn()>::new(move || drop(proxy.send_event(News::Asked(Asked::Link))));
    window.set_onhashchange(Some(leads.into_js_value().unchecked_ref()));
    let seen = seen.clone();
    let leaves = Closure::<dyn Fn(BeforeUnloadEvent)>::new(move |event: BeforeUnloadEvent| {
        if seen.borrow().dirty {
            event.prevent_default();
        }
    });
    window.set_onbeforeunload(Some(leaves.into_js_value().unchecked_ref()));
    Ok(())
}

fn object(value: &Value) -> Result<JsValue, JsValue> {
    JSON::parse(&value.to_string())
}

impl Seen {
    fn readings(&self) -> Value {
        let mut values = self.values.clone();
        values["first_picture_ms"] = json!(self.first);
        if let Some(answer) = &self.answer {
            values["digest"] = json!(format!("{:016x}", answer.history.digest()));
            values["summary"] = json!(answer.summary);
            values["took_s"] = json!(answer.took.as_secs_f64());
        }
        values
    }

    fn widgets(&self, zoom: f32) -> Value {
        let Some(TreeUpdate { nodes, .. }) = &self.widgets else { return json!([]) };
        let words = |of: &NodeId| {
            let label = nodes.iter().find(|(id, _)| id == of).map(|(_, node)| node);
            label.and_then(|node| node.label().or_else(|| node.value()))
        };
        let name = |node: &Node| json!(node.label().or_else(|| node.labelled_by().first().and_then(words)));
        nodes.iter().filter_map(|(_, node)| widget(node, &name(node), f64::from(zoom))).collect()
    }
}

/// Description of a widget that has a place, as for a screen reader.
fn widget(node: &Node, name: &Value, zoom: f64) -> Option<Value> {
    let place = node.bounds()?;
    Some(json!({
        "role": format!("{:?}", node.role()),
        "name": name,
        "value": node.value(),
        "number": node.numeric_value(),
        "disabled": node.is_disabled(),
        "x": place.x0 * zoom,
        "y": place.y0 * zoom,
        "width": place.width() * zoom,
        "height": place.height() * zoom,
    }))
}
