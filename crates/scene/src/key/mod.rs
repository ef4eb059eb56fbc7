//! One key of a scene: what it takes, where its value goes, and every message about it.

mod kind;

pub use kind::{Kind, Need};
pub use peelkit::model::Range;

use crate::bodies::{BODIES, body_of};
use crate::error::{Problem, one_line};
use crate::near::nearest;
use crate::pieces;
use crate::quantity::{Dimension, QuantityError, parse_quantity};
use crate::scene::Scene;
use crate::shape;
use crate::steps;
use crate::table::{read_heights, read_profile};
use crate::value::{Value, quoted, show};
use peelkit::adhesion::{LineLoad, Substrate};
use peelkit::model::{Attraction, Body, Hold, Measured, ProfileForm, Start};
use peelkit::study::Terms;
use std::sync::Arc;

/// A key of a scene.
#[derive(Debug)]
pub struct Key {
    /// The table it stands in; empty at the top of the file.
    pub table: &'static str,
    /// Its name within the table.
    pub name: &'static str,
    /// Whether a scene has to hold it.
    pub need: Need,
    /// What it takes.
    pub kind: Kind,
    /// What it means, in a few words.
    pub about: &'static str,
}

const LINE_LOADS: &[(&str, LineLoad)] =
    &[("full", LineLoad::Full), ("force-only", LineLoad::ForceOnly), ("axis-gap", LineLoad::AxisGap)];
const STARTS: &[(&str, Start)] = &[("conformed", Start::Conformed), ("flat", Start::Crests)];
const TERMS: &[(&str, Terms)] = &[("all", Terms::All), ("auto", Terms::Auto)];
const HOLDS: &[(&str, Hold)] = &[("free", Hold::Free), ("fixed", Hold::Fixed)];

impl Key {
    /// `strip.length`
    pub fn path(&self) -> String {
        if self.table.is_empty() { self.name.to_owned() } else { format!("{}.{}", self.table, self.name) }
    }

    /// Whether it may stand in this scene: one of a body that the scene does not peel may not, nor one of a substrate of another
    /// shape.
    pub fn belongs_to(&self, scene: &Scene) -> bool {
        match self.table {
            shape::TABLE => shape::has(&scene.model.ground.substrate, self.name),
            table if !BODIES.contains(&table) => true,
            table => match &scene.model.body {
                Body::Profile(profile) => {
                    table == body_of(scene) && self.fits(&profile.form, &scene.table_texts.profile)
                }
                _ => table == body_of(scene),
            },
        }
    }

    /// Whether a profile that has this form and table already may be given the key: it takes a table or pieces, and not both.
    fn fits(&self, form: &ProfileForm, table: &str) -> bool {
        match (&self.kind, form) {
            (Kind::Table(_), ProfileForm::Pieces(_)) => false,
            (Kind::Pieces(_), ProfileForm::Table(_)) => table.is_empty(),
            _ => true,
        }
    }

