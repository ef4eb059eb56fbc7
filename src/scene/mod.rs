//! The text a user writes, and every message about it.
//!
//! A scene is a TOML file; quantities are texts with their unit ("100 nm"). [`KEYS`] is the one list of what it may
//! hold.

mod document;
mod error;
mod friction;
mod key;
mod keys;
mod near;
mod pieces;
mod quantity;
mod shape;
mod steps;
mod table;
mod value;

pub use error::{Problem, SceneError};
pub use key::{Key, Kind, Need, Range};
pub use keys::{BODIES, KEYS, body_of, find_key};
pub use quantity::{Dimension, QuantityError, parse_quantity};
pub use value::Value;

use crate::model::{Adhesion, Attraction, Body, Grip, Hold, PeelModel, Strip};
use crate::study::{Accuracy, Bounds};
use std::path::Path;

/// A whole scene, every value checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Where it was read from.
    pub name: String,
    /// What it is called; the stem of `name` where the text gives no title.
    pub title: String,
    /// The body, its adhesion, its grip and how that is moved.
    pub model: PeelModel,
    /// What the user asks of the numbers.
    pub accuracy: Accuracy,
    /// Where the path may be stopped although it goes on.
    pub bounds: Bounds,
}

impl Scene {
    /// Reads a scene. `name` is that of the file and stands in every message; `overrides` are keys with values that
    /// replace those of the text (`--set`): a TOML value, or a text without its quotes.
    ///
    /// ```
    /// use peelkit::scene::Scene;
    ///
    /// let text = r#"
    /// [strip]
    /// length = "0.1 um"
    /// height = "10 nm"
    /// youngs_modulus = "2 GPa"
    /// [adhesion]
    /// hamaker_constant = "1e-19 J"
    /// equilibrium_distance = "0.4 nm"
    /// "#;
    /// let scene = Scene::parse("strip.toml", text, &[("strip.height".into(), "5 nm".into())])?;
    /// assert_eq!((scene.model.length(), scene.model.free_end()), (100.0, (1.0, 5.0)));
    ///
    /// let error = Scene::parse("strip.toml", &text.replace("10 nm", "10"), &[]).unwrap_err();
    /// assert_eq!(error.to_string(), "strip.toml, line 4: `strip.height` is \"10\", a number without a unit");
    /// # Ok::<(), peelkit::scene::SceneError>(())
    /// ```
    pub fn parse(name: &str, text: &str, overrides: &[(String, String)]) -> Result<Self, SceneError> {
        let mut scene = Self::empty(name);
        document::read(&mut scene, text, overrides)?;
        Ok(scene)
    }

    /// Whether values fit one another that are right by themselves: the key that does not, and why.
    pub fn check(&self) -> Result<(), (&'static Key, Problem)> {
        let problem = |path: &str, found: String, remedy: &str| {
            let key = KEYS.iter().find(|key| key.path() == path);
            key.map_or(Ok(()), |key| Err((key, Problem::new(found, remedy))))
        };
        let adhesion = &self.model.adhesion;
        if !adhesion.attraction.takes_work_and_strength() {
            for (path, value) in [("adhesion.work", adhesion.work), ("adhesion.strength", adhesion.strength)] {
                if value.is_some() {
                    let laws: Vec<String> = Attraction::cohesive().map(|law| format!("\"{}\"", law.name())).collect();
                    return problem(
                        path,
                        "is of a cohesive law, and the law of this scene is none".into(),
                        &format!(
                            "Give `law` = {} beside it, or leave it away: without one, hamaker_constant and \
                             equilibrium_distance say all.",
                            laws.join(" or ")
                        ),
                    );
                }
            }
        }
        let grip = &self.model.grip;
        let stretched = self.model.strip().is_some() && self.model.ground.substrate.is_flat();
        if grip.pretension.is_some() && (!stretched || grip.horizontal == Hold::Free) {
            return problem(
                "grip.pretension",
                "stretches a strip on flat ground whose grip is held across the pull, and this scene has none".into(),
                "Peel a [strip] with `horizontal = \"fixed\"` under [grip], on a flat substrate, or leave `pretension` away.",
            );
        }
        let misfit = friction::misfit(&self.model).or_else(|| shape::misfit(&self.model));
        if let Some((path, found, remedy)) = misfit.or_else(|| steps::misfit(&self.model)) {
            return problem(path, found, remedy);
        }
        let spatula = match &self.model.body {
            Body::Spatula(spatula) => spatula,
            Body::Strip(_) if self.model.pull.direction().up.abs() < 1e-9 && self.model.friction_law().is_none() => {
                return problem(
                    "drive.angle",
                    format!(
                        "is {} degrees, along the strip, which that only stretches or presses",
                        self.model.pull.angle.to_degrees()
                    ),
                    "Pull at an angle between, above 0 and below 180 degrees: `angle = \"60 deg\"`.",
                );
            }
            _ => return Ok(()),
        };
        let (rounding, pad) = (spatula.tip_rounding_length, spatula.pad_length);
        if rounding > pad {
            return problem(
                "spatula.tip_rounding_length",
                format!("is {rounding} nm, more than the pad is long ({pad} nm)"),
                "Round no more than the pad: `tip_rounding_length` at most `pad_length`.",
            );
        }
        let (width, tip) = (spatula.tip_rounding_width, spatula.tip_width);
        if rounding > 0.0 && width > tip {
            return problem(
                "spatula.tip_rounding_width",
                format!("is {width} nm, more than the tip is wide ({tip} nm)"),
                "A rounded tip is narrower at its end: `tip_rounding_width` at most `tip_width`.",
            );
        }
        let (bend, behind) = (spatula.bend_length, spatula.neck_length + spatula.shaft_length);
        if bend > behind {
            return problem(
                "spatula.bend_length",
                format!("is {bend} nm, more than neck and shaft are long ({behind} nm)"),
                "Let the bend end on the shaft: `bend_length` at most `neck_length` and `shaft_length` together.",
            );
        }
        Ok(())
    }

    /// A scene that holds the defaults; what has none is NaN until the text gives it.
    pub(crate) fn empty(name: &str) -> Self {
        let title = Path::new(name).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let adhesion = Adhesion::of_half_space(f64::NAN, f64::NAN);
        Self {
            name: name.to_owned(),
            title,
            model: PeelModel::of(Body::Strip(Strip::UNKNOWN), adhesion, Grip::FREE),
            accuracy: Accuracy::to(1e-6),
            bounds: Bounds { points: 20_000, time_s: Some(60.0), displacement: None },
        }
    }
}

impl Strip {
    /// The defaults; what has none is NaN until a text gives it.
    pub(crate) const UNKNOWN: Self = Self {
        length: f64::NAN,
        height: f64::NAN,
        width: 1.0,
        youngs_modulus: f64::NAN,
        poissons_ratio: 0.2,
        shear_correction: 5.0 / 6.0,
        bending_stiffness_factor: 1.0,
    };
}

impl Key {
    /// What holds where a scene does not give the key.
    pub fn default_value(&self) -> Option<Value> {
        match self.need {
            Need::Required => None,
            Need::Optional => self.value(&Scene::empty("")),
        }
    }
}
