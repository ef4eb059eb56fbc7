//! Strips on ground that is not flat: where they lie without a force and their first largest force, against a strong form
//! without finite elements.

use super::check::missing;
use super::reference::{Row, read};
use super::{Check, Measure, Topic};
use crate::adhesion::{Round, Shape, Sinusoid, Substrate};
use crate::model::{Form, Ground, PeelModel, Start, StripModel};
use crate::solve::Beginning;
use crate::study::{Accuracy, Bounds, peel};
use rayon::prelude::*;

pub(super) const TOPIC: Topic = Topic {
    name: "ground",
    about: "strips on waves and cylinders: where they lie, first peak, against solve_bvp",
    run,
};

const TABLE: &str = include_str!("../../../verification/rough.csv");
const SOURCE: &str = "verification/rough.py: scipy's solve_bvp on the strong form";
/// The path as far as its first peak.
const BOUNDS: Bounds = Bounds { points: 20_000, time_s: None, displacement: Some(5.0) };
const ASKED: f64 = 1e-6;
/// Tolerance of what is looked at where no force acts, relative: the table's own error.
const AT_REST: f64 = 1e-7;
const ORDER: usize = 7;

fn run() -> Vec<Check> {
    read(TABLE).par_iter().flat_map(of_row).collect()
}

/// The strip of a row of the table.
fn model(row: &Row) -> Option<PeelModel> {
    let number = |column: &str| row.number(column);
    let (length, offset) = (number("length_of_shape_nm")?, number("offset_nm")?);
    let substrate = match row.text("shape")? {
        "sinusoid" => Substrate::Sinusoid(Sinusoid { height: number("height_nm")?, wavelength: length, offset }),
        "cylinder" => Substrate::Round(Round { shape: Shape::Cylinder, radius: length, offset }),
        _ => return None,
    };
    let mut strip = StripModel::of_the_paper(number("strip_length_nm")?, 1.0);
    strip.strip.height = number("strip_height_nm")?;
    Some(PeelModel { ground: Ground { substrate, start: Start::Conformed }, ..strip.into() })
}

fn of_row(row: &Row) -> Vec<Check> {
    let word = |column: &str| row.text(column).unwrap_or_default();
    let name = format!(
        "{} H = {} nm, {} nm, offset {} nm, L = {} nm, h = {} nm",
        word("shape"),
        word("height_nm"),
        word("length_of_shape_nm"),
        word("offset_nm"),
        word("strip_length_nm"),
        word("strip_height_nm")
    );
    let check = |quantity: &str, computed, measure, tolerance| {
        let expected = row.number(quantity).unwrap_or(f64::NAN);
        Check::new(TOPIC.name, format!("{quantity}, {name}"), SOURCE, computed, expected, measure, tolerance)
    };
    let Some(model) = model(row) else {
        return vec![check("shape", Err("a word of the row is not known".into()), Measure::Relative, ASKED)];
    };
    let mut checks: Vec<Check> = AT_START
        .into_iter()
        .zip(at_start(&model))
        .map(|(quantity, computed)| check(quantity, computed, Measure::Relative, AT_REST))
        .collect();
    let peel = peel(&model, &Accuracy::to(ASKED), &BOUNDS);
    let first = peel.initiation_peak.ok_or_else(|| missing(&peel.end));
    checks.push(check("peak_force_nN", first.clone().map(|peak| peak.force), Measure::Relative, ASKED));
    checks.push(check("peak_displacement_nm", first.map(|peak| peak.displacement), Measure::Relative, 10.0 * ASKED));
    checks
}

const AT_START: [&str; 6] = [
    "start_energy_aJ",
    "start_gap_left_nm",
    "start_gap_middle_nm",
    "start_gap_right_nm",
    "start_end_x_nm",
    "start_end_y_nm",
];

/// The numbers of [`AT_START`].
fn at_start(model: &PeelModel) -> [Result<f64, String>; 6] {
    let problem = model.problem(Form::ThreeField, ORDER);
    let at = match &problem.beginning {
        Beginning::Settled(at) => at,
        Beginning::Nowhere(why) => return std::array::from_fn(|_| Err(why.clone())),
        Beginning::AtRest => return std::array::from_fn(|_| Err("the ground is flat".to_owned())),
    };
    let half = 0.5 * problem.height;
    // both ends and the node between two elements, which is in the middle
    let length = problem.length;
    let coarse = problem.chain.resampled(at.configuration(), &[0.0, 0.5 * length, length]);
    let node = |k: usize| [coarse[3 * k], coarse[3 * k + 1] + half];
    let gap = |k: usize| {
        let [x, y] = node(k);
        model.ground.substrate.foot(x, y).distance - half
    };
    let energy = problem.chain.energy(at.configuration(), &at.state).0.total;
    let [x, y] = node(2 * ORDER);
    [energy, gap(0), gap(ORDER), gap(2 * ORDER), x, y].map(Ok)
}
