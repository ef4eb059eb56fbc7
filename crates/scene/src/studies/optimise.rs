//! The design problem of a scene: what it asks of the library, and whether that has a meaning.

use super::whole::has_no;
use crate::body::body_of;
use crate::error::ValueError;
use crate::key::kind::Key;
use crate::keys::find_key;
use crate::scene::studies::{FreeKey, OptimisationTable, VolumeRule};
use crate::scene::{Described, Scene};
use crate::tables::rate;
use crate::tables::setae::seta;
use crate::value::{Value, show};
use peelkit::model::{Body, PeelModel, Profile, ProfileColumns, ProfileForm, ProfileTable};
use peelkit::study::optimisation::{
    ConstraintKind, DesignConstraint, DesignProblem, DesignVariable, NoOptimum, NumberBy, Objective, ProfileColumn,
    ProfileDesign, SearchMethod, volume,
};
use std::f64::consts::PI;
use std::sync::Arc;

/// The table of a scene.
const TABLE: &str = "optimise";

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
        let objective = table.objective().unwrap_or(Objective::Quantity(self.describes().quantities()[0]));
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

/// What is wrong with the table of a scene: its key, and how.
pub(crate) fn problem(scene: &Scene) -> Option<(String, ValueError)> {
    let table = scene.optimisation.as_ref()?;
    let wrong = Wrong { scene, table };
    let found = wrong
        .free()
        .and_then(|()| wrong.objective())
        .and_then(|()| wrong.angles())
        .and_then(|()| table.parameters.iter().enumerate().try_for_each(|(item, free)| wrong.parameter(item, free)))
        .and_then(|()| wrong.profiles())
        .and_then(|()| wrong.volume())
        .and_then(|()| wrong.method())
        .and_then(|()| wrong.of_library());
    found.err().map(|(name, problem)| (format!("{TABLE}.{name}"), problem))
}

type Checked = Result<(), (&'static str, ValueError)>;

fn refuse(name: &'static str, found: impl Into<String>, remedy: impl Into<String>) -> Checked {
    Err((name, ValueError::new(found.into(), remedy.into())))
}

struct Wrong<'s> {
    scene: &'s Scene,
    table: &'s OptimisationTable,
}

