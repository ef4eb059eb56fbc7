//! A field of displacements as unknowns of a strip: of a state on another mesh, or given as a function of the place.
//!
//! Each unknown is a functional of the field that is one of its own shape function and zero of all others of the element: a value or a slope at
//! a vertex, and for an integrated Legendre polynomial the integral of its slope times that of the field. What a finer mesh of the same kind, or
//! one of a higher order, is given is the field itself; of an enriched edge that is so on the edge alone, since half of its row is bilinear above.

use super::basis::{Factor, Shape};
use super::strip::{Field, SolidStrip};
use super::tables::gauss;
use crate::solve::state::State;
use crate::solve::system::System;

/// Points of the integrals.
const POINTS: usize = 10;

/// A place in [-1, 1] with its weight; and whether the slope of the field counts there in place of its value.
type Look = (f64, f64, bool);

/// Where the functional of a factor looks, and with what weights; none of an incompatible mode.
fn looks(factor: Factor) -> Option<Vec<Look>> {
    match factor {
        Factor::One => None,
        Factor::First | Factor::HermiteFirst => Some(vec![(-1.0, 1.0, false)]),
        Factor::Second | Factor::HermiteSecond => Some(vec![(1.0, 1.0, false)]),
        Factor::SlopeFirst => Some(vec![(-1.0, 1.0, true)]),
        Factor::SlopeSecond => Some(vec![(1.0, 1.0, true)]),
        Factor::Bubble(_) => Some(gauss(POINTS).into_iter().map(|(t, w)| (t, w * factor.at(t)[1], true)).collect()),
    }
}

impl SolidStrip {
    /// The state that has the displacements of one of another strip of the same length and height, as far as this one can have them.
    pub(crate) fn state_of(&self, other: &Self, at: &State) -> State {
        let all = other.displacements(&at.values);
        let values = self.interpolated(|place, height| other.field_at(&all, place, height, false));
        State { values, force: at.force, ..System::stress_free(self, self.mesh.columns()) }
    }

    /// Unknowns of a field of displacements by S and the height over the contact face.
    pub(crate) fn interpolated(&self, field: impl Fn(f64, f64) -> Field) -> Vec<f64> {
        let mut all = vec![0.0; 2 * self.layout.functions()];
        for column in 0..self.mesh.columns() {
            for row in 0..self.mesh.rows() {
                for shape in &self.rows[row].shapes {
                    let first = 2 * self.layout.function(column, row, shape.place);
                    let found = self.functional(&field, (column, row), shape);
                    all[first..first + 2].copy_from_slice(&found);
                }
            }
        }
        let inside = self.inside();
        let grip = self.grip.nearest(&all[inside..]);
        all.truncate(inside);
        all.extend(grip);
        all
    }

