//! Files with bytes changed, cut, repeated and overwritten by hostile words, each by its seed.

/// splitmix64.
struct Bits(u64);

impl Bits {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        usize::try_from(self.next() % u64::try_from(n.max(1)).expect("small")).expect("below n")
    }
}

/// One to four changes; every second one within the first tenth, where headers stand.
pub(crate) fn mutated(whole: &[u8], words: &[&str], seed: u64) -> Vec<u8> {
    let mut bits = Bits(seed);
    let mut bytes = whole.to_vec();
    for _ in 0..=bits.below(4) {
        let span = if bits.below(2) == 0 { bytes.len() / 10 + 1 } else { bytes.len() + 1 };
        let at = bits.below(span).min(bytes.len());
        let until = (at + bits.below(40)).min(bytes.len());
        match bits.below(6) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..until)),
            2 => {
                let word = words[bits.below(words.len())].bytes();
                bytes.splice(at..until, word);
            }
            3 => {
                let copy = bytes[at..until].to_vec();
                bytes.splice(at..at, copy);
            }
            4 => bytes.get_mut(at..until).into_iter().flatten().for_each(|byte| *byte = b'9'),
            _ => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte = u8::try_from(bits.next() % 256).expect("a byte");
                }
            }
        }
    }
    bytes
}

/// The value behind a `=` of one line replaced by a word: most other changes leave no TOML.
pub(crate) fn other_value(whole: &str, words: &[&str], seed: u64) -> String {
    let mut bits = Bits(seed);
    let mut lines: Vec<String> = whole.lines().map(str::to_owned).collect();
    let with_value: Vec<usize> = (0..lines.len()).filter(|&n| lines[n].contains('=')).collect();
    for _ in 0..=bits.below(3) {
        let line = &mut lines[with_value[bits.below(with_value.len())]];
        // One of the values of an inline table, up to the next comma or to the end.
        let signs: Vec<usize> = line.match_indices('=').map(|(at, _)| at).collect();
        let Some(&from) = signs.get(bits.below(signs.len())) else { continue };
        let end = line[from..].find([',', '}']).map_or(line.len(), |length| from + length);
        line.replace_range(from + 1..end, &format!(" {}", words[bits.below(words.len())]));
    }
    lines.join("\n")
}

/// A complaint is in words, no longer than a screen, and shows no raw control character of the file.
#[track_caller]
pub(crate) fn expect_words(complaint: &str) {
    assert!(complaint.len() > 10 && complaint.chars().count() < 4000, "as long as a complaint: {complaint}");
    let raw = complaint.chars().find(|c| c.is_control() && *c != '\n');
    assert_eq!(raw, None, "no control character: {complaint:?}");
}

/// The most memory that the process has held so far \[bytes\], where the system says so.
pub(crate) fn peak_memory() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.split_whitespace().next()?.parse::<usize>().ok().map(|kib| kib << 10)
}

/// Cases of a long run: a million, or as many as `GIRDERBENCH_CASES` asks for.
pub(crate) fn many() -> u64 {
    std::env::var("GIRDERBENCH_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(1_000_000)
}

/// Names the file and the seed where what is done with them panics.
pub(crate) struct Case<'a>(&'a str, u64);

impl<'a> Case<'a> {
    pub(crate) fn of(file: &'a str, seed: u64) -> Self {
        Self(file, seed)
    }
}

impl Drop for Case<'_> {
    #[expect(clippy::print_stderr, reason = "shown when a test fails")]
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("{}, seed {}", self.0, self.1);
        }
    }
}
