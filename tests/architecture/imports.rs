//! Which file of `src` imports which: `use` trees, inline paths and re-exports, resolved to the file that defines a name.
//!
//! A `mod.rs` that declares and re-exports its children does not import them by that; a name that it hands on is its
//! child's. Code of a test module at the end of a file does not count.

use std::collections::{BTreeMap, BTreeSet};

use crate::source::{Source, is_word};

/// Words that define a name.
const DEFINES: [&str; 8] = ["fn", "struct", "enum", "const", "type", "trait", "static", "union"];

/// How many re-exports a name may be handed on through.
const MOST_HOPS: usize = 8;

/// A module: its file, its code, and what it hands on.
struct Module {
    file: String,
    code: String,
    /// Name, and the path that it is handed on from.
    handed_on: Vec<(String, Vec<String>)>,
    /// Paths whose every name is handed on.
    globs: Vec<Vec<String>>,
}

/// The imports of all files.
pub(crate) struct Imports {
    modules: BTreeMap<Vec<String>, Module>,
    arrows: BTreeMap<String, BTreeSet<String>>,
}

impl Imports {
    /// Reads them from the files of `src`.
    pub(crate) fn of(sources: &[Source]) -> Self {
        let mut imports = Self { modules: BTreeMap::new(), arrows: BTreeMap::new() };
        for source in sources.iter().filter(|source| source.path != "src/main.rs") {
            let module = Module {
                file: source.path.clone(),
                code: source.production().to_owned(),
                handed_on: Vec::new(),
                globs: Vec::new(),
            };
            imports.modules.insert(module_of(&source.path), module);
        }
        imports.read_re_exports();
        imports.read_arrows();
        imports
    }

    /// Every import: the file that imports, and the file that it imports from.
    pub(crate) fn arrows(&self) -> impl Iterator<Item = (&str, &str)> {
        self.arrows.iter().flat_map(|(from, all)| all.iter().map(|to| (from.as_str(), to.as_str())))
    }

    /// Sets of two files or more that reach each other.
    pub(crate) fn circles(&self) -> Vec<BTreeSet<String>> {
        let reached: BTreeMap<&str, BTreeSet<&str>> =
            self.arrows.keys().map(|file| (file.as_str(), self.reached(file))).collect();
        let mut circles: Vec<BTreeSet<String>> = Vec::new();
        for (file, all) in &reached {
            let back = |other: &&&str| reached.get(**other).is_some_and(|there| there.contains(file));
            let circle: BTreeSet<String> = all.iter().filter(back).map(|other| (*other).to_owned()).collect();
            if circle.len() > 1 && !circles.contains(&circle) {
                circles.push(circle);
            }
        }
        circles
    }

    fn reached(&self, file: &str) -> BTreeSet<&str> {
        let (mut reached, mut next) = (BTreeSet::new(), vec![file]);
        while let Some(file) = next.pop() {
            for to in self.arrows.get(file).into_iter().flatten() {
                if reached.insert(to.as_str()) {
                    next.push(to);
                }
            }
        }
        reached
    }

    fn read_re_exports(&mut self) {
        let paths: Vec<Vec<String>> = self.modules.keys().cloned().collect();
        for at in paths {
            let found: Vec<Vec<String>> = statements(&self.modules[&at].code)
                .into_iter()
                .filter(|statement| statement.public)
                .flat_map(|statement| leaves(&statement.tree))
                .filter_map(|path| self.absolute(&at, &path))
                .collect();
            let module = self.modules.get_mut(&at).expect("it was listed");
            for mut path in found {
                match path.last().map(String::as_str) {
                    Some("*") => {
                        path.pop();
                        module.globs.push(path);
                    }
                    Some(name) => module.handed_on.push((name.to_owned(), path.clone())),
                    None => {}
                }
            }
        }
    }

