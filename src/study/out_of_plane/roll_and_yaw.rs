//! The roll and the turn about the normal together, where there is a force along the strip: the inertia of their matrix.
//!
//! Elements and elimination are those of the roll alone, with two unknowns for each function: ω_y and then ω_x. The turn about the normal is
//! held at the left end, as it is of a beam in space. So the last pivot is again the moment about the axis that rolls the grip by one, all
//! else in equilibrium.

use super::roll_elements::{RollElements, RollStability, eliminate};
use super::roll_section::CoupledDensity;

/// Unknowns of a function, and of the two ends of an element.
const FIELDS: usize = 2;
const OF_ENDS: usize = 2 * FIELDS;
/// Where ω_y and ω_x stand in a [`CoupledDensity`], each with its slope behind it.
const PLACES: [usize; FIELDS] = [2, 0];

impl RollElements {
    /// The inertia of elements with these ends, whose densities are given place by place. Nothing where a number is not finite.
    pub(crate) fn coupled_stability(
        &self,
        ends: &[f64],
        densities: impl Iterator<Item = CoupledDensity>,
    ) -> Option<RollStability> {
        let mut densities = densities;
        let size = FIELDS * self.points.first()?.functions.len();
        let mut matrix = vec![0.0; size * size];
        let (mut negative, mut carried) = (0, [0.0; OF_ENDS * OF_ENDS]);
        for (element, pair) in ends.windows(2).enumerate() {
            self.assemble_coupled(&mut matrix, pair[1] - pair[0], &mut densities)?;
            let inner = size - OF_ENDS;
            if element == 0 {
                hold(&mut matrix, size, inner);
            }
            negative += eliminate(&mut matrix, size, inner);
            let before = carried;
            for i in 0..OF_ENDS {
                for j in 0..=i {
                    let left = if i < FIELDS { before[(i + FIELDS) * OF_ENDS + j + FIELDS] } else { 0.0 };
                    carried[i * OF_ENDS + j] = matrix[(inner + i) * size + inner + j] + left;
                }
            }
            negative += eliminate(&mut carried, OF_ENDS, FIELDS);
        }
        let [yaw, mixed, roll] = [(2, 2), (3, 2), (3, 3)].map(|(i, j)| carried[i * OF_ENDS + j]);
        let grip_stiffness = roll - mixed * mixed / yaw;
        negative += usize::from(yaw < 0.0) + usize::from(grip_stiffness < 0.0);
        (!grip_stiffness.is_nan()).then_some(RollStability { negative, grip_stiffness })
    }

    /// The lower half of the matrix of an element of this length, nm.
    fn assemble_coupled(
        &self,
        matrix: &mut [f64],
        length: f64,
        densities: &mut impl Iterator<Item = CoupledDensity>,
    ) -> Option<()> {
        matrix.fill(0.0);
        let size = FIELDS * self.points.first()?.functions.len();
        for point in &self.points {
            let density = densities.next()?;
            let weight = 0.5 * length * point.weight;
            // value and slope of an unknown among the four numbers of the density
            let forms: Vec<(usize, [f64; 2])> = (0..size)
                .map(|unknown| {
                    let [value, slope] = point.functions[unknown / FIELDS];
                    (PLACES[unknown % FIELDS], [value, slope * 2.0 / length])
                })
                .collect();
            for i in 0..size {
                let (a, one) = forms[i];
                let by: [f64; OF_ENDS] =
                    std::array::from_fn(|k| weight * (one[0] * density[a][k] + one[1] * density[a + 1][k]));
                for j in 0..=i {
                    let (b, other) = forms[j];
                    matrix[i * size + j] += by[b] * other[0] + by[b + 1] * other[1];
                }
            }
        }
        Some(())
    }
}

/// Holds an unknown: what is left of it is a pivot of one.
fn hold(matrix: &mut [f64], size: usize, unknown: usize) {
    for j in 0..unknown {
        matrix[unknown * size + j] = 0.0;
    }
    for i in unknown + 1..size {
        matrix[i * size + unknown] = 0.0;
    }
    matrix[unknown * size + unknown] = 1.0;
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;
    use std::num::NonZeroUsize;

    fn uniform(elements: usize, length: f64, density: CoupledDensity) -> RollStability {
        let ends: Vec<f64> = (0..=elements).map(|k| length * k as f64 / elements as f64).collect();
        let rolls = RollElements::new(NonZeroUsize::new(8).unwrap());
        rolls.coupled_stability(&ends, std::iter::repeat(density)).unwrap()
    }

    /// ½ ∫ EI3 ω_y'² + H ω_y² with ω_y held at the left end and free at the right one: a column that is pushed by -H has as many modes as
    /// (2n - 1)² π²/4 EI3/L² lie below that. The roll, on its own, is a bar on a bed, k > 0.
    #[test]
    fn a_column_that_is_pushed_bends_sideways_at_the_loads_of_euler() {
        let (bending, torsion, length, support) = (3.0, 2.0, 7.0, 0.4);
        for waves in [0.2, 0.45, 0.55, 1.4, 1.6, 2.6] {
            let force = -bending * (waves * PI / length).powi(2);
            let mut density = [[0.0; 4]; 4];
            (density[0][0], density[1][1], density[2][2], density[3][3]) = (support, torsion, force, bending);
            let found = uniform(5, length, density);
            assert_eq!(found.negative, (waves + 0.5) as usize, "{waves} half waves");
            let rolled = (support * torsion).sqrt() * (length * (support / torsion).sqrt()).tanh();
            assert_relative_eq!(found.grip_stiffness, rolled, max_relative = 1e-9);
        }
    }
}
