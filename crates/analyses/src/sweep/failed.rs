//! What is said of values whose computation stopped short.

use peelkit::study::PathEnd;
use peelkit_report::{PullRow, SweepRow, SweptKeys, as_given};
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
pub fn failed_peels(keys: SweptKeys, rows: &[SweepRow]) -> Option<String> {
    let reasons = rows.iter().filter_map(|row| match &row.found.end {
        PathEnd::Failed(reason) => Some(format!("at {}: {reason}", place(keys, row.value, row.second))),
        _ => None,
    });
    failed(&reasons.collect::<Vec<_>>(), rows.len())
}

/// The same of rows of pulls, of which `short` says why one stopped short.
pub fn failed_pulls<F>(keys: SweptKeys, rows: &[PullRow<F>], short: impl Fn(&F) -> Option<String>) -> Option<String> {
    let reason = |row: &PullRow<F>| {
        let why = match &row.found {
            Ok(found) => short(found)?,
            Err(why) => why.clone(),
        };
        Some(format!("at {}: {why}", place(keys, row.value, row.second)))
    };
    failed(&rows.iter().filter_map(reason).collect::<Vec<_>>(), rows.len())
}

/// Where in the sweep these values are: `strip.length = 80 nm`.
pub fn place(keys: SweptKeys, value: f64, second: Option<f64>) -> String {
    let one = |key: &Key, value: f64| {
        let value = format!("{} {}", as_given(key, value), key.usual_unit());
        format!("{} = {}", key.path(), value.trim_end())
    };
    let second = keys.second.zip(second).map(|(key, value)| format!(", {}", one(key, value)));
    format!("{}{}", one(keys.first, value), second.unwrap_or_default())
}