    fn read_arrows(&mut self) {
        let mut arrows = BTreeMap::new();
        for (at, module) in &self.modules {
            let own = |path: &Vec<String>| path.len() == at.len() + 1 && path.starts_with(at);
            let mut used = BTreeSet::new();
            let mut aliases: BTreeMap<String, Vec<String>> = self
                .modules
                .keys()
                .filter(|path| own(path))
                .map(|path| (path[at.len()].clone(), path.clone()))
                .collect();
            let mut rest = module.code.clone();
            for statement in statements(&module.code) {
                rest = rest.replacen(&statement.text, "", 1);
                for path in leaves(&statement.tree).iter().filter_map(|path| self.absolute(at, path)) {
                    // A parent hands its children's names on.
                    if statement.public && path.starts_with(at) {
                        continue;
                    }
                    if self.modules.contains_key(&path) {
                        aliases.insert(path.last().cloned().unwrap_or_default(), path);
                    } else {
                        used.extend(self.file_of(&path, 0));
                    }
                }
            }
            let inline = inline_paths(&rest).into_iter();
            used.extend(inline.filter_map(|path| self.inline(at, &aliases, &path)));
            used.remove(&module.file);
            arrows.insert(module.file.clone(), used);
        }
        self.arrows = arrows;
    }

    /// The file that a path in the midst of the code leads to, if it begins at the crate, at a parent or at an alias.
    fn inline(&self, at: &[String], aliases: &BTreeMap<String, Vec<String>>, path: &[String]) -> Option<String> {
        if ["crate", "super", "self"].contains(&path[0].as_str()) {
            return self.file_of(&self.absolute(at, path)?, 0);
        }
        let alias = aliases.get(&path[0])?;
        self.file_of(&[alias, &path[1..]].concat(), 0)
    }

    /// A path from the crate's root on; `None` where it leads out of the crate.
    fn absolute(&self, at: &[String], path: &[String]) -> Option<Vec<String>> {
        let first = path.first()?;
        let mut base = at.to_vec();
        let mut rest = path;
        match first.as_str() {
            "crate" => {
                base.clear();
                rest = &path[1..];
            }
            "self" => rest = &path[1..],
            "super" => {
                while rest.first().is_some_and(|word| word == "super") {
                    base.pop()?;
                    rest = &rest[1..];
                }
            }
            name => {
                base.push(name.to_owned());
                if !self.modules.contains_key(&base) {
                    return None;
                }
                rest = &path[1..];
            }
        }
        let mut whole = [&base[..], rest].concat();
        if whole.last().is_some_and(|word| word == "self") {
            whole.pop();
        }
        Some(whole)
    }

    /// The file that defines what a path from the root names.
    fn file_of(&self, path: &[String], hops: usize) -> Option<String> {
        let depth = (0..=path.len()).rev().find(|&depth| self.modules.contains_key(&path[..depth]))?;
        let module = &self.modules[&path[..depth]];
        let Some(name) = path.get(depth).filter(|_| hops < MOST_HOPS) else { return Some(module.file.clone()) };
        if let Some((_, from)) = module.handed_on.iter().find(|(handed, from)| handed == name && from[..] != *path) {
            return self.file_of(&[from, &path[depth + 1..]].concat(), hops + 1);
        }
        let glob = module.globs.iter().find(|from| self.modules.get(*from).is_some_and(|m| defines(&m.code, name)));
        match glob {
            Some(from) if !defines(&module.code, name) => self.file_of(&[from, &path[depth..]].concat(), hops + 1),
            _ => Some(module.file.clone()),
        }
    }
}

/// `src/a/b/mod.rs` and `src/a/b.rs` → a, b.
fn module_of(path: &str) -> Vec<String> {
    let inside = path.trim_start_matches("src/").trim_end_matches(".rs");
    let words = inside.split('/').map(str::to_owned);
    words.filter(|word| word != "mod" && word != "lib").collect()
}

