//! Content of a link to the page, after its `#`: `lesson=stick-and-slip&t=0.42&lang=ja`.
//!
//! | key | value |
//! |---|---|
//! | `scene` | name of a preset |
//! | `lesson` | name of a lesson; with `toml`, the one whose words stand beside that scene |
//! | `toml` | a scene's text: deflated in base64url, or as it is with `%` before hexadecimal bytes |
//! | `t` | the time shown \[s\] |
//! | `lang` | the language, `en` or `ja` |

use std::io::{Read as _, Write as _};

use base64::Engine as _;
use base64::prelude::BASE64_URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;

use crate::app::text;
use crate::language::Language;

/// Longest text of a scene that is taken from a link \[bytes\].
const LONGEST_TEXT: u64 = 1 << 20;

/// Longest link that is made: what mail and chat programs still take for one.
const LONGEST_LINK: usize = 8000;

/// Target of a link.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// The preset of this name.
    Preset(String),
    /// The lesson of this name.
    Lesson(String),
    /// The scene of this text, beside the words of the lesson of this name.
    Text(String, Option<String>),
}

/// A link.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Link {
    /// Target; `None` where the scene stays.
    pub target: Option<Target>,
    /// The time shown \[s\].
    pub t: Option<f64>,
    /// The language.
    pub language: Option<Language>,
}

impl Link {
    /// Link from the text after the `#` of an address, which may still be there.
    ///
    /// # Errors
    /// In words: the first key or value that has no sense.
    pub fn parse(fragment: &str) -> Result<Self, String> {
        let (mut link, mut lesson) = (Self::default(), None);
        let fragment = fragment.strip_prefix('#').unwrap_or(fragment);
        for pair in fragment.split('&').filter(|pair| !pair.is_empty()) {
            let (key, value) = pair.split_once('=').unwrap_or((pair, ""));
            let refused = || text::link_refused(pair);
            match key {
                "scene" => link.target = Some(Target::Preset(unescaped(value).ok_or_else(refused)?)),
                "lesson" => lesson = Some(unescaped(value).ok_or_else(refused)?),
                "toml" => link.target = Some(Target::Text(scene_text(value).ok_or_else(refused)?, None)),
                "t" => link.t = Some(value.parse().ok().filter(|t: &f64| t.is_finite()).ok_or_else(refused)?),
                "lang" => link.language = Some(Language::of_locale(value).ok_or_else(refused)?),
                _ => return Err(refused()),
            }
        }
        link.target = match (link.target, lesson) {
            (Some(Target::Text(text, _)), beside) => Some(Target::Text(text, beside)),
            (_, Some(name)) => Some(Target::Lesson(name)),
            (other, None) => other,
        };
        Ok(link)
    }

    /// As it stands behind the `#`.
    ///
    /// # Errors
    /// In words: a scene with more text than a link has room for.
    pub fn write(&self) -> Result<String, String> {
        let target = self.target.as_ref().map(|target| match target {
            Target::Preset(name) => format!("scene={}", escaped(name)),
            Target::Lesson(name) => format!("lesson={}", escaped(name)),
            Target::Text(text, lesson) => {
                let beside = lesson.as_ref().map_or(String::new(), |name| format!("lesson={}&", escaped(name)));
                format!("{beside}toml={}", BASE64_URL_SAFE_NO_PAD.encode(deflated(text)))
            }
        });
        // To the microsecond, which no eye tells from the moment.
        let t = self.t.map(|t| format!("t={}", (t * 1e6).round() / 1e6));
        let language = self.language.map(|language| format!("lang={}", language.code()));
        let link = [target, t, language].into_iter().flatten().collect::<Vec<_>>().join("&");
        if link.len() > LONGEST_LINK { Err(text::LINK_TOO_LONG.as_str().to_owned()) } else { Ok(link) }
    }
}

/// The text of a scene, however it is written.
fn scene_text(value: &str) -> Option<String> {
    // The text of any scene has signs that are no digits.
    let digit = |byte: u8| byte.is_ascii_alphanumeric() || b"-_".contains(&byte);
    if value.bytes().all(digit) { inflated(&BASE64_URL_SAFE_NO_PAD.decode(value).ok()?) } else { unescaped(value) }
}

