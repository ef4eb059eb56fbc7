//! A pull at a rate: the table `time`, and what it says of the material, the grip and the steps in time.

use crate::error::{Origin, SceneError, ValueError};
use crate::key::kind::Setting;
use crate::scene::Scene;
use crate::scene::rate::{FLOWS, NS_PER_S, TimeTable};
use crate::scene::seta::{SetaTable, SetaTipLaw};
use crate::value::form::Form;
use crate::value::{Fault, Value, quoted};
use peelkit::study::{FollowedUntil, PullRate, SetaPullRate, SetaTimeAccuracy, Terms, TimeAccuracy, Until};
use std::ops::Range;

/// The table of a scene.
pub(crate) const TABLE: &str = "time";

/// `material`
pub(crate) static MATERIAL: Setting = Setting {
    takes: "\"elastic\", \"kelvin-voigt\" or \"standard-linear-solid\"",
    brief: "one of three words",
    example: "\"elastic\"",
    form: || Form::word(&FLOWS),
    read: |scene, value, _| {
        let Value::Text(text) = value else { return Err(Fault::whole(format!("is {value}, no word"))) };
        let found = FLOWS.iter().find(|(word, _)| word == text);
        let none = || Fault::whole(format!("is {}, which is none of its values", quoted(text)));
        scene.time_table().material = found.ok_or_else(none)?.1;
        Ok(())
    },
    write: |scene, _| Some(Value::Text(scene.time.as_ref()?.material.word().to_owned())),
};

/// That a scene is pulled at a rate, where equilibria are followed.
pub(crate) fn refused(file: &Origin, header: Range<usize>) -> SceneError {
    let problem = ValueError::new(
        "is a table of a scene that `peel run`, `sweep`, `fit`, `optimise` and `uncertainty` alone follow in time; here equilibria are followed",
        "Give the scene to one of them, or remove [time] to follow the equilibria.",
    );
    file.error(header, &format!("[{TABLE}]"), problem)
}

impl Scene {
    /// How the grip is pulled at the rate of a table.
    pub fn pull_rate(&self, table: &TimeTable) -> PullRate {
        let until = table.held.map_or(Until::ContactLost, |time| Until::Held(NS_PER_S * time));
        let to = table.displacement.unwrap_or(self.model.length());
        PullRate { accelerates: table.acceleration, until, ..PullRate::new(to, table.rate) }
    }

    /// How accurately that is followed: with the elements and their order, and the largest number of points, that the scene names.
    pub fn time_accuracy(&self, table: &TimeTable) -> TimeAccuracy {
        let (choice, usual) = (&self.accuracy.choice, TimeAccuracy::default());
        TimeAccuracy {
            elements: choice.elements,
            order: choice.order.unwrap_or(usual.order),
            tolerance: table.tolerance,
            most_steps: self.bounds.points,
            ..usual
        }
    }
}

impl Scene {
    /// How the root of a seta is pulled at the rate of a table: along the angle and azimuth of `drive`.
    pub fn seta_pull_rate(&self, table: &TimeTable, seta: &SetaTable) -> SetaPullRate {
        let most = table.displacement.unwrap_or(seta.height());
        let usual = SetaPullRate::normal(most, table.rate);
        let accelerates = table.acceleration.unwrap_or(usual.accelerates);
        SetaPullRate { direction: self.root_direction(), accelerates, ..usual }
    }

    /// How accurately that is followed.
    pub fn seta_time_accuracy(&self, table: &TimeTable) -> SetaTimeAccuracy {
        let usual = SetaTimeAccuracy::default();
        SetaTimeAccuracy { tolerance: table.tolerance, most_steps: self.bounds.points, ..usual }
    }
}

