//! The values of a sweep, with the model at each and what the path from rest has there.

use super::failure::PointNotFound;
use super::initial_limit_point::initial_limit_point;
use super::result::{PointKind, Spacing};
use crate::model::check::error::ModelError;
use crate::model::peel::PeelModel;
use crate::solve::points::locate::Located;
use crate::study::accuracy::Accuracy;
use crate::study::peeling::checked;
use crate::study::stop_criteria::StopCriteria;

/// Parts of the sweep at whose ends the point is held against the path from rest.
const PARTS: usize = 4;

/// What is followed, over which values, and how well.
pub(super) struct Sweep<'a> {
    pub kind: PointKind,
    pub values: &'a [f64],
    pub spacing: Spacing,
    pub model: &'a dyn Fn(f64) -> PeelModel,
    pub at_coordinate: &'a dyn Fn(f64) -> PeelModel,
    pub accuracy: &'a Accuracy,
    pub stop: &'a dyn Fn() -> StopCriteria,
    pub solved: &'a dyn Fn(usize),
}

impl Sweep<'_> {
    pub fn coordinate(&self, index: usize) -> f64 {
        self.spacing.coordinate(self.values[index])
    }

    /// Whether the model at a value can be computed.
    pub fn check(&self, index: usize) -> Result<(), ModelError> {
        checked(&(self.model)(self.values[index]), self.accuracy)
    }

    /// The point where the path from rest has it at a value.
    pub fn initial_limit_point_of(&self, index: usize) -> Result<Option<Located>, PointNotFound> {
        initial_limit_point(&(self.model)(self.values[index]), self.kind, self.accuracy, &(self.stop)())
    }

    /// Whether the point is held against the path from rest at this value.
    pub fn is_milestone(&self, index: usize) -> bool {
        let last = self.values.len() - 1;
        index == last || index.is_multiple_of(last.div_ceil(PARTS).max(1))
    }
}
