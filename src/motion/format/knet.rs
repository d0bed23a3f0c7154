//! K-NET and KiK-net ASCII: seventeen header lines known by their number, then counts of the digitiser, eight a line.
//!
//! A count times the scale factor, `3920(gal)/6182761`, is an acceleration with the offset of the sensor: the mean is
//! removed. Line 11 has the sampling frequency, line 12 the duration, line 13 the component.

use super::record::{Channel, Format, Orientation, RecordError, Supplement};
use super::text::{Lines, expect_count, first_number, interval, number, quoted, sample};
use super::unit::Unit;
use crate::language::{Text, message};

/// Lines of the header.
const HEADER: usize = 17;
/// Columns of a header line before its value.
const LABEL: usize = 18;

/// This format.
pub(super) const FORMAT: Format = Format {
    name: "K-NET ASCII",
    extensions: &["ew", "ns", "ud", "ew1", "ns1", "ud1", "ew2", "ns2", "ud2"],
    contents: Text::new("record-knet"),
    sniff,
    read,
};

fn sniff(bytes: &[u8]) -> bool {
    let mut lines = Lines::of(bytes);
    lines.next().is_some_and(|line| line.starts_with("Origin Time"))
        && lines.nth(11).is_some_and(|line| line.starts_with("Dir."))
}

fn read(bytes: &[u8], beside: &Supplement) -> Result<Vec<Channel>, RecordError> {
    beside.nothing(Text::new("record-states-knet"))?;
    let mut lines = Lines::of(bytes);
    let mut header = Vec::new();
    for _ in 0..HEADER {
        header.push(lines.header(Text::new("record-knet-header"))?);
    }
    let value = |line: usize| header[line - 1].get(LABEL..).unwrap_or_default().trim();
    let frequency = positive(value(11), 11, Text::new("record-knet-frequency"))?;
    let duration = positive(value(12), 12, Text::new("record-knet-duration"))?;
    let scale = scale(value(14))?;
    let dt = interval(1.0 / frequency, 11)?;
    let mut numbers = Vec::new();
    while let Some(line) = lines.next() {
        for word in line.split_ascii_whitespace() {
            numbers.push(sample(word, lines.number)? * scale);
        }
    }
    let wanted = whole(duration * frequency)
        .ok_or_else(|| RecordError::new(12, quoted(value(12)), Text::new("record-knet-whole")))?;
    expect_count(wanted, numbers.len(), lines.number)?;
    let mean = numbers.iter().sum::<f64>() / numbers.len() as f64;
    for sample in &mut numbers {
        *sample -= mean;
    }
    let name = format!("{} {}", value(6), value(13));
    let mut channel = Channel::converted(&name, direction(value(13)), Unit::Gal, dt, numbers);
    channel.done.insert(0, message!("record-counts", "scale" => value(14).replace("(gal)", "")));
    channel.done.insert(1, message!("record-mean", "mean" => format!("{mean:.4}")));
    Ok(vec![channel])
}

fn positive(text: &str, line: u64, remedy: Text) -> Result<f64, RecordError> {
    let value = first_number(text).map(|(value, _)| value).filter(|value| *value > 0.0);
    value.ok_or_else(|| RecordError::new(line, quoted(text), remedy))
}

/// A number of samples, two at least.
fn whole(count: f64) -> Option<usize> {
    /// Beyond this no file is that large.
    const MOST: f64 = 1e9;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within 2 and 1e9")]
    ((2.0..=MOST).contains(&count) && (count - count.round()).abs() < 1e-6).then(|| count.round() as usize)
}

/// `3920(gal)/6182761` \[gal per count\].
fn scale(text: &str) -> Result<f64, RecordError> {
    let parts = || {
        let (full, counts) = text.split_once('/')?;
        let (full, unit) = full.split_once('(')?;
        (Unit::of_word(unit.trim_end_matches(')'))? == Unit::Gal).then_some(())?;
        Some(number(full.trim())? / number(counts.trim())?)
    };
    parts()
        .filter(|scale: &f64| scale.is_finite() && *scale > 0.0)
        .ok_or_else(|| RecordError::new(14, quoted(text), Text::new("record-knet-scale")))
}

/// K-NET names directions; KiK-net numbers them: 1 to 3 in the borehole, 4 to 6 at the surface.
fn direction(text: &str) -> Orientation {
    match text {
        "N-S" | "1" | "4" => Orientation::Azimuth(0.0),
        "E-W" | "2" | "5" => Orientation::Azimuth(90.0),
        "U-D" | "3" | "6" => Orientation::Up,
        _ => Orientation::Unstated,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(frequency: &str, duration: &str, scale: &str, data: &str) -> String {
        let mut lines: Vec<String> = (1..=HEADER).map(|n| format!("Header line {n:<6}")).collect();
        let mut set = |n: usize, label: &str, value: &str| lines[n - 1] = format!("{label:<LABEL$}{value}");
        set(1, "Origin Time", "2020/01/01 00:00:00");
        set(6, "Station Code", "XXX001");
        set(11, "Sampling Freq(Hz)", frequency);
        set(12, "Duration Time(s)", duration);
        set(13, "Dir.", "E-W");
        set(14, "Scale Factor", scale);
        format!("{}\n{data}", lines.join("\n"))
    }

    #[test]
    fn counts_are_scaled_and_their_mean_removed() {
        let text = text("2Hz", "2", "200(gal)/100", "  101  103\n  99 97 \n");
        let channel = &read(text.as_bytes(), &Supplement::default()).expect("a record")[0];
        let expected = [0.02, 0.06, -0.02, -0.06];
        for (sample, expected) in channel.samples.iter().zip(expected) {
            assert!((sample - expected).abs() < 1e-12, "{sample} m/s²");
        }
        assert_eq!((channel.dt, channel.orientation), (0.5, Orientation::Azimuth(90.0)), "2 Hz, east");
        assert!(
            channel.done.iter().any(|done| done.to_string() == "mean of 200.0000 gal removed"),
            "{:?}",
            channel.done
        );
    }

    #[test]
    fn headers_that_state_no_numbers_are_refused() {
        let error = |text: String| read(text.as_bytes(), &Supplement::default()).expect_err("no record").to_string();
        assert!(error(text("fast", "2", "200(gal)/100", "1 2 3 4")).starts_with("line 11"), "frequency");
        assert!(error(text("2Hz", "1e18", "200(gal)/100", "1 2 3 4")).starts_with("line 12"), "duration");
        assert!(error(text("2Hz", "2", "200/100", "1 2 3 4")).starts_with("line 14"), "no unit");
        assert!(error(text("2Hz", "2", "200(gal)/0", "1 2 3 4")).starts_with("line 14"), "no counts");
        assert!(error(text("2Hz", "3", "200(gal)/100", "1 2 3 4")).contains("states 6 samples"), "cut off");
        assert!(error("Origin Time\n".to_owned()).contains("cut off"), "no header");
    }
}
