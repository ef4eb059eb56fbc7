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
    /// The names of their columns, with units: `strip.length_nm`.
    pub fn columns(&self) -> Vec<String> {
        [Some(self.first), self.second].into_iter().flatten().map(column).collect()
    }

    /// As messages and checkpoints call them: `strip.length and strip.height`.
    pub fn names(&self) -> String {
        match self.second {
            None => self.first.path(),
            Some(second) => format!("{} and {}", self.first.path(), second.path()),
        }
    }
}

/// The key with the unit of its number in its name.
pub(crate) fn column(key: &Key) -> String {
    let unit = key.unit().replace('/', "_per_");
    if unit.is_empty() { key.path() } else { format!("{}_{unit}", key.path()) }
}
