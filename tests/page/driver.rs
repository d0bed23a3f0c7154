//! A browser that is driven: chromedriver by the `WebDriver` protocol, and files served to it.

use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// Chromium's own warning to a page that asks whether there is WebGPU, where there is none.
const NO_WEBGPU: &str = "No available adapters.";

/// Longest wait for the browser to do one thing.
const PATIENCE: Duration = Duration::from_mins(1);

/// Asks again and again until there is an answer, or it is too late.
#[expect(clippy::disallowed_methods, reason = "how long a browser takes")]
fn within<T>(patience: Duration, ask: impl Fn() -> Option<T>) -> Option<T> {
    let begun = Instant::now();
    while begun.elapsed() < patience {
        if let Some(answer) = ask() {
            return Some(answer);
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    None
}

/// Serves the files of a folder to this machine; the address.
pub(crate) fn serve(folder: &Path) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = format!("http://{}", listener.local_addr().expect("bound"));
    let folder = folder.to_owned();
    std::thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let folder = folder.clone();
            // A browser that has changed its mind hangs up.
            std::thread::spawn(move || drop(send_file(stream, &folder)));
        }
    });
    address
}

fn send_file(mut stream: TcpStream, folder: &Path) -> std::io::Result<()> {
    let mut line = String::new();
    let mut reader = BufReader::new(stream.try_clone()?);
    reader.read_line(&mut line)?;
    let mut header = String::new();
    while reader.read_line(&mut header)? > 2 {
        header.clear();
    }
    let path = line.split(' ').nth(1).unwrap_or("/").trim_start_matches('/');
    let kind = match path.rsplit('.').next() {
        Some("html") => "text/html",
        Some("js") => "text/javascript",
        Some("wasm") => "application/wasm",
        _ => "application/octet-stream",
    };
    let (status, bytes) = fs::read(folder.join(path)).map_or(("404 Not Found", Vec::new()), |bytes| ("200 OK", bytes));
    let length = bytes.len();
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n"
    )?;
    stream.write_all(&bytes)
}

/// A page in a browser; it ends when it is dropped.
pub(crate) struct Page {
    driver: Child,
    port: u16,
    session: String,
    /// Where its downloads go.
    pub(crate) downloads: PathBuf,
}

impl Drop for Page {
    fn drop(&mut self) {
        let _ = self.ask("DELETE", "", None);
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}

impl Page {
    /// Starts a browser with a window of this size.
    pub(crate) fn open([width, height]: [u32; 2], downloads: &Path) -> Self {
        let mut driver = Command::new("chromedriver")
            .arg("--port=0")
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("chromedriver is installed");
        let mut lines = BufReader::new(driver.stdout.take().expect("piped")).lines().map_while(Result::ok);
        let port =
            lines.find_map(|line| line.split("successfully on port ").nth(1)?.trim_end_matches('.').parse().ok());
        // It goes on to speak, and must not be stopped by nobody's listening.
        std::thread::spawn(move || lines.for_each(drop));
        let port = port.expect("it says its port");
        let arguments = json!([
            "--headless=new",
            "--no-sandbox",
            "--disable-dev-shm-usage",
            "--hide-scrollbars",
            "--lang=en",
            "--use-gl=angle",
            "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader",
            format!("--window-size={width},{height}"),
        ]);
        let wanted = json!({ "capabilities": { "alwaysMatch": {
            "goog:chromeOptions": { "args": arguments },
            "goog:loggingPrefs": { "browser": "ALL" },
        } } });
        let mut page = Self { driver, port, session: String::new(), downloads: downloads.to_owned() };
        let begun = page.ask("POST", "/session", Some(&wanted)).expect("a session");
        page.session = format!("/session/{}", begun["sessionId"].as_str().expect("it has a name"));
        let allowed = json!({ "behavior": "allow", "downloadPath": downloads });
        page.command("/goog/cdp/execute", &json!({ "cmd": "Browser.setDownloadBehavior", "params": allowed }));
        page
    }

    /// One request to the driver.
    fn ask(&self, method: &str, path: &str, body: Option<&Value>) -> Result<Value, String> {
        let body = body.map(Value::to_string).unwrap_or_default();
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).map_err(|e| e.to_string())?;
        stream.set_read_timeout(Some(PATIENCE)).map_err(|e| e.to_string())?;
        let head = format!("{method} {}{path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n", self.session, self.port);
        let kind = format!("Content-Type: application/json\r\nContent-Length: {}\r\nConnection: close\r\n", body.len());
        write!(stream, "{head}{kind}\r\n{body}").map_err(|e| e.to_string())?;
        let mut reader = BufReader::new(stream);
        let (mut line, mut length) = (String::new(), 0);
        while reader.read_line(&mut line).map_err(|e| e.to_string())? > 2 {
            if let Some((name, value)) = line.split_once(':')
                && name.eq_ignore_ascii_case("content-length")
            {
                length = value.trim().parse().map_err(|_| format!("a length: {line}"))?;
            }
            line.clear();
        }
        let mut bytes = vec![0; length];
        reader.read_exact(&mut bytes).map_err(|e| e.to_string())?;
        let answer: Value = serde_json::from_slice(&bytes).map_err(|e| e.to_string())?;
        match answer["value"]["error"].as_str() {
            Some(_) => Err(answer["value"].to_string()),
            None => Ok(answer["value"].clone()),
        }
    }

