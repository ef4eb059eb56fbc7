//! The strip against collocation of the strong form, exact relations and limits.

mod peaks;
mod points;
mod steady;
mod work;

use super::check::{Check, Measure, Topic, missing};
use super::reference::{self, Row, published};
use peelkit::adhesion::LineLoad;
use peelkit::model::StripModel;
use peelkit::study::{Accuracy, Peel, StopCriteria, peel};
use rayon::prelude::*;

pub(super) const TOPIC: Topic =
    Topic { name: "strip", about: "the peeling strip: collocation of the strong form, exact relations, limits", run };

const POINTS: &str = include_str!("../../../../../verification/strip_points.csv");
const PEAKS: &str = include_str!("../../../../../verification/strip_peaks.csv");

/// What a user gets who asks for nothing else.
const DEFAULT: Accuracy = Accuracy::to(1e-6);

fn run() -> Vec<Check> {
    let whole = Case::all(POINTS, |_| None);
    let mut checks = points::checks(&whole);
    checks.extend(steady::checks());
    checks.extend(peaks::checks());
    checks.extend(work::checks(&whole));
    checks
}

/// A row of a table and the crate's peel of its strip.
struct Case {
    row: Row,
    peel: Peel,
}

impl Case {
    /// Every row of a table, peeled at the default accuracy up to a displacement (nm) or to its end.
    fn all(table: &str, until: impl Fn(&Row) -> Option<f64> + Sync) -> Vec<Self> {
        let rows = reference::read(table);
        let peeled = |row: Row| {
            let bounds = StopCriteria { points: 20_000, displacement: until(&row), should_stop: None };
            Self { peel: peel(&strip_of(&row), &DEFAULT, &bounds), row }
        };
        let beam = |row: &Row| row.number("bending_stiffness_factor").is_some_and(f64::is_finite);
        rows.into_par_iter().filter(beam).map(peeled).collect()
    }

    fn load(&self) -> LineLoad {
        self.peel.model.adhesion.line_load
    }

    /// EI over that of the section.
    fn factor(&self) -> f64 {
        self.peel.model.material().bending_stiffness_factor
    }

    /// "full, EI × 0.01, L = 200 nm"
    fn name(&self) -> String {
        let load = self.row.text("line_load").unwrap_or("full");
        format!("{load}, EI × {}, L = {} nm", self.factor(), self.peel.model.length())
    }

    /// A check of `computed` against the number in `column`; none where the table has none and nothing was computed.
    fn against(&self, what: &str, column: &str, computed: Option<f64>, tolerance: f64) -> Option<Check> {
        let expected = self.row.number(column);
        if expected.is_none() && computed.is_none() {
            return None;
        }
        Some(check(
            format!("{what}, {}", self.name()),
            match self.row.text("shear_correction") {
                Some(_) => "verification/strip_peaks.py: collocation",
                None => "verification/strip_points.py: collocation",
            },
            computed.ok_or_else(|| missing(&self.peel.end)),
            expected.unwrap_or(f64::NAN),
            Measure::Relative,
            tolerance,
        ))
    }
}

/// The strip of a row, with numbers that are none where the row is not understood; one that is rigid in shear is nearly so.
fn strip_of(row: &Row) -> StripModel {
    let mut model = row.strip().unwrap_or_else(|| StripModel::of_the_paper(f64::NAN, f64::NAN));
    // the shear that is left changes the peak by about 0.3 (EI/EI0)^(1/2) / shear_correction
    let rigid = 1e7 * model.strip.bending_stiffness_factor.sqrt();
    model.strip.shear_correction = model.strip.shear_correction.min(rigid);
    model
}

fn check(
    name: impl Into<String>,
    source: impl Into<String>,
    computed: Result<f64, String>,
    expected: f64,
    measure: Measure,
    tolerance: f64,
) -> Check {
    Check::new(TOPIC.name, name, source, computed, expected, measure, tolerance)
}
