//! A seta: what the keys of its tips take, how its root is moved, and what of it cannot be computed.

use crate::error::{Origin, SceneError, ValueError};
use crate::key::kind::Setting;
use crate::scene::Scene;
use crate::scene::seta::{SetaTable, SetaTipLaw, TIP_LAWS};
use crate::value::form::Form;
use crate::value::{Fault, Value, quoted};
use peelkit::model::{ModelError, ModelErrorKind, Moved, SetaError, Step};
use peelkit::solve::Direction;
use peelkit::study::{SetaLoading, SetaStep, StepEnd};
use std::ops::Range;

/// The table of a scene.
pub(crate) const TABLE: &str = "seta";

/// That a scene is one of a seta, where a single beam is peeled.
pub(crate) fn refused(file: &Origin, header: Range<usize>) -> SceneError {
    let problem = ValueError::new(
        "is a table of a scene that `peel run`, `sweep`, `coarsen`, `fit`, `optimise` and `uncertainty` alone compute; here a single beam is peeled",
        "Give the scene to one of them, or remove [seta] to peel one of its tips.",
    );
    file.error(header, &format!("[{TABLE}]"), problem)
}

impl Scene {
    /// What is done to the root of the seta: the preload, the steps of `drive`, and the pull at its angle and azimuth until no tip adheres or,
    /// at the latest, until the root has moved as far as the seta is high.
    pub fn seta_loading(&self, table: &SetaTable) -> SetaLoading {
        let preload = table.preload.map(|force| SetaStep { direction: DOWN, until: StepEnd::Preload(force) });
        let before = self.model.steps.iter().filter_map(|&step| moved(step));
        let travel = |(direction, length)| SetaStep { direction, until: StepEnd::Travel(length) };
        let pull = SetaStep { direction: self.root_direction(), until: StepEnd::Detached(table.height()) };
        let steps = preload.into_iter().chain(before.map(travel)).chain([pull]).collect();
        SetaLoading { start: table.start(), steps }
    }

    /// Along which the root of a seta is pulled: `angle` and `azimuth` of `drive`.
    pub(crate) fn root_direction(&self) -> [f64; 3] {
        let azimuth = self.model.space.unwrap_or_default().azimuth;
        let Direction { along, up } = self.model.pull.direction();
        [along * azimuth.cos(), up, along * azimuth.sin()]
    }
}

/// Towards the ground.
const DOWN: [f64; 3] = [0.0, -1.0, 0.0];

/// Where a step of the root goes, and how far, nm; nothing of one that moves nothing.
fn moved(step: Step) -> Option<([f64; 3], f64)> {
    let (what, amount) = step.motion()?;
    let sign = amount.signum();
    match what {
        Moved::Place => Some(([sign, 0.0, 0.0], amount.abs())),
        Moved::Height => Some(([0.0, sign, 0.0], amount.abs())),
        Moved::Side => Some(([0.0, 0.0, sign], amount.abs())),
        Moved::Rotation | Moved::Roll | Moved::Yaw => None,
    }
}

/// Whether a step is one of the root of a seta, whose rotation is held and whose place is prescribed.
fn moves_the_root(step: Step) -> bool {
    match step {
        Step::Press(_) | Step::Lift(_) | Step::Drag(_) | Step::Push(_) | Step::Shift(_) | Step::Hold => true,
        Step::Turn(_) | Step::Roll(_) | Step::Yaw(_) | Step::Release => false,
    }
}

/// What of the seta of a scene is wrong: by the key of the scene.
pub(crate) fn problem(scene: &Scene) -> Option<(String, ValueError)> {
    let table = scene.seta.as_ref()?;
    let seta = &table.seta;
    if let Err(error) = seta.check() {
        let key = match &error {
            SetaError::OutOfRange { key, .. } | SetaError::Levels { key, .. } => key,
            SetaError::Tips { .. } => "branches",
            SetaError::Scatter { .. } => "height_scatter",
            _ => "forks",
        };
        let remedy = "The keys of [seta] with their ranges are listed by `peel keys seta`.";
        return Some((format!("{TABLE}.{key}"), ValueError::new(format!("cannot be computed: {error}"), remedy)));
    }
    if let (Some(_), SetaTipLaw::Beam, Some(_)) = (table.preload, table.tip_law, scene.model.adhesion.shear_strength) {
        let problem = ValueError::new(
            "is given, and spatulae that are held along the ground adhere where they lie at the start",
            "Remove `preload`, or remove `shear_strength` under [adhesion]: the spatulae slide then.",
        );
        return Some((format!("{TABLE}.preload"), problem));
    }
    if let Some((key, problem)) = problem_of_tips(table) {
        return Some((format!("{TABLE}.{key}"), problem));
    }
    let of_step = |(index, &step): (usize, &Step)| match step.check() {
        Err(wrong) => {
            let kind = ModelErrorKind::Step { number: index + 1, step, wrong };
            Some(ValueError::from(ModelError::new("drive.steps", kind)))
        }
        Ok(()) if moves_the_root(step) => None,
        Ok(()) => Some(ValueError::new(
            format!("has the step \"{step}\", and the root of a seta does not rotate and is never released"),
            "The steps of a seta are press, lift, drag, push, shift and hold.",
        )),
    };
    scene.model.steps.iter().enumerate().find_map(of_step).map(|problem| ("drive.steps".to_owned(), problem))
}

