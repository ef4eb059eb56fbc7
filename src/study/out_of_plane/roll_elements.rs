//! Finite elements for the roll, and the inertia of their matrix.
//!
//! On each element of the beam's mesh φ is a polynomial: two functions that are one at an end, and bubbles, integrals
//! of Legendre polynomials. The bubbles are eliminated element by element, the ends from left to right. The signs of
//! the pivots are those of the eigenvalues (Sylvester's law of inertia); the last pivot is the moment about the axis
//! that rolls the grip by one.

use super::roll_section::{RollDensity, RollSection};
use crate::adhesion::section::line_load::LineLaw;
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::section::Material;
use crate::beam::torsion::LateralStiffness;
use crate::model::peel::{Hold, PeelModel};
use crate::number::gauss::gauss_legendre;
use crate::solve::problem::Direction;
use crate::solve::state::State;
use std::num::NonZeroUsize;

/// A place of the rule: local coordinate in [-1, 1], weight, and each function with its slope there.
pub(super) struct RulePoint {
    pub local: f64,
    pub weight: f64,
    pub functions: Vec<[f64; 2]>,
}

/// Elements of one degree.
pub(super) struct RollElements {
    pub points: Vec<RulePoint>,
}

/// What the elimination of a roll found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RollStability {
    /// Negative eigenvalues
    pub negative: usize,
    /// The last pivot: the moment that rolls the grip by one, all else in equilibrium, nN nm
    pub grip_stiffness: f64,
}

impl RollStability {
    /// A number that falls through zero, continuously, where the first eigenvalue does: the stiffness of the grip, and
    /// where modes are unstable with the grip held as well, less than any.
    pub(crate) fn margin(&self) -> f64 {
        let held = self.negative - usize::from(self.grip_stiffness < 0.0);
        if held == 0 { self.grip_stiffness } else { f64::NEG_INFINITY }
    }
}

impl RollElements {
    /// Of a degree, with a point more than that.
    pub(crate) fn new(degree: NonZeroUsize) -> Self {
        let rule = gauss_legendre(degree.saturating_add(1));
        let points = rule.into_iter().map(|(local, weight)| RulePoint {
            local,
            weight,
            functions: functions(degree.get(), local),
        });
        Self { points: points.collect() }
    }

    /// Local coordinates of the rule on an element, in [-1, 1].
    pub(crate) fn places(&self) -> impl Iterator<Item = f64> + '_ {
        self.points.iter().map(|point| point.local)
    }

    /// How many there are.
    pub(crate) fn places_of_element(&self) -> usize {
        self.points.len()
    }

    /// The inertia of elements with these ends, whose densities are given place by place. Nothing where a number is not
    /// finite.
    pub(crate) fn stability(
        &self,
        ends: &[f64],
        densities: impl Iterator<Item = RollDensity>,
    ) -> Option<RollStability> {
        let mut densities = densities;
        let size = self.points.first()?.functions.len();
        let mut matrix = vec![0.0; size * size];
        let mut found = RollStability { negative: 0, grip_stiffness: 0.0 };
        for pair in ends.windows(2) {
            self.assemble(&mut matrix, pair[1] - pair[0], &mut densities)?;
            found.negative += eliminate(&mut matrix, size, size - 2);
            // the last two are the ends
            let [left, mixed, right] =
                [(size - 2, size - 2), (size - 1, size - 2), (size - 1, size - 1)].map(|(i, j)| matrix[i * size + j]);
            let pivot = found.grip_stiffness + left;
            found.negative += usize::from(pivot < 0.0);
            found.grip_stiffness = right - mixed * mixed / pivot;
        }
        found.negative += usize::from(found.grip_stiffness < 0.0);
        (!found.grip_stiffness.is_nan()).then_some(found)
    }

    /// The lower half of the matrix of an element of this length, nm.
    fn assemble(
        &self,
        matrix: &mut [f64],
        length: f64,
        densities: &mut impl Iterator<Item = RollDensity>,
    ) -> Option<()> {
        matrix.fill(0.0);
        let size = self.points.first()?.functions.len();
        let mut strains = vec![0.0; size];
        for point in &self.points {
            let RollDensity { stiffness, drift, support } = densities.next()?;
            let weight = 0.5 * length * point.weight;
            for (strain, [value, slope]) in strains.iter_mut().zip(&point.functions) {
                *strain = slope * 2.0 / length - drift * value;
            }
            for i in 0..size {
                let (by_strain, by_value) = (weight * stiffness * strains[i], weight * support * point.functions[i][0]);
                for j in 0..=i {
                    matrix[i * size + j] += by_strain * strains[j] + by_value * point.functions[j][0];
                }
            }
        }
        Some(())
    }
}

