//! Which keys a sweep varies, and what their columns are called.

use peelkit_scene::Key;

/// The key that a sweep varies, or the two keys of a plane.
#[derive(Clone, Copy, Debug)]
pub struct SweptKeys<'k> {
    /// Of `value`
    pub first: &'k Key,
    /// Of `value_2`
    pub second: Option<&'k Key>,
}

impl<'k> From<&'k Key> for SweptKeys<'k> {
    fn from(first: &'k Key) -> Self {
        Self { first, second: None }
    }
}

impl SweptKeys<'_> {
    /// The names of their columns, with the units in which a user gives them: `strip.length_nm`, `drive.angle_deg`.
    pub fn columns(&self) -> Vec<String> {
        self.keys().map(|key| column(key, key.usual_unit())).collect()
    }

    /// One key or two.
    pub fn keys(&self) -> impl Iterator<Item = &Key> {
        [Some(self.first), self.second].into_iter().flatten()
    }

    /// As messages and checkpoints call them: `strip.length and strip.height`.
    pub fn names(&self) -> String {
        match self.second {
            None => self.first.path(),
            Some(second) => format!("{} and {}", self.first.path(), second.path()),
        }
    }
}

/// A number in the unit in which a user gives the key: an angle in degrees, with what the change of the unit rounds rounded back.
pub fn as_given(key: &Key, number: f64) -> f64 {
    match key.per_usual_unit() {
        1.0 => number,
        scale => format!("{:.13e}", scale * number).parse().unwrap_or(scale * number),
    }
}

/// The key with the unit of its number in its name.
pub(crate) fn column(key: &Key, unit: &str) -> String {
    let unit = unit.replace('/', "_per_");
    if unit.is_empty() { key.path() } else { format!("{}_{unit}", key.path()) }
}
