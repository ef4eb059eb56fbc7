//! A value goes into a scene under its key, and comes out again.

use super::choice::measured;
use super::kind::{Key, Kind};
use crate::body::{set_space, shape_names};
use crate::error::ValueError;
use crate::key::pieces;
use crate::scene::Scene;
use crate::value::quantity::{Comma, Dimension, parse_quantity};
use crate::value::table::{read_heights, read_profile};
use crate::value::traction::read_tractions;
use crate::value::{Fault, Value, quoted, steps};
use peelkit::adhesion::Substrate;
use peelkit::model::{Measured, ModelErrorKind, ProfileForm, Range, angle_text};
use std::sync::Arc;

impl Key {
    /// Puts a value into the scene if it is in range; it may name keys of this list.
    pub(crate) fn put(&self, keys: &[Key], scene: &mut Scene, value: &Value) -> Result<(), ValueError> {
        match (&self.kind, value) {
            (Kind::Text(place), Value::Text(text)) => *place(scene) = text.clone(),
            (Kind::Flag(place), &Value::Flag(flag)) => *place(scene) = flag,
            (Kind::InSpace, &Value::Flag(flag)) => set_space(scene, flag),
            (Kind::Table(place), Value::Text(text)) => {
                let (table, text) =
                    read_profile(&scene.name, text).map_err(|found| ValueError::new(found, self.remedy()))?;
                *place(scene) = ProfileForm::Table(table);
                scene.table_texts.profile = text;
            }
            (Kind::Pieces(place), Value::List(items)) => {
                let problem =
                    |fault: Fault| ValueError { item: fault.item, ..ValueError::new(fault.found, self.remedy()) };
                *place(scene) = ProfileForm::Pieces(pieces::read(items).map_err(problem)?);
            }
            (Kind::Word(choice), Value::Text(word)) => (choice.put)(scene, self.pick(&(choice.words)(), word)?),
            (Kind::Setting(setting), value) => (setting.read)(scene, value, keys)
                .map_err(|fault| ValueError { item: fault.item, ..ValueError::new(fault.found, self.remedy()) })?,
            (Kind::Steps(place), Value::List(items)) => {
                let text = |item: &Value| if let Value::Text(text) = item { Some(text.clone()) } else { None };
                let texts = items.iter().map(text).collect::<Option<Vec<_>>>().ok_or_else(|| self.wrong_type(value))?;
                *place(scene) = steps::read(&texts).map_err(|found| ValueError::new(found, self.remedy()))?;
            }
            (Kind::Shape(place), Value::Text(word)) => {
                let shapes = shape_names();
                place(scene).take_shape(shapes[self.pick(&shapes, word)?]);
                if !matches!(place(scene), Substrate::Profile(_)) {
                    scene.table_texts.substrate.clear();
                }
            }
            (Kind::Heights(place), Value::Text(text)) => {
                let (heights, text) =
                    read_heights(&scene.name, text).map_err(|found| ValueError::new(found, self.remedy()))?;
                *place(scene) = Substrate::Profile(Arc::new(heights));
                scene.table_texts.substrate = text;
            }
            (Kind::Tractions(place), Value::Text(text)) => {
                let (table, text) =
                    read_tractions(&scene.name, text).map_err(|found| ValueError::new(found, self.remedy()))?;
                *place(scene) = measured(&table);
                scene.table_texts.law = text;
            }
            (
                Kind::Measure(dimension, ..) | Kind::Quantity(dimension, _) | Kind::Bound(dimension, _),
                Value::Text(text),
            ) => {
                let number = parse_quantity(text, *dimension).map_err(|e| self.no_quantity(text, *dimension, e))?;
                self.store_number(scene, number)?;
            }
            (Kind::Number(..) | Kind::Share(..) | Kind::Count(..) | Kind::Fixed(..), &Value::Number(number)) => {
                self.store_number(scene, number)?;
            }
            (_, value) => return Err(self.wrong_type(value)),
        }
        Ok(())
    }