impl Wrong<'_> {
    fn free(&self) -> Checked {
        if self.table.parameters.is_empty() && self.table.columns().is_empty() {
            return refuse(
                "parameters",
                "is empty, and neither width nor height is free: nothing can be optimised",
                "Add for example parameters = [{ key = \"strip.height\", from = \"2 nm\", to = \"20 nm\" }], or width = { from = \"5 nm\", to = \"20 nm\" }.",
            );
        }
        Ok(())
    }

    /// Whether a run of the scene has what is optimised.
    fn objective(&self) -> Checked {
        let none = self.table.objective.and_then(|of| has_no(self.scene, of));
        none.map_or(Ok(()), |none| refuse("objective", none.found, none.remedy))
    }

    fn angles(&self) -> Checked {
        let OptimisationTable { holding_angle, release_angle, .. } = *self.table;
        for (name, angle) in [("holding_angle", holding_angle), ("release_angle", release_angle)] {
            if let Some(angle) = angle.filter(|angle| !(0.0..=PI).contains(angle)) {
                return refuse(
                    name,
                    format!("is {} degrees, which is out of range", show(angle.to_degrees())),
                    "It takes 0 to 180 degrees.",
                );
            }
        }
        match (holding_angle, release_angle) {
            (Some(_), None) => refuse(
                "holding_angle",
                "is given without release_angle",
                "Give both, for a ratio of two peels, or none.",
            ),
            (None, Some(_)) => refuse(
                "release_angle",
                "is given without holding_angle",
                "Give both, for a ratio of two peels, or none.",
            ),
            (Some(a), Some(b)) if a == b => {
                refuse("release_angle", "is the holding_angle, and the ratio is always 1", "Give another angle.")
            }
            (Some(_), Some(_)) if self.table.parameters.iter().any(|free| free.path == "drive.angle") => refuse(
                "parameters",
                "has drive.angle, and both peels of the ratio have angles of their own",
                "Remove it, or remove holding_angle and release_angle.",
            ),
            _ => Ok(()),
        }
    }

    fn parameter(&self, item: usize, free: &FreeKey) -> Checked {
        let (path, number) = (&free.path, item + 1);
        let refuse =
            |found: String, remedy: String| refuse("parameters", format!("has in parameter {number} {found}"), remedy);
        let key = match find_key(path) {
            Ok(key) => key,
            Err(error) => return refuse(format!("{path}, which {}", error.found), error.remedy),
        };
        let of_model = key.is_numeric() && !key.is_count() && !["", "accuracy", "bounds"].contains(&key.table);
        if !of_model {
            return refuse(
                format!("{path}, which is no number of the model"),
                "Name a number of what is peeled, of its adhesion, grip, drive or substrate.".into(),
            );
        }
        if !key.belongs_to(self.scene) {
            let foreign = key.foreign(self.scene);
            return refuse(format!("{path}, which {}", foreign.found), foreign.remedy);
        }
        if key.value(self.scene).is_none() {
            return refuse(
                format!("{path}, which the scene does not set: there is no start"),
                format!("Set {path} in its table."),
            );
        }
        if self.table.parameters[..item].iter().any(|other| other.path == *path) {
            return refuse(format!("{path} a second time"), "Remove one of the two.".into());
        }
        if free.from.total_cmp(&free.to).is_ge() {
            return refuse(
                format!(
                    "{path} from {} to {}: the lower bound is not below the upper one",
                    shown(key, free.from),
                    shown(key, free.to)
                ),
                "Exchange them, or set the key and remove the parameter.".into(),
            );
        }
        for bound in [free.from, free.to] {
            if let Err(error) = key.store_number(&mut self.scene.clone(), bound) {
                return refuse(format!("{path} with a bound that {}", error.found), error.remedy);
            }
        }
        Ok(())
    }

    fn profiles(&self) -> Checked {
        for (column, free) in self.table.columns() {
            let name = column.word();
            let strip = self.scene.model.strip();
            if strip.is_some_and(|strip| strip.layers.is_some() || strip.crack.is_some()) {
                return refuse(
                    name,
                    "is free, and a strip of layers or with a crack has one section all along",
                    "Remove `layers` and `crack` from [strip], or this key.",
                );
            }
            if self.scene.model.yields() {
                return refuse(
                    name,
                    "is free, and a strip that yields has one section all along",
                    "Remove `yield_strength` from [strip], or this key.",
                );
            }
            if matches!(self.scene.model.body, Body::Spatula(_)) {
                return refuse(
                    name,
                    "is free, and the outline of a spatula is not a table of widths and heights",
                    "Vary keys of the spatula as parameters, or peel a [strip] or a [profile].",
                );
            }
            if !(free.from > 0.0 && free.from < free.to) {
                return refuse(
                    name,
                    format!(
                        "goes from {} nm to {} nm: the lower bound is not above zero and below the upper one",
                        show(free.from),
                        show(free.to)
                    ),
                    "Exchange them, or give others.",
                );
            }
            if let Some(other) =
                self.table.parameters.iter().find(|of| of.path == format!("{}.{name}", body_of(self.scene)))
            {
                return refuse(
                    "parameters",
                    format!("has {}, and the {name} along the body is free as well", other.path),
                    "Remove one of the two.",
                );
            }
        }
        Ok(())
    }

    /// Whether bodies between the bounds can have the volume that is asked for.
    fn volume(&self) -> Checked {
        let rule = self.table.volume_rule();
        let columns = self.table.columns();
        if rule == VolumeRule::Free || columns.is_empty() || !self.table.parameters.is_empty() {
            return Ok(());
        }
        let mean = |column: &ProfileColumn| {
            let geometry = self.scene.model.body.geometry();
            let length = self.scene.model.length();
            let at = |k: usize| geometry.at(length * (k as f64 + 0.5) / 1000.0);
            let value = |k: usize| if *column == ProfileColumn::Width { at(k).width } else { at(k).height[0] };
            (0..1000).map(value).sum::<f64>() / 1000.0
        };
        let least: f64 = columns.iter().map(|(column, free)| free.from / mean(column)).product();
        let most: f64 = columns.iter().map(|(column, free)| free.to / mean(column)).product();
        let uniform = self.scene.model.is_uniform();
        let name = columns[0].0.word();
        if uniform && (least > 1.0 || most < 1.0 && rule == VolumeRule::Equal) {
            return refuse(
                name,
                format!(
                    "goes from {} nm to {} nm, and then the volume is {} to {} of that of the scene, which optimise.volume does not allow",
                    show(columns[0].1.from),
                    show(columns[0].1.to),
                    rounded(least),
                    rounded(most)
                ),
                "Widen the bounds, or set optimise.volume = \"free\".",
            );
        }
        Ok(())
    }

    fn method(&self) -> Checked {
        let is_peel = matches!(self.scene.describes(), Described::Peel);
        if let Some(method) = self.table.method.filter(|&method| !is_peel && method != SearchMethod::DerivativeFree) {
            return refuse(
                "method",
                format!("is \"{}\", and {} has no derivatives", method.word(), self.scene.describes().words()),
                "Use \"derivative-free\", or leave it out.",
            );
        }
        let constrained = self.table.volume_rule() != VolumeRule::Free
            || self.table.columns().iter().any(|(_, free)| free.slope.is_some());
        if self.table.method == Some(SearchMethod::QuasiNewton) && constrained {
            return refuse(
                "method",
                "is \"quasi-newton\", which knows bounds alone, and the volume or a slope is constrained",
                "Use \"sequential-quadratic\" or \"derivative-free\", or leave it out.",
            );
        }
        Ok(())
    }

    /// What the library finds: models that cannot be computed at the bounds.
    fn of_library(&self) -> Checked {
        let Some(Err(error)) = self.scene.design_problem().map(|problem| problem.check()) else { return Ok(()) };
        let name = match &error {
            NoOptimum::OutsideRange { name, .. } | NoOptimum::Bounds { name, .. } => match name {
                name if name.starts_with("width_nm") => "width",
                name if name.starts_with("height_nm") => "height",
                _ => "parameters",
            },
            _ => "parameters",
        };
        refuse(name, format!("cannot be used: {error}"), "Give other bounds.")
    }
}

fn shown(key: &Key, value: f64) -> String {
    format!("{} {}", show(value), key.unit()).trim().to_owned()
}

fn rounded(ratio: f64) -> String {
    show((ratio * 1e3).round() / 1e3)
}
