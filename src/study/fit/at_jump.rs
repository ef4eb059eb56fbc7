//! How the displacement of the first jump changes with the parameters.

use super::machine_curve::MachineCurve;
use crate::study::peel::result::Peel;
use crate::study::sensitivity::Variation;
use crate::study::sensitivity::error::NoSensitivities;
use crate::study::sensitivity::force::{ForceOnBranch, forces_on_branch};
use crate::study::sensitivity::quantity::PeelQuantity;
use crate::study::sensitivity::run::sensitivities;

/// dU*/dx of the first jump, a number a variation: 0 where the path ends without one. `compliance` is d(1/k)/dx.
///
/// U = u + P/k is largest there, so that only what U depends on directly counts: dU*/dx = P d(1/k)/dx + du/dx at held P. Of a rigid machine it
/// is that of the limit point; else du/dx = -(dP/dx at held u)/(dP/du), both at one solution, because a stiff machine jumps where both are large.
pub(super) fn jump_derivatives(
    peel: &Peel,
    curve: &MachineCurve,
    variations: &[Variation],
    compliance: &[f64],
) -> Result<Vec<f64>, NoSensitivities> {
    if !curve.end.jumps {
        return Ok(vec![0.0; variations.len()]);
    }
    if curve.compliance == 0.0 {
        let found = sensitivities(peel, &[PeelQuantity::FirstJumpDisplacement], variations)?;
        let own =
            |k: usize| found.of(PeelQuantity::FirstJumpDisplacement, k).map_or(0.0, |derivative| derivative.value);
        let changed = compliance.iter().map(|change| change * curve.end.at.force);
        return Ok(changed.enumerate().map(|(k, direct)| own(k) + direct).collect());
    }
    let at_end = forces_on_branch(peel, &[curve.last_grip()], variations)?;
    let one = |at: &ForceOnBranch| {
        let changes = at.derivatives.iter().zip(compliance);
        changes.map(|(force, change)| change * at.force - force / at.slope).collect()
    };
    Ok(at_end.first().map_or_else(Vec::new, one))
}
