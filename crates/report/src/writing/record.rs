//! What is written of a value: its keys, each with its meaning and its number, in one line a key. The header and the rows of a table, the objects of
//! summary.json and their reference follow from it.
//!
//! ```
//! use peelkit_report::{Fields, Record};
//!
//! struct Spring {
//!     force: f64,
//!     length: Option<f64>,
//! }
//!
//! impl Record for Spring {
//!     fn fields(of: &mut Fields<Self>) {
//!         of.field("force_nN", "what holds its end", |spring| spring.force);
//!         of.field("length_nm", "its length; null where nobody has measured it", |spring| spring.length);
//!     }
//! }
//! # assert_eq!(Spring { force: 1.0, length: None }.to_json().unwrap(), "{\n  \"force_nN\": 1.0,\n  \"length_nm\": null\n}\n");
//! # assert_eq!(Spring::keys()[0].unit(), "nN");
//! ```

use crate::writing::error::ReportError;
use crate::writing::file::write_whole;
use crate::writing::number::{Finite, to_json};
use crate::writing::reference::{OutputKey, Reference};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::borrow::Cow;
use std::io;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// A value that has keys.
pub trait Record: Sized {
    /// Its keys in their order: one line each.
    fn fields(of: &mut Fields<Self>);

    /// Its keys and what stands under them.
    fn object(&self) -> Object {
        let mut object = Object::default();
        Self::fields(&mut Fields(Pass::Values(self, &mut object)));
        object
    }

    /// The object as text; a number that is not finite is an error that names its key.
    fn to_json(&self) -> io::Result<String> {
        to_json(&self.object())
    }

    /// Its keys and what they mean.
    fn keys() -> Vec<OutputKey> {
        let mut reference = Reference::default();
        described::<Self>(&mut reference);
        reference.into_keys()
    }

    /// By what the record is known where it occurs again.
    fn name() -> &'static str {
        std::any::type_name::<Self>()
    }
}

fn described<R: Record>(reference: &mut Reference) {
    reference.record(R::name(), |below| R::fields(&mut Fields(Pass::Keys(below))));
}

impl<R: Record> Record for &R {
    fn fields(of: &mut Fields<Self>) {
        match &mut of.0 {
            Pass::Values(from, to) => R::fields(&mut Fields(Pass::Values(*from, to))),
            Pass::Keys(to) => R::fields(&mut Fields(Pass::Keys(to))),
        }
    }

    fn name() -> &'static str {
        R::name()
    }
}

/// The keys of one, and behind them those of the other.
impl<A: Record, B: Record> Record for (A, B) {
    fn fields(of: &mut Fields<Self>) {
        of.part(|both| &both.0);
        of.part(|both| &both.1);
    }
}

/// The list of the fields of a record: filled from a value, or from none, for their names and meanings.
pub struct Fields<'r, 'w, R>(Pass<'r, 'w, R>);

