//! Where the pole of the near face alone takes a section, as its energy and the forces in the beam say it, whatever the mesh.
//!
//! A nearly upright section beyond the front, c = |cos θ|, has the energy -b|W|/c per length. Under the force (H, V) in the beam its tilt is stiffened by
//! the axial force N = H cos θ + V sin θ and softened by 2b|W|/c³. Where θ changes along S that acts over a short length only, c/|θ'| or, where θ' = 0,
//! √(2c/|θ''|) with EI θ'' = H, and never over more than W does, the height r above the ground: there bending holds the section as well. The softening
//! is as large as what holds against it where
//!
//!   2b|W| = (N + (π/2)² EI/r²) c³ + EI θ'² c + ½ |H| c².
//!
//! There the pole takes the section, and no smooth state lies far beyond: on a plateau P = w, where the first integral is ½EI θ'² = w (1 - sin θ) - b|W|/c,
//! this is where θ' would be zero, and three sampled strips have a limit point at 2.2 to 2.6 times as much, where bending gives way too. Every mesh that
//! resolves the front comes to the same place.

use super::PlanarBeam;
use super::model_limits::{PoleInReach, UprightPole, UprightSection};
use crate::beam::GripForces;
use crate::solve::State;
use std::f64::consts::FRAC_PI_2;

/// Half width of a pole's barrier, cos θ, below which elements step over it without a trace, whatever their mesh. Of sampled pulls and spatulae
/// with the near face alone those that cross 6e-8 agree on all meshes; those that cross 2e-6 and more go on differently on each.
const UNNOTICED: f64 = 1e-7;
/// Sections with a larger cos θ are far from a pole.
const NEARBY: f64 = 0.3;
/// A section that is softened so at a larger cos θ than this is turned by the law and not by its pole: its state is smooth, and every mesh resolves it.
const UPRIGHT: f64 = 0.1;
/// Places of an element at which its rotation is looked at.
const LOOKS: usize = 24;

impl PlanarBeam {
    /// The first section of a state, from the free end on, that stands upright where a pole of the law changes what is computed.
    pub fn upright_section(&self, at: &State) -> Option<UprightSection> {
        let pole = self.limits.pole.as_ref()?;
        self.elements_near_upright(at).find_map(|element| {
            let crossed = self.looks(at, element).windows(2).find_map(|pair| self.crossed(pair, pole));
            crossed.filter(|&(_, strength)| strength > UNNOTICED).map(|(section, _)| section)
        })
    }

    /// The section of a state that the pole of the law softens the most, over what holds it, with that ratio: at one the pole takes it.
    pub fn tipping_section(&self, at: &State) -> Option<(UprightSection, f64)> {
        let pole = self.limits.pole.as_ref()?;
        let forces = self.grip_forces(at);
        let larger = |a: &(UprightSection, f64), b: &(UprightSection, f64)| a.1.total_cmp(&b.1);
        let tipping = self.elements_near_upright(at).filter_map(|element| {
            let looks = self.looks(at, element);
            looks.windows(2).filter_map(|pair| self.tipping(pair, pole, &forces)).max_by(larger)
        });
        tipping.max_by(larger)
    }

    pub(super) fn elements_near_upright(&self, at: &State) -> impl Iterator<Item = usize> {
        (0..at.mesh.elements()).filter(|&element| self.is_near_upright(at, element))
    }

    /// Whether a node of an element is nearly upright, or its nodes lie on both sides of that.
    fn is_near_upright(&self, at: &State, element: usize) -> bool {
        let (order, fields) = (self.chain.order(), self.fields());
        let nodes = &self.nodes(&at.values)[element * order * fields..][..(order + 1) * fields];
        let mut cosines = nodes.chunks(fields).map(|node| node[self.rotation].cos());
        let first = cosines.next().unwrap_or(1.0);
        first.abs() < NEARBY || cosines.any(|cos| cos.abs() < NEARBY || cos.signum() != first.signum())
    }

    /// [S, height of the axis, rotation] at places along an element.
    pub(super) fn looks(&self, at: &State, element: usize) -> Vec<[f64; 3]> {
        let ends = &at.mesh.boundaries;
        let look = |k: usize| {
            let share = k as f64 / LOOKS as f64;
            let (values, _) = self.chain.sample(self.configuration(at), element, 2.0 * share - 1.0);
            let place = ends[element] + share * (ends[element + 1] - ends[element]);
            [place, values[self.rotation - 1], values[self.rotation]]
        };
        (0..=LOOKS).map(look).collect()
    }

    /// EI (nN·nm²), height of the near face of an upright section (nm) and b|W| there (nN).
    fn pole_at(&self, pole: &UprightPole, place: f64, axis: f64) -> [f64; 3] {
        let height = axis + 0.5 * self.height_at(place);
        let [bending, width] = (pole.section)(place);
        [bending, height, width * pole.law.half_space.potential(height).abs()]
    }

    /// The upright section between two places, with the strength of the pole.
    fn crossed(&self, pair: &[[f64; 3]], pole: &UprightPole) -> Option<(UprightSection, f64)> {
        let [[start, low, left], [end, high, right]] = [pair[0], pair[1]];
        let [from, to] = [left.cos(), right.cos()];
        if from.signum() == to.signum() {
            return None;
        }
        let share = from / (from - to);
        let place = start + share * (end - start);
        let [bending, height, attraction] = self.pole_at(pole, place, low + share * (high - low));
        let turn = (right - left) / (end - start);
        let strength = 2.0 * attraction / (bending * turn * turn);
        Some((UprightSection { place, height, pole: PoleInReach::Crossed { strength } }, strength))
    }

    /// The one of two neighbouring places that is nearer to upright, with the softening of its tilt over what holds it; none where it is not the pole
    /// that softens it.
    fn tipping(&self, pair: &[[f64; 3]], pole: &UprightPole, forces: &GripForces) -> Option<(UprightSection, f64)> {
        let [[start, _, left], [end, _, right]] = [pair[0], pair[1]];
        let [place, axis, rotation] = if left.cos().abs() < right.cos().abs() { pair[0] } else { pair[1] };
        let cosine = rotation.cos().abs();
        let [bending, height, attraction] = self.pole_at(pole, place, axis);
        let turn = (right - left) / (end - start);
        // beyond the front the grip's force is that of every section
        let axial = forces.horizontal * rotation.cos() + forces.vertical * rotation.sin();
        let held = axial.max(0.0) + bending * (FRAC_PI_2 / height).powi(2);
        let turning = bending * turn * turn + 0.5 * forces.horizontal.abs() * cosine;
        let ratio = 2.0 * attraction / (held * cosine.powi(3) + turning * cosine);
        let tipping = UprightSection { place, height, pole: PoleInReach::Tipping { cosine, ratio } };
        // the tilt at which the pole would take it, if the rest stayed what it is
        (cosine * ratio.cbrt() < UPRIGHT).then_some((tipping, ratio))
    }
}
