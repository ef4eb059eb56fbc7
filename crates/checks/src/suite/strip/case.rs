//! A strip of a table, peeled.

use crate::check::{Check, Measure, missing};
use crate::suite::reference;
use crate::suite::reference::Row;
use peelkit::adhesion::LineLoad;
use peelkit::model::StripModel;
use peelkit::study::{Accuracy, Peel, StopCriteria, peel};
use rayon::prelude::*;

/// What a user gets who asks for nothing else.
pub(super) const DEFAULT: Accuracy = Accuracy::to(1e-6);

/// A row of a table and the crate's peel of its strip.
pub(super) struct Case {
    pub row: Row,
    pub peel: Peel,
}

impl Case {
    /// Every row of a table, peeled at the default accuracy up to a displacement (nm) or to its end.
    pub fn all(table: &str, until: impl Fn(&Row) -> Option<f64> + Sync) -> Vec<Self> {
        let rows = reference::read(table);
        let peeled = |row: Row| {
            let bounds = StopCriteria { displacement: until(&row), ..StopCriteria::after_points(20_000) };
            Self { peel: peel(&strip_of(&row), &DEFAULT, &bounds), row }
        };
        let beam = |row: &Row| row.number("bending_stiffness_factor").is_some_and(f64::is_finite);
        rows.into_par_iter().filter(beam).map(peeled).collect()
    }

    pub fn load(&self) -> LineLoad {
        self.peel.model.adhesion.line_load
    }

    /// EI over that of the section.
    pub fn factor(&self) -> f64 {
        self.peel.model.material().bending_stiffness_factor
    }

    /// "full, EI × 0.01, L = 200 nm"
    pub fn name(&self) -> String {
        let load = self.row.text("line_load").unwrap_or("full");
        format!("{load}, EI × {}, L = {} nm", self.factor(), self.peel.model.length())
    }

    /// A check of `computed` against the number in `column`; none where the table has none and nothing was computed.
    pub fn against(&self, what: &str, column: &str, computed: Option<f64>, tolerance: f64) -> Option<Check> {
        let expected = self.row.number(column);
        if expected.is_none() && computed.is_none() {
            return None;
        }
        Some(Check::new(
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
    let rigid = 1e7 * model.strip.material.bending_stiffness_factor.sqrt();
    model.strip.material.shear_correction = model.strip.material.shear_correction.min(rigid);
    model
}