    fn functional(&self, field: &impl Fn(f64, f64) -> Field, (column, row): (usize, usize), shape: &Shape) -> [f64; 2] {
        let (length, height) = (self.mesh.length_of(column), self.mesh.height_of(row));
        let (left, low) = (self.mesh.lines[column], self.mesh.heights[row]);
        let (Some(along), Some(through)) = (looks(shape.along), looks(shape.through)) else { return [0.0; 2] };
        // of a slope unknown u,S itself, of an integral the slope by the coordinate of the element
        let by_xi = if shape.is_slope() { 1.0 } else { 0.5 * length };
        let mut found = [0.0; 2];
        for &(xi, weight, slope_along) in &along {
            for &(eta, other, slope_through) in &through {
                let here = field(left + 0.5 * length * (1.0 + xi), low + 0.5 * height * (1.0 + eta));
                let value = match (slope_along, slope_through) {
                    (false, false) => here.displacement,
                    (true, false) => here.along.map(|slope| by_xi * slope),
                    (false, true) => here.through.map(|slope| 0.5 * height * slope),
                    (true, true) => here.mixed.map(|slope| by_xi * 0.5 * height * slope),
                };
                (0..2).for_each(|i| found[i] += weight * other * value[i]);
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::super::basis::SolidElement;
    use super::super::contact::SolidContact;
    use super::super::grip::{GripDrive, SolidGrip};
    use super::super::material::{Plane, SolidMaterial};
    use super::super::mesh::Grading;
    use super::super::strip::{SolidStrip, StripDesign};
    use super::*;
    use crate::adhesion::levels::half_space::HalfSpace;
    use crate::beam::section::Material;
    use approx::assert_abs_diff_eq;

    /// A strip of 6 x 4 nm that adheres next to nothing.
    fn strip(element: SolidElement, grip: SolidGrip, along: f64, through: usize) -> SolidStrip {
        let design = StripDesign {
            length: 6.0,
            height: 4.0,
            width: 1.5,
            material: Material::of(2.0, 0.3),
            energy: SolidMaterial::NeoHookean,
            plane: Plane::Stress,
            ground: HalfSpace { hamaker_constant: 1e-25, equilibrium_distance: 0.4 },
            contact: SolidContact::ReferenceTraction,
            far_face: false,
            grip,
            element,
            modes: true,
            along,
            through,
            grading: Grading::Grip { levels: 1, ratio: 0.4 },
        };
        SolidStrip::new(design, GripDrive::UP)
    }

    fn all(along: f64, through: usize) -> impl Iterator<Item = (SolidElement, SolidStrip)> {
        ["Q1C1", "Q1C3", "Q1CH", "H1(2)", "Q(3,2)"].into_iter().flat_map(move |name| {
            let element = SolidElement::named(name).unwrap();
            [SolidGrip::Rigid, SolidGrip::Parabolic].map(|grip| (element, strip(element, grip, along, through)))
        })
    }

    fn linear([a, b, c, d]: [f64; 4]) -> impl Fn(f64, f64) -> Field {
        move |place, height| Field {
            displacement: [a * place + b * height, c * place + d * height],
            along: [a, c],
            through: [b, d],
            mixed: [0.0; 2],
        }
    }

    /// A patch: of a uniform strain the stress is the same everywhere, and nothing but the outline is loaded.
    #[test]
    fn a_uniform_strain_loads_nothing_inside() {
        let f = [0.011, -0.023, 0.017, -0.008];
        for (element, strip) in all(2.0, 3) {
            let values = strip.interpolated(linear(f));
            let all = strip.displacements(&values);
            let last = strip.mesh.columns() - 1;
            let mut residual = vec![0.0; all.len()];
            let mut on_outline = vec![false; all.len()];
            let mut work = super::super::strip::ElementWork::default();
            for column in 0..last {
                for row in 0..strip.mesh.rows() {
                    strip.element_at(&all, (column, row), false, &mut work);
                    for (k, shape) in strip.rows[row].shapes.iter().enumerate() {
                        let first = 2 * strip.layout.function(column, row, shape.place);
                        (0..2).for_each(|i| residual[first + i] += work.residual[2 * k + i]);
                        let [left, right] = [-1.0, 1.0].map(|end| shape.along.at(end) != [0.0; 2]);
                        let [low, high] = [-1.0, 1.0].map(|end| shape.through.at(end)[0] != 0.0);
                        let outer = left && column == 0
                            || right && column + 1 == last
                            || low && row == 0
                            || high && row + 1 == strip.mesh.rows();
                        (0..2).for_each(|i| on_outline[first + i] |= outer);
                    }
                }
            }
            let start = 2 * strip.layout.line_start(last);
            let inside: Vec<usize> = (0..start).filter(|&k| !on_outline[k]).collect();
            assert!(inside.len() > 3, "{element}");
            inside.into_iter().for_each(|k| assert_abs_diff_eq!(residual[k], 0.0, epsilon = 1e-15));
            let stress = strip.stress_at(&values, 1.0, 0.7);
            for (place, height) in [(0.3, 0.0), (2.1, 2.9), (3.9, 4.0)] {
                let found = strip.stress_at(&values, place, height);
                (0..3).for_each(|k| assert_abs_diff_eq!(found[k], stress[k], epsilon = 1e-14));
            }
        }
    }

    /// Turned as a rigid body, slopes turn with it, and there is neither energy nor a force.
    #[test]
    fn a_rotation_is_without_strain() {
        let (sin, cos) = 0.3f64.sin_cos();
        for (element, strip) in all(2.0, 2) {
            let values = strip.interpolated(linear([cos - 1.0, -sin, sin, cos - 1.0]));
            let at = State { values, ..System::stress_free(&strip, 1) };
            let energy = System::evaluate(&strip, &at, &at.values).0.energy;
            assert_abs_diff_eq!(energy, 0.0, epsilon = 1e-14);
            let residual = System::residual(&strip, &at);
            let largest = residual.iter().fold(0.0f64, |most, value| most.max(value.abs()));
            assert!(largest < 1e-14, "{element}: {largest:.2e}");
            assert_abs_diff_eq!(strip.end_rotation(&strip.displacements(&at.values)), 0.3, epsilon = 1e-14);
        }
    }

    /// On a finer mesh a state is the same field: of an enriched edge there, where it is enriched, of other elements everywhere.
    #[test]
    fn a_state_is_the_same_on_a_finer_mesh() {
        for (element, coarse) in all(3.0, 2) {
            let fine = coarse.refined();
            let mut at = System::stress_free(&coarse, 1);
            for (k, value) in at.values.iter_mut().enumerate() {
                *value = 0.02 * ((37 * k + 5) as f64).sin();
            }
            let moved = fine.state_of(&coarse, &at);
            let is_enriched = element.is_bilinear_inside() && element.order_along(true) > 1;
            for (place, height) in [(0.4, 0.1), (2.7, 3.3), (3.3, 1.9)] {
                let height = if is_enriched { 0.0 } else { height };
                let [a, b] = [
                    coarse.displacement_at(&at.values, place, height),
                    fine.displacement_at(&moved.values, place, height),
                ];
                (0..2).for_each(|i| assert_abs_diff_eq!(a[i], b[i], epsilon = 1e-14));
            }
        }
    }
}
