//! What the keys and columns of the outputs mean. The pages in `docs/reference/outputs` are made of these lists, which follow from the records, and
//! a test holds them against what the command writes.

use std::borrow::Cow;

/// A key of a JSON object or a column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputKey {
    /// `peak.force_nN`; `limit_points[].kind` is a key of every object of a list. Its unit is the end of its name.
    pub path: Cow<'static, str>,
    /// In a few words.
    pub about: &'static str,
    /// The key whose object has the keys of this one, where they are described there.
    pub like: Option<Cow<'static, str>>,
}

impl OutputKey {
    /// A key that is described here.
    pub(crate) fn new(path: impl Into<Cow<'static, str>>, about: &'static str) -> Self {
        Self { path: path.into(), about, like: None }
    }
}

/// A table or an object that is written.
#[derive(Clone, Debug)]
pub struct Output {
    /// As its table in `docs/reference/outputs` is called
    pub name: &'static str,
    /// What it consists of: keys, columns or arrays
    pub parts: &'static str,
    /// In the order in which they are written
    pub keys: Vec<OutputKey>,
}

impl Output {
    /// An object, which has keys.
    pub(crate) fn object(name: &'static str, keys: Vec<OutputKey>) -> Self {
        Self { name, parts: "key", keys }
    }

    /// A table, which has columns.
    pub(crate) fn table(name: &'static str, keys: Vec<OutputKey>) -> Self {
        Self { name, parts: "column", keys }
    }
}

/// Endings of names that are units, and the units.
const UNITS: &[(&str, &str)] = &[
    ("_J_per_m2", "J/m²"),
    ("_N_per_m", "N/m"),
    ("_nN_nm2", "nN nm²"),
    ("_nN_per_nm", "nN/nm"),
    ("_aJ_per_nm", "aJ/nm"),
    ("_per_nm", "1/nm"),
    ("_GPa", "GPa"),
    ("_nN_nm", "nN nm"),
    ("_nN", "nN"),
    ("_nm", "nm"),
    ("_aJ", "aJ"),
    ("_rad", "rad"),
    ("_deg", "deg"),
    ("_s", "s"),
];

/// The ending of a name that is its unit, `_nN`, and the unit.
fn ending(name: &str) -> Option<(&'static str, &'static str)> {
    UNITS.iter().copied().find(|(ending, _)| name.ends_with(ending))
}

/// A name in two: `force_nN` is `force` and `nN`; a name without a unit has an empty one.
pub fn without_unit(name: &str) -> (&str, &str) {
    match ending(name) {
        Some((unit, _)) => (&name[..name.len() - unit.len()], &name[name.len() - unit.len() + 1..]),
        None => (name, ""),
    }
}

impl OutputKey {
    /// The unit of its number; empty where it has none.
    pub fn unit(&self) -> &'static str {
        ending(&self.path).map_or("", |(_, unit)| unit)
    }
}

/// All paths of a list, the keys that are described elsewhere in it included.
pub fn paths(keys: &[OutputKey]) -> Vec<String> {
    let below =
        |path: &str, root: &str| path.strip_prefix(root).filter(|rest| rest.starts_with(['.', '['])).map(str::to_owned);
    let mut all: Vec<String> = keys.iter().map(|key| key.path.to_string()).collect();
    for key in keys {
        let Some(other) = &key.like else { continue };
        let rests = keys.iter().filter_map(|from| below(&from.path, other));
        all.extend(rests.map(|rest| format!("{}{rest}", key.path)));
    }
    all
}

/// The columns of two tables that have most of them in common: those of the second stand before the next one that both have.
pub fn merged(mut first: Vec<OutputKey>, second: Vec<OutputKey>) -> Vec<OutputKey> {
    let mut next = first.len();
    for key in second.into_iter().rev() {
        match first.iter().position(|known| *known == key) {
            Some(place) => next = place,
            None => first.insert(next, key),
        }
    }
    first
}

/// A list of keys that is being made of records.
#[derive(Debug, Default)]
pub struct Reference {
    keys: Vec<OutputKey>,
    /// Of the object that is being described
    path: String,
    /// Names of the records that are described already, and where
    described: Vec<(&'static str, String)>,
}

impl Reference {
    /// Adds a key; `below` describes what it holds.
    pub(crate) fn key(&mut self, name: &str, about: &'static str, below: impl FnOnce(&mut Self)) {
        let path = if self.path.is_empty() { name.to_owned() } else { format!("{}.{name}", self.path) };
        self.keys.push(OutputKey::new(path.clone(), about));
        self.within(path, below);
    }

    /// Describes the items of the list of the last key.
    pub(crate) fn items(&mut self, below: impl FnOnce(&mut Self)) {
        self.within(format!("{}[]", self.path), below);
    }

    fn within(&mut self, path: String, below: impl FnOnce(&mut Self)) {
        let outer = std::mem::replace(&mut self.path, path);
        below(self);
        self.path = outer;
    }

    /// Describes the object of the last key by its fields: once, and everywhere else by where that was.
    pub(crate) fn record(&mut self, name: &'static str, fields: impl FnOnce(&mut Self)) {
        match self.described.iter().find(|(known, _)| *known == name) {
            Some((_, place)) => {
                let list = if self.path.ends_with("[]") { "[]" } else { "" };
                let like = place.strip_suffix(list).unwrap_or(place).to_owned();
                if let Some(key) = self.keys.last_mut() {
                    key.like = Some(like.into());
                }
            }
            None => {
                self.described.push((name, self.path.clone()));
                fields(self);
            }
        }
    }

    /// What was described.
    pub(crate) fn into_keys(self) -> Vec<OutputKey> {
        self.keys
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(path: &str, about: &'static str) -> OutputKey {
        OutputKey::new(path.to_owned(), about)
    }

    #[test]
    fn units_are_the_ends_of_names() {
        let unit = |path| key(path, "").unit();
        assert_eq!(
            ["moment_nN_nm", "force_nN", "solve_s", "points", "kappa_per_nm", "EI_nN_nm2", "k_N_per_m"].map(unit),
            ["nN nm", "nN", "s", "", "1/nm", "nN nm²", "N/m"]
        );
        assert_eq!(
            ["moment_nN_nm", "points", "end_rotation_rad"].map(without_unit),
            [("moment", "nN_nm"), ("points", ""), ("end_rotation", "rad")]
        );
    }

    #[test]
    fn what_two_tables_have_in_common_is_described_once() {
        let list = |names: &[&str]| names.iter().map(|name| key(name, "")).collect::<Vec<_>>();
        let both =
            merged(list(&["event", "step", "place", "tip"]), list(&["event", "time", "place", "loss", "tip", "end"]));
        assert_eq!(both, list(&["event", "step", "time", "place", "loss", "tip", "end"]));
    }
}
