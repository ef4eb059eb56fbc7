//! What pull-offs of setae have in common, and setae that differ from the one of a scene in some keys, pulled off one after the other, or side by side.

use crate::outcome::Refusal;
use peelkit::model::{PeelModel, PullCurve, Seta, SetaError, SetaMesh, SetaModel, SetaOfBeams, TipLaw};
use peelkit::solve::{Pace, PathOptions};
use peelkit::study::coarsening::{
    AfterRound, Coarsening, CoarseningError, CoarseningOptions, GrowingTable, PadEnd, TipRange, TipTable,
    pull_off_by_table,
};
use peelkit::study::{
    self, Accuracy, BeamsPullOff, Choice, ConvergedPeak, SetaOptions, SetaPullOff, SetaResult, SpatulaCurveError,
    StopCriteria,
};
use peelkit_scene::{Scene, SetaTable, SetaTipLaw};
use std::sync::{Arc, OnceLock};

/// By how much the curve of a tip begins with it pressed, nm.
const PRESSED: f64 = 50.0;
/// By how much the first table of a tip begins with it pressed, nm.
const WIDE: f64 = 100.0;
/// The range of its rotation, rad.
const TURNED: [f64; 2] = [-0.4, 0.65];

/// The curve that the tips of a scene follow. A mesh that the scene names is that of the branches, not of the tip.
pub fn tip_curve(scene: &Scene) -> Result<PullCurve, SpatulaCurveError> {
    study::tip_curve(&scene.tip_model(), &Accuracy { choice: Choice::default(), ..scene.accuracy }, PRESSED)
}

/// What the tips of a scene follow.
pub enum TipLawOf {
    /// The curve of their normal pull
    Curve,
    /// A table, which grows
    Table(Box<GrowingTable>),
    /// None: their spatulae are beams
    Beam,
}

/// Why there is no table of the tips.
pub enum NoTable {
    /// There can be none, and what to do.
    Refused { found: String, remedy: &'static str },
    /// It takes longer than the run may last.
    Stopped(String),
}

impl From<CoarseningError> for NoTable {
    fn from(why: CoarseningError) -> Self {
        let found = format!("the table of the tips of the seta: {why}");
        match why {
            CoarseningError::Stopped { .. } => Self::Stopped(found),
            other => Self::Refused { found, remedy: other.remedy() },
        }
    }
}

impl From<NoTable> for Refusal {
    fn from(why: NoTable) -> Self {
        match why {
            NoTable::Refused { found, remedy } => Self::asked(found, remedy),
            NoTable::Stopped(found) => Self::CutShort(found),
        }
    }
}

/// How the first table of the tips is made: as wide as the tips of the default seta ask for, pulled along the normal.
fn table_options(table: &SetaTable) -> CoarseningOptions {
    let range = TipRange { press: WIDE, rotation: TURNED, ..TipRange::SLIDING };
    CoarseningOptions { range, tolerance: table.tip_tolerance, ..CoarseningOptions::of(PadEnd::Sliding) }
}

/// The first table of the tips of a scene: read from the folder that the scene names, beside it, or computed. What is wrong where there is none.
fn first_table(scene: &Scene, table: &SetaTable, stop: &StopCriteria) -> Result<Arc<TipTable>, NoTable> {
    let Some(folder) = &table.tip_table else {
        let made = Coarsening::until(&scene.tip_model(), &table_options(table), stop);
        return Ok(Arc::new(made.and_then(|mut made| made.table())?));
    };
    let folder = scene.beside(folder);
    let read = peelkit_report::read_tip_law_of(&folder, scene, table.tip_tolerance);
    let remedy = "`peel coarsen` of a scene with the body and the adhesion of the tips writes it; without seta.tip_table the run computes it.";
    let mut read = read.map_err(|error| NoTable::Refused { found: error.to_string(), remedy })?;
    // what is added to it is as accurate as is asked
    read.options.tolerance = table.tip_tolerance;
    Ok(Arc::new(read))
}

/// The table of the tips of a scene, which grows, and whose tips are resolved as the scene says.
fn growing(
    scene: &Scene,
    table: &SetaTable,
    first: Arc<TipTable>,
    stop: &StopCriteria,
) -> Result<GrowingTable, CoarseningError> {
    let growing = GrowingTable::of(&scene.tip_model(), first).growing_until(stop);
    match table.resolve_within {
        Some(within) => growing.resolved(within),
        None => Ok(growing),
    }
}

impl TipLawOf {
    /// Of a scene, computed as long as the criteria let it.
    pub fn new(scene: &Scene, table: &SetaTable, stop: &StopCriteria) -> Result<Self, NoTable> {
        Ok(match table.tip_law {
            SetaTipLaw::Curve => Self::Curve,
            SetaTipLaw::Beam => Self::Beam,
            SetaTipLaw::Table => Self::Table(Box::new(growing(scene, table, first_table(scene, table, stop)?, stop)?)),
        })
    }

