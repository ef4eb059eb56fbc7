//! The numbers of one sample's peel.

use crate::model::peel::PeelModel;
use crate::study::accuracy::Accuracy;
use crate::study::limit_point_continuation::result::{FollowedPoint, PointKind, Remark, Spacing};
use crate::study::limit_point_continuation::sweep::follow_point;
use crate::study::peel::result::{PathEnd, Peel};
use crate::study::peeling::peel;
use crate::study::sensitivity::quantity::PeelQuantity;
use crate::study::stop_criteria::StopCriteria;
use serde::{Deserialize, Serialize};

/// What one sample gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// The numbers that were asked for; none where the path does not have one, or was not computed as far
    pub values: Vec<Option<f64>>,
    /// Why its path was not computed to its end, if it was not
    pub cut_short: Option<String>,
}

impl Outcome {
    /// Of a model that there is not, and why.
    pub fn refused(numbers: usize, why: String) -> Self {
        Self { values: vec![None; numbers], cut_short: Some(why) }
    }
}

/// These numbers of a model's peel. Where they are of the initiation peak alone, no more of the path is followed than leads there. `stop` gives the
/// stop criteria of one path, anew for each.
pub fn peel_numbers(
    model: &PeelModel,
    of: &[PeelQuantity],
    accuracy: &Accuracy,
    stop: &dyn Fn() -> StopCriteria,
) -> Outcome {
    let of_initiation =
        |quantity| matches!(quantity, PeelQuantity::InitiationPeakForce | PeelQuantity::InitiationPeakDisplacement);
    if of.iter().all(|&quantity| of_initiation(quantity)) && can_be_followed(model) {
        initiation_peak(model, of, accuracy, stop)
    } else {
        whole(&peel(model, accuracy, &stop()), of)
    }
}

/// Whether the initiation peak can be had without the path behind it.
fn can_be_followed(model: &PeelModel) -> bool {
    model.friction_law().is_none() && model.ground.substrate.is_flat() && model.steps.is_empty()
}

fn whole(peel: &Peel, of: &[PeelQuantity]) -> Outcome {
    let cut_short = match &peel.end {
        PathEnd::Failed(failure) => Some(failure.to_string()),
        PathEnd::Bound(bound) => Some(bound.to_string()),
        _ => None,
    };
    Outcome { values: of.iter().map(|quantity| quantity.value(peel)).collect(), cut_short }
}

fn initiation_peak(
    model: &PeelModel,
    of: &[PeelQuantity],
    accuracy: &Accuracy,
    stop: &dyn Fn() -> StopCriteria,
) -> Outcome {
    let here = |_| model.clone();
    let found = follow_point(PointKind::InitiationPeak, &[0.0], Spacing::Linear, &here, accuracy, stop, &|_| {});
    let point = found.rows.first().and_then(|row| row.point);
    let cut_short = found.remarks.iter().find_map(|remark| match remark {
        Remark::NotFound { reason, .. } => Some(reason.to_string()),
        _ => None,
    });
    let value = |quantity: &PeelQuantity| {
        point.map(|FollowedPoint { force, displacement, .. }| match quantity {
            PeelQuantity::InitiationPeakForce => force,
            _ => displacement,
        })
    };
    Outcome { values: of.iter().map(value).collect(), cut_short }
}
