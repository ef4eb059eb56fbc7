//! Strips that are pulled, rolled and let go in space, against collocation of the strong form.

use crate::check::{Check, Measure, Topic};
use peelkit::adhesion::SectionShape;
use peelkit::model::{Body, Hold, PeelModel, Space, Step, StripModel};
use peelkit::study::{Accuracy, LimitPoint, LimitPointKind, Peel, StopCriteria, peel};
use rayon::prelude::*;

pub(in crate::suite) const TOPIC: Topic =
    Topic { name: "space", about: "strips in space, and what a grip does before the pull: collocation", checks };

const PEELS: &str = include_str!("../../../verification/space_peels.csv");
const COLLOCATION: &str = "verification/space_peels.py: Gauss collocation";
const ASKED: f64 = 1e-6;
/// The first folds lie before that point.
const BOUNDS: StopCriteria = StopCriteria::after_points(220);
/// Of the height at which a rolled grip has no force, nm, and of its torque there, nN·nm.
const HEIGHT: f64 = 1e-8;
const TORQUE: f64 = 1e-6;

/// A strip of the table.
struct Case {
    name: &'static str,
    /// b and h, nm
    section: [f64; 2],
    shape: SectionShape,
    /// Elevation and azimuth of the pull, degrees
    pull: [f64; 2],
    steps: &'static [Step],
    /// Whether the grip holds its roll, and its yaw
    held: [bool; 2],
}

const ROLL: Step = Step::Roll(5.0 * std::f64::consts::PI / 180.0);

const CASES: &[Case] = &[
    pulled("sideways", [40.0, 10.0], SectionShape::Rectangle, [60.0, 90.0]),
    pulled("oblique_60_30", [20.0, 10.0], SectionShape::Rectangle, [60.0, 30.0]),
    pulled("oblique_45_60", [15.0, 10.0], SectionShape::Rectangle, [45.0, 60.0]),
    pulled("ellipse_oblique", [12.0, 8.0], SectionShape::Ellipse, [70.0, 40.0]),
    rolled("rolled", 10.0, SectionShape::Rectangle, &[Step::Lift(0.5), ROLL, Step::Release], true),
    rolled("rolled_yaw_free", 10.0, SectionShape::Rectangle, &[Step::Lift(0.4), ROLL, Step::Release], false),
    rolled("ellipse_rolled", 20.0, SectionShape::Ellipse, &[Step::Lift(0.1), ROLL, Step::Release], true),
];

const fn pulled(name: &'static str, section: [f64; 2], shape: SectionShape, pull: [f64; 2]) -> Case {
    Case { name, section, shape, pull, steps: &[], held: [false; 2] }
}

/// By a grip that has been lifted, rolled and let go of its height, and is pulled straight up at that roll.
const fn rolled(name: &'static str, width: f64, shape: SectionShape, steps: &'static [Step], holds_yaw: bool) -> Case {
    Case { name, section: [width, 10.0], shape, pull: [90.0, 0.0], steps, held: [true, holds_yaw] }
}

fn checks() -> Vec<Check> {
    CASES.par_iter().flat_map(checks_of).collect()
}

impl Case {
    fn model(&self) -> PeelModel {
        let mut model = PeelModel::from(StripModel::of_the_paper(100.0, 1.0));
        if let Body::Strip(strip) = &mut model.body {
            [strip.width, strip.height] = self.section;
            if self.shape == SectionShape::Ellipse {
                strip.material.shear_correction = 0.9;
            }
        }
        let [elevation, azimuth] = self.pull.map(f64::to_radians);
        let [roll, yaw] = self.held.map(|held| if held { Hold::Fixed } else { Hold::Free });
        model.pull.angle = elevation;
        model.space = Some(Space { azimuth, roll, yaw, section: self.shape, ..Space::default() });
        model.steps = self.steps.to_vec();
        model
    }

    /// A number of the table.
    fn known(&self, quantity: &str) -> Option<f64> {
        let key = format!("{},{quantity},", self.name);
        let row = PEELS.lines().find_map(|line| line.strip_prefix(&key))?;
        row.split(',').next()?.parse().ok()
    }
}

fn checks_of(case: &Case) -> Vec<Check> {
    let peel = peel(&case.model(), &Accuracy::to(ASKED), &BOUNDS);
    let start = if case.steps.is_empty() { 0.0 } else { case.known("start_displacement_nm").unwrap_or(f64::NAN) };
    let first = |kind| peel.limit_points.iter().find(|point| point.kind == kind).copied();
    let mut found = behind_steps(case, &peel);
    let mut points = vec![("peak", first(LimitPointKind::Load))];
    if case.steps.is_empty() {
        points.push(("fold", first(LimitPointKind::Displacement)));
    }
    for (what, point) in points {
        let place = |point: LimitPoint| (point.displacement, point.displacement_error);
        let force = |point: LimitPoint| (point.force, point.force_error);
        found.extend(held(case, &format!("{what}_displacement_nm"), start, point.map(place)).into_iter().flatten());
        found.extend(held(case, &format!("{what}_force_nN"), 0.0, point.map(force)).into_iter().flatten());
    }
    found
}

/// A number against the table, which counts from `start`, and its error over its bound.
fn held(case: &Case, quantity: &str, start: f64, found: Option<(f64, f64)>) -> Option<[Check; 2]> {
    let expected = case.known(quantity)? - start;
    let name = format!("{} of {}", quantity, case.name);
    let number = found.map(|(number, _)| number).ok_or_else(|| "no such point was located".to_owned());
    let over = found.map(|(number, bound)| (number - expected).abs() / bound).ok_or_else(String::new);
    Some([
        Check::new(name.clone(), COLLOCATION, number, expected, Measure::Relative, ASKED),
        Check::new(format!("error over bound of {name}"), COLLOCATION, over, 1.0, Measure::AtMost, 0.0),
    ])
}

/// Where the grip is behind its steps, and what it exerts there.
fn behind_steps(case: &Case, peel: &Peel) -> Vec<Check> {
    if case.steps.is_empty() {
        return Vec::new();
    }
    let missing = || "a step before the pull has no end".to_owned();
    let all = peel.steps.len() == case.steps.len();
    let grip = peel.steps.last().filter(|_| all);
    let height = grip.map(|grip| grip.y).ok_or_else(missing);
    let torque = grip.and_then(|grip| grip.forces.in_space).map(|forces| forces.torque).ok_or_else(missing);
    let numbers = [("start_displacement_nm", height, HEIGHT), ("start_torque_nN_nm", torque, TORQUE)];
    let check = |(quantity, number, tolerance): (&str, _, f64)| {
        let name = format!("{quantity} of {} behind its steps", case.name);
        Some(Check::new(name, COLLOCATION, number, case.known(quantity)?, Measure::Absolute, tolerance))
    };
    numbers.into_iter().filter_map(check).collect()
}
