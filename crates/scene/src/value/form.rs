//! What the value of a key looks like: as much as an editor can know of it without computing anything.

use super::quantity::Dimension;
use peelkit::model::Range;

/// The form of a value.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// Any text in quotes
    Text,
    /// One of these words in quotes
    Word(Vec<&'static str>),
    /// true or false
    Flag,
    /// A whole number from the first to the second
    Whole(f64, f64),
    /// A number without a unit
    Number(Range),
    /// A text of a number with its unit; the range is in the unit of the library
    Quantity(Dimension, Range),
    /// A number, or a text of a number with its unit, as the key asks that is named beside it
    OfItsKey,
    /// One value, or a list of two: at the beginning and at the end
    AtBothEnds(Box<Form>),
    /// One form or the other
    Either(Box<Form>, Box<Form>),
    /// A list of values that look alike
    List(Box<Form>),
    /// A table of these entries and no others
    Table(&'static [Entry]),
    /// A text that begins with one of these words
    Step(&'static [&'static str]),
    /// The path of a key of a scene, such as strip.height, and what may follow it
    OfKey,
    /// A table of paths of keys with their numbers
    Values,
}

/// An entry of a table within a value.
#[derive(Debug)]
pub struct Entry {
    /// Its name
    pub name: &'static str,
    /// Whether the table has to hold it
    pub needed: bool,
    /// What it takes
    pub form: fn() -> Form,
}

/// So that a table can be declared in one expression.
impl PartialEq for Entry {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && self.needed == other.needed && (self.form)() == (other.form)()
    }
}

impl Entry {
    /// One that the table has to hold.
    pub(crate) const fn needed(name: &'static str, form: fn() -> Form) -> Self {
        Self { name, needed: true, form }
    }

    /// One that it may leave out.
    pub(crate) const fn optional(name: &'static str, form: fn() -> Form) -> Self {
        Self { name, needed: false, form }
    }
}

impl Form {
    /// One of the words of a list of choices.
    pub(crate) fn word<T>(choices: &[(&'static str, T)]) -> Self {
        Self::Word(choices.iter().map(|(word, _)| *word).collect())
    }

    /// A list of such values.
    pub(crate) fn list(of: Self) -> Self {
        Self::List(Box::new(of))
    }
}