/// Eliminates the first unknowns, so many, from a symmetric matrix of which the lower half is given: how many pivots
/// are negative.
pub(super) fn eliminate(matrix: &mut [f64], size: usize, first: usize) -> usize {
    let mut negative = 0;
    for k in 0..first {
        let pivot = matrix[k * size + k];
        negative += usize::from(pivot < 0.0);
        for i in k + 1..size {
            let factor = matrix[i * size + k] / pivot;
            for j in k + 1..=i {
                matrix[i * size + j] -= factor * matrix[j * size + k];
            }
        }
    }
    negative
}

/// The functions of a degree with their slopes at a local coordinate: bubbles (P_k - P_(k-2))/(2k - 1), whose slope is
/// P_(k-1), then the two that are one at an end.
fn functions(degree: usize, local: f64) -> Vec<[f64; 2]> {
    let mut legendre = vec![1.0, local];
    for k in 2..=degree {
        let n = k as f64;
        legendre.push(((2.0 * n - 1.0) * local * legendre[k - 1] - (n - 1.0) * legendre[k - 2]) / n);
    }
    let bubble = |k: usize| [(legendre[k] - legendre[k - 2]) / (2 * k - 1) as f64, legendre[k - 1]];
    let ends = [[0.5 * (1.0 - local), -0.5], [0.5 * (1.0 + local), 0.5]];
    (2..=degree).map(bubble).chain(ends).collect()
}

// -- The roll of a beam in a planar equilibrium --

/// What the roll of all equilibria of one peel is computed with.
pub(super) struct RollReader<'p> {
    model: &'p PeelModel,
    beam: &'p PlanarBeam,
    law: LineLaw,
    material: Material,
    elements: RollElements,
}

/// A beam in a planar equilibrium as its roll sees it, at the points of the rule of every element.
pub(super) struct RollingBeam {
    ends: Vec<f64>,
    sections: Vec<RollSection>,
}

impl<'p> RollReader<'p> {
    /// With a degree more than the planar elements have.
    pub(crate) fn new(model: &'p PeelModel, beam: &'p PlanarBeam) -> Self {
        let degree = NonZeroUsize::MIN.saturating_add(beam.chain.order());
        let elements = RollElements::new(degree);
        Self { model, beam, law: model.line_law(), material: model.material(), elements }
    }

    /// The stability of an equilibrium. Nothing where a number is not finite.
    pub(crate) fn stability(&self, at: &State) -> Option<RollStability> {
        self.stability_of(&self.rolling(at))
    }

    /// The same of what was read before.
    pub(crate) fn stability_of(&self, beam: &RollingBeam) -> Option<RollStability> {
        self.stability_of_sections(&beam.ends, beam.sections.iter().copied())
    }

    /// The same where a straight beam of one section is of another width, nm.
    pub(crate) fn stability_of_width(&self, beam: &RollingBeam, width: f64) -> Option<RollStability> {
        let outline = self.model.body.geometry().at(0.0);
        let lateral = LateralStiffness::of(&self.material, width, outline.height[0], outline.roundness);
        self.stability_of_sections(&beam.ends, beam.sections.iter().map(|section| section.widened(width, lateral)))
    }

