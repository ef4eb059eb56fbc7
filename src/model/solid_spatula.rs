//! A spatula or a profile as a solid in space: how it is cut into elements, and what of a model of beams such a solid does not have.

use super::body::Body;
use super::check::error::ModelError;
use super::ground::Start;
use super::peel::{Hold, PeelModel};
use crate::adhesion::section::law::Attraction;
use crate::beam::section::{Material, SHEAR_CORRECTION};
use crate::beam::varying::BeamGeometry;
use crate::solid::grip::GripDrive;
use crate::solid::spatula::geometry::rise;
use crate::solid::spatula::solid_spatula::{SolidSpatula, SpatulaMesh};
use std::sync::Arc;

/// How a spatula or a profile is cut into elements. Distances of stations along S in nm: at most these.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidSpatulaSettings {
    /// On the pad, which lies flat at rest
    pub along: f64,
    /// Where the axis bends, behind the pad; twice that behind the bend, as far as it adheres
    pub neck: f64,
    /// On the shaft, which does not adhere
    pub shaft: f64,
    /// Elements across the half width
    pub across: usize,
}

impl Default for SolidSpatulaSettings {
    /// Stations of 2, 3 and 150 nm, and two elements across the half width.
    fn default() -> Self {
        Self::every(2.0)
    }
}

/// Distances of stations in the bend over those on the pad, and on the shaft, nm.
const IN_BEND: f64 = 1.5;
const ON_SHAFT: f64 = 150.0;
/// Elements across the half width.
const USUAL_ACROSS: usize = 2;

impl SolidSpatulaSettings {
    /// With this distance of the stations on the pad, nm.
    pub const fn every(along: f64) -> Self {
        Self { along, neck: IN_BEND * along, shaft: ON_SHAFT, across: USUAL_ACROSS }
    }
}

/// Why a spatula cannot be computed as a solid. Lengths in nm.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SolidSpatulaError {
    /// What is wrong with the model as one of a beam.
    #[error("{0}")]
    Model(#[from] ModelError),
    /// A distance that is none.
    #[error("`{key}` is {found} nm, which is not above zero")]
    NoDistance { key: &'static str, found: f64 },
    /// Elements across that are too few or too many.
    #[error("`solid.across` is {found}: from 1 to {MOST_ACROSS} elements are offered across the half width")]
    Across { found: usize },
    /// More stations than a computer holds.
    #[error("the stations are {stations:.1e} in number; at most {MOST_STATIONS} are computed")]
    TooMany { stations: f64 },
    /// Something of a model that a solid spatula does not have.
    #[error("`{key}` is given, and a solid in space {why}")]
    NotOfSolid { key: &'static str, why: &'static str },
}

/// Most elements across the half width.
pub const MOST_ACROSS: usize = 16;
/// Most stations.
const MOST_STATIONS: usize = 20_000;
/// Distances of stations behind the bend over those in it.
const BEHIND_BEND: f64 = 2.0;
/// Most turn of the underside over an element, rad.
const MOST_TURN: f64 = 0.15;
/// Lines across lie at 1 - (1 - k/n)^p, closer at the free edge.
const GRADING: f64 = 1.5;

impl SolidSpatulaError {
    /// The key of a scene that gives the value.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Model(error) => error.key(),
            Self::NoDistance { key, .. } | Self::NotOfSolid { key, .. } => key,
            Self::Across { .. } => "solid.across",
            Self::TooMany { .. } => "solid.along",
        }
    }

    /// What would be right: a sentence of its own.
    pub fn remedy(&self) -> String {
        match self {
            Self::Model(error) => error.remedy(),
            Self::NoDistance { .. } => "Give a number above zero, in nm.".into(),
            Self::Across { .. } => "Give 2, or 4 for a second opinion.".into(),
            Self::TooMany { .. } => "Give stations that are farther apart.".into(),
            Self::NotOfSolid { .. } => "Remove it, or remove the table [solid] to compute a beam.".into(),
        }
    }
}

