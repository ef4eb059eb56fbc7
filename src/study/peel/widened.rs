//! Bounds of what cannot be known better.

use super::result::Peel;
use crate::study::accuracy::Accuracy;

/// With no bound below a share of its number, where there is one.
pub(super) fn widened(mut peel: Peel, accuracy: &Accuracy, least: Option<f64>) -> Peel {
    peel.asked = accuracy.relative;
    let Peel { limit_points, initiation_peak, peak, snap_off, pad_detachment, detachment, plateau, .. } = &mut peel;
    if let Some(share) = least {
        for point in limit_points.iter_mut().chain(snap_off).chain(pad_detachment).chain(detachment) {
            point.force_error = point.force_error.max(share * point.force.abs());
            point.displacement_error = point.displacement_error.max(share * point.displacement.abs());
            point.work_error = point.work_error.map(|error| error.max(share * point.work.abs()));
        }
        if let Some(plateau) = plateau {
            plateau.force_error = plateau.force_error.map(|error| error.max(share * plateau.force));
        }
        for peak in initiation_peak.iter_mut().chain(peak) {
            peak.force_error = peak.force_error.max(share * peak.force.abs());
            peak.displacement_error = peak.displacement_error.max(share * peak.displacement.abs());
        }
    }
    peel
}