enum Pass<'r, 'w, R> {
    Values(&'r R, &'w mut Object),
    Keys(&'w mut Reference),
}

impl<'r, R> Fields<'r, '_, R> {
    /// A key, what it means, and what stands under it: a number, a word, a record, a list of them; null where there is none.
    pub fn field<C: Content>(&mut self, name: &'static str, about: &'static str, value: impl FnOnce(&'r R) -> C) {
        self.sometimes(name, about, |from| Some(value(from)));
    }

    /// A key that is left out where there is nothing to stand under it.
    pub fn sometimes<C: Content>(
        &mut self,
        name: &'static str,
        about: &'static str,
        value: impl FnOnce(&'r R) -> Option<C>,
    ) {
        match &mut self.0 {
            Pass::Values(from, to) => to.0.extend(value(from).map(|value| (Cow::from(name), value.cell()))),
            Pass::Keys(to) => to.key(name, about, C::describe),
        }
    }

    /// A number and the bound of its error behind it, each under its key.
    pub fn bounded(
        &mut self,
        [name, error]: [&'static str; 2],
        about: &'static str,
        value: impl FnOnce(&'r R) -> Option<Bounded>,
    ) {
        let found = match &self.0 {
            Pass::Values(from, _) => value(from),
            Pass::Keys(_) => None,
        };
        self.field(name, about, |_| found.map(|bounded| bounded.value));
        self.field(error, "its bound", |_| found.and_then(|bounded| bounded.error));
    }

    /// An object of keys of its own that are read from the same value.
    pub fn group(&mut self, name: &'static str, about: &'static str, fields: impl FnOnce(&mut Fields<'r, '_, R>)) {
        match &mut self.0 {
            Pass::Values(from, to) => {
                let mut object = Object::default();
                fields(&mut Fields(Pass::Values(from, &mut object)));
                to.0.push((Cow::from(name), Cell::Object(object)));
            }
            Pass::Keys(to) => to.key(name, about, |below| fields(&mut Fields(Pass::Keys(below)))),
        }
    }

    /// The keys of another record among those of this one.
    pub fn part<P: Record>(&mut self, value: impl FnOnce(&'r R) -> P) {
        self.sometimes_part(|from| Some(value(from)));
    }

    /// The same where there is one; without it they are left out.
    pub fn sometimes_part<P: Record>(&mut self, value: impl FnOnce(&'r R) -> Option<P>) {
        match &mut self.0 {
            Pass::Values(from, to) => {
                if let Some(part) = value(from) {
                    P::fields(&mut Fields(Pass::Values(&part, to)));
                }
            }
            Pass::Keys(to) => P::fields(&mut Fields(Pass::Keys(to))),
        }
    }
}

/// A number with the bound of its error, where it has one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// The number
    pub value: f64,
    /// In its unit
    pub error: Option<f64>,
}

impl Bounded {
    /// A number with its bound.
    pub fn new(value: f64, error: f64) -> Self {
        Self { value, error: Some(error) }
    }
}

/// What stands under a key or in a cell of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// `null`, or an empty cell
    Nothing,
    /// It has to be finite where it is written
    Number(f64),
    /// How many
    Count(u64),
    /// Whether
    Flag(bool),
    /// Words
    Text(String),
    /// In its order
    List(Vec<Cell>),
    /// Under keys of its own
    Object(Object),
}

/// Keys and what stands under them, in their order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Object(pub Vec<(Cow<'static, str>, Cell)>);

/// What can stand under a key.
pub trait Content {
    /// As it is written
    fn cell(self) -> Cell;

    /// Describes the keys below it, where it has such.
    #[doc(hidden)]
    fn describe(_: &mut Reference)
    where
        Self: Sized,
    {
    }
}

impl<R: Record> Content for R {
    fn cell(self) -> Cell {
        Cell::Object(self.object())
    }

    fn describe(to: &mut Reference) {
        described::<R>(to);
    }
}

impl<C: Content> Content for Option<C> {
    fn cell(self) -> Cell {
        self.map_or(Cell::Nothing, C::cell)
    }

    fn describe(to: &mut Reference) {
        C::describe(to);
    }
}

impl<C: Content> Content for Vec<C> {
    fn cell(self) -> Cell {
        Cell::List(self.into_iter().map(C::cell).collect())
    }

    fn describe(to: &mut Reference) {
        to.items(C::describe);
    }
}

impl<C: Content, const N: usize> Content for [C; N] {
    fn cell(self) -> Cell {
        Cell::List(self.into_iter().map(C::cell).collect())
    }
}

impl<R: Record> Content for &[R] {
    fn cell(self) -> Cell {
        Cell::List(self.iter().map(Content::cell).collect())
    }

    fn describe(to: &mut Reference) {
        to.items(R::describe);
    }
}

macro_rules! leaves {
    ($($leaf:ty: $cell:expr;)*) => {$(
        impl Content for $leaf {
            fn cell(self) -> Cell {
                $cell(self)
            }
        }
    )*};
}

leaves! {
    f64: Cell::Number;
    usize: |count| Cell::Count(count as u64);
    u64: Cell::Count;
    u32: |count| Cell::Count(u64::from(count));
    bool: Cell::Flag;
    &str: |text: &str| Cell::Text(text.to_owned());
    String: Cell::Text;
    Object: Cell::Object;
    Cell: |cell| cell;
}

impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Nothing => serializer.serialize_none(),
            Self::Number(number) => Finite(*number).serialize(serializer),
            Self::Count(count) => serializer.serialize_u64(*count),
            Self::Flag(flag) => serializer.serialize_bool(*flag),
            Self::Text(text) => serializer.serialize_str(text),
            Self::List(items) => serializer.collect_seq(items),
            Self::Object(object) => object.serialize(serializer),
        }
    }
}

impl Serialize for Object {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, cell) in &self.0 {
            map.serialize_entry(name, cell)?;
        }
        map.end()
    }
}

/// The names of the columns of a table of such records.
pub(crate) fn columns<R: Record>() -> Vec<String> {
    R::keys().into_iter().map(|key| key.path.into_owned()).collect()
}

/// The columns of a table of records: a name and a cell a record.
pub fn columns_of<R: Record>(rows: impl IntoIterator<Item = R>) -> Vec<(String, Vec<Cell>)> {
    let mut table: Vec<(String, Vec<Cell>)> = columns::<R>().into_iter().map(|name| (name, Vec::new())).collect();
    for row in rows {
        for ((_, column), (_, cell)) in table.iter_mut().zip(row.object().0) {
            column.push(cell);
        }
    }
    table
}

/// The text of a table in CSV: a header, and a row a record; a number that is not finite is an error that names its column.
pub(crate) fn csv(header: &[String], rows: impl Iterator<Item = Object>) -> io::Result<Vec<u8>> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.write_record(header)?;
    for Object(row) in rows {
        debug_assert!(row.iter().map(|(name, _)| name).eq(header), "{row:?} in a table of {header:?}");
        for (name, cell) in &row {
            if let Cell::Number(number) = cell
                && !number.is_finite()
            {
                return Err(io::Error::new(ErrorKind::InvalidData, format!("{name}: {number} is not a finite number")));
            }
        }
        writer.serialize(row.iter().map(|(_, cell)| cell).collect::<Vec<_>>())?;
    }
    writer.into_inner().map_err(|error| error.into_error())
}

