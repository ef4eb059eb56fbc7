//! What is said of values whose computation stopped short.

use crate::stop::Stop;
use crate::text_summary;
use peelkit::study::PathEnd;
use peelkit_report::{SweepRow, SweptKeys, as_given};
use peelkit_scene::Key;

/// The values whose computation stopped short, of so many, each with its reason; nothing where there are none.
pub fn failed(reasons: &[String], values: usize) -> Option<String> {
    const SHOWN: usize = 10;
    let mut text = format!("{} of {values} values", reasons.len());
    for reason in reasons.iter().take(SHOWN) {
        text += &format!("\n{reason}");
    }
    if reasons.len() > SHOWN {
        text += &format!("\nand {} more: see the column `end`", reasons.len() - SHOWN);
    }
    (!reasons.is_empty()).then_some(text)
}

/// The same of rows of whole paths.
pub fn failed_rows(keys: SweptKeys, rows: &[SweepRow]) -> Option<String> {
    let reasons = rows.iter().filter_map(|row| match &row.found.end {
        PathEnd::Failed(reason) => Some(format!("at {}: {reason}", place(keys, row.value, row.second))),
        _ => None,
    });
    failed(&reasons.collect::<Vec<_>>(), rows.len())
}

/// Where in the sweep these values are: `strip.length = 80 nm`.
pub fn place(keys: SweptKeys, value: f64, second: Option<f64>) -> String {
    let one = |key: &Key, value: f64| {
        format!("{} = {}{}", key.path(), as_given(key, value), text_summary::spaced(key.usual_unit()))
    };
    let second = keys.second.zip(second).map(|(key, value)| format!(", {}", one(key, value)));
    format!("{}{}", one(keys.first, value), second.unwrap_or_default())
}

/// Ends with what is missing of so many values where so many are done, and with what is said of those that stopped short.
pub fn stopped_short([done, values]: [usize; 2], failed: Option<String>) -> Result<(), Stop> {
    let interrupted = (done < values).then(|| {
        format!(
            "interrupted, {done} of {values} values are done; the same command resumes from there, --fresh starts anew"
        )
    });
    let parts: Vec<String> = interrupted.into_iter().chain(failed).collect();
    if parts.is_empty() { Ok(()) } else { Err(Stop::cut_short(parts.join("\nand "))) }
}
