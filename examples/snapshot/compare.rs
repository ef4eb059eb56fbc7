//! Two snapshots compared, as a table.

use crate::differences::Differences;
use crate::run::Snapshot;

/// The first few of a list.
fn listed(what: &str, items: &[String]) -> String {
    const FEW: usize = 3;
    if items.is_empty() {
        return String::new();
    }
    let more = if items.len() > FEW { format!(" and {} more", items.len() - FEW) } else { String::new() };
    format!("\n    {what}: {}{more}", items[..items.len().min(FEW)].join(", "))
}

/// Prints the table; whether all is the same, or near enough.
pub fn compare(before: &Snapshot, after: &Snapshot, within: f64, numbers_only: bool) -> bool {
    let (mut same, mut all, mut numbers) = (0, true, 0);
    for old in &before.runs {
        let Some(new) = after.runs.iter().find(|run| run.label == old.label) else {
            println!("{:42} is missing", old.label);
            all = false;
            continue;
        };
        let found = Differences::between(old, new);
        numbers += found.numbers;
        if found.is_none() {
            same += 1;
            println!("{:42} equal bit for bit, {} numbers", old.label, found.numbers);
            continue;
        }
        let passes = found.passes(within, numbers_only);
        all &= passes;
        let counts = if found.counts.is_empty() { "counts equal" } else { "COUNTS DIFFER" };
        let (size, place) = found.largest.as_ref().map_or((0.0, "no number"), |(size, path)| (*size, path.as_str()));
        let verdict = if passes { "passes" } else { "DIFFERS" };
        let bounds =
            if found.beyond_bounds.is_empty() { "within 0.1 of the bounds" } else { "BEYOND 0.1 of the bounds" };
        println!("{:42} {verdict}: {size:.1e} at {place}; {counts}; {bounds}", old.label);
        let lists = [
            ("differs in kind", &found.shapes),
            ("counts", &found.counts),
            ("beyond", &found.beyond_bounds),
            ("keys", &found.keys),
            ("texts", &found.texts),
        ];
        let details: String = lists.iter().map(|(what, items)| listed(what, items)).collect();
        if !details.is_empty() {
            println!("{}", &details[1..]);
        }
    }
    for new in after.runs.iter().filter(|new| before.runs.iter().all(|old| old.label != new.label)) {
        println!("{:42} is new", new.label);
        all = false;
    }
    println!("{same} of {} runs equal bit for bit, {numbers} numbers compared", before.runs.len());
    all
}
