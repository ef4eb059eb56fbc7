//! What is uncertain of a scene: the plan that it asks of the library, the scene at any values of the uncertain keys, and whether every
//! distribution stays where its key may be.

use super::whole::has_no;
use crate::error::ValueError;
use crate::key::kind::Key;
use crate::keys::find_key;
use crate::scene::Scene;
use crate::scene::studies::{CorrelatedKeys, UncertainKey, UncertaintyTable};
use crate::value::{Value, quoted, show};
use peelkit::model::PeelModel;
use peelkit::study::uncertainty::{Correlation, Design, Distribution, Indices, Input, NoDesign, Plan};

/// The table of a scene.
const TABLE: &str = "uncertainty";

impl UncertaintyTable {
    /// The plan, in the units of the library, with the means, medians and modes that are those of the scene.
    pub fn plan(&self, scene: &Scene) -> Plan {
        let input = |of: &UncertainKey| Input { name: of.path.clone(), distribution: of.of_scene(scene) };
        // a key that is no input has a number that no input has: the plan is refused
        let place = |path: &String| self.inputs.iter().position(|of| of.path == *path).unwrap_or(usize::MAX);
        let correlation =
            |of: &CorrelatedKeys| Correlation { inputs: of.keys.each_ref().map(place), coefficient: of.coefficient };
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
    fn of_scene(&self, scene: &Scene) -> Distribution {
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

/// The largest probability of a value that cannot be computed.
const MOST_OUTSIDE: f64 = 1e-6;

/// What is wrong with the table of a scene: its key, and how.
pub(crate) fn problem(scene: &Scene) -> Option<(String, ValueError)> {
    let table = scene.uncertainty.as_ref()?;
    let at = |name: &str, problem: ValueError| (format!("{TABLE}.{name}"), problem);
    let each = (0..table.inputs.len()).find_map(|index| of_input(scene, table, index).err());
    if let Some(problem) = each {
        return Some(at("inputs", problem));
    }
    if let Some(none) = table.quantities.iter().find_map(|&of| has_no(scene, of)) {
        return Some(at("quantities", none));
    }
    if let Some(path) = table.correlations.iter().flat_map(|of| &of.keys).find(|path| !has(table, path)) {
        let known: Vec<&str> = table.inputs.iter().map(|of| of.path.as_str()).collect();
        let remedy = format!("The inputs are {}.", known.join(", "));
        return Some(at("correlations", ValueError::new(format!("names {}, which is no input", quoted(path)), remedy)));
    }
    let error = Design::new(table.plan(scene)).err()?;
    let (name, remedy) = match &error {
        NoDesign::NoInputs => ("inputs", "Add an input: a key, its distribution and what that needs."),
        NoDesign::TooManyInputs { .. } => ("inputs", "Leave out inputs that matter little."),
        NoDesign::Twice { .. } => ("inputs", "Remove one of the two."),
        NoDesign::Distribution { .. } => ("inputs", "Give it other numbers."),
        NoDesign::Coefficient { .. } => ("correlations", "Two inputs that are one and the same are one input."),
        NoDesign::WithItself { .. } | NoDesign::CorrelatedTwice { .. } | NoDesign::NoSuchInput { .. } => {
            ("correlations", "Remove it.")
        }
        NoDesign::Contradiction => {
            ("correlations", "Make them smaller: no three inputs can be strongly correlated in contradictory ways.")
        }
        NoDesign::TooFew { .. } if table.indices == Indices::Estimated => {
            ("samples", "Give more samples, or indices = false.")
        }
        NoDesign::TooFew { .. } => ("samples", "Give more samples."),
    };
    Some(at(name, ValueError::new(format!("cannot be used: {error}"), remedy)))
}

fn has(table: &UncertaintyTable, path: &str) -> bool {
    table.inputs.iter().any(|of| of.path == path)
}

/// Whether an input is a number of the model whose distribution stays where that may be.
fn of_input(scene: &Scene, table: &UncertaintyTable, index: usize) -> Result<(), ValueError> {
    let input = &table.inputs[index];
    let in_input = |found: String| format!("has in input {} {found}", index + 1);
    let key = find_key(&input.path)?;
    if !is_of_model(key) {
        let found = in_input(format!("{}, which is no number of the model", input.path));
        return Err(ValueError::new(
            found,
            "Name a number of what is peeled, of its adhesion, grip, drive or substrate.",
        ));
    }
    if !key.belongs_to(scene) {
        let foreign = key.foreign(scene);
        return Err(ValueError::new(in_input(format!("{}, which {}", input.path, foreign.found)), foreign.remedy));
    }
    let distribution = input.of_scene(scene);
    if input.is_centered && key.value(scene).is_none() {
        let found = in_input(format!("{} without a mean, median or mode, and the scene has none", input.path));
        return Err(ValueError::new(found, "Give the distribution its mean, median or mode."));
    }
    distribution.check().map_err(|error| {
        let found = in_input(format!("{}: a {} distribution whose {error}", input.path, distribution.name()));
        ValueError::new(found, "Give it other numbers.")
    })?;
    inside(scene, key, &distribution).map_err(|error| ValueError::new(in_input(error.found), error.remedy))
}

/// Whether the key is a number of what is computed, and not of how.
fn is_of_model(key: &Key) -> bool {
    key.is_numeric() && !key.is_count() && !["", "accuracy", "bounds", TABLE].contains(&key.table)
}

/// Whether the distribution stays in the range of its key, and the scene with its extreme values can be computed.
fn inside(scene: &Scene, key: &Key, distribution: &Distribution) -> Result<(), ValueError> {
    let path = key.path();
    let outside = distribution.probability_outside(key.range());
    if outside > MOST_OUTSIDE {
        let instead = match distribution {
            Distribution::Normal { .. } => {
                "Use a smaller deviation, or a lognormal, uniform or triangular distribution that ends inside."
            }
            _ => "Move its ends inside.",
        };
        let found = format!(
            "{path}, {} of whose distribution is outside of what the key may be: it is {distribution}{}, and the key takes {}",
            show_share(outside),
            if key.unit().is_empty() { String::new() } else { format!(" in {}", key.unit()) },
            key.takes()
        );
        return Err(ValueError::new(found, instead));
    }
    for probability in [MOST_OUTSIDE, 1.0 - MOST_OUTSIDE] {
        let value = distribution.quantile(probability);
        let mut extreme = scene.clone();
        let found = |why: &str| {
            format!(
                "{path}, whose distribution reaches {} {}: the scene then has no model, because {why}",
                show(value),
                key.unit()
            )
        };
        let narrower = "Use a narrower distribution.";
        key.store_number(&mut extreme, value).map_err(|error| ValueError::new(found(&error.found), narrower))?;
        extreme.check_whole().map_err(|error| ValueError::new(found(&error.found), narrower))?;
    }
    Ok(())
}

/// A probability as a person reads it.
fn show_share(share: f64) -> String {
    if share < 1e-3 { format!("a share of {share:.1e}") } else { format!("{:.2} %", 100.0 * share) }
}
