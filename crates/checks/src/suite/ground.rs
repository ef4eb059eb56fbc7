//! Strips and spatulae on ground that is not flat: where they lie without a force and their first largest force, against a strong
//! form without finite elements.

use super::reference::{Row, read};
use crate::check::{Check, Measure, Topic, missing};
use crate::suite::accuracy::bounds::last_digit;
use peelkit::adhesion::{BodyShape, Round, Sinusoid, Substrate};
use peelkit::model::{Body, Discretisation, Form, Ground, Hold, PeelModel, Spatula, Start, StripModel};
use peelkit::solve::InitialState;
use peelkit::study::{Accuracy, Peel, Prepared, StopCriteria, peel, prepared};
use rayon::prelude::*;

pub(super) const TOPIC: Topic = Topic {
    name: "ground",
    about: "strips and spatulae on waves and cylinders: free equilibria and first peaks, against solve_bvp",
    checks,
};

const TABLE: &str = include_str!("../../verification/rough.csv");
const SOURCE: &str = "verification/rough.py: scipy's solve_bvp on the strong form";
const SPATULAE: &str = include_str!("../../verification/rough_spatula.csv");
const SPATULAE_SOURCE: &str = "verification/rough_spatula.py: scipy's solve_bvp on the strong form";
/// The path of a strip as far as its first peak.
const BOUNDS: StopCriteria = StopCriteria::up_to(5.0);
/// How far a spatula's path goes on beyond its first peak, relative.
const BEHIND: f64 = 1.05;
const ASKED: f64 = 1e-6;
/// Tolerance of what is looked at where no force acts, relative: the table's own error.
const AT_REST: f64 = 1e-7;
const ORDER: usize = 7;

fn checks() -> Vec<Check> {
    let mut checks: Vec<Check> = read(TABLE).par_iter().flat_map(of_strip).collect();
    checks.par_extend(read(SPATULAE).par_iter().flat_map(of_spatula));
    checks
}

/// The ground of a row of a table.
fn ground(row: &Row) -> Option<Ground> {
    let (length, offset) = (row.number("length_of_shape_nm")?, row.number("offset_nm")?);
    let substrate = match row.text("shape")? {
        "sinusoid" => Substrate::Sinusoid(Sinusoid { height: row.number("height_nm")?, wavelength: length, offset }),
        "cylinder" => Substrate::Round(Round { shape: BodyShape::Cylinder, radius: length, offset }),
        _ => return None,
    };
    Some(Ground { substrate, start: Start::Conformed })
}

/// The strip of a row of the table.
fn strip(row: &Row) -> Option<PeelModel> {
    let mut strip = StripModel::of_the_paper(row.number("strip_length_nm")?, 1.0);
    strip.strip.height = row.number("strip_height_nm")?;
    Some(PeelModel { ground: ground(row)?, ..strip.into() })
}

/// The spatula of a row of its table.
fn spatula(row: &Row) -> Option<PeelModel> {
    let number = |column: &str| row.number(column);
    let diameter = number("shaft_diameter_nm")?;
    let spatula = Spatula {
        pad_length: number("pad_length_nm")?,
        neck_length: number("neck_length_nm")?,
        shaft_length: number("shaft_length_nm")?,
        bend_length: number("bend_length_nm")?,
        tip_width: number("tip_width_nm")?,
        neck_width: diameter,
        shaft_diameter: diameter,
        pad_thickness: number("pad_thickness_nm")?,
        ..Spatula::default()
    };
    let mut model = PeelModel { body: Body::Spatula(spatula), ..StripModel::of_the_paper(1.0, 1.0).into() };
    model.ground = ground(row)?;
    model.grip.rotation = if row.text("grip_rotation")? == "fixed" { Hold::Fixed } else { Hold::Free };
    model.pull.angle = number("angle_deg")?.to_radians();
    Some(model)
}

/// The checks of a row with the strip of that row.
fn of_strip(row: &Row) -> Vec<Check> {
    let word = |column: &str| row.text(column).unwrap_or_default();
    let name = format!("{}, L = {} nm, h = {} nm", ground_named(row), word("strip_length_nm"), word("strip_height_nm"));
    let expected = Expected { row, name, source: SOURCE };
    let Some(model) = strip(row) else { return vec![expected.unknown()] };
    let length = model.length();
    let mut checks = expected.at_start(&model, [0.0, 0.5 * length, length]);
    checks.extend(expected.first_peak(&peel(&model, &Accuracy::to(ASKED), &BOUNDS)));
    checks
}

