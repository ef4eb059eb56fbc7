//! Thick and thin limits: the error of a mesh of few elements does not depend on the slenderness.

use super::end_force::{cantilever_of, table};
use super::rods::{FORCE, tip, under_control};
use crate::suite::check::{Check, Measure};

/// Order and number of elements of each mesh.
const MESHES: [(usize, usize); 3] = [(1, 8), (2, 4), (3, 2)];

/// A mesh that locks errs by a factor of about (L/h)² more. Where the beam is as high as long, shear adds to the tip's path
/// what every mesh gets right, so that the error is smaller;
/// at slenderness 10 that fraction is still a hundredth.
pub(super) fn checks() -> Vec<Check> {
    let rows = table();
    let rods: Vec<_> = rows.iter().filter(|row| row.text("case") == Some("slenderness")).collect();
    let mut checks = Vec::new();
    for (order, elements) in MESHES {
        let errors: Vec<Result<f64, String>> = rods
            .iter()
            .map(|row| {
                let (rod, load) = cantilever_of(row);
                let found = under_control(&rod, order, elements, FORCE, &[load])?;
                let expected = row.number("tip_y").ok_or("the table has no tip_y")?;
                Ok((tip(&found[0])[1] / expected - 1.0).abs())
            })
            .collect();
        let Some(Ok(usual)) = errors.get(2).cloned() else { continue };
        for (k, error) in errors.into_iter().enumerate() {
            checks.push(Check::new(
                format!(
                    "relative error of tip y, slenderness 1e{k}, {elements} elements of order {order}, P L²/EI = 1, over \
                     that at slenderness 100"
                ),
                "1: no locking (exact values: verification/cantilever.py, shooting)",
                error.map(|error| error / usual),
                1.0,
                if k == 0 { Measure::AtMost } else { Measure::Relative },
                if k < 2 { 0.02 } else { 1e-3 },
            ));
        }
    }
    checks
}
