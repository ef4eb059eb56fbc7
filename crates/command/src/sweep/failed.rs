//! What is said of values whose computation stopped short.

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