    fn command(&self, path: &str, body: &Value) -> Value {
        self.ask("POST", path, Some(body)).unwrap_or_else(|words| panic!("{path}: {words}"))
    }

    /// Goes to an address.
    pub(crate) fn go(&self, address: &str) {
        self.command("/url", &json!({ "url": address }));
    }

    /// What a script answers.
    pub(crate) fn script(&self, script: &str) -> Value {
        self.command("/execute/sync", &json!({ "script": script, "args": [] }))
    }

    /// What the window shows.
    pub(crate) fn readings(&self) -> Value {
        self.script("return globalThis.girderbench?.readings?.() ?? {}")
    }

    /// Waits until something holds of what the window shows.
    pub(crate) fn until(&self, what: &str, holds: impl Fn(&Value) -> bool) -> Value {
        let found = within(PATIENCE, || Some(self.readings()).filter(&holds));
        let message = || self.script("return document.getElementById('message').textContent");
        found.unwrap_or_else(|| panic!("{what}: {}; {}; {:?}", self.readings(), message(), self.complaints()))
    }

    /// The widget of a role with a name or a value that begins so, once there is one.
    pub(crate) fn widget(&self, role: &str, begins: &str) -> Value {
        let found = within(PATIENCE, || self.widget_now(role, begins));
        found.unwrap_or_else(|| panic!("no {role} {begins}: {}", self.widgets()))
    }

    fn widgets(&self) -> Value {
        self.script("return girderbench.widgets()")
    }

    fn widget_now(&self, role: &str, begins: &str) -> Option<Value> {
        // Letters of the name or value that begins so; the shortest, as "Export picture" begins "Export picture for print" too.
        let letters = |widget: &Value| {
            let words = [&widget["name"], &widget["value"]].map(|words| words.as_str().unwrap_or_default());
            words.into_iter().filter(|words| words.starts_with(begins)).map(str::len).min()
        };
        let widgets = self.widgets();
        let of_role = widgets.as_array().into_iter().flatten().filter(|widget| widget["role"] == role);
        of_role
            .filter_map(|widget| Some((letters(widget)?, widget)))
            .min_by_key(|(letters, _)| *letters)
            .map(|(_, widget)| widget.clone())
    }

    /// Chooses an item of a menu. A menu that does not open is clicked once more: on a busy machine the press and the release of a click
    /// can come in one frame with the end of what was done before.
    pub(crate) fn choose(&self, menu: &str, item: &str) {
        self.click(&self.widget("Button", menu));
        if within(PATIENCE / 4, || self.widget_now("Button", item)).is_none() {
            self.click(&self.widget("Button", menu));
        }
        self.click(&self.widget("Button", item));
    }

    /// Presses the mouse on a widget and lets it go so many pixels to the right.
    pub(crate) fn drag(&self, widget: &Value, right: f64) {
        let side =
            |at: &str, size: &str| widget[at].as_f64().expect("a place") + 0.5 * widget[size].as_f64().expect("a size");
        let (x, y) = (side("x", "width"), side("y", "height"));
        let to = |by: f64| json!({ "type": "pointerMove", "duration": 60, "x": (x + by).round(), "y": y.round() });
        // Each in a frame of its own: within one the press would be where the mouse is at its end.
        let wait = json!({ "type": "pause", "duration": 150 });
        let (down, up) = (json!({ "type": "pointerDown", "button": 0 }), json!({ "type": "pointerUp", "button": 0 }));
        let mut steps = vec![to(0.0), wait.clone(), down, wait.clone()];
        if right != 0.0 {
            steps.extend((1..=4).flat_map(|step| [to(right * f64::from(step) / 4.0), wait.clone()]));
        }
        steps.push(up);
        let mouse =
            json!({ "type": "pointer", "id": "mouse", "parameters": { "pointerType": "mouse" }, "actions": steps });
        self.command("/actions", &json!({ "actions": [mouse] }));
    }

    /// Clicks a widget.
    pub(crate) fn click(&self, widget: &Value) {
        self.drag(widget, 0.0);
    }

    /// Presses a key.
    pub(crate) fn key(&self, key: &str) {
        let steps = json!([{ "type": "keyDown", "value": key }, { "type": "pause", "duration": 60 }, { "type": "keyUp", "value": key }]);
        self.command("/actions", &json!({ "actions": [{ "type": "key", "id": "keys", "actions": steps }] }));
    }

    /// A picture of the page, as PNG in base64.
    pub(crate) fn picture(&self) -> String {
        let picture = self.ask("GET", "/screenshot", None).expect("a picture");
        picture.as_str().expect("text").to_owned()
    }

    /// Warnings and errors that have been written to the console since the last time.
    pub(crate) fn complaints(&self) -> Vec<String> {
        let log = self.command("/se/log", &json!({ "type": "browser" }));
        let bad = |entry: &&Value| entry["level"] == "SEVERE" || entry["level"] == "WARNING";
        let bad = log.as_array().into_iter().flatten().filter(bad).map(|entry| entry["message"].to_string());
        bad.filter(|words| !words.contains(NO_WEBGPU)).collect()
    }

    /// A file that has been downloaded, once it is whole.
    pub(crate) fn downloaded(&self, name: &str) -> Vec<u8> {
        let path = self.downloads.join(name);
        let found = within(PATIENCE, || fs::read(&path).ok().filter(|bytes| !bytes.is_empty()));
        found.unwrap_or_else(|| panic!("no {}", path.display()))
    }
}
