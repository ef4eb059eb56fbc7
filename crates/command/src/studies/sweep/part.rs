//! `peel sweep --part I/N`: one part of a sweep that several machines divide.

use super::args::Sweep;
use crate::terminal::command_line::words;
use crate::terminal::stop::Stop;
use peelkit_analyses::Axis;
use peelkit_report::{DividedSweep, Part, PartAxis, PartHeader, VERSION};
use peelkit_scene::Scene;

/// Options that do not belong to the undivided sweep, and whether a word follows them.
const OF_A_PART: [(&str, bool); 5] =
    [("--part", true), ("--out", true), ("--force", false), ("--fresh", false), ("--json", false)];

/// Refuses a part of what cannot be divided.
pub fn check(args: &Sweep, part: Part, axes: &[Axis]) -> Result<(), Stop> {
    if args.followed().is_some() {
        return Err(Stop::bad_input(
            format!("--part {part} divides sweeps of whole paths, and --follow goes from each value to the next"),
            "Omit --part: a followed sweep takes milliseconds a value. Or omit --follow and --peak-only.",
        ));
    }
    if args.folder().is_none() {
        return Err(Stop::bad_input(
            format!("--part {part} leaves files for peel collect, and --json without --out writes none"),
            "Give a folder for this part with --out DIR, or omit --json.",
        ));
    }
    let cases: usize = axes.iter().map(|axis| axis.values.len()).product();
    if part.index > cases {
        return Err(Stop::bad_input(
            format!("--part {part} has no values: the sweep has {cases}"),
            format!("Divide it into at most {cases} parts; peel collect needs no part without values."),
        ));
    }
    Ok(())
}

/// What the file of the part begins with.
pub fn header(args: &Sweep, scene: &Scene, axes: &[Axis], part: Part) -> PartHeader {
    let axis = |axis: &Axis| PartAxis { key: axis.key.path(), log: axis.log, values: axis.values.clone() };
    let sweep = DividedSweep {
        peelkit: VERSION.to_owned(),
        of: part.of,
        vary: axes.iter().map(axis).collect(),
        scene: scene.to_toml(),
    };
    let (name, folder) = (scene.name.clone(), args.folder_of_all());
    PartHeader { part, sweep, name, folder, command: undivided(words()) }
}

/// The command line without what stands there for one part alone.
fn undivided(words: Vec<String>) -> Vec<String> {
    let mut kept = Vec::new();
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        let begins = |name: &str| word.strip_prefix(name).is_some_and(|rest| rest.starts_with('='));
        match OF_A_PART.iter().find(|(name, _)| word == *name || begins(name)) {
            Some((name, true)) if word == *name => drop(words.next()),
            Some(_) => {}
            None => kept.push(word),
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_lies_in_one_part_and_parts_are_even() {
        for of in 1..10 {
            let mut sizes = vec![0; of];
            for case in 0..23 {
                let parts: Vec<usize> = (1..=of).filter(|&index| Part { index, of }.has(case)).collect();
                assert_eq!(parts.len(), 1);
                sizes[parts[0] - 1] += 1;
            }
            assert!(sizes.iter().max().unwrap() - sizes.iter().min().unwrap() <= 1);
        }
    }

    #[test]
    fn the_command_of_the_whole_names_no_part() {
        let words = |line: &str| shlex::split(line).unwrap();
        let typed = words("peel sweep a.toml --part 3/8 --vary strip.length --out=p3 --values '1 nm' --fresh --json");
        assert_eq!(undivided(typed), words("peel sweep a.toml --vary strip.length --values '1 nm'"));
        assert_eq!(undivided(words("peel sweep --part=1/2 --out p a.toml")), words("peel sweep a.toml"));
    }
}