impl SolidSpatulaSettings {
    /// The spatula of a model on these settings.
    ///
    /// # Errors
    /// What is wrong first: with the model, with the settings, or what of the model a solid spatula does not have.
    ///
    /// ```
    /// use peelkit::model::{Hold, SolidSpatulaSettings, Spatula};
    ///
    /// let mut model = Spatula::default().model();
    /// model.grip.rotation = Hold::Fixed;
    /// model.adhesion.far_face = false;
    /// let spatula = SolidSpatulaSettings::default().spatula(&model)?;
    /// assert_eq!((spatula.elements(), spatula.unknowns()), (316, 13317));
    /// let error = SolidSpatulaSettings { across: 0, ..Default::default() }.spatula(&model).unwrap_err();
    /// assert_eq!(error.key(), "solid.across");
    /// # Ok::<(), peelkit::model::SolidSpatulaError>(())
    /// ```
    pub fn spatula(&self, model: &PeelModel) -> Result<SolidSpatula, SolidSpatulaError> {
        let mesh = self.mesh(model)?;
        let body = model.body.geometry();
        let Material { youngs_modulus, poissons_ratio, .. } = body.material();
        let ground = (model.adhesion.half_space(), model.ground.substrate.clone());
        Ok(SolidSpatula::new(body.shared(), (youngs_modulus, poissons_ratio), ground, drive_of(model), mesh))
    }

    /// The mesh of a model.
    pub(super) fn mesh(&self, model: &PeelModel) -> Result<SpatulaMesh, SolidSpatulaError> {
        model.check()?;
        what_it_has(model)?;
        self.check()?;
        let zones = Zones::of(model)?;
        let pressed = (model.ground.start == Start::Conformed).then_some(zones.pad);
        let stations = self.stations(model.body.geometry(), &zones)?;
        Ok(SpatulaMesh { stations, sides: self.sides(), adhering: zones.adhering, pressed })
    }

    fn check(&self) -> Result<(), SolidSpatulaError> {
        let distances = [("solid.along", self.along), ("solid.neck", self.neck), ("solid.shaft", self.shaft)];
        if let Some((key, found)) = distances.into_iter().find(|(_, found)| !(found.is_finite() && *found > 0.0)) {
            return Err(SolidSpatulaError::NoDistance { key, found });
        }
        if !(1..=MOST_ACROSS).contains(&self.across) {
            return Err(SolidSpatulaError::Across { found: self.across });
        }
        Ok(())
    }

    /// S of the stations: every break is one.
    fn stations(&self, outline: &dyn BeamGeometry, zones: &Zones) -> Result<Vec<f64>, SolidSpatulaError> {
        let distance = |middle: f64| match middle {
            _ if middle < zones.pad => self.along,
            _ if middle < zones.bend => self.neck,
            _ if middle < zones.adhering => BEHIND_BEND * self.neck,
            _ => self.shaft,
        };
        let parts = |pair: &[f64]| {
            let turn = outline.at(pair[1]).underside[0] - outline.at(pair[0]).underside[0];
            let by_length = (pair[1] - pair[0]) / distance(0.5 * (pair[0] + pair[1]));
            by_length.max(turn.abs() / MOST_TURN).ceil().max(1.0)
        };
        let ends = ends(outline);
        let stations: f64 = ends.windows(2).map(parts).sum();
        if stations > MOST_STATIONS as f64 {
            return Err(SolidSpatulaError::TooMany { stations });
        }
        let mut found = vec![0.0];
        for pair in ends.windows(2) {
            let parts = parts(pair) as usize;
            let cut =
                |k: usize| if k == parts { pair[1] } else { pair[0] + (pair[1] - pair[0]) * k as f64 / parts as f64 };
            found.extend((1..=parts).map(cut));
        }
        Ok(found)
    }

    fn sides(&self) -> Vec<f64> {
        (0..=self.across).map(|k| 1.0 - (1.0 - k as f64 / self.across as f64).powf(GRADING)).collect()
    }
}

/// S of the free end, of the breaks and of the grip, nm.
fn ends(outline: &dyn BeamGeometry) -> Vec<f64> {
    let mut ends = vec![0.0, outline.length()];
    ends.extend(outline.breaks());
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    ends
}

/// Where stations lie how close, and what adheres: S of the ends, nm.
struct Zones {
    /// Of what lies flat at rest
    pad: f64,
    /// Of where the underside turns up from the ground
    bend: f64,
    /// Of what adheres
    adhering: f64,
}

