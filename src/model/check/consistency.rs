//! Whether the numbers of a model fit one another.

use super::drive;
use super::error::{Measured, ModelError, ModelErrorKind};
use crate::adhesion::section::line_load::LineLoad;
use crate::adhesion::spatial_section::section::SectionShape;
use crate::beam::section::Material;
use crate::model::body::Body;
use crate::model::body::profile::ProfileForm;
use crate::model::body::spatula::Spatula;
use crate::model::body::strip::Strip;
use crate::model::peel::{Hold, PeelModel};

/// First what is wrong.
pub(super) fn check(model: &PeelModel) -> Result<(), ModelError> {
    adhesion(model)?;
    friction(model)?;
    length(model)?;
    ground(model)?;
    drive::check(model)?;
    body(model)?;
    space(model)
}

/// Most process zones along a beam: the strip of the paper of 3 mm is 1.4e6 of them long and has its peak to 1e-10; that of 10 mm, of 4.6e6, has none.
const MOST_ZONES: f64 = 2e6;

/// That the beam is no longer than so many of its process zones, before anything of its size is made.
fn length(model: &PeelModel) -> Result<(), ModelError> {
    let zones = model.length() / model.process_length();
    if zones > MOST_ZONES {
        return Err(ModelError::new(
            key_of_length(&model.body),
            ModelErrorKind::TooLong { found: zones, most: MOST_ZONES },
        ));
    }
    Ok(())
}

/// What makes a body long.
fn key_of_length(body: &Body) -> &'static str {
    match body {
        Body::Strip(_) => "strip.length",
        Body::Profile(profile) => match profile.form {
            ProfileForm::Table(_) => "profile.table",
            ProfileForm::Pieces(_) => "profile.pieces",
        },
        Body::Spatula(Spatula { pad_length, neck_length, shaft_length, .. }) => {
            let lengths = [
                ("spatula.pad_length", pad_length),
                ("spatula.neck_length", neck_length),
                ("spatula.shaft_length", shaft_length),
            ];
            lengths.iter().max_by(|a, b| a.1.total_cmp(b.1)).map_or("spatula.pad_length", |longest| longest.0)
        }
    }
}

/// That work and strength belong to the law, and that what has a pretension is stretched.
fn adhesion(model: &PeelModel) -> Result<(), ModelError> {
    let adhesion = &model.adhesion;
    let numbers = [("adhesion.work", adhesion.work, "J/m2"), ("adhesion.strength", adhesion.strength, "GPa")];
    let shear = [
        ("adhesion.shear_strength", adhesion.shear_strength, "GPa"),
        ("adhesion.shear_work", adhesion.shear_work, "J/m2"),
    ];
    let given = |(key, value, unit): (&'static str, Option<f64>, &'static str)| {
        value.map(|value| (key, Measured { value, unit }))
    };
    if !adhesion.attraction.is_cohesive() {
        if let Some((key, found)) = numbers.into_iter().chain(shear).find_map(given) {
            return Err(ModelError::new(key, ModelErrorKind::NotOfCohesiveLaw { found }));
        }
    } else if let (Some(_), Some((key, found))) = (adhesion.attraction.table(), numbers.into_iter().find_map(given)) {
        return Err(ModelError::new(key, ModelErrorKind::BesideTable { found }));
    }
    shear_strength(model)?;
    healing(model)?;
    let stretched = model.strip().is_some() && model.ground.substrate.is_flat();
    match model.grip.pretension {
        Some(value) if !stretched || model.grip.horizontal == Hold::Free => {
            let found = Measured { value, unit: "nN" };
            Err(ModelError::new("grip.pretension", ModelErrorKind::NotStretched { found }))
        }
        _ => Ok(()),
    }
}

/// That what has an exponent has two works that it can mix, that what has a work in shear has a strength in shear, and that what holds along the ground
/// is a strip, or is in space, on flat ground, with the contact moment and without pretension.
fn shear_strength(model: &PeelModel) -> Result<(), ModelError> {
    if let (Some(value), None) = (model.adhesion.mixing_exponent, model.adhesion.shear_work) {
        let found = Measured { value, unit: "" };
        return Err(ModelError::new("adhesion.mixing_exponent", ModelErrorKind::NothingToMix { found }));
    }
    if model.adhesion.shear_strength.is_none() {
        let error = |value| {
            let found = Measured { value, unit: "J/m2" };
            Err(ModelError::new("adhesion.shear_work", ModelErrorKind::NotHeldInShear { found }))
        };
        return model.adhesion.shear_work.map_or(Ok(()), error);
    }
    let with = "a shear strength of the adhesion";
    let no_strip = model.strip().is_none() && model.space.is_none();
    none_beside("adhesion.shear_strength", with, &[(no_strip, "a body that is no strip, in the plane")])?;
    none_beside("adhesion.shear_strength", with, &beside_law_of_face(model))
}

