//! The rows of all parts in the order of the sweep, each once, and what is missing of them.

use super::parts::Parts;
use crate::terminal::stop::Stop;
use peelkit::study::PeelResult;
use peelkit_analyses::{Case, Cases, place};
use peelkit_report::{Part, SweepPart, SweepRow, SweptKeys};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// What the parts give together.
pub struct Merged {
    /// In the order of the sweep.
    pub rows: Vec<SweepRow>,
    /// Which parts were given twice.
    pub remarks: Vec<String>,
    values: usize,
    of: usize,
    /// Of each part that is not whole, the values that it lacks and those that it should have.
    lacking: BTreeMap<usize, (usize, usize)>,
    unfinished: Vec<PathBuf>,
}

impl Merged {
    /// Refuses parts that were computed twice with different results.
    pub fn of(parts: &Parts, cases: &Cases) -> Result<Self, Stop> {
        let of = parts.header().sweep.of;
        let mut rows = Vec::with_capacity(cases.all.len());
        let mut lacking: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
        let by_part = by_part(parts);
        for (index, case) in cases.all.iter().enumerate() {
            let part = Part::with_case(index, of).index;
            let counts = lacking.entry(part).or_default();
            counts.1 += 1;
            match row(case, cases.keys, by_part.get(&part).map_or(&[], Vec::as_slice))? {
                Some(row) => rows.push(row),
                None => counts.0 += 1,
            }
        }
        lacking.retain(|_, (missing, _)| *missing > 0);
        let (values, unfinished) = (cases.all.len(), parts.unfinished.clone());
        Ok(Self { rows, remarks: twice(&by_part, of), values, of, lacking, unfinished })
    }

    /// The parts that are missing or not finished, counted from 1.
    pub fn missing_parts(&self) -> Vec<usize> {
        self.lacking.keys().copied().collect()
    }

    /// Which values are missing, if any are.
    pub fn missing_text(&self) -> Option<String> {
        let missing = self.values - self.rows.len();
        if missing == 0 {
            return None;
        }
        let whole = |&&(missing, all): &&(usize, usize)| missing == all;
        let absent = self.lacking.iter().filter(|(_, counts)| whole(counts)).map(|(part, _)| *part);
        let mut text = format!("{missing} of {} values are missing", self.values);
        let absent: BTreeSet<usize> = absent.collect();
        if !absent.is_empty() {
            text += &format!("\nparts of {} that were not given: {}", self.of, ranges(&absent));
        }
        for (part, (missing, all)) in self.lacking.iter().filter(|(_, counts)| !whole(counts)) {
            text += &format!("\npart {part}/{} lacks {missing} of its {all} values", self.of);
        }
        for folder in &self.unfinished {
            text += &format!("\n{} is not finished: its own command resumes it", folder.display());
        }
        Some(text + "\nthe same command with the late parts completes the folder")
    }
}

type Given<'p> = (&'p Path, &'p SweepPart);

/// The parts by their number, each as often as it was given.
fn by_part(parts: &Parts) -> BTreeMap<usize, Vec<Given<'_>>> {
    let mut by_part: BTreeMap<usize, Vec<Given>> = BTreeMap::new();
    for given in parts.all() {
        by_part.entry(given.1.header.part.index).or_default().push(given);
    }
    by_part
}

/// The row of a case, from the first folder that has it; all others have to agree.
fn row(case: &Case, keys: SweptKeys, given: &[Given]) -> Result<Option<SweepRow>, Stop> {
    let Case { value, second, scene } = case;
    let mut found = given.iter().filter_map(|(folder, part)| Some((*folder, part.found(*value, *second)?)));
    let Some((folder, (first, solve_s))) = found.next() else {
        return Ok(None);
    };
    if let Some((other, (again, _))) = found.find(|(_, (again, _))| *again != first) {
        let peak =
            |found: &PeelResult| found.peak.map_or("no peak".to_owned(), |at| format!("a peak of {} nN", at.force));
        let (place, points) = (place(keys, *value, *second), |found: &PeelResult| found.effort.points);
        return Err(Stop::bad_input(
            format!(
                "{} and {} have different results at {place}: {} on {} points, and {} on {} points",
                folder.display(),
                other.display(),
                peak(first),
                points(first),
                peak(again),
                points(again)
            ),
            "Omit one of the two folders. Different processors or mathematical libraries may change last digits.",
        ));
    }
    let (model, found) = (scene.model.clone(), first.clone());
    Ok(Some(SweepRow { value: *value, second: *second, model, found, solve_s }))
}

/// That parts were given more than once, if they were.
fn twice(by_part: &BTreeMap<usize, Vec<Given>>, of: usize) -> Vec<String> {
    let remark = |(part, given): (&usize, &Vec<Given>)| {
        let folders: Vec<String> = given.iter().map(|(folder, _)| folder.display().to_string()).collect();
        format!("part {part}/{of} is in {}: the results are equal, each value counts once", folders.join(" and "))
    };
    by_part.iter().filter(|(_, given)| given.len() > 1).map(remark).collect()
}

/// Numbers with runs written in short: `1, 4-6`.
fn ranges(numbers: &BTreeSet<usize>) -> String {
    let numbers: Vec<usize> = numbers.iter().copied().collect();
    let runs = numbers.chunk_by(|a, b| a + 1 == *b).map(|run| match run {
        [one] => one.to_string(),
        [first, .., last] => format!("{first}-{last}"),
        [] => String::new(),
    });
    runs.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::ranges;

    #[test]
    fn runs_are_written_in_short() {
        assert_eq!(ranges(&[1, 4, 5, 6, 8, 9].into()), "1, 4-6, 8-9");
        assert_eq!(ranges(&[3].into()), "3");
    }
}
