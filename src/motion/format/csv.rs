//! A ground motion as a two-column table: time in s, acceleration in m/s², one line a sample.
//!
//! Bytes in, never a path. Lines that start with `#` are comments; a first line that is no numbers is a heading. The
//! samples must be evenly spaced; the first one is the acceleration at t = 0, whatever its own time.

use csv::{Reader, ReaderBuilder, StringRecord, Trim};

use super::record::{Format, RecordError, Series};

/// Printed times are rounded; they may be off by this part of the interval.
const UNEVEN: f64 = 0.01;

/// This format.
pub(super) const FORMAT: Format = Format {
    name: "CSV",
    extensions: &["csv", "txt"],
    contents: "two columns, time in s and acceleration in m/s², one line a sample",
    sniff,
    read,
};

/// Whether two numbers stand in the first line, or in the second below a heading.
fn sniff(bytes: &[u8]) -> bool {
    let records = reader(bytes).into_records().take(2);
    let mut numbers = records.map(|record| record.is_ok_and(|record| numbers(&record, 0).is_ok()));
    numbers.any(|found| found)
}

fn reader(bytes: &[u8]) -> Reader<&[u8]> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    ReaderBuilder::new().has_headers(false).flexible(true).comment(Some(b'#')).trim(Trim::All).from_reader(text)
}

/// Reads a record.
///
/// # Errors
/// The first line that is not two numbers, or that breaks the even spacing; fewer than two samples.
fn read(bytes: &[u8]) -> Result<Series, RecordError> {
    let (mut times, mut samples) = (Vec::new(), Vec::new());
    for (n, record) in reader(bytes).records().enumerate() {
        let record = record.map_err(|error| unreadable(&error))?;
        let line = record.position().map_or(0, csv::Position::line);
        match numbers(&record, line) {
            Ok((t, a)) => {
                times.push((line, t));
                samples.push(a);
            }
            Err(_) if n == 0 && is_heading(&record) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(Series { dt: interval(&times)?, samples })
}

fn unreadable(error: &csv::Error) -> RecordError {
    let line = error.position().map_or(0, csv::Position::line);
    RecordError { line, value: "no text".to_owned(), remedy: "save the record as UTF-8 text".to_owned() }
}

/// A heading has two columns, and no number in either.
fn is_heading(record: &StringRecord) -> bool {
    record.len() == 2 && record.iter().all(|field| field.parse::<f64>().is_err())
}

fn numbers(record: &StringRecord, line: u64) -> Result<(f64, f64), RecordError> {
    let wrong =
        |value: &str, remedy: &str| RecordError { line, value: format!("`{value}`"), remedy: remedy.to_owned() };
    let fields: Vec<&str> = record.iter().collect();
    let [t, a] = fields[..] else {
        return Err(wrong(&fields.join(","), "give two columns: time in s, acceleration in m/s²"));
    };
    let number = |field: &str| field.parse::<f64>().ok().filter(|v| v.is_finite());
    let t = number(t).ok_or_else(|| wrong(t, "the time must be a finite number, in s"))?;
    let a = number(a).ok_or_else(|| wrong(a, "the acceleration must be a finite number, in m/s²"))?;
    Ok((t, a))
}

/// The interval between samples, if there is one.
fn interval(times: &[(u64, f64)]) -> Result<f64, RecordError> {
    let (&[(_, first), ..], &[.., (last_line, last)]) = (times, times) else {
        let remedy = "a record needs at least 2 samples".to_owned();
        return Err(RecordError { line: 1, value: "no samples".to_owned(), remedy });
    };
    let dt = (last - first) / (times.len() - 1) as f64;
    if times.len() < 2 || dt <= 0.0 {
        let remedy = "a record needs at least 2 samples, and times that grow".to_owned();
        return Err(RecordError { line: last_line, value: format!("time {last}"), remedy });
    }
    let uneven = |&(n, &(_, t)): &(usize, &(u64, f64))| (t - (first + dt * n as f64)).abs() > UNEVEN * dt;
    match times.iter().enumerate().find(uneven) {
        None => Ok(dt),
        Some((n, &(line, t))) => {
            let expected = first + dt * n as f64;
            let remedy =
                format!("samples must be evenly spaced: with {dt} s between them this one belongs at {expected} s");
            Err(RecordError { line, value: format!("time {t}"), remedy })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        read(text.as_bytes()).expect_err("it is no record").to_string()
    }

    #[test]
    fn heading_comments_and_a_later_start_are_read_over() {
        let text = "\u{feff}# El Centro\nt_s, a_m_s2\n1.00, 0.5\n1.02, -0.25\n# a gap in the paper\n1.04, 1e-3\n";
        let series = read(text.as_bytes()).expect("a record");
        assert_eq!(series.samples, [0.5, -0.25, 1e-3], "in order");
        assert!((series.dt - 0.02).abs() < 4.0 * f64::EPSILON, "from rounded times: {}", series.dt);
    }

    #[test]
    fn a_complaint_names_line_value_and_remedy() {
        assert_eq!(
            error("0,1\n0.01,abc\n"),
            "line 2: found `abc`; the acceleration must be a finite number, in m/s²",
            "word"
        );
        assert!(error("0,1\n0.01,inf\n").starts_with("line 2: found `inf`"), "infinite");
        assert!(error("0,1\n0.01,2,3\n").contains("line 2: found `0.01,2,3`; give two columns"), "three columns");
        assert!(error("t,a\n0,1\nt,a\n").contains("line 3"), "a heading stands first only");
    }

    #[test]
    fn uneven_standing_or_missing_times_are_refused() {
        let uneven = error("0,1\n0.01,1\n0.025,1\n0.03,1\n");
        assert!(uneven.contains("line 3: found time 0.025") && uneven.contains("belongs at 0.02 s"), "{uneven}");
        assert!(error("0,1\n0,1\n").contains("times that grow"), "no interval");
        assert!(error("0,1\n").contains("at least 2 samples"), "one");
        assert!(error("").contains("at least 2 samples"), "none");
    }

    #[test]
    fn bytes_that_are_no_text_are_refused() {
        let error = read(b"0,1\n\xff\xfe,2\n").expect_err("not UTF-8");
        assert!(error.to_string().contains("line 2: found no text"), "{error}");
    }
}