    /// What tells a table from another one, if there is one.
    pub fn fingerprint(&self) -> Option<u32> {
        let table = self.growing()?.table();
        let mut hasher = crc32fast::Hasher::new();
        for node in [&table.attached, &table.detached].into_iter().flat_map(|sheet| &sheet.table().nodes) {
            for number in [node.normal, node.slope, node.energy, node.force[0], node.force[2]] {
                hasher.update(&number.to_bits().to_le_bytes());
            }
        }
        Some(hasher.finalize())
    }

    /// The table as it is now, if there is one.
    pub fn growing(&self) -> Option<&GrowingTable> {
        match self {
            Self::Curve | Self::Beam => None,
            Self::Table(growing) => Some(growing),
        }
    }
}

/// The seta of a scene, whose tips follow this law.
pub fn model(scene: &Scene, table: &SetaTable, law: Arc<dyn TipLaw>) -> SetaModel {
    let mut model = SetaModel::new(table.seta.clone(), law);
    model.mesh.order = scene.accuracy.choice.order.unwrap_or(model.mesh.order);
    model
}

/// Order of the elements of a seta of beams, and how many a spatula has, where the scene does not say it.
const BEAM_ORDER: usize = 5;
const BEAM_ELEMENTS: usize = 32;
/// First step of the root of a seta of beams, nm.
const FIRST_STEP: f64 = 0.1;

/// The seta of a scene whose spatulae are beams, or why there is none.
pub fn of_beams(scene: &Scene, table: &SetaTable) -> Result<SetaOfBeams, String> {
    let spatula = scene.tip_in_space().branch().map_err(|error| format!("a tip cannot be a beam in space: {error}"))?;
    let Choice { order, elements, .. } = scene.accuracy.choice;
    let mesh = SetaMesh { order: order.unwrap_or(BEAM_ORDER), ..SetaMesh::usual(table.seta.levels()) };
    Ok(SetaOfBeams { seta: table.seta.clone(), mesh, spatula, elements: elements.unwrap_or(BEAM_ELEMENTS) })
}

/// How the path of a seta of beams is stepped.
pub fn path_options(scene: &Scene) -> PathOptions {
    let usual = PathOptions { pace: Pace::Wary, first_displacement: FIRST_STEP, ..PathOptions::default() };
    PathOptions { step_tolerance: scene.accuracy.choice.step.unwrap_or(usual.step_tolerance), ..usual }
}

/// A seta that was pulled off.
pub enum PulledSeta {
    /// Its tips follow a law.
    ByLaw(SetaModel, SetaPullOff),
    /// Its spatulae are beams.
    OfBeams(SetaOfBeams, BeamsPullOff),
}

impl PulledSeta {
    /// Its pull-off.
    pub fn pull_off(&self) -> &SetaPullOff {
        match self {
            Self::ByLaw(_, found) => found,
            Self::OfBeams(_, found) => &found.result,
        }
    }

    /// Of it its pull-off alone.
    pub fn into_pull_off(self) -> SetaPullOff {
        match self {
            Self::ByLaw(_, found) => found,
            Self::OfBeams(_, found) => found.result,
        }
    }

    /// The seta.
    pub fn seta(&self) -> &Seta {
        match self {
            Self::ByLaw(model, _) => &model.seta,
            Self::OfBeams(model, _) => &model.seta,
        }
    }

    /// Order of its elements.
    pub fn order(&self) -> usize {
        match self {
            Self::ByLaw(model, _) => model.mesh.order,
            Self::OfBeams(model, _) => model.mesh.order,
        }
    }

    /// Its peak on finer meshes.
    pub fn peak(
        &self,
        scene: &Scene,
        table: &SetaTable,
        stop: &StopCriteria,
    ) -> Result<Option<ConvergedPeak>, SetaError> {
        let (loading, wanted) = (scene.seta_loading(table), scene.accuracy.relative);
        match self {
            Self::ByLaw(model, found) => study::converged_peak(model, &loading, &options(scene), found, wanted, stop),
            Self::OfBeams(model, found) => {
                study::peak_of_beams_on_finer_mesh(model, &loading, &path_options(scene), found, stop)
            }
        }
    }
}

/// How the pull-off of a scene is computed.
pub fn options(scene: &Scene) -> SetaOptions {
    SetaOptions { balance: scene.accuracy.relative, ..SetaOptions::default() }
}

/// What their pull-offs have in common: the law of the tips, which is computed once where the key of the tips does not vary.
pub struct Setae {
    tip: PeelModel,
    accuracy: Accuracy,
    curve: OnceLock<Result<PullCurve, String>>,
    table: OnceLock<Result<Arc<TipTable>, String>>,
    /// What its table is made of
    of: Option<SetaTable>,
}

impl Setae {
    /// Those like the one of this scene.
    pub fn like(scene: &Scene) -> Self {
        Self {
            tip: scene.tip_model(),
            accuracy: scene.accuracy,
            curve: OnceLock::new(),
            table: OnceLock::new(),
            of: scene.seta.clone(),
        }
    }