    /// Puts a number into the scene, in the unit of the library, if it is in range; one of space puts the scene there.
    ///
    /// Fails where it is out of range, is not whole where it has to be, or the key does not belong to the scene.
    pub fn store_number(&self, scene: &mut Scene, number: f64) -> Result<(), ValueError> {
        if !self.is_of_space() && !self.belongs_to(scene) {
            return Err(self.foreign(scene));
        }
        let found = Measured { value: number, unit: self.unit() };
        self.range().check(found).map_err(|wrong| {
            let found = match wrong {
                ModelErrorKind::OutOfRange { .. } if self.unit() == Dimension::Angle.unit() => {
                    format!("is {}, which is out of range", angle_text(number))
                }
                wrong => wrong.to_string(),
            };
            ValueError::new(found, self.remedy())
        })?;
        match self.kind {
            _ if self.put_number(scene, number) => {}
            Kind::Count(..) | Kind::Fixed(..) if number.fract() != 0.0 => {
                return Err(ValueError::new(format!("is {found}, which is not whole"), self.remedy()));
            }
            Kind::Count(_, place) => *place(scene) = number as usize,
            Kind::Fixed(_, place) => *place(scene) = Some(number as usize),
            _ => return Err(ValueError::new("is not a number", self.remedy())),
        }
        Ok(())
    }

    /// What its number may be.
    pub fn range(&self) -> Range {
        match self.kind {
            Kind::Number(range, _) | Kind::Share(range, _) | Kind::Measure(_, range, _) => range,
            Kind::Count(most, _) | Kind::Fixed(most, _) => Range::From(1.0, most as f64),
            _ => Range::Positive,
        }
    }

    /// Puts a number with or without a unit into the scene, whatever it is; says whether the key takes one.
    pub(crate) fn put_number(&self, scene: &mut Scene, number: f64) -> bool {
        match self.kind {
            Kind::Number(_, place) | Kind::Quantity(_, place) | Kind::Measure(_, _, place) => *place(scene) = number,
            Kind::Bound(_, place) | Kind::Share(_, place) => *place(scene) = Some(number),
            _ => return false,
        }
        true
    }

    /// Reads a text of the command line as a number of this key, in the unit of the library.
    ///
    /// Fails where it is no number, or its unit is missing, unknown or of something else.
    pub fn parse_number(&self, text: &str) -> Result<f64, ValueError> {
        match self.kind {
            Kind::Measure(dimension, ..) | Kind::Quantity(dimension, _) | Kind::Bound(dimension, _) => {
                parse_quantity(text, dimension).map_err(|e| self.no_quantity(text, dimension, e))
            }
            _ => text.trim().parse().map_err(|_| match Comma::find(text) {
                Some(comma) => self.with_comma(text, &comma),
                None => ValueError::new(format!("is {}, not a number", quoted(text)), self.remedy()),
            }),
        }
    }

    /// What the scene holds for this key of a list; nothing for a bound that is not set.
    pub(crate) fn held(&self, keys: &[Key], scene: &Scene) -> Option<Value> {
        if let Kind::Setting(setting) = self.kind {
            return (setting.write)(scene, keys);
        }
        let mut scene = scene.clone();
        Some(match self.kind {
            Kind::Setting(_) => return None,
            Kind::Text(place) => Value::Text(place(&mut scene).clone()),
            Kind::Number(_, place) | Kind::Quantity(_, place) | Kind::Measure(_, _, place) => {
                Value::Number(*place(&mut scene))
            }
            Kind::Bound(_, place) | Kind::Share(_, place) => Value::Number((*place(&mut scene))?),
            Kind::Fixed(_, place) => Value::Number((*place(&mut scene))? as f64),
            Kind::Count(_, place) => Value::Number(*place(&mut scene) as f64),
            Kind::Flag(place) => Value::Flag(*place(&mut scene)),
            Kind::InSpace => Value::Flag(scene.model.space.is_some()),
            Kind::Table(place) => match place(&mut scene) {
                ProfileForm::Table(_) => Value::Text(scene.table_texts.profile.clone()),
                ProfileForm::Pieces(_) => return None,
            },
            Kind::Pieces(place) => match place(&mut scene) {
                ProfileForm::Pieces(pieces) => pieces::written(pieces),
                ProfileForm::Table(_) => return None,
            },
            Kind::Word(choice) => Value::Text(choice.word(&mut scene)?.to_owned()),
            Kind::Steps(place) => {
                Value::List(place(&mut scene).iter().map(|step| Value::Text(step.to_string())).collect())
            }
            Kind::Shape(place) => Value::Text(place(&mut scene).name().to_owned()),
            Kind::Heights(place) => match place(&mut scene) {
                Substrate::Profile(_) => Value::Text(scene.table_texts.substrate.clone()),
                _ => return None,
            },
            Kind::Tractions(place) => {
                place(&mut scene).table()?;
                Value::Text(scene.table_texts.law.clone())
            }
        })
    }
}
