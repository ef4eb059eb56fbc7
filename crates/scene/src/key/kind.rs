//! One key of a scene: what it takes, and where in a scene its value goes.

use super::choice::Choice;
use super::table::{SETA, Table};
use crate::scene::Scene;
use crate::value::form::Form;
use crate::value::quantity::Dimension;
use crate::value::{Fault, Value};
use peelkit::adhesion::Substrate;
use peelkit::model::{Attraction, ProfileForm, Range, Step};

/// Whether a scene has to hold a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    /// A scene without it is refused.
    Required,
    /// What holds without it is what `Scene::empty` holds.
    Optional,
}

/// A key of an analysis that a scene asks for, which is read and written by functions of its own.
#[derive(Debug)]
pub struct Setting {
    /// What it takes, in words
    pub takes: &'static str,
    /// The same as a list of keys shows it
    pub brief: &'static str,
    /// What its value looks like
    pub form: fn() -> Form,
    /// A value that is right, as it stands in a scene
    pub example: &'static str,
    /// Puts a value into the scene, which may name keys of this list
    pub read: fn(&mut Scene, &Value, &[Key]) -> Result<(), Fault>,
    /// What the scene holds; nothing where it does not ask for the analysis
    pub write: fn(&Scene, &[Key]) -> Option<Value>,
}

/// What a key takes, and where in the scene its value goes.
#[derive(Debug)]
pub enum Kind {
    /// A text in quotes.
    Text(fn(&mut Scene) -> &mut String),
    /// A number without a unit.
    Number(Range, fn(&mut Scene) -> &mut f64),
    /// A number with a unit, in a range of its own.
    Measure(Dimension, Range, fn(&mut Scene) -> &mut f64),
    /// A positive number with a unit.
    Quantity(Dimension, fn(&mut Scene) -> &mut f64),
    /// The same, or nothing.
    Bound(Dimension, fn(&mut Scene) -> &mut Option<f64>),
    /// A whole number from 1 to this.
    Count(usize, fn(&mut Scene) -> &mut usize),
    /// A whole number from 1 to this, or nothing.
    Fixed(usize, fn(&mut Scene) -> &mut Option<usize>),
    /// A number without a unit, or nothing.
    Share(Range, fn(&mut Scene) -> &mut Option<f64>),
    /// true or false
    Flag(fn(&mut Scene) -> &mut bool),
    /// true or false: whether the scene is in space
    InSpace,
    /// One of several words.
    Word(&'static Choice),
    /// A table along a beam: a CSV of several lines, or the name of its file, which is looked for beside the scene.
    Table(fn(&mut Scene) -> &mut ProfileForm),
    /// A list of the pieces of a beam, in place of a table.
    Pieces(fn(&mut Scene) -> &mut ProfileForm),
    /// A word for the shape of the substrate.
    Shape(fn(&mut Scene) -> &mut Substrate),
    /// Heights of the substrate: a CSV of several lines, or the name of its file, which is looked for beside the scene.
    Heights(fn(&mut Scene) -> &mut Substrate),
    /// Openings and tractions of a cohesive law: a CSV of several lines, or the name of its file, which is looked for beside the scene.
    Tractions(fn(&mut Scene) -> &mut Attraction),
    /// A setting of an analysis that the scene asks for.
    Setting(&'static Setting),
    /// A list of motions of the grip before the pull.
    Steps(fn(&mut Scene) -> &mut Vec<Step>),
}

/// A key of a scene.
#[derive(Debug)]
pub struct Key {
    /// The table it stands in; empty at the top of the file.
    pub table: &'static str,
    /// That table
    pub(crate) of: &'static Table,
    /// Its name within the table.
    pub name: &'static str,
    /// Whether a scene has to hold it.
    pub need: Need,
    /// What it takes.
    pub kind: Kind,
    /// What it means, in a few words.
    pub about: &'static str,
    /// Words and symbol of an axis; empty of a key that is no number
    pub(crate) title: (&'static str, &'static str),
    /// Whether a scene in space alone has it
    pub(crate) of_space: bool,
}

impl Key {
    /// `strip.length`
    pub fn path(&self) -> String {
        if self.table.is_empty() { self.name.to_owned() } else { format!("{}.{}", self.table, self.name) }
    }

    /// Whether only a scene in space has it. Where a scene gives it and says nothing of `space`, it is in space.
    pub fn is_of_space(&self) -> bool {
        self.of_space
    }

    /// The unit of its number inside the library: `nm`; empty where it has none.
    pub fn unit(&self) -> &'static str {
        match self.kind {
            Kind::Measure(dimension, ..) | Kind::Quantity(dimension, _) | Kind::Bound(dimension, _) => dimension.unit(),
            _ => "",
        }
    }

    /// The key with the unit of its number, as an axis is labelled.
    pub fn label(&self) -> String {
        if self.unit().is_empty() { self.path() } else { format!("{} ({})", self.path(), self.unit()) }
    }

    /// Whether it takes one number, with a unit or without.
    pub fn is_numeric(&self) -> bool {
        let Self { kind, .. } = self;
        matches!(kind, Kind::Number(..) | Kind::Measure(..) | Kind::Quantity(..) | Kind::Bound(..) | Kind::Share(..))
            || self.is_count()
    }

    /// Whether it takes a whole number.
    pub fn is_count(&self) -> bool {
        matches!(self.kind, Kind::Count(..) | Kind::Fixed(..))
    }

    /// Whether its number is written without a decimal point.
    pub fn is_written_whole(&self, number: f64) -> bool {
        self.is_count() || matches!(self.kind, Kind::Setting(_)) && number.fract() == 0.0
    }

    /// Whether its value may be the name of a file.
    pub(crate) fn reads_a_file(&self) -> bool {
        let is_tree = (self.table, self.name) == (SETA.name, "tree");
        matches!(self.kind, Kind::Table(_) | Kind::Heights(_) | Kind::Tractions(_)) || is_tree
    }

    /// Whether its values are TOML strings.
    pub(crate) fn is_text(&self) -> bool {
        let plain = matches!(self.kind, Kind::Number(..) | Kind::Share(..) | Kind::Flag(_) | Kind::InSpace);
        !plain && !matches!(self.kind, Kind::Steps(_) | Kind::Pieces(_) | Kind::Setting(_)) && !self.is_count()
    }
}