    /// The key of its table that a scene may hold in its place.
    pub fn alternative(&self) -> Option<&'static str> {
        match self.kind {
            Kind::Table(_) => Some("pieces"),
            Kind::Pieces(_) => Some("table"),
            _ => None,
        }
    }

    /// The shapes of a substrate that have it, where it is a key of one.
    pub fn shapes(&self) -> Vec<&'static str> {
        if self.table == shape::TABLE { shape::shapes_with(self.name) } else { Vec::new() }
    }

    /// That it may not.
    pub fn foreign(&self, scene: &Scene) -> Problem {
        if self.table == shape::TABLE {
            return shape::foreign(&scene.model.ground.substrate, self.name);
        }
        let body = body_of(scene);
        if let Some(other) = self.alternative().filter(|_| self.table == body) {
            return Problem::new(
                format!("is given beside `{}.{other}`, and the beam has one geometry", self.table),
                format!("Remove one of `{}` and `{other}`.", self.name),
            );
        }
        Problem::new(
            format!("is a key of [{}], and the scene peels a [{body}]", self.table),
            format!("A scene has one of the tables [{}].", BODIES.join("], [")),
        )
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
        matches!(self.kind, Kind::Count(_) | Kind::Fixed(..))
    }

    /// Whether its values are TOML strings.
    pub(crate) fn is_text(&self) -> bool {
        !matches!(self.kind, Kind::Number(..) | Kind::Share(..) | Kind::Flag(_) | Kind::Steps(_) | Kind::Pieces(_))
            && !self.is_count()
    }

    /// Puts a value into the scene if it is in range.
    pub(crate) fn store(&self, scene: &mut Scene, value: &Value) -> Result<(), Problem> {
        match (&self.kind, value) {
            (Kind::Text(place), Value::Text(text)) => *place(scene) = text.clone(),
            (Kind::Flag(place), &Value::Flag(flag)) => *place(scene) = flag,
            (Kind::Table(place), Value::Text(text)) => {
                let (table, text) =
                    read_profile(&scene.name, text).map_err(|found| Problem::new(found, self.remedy()))?;
                *place(scene) = ProfileForm::Table(table);
                scene.table_texts.profile = text;
            }
            (Kind::Pieces(place), Value::List(items)) => {
                let problem =
                    |fault: pieces::Fault| Problem { item: fault.item, ..Problem::new(fault.found, self.remedy()) };
                *place(scene) = ProfileForm::Pieces(pieces::read(items).map_err(problem)?);
            }
            (Kind::Attraction(place), Value::Text(word)) => *place(scene) = self.pick(&attractions(), word)?,
            (Kind::LineLoad(place), Value::Text(word)) => *place(scene) = self.pick(LINE_LOADS, word)?,
            (Kind::Hold(place), Value::Text(word)) => *place(scene) = self.pick(HOLDS, word)?,
            (Kind::Start(place), Value::Text(word)) => *place(scene) = self.pick(STARTS, word)?,
            (Kind::Terms(place), Value::Text(word)) => *place(scene) = self.pick(TERMS, word)?,
            (Kind::Steps(place), Value::List(items)) => {
                let text = |item: &Value| if let Value::Text(text) = item { Some(text.clone()) } else { None };
                let texts = items.iter().map(text).collect::<Option<Vec<_>>>().ok_or_else(|| self.wrong_type(value))?;
                *place(scene) = steps::read(&texts).map_err(|found| Problem::new(found, self.remedy()))?;
            }
            (Kind::Shape(place), Value::Text(word)) => {
                let name = self.pick(&shape::names(), word)?;
                place(scene).take_shape(name);
                if !matches!(place(scene), Substrate::Profile(_)) {
                    scene.table_texts.substrate.clear();
                }
            }
            (Kind::Heights(place), Value::Text(text)) => {
                let (heights, text) =
                    read_heights(&scene.name, text).map_err(|found| Problem::new(found, self.remedy()))?;
                *place(scene) = Substrate::Profile(Arc::new(heights));
                scene.table_texts.substrate = text;
            }
            (
                Kind::Measure(dimension, ..) | Kind::Quantity(dimension, _) | Kind::Bound(dimension, _),
                Value::Text(text),
            ) => {
                let number = parse_quantity(text, *dimension).map_err(|e| self.no_quantity(text, *dimension, e))?;
                self.store_number(scene, number)?;
            }
            (Kind::Number(..) | Kind::Share(..) | Kind::Count(_) | Kind::Fixed(..), &Value::Number(number)) => {
                self.store_number(scene, number)?;
            }
            (_, value) => return Err(self.wrong_type(value)),
        }
        Ok(())
    }

    /// Puts a number into the scene, in the unit of the library, if it is in range.
    pub fn store_number(&self, scene: &mut Scene, number: f64) -> Result<(), Problem> {
        if !self.belongs_to(scene) {
            return Err(self.foreign(scene));
        }
        let range = match self.kind {
            Kind::Number(range, _) | Kind::Share(range, _) | Kind::Measure(_, range, _) => range,
            Kind::Count(_) => Range::From(1.0, 1e9),
            Kind::Fixed(most, _) => Range::From(1.0, most as f64),
            _ => Range::Positive,
        };
        let found = Measured { value: number, unit: self.unit() };
        range.check(found).map_err(|wrong| Problem::new(wrong.to_string(), self.remedy()))?;
        match self.kind {
            Kind::Number(_, place) | Kind::Quantity(_, place) | Kind::Measure(_, _, place) => *place(scene) = number,
            Kind::Bound(_, place) | Kind::Share(_, place) => *place(scene) = Some(number),
            Kind::Count(_) | Kind::Fixed(..) if number.fract() != 0.0 => {
                return Err(Problem::new(format!("is {found}, which is not whole"), self.remedy()));
            }
            Kind::Count(place) => *place(scene) = number as usize,
            Kind::Fixed(_, place) => *place(scene) = Some(number as usize),
            _ => return Err(Problem::new("is not a number", self.remedy())),
        }
        Ok(())
    }

    /// Reads a text of the command line as a number of this key, in the unit of the library.
    pub fn parse_number(&self, text: &str) -> Result<f64, Problem> {
        match self.kind {
            Kind::Measure(dimension, ..) | Kind::Quantity(dimension, _) | Kind::Bound(dimension, _) => {
                parse_quantity(text, dimension).map_err(|e| self.no_quantity(text, dimension, e))
            }
            _ => text
                .trim()
                .parse()
                .map_err(|_| Problem::new(format!("is {}, not a number", quoted(text)), self.remedy())),
        }
    }

    /// What the scene holds for this key; nothing for a bound that is not set.
    pub fn value(&self, scene: &Scene) -> Option<Value> {
        let mut scene = scene.clone();
        Some(match self.kind {
            Kind::Text(place) => Value::Text(place(&mut scene).clone()),
            Kind::Number(_, place) | Kind::Quantity(_, place) | Kind::Measure(_, _, place) => {
                Value::Number(*place(&mut scene))
            }
            Kind::Bound(_, place) | Kind::Share(_, place) => Value::Number((*place(&mut scene))?),
            Kind::Fixed(_, place) => Value::Number((*place(&mut scene))? as f64),
            Kind::Count(place) => Value::Number(*place(&mut scene) as f64),
            Kind::Flag(place) => Value::Flag(*place(&mut scene)),
            Kind::Table(place) => match place(&mut scene) {
                ProfileForm::Table(_) => Value::Text(scene.table_texts.profile.clone()),
                ProfileForm::Pieces(_) => return None,
            },
            Kind::Pieces(place) => match place(&mut scene) {
                ProfileForm::Pieces(pieces) => pieces::written(pieces),
                ProfileForm::Table(_) => return None,
            },
            Kind::Attraction(place) => Value::Text(place(&mut scene).name().to_owned()),
            Kind::LineLoad(place) => Value::Text(word(LINE_LOADS, *place(&mut scene))),
            Kind::Hold(place) => Value::Text(word(HOLDS, *place(&mut scene))),
            Kind::Start(place) => Value::Text(word(STARTS, *place(&mut scene))),
            Kind::Terms(place) => Value::Text(word(TERMS, *place(&mut scene))),
            Kind::Steps(place) => {
                Value::List(place(&mut scene).iter().map(|step| Value::Text(step.to_string())).collect())
            }
            Kind::Shape(place) => Value::Text(place(&mut scene).name().to_owned()),
            Kind::Heights(place) => match place(&mut scene) {
                Substrate::Profile(_) => Value::Text(scene.table_texts.substrate.clone()),
                _ => return None,
            },
        })
    }

    /// What the key takes, in words.
    pub fn takes(&self) -> String {
        match self.kind {
            Kind::Text(_) => "a text in quotes".into(),
            Kind::Number(range, _) | Kind::Share(range, _) => range.to_string(),
            Kind::Quantity(dimension, _) | Kind::Bound(dimension, _) => {
                format!("{dimension} above zero with its unit in quotes ({})", dimension.units().join(", "))
            }
            Kind::Measure(dimension, range, _) => {
                let (unit, units) = (dimension.unit(), dimension.units().join(", "));
                format!("{dimension} with its unit in quotes ({units}), {range} in {unit}")
            }
            Kind::Count(_) => "a whole number from 1 to 1e9".into(),
            Kind::Fixed(most, _) => format!("a whole number from 1 to {most}"),
            Kind::Flag(_) => "true or false".into(),
            Kind::Table(_) => {
                "a CSV in quotes, or the name of a file beside the scene: one row for each position, with the columns s_nm, \
                               width_nm, height_nm and, optionally, angle_deg and roundness"
                    .into()
            }
            Kind::Attraction(_) => words(&attractions()),
            Kind::LineLoad(_) => words(LINE_LOADS),
            Kind::Hold(_) => words(HOLDS),
            Kind::Start(_) => words(STARTS),
            Kind::Terms(_) => words(TERMS),
            Kind::Steps(_) => steps::TAKES.into(),
            Kind::Pieces(_) => pieces::TAKES.into(),
            Kind::Shape(_) => words(&shape::names()),
            Kind::Heights(_) => {
                "a CSV in quotes, or the name of a file beside the scene: one row for each position, with the columns x_nm and \
                               height_nm"
                    .into()
            }
        }
    }

    /// A value that is right, as it stands in a scene.
    pub fn example(&self) -> &'static str {
        match (self.name, &self.kind) {
            ("length" | "wavelength", _) => "\"100 nm\"",
            ("radius", _) => "\"200 nm\"",
            ("height", _) => "\"10 nm\"",
            ("equilibrium_distance", _) => "\"0.4 nm\"",
            ("poissons_ratio", _) => "0.2",
            ("shear_correction", _) => "0.8333333333333334",
            ("presliding", _) => "\"0.01 nm\"",
            ("coefficient", _) => "0.3",
            ("relative", _) => "1e-6",
            ("order", _) => "7",
            (_, Kind::Text(_)) => "\"Peeling of a strip\"",
            (_, Kind::Number(..)) => "1.0",
            (_, Kind::Measure(Dimension::Angle, ..) | Kind::Quantity(Dimension::Angle, _)) => "\"45 deg\"",
            (_, Kind::Bound(Dimension::Angle, _)) => "\"45 deg\"",
            (_, Kind::Measure(Dimension::AnglePerLength, ..) | Kind::Quantity(Dimension::AnglePerLength, _)) => {
                "\"0.5 deg/nm\""
            }
            (_, Kind::Bound(Dimension::AnglePerLength, _)) => "\"0.5 deg/nm\"",
            (_, Kind::Measure(..)) => "\"0 nm\"",
            (_, Kind::Quantity(Dimension::Length, _)) => "\"1 nm\"",
            (_, Kind::Bound(Dimension::Length, _)) => "\"500 nm\"",
            (_, Kind::Quantity(Dimension::Pressure, _) | Kind::Bound(Dimension::Pressure, _)) => "\"2 GPa\"",
            (_, Kind::Quantity(Dimension::Energy, _) | Kind::Bound(Dimension::Energy, _)) => "\"1e-19 J\"",
            (_, Kind::Quantity(Dimension::Time, _) | Kind::Bound(Dimension::Time, _)) => "\"60 s\"",
            (_, Kind::Quantity(Dimension::Stiffness, _) | Kind::Bound(Dimension::Stiffness, _)) => "\"0.5 N/m\"",
            (_, Kind::Quantity(Dimension::Work, _) | Kind::Bound(Dimension::Work, _)) => "\"0.03 J/m2\"",
            (_, Kind::Quantity(Dimension::Force, _) | Kind::Bound(Dimension::Force, _)) => "\"1 nN\"",
            (_, Kind::Count(_)) => "20000",
            (_, Kind::Fixed(..)) => "20",
            (_, Kind::Share(..)) => "0.01",
            (_, Kind::Flag(_)) => "true",
            (_, Kind::Table(_)) => "\"s_nm,width_nm,height_nm\\n0,20,5\\n100,20,10\"",
            (_, Kind::Pieces(_)) => "[{ length = \"90 nm\", width = [\"9 nm\", \"5 nm\"], height = \"5 nm\" }]",
            (_, Kind::Attraction(_)) => "\"bilinear\"",
            (_, Kind::LineLoad(_)) => "\"full\"",
            (_, Kind::Hold(_)) => "\"fixed\"",
            (_, Kind::Steps(_)) => "[\"press 0.1 nm\", \"turn 1 deg\", \"hold\"]",
            (_, Kind::Start(_)) => "\"conformed\"",
            (_, Kind::Terms(_)) => "\"auto\"",
            (_, Kind::Shape(_)) => "\"flat\"",
            (_, Kind::Heights(_)) => "\"x_nm,height_nm\\n0,0\\n50,-8\\n100,0\"",
        }
    }

    /// A line of a scene that is right.
    pub(crate) fn example_line(&self) -> String {
        format!("{} = {}", self.name, self.example())
    }

    fn remedy(&self) -> String {
        format!("`{}` takes {}; for example {}", self.name, self.takes(), self.example_line())
    }

    fn pick<T: Copy>(&self, choices: &[(&'static str, T)], found: &str) -> Result<T, Problem> {
        if let Some(&(_, choice)) = choices.iter().find(|(word, _)| *word == found) {
            return Ok(choice);
        }
        let near = nearest(found, choices.iter().map(|&(word, _)| word));
        let guess = near.map(|word| format!("Did you mean \"{word}\"? ")).unwrap_or_default();
        Err(Problem::new(
            format!("is {}, which is none of its values", quoted(found)),
            format!("{guess}{}", self.remedy()),
        ))
    }

    fn no_quantity(&self, text: &str, dimension: Dimension, error: QuantityError) -> Problem {
        match error {
            QuantityError::NoNumber => {
                Problem::new(format!("is {}, which does not begin with a number", quoted(text)), self.remedy())
            }
            QuantityError::NoUnit => self.no_unit(&quoted(text), &one_line(text.trim()), dimension),
            QuantityError::UnknownUnit { unit, near } => {
                let guess = near.map(|near| format!("Did you mean \"{near}\"? ")).unwrap_or_default();
                Problem::new(
                    format!("is {}, whose unit {} is not known", quoted(text), quoted(&unit)),
                    format!("{guess}{}", self.remedy()),
                )
            }
            QuantityError::WrongDimension { unit, measures } => {
                Problem::new(format!("is {}: {unit} measures {measures}, not {dimension}", quoted(text)), self.remedy())
            }
        }
    }

    fn no_unit(&self, found: &str, number: &str, dimension: Dimension) -> Problem {
        let unit = dimension.unit();
        let remedy = format!("Write \"{number} {unit}\" if {unit} is meant. {}", self.remedy());
        Problem::new(format!("is {found}, a number without a unit"), remedy)
    }

    fn wrong_type(&self, value: &Value) -> Problem {
        match (&self.kind, value) {
            (
                Kind::Measure(dimension, ..) | Kind::Quantity(dimension, _) | Kind::Bound(dimension, _),
                Value::Number(number),
            ) => self.no_unit(&show(*number), &show(*number), *dimension),
            (Kind::Number(..) | Kind::Share(..) | Kind::Count(_) | Kind::Fixed(..), Value::Text(text))
                if text.trim().parse::<f64>().is_ok() =>
            {
                Problem::new(
                    format!("is {}, a number in quotes", quoted(text)),
                    format!("Remove the quotes: {} = {}", self.name, one_line(text.trim())),
                )
            }
            (Kind::Flag(_), Value::Text(text)) if matches!(text.trim(), "true" | "false") => Problem::new(
                format!("is {} in quotes", quoted(text)),
                format!("Remove the quotes: {} = {}", self.name, text.trim()),
            ),
            _ => Problem::new(format!("is {value}"), self.remedy()),
        }
    }
}

/// The names of the adhesion models in a scene.
fn attractions() -> Vec<(&'static str, Attraction)> {
    Attraction::all().map(|attraction| (attraction.name(), attraction)).collect()
}

fn word<T: Copy + PartialEq>(choices: &[(&'static str, T)], value: T) -> String {
    choices.iter().find(|(_, choice)| *choice == value).map_or("", |(word, _)| word).to_owned()
}

fn words<T>(choices: &[(&'static str, T)]) -> String {
    let words: Vec<String> = choices.iter().map(|(word, _)| format!("\"{word}\"")).collect();
    match words.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
        _ => words.concat(),
    }
}