/// A rise over the ground at rest that counts as none, one that is near, and one from which nothing acts, over r0: the traction is below 1e-5 of its
/// largest value there.
const FLAT: f64 = 0.1;
const NEAR: f64 = 12.0;
const OUT_OF_REACH: f64 = 50.0;
/// A width or a roundness changes by less at a break, as a share, unless it jumps there.
const JUMP: f64 = 1e-3;

impl Zones {
    /// Of a spatula its pad, its bend and its neck; of a profile by how high its pieces begin over the ground.
    fn of(model: &PeelModel) -> Result<Self, SolidSpatulaError> {
        match &model.body {
            Body::Spatula(body) => Ok(Self {
                pad: body.pad_length,
                bend: body.pad_length + body.bend_length,
                adhering: body.pad_length + body.neck_length,
            }),
            body @ Body::Profile(_) => Self::of_profile(body.geometry().shared(), model.adhesion.equilibrium_distance),
            Body::Strip(_) => Err(not_of_solid("strip", "is a spatula or a profile")),
        }
    }

    fn of_profile(outline: Arc<dyn BeamGeometry>, distance: f64) -> Result<Self, SolidSpatulaError> {
        let step = JUMP * JUMP * outline.length();
        let jumps = |&place: &f64| {
            let [before, behind] = [place - step, place + step].map(|place| outline.at(place));
            (behind.width - before.width).abs() > JUMP * before.width
                || (behind.roundness - before.roundness).abs() > JUMP
        };
        if outline.breaks().iter().any(jumps) {
            return Err(not_of_solid("profile.pieces", "has no jump of its width or of its roundness"));
        }
        let ends = ends(&*outline);
        let rise = rise(outline, &ends);
        let flat = rise.iter().take_while(|rise| **rise < FLAT * distance).count() - 1;
        let last = |reach: f64| (0..ends.len() - 1).rfind(|&k| rise[k] < reach * distance).map_or(0, |k| k + 1);
        Ok(Self { pad: ends[flat], bend: ends[last(NEAR)], adhering: ends[last(OUT_OF_REACH)] })
    }
}

/// What the grip of a model does to a rigid end face.
pub(super) fn drive_of(model: &PeelModel) -> GripDrive {
    let [rotation, across] = [model.grip.rotation, model.grip.horizontal].map(|hold| hold == Hold::Fixed);
    GripDrive { rotation, across, direction: model.pull.direction(), turn: model.pull.turn }
}

fn not_of_solid(key: &'static str, why: &'static str) -> SolidSpatulaError {
    SolidSpatulaError::NotOfSolid { key, why }
}

/// That a model has nothing that a solid spatula does not have.
fn what_it_has(model: &PeelModel) -> Result<(), SolidSpatulaError> {
    let refused = [
        (model.adhesion.far_face, "adhesion.far_face", "adheres by its underside alone"),
        (model.space.is_some(), "space", "is pulled in its plane of symmetry"),
    ];
    let found = refused.into_iter().chain(of_beams_alone(model)).find(|refused| refused.0);
    found.map_or(Ok(()), |(_, key, why)| Err(not_of_solid(key, why)))
}

/// What no solid has, whether it is given, and what a solid does instead.
pub(super) fn of_beams_alone(model: &PeelModel) -> [(bool, &'static str, &'static str); 7] {
    let of_half_space = matches!(model.adhesion.attraction, Attraction::BodyForce | Attraction::SurfaceTraction);
    let material = model.body.geometry().material();
    let [bending, shear] = match model.body {
        Body::Strip(_) => ["strip.bending_stiffness_factor", "strip.shear_correction"],
        Body::Spatula(_) => ["spatula.bending_stiffness_factor", "spatula.shear_correction"],
        Body::Profile(_) => ["profile.bending_stiffness_factor", "profile.shear_correction"],
    };
    [
        (material.bending_stiffness_factor != 1.0, bending, "bends as its material does"),
        ((material.shear_correction - SHEAR_CORRECTION).abs() > 1e-12, shear, "shears as its material does"),
        (!of_half_space, "adhesion.law", "adheres by the forces of a half space"),
        (model.friction.strength.is_some(), "friction.strength", "slides freely along the ground"),
        (model.grip.pretension.is_some(), "grip.pretension", "adheres without pretension"),
        (model.grip.stiffness.is_some(), "grip.stiffness", "is moved by its grip itself"),
        (!model.steps.is_empty(), "drive.steps", "is pulled from rest"),
    ]
}