    /// Computes the law of the tips, so that it is there; a fault of it is reported where it is asked for.
    pub fn prepare(&self, scene: &Scene, stop: &StopCriteria) {
        let Some(table) = &scene.seta else { return };
        let _ = match table.tip_law {
            SetaTipLaw::Curve => self.curve(scene).map(drop),
            SetaTipLaw::Table => self.table(scene, table, stop).map(drop),
            SetaTipLaw::Beam => Ok(()),
        };
    }

    /// The numbers of the pull-off of the seta of a scene, or why there is none. Called from any thread.
    pub fn pull_off(&self, scene: &Scene, table: &SetaTable, stop: &StopCriteria) -> Result<SetaResult, String> {
        self.pulled_off(scene, table, stop).map(|(_, found)| found)
    }

    /// The pull-off of the seta of a scene with its numbers, likewise.
    pub fn pulled_off(
        &self,
        scene: &Scene,
        table: &SetaTable,
        stop: &StopCriteria,
    ) -> Result<(SetaPullOff, SetaResult), String> {
        let pulled = self.followed(scene, table, stop)?;
        let peak = pulled.peak(scene, table, stop).map_err(|error| error.to_string())?;
        let found = SetaResult::new(pulled.pull_off(), peak.as_ref());
        Ok((pulled.into_pull_off(), found))
    }

    /// The pull-off of the seta of a scene on the mesh of its curve, likewise.
    pub fn followed(&self, scene: &Scene, table: &SetaTable, stop: &StopCriteria) -> Result<PulledSeta, String> {
        let (loading, options) = (scene.seta_loading(table), options(scene));
        let (model, pull_off) = match table.tip_law {
            SetaTipLaw::Beam => {
                let (model, options) = (of_beams(scene, table)?, path_options(scene));
                let found = study::pull_off_of_beams(&model, &loading, &options, stop, None, &mut |_, _| {});
                return found.map(|found| PulledSeta::OfBeams(model, found)).map_err(|error| error.to_string());
            }
            SetaTipLaw::Curve => {
                let model = self.model(scene, table)?;
                let pull_off = study::pull_off(&model, &loading, &options, stop);
                (model, pull_off)
            }
            SetaTipLaw::Table => {
                let first = self.table(scene, table, stop)?;
                let mut growing = growing(scene, table, first, stop).map_err(|error| error.to_string())?;
                let of = |law: Arc<dyn TipLaw>| model(scene, table, law);
                let pulled = pull_off_by_table(&mut growing, (&of, table.sideways()), (&loading, &options), stop);
                let pull_off = match pulled {
                    Ok((_, AfterRound::Outside(outside))) if !outside.peak_is_inside => return Err(outside.to_string()),
                    Ok((_, AfterRound::Stopped(bound))) => return Err(bound.to_string()),
                    other => other.map(|(found, _)| found),
                };
                (of(Arc::new(growing.law(table.sideways()))), pull_off)
            }
        };
        pull_off.map(|pull_off| PulledSeta::ByLaw(model, pull_off)).map_err(|error| error.to_string())
    }

    /// The seta of a scene, whose tips follow the curve.
    pub fn model(&self, scene: &Scene, table: &SetaTable) -> Result<SetaModel, String> {
        Ok(model(scene, table, table.law(self.curve(scene)?)))
    }

    fn table(&self, scene: &Scene, table: &SetaTable, stop: &StopCriteria) -> Result<Arc<TipTable>, String> {
        let of = || {
            first_table(scene, table, stop).map_err(|error| match error {
                NoTable::Refused { found, remedy } => format!("{found}. {remedy}"),
                NoTable::Stopped(found) => found,
            })
        };
        let is_same = |own: &SetaTable| own.tip_table == table.tip_table && own.tip_tolerance == table.tip_tolerance;
        if scene.tip_model() == self.tip && self.of.as_ref().is_some_and(is_same) {
            self.table.get_or_init(of).clone()
        } else {
            of()
        }
    }

    fn curve(&self, scene: &Scene) -> Result<PullCurve, String> {
        let of = || tip_curve(scene).map_err(|error| error.to_string());
        if scene.tip_model() == self.tip && scene.accuracy == self.accuracy {
            self.curve.get_or_init(of).clone()
        } else {
            of()
        }
    }
}
