//! The parts that `peel collect` is given: read, and held against each other.

use crate::terminal::stop::Stop;
use crate::text_summary::number::spaced;
use peelkit_analyses::Axis;
use peelkit_report::{DividedSweep, JournalKind, PartAxis, PartHeader, SweepPart, VERSION};
use peelkit_scene::{KEYS, Key, Scene, find_key};
use std::path::{Path, PathBuf};

/// The parts of one sweep, at least one, each with its folder, and folders in which a part is still being computed.
pub struct Parts {
    first: (PathBuf, SweepPart),
    others: Vec<(PathBuf, SweepPart)>,
    pub unfinished: Vec<PathBuf>,
}

impl Parts {
    /// Refuses folders that hold no part, and parts of different sweeps.
    pub fn read(folders: &[PathBuf]) -> Result<Self, Stop> {
        let mut parts = Vec::new();
        let mut unfinished = Vec::new();
        for folder in folders {
            match SweepPart::read(folder)? {
                Some(part) => parts.push((folder.clone(), part)),
                None if JournalKind::SWEEP.is_in(folder) => unfinished.push(folder.clone()),
                None => return Err(no_part(folder)),
            }
        }
        let mut parts = parts.into_iter();
        let Some(first) = parts.next() else {
            return Err(Stop::bad_input(
                format!("no part is finished: {} folders hold checkpoints alone", unfinished.len()),
                "Wait for the parts, or resume them, each with its own command.",
            ));
        };
        let parts = Self { first, others: parts.collect(), unfinished };
        parts.refuse_strangers()?;
        Ok(parts)
    }

    pub fn header(&self) -> &PartHeader {
        &self.first.1.header
    }

    pub fn all(&self) -> impl Iterator<Item = (&Path, &SweepPart)> {
        [&self.first].into_iter().chain(&self.others).map(|(folder, part)| (folder.as_path(), part))
    }

    /// The keys that are varied, and their values.
    pub fn axes(&self) -> Result<Vec<Axis>, Stop> {
        let folder = self.first.0.display();
        let axes = self.header().sweep.vary.iter().map(|axis| {
            let key = find_key(&axis.key)
                .map_err(|problem| Stop::bad_argument(format!("{folder}: {}", axis.key), &problem))?;
            let origin = format!("{} in {folder}", axis.key);
            Ok(Axis { key, values: axis.values.clone(), log: axis.log, origin })
        });
        axes.collect()
    }

    fn refuse_strangers(&self) -> Result<(), Stop> {
        let (folder, first) = &self.first;
        let mine = &first.header.sweep;
        if mine.peelkit != VERSION {
            return Err(Stop::bad_input(
                format!("{} was computed by peel {}, and this is peel {VERSION}", folder.display(), mine.peelkit),
                "Collect the parts with the version that computed them, or compute them again.",
            ));
        }
        match self.others.iter().find(|(_, part)| part.header.sweep != *mine) {
            Some((other, part)) => Err(Stop::bad_input(
                format!(
                    "{} and {} are parts of different sweeps: {}",
                    folder.display(),
                    other.display(),
                    difference(mine, &part.header.sweep)
                ),
                "Give the parts of one sweep: the same scene, keys, values, number of parts and version.",
            )),
            None => Ok(()),
        }
    }
}

fn no_part(folder: &Path) -> Stop {
    Stop::bad_input(
        format!("{} holds no part of a sweep", folder.display()),
        "Give folders that peel sweep --part I/N has written; omit a part that has not begun.",
    )
}

// -- In what two divided sweeps differ --

/// The first difference between two sweeps that are not the same, as the end of a message.
fn difference(a: &DividedSweep, b: &DividedSweep) -> String {
    if a.peelkit != b.peelkit {
        return format!("they were computed by peel {} and peel {}", a.peelkit, b.peelkit);
    }
    if a.of != b.of {
        return format!("one is divided into {} parts, the other into {}", a.of, b.of);
    }
    let keys = |sweep: &DividedSweep| sweep.vary.iter().map(|axis| axis.key.as_str()).collect::<Vec<_>>().join(" and ");
    if keys(a) != keys(b) {
        return format!("one varies {}, the other {}", keys(a), keys(b));
    }
    let of_axes = a.vary.iter().zip(&b.vary).find_map(|(a, b)| of_axis(a, b));
    of_axes.or_else(|| of_scenes(&a.scene, &b.scene)).unwrap_or_else(|| "their scenes are written differently".into())
}

fn of_axis(a: &PartAxis, b: &PartAxis) -> Option<String> {
    let (key, [m, n]) = (&a.key, [a.values.len(), b.values.len()]);
    if m != n {
        return Some(format!("{key} has {m} values in one and {n} in the other"));
    }
    if a.log != b.log {
        return Some(format!("{key} is varied with --log in one of them alone"));
    }
    let at = a.values.iter().zip(&b.values).position(|(a, b)| a.to_bits() != b.to_bits())?;
    let unit = find_key(key).map_or("", Key::unit);
    let [x, y] = [a, b].map(|axis| format!("{}{}", axis.values[at], spaced(unit)));
    Some(format!("value {} of {key} is {x} in one and {y} in the other", at + 1))
}

/// The first key that the scenes give differently.
fn of_scenes(a: &str, b: &str) -> Option<String> {
    let [a, b] = [a, b].map(|text| Scene::parse("part", text, &[]).ok());
    let (a, b) = a.zip(b)?;
    let value = |key: &Key, scene: &Scene| key.belongs_to(scene).then(|| key.value(scene)).flatten();
    let key = KEYS.iter().find(|key| value(key, &a) != value(key, &b))?;
    let shown = |scene: &Scene| {
        value(key, scene).map_or_else(|| "not given".to_owned(), |value| format!("{value}{}", spaced(key.unit())))
    };
    Some(format!("{} is {} in one and {} in the other", key.path(), shown(&a), shown(&b)))
}