/// That what does not heal is a strip on flat ground in the plane under a cohesive law, with the contact moment and without pretension.
fn healing(model: &PeelModel) -> Result<(), ModelError> {
    if model.adhesion.healing {
        return Ok(());
    }
    let is_cohesive = model.adhesion.attraction.is_cohesive();
    let with = "an adhesion that does not heal";
    let alone = [
        (!is_cohesive, "a law of adhesion that is not cohesive"),
        (model.space.is_some(), "`space`"),
        (model.strip().is_none(), "a body that is no strip"),
    ];
    none_beside("adhesion.healing", with, &alone)?;
    none_beside("adhesion.healing", with, &beside_law_of_face(model))
}

/// What is not computed with a face that is held along the ground, or does not heal.
fn beside_law_of_face(model: &PeelModel) -> [(bool, &'static str); 3] {
    [
        (!model.ground.substrate.is_flat(), "ground that is not flat"),
        (model.grip.pretension.is_some(), "`grip.pretension`"),
        (model.adhesion.line_load != LineLoad::Full, "a `line_load` that is not \"full\""),
    ]
}

/// That a key is given beside none of these.
fn none_beside(key: &'static str, with: &'static str, beside: &[(bool, &'static str)]) -> Result<(), ModelError> {
    let wrong = beside.iter().find(|(is_given, _)| *is_given);
    wrong.map_or(Ok(()), |&(_, what)| Err(ModelError::new(key, ModelErrorKind::Beside { what, with })))
}

/// That it has a strength, on flat ground, under the half space, and without a pretension.
fn friction(model: &PeelModel) -> Result<(), ModelError> {
    let friction = &model.friction;
    let Some(strength) = friction.strength else {
        let coefficient = Some(friction.coefficient).filter(|&coefficient| coefficient > 0.0);
        let given = [("friction.coefficient", coefficient, ""), ("friction.presliding", friction.presliding, "nm")];
        let first = given.into_iter().find_map(|(key, value, unit)| Some((key, Measured { value: value?, unit })));
        let error = |(key, found)| Err(ModelError::new(key, ModelErrorKind::NoShearStrength { found }));
        return first.map_or(Ok(()), error);
    };
    let found = Measured { value: strength, unit: "GPa" };
    if !model.ground.substrate.is_flat() {
        return Err(ModelError::new("friction.strength", ModelErrorKind::FrictionOffFlatGround { found }));
    }
    if !model.adhesion.attraction.takes_friction() {
        return Err(ModelError::new("friction.strength", ModelErrorKind::FrictionBesideLaw { found }));
    }
    match model.grip.pretension {
        Some(value) => {
            let found = Measured { value, unit: "nN" };
            Err(ModelError::new("grip.pretension", ModelErrorKind::PretensionUnderFriction { found }))
        }
        None => Ok(()),
    }
}

/// Most waves or radii, and most process zones, on which a beam lies on ground that is not flat.
const MOST_DETAILS: f64 = 100.0;
const MOST_ZONES_ON_GROUND: f64 = 3000.0;

/// On ground that is not flat: that the load has a potential, that elements resolve the ground, and that its own numbers fit.
fn ground(model: &PeelModel) -> Result<(), ModelError> {
    let substrate = &model.ground.substrate;
    if substrate.is_flat() {
        return Ok(());
    }
    if !model.line_law().has_potential() {
        let (key, load) = match model.adhesion.line_load {
            LineLoad::ForceOnly => ("adhesion.line_load", "force-only"),
            LineLoad::Full | LineLoad::AxisGap => ("adhesion.law", model.adhesion.attraction.name()),
        };
        return Err(ModelError::new(key, ModelErrorKind::NoPotentialOnGround { load }));
    }
    let contact_extent = model.contact_extent();
    let details = contact_extent / substrate.feature_length();
    if details > MOST_DETAILS {
        let kind = ModelErrorKind::TooManyDetails { found: details, most: MOST_DETAILS };
        return Err(ModelError::new("substrate.shape", kind));
    }
    let zones = contact_extent / model.process_length();
    if zones > MOST_ZONES_ON_GROUND {
        let kind = ModelErrorKind::TooManyZones { found: zones, most: MOST_ZONES_ON_GROUND };
        return Err(ModelError::new("substrate.shape", kind));
    }
    let misfit = substrate.misfit();
    misfit.map_or(Ok(()), |misfit| Err(ModelError::new(misfit.key, ModelErrorKind::Substrate(misfit))))
}

/// That of its body.
fn body(model: &PeelModel) -> Result<(), ModelError> {
    match &model.body {
        Body::Strip(strip) => strip_with_crack(strip, model)
            .and_then(|()| strip_of_layers(strip, model))
            .and_then(|()| strip_that_yields(strip, model)),
        Body::Spatula(spatula) => spatula_tip(spatula),
        Body::Profile(_) => Ok(()),
    }
}

/// That a crack leaves a part that adheres, and that the rest of the scene is computed beside one.
fn strip_with_crack(strip: &Strip, model: &PeelModel) -> Result<(), ModelError> {
    let Some(found) = strip.crack else { return Ok(()) };
    if found >= strip.length {
        let kind = ModelErrorKind::CrackOfWholeLength { found, length: strip.length };
        return Err(ModelError::new("strip.crack", kind));
    }
    let beside = [
        (model.space.is_some(), "a scene in space"),
        (model.friction.strength.is_some(), "friction"),
        (model.grip.pretension.is_some(), "a pretension"),
        (!model.ground.substrate.is_flat(), "ground that is not flat"),
    ];
    none_beside("strip.crack", "an initial crack", &beside)
}

/// That layers are peeled in the plane off a cohesive law, which looks at the face alone.
fn strip_of_layers(strip: &Strip, model: &PeelModel) -> Result<(), ModelError> {
    let Some(layers) = strip.layers else { return Ok(()) };
    if strip.of_layers(layers) != *strip {
        return Err(ModelError::new("strip.layers", ModelErrorKind::NotOfLayers));
    }
    let beside = [
        (model.space.is_some(), "a scene in space"),
        (!model.adhesion.attraction.is_cohesive(), "a law of adhesion that is not cohesive"),
    ];
    none_beside("strip.layers", "layers", &beside)
}

/// That what hardens yields, less stiffly than it is elastic, and that what yields is of one material, in the plane on flat ground under a cohesive law
/// with the contact moment, pulled from rest.
fn strip_that_yields(strip: &Strip, model: &PeelModel) -> Result<(), ModelError> {
    let Material { youngs_modulus, yield_strength, tangent_modulus, .. } = strip.material;
    if let Some(value) = tangent_modulus {
        let found = Measured { value, unit: "GPa" };
        let error = |kind| Err(ModelError::new("strip.tangent_modulus", kind));
        if yield_strength.is_none() {
            return error(ModelErrorKind::NothingToHarden { found });
        }
        if value >= youngs_modulus {
            return error(ModelErrorKind::NoSofter { found, youngs_modulus });
        }
    }
    if yield_strength.is_none() {
        return Ok(());
    }
    let (with, key) = ("a film that yields", "strip.yield_strength");
    let beside = [
        (!model.adhesion.attraction.is_cohesive(), "a law of adhesion that is not cohesive"),
        (model.space.is_some(), "a scene in space"),
        (strip.layers.is_some(), "layers"),
        (!strip.material.stretch.is_linear(), "a stretch that is not linear"),
        (!model.steps.is_empty(), "a step before the pull"),
    ];
    none_beside(key, with, &beside)?;
    none_beside(key, with, &beside_law_of_face(model))
}

/// That the tip is rounded within the pad and narrows, and that the bend ends on the shaft.
fn spatula_tip(spatula: &Spatula) -> Result<(), ModelError> {
    let (rounding, pad) = (spatula.tip_rounding_length, spatula.pad_length);
    if rounding > pad {
        let kind = ModelErrorKind::RoundingBeyondPad { found: rounding, pad };
        return Err(ModelError::new("spatula.tip_rounding_length", kind));
    }
    let (width, tip) = (spatula.tip_rounding_width, spatula.tip_width);
    if rounding > 0.0 && width > tip {
        let kind = ModelErrorKind::RoundingWiderThanTip { found: width, tip };
        return Err(ModelError::new("spatula.tip_rounding_width", kind));
    }
    let (bend, behind) = (spatula.bend_length, spatula.neck_length + spatula.shaft_length);
    if bend > behind {
        let kind = ModelErrorKind::BendBeyondShaft { found: bend, behind };
        return Err(ModelError::new("spatula.bend_length", kind));
    }
    Ok(())
}

/// That it is on flat ground without friction, under a law that has an energy there; that only a strip has a section of a shape.
fn space(model: &PeelModel) -> Result<(), ModelError> {
    let Some(space) = &model.space else { return Ok(()) };
    let not = |wrong: bool, key: &'static str, why: &'static str| match wrong {
        true => Err(ModelError::new(key, ModelErrorKind::NotInSpace { why })),
        false => Ok(()),
    };
    let shaped = space.section != SectionShape::Rectangle && model.strip().is_none();
    not(shaped, "strip.section", "it is the section of a strip")?;
    not(!model.ground.substrate.is_flat(), "substrate.shape", "the substrate is flat")?;
    not(model.friction.strength.is_some(), "friction.strength", "there is no friction")?;
    not(model.grip.pretension.is_some(), "grip.pretension", "the strip adheres without pretension")?;
    not(!model.material().stretch.is_linear(), "strip.stretch", "the stretch is linear")?;
    let of_law = |error| ModelError::new("adhesion.law", ModelErrorKind::LawInSpace(error));
    model.spatial_section(space).map(drop).map_err(of_law)
}
