//! Whether the values of a scene fit one another.

use super::error::Problem;
use super::key::Key;
use super::keys::KEYS;
use super::scene::Scene;
use super::{friction, shape, steps};
use peelkit::model::{Attraction, Body, Hold};

impl Scene {
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
                        "belongs to a cohesive law, and the law of this scene is not cohesive".into(),
                        &format!(
                            "Give `law` = {} beside it, or remove it: hamaker_constant and equilibrium_distance define the \
                             half space.",
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
                "stretches a strip on a flat substrate whose grip is constrained normal to the pull direction, and this scene has none".into(),
                "Peel a [strip] with `horizontal = \"fixed\"` under [grip], on a flat substrate, or remove `pretension`.",
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
                        "is {} degrees, along the strip, which is then only stretched or compressed",
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
                "Round the pad at most: `tip_rounding_length` not above `pad_length`.",
            );
        }
        let (width, tip) = (spatula.tip_rounding_width, spatula.tip_width);
        if rounding > 0.0 && width > tip {
            return problem(
                "spatula.tip_rounding_width",
                format!("is {width} nm, more than the tip is wide ({tip} nm)"),
                "A rounded tip is narrower at its end: `tip_rounding_width` not above `tip_width`.",
            );
        }
        let (bend, behind) = (spatula.bend_length, spatula.neck_length + spatula.shaft_length);
        if bend > behind {
            return problem(
                "spatula.bend_length",
                format!("is {bend} nm, more than neck and shaft are long ({behind} nm)"),
                "Let the bend end on the shaft: `bend_length` not above `neck_length` plus `shaft_length`.",
            );
        }
        Ok(())
    }
}
