//! What the table asks of the library, and the scene at any values of the uncertain keys.

use super::{UncertainKey, UncertaintyTable};
use crate::error::ValueError;
use crate::key::Key;
use crate::keys::find_key;
use crate::scene::Scene;
use crate::value::Value;
use peelkit::model::PeelModel;
use peelkit::study::uncertainty::{Correlation, Distribution, Input, Plan};

impl UncertaintyTable {
    /// The plan, in the units of the library, with the means, medians and modes that are those of the scene.
    pub fn plan(&self, scene: &Scene) -> Plan {
        let input = |of: &UncertainKey| Input { name: of.path.clone(), distribution: of.of_scene(scene) };
        // a key that is no input has a number that no input has: the plan is refused
        let place = |path: &String| self.inputs.iter().position(|of| of.path == *path).unwrap_or(usize::MAX);
        let correlation = |of: &super::CorrelatedKeys| Correlation {
            inputs: of.keys.each_ref().map(place),
            coefficient: of.coefficient,
        };
        Plan {
            inputs: self.inputs.iter().map(input).collect(),
            correlations: self.correlations.iter().map(correlation).collect(),
            samples: self.samples,
            seed: self.seed,
            indices: self.indices,
        }
    }

    /// The model of the scene with these values of the uncertain keys, in their order and the units of the library.
    ///
    /// # Errors
    /// Where one of them is out of the range of its key.
    pub fn model(&self, scene: &Scene, values: &[f64]) -> Result<PeelModel, ValueError> {
        Ok(self.scene(scene, values)?.model)
    }

    /// The scene with these values, likewise.
    ///
    /// # Errors
    /// As of [`UncertaintyTable::model`].
    pub fn scene(&self, scene: &Scene, values: &[f64]) -> Result<Scene, ValueError> {
        let mut scene = scene.clone();
        for (input, &value) in self.inputs.iter().zip(values) {
            let key = find_key(&input.path)?;
            let named = |error: ValueError| ValueError::new(format!("`{}` {}", input.path, error.found), error.remedy);
            key.store_number(&mut scene, value).map_err(named)?;
        }
        Ok(scene)
    }
}

impl UncertainKey {
    /// The distribution, about the value of the scene where it is given about none.
    pub(super) fn of_scene(&self, scene: &Scene) -> Distribution {
        if !self.is_centered {
            return self.distribution;
        }
        let value = find_key(&self.path).ok().and_then(|key: &Key| key.value(scene));
        let Some(Value::Number(center)) = value else { return self.distribution };
        match self.distribution {
            Distribution::Normal { deviation, .. } => Distribution::Normal { mean: center, deviation },
            Distribution::Lognormal { log_deviation, .. } => Distribution::Lognormal { median: center, log_deviation },
            Distribution::Triangular { from, to, .. } => Distribution::Triangular { from, mode: center, to },
            uniform @ Distribution::Uniform { .. } => uniform,
        }
    }
}