// -- A table in CSV, written whole or not at all --

/// Writes `dir/name`: a header, the keys of the record, and a row a record.
///
/// Fails with [`ReportError::Write`] where the file cannot be written or a number is not finite.
pub fn write_table<R: Record>(
    dir: &Path,
    name: &str,
    rows: impl IntoIterator<Item = R>,
) -> Result<PathBuf, ReportError> {
    write_text(dir, name, table(rows))
}

/// The text of such a table.
pub(crate) fn table<R: Record>(rows: impl IntoIterator<Item = R>) -> io::Result<Vec<u8>> {
    csv(&columns::<R>(), rows.into_iter().map(|row| row.object()))
}

/// Writes this text, and says where it stands.
pub(crate) fn write_text(dir: &Path, name: &str, text: io::Result<Vec<u8>>) -> Result<PathBuf, ReportError> {
    let path = dir.join(name);
    let text = text.map_err(|source| ReportError::Write { path: path.clone(), source })?;
    write_whole(&path, &text)?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy)]
    struct Place {
        force: f64,
        error: f64,
    }

    impl Record for Place {
        fn fields(of: &mut Fields<Self>) {
            of.bounded(["force_nN", "error_nN"], "P there", |at| Some(Bounded::new(at.force, at.error)));
        }
    }

    struct Path {
        title: &'static str,
        places: Vec<Place>,
        last: Option<Place>,
        roll: Option<f64>,
    }

    impl Record for Path {
        fn fields(of: &mut Fields<Self>) {
            of.field("title", "what it is called", |path| path.title);
            of.field("places", "in their order", |path| path.places.as_slice());
            of.field("last", "where it ends", |path| path.last.as_ref());
            of.sometimes("roll_deg", "in space", |path| path.roll);
        }
    }

    const PLACE: Place = Place { force: 0.1 + 0.2, error: 1e-9 };

    fn path(places: Vec<Place>) -> Path {
        Path { title: "a", last: None, places, roll: None }
    }

    #[test]
    fn an_object_has_the_keys_in_their_order_and_numbers_with_all_digits() {
        let text = path(vec![PLACE]).to_json().unwrap();
        let expected = "{\n  \"title\": \"a\",\n  \"places\": [\n    {\n      \"force_nN\": 0.30000000000000004,\n      \"error_nN\": 1e-9\n    }\n  ],\n  \"last\": null\n}\n";
        assert_eq!(text, expected);
        let in_space = Path { roll: Some(2.0), last: Some(PLACE), ..path(Vec::new()) }.to_json().unwrap();
        assert!(
            in_space.contains("\"places\": []") && in_space.ends_with("},\n  \"roll_deg\": 2.0\n}\n"),
            "{in_space}"
        );
    }

    #[test]
    fn the_keys_are_listed_without_a_value_and_a_record_that_occurs_again_is_described_once() {
        let keys = Path::keys();
        let listed: Vec<_> = keys.iter().map(|key| (&*key.path, key.unit(), key.like.as_deref())).collect();
        let expected = [
            ("title", "", None),
            ("places", "", None),
            ("places[].force_nN", "nN", None),
            ("places[].error_nN", "nN", None),
            ("last", "", Some("places[]")),
            ("roll_deg", "deg", None),
        ];
        assert_eq!(listed, expected);
        assert_eq!((keys[3].about, keys[5].about), ("its bound", "in space"));
    }

    #[test]
    fn a_table_has_a_header_even_without_rows() {
        let table = |rows: &[(Place, Place)]| {
            let text = csv(&columns::<(&Place, Place)>(), rows.iter().map(|(a, b)| (a, *b).object()));
            text.map(|text| String::from_utf8(text).unwrap())
        };
        let header = "force_nN,error_nN,force_nN,error_nN\n";
        assert_eq!(table(&[]).unwrap(), header);
        assert_eq!(table(&[(PLACE, PLACE)]).unwrap(), format!("{header}{0},{0}\n", "0.30000000000000004,1e-9"));
    }

    #[test]
    fn a_number_that_is_not_finite_is_an_error_that_names_its_key() {
        for bad in [f64::NAN, f64::INFINITY] {
            let error = path(vec![PLACE, Place { force: bad, ..PLACE }]).to_json().unwrap_err().to_string();
            assert!(error.contains("places[1].force_nN"), "{error}");
            let row = Place { error: bad, ..PLACE }.object();
            let error = csv(&columns::<Place>(), [row].into_iter()).unwrap_err().to_string();
            assert_eq!(error, format!("error_nN: {bad} is not a finite number"));
        }
    }
}
