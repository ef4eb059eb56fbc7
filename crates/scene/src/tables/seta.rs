//! A seta: its table, which keys a scene with one has, and what it says of the tips.

use super::tips;
use super::tips::SetaTipLaw;
use crate::bodies::set_body;
use crate::error::{Origin, SceneError, ValueError};
use crate::key::Key;
use crate::scene::Scene;
use peelkit::model::{
    Grip, Hold, ModelError, ModelErrorKind, Moved, NormalPull, PeelModel, PullCurve, Seta, SetaError, Sideways, Space,
    Step, TipLaw,
};
use peelkit::solve::Direction;
use peelkit::study::{SetaLoading, SetaStart, SetaStep, StepEnd};
use std::ops::Range;
use std::sync::Arc;

/// The table of a scene.
pub(crate) const TABLE: &str = "seta";

/// The other tables and keys of a scene with a seta. The tables of a body and of adhesion describe its tips.
const OTHERS: [(&str, &[&str]); 12] = [
    ("", &["title"]),
    ("strip", &[]),
    ("spatula", &[]),
    ("profile", &[]),
    ("adhesion", &[]),
    ("drive", &["angle", "azimuth", "steps"]),
    ("accuracy", &["relative", "order"]),
    ("bounds", &[]),
    ("fit", &[]),
    ("optimise", &[]),
    ("uncertainty", &[]),
    (
        "time",
        &[
            "rate",
            "density",
            "material",
            "retardation_time",
            "relaxation_time",
            "stiffness_ratio",
            "displacement",
            "acceleration",
            "tolerance",
        ],
    ),
];

/// The error that a table of tips may have where the scene does not say it.
const TIP_TOLERANCE: f64 = 1e-3;

/// A seta as a scene gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct SetaTable {
    /// Geometry and material
    pub seta: Seta,
    /// Of what holds a tip along the ground to the place where it began to adhere, nN/nm; none: tips slide freely
    pub lateral_stiffness: Option<f64>,
    /// Height above its place at rest at which a detached tip adheres again, nm
    pub contact_height: f64,
    /// Force with which the seta is pressed on before all steps, nN; none: every tip adheres at the start
    pub preload: Option<f64>,
    /// What its tips follow
    pub tip_law: SetaTipLaw,
    /// Folder of `peel coarsen` with their table, as the scene names it; none: the table is computed
    pub tip_table: Option<String>,
    /// Error that the table may have, over the largest force and the largest moment
    pub tip_tolerance: f64,
    /// How near to where they snap off tips are solved as spatulae, nm; none: they follow the table there as well
    pub resolve_within: Option<f64>,
}

/// How high a seta that is pressed on starts above the height at which its highest tip would adhere, nm.
const CLEARANCE: f64 = 1.0;
/// The same of tips that follow their table, whose attraction says itself where they adhere.
const OUT_OF_REACH: f64 = 100.0;

impl Default for SetaTable {
    /// The default seta; its angle is that of the text "60 deg", to the last bit.
    fn default() -> Self {
        let seta = Seta { shaft_angle: 60.0 * 1f64.to_radians(), ..Seta::default() };
        Self {
            seta,
            lateral_stiffness: None,
            contact_height: 0.0,
            preload: None,
            tip_law: SetaTipLaw::default(),
            tip_table: None,
            tip_tolerance: TIP_TOLERANCE,
            resolve_within: None,
        }
    }
}

impl SetaTable {
    /// The law of its tips, of which each follows this curve.
    pub fn law(&self, curve: PullCurve) -> Arc<dyn TipLaw> {
        Arc::new(NormalPull { curve, sideways: self.sideways(), contact_height: self.contact_height })
    }

    /// What holds its tips along the ground.
    pub fn sideways(&self) -> Sideways {
        self.lateral_stiffness.map_or(Sideways::Free, Sideways::Held)
    }

    /// From its tips to its root, upright, nm: how far the root is moved at most.
    pub(crate) fn height(&self) -> f64 {
        self.seta.shaft_length + self.seta.brush_height
    }

    /// How it starts: adhering, or above the ground where it is pressed on first.
    fn start(&self) -> SetaStart {
        let clearance = match self.tip_law {
            SetaTipLaw::Curve => CLEARANCE,
            SetaTipLaw::Table => OUT_OF_REACH,
        };
        match self.preload {
            None => SetaStart::Adhering,
            Some(_) => SetaStart::Above(2.0 * self.seta.height_scatter + self.contact_height + clearance),
        }
    }
}

/// That a scene is one of a seta, where a single beam is peeled.
pub(crate) fn refused(file: &Origin, header: Range<usize>) -> SceneError {
    let problem = ValueError::new(
        "is a table of a scene that `peel run`, `sweep`, `fit`, `optimise` and `uncertainty` alone compute; here a single beam is peeled",
        "Give the scene to one of them, or remove [seta] to peel one of its tips.",
    );
    file.error(header, &format!("[{TABLE}]"), problem)
}

/// The seta of a scene, which becomes one with a seta.
pub(crate) fn of(scene: &mut Scene) -> &mut SetaTable {
    scene.seta.get_or_insert_default()
}

/// Makes the scene one with a seta, whose root is moved in space; its tips are spatulae where it names no body.
pub(crate) fn begin(scene: &mut Scene, without_body: bool) {
    of(scene);
    scene.model.space = Some(Space::default());
    if without_body {
        set_body(scene, "spatula");
    }
}

/// Whether a scene with a seta has this key.
pub(crate) fn has(table: &str, name: &str) -> bool {
    table == TABLE || OTHERS.iter().any(|(of, names)| *of == table && (names.is_empty() || names.contains(&name)))
}

/// That a scene without one has no such key, or that a scene with one has not.
pub(crate) fn foreign(scene: &Scene, key: &Key) -> ValueError {
    match &scene.seta {
        None => ValueError::new(
            "is a key of [seta], a table that the scene does not have",
            "Add the table [seta] to the scene; scenes/seta.toml is one with a seta.",
        ),
        Some(_) => ValueError::new(
            "is given, and the scene has a [seta], which has no such key",
            format!(
                "Remove `{}`: beside [seta] stand the table of its tips, [adhesion], `angle`, `azimuth` and `steps` of [drive], `relative` and `order` of [accuracy], [bounds], [fit], [optimise], [uncertainty], and [time] without `held`.",
                key.name
            ),
        ),
    }
}

impl Scene {
    /// The body at a tip of a seta with its adhesion, its end held against rotation, on flat ground without friction: what the law of the
    /// tips is computed of.
    pub fn tip_model(&self) -> PeelModel {
        let grip = Grip { rotation: Hold::Fixed, ..Grip::FREE };
        PeelModel::of(self.model.body.clone(), self.model.adhesion, grip)
    }
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
            SetaError::OutOfRange { key, .. } => key,
            SetaError::Scatter { .. } => "height_scatter",
            _ => "forks",
        };
        let remedy = "The keys of [seta] with their ranges are listed by `peel keys seta`.";
        return Some((format!("{TABLE}.{key}"), ValueError::new(format!("cannot be computed: {error}"), remedy)));
    }
    if let Some((key, problem)) = tips::problem(table) {
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