fn text(value: &Value) -> Result<&str, Fault> {
    match value {
        Value::Text(text) => Ok(text),
        other => Err(Fault::whole(format!("is {other}, and takes a text in quotes"))),
    }
}

/// `tip_law`
pub(crate) static TIP_LAW: Setting = Setting {
    takes: "\"curve\", the normal pull of their spatula; \"table\", its force and moment at any height and rotation; or \"beam\", spatulae that are beams",
    brief: "curve, table, beam",
    example: "\"table\"",
    form: || Form::word(&TIP_LAWS),
    read: |scene, value, _| {
        let word = text(value)?;
        let found = TIP_LAWS.iter().find(|(name, _)| *name == word);
        scene.seta_table().tip_law =
            found.ok_or_else(|| Fault::whole(format!("is {}, no law of tips", quoted(word))))?.1;
        Ok(())
    },
    write: |scene, _| Some(Value::Text(scene.seta.as_ref()?.tip_law.name().to_owned())),
};

/// `tip_table`
pub(crate) static TIP_TABLE: Setting = Setting {
    takes: "the name of a folder in quotes that `peel coarsen` has written, beside the scene; without it the run computes the table",
    brief: "a folder",
    example: "\"out/spatula-tip\"",
    form: || Form::Text,
    read: |scene, value, _| {
        let folder = text(value)?;
        if folder.trim().is_empty() {
            return Err(Fault::whole("is empty, and takes the name of a folder".to_owned()));
        }
        scene.seta_table().tip_table = Some(folder.to_owned());
        Ok(())
    },
    write: |scene, _| Some(Value::Text(scene.seta.as_ref()?.tip_table.clone()?)),
};

/// What of the keys of the tips does not fit the rest: by the key of the table.
fn problem_of_tips(table: &SetaTable) -> Option<(&'static str, ValueError)> {
    let (default, law) = (SetaTable::default(), table.tip_law);
    let (by_table, of_beams) = (law == SetaTipLaw::Table, law == SetaTipLaw::Beam);
    let instead = if of_beams { "the spatulae are beams" } else { "the tips follow the curve of their normal pull" };
    let of_a_table = [
        (table.tip_table.is_some(), "tip_table", "names a table"),
        (table.tip_tolerance != default.tip_tolerance, "tip_tolerance", "is that of a table"),
        (table.resolve_within.is_some(), "resolve_within", "says which tips are no longer taken from a table"),
    ];
    if let Some((_, key, what)) = of_a_table.into_iter().find(|(is_given, ..)| *is_given && !by_table) {
        let remedy = format!("Give seta.tip_law = \"table\", or remove `{key}`.");
        return Some((key, ValueError::new(format!("{what}, and {instead}"), remedy)));
    }
    let contact = table.contact_height != default.contact_height;
    let not_covered = [
        (
            contact && by_table,
            "contact_height",
            "is given, and tips that follow their table adhere again where the attraction pulls them down",
        ),
        (
            contact && of_beams,
            "contact_height",
            "is given, and spatulae that are beams adhere again where the attraction pulls them down",
        ),
        (
            of_beams && table.lateral_stiffness.is_some(),
            "lateral_stiffness",
            "is given, and spatulae that are beams slide freely",
        ),
    ];
    let (_, key, what) = not_covered.into_iter().find(|(is_given, ..)| *is_given)?;
    Some((key, ValueError::new(what, format!("Remove `{key}`, or give seta.tip_law = \"curve\"."))))
}