/// The checks of a row with the spatula of that row.
fn of_spatula(row: &Row) -> Vec<Check> {
    let word = |column: &str| row.text(column).unwrap_or_default();
    let name = format!(
        "{}, pad {} nm, rotation {}, pulled at {} degrees",
        ground_named(row),
        word("pad_length_nm"),
        word("grip_rotation"),
        word("angle_deg")
    );
    let expected = Expected { row, name, source: SPATULAE_SOURCE };
    let (Some(model), Some(pad)) = (spatula(row), row.number("pad_length_nm")) else {
        return vec![expected.unknown()];
    };
    let mut checks = expected.at_start(&model, [0.0, 0.5 * pad, pad]);
    let displacement = row.number("peak_displacement_nm").map(|place| BEHIND * place);
    let peel = peel(&model, &Accuracy::to(ASKED), &StopCriteria { displacement, ..BOUNDS });
    checks.extend(expected.first_peak(&peel));
    checks.push(expected.over_bound(&peel));
    checks
}

/// The ground of a row, in words.
fn ground_named(row: &Row) -> String {
    let word = |column: &str| row.text(column).unwrap_or_default();
    let [shape, height, length, offset] = ["shape", "height_nm", "length_of_shape_nm", "offset_nm"].map(word);
    format!("{shape} H = {height} nm, {length} nm, offset {offset} nm")
}

/// What a row says.
struct Expected<'a> {
    row: &'a Row,
    name: String,
    source: &'static str,
}

const AT_START: [&str; 6] = [
    "start_energy_aJ",
    "start_gap_left_nm",
    "start_gap_middle_nm",
    "start_gap_right_nm",
    "start_end_x_nm",
    "start_end_y_nm",
];

impl Expected<'_> {
    fn check(&self, quantity: &str, computed: Result<f64, String>, tolerance: f64) -> Check {
        let expected = self.row.number(quantity).unwrap_or(f64::NAN);
        let name = format!("{quantity}, {}", self.name);
        Check::new(name, self.source, computed, expected, Measure::Relative, tolerance)
    }

    fn unknown(&self) -> Check {
        self.check("shape", Err("a word or a number of the row is not known".into()), ASKED)
    }

    /// Where it lies without a force, with the gaps at these places.
    fn at_start(&self, model: &PeelModel, places: [f64; 3]) -> Vec<Check> {
        let found = at_start(model, places);
        AT_START.into_iter().zip(found).map(|(quantity, found)| self.check(quantity, found, AT_REST)).collect()
    }

    /// Its first largest force.
    fn first_peak(&self, peel: &Peel) -> [Check; 2] {
        let first = peel.initiation_peak.ok_or_else(|| missing(&peel.end));
        [
            self.check("peak_force_nN", first.clone().map(|peak| peak.force), ASKED),
            self.check("peak_displacement_nm", first.map(|peak| peak.displacement), 10.0 * ASKED),
        ]
    }

    /// How far that is off, the table's last digit aside, over the bounds that the program states.
    fn over_bound(&self, peel: &Peel) -> Check {
        let over = |quantity: &str, value: f64, bound: f64| {
            let (text, exact) = (self.row.text(quantity)?, self.row.number(quantity)?);
            Some(((value - exact).abs() - 0.5 * last_digit(text)).max(0.0) / bound)
        };
        let largest = || {
            let peak = peel.initiation_peak?;
            let force = over("peak_force_nN", peak.force, peak.force_error)?;
            Some(force.max(over("peak_displacement_nm", peak.displacement, peak.displacement_error)?))
        };
        let computed = largest().ok_or_else(|| missing(&peel.end));
        let name = format!("largest error over its bound, {}", self.name);
        Check::new(name, self.source, computed, 1.0, Measure::AtMost, 0.0)
    }
}

/// The numbers of [`AT_START`].
fn at_start(model: &PeelModel, places: [f64; 3]) -> [Result<f64, String>; 6] {
    let problem = match prepared(model, Discretisation::moving(Form::ThreeField, ORDER), None) {
        Ok(Prepared { problem, .. }) => problem,
        Err(failed) => return std::array::from_fn(|_| Err(failed.to_string())),
    };
    let (beam, at) = match (problem.beam.planar(), &problem.start) {
        (Some(beam), InitialState::Known { at, .. }) => (beam, at),
        _ => {
            return std::array::from_fn(|_| Err("the ground is flat".to_owned()));
        }
    };
    // nodes between two elements, at each of the places and at the end
    let mut ends = places.to_vec();
    ends.extend((places[2] < beam.length).then_some(beam.length));
    let coarse = beam.chain.resampled(beam.configuration(at), &ends);
    let node = |k: usize| {
        let [along, gap] = [coarse[3 * ORDER * k], coarse[3 * ORDER * k + 1]];
        (ends[k] + along, gap + 0.5 * beam.height_at(ends[k]))
    };
    let gap = |k: usize| {
        let (x, y) = node(k);
        model.ground.substrate.project(x, y).distance - 0.5 * beam.height_at(ends[k])
    };
    let energy = beam.chain.energy(beam.configuration(at), &at.values).0.total;
    let (x, y) = node(ends.len() - 1);
    [energy, gap(0), gap(1), gap(2), x, y].map(Ok)
}
