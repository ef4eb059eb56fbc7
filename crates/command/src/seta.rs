//! What pull-offs of setae have in common, and setae that differ from the one of a scene in some keys, pulled off one after the other, or side by side.

use peelkit::model::{PeelModel, PullCurve, SetaModel};
use peelkit::study::{self, Accuracy, Choice, SetaOptions, SetaResult, SpatulaCurveError, StopCriteria};
use peelkit_scene::{Scene, SetaTable};
use std::sync::OnceLock;

/// By how much the curve of a tip begins with it pressed, nm.
const PRESSED: f64 = 50.0;

/// The curve that the tips of a scene follow. A mesh that the scene names is that of the branches, not of the tip.
pub fn tip_curve(scene: &Scene) -> Result<PullCurve, SpatulaCurveError> {
    study::tip_curve(&scene.tip_model(), &Accuracy { choice: Choice::default(), ..scene.accuracy }, PRESSED)
}

/// The seta of a scene, whose tips follow this curve.
pub fn model(scene: &Scene, table: &SetaTable, curve: PullCurve) -> SetaModel {
    let mut model = SetaModel::new(table.seta, table.law(curve));
    model.mesh.order = scene.accuracy.choice.order.unwrap_or(model.mesh.order);
    model
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
}

impl Setae {
    /// Those like the one of this scene.
    pub fn like(scene: &Scene) -> Self {
        Self { tip: scene.tip_model(), accuracy: scene.accuracy, curve: OnceLock::new() }
    }

    /// The pull-off of the seta of a scene, or why there is none. Called from any thread.
    pub fn pull_off(&self, scene: &Scene, stop: &StopCriteria) -> Result<SetaResult, String> {
        let Some(table) = &scene.seta else { return Err("the scene has no [seta]".to_owned()) };
        let model = self.model(scene, table)?;
        let (loading, options) = (scene.seta_loading(table), options(scene));
        let found = study::pull_off(&model, &loading, &options, stop).and_then(|pull_off| {
            let peak = study::converged_peak(&model, &loading, &options, &pull_off, scene.accuracy.relative, stop)?;
            Ok(SetaResult::new(&pull_off, peak.as_ref()))
        });
        found.map_err(|error| error.to_string())
    }

    /// The seta of a scene.
    pub fn model(&self, scene: &Scene, table: &SetaTable) -> Result<SetaModel, String> {
        Ok(model(scene, table, self.curve(scene)?))
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