/// Everything but letters, digits and a few signs as `%` and two hexadecimal digits a byte.
fn escaped(words: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.~".contains(&byte);
    words.bytes().map(|byte| if plain(byte) { char::from(byte).into() } else { format!("%{byte:02X}") }).collect()
}

fn unescaped(words: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(words.len());
    let mut rest = words.bytes();
    while let Some(byte) = rest.next() {
        let two = |rest: &mut std::str::Bytes<'_>| {
            let digit = |byte: u8| char::from(byte).to_digit(16).and_then(|digit| u8::try_from(digit).ok());
            Some(digit(rest.next()?)? << 4 | digit(rest.next()?)?)
        };
        bytes.push(if byte == b'%' { two(&mut rest)? } else { byte });
    }
    String::from_utf8(bytes).ok()
}

fn deflated(text: &str) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    // Memory takes all of it.
    let _ = encoder.write_all(text.as_bytes());
    encoder.finish().unwrap_or_default()
}

/// A text that may be no longer than a scene's.
fn inflated(bytes: &[u8]) -> Option<String> {
    let mut text = String::new();
    DeflateDecoder::new(bytes).take(LONGEST_TEXT + 1).read_to_string(&mut text).ok()?;
    (text.len() as u64 <= LONGEST_TEXT && !text.is_empty()).then_some(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    #[test]
    fn a_link_opens_a_lesson_at_a_moment_in_a_language() {
        let link = Link::parse("#lesson=stick-and-slip&t=0.42&lang=ja").expect("a link");
        let target = Some(Target::Lesson("stick-and-slip".into()));
        assert_eq!(link, Link { target, t: Some(0.42), language: Some(Language::Japanese) });
        assert_eq!(link.write().expect("short"), "lesson=stick-and-slip&t=0.42&lang=ja", "and back");
        assert_eq!(Link::parse("#"), Ok(Link::default()), "nothing is asked for");
        let preset = Link::parse("scene=deck-30m").expect("a link");
        assert_eq!(preset.target, Some(Target::Preset("deck-30m".into())), "without the sign");
    }

    #[test]
    fn every_preset_goes_into_a_link_and_comes_back() {
        for preset in presets::all() {
            let link = Link { target: Some(Target::Text(preset.text.to_owned(), None)), ..Link::default() };
            let written = link.write().unwrap_or_else(|words| panic!("{}: {words}", preset.name));
            assert_eq!(Link::parse(&written), Ok(link), "{}: {} signs", preset.name, written.len());
        }
    }

    #[test]
    fn a_scene_may_be_written_into_a_link_by_hand() {
        let text = "format = 1\nname = \"橋\"\n";
        let link = Link::parse(&format!("toml={}", escaped(text))).expect("a link");
        assert_eq!(link.target, Some(Target::Text(text.into(), None)));
        let long = "x = 1\n".repeat(400_000);
        let link = format!("toml={}", BASE64_URL_SAFE_NO_PAD.encode(deflated(&long)));
        assert!(link.len() < LONGEST_LINK && Link::parse(&link).is_err(), "more text than any scene");
        let mut state = 1_u64;
        let mut noise = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            format!("{:x}", state >> 32)
        };
        let noise: String = (0..2000).map(|_| noise()).collect();
        let long = Link { target: Some(Target::Text(noise, None)), ..Link::default() };
        assert!(long.write().is_err(), "no link for everything");
    }

    #[test]
    fn what_has_no_sense_is_said() {
        for wrong in ["t=soon", "t=inf", "lang=fr", "scene=%4", "toml=AAAA", "toml=%FF", "speed=2", "lesson"] {
            let words = Link::parse(wrong);
            if wrong == "lesson" {
                assert_eq!(words.map(|link| link.target), Ok(Some(Target::Lesson(String::new()))), "no lesson has it");
                continue;
            }
            assert!(words.as_ref().is_err_and(|words| words.contains(wrong)), "{wrong}: {words:?}");
        }
    }
}