    /// Without a force along the strip the roll alone is left, with one the turn about the normal as well.
    fn stability_of_sections(
        &self,
        ends: &[f64],
        sections: impl Iterator<Item = RollSection>,
    ) -> Option<RollStability> {
        if self.model.pull.direction() == Direction::UP && self.model.grip.horizontal == Hold::Free {
            self.elements.stability(ends, sections.map(|section| section.density()))
        } else {
            self.elements.coupled_stability(ends, sections.map(|section| section.coupled()))
        }
    }

    /// The sections of an equilibrium.
    pub(crate) fn rolling(&self, at: &State) -> RollingBeam {
        let beam = self.beam;
        let configuration = beam.configuration(at);
        let mut sections = Vec::with_capacity(at.mesh.elements() * self.elements.places_of_element());
        for (element, pair) in at.mesh.boundaries.windows(2).enumerate() {
            for local in self.elements.places() {
                let (values, state) = beam.chain.sample(configuration, element, local);
                let outline = self.model.body.geometry().at(pair[0] + 0.5 * (1.0 + local) * (pair[1] - pair[0]));
                let (sin, cos) = values[beam.rotation].sin_cos();
                let adhesion = self.law.response_of(outline.height[0], values[beam.rotation - 1], sin, cos);
                sections.push(RollSection::new(&self.material, &outline, &state, [sin, cos], &adhesion));
            }
        }
        RollingBeam { ends: at.mesh.boundaries.clone(), sections }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    fn of_degree(degree: usize) -> RollElements {
        RollElements::new(NonZeroUsize::new(degree).unwrap())
    }

    fn uniform(degree: usize, elements: usize, length: f64, density: RollDensity) -> RollStability {
        let ends: Vec<f64> = (0..=elements).map(|k| length * k as f64 / elements as f64).collect();
        of_degree(degree).stability(&ends, std::iter::repeat(density)).unwrap()
    }

    /// ½ ∫ GJ φ'² - k φ² with free ends has an eigenvalue (nπ/L)² GJ - k for n = 0, 1, 2, ...; the grip's stiffness is
    /// -(k GJ)^(1/2) tan(L (k/GJ)^(1/2)).
    #[test]
    fn a_bar_on_a_repelling_bed_has_as_many_modes_as_half_waves() {
        let (stiffness, length) = (3.0, 7.0);
        for waves in [0.1, 0.4, 0.6, 1.3, 2.7, 3.4] {
            let support = -stiffness * (waves * PI / length).powi(2);
            let found = uniform(8, 5, length, RollDensity { stiffness, drift: 0.0, support });
            assert_eq!(found.negative, waves.ceil() as usize, "{waves} half waves");
            let exact = -(-support * stiffness).sqrt() * (waves * PI).tan();
            assert_relative_eq!(found.grip_stiffness, exact, max_relative = 1e-9);
            assert_eq!(found.margin() == f64::NEG_INFINITY, waves > 0.5);
        }
    }

    /// φ = exp(βS) has no strain: with κ = 0 the grip rolls freely. A drift of any size changes nothing about that.
    #[test]
    fn a_drift_alone_stores_nothing() {
        let found = uniform(8, 4, 3.0, RollDensity { stiffness: 2.0, drift: 0.7, support: 0.0 });
        assert!(found.grip_stiffness.abs() < 1e-10, "{}", found.grip_stiffness);
    }

    #[test]
    fn what_is_not_finite_has_no_inertia() {
        let bad = RollDensity { stiffness: f64::NAN, drift: 0.0, support: 1.0 };
        assert_eq!(of_degree(3).stability(&[0.0, 1.0], std::iter::repeat(bad)), None);
        assert_eq!(of_degree(3).stability(&[0.0, 1.0], std::iter::empty()), None);
    }
}