/// What of a pull at a rate is wrong: by the key of the scene.
pub(crate) fn problem(scene: &Scene) -> Option<(String, ValueError)> {
    let table = scene.time.as_ref()?;
    let own = table.material.word();
    for (key, value, flow) in table.of_materials() {
        match (value, flow == table.material) {
            (Some(_), false) => {
                let problem = ValueError::new(
                    format!("is given, and the material of the pull at a rate is \"{own}\""),
                    format!("Remove `{key}`, or write material = \"{}\" in [time].", flow.word()),
                );
                return Some((format!("{TABLE}.{key}"), problem));
            }
            (None, true) => {
                let example = if key == "stiffness_ratio" { "2.0" } else { "\"1 us\"" };
                let problem = ValueError::new(
                    format!("is \"{own}\", a material with a `{key}`, which is not given"),
                    format!("Add for example {key} = {example} to [time]."),
                );
                return Some((format!("{TABLE}.material"), problem));
            }
            _ => {}
        }
    }
    if let Some(problem) = not_of_adhesive(scene, table) {
        return Some(problem);
    }
    match &scene.seta {
        None => not_covered(scene),
        Some(seta) => not_covered_of_seta(scene, table, seta),
    }
}

/// What of an adhesive that resists its opening does not fit.
fn not_of_adhesive(scene: &Scene, table: &TimeTable) -> Option<(String, ValueError)> {
    let (key, problem) = match (table.opening_rate, table.rate_exponent) {
        (None, None) => return None,
        (None, Some(_)) => {
            let found = "is given, and the adhesive has no `opening_rate`";
            ("rate_exponent", ValueError::new(found, "Give opening_rate = \"1 mm/s\" beside it, or remove it."))
        }
        (Some(_), _) if scene.seta.is_some() || !scene.model.adhesion.attraction.is_cohesive() => {
            let found = "is given, and what adheres is no beam under a cohesive law";
            let remedy = "Give law = \"exponential\", work and strength in [adhesion], or remove it.";
            ("opening_rate", ValueError::new(found, remedy))
        }
        (Some(_), _) => return None,
    };
    Some((format!("{TABLE}.{key}"), problem))
}

/// What of the pull of a beam is not followed in time.
fn not_covered(scene: &Scene) -> Option<(String, ValueError)> {
    let model = &scene.model;
    let not_covered = [
        (model.space.is_some(), "is in space"),
        (!model.ground.substrate.is_flat(), "has ground that is not flat"),
        (model.friction_law().is_some(), "has friction"),
        (!model.adhesion.healing, "has an adhesion that does not heal"),
        (!model.steps.is_empty(), "has steps before the pull"),
        (model.pull.turn != 0.0, "turns its grip by `drive.turn`"),
        (model.grip.pretension.is_some(), "has a `grip.pretension`"),
        (scene.accuracy.terms == Terms::Auto, "has terms = \"auto\""),
        (scene.bounds.until != FollowedUntil::End, "has a `path.until`"),
    ];
    let (_, what) = not_covered.into_iter().find(|(is_there, _)| *is_there)?;
    let problem = ValueError::new(
        format!("is given, and the scene {what}, which is not followed in time"),
        "Remove [time] to follow the equilibria, or give a beam in the plane on flat ground with all terms, without friction, steps, pretension, `path.until` and a grip that turns.",
    );
    Some((format!("{TABLE}.rate"), problem))
}

/// What of the pull of a seta is not followed in time.
fn not_covered_of_seta(scene: &Scene, table: &TimeTable, seta: &SetaTable) -> Option<(String, ValueError)> {
    let not_covered = [
        (table.density > 0.0, "density", "is above zero, and the mass of a seta"),
        (seta.preload.is_some(), "rate", "is given, and the `seta.preload` of the scene"),
        (!scene.model.steps.is_empty(), "rate", "is given, and what the `drive.steps` of the scene do"),
        (seta.tip_law == SetaTipLaw::Table, "rate", "is given, and a seta whose tips follow a table"),
        (seta.tip_law == SetaTipLaw::Beam, "rate", "is given, and a seta whose spatulae are beams"),
    ];
    let (_, key, what) = not_covered.into_iter().find(|(is_there, ..)| *is_there)?;
    let problem = ValueError::new(
        format!("{what} is not followed in time"),
        "Remove [time] to follow the equilibria, or give density = \"0 kg/m3\" and a seta whose tips adhere at the start and follow their curve, without preload and steps.",
    );
    Some((format!("{TABLE}.{key}"), problem))
}
