//! One key of a scene: what it takes, where its value goes, and every message about it.

mod access;
mod choice;
pub(crate) mod kind;
mod listing;
mod message;
mod title;

use kind::{Kind, Need};

use super::bodies::{BODIES, body_of};
use super::error::ValueError;
use super::scene::Scene;
use super::tables::{fit, optimisation, rate, seta, uncertainty};
use super::{shape, space};
use peelkit::model::{Body, ProfileForm};

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

impl Key {
    /// `strip.length`
    pub fn path(&self) -> String {
        if self.table.is_empty() { self.name.to_owned() } else { format!("{}.{}", self.table, self.name) }
    }

    /// Whether it may stand in this scene: one of a body that the scene does not peel may not, nor one of a substrate of another
    /// shape, nor one of space in the plane.
    pub fn belongs_to(&self, scene: &Scene) -> bool {
        if scene.seta.is_some() && !seta::has(self.table, self.name) {
            return false;
        }
        match self.table {
            seta::TABLE => scene.seta.is_some(),
            rate::TABLE => scene.time.is_some(),
            fit::TABLE => scene.fit.is_some(),
            optimisation::TABLE => scene.optimisation.is_some(),
            uncertainty::TABLE => scene.uncertainty.is_some(),
            _ if self.is_of_space() && scene.model.space.is_none() => false,
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
    pub fn foreign(&self, scene: &Scene) -> ValueError {
        if self.table == seta::TABLE || scene.seta.is_some() && !seta::has(self.table, self.name) {
            return seta::foreign(scene, self);
        }
        if self.table == shape::TABLE {
            return shape::foreign(&scene.model.ground.substrate, self.name);
        }
        if self.table == fit::TABLE {
            return ValueError::new(
                "is a key of [fit], a table that the scene does not have",
                "Add the table [fit] to the scene.",
            );
        }
        if self.table == rate::TABLE {
            return ValueError::new(
                "is a key of [time], a table that the scene does not have",
                "Add the table [time] to the scene.",
            );
        }
        let body = body_of(scene);
        if self.is_of_space() && (self.table == body || !BODIES.contains(&self.table)) {
            return space::foreign();
        }
        if let Some(other) = self.alternative().filter(|_| self.table == body) {
            return ValueError::new(
                format!("is given beside `{}.{other}`, and the beam has one geometry", self.table),
                format!("Remove one of `{}` and `{other}`.", self.name),
            );
        }
        ValueError::new(
            format!("is a key of [{}], and the scene peels a [{body}]", self.table),
            format!("A scene has one of the tables [{}]; a [seta] may stand beside a [spatula].", BODIES.join("], [")),
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
        matches!(self.kind, Kind::Count(..) | Kind::Fixed(..))
    }

    /// Whether its number is written without a decimal point.
    pub fn is_written_whole(&self, number: f64) -> bool {
        self.is_count() || matches!(self.kind, Kind::Setting(_)) && number.fract() == 0.0
    }

    /// Whether its value may be the name of a file.
    pub(crate) fn reads_a_file(&self) -> bool {
        matches!(self.kind, Kind::Table(_) | Kind::Heights(_))
    }

    /// Whether its values are TOML strings.
    pub(crate) fn is_text(&self) -> bool {
        let plain = matches!(self.kind, Kind::Number(..) | Kind::Share(..) | Kind::Flag(_) | Kind::InSpace);
        !plain && !matches!(self.kind, Kind::Steps(_) | Kind::Pieces(_) | Kind::Setting(_)) && !self.is_count()
    }
}
