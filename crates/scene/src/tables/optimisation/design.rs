//! What the table asks of the library: the design problem of a scene.

use super::{FreeProfile, OptimisationTable, VolumeRule};
use crate::keys::find_key;
use crate::scene::Scene;
use crate::tables::{rate, seta};
use crate::value::Value;
use peelkit::model::{Body, PeelModel, Profile, ProfileColumns, ProfileForm, ProfileTable};
use peelkit::study::optimisation::{
    ConstraintKind, DesignConstraint, DesignProblem, DesignVariable, NumberBy, Objective, ProfileColumn, ProfileDesign,
    volume,
};
use std::sync::Arc;

/// From values of the variables to the model of a scene: keys first, then the widths, then the heights.
#[derive(Clone)]
struct Designs {
    scene: Scene,
    profile: Option<ProfileDesign>,
    columns: Vec<ProfileColumn>,
}

impl Designs {
    /// What is checked and drawn of a design: of a seta the body at each of its tips.
    fn model(&self, values: &[f64]) -> Option<PeelModel> {
        let scene = self.scene(values)?;
        Some(if scene.seta.is_some() { scene.tip_model() } else { scene.model })
    }

    /// The scene with these values; none where one is out of the range of its key, and where there is no such seta or no such pull at a rate.
    fn scene(&self, values: &[f64]) -> Option<Scene> {
        let table = self.scene.optimisation.as_ref()?;
        let (numbers, mut rest) = values.split_at_checked(table.parameters.len())?;
        let mut scene = self.scene.clone();
        for (free, &value) in table.parameters.iter().zip(numbers) {
            find_key(&free.path).ok()?.store_number(&mut scene, value).ok()?;
        }
        if seta::problem(&scene).or_else(|| rate::problem(&scene)).is_some() {
            return None;
        }
        let Some(profile) = &self.profile else { return Some(scene) };
        let mut columns = Vec::new();
        for &column in &self.columns {
            let (of_column, others) = rest.split_at_checked(profile.values(column).len())?;
            columns.push((column, of_column));
            rest = others;
        }
        let model = profile.shaped(&scene.model, &columns)?;
        Some(Scene { model, ..scene })
    }
}

impl OptimisationTable {
    /// What is free of the outline, with its bounds.
    pub(super) fn columns(&self) -> Vec<(ProfileColumn, FreeProfile)> {
        let columns = [(ProfileColumn::Width, self.width), (ProfileColumn::Height, self.height)];
        columns.into_iter().filter_map(|(column, free)| Some((column, free?))).collect()
    }

    /// The objective; none where the text has none.
    fn objective(&self) -> Option<Objective> {
        let of = self.objective?;
        Some(match (self.holding_angle, self.release_angle) {
            (Some(holding_angle), Some(release_angle)) => Objective::Ratio { of, holding_angle, release_angle },
            _ => Objective::Quantity(of),
        })
    }
}

impl Scene {
    /// The scene of a design: the keys set, the profile a table, and nothing left to optimise; none where it is no scene.
    pub fn of_design(&self, values: &[f64]) -> Option<Self> {
        let table = self.optimisation.as_ref()?;
        let found = self.designs(table).scene(values)?;
        let mut scene = Self { optimisation: None, uncertainty: None, fit: None, ..found };
        if !table.columns().is_empty() {
            scene.table_texts.profile = table_text(&scene.model)?;
        }
        Some(scene)
    }

    fn designs(&self, table: &OptimisationTable) -> Designs {
        let columns: Vec<ProfileColumn> = table.columns().iter().map(|(column, _)| *column).collect();
        let profile = (!columns.is_empty()).then(|| ProfileDesign::of(&self.model, table.values)).flatten();
        Designs { scene: self.clone(), columns, profile }
    }

    /// The design problem of the table `optimise`; none where the scene has none. What is wrong with it
    /// [`peelkit::study::optimisation::DesignProblem::check`] says. Of a scene with a seta or a rate who computes it has to say how in
    /// [`DesignProblem::number`].
    pub fn design_problem(&self) -> Option<DesignProblem<'static>> {
        let table = self.optimisation.as_ref()?;
        let objective = table.objective().unwrap_or(Objective::Quantity(self.quantities().0[0]));
        let columns = table.columns();
        let designs = self.designs(table);
        let profile = designs.profile.clone();
        let (mut variables, mut start) = (Vec::new(), Vec::new());
        for free in &table.parameters {
            let value = find_key(&free.path).ok().and_then(|key| key.value(self));
            variables.push(DesignVariable::new(free.path.clone(), free.from, free.to));
            start.push(if let Some(Value::Number(number)) = value { number } else { f64::NAN });
        }
        let mut constraints: Vec<DesignConstraint<'static>> = Vec::new();
        for (column, free) in columns {
            let Some(profile) = &profile else { continue };
            if let Some(slope) = free.slope {
                let scale = 0.5 * (free.from + free.to);
                constraints.extend(profile.smoothness(column, variables.len(), slope, scale));
            }
            variables.extend(profile.variables(column, free.from, free.to));
            start.extend(profile.values(column));
        }
        constraints.extend(volume_constraint(table.volume_rule(), &self.model, designs.clone()));
        let model = Box::new(move |values: &[f64]| designs.model(values));
        let number = NumberBy::Peel;
        Some(DesignProblem { objective, goal: table.goal, variables, constraints, model, number, start })
    }
}

/// ln of the volume over that of the scene.
fn volume_constraint(rule: VolumeRule, model: &PeelModel, designs: Designs) -> Option<DesignConstraint<'static>> {
    let kind = match rule {
        VolumeRule::Equal => ConstraintKind::Equal,
        VolumeRule::AtMost => ConstraintKind::AtMost,
        VolumeRule::Free => return None,
    };
    let (designs, given) = (Arc::new(designs), volume(model));
    let function = move |values: &[f64]| designs.model(values).map_or(f64::NAN, |model| (volume(&model) / given).ln());
    Some(DesignConstraint { name: "volume".into(), kind, function: Box::new(function) })
}

/// The table of a profile as a CSV that reads as the same numbers.
fn table_text(model: &PeelModel) -> Option<String> {
    let Body::Profile(Profile { form: ProfileForm::Table(table), .. }) = &model.body else { return None };
    let ProfileColumns { places, widths, heights, angles, roundness } = table.columns();
    let row = |k: usize| format!("{},{},{},{},{}\n", places[k], widths[k], heights[k], angles[k], roundness[k]);
    let rows: String = (0..places.len()).map(row).collect();
    Some(format!("{}\n{rows}", ProfileTable::COLUMNS.join(",")))
}
