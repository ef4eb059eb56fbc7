//! What is reported at each value, with its bounds.

use super::result::{FollowedPoint, FollowedRow, PointKind};
use super::strand::{Difference, Found, NEIGHBOURS, Strand};
use super::values::Sweep;
use crate::model::peel::{Form, PeelModel};
use crate::model::problem::build::Discretisation;
use crate::solve::path::equilibrium_path::Path;
use crate::study::accuracy::{Accuracy, ORDER, Resolution};
use crate::study::error_bounds::{FOLLOWED_BOUND_FACTOR, ROUND_OFF, ROUND_OFF_PLACE, TOLERANCE_FLOOR_FRACTION};
use crate::study::initial::prepared::prepared;

impl Sweep<'_> {
    /// The rows of a strand, each bounded by the checks around it.
    pub fn rows(&self, strand: &Strand) -> Vec<FollowedRow> {
        let row = |(i, found): (usize, &Found)| {
            let index = strand.first + i;
            let place = strand.checks.partition_point(|c| c.0 < index);
            let around = place.saturating_sub(NEIGHBOURS)..(place + NEIGHBOURS).min(strand.checks.len());
            let worst = strand.checks[around].iter().map(|c| c.1).reduce(Difference::max);
            FollowedRow {
                value: self.values[index],
                point: worst.map(|difference| self.point(index, found, difference)),
                newton_iterations: found.iterations,
                elements: found.elements,
            }
        };
        strand.found.iter().enumerate().map(row).collect()
    }

    fn point(&self, index: usize, found: &Found, difference: Difference) -> FollowedPoint {
        let model = (self.model)(self.values[index]);
        let law = model.line_law();
        let o = &found.observables;
        let place = if self.kind == PointKind::InitiationPeak { ROUND_OFF_PLACE } else { ROUND_OFF };
        let floor = TOLERANCE_FLOOR_FRACTION * self.accuracy.relative;
        FollowedPoint {
            displacement: o.displacement,
            force: o.force,
            end_rotation: o.recorded,
            work: law.has_potential().then(|| Some(found.energy - energy_at_rest(&model)?)).flatten(),
            displacement_error: (FOLLOWED_BOUND_FACTOR * difference.displacement + place + floor)
                * o.displacement.abs(),
            force_error: (FOLLOWED_BOUND_FACTOR * difference.force + ROUND_OFF + floor) * o.force.abs(),
        }
    }
}

/// Stored and adhesion energy where the path begins, aJ.
fn energy_at_rest(model: &PeelModel) -> Option<f64> {
    if let Some(strip) = model.strip().filter(|_| model.space.is_none()) {
        return Some(strip.width * model.line_law().rest_energy() * strip.length);
    }
    let how = Discretisation::moving(Form::TwoField, ORDER);
    let problem = prepared(model, how, None).ok()?.problem;
    let accuracy = Accuracy::to(1e-8);
    let options = Resolution::first(model, &accuracy).path_options(model, accuracy.relative);
    let first = Path::new(&problem, options).advance().ok()?;
    Some(problem.energy(&first.at, first.energy))
}
