//! States in which the model of a planar beam ends: a section that stands upright, and one that collapses.
//!
//! Where a section that stands upright on a pressed edge holds the beam the energy has a corner. The face that looks down is another one on either side of θ = 90 degrees. A law of that face has Ψ = W(r), r = y - (h/2)|cos θ| above the height of
//! the axis, whose slope by θ changes there from -T h/2 to +T h/2, T = -W' the traction, above zero where the edge is pressed. Then the energy has a
//! corner that is a least value: an upright section stays upright under any moment between the two, and so do those beside it over some length, where
//! nothing but the corner holds them. No smooth solution goes on from there.
//!
//! The end of a beam collapses onto the substrate in a state that the energy of a beam has and no beam. A section that stands upright is attracted with up to b h T per length, T the largest traction of the half space. Where that is more than about ½EA the
//! sections of an upright end gain more by coming down to the equilibrium height, all of them, than it takes to compress the axis between them to nothing,
//! Γ1 = -1: linear elasticity lets sections through one another. Each mesh has another such state, and Newton's method goes from none to the next.

use super::model_limits::{
    LOOKS, NEARBY, PoleInReach, UNNOTICED, UNNOTICED_SHARE, UNRESOLVED, UprightCorner, UprightPole, UprightSection,
};
use super::planar_beam::PlanarBeam;
use crate::solve::state::State;
use serde::{Deserialize, Serialize};
use std::fmt;

/// A section with a smaller |cos θ| is upright, where a path cannot be continued.
const UPRIGHT: f64 = 1e-3;
/// To either side of upright: where a corner is distinguished from a curve.
const BESIDE: f64 = 1e-9;
/// A jump of the line moment below this share of the work of adhesion per length holds nothing.
const WEAK: f64 = 1e-2;

impl PlanarBeam {
    /// The first section of a state, from the free end on, that stands upright on a pressed edge.
    pub(crate) fn held_upright(&self, at: &State) -> Option<UprightSection> {
        let corner = self.limits.corner.as_ref()?;
        self.elements_near_upright(at).find_map(|element| {
            let looks = self.looks(at, element);
            let [place, axis, rotation] = *looks.iter().min_by(|a, b| a[2].cos().abs().total_cmp(&b[2].cos().abs()))?;
            let cosine = rotation.cos().abs();
            let moment = self.moment_jump(corner, place, axis, rotation.sin().signum());
            let held = cosine < UPRIGHT && moment > WEAK * self.rest_adhesion.abs();
            held.then(|| UprightSection {
                place,
                height: axis + 0.5 * self.height_at(place),
                pole: PoleInReach::Edge { cosine, moment: 0.5 * moment },
            })
        })
    }

    /// How much b ∂Ψ/∂θ grows where a section turns through upright, nN; `side` is the sign of sin θ.
    fn moment_jump(&self, corner: &UprightCorner, place: f64, axis: f64, side: f64) -> f64 {
        let height = self.height_at(place);
        let slope = |cos: f64| corner.law.response_of(height, axis, side, cos).by_rotation;
        // cos θ falls with θ where sin θ is above zero
        (corner.width)(place) * (slope(-side * BESIDE) - slope(side * BESIDE))
    }
}

impl PlanarBeam {
    /// The first section of a state, from the free end on, that stands upright where a pole of the law changes what is computed by more than the accuracy
    /// `relative`.
    pub(crate) fn upright_section(&self, at: &State, relative: f64) -> Option<UprightSection> {
        let pole = self.limits.pole.as_ref()?;
        let least = UNNOTICED.min(UNNOTICED_SHARE * relative);
        self.elements_near_upright(at).find_map(|element| {
            let crossed = self.looks(at, element).windows(2).find_map(|pair| self.crossed(pair, pole));
            crossed.filter(|&(_, strength)| strength > least).map(|(section, _)| section)
        })
    }

    /// The first section of a state, from the free end on, that is so nearly upright that the elements do not resolve a pole of the law.
    pub(crate) fn unresolved_section(&self, at: &State) -> Option<UprightSection> {
        self.nearly_upright(at, UNRESOLVED).next()
    }