/// A `use` statement.
struct Statement {
    public: bool,
    text: String,
    tree: String,
}

fn statements(code: &str) -> Vec<Statement> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = code[at..].find("use ").map(|i| at + i) {
        at = start + 4;
        let line = code[..start].rsplit('\n').next().unwrap_or_default().trim();
        let begins = line.is_empty() || (line.starts_with("pub") && (line == "pub" || line.ends_with(')')));
        let Some(end) = code[start..].find(';').filter(|_| begins) else { continue };
        let tree = code[start + 4..start + end].to_owned();
        found.push(Statement { public: line.starts_with("pub"), text: code[start..=start + end].to_owned(), tree });
        at = start + end;
    }
    found
}

/// Every path of a `use` tree; a glob ends in `*`, an alias counts as its name.
fn leaves(tree: &str) -> Vec<Vec<String>> {
    let tree = tree.trim();
    let Some(open) = tree.find('{') else {
        let path = tree.split(" as ").next().unwrap_or(tree);
        return vec![path.split("::").map(|word| word.trim().to_owned()).collect()];
    };
    let stem: Vec<String> =
        tree[..open].split("::").map(|word| word.trim().to_owned()).filter(|w| !w.is_empty()).collect();
    let inside = tree[open + 1..].rsplit_once('}').map_or("", |(inside, _)| inside);
    let (mut parts, mut depth) = (vec![String::new()], 0_i32);
    for c in inside.chars() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        match c {
            ',' if depth == 0 => parts.push(String::new()),
            c => parts.last_mut().expect("one at least").push(c),
        }
    }
    let parts = parts.iter().filter(|part| !part.trim().is_empty());
    parts.flat_map(|part| leaves(part)).map(|path| [stem.clone(), path].concat()).collect()
}

/// Every path of two words or more: `a::b::c`.
fn inline_paths(code: &str) -> Vec<Vec<String>> {
    let words = code.split(|c: char| !is_word(c) && c != ':');
    let paths = words.map(|path| path.split("::").map(str::to_owned).collect::<Vec<_>>());
    paths.filter(|path| path.len() > 1 && path.iter().all(|word| !word.is_empty() && !word.contains(':'))).collect()
}

/// Whether code defines a name.
fn defines(code: &str, name: &str) -> bool {
    let words: Vec<&str> = code.split(|c: char| !is_word(c)).filter(|word| !word.is_empty()).collect();
    words.windows(2).any(|pair| DEFINES.contains(&pair[0]) && pair[1] == name)
}

#[test]
fn the_graph_finds_what_it_is_for() {
    let source = |path: &str, code: &str| Source { path: path.into(), text: code.into(), code: code.into() };
    let files = [
        source("src/lib.rs", "pub mod a;\npub mod b;"),
        source("src/a/mod.rs", "mod one;\nmod two;\npub use one::One;\npub(crate) use two::*;"),
        source("src/a/one.rs", "use super::two::Two;\npub struct One(Two);"),
        source("src/a/two.rs", "pub struct Two;\nfn far() { crate::b::f() }"),
        source("src/b.rs", "use crate::{a, a::One};\npub fn f() { a::Two }\n#[cfg(test)]\nmod tests { use crate::a; }"),
    ];
    let imports = Imports::of(&files);
    let arrows: Vec<(&str, &str)> = imports.arrows().collect();
    let wanted = [
        ("src/a/one.rs", "src/a/two.rs"),
        ("src/a/two.rs", "src/b.rs"),
        ("src/b.rs", "src/a/one.rs"),
        ("src/b.rs", "src/a/two.rs"),
    ];
    assert_eq!(arrows, wanted, "through groups, parents, re-exports, globs and aliases");
    let circle = ["src/a/one.rs", "src/a/two.rs", "src/b.rs"].map(str::to_owned);
    assert_eq!(imports.circles(), [BTreeSet::from(circle)], "one circle of three, the parent not in it");
}
