//! The hard scenes: results within their bounds, or a named refusal; never a wrong number.
//!
//! The scenes are texts, which this module does not read: the caller hands over what they say. The true values are those of
//! `verification/hard_scenes.csv`, a collocation of the strong form without finite elements.

mod drawn;
mod repeated;
mod scene;

pub use drawn::STRIPS;
pub use scene::{Ending, HardScene};

use super::reference::Row;
use crate::check::{Check, Measure, under};
use crate::suite::accuracy::bounds;
use crate::suite::reference;
use peelkit::model::{Hold, PeelModel};
use peelkit::study::{Peel, peel};
use rayon::prelude::*;

/// The name under which the checks are reported.
const NAME: &str = "hard";

const TABLE: &str = include_str!("../../../verification/hard_scenes.csv");
const SOURCE: &str = "verification/hard_scenes.py: Chebyshev collocation of the strong form";
/// Two numbers of a scene are the same within this.
const SAME: f64 = 1e-12;

/// Peels every scene, once more in other units, and these of the [`STRIPS`] randomly sampled strips, on all cores, and judges what came out.
pub fn run(scenes: &[HardScene], strips: &[usize]) -> Vec<Check> {
    let rows = reference::read(TABLE);
    let peels: Vec<Peel> = scenes.par_iter().map(|s| peel(&s.model, &s.accuracy, &s.bounds.from_now())).collect();
    let pairs = scenes.iter().zip(&peels);
    let judged = |(scene, peel)| [vec![ending(scene, peel)], numbers(scene, peel, &rows)].concat();
    under(NAME, pairs.flat_map(judged).chain(repeated::checks(scenes)).chain(drawn::checks(strips)).collect())
}

/// Whether the path ended as expected: 1 if it did.
fn ending(scene: &HardScene, peel: &Peel) -> Check {
    let found = Ending::of(&peel.end);
    let computed = if found == scene.expected { Ok(1.0) } else { Err(format!("the path ended {:?}", peel.end)) };
    let name = format!("{}: ends {:?}; {}", scene.name, scene.expected, effort(peel));
    Check::new(name, "scenes/hard", computed, 1.0, Measure::Absolute, 0.0)
}

fn effort(peel: &Peel) -> String {
    let effort = &peel.effort;
    format!("{} points, {} iterations, {} elements", effort.points, effort.newton_iterations, effort.elements)
}

/// Every number of the scene in the table: |computed - true| over the bound is at most 1, as far as the digits of the table
/// tell.
fn numbers(scene: &HardScene, peel: &Peel, rows: &[Row]) -> Vec<Check> {
    let Some(row) = rows.iter().find(|row| is_of(row, &scene.model)) else { return Vec::new() };
    let check = |(quantity, reported): (&'static str, Option<(f64, f64)>)| {
        let text = row.text(quantity)?;
        let exact: f64 = text.parse().ok()?;
        let over = |(value, bound): (f64, f64)| {
            let unknown = 0.5 * bounds::last_digit(text);
            ((value - exact).abs() - unknown).max(0.0) / bound
        };
        let bound = reported.map_or(f64::NAN, |(_, bound)| bound / exact.abs());
        let name = format!("{}: error of {quantity} over its bound, which is {bound:.1e} of {text}", scene.name);
        let computed = reported.map(over).ok_or_else(|| "not reported".to_owned());
        Some(Check::new(name, SOURCE, computed, 1.0, Measure::AtMost, 0.0))
    };
    bounds::reported(peel).into_iter().filter_map(check).collect()
}

/// Whether a row of the table is of this strip.
fn is_of(row: &Row, model: &PeelModel) -> bool {
    let Some(s) = model.strip() else { return false };
    let (a, g) = (&model.adhesion, &model.grip);
    let pairs = [
        ("length_nm", s.length),
        ("height_nm", s.height),
        ("width_nm", s.width),
        ("youngs_modulus_GPa", s.material.youngs_modulus),
        ("poissons_ratio", s.material.poissons_ratio),
        ("shear_correction", s.material.shear_correction),
        ("bending_stiffness_factor", s.material.bending_stiffness_factor),
        ("hamaker_constant_J", 1e-18 * a.hamaker_constant),
        ("equilibrium_distance_nm", a.equilibrium_distance),
    ];
    let same = |(column, value): (&str, f64)| row.number(column).is_some_and(|n| (n / value - 1.0).abs() < SAME);
    let holds = |column: &str, hold: Hold| row.text(column) == Some(if hold == Hold::Fixed { "fixed" } else { "free" });
    pairs.into_iter().all(same) && holds("grip_rotation", g.rotation) && holds("grip_horizontal", g.horizontal)
}