    /// The first section of a state, from the free end on, that the pole of its law draws upright, and the same as one that is to be resolved.
    pub(crate) fn drawn_section(&self, at: &State) -> Option<[UprightSection; 2]> {
        let pole = self.limits.pole.as_ref()?;
        let tension = self.grip_forces(at).vertical.max(0.0);
        self.nearly_upright(at, 0.0).find_map(|section| {
            let PoleInReach::Unresolved { cosine, length, .. } = section.pole else { return None };
            let [bending, _] = (pole.section)(section.place);
            let held_by = tension + bending / (section.height * section.height);
            let softened = 2.0 * bending / (length * length);
            let held = cosine * (softened / held_by).cbrt();
            let drawn = UprightSection { pole: PoleInReach::Drawn { cosine, held }, ..section };
            (softened > held_by).then_some([drawn, section])
        })
    }

    /// The sections nearest to upright of elements that are longer than this many times the length over which the pole bends the beam there.
    fn nearly_upright(&self, at: &State, longer: f64) -> impl Iterator<Item = UprightSection> {
        let pole = self.limits.pole.as_ref();
        let near = pole.map(|pole| self.elements_near_upright(at).map(move |element| (element, pole)));
        let nearest = move |(element, pole)| self.nearest_to_upright(&self.looks(at, element), pole, longer);
        near.into_iter().flatten().filter_map(nearest)
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

    /// The section of an element that is nearest to upright on one side, where the element is longer than so many times the length over which the pole bends
    /// the beam.
    fn nearest_to_upright(&self, looks: &[[f64; 3]], pole: &UprightPole, longer: f64) -> Option<UprightSection> {
        let [place, axis, rotation] = *looks.iter().min_by(|a, b| a[2].cos().abs().total_cmp(&b[2].cos().abs()))?;
        let cosine = rotation.cos().abs();
        let one_sided = looks.iter().all(|look| look[2].cos().signum() == looks[0][2].cos().signum());
        let [bending, height, attraction] = self.pole_at(pole, place, axis);
        let length = (bending * cosine.powi(3) / attraction).sqrt();
        let element = looks[LOOKS][0] - looks[0][0];
        (one_sided && element > longer * length).then_some(UprightSection {
            place,
            height,
            pole: PoleInReach::Unresolved { cosine, length, element },
        })
    }
}

/// A section at which the axis is compressed, or sheared, as no beam is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct CollapsedSection {
    /// S, nm
    pub place: f64,
    /// Γ1 = x' cosθ + y' sinθ - 1
    pub stretch: f64,
    /// Γ2 = -x' sinθ + y' cosθ
    pub shear: f64,
}

impl fmt::Display for CollapsedSection {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { place, stretch, shear } = self;
        write!(
            f,
            "the beam collapses onto the substrate, where its adhesion is too strong for its stiffness: at S = {place:.3} nm it is compressed by Γ1 = \
             {stretch:.3} and sheared by Γ2 = {shear:.3}, beyond {COLLAPSED}, and no beam is"
        )
    }
}

/// Largest compression -Γ1 and largest shear |Γ2| of a beam, far beyond what a linear material is taken for.
const COLLAPSED: f64 = 0.5;

impl PlanarBeam {
    /// The section, of those between elements, that is compressed or sheared most, where no beam is so.
    pub(crate) fn collapsed_section(&self, at: &State) -> Option<CollapsedSection> {
        let nodes = self.chain.node_states(self.configuration(at), 0..at.mesh.elements());
        let sections = nodes.iter().map(|node| {
            let (sin, cos) = node.values[self.rotation].sin_cos();
            let (across, up) = (node.section.horizontal_slope, node.section.vertical_slope);
            CollapsedSection {
                place: node.position,
                stretch: across * cos + up * sin - 1.0,
                shear: up * cos - across * sin,
            }
        });
        let size = |section: &CollapsedSection| section.shear.abs().max(-section.stretch);
        sections.max_by(|a, b| size(a).total_cmp(&size(b))).filter(|section| size(section) > COLLAPSED)
    }
}
