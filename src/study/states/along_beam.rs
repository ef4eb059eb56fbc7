//! The fields of one equilibrium along a planar beam.
//!
//! They are sampled where the elements know them best: at the ends of elements, from nodal forces, and at the Gauss points between, where the
//! slopes of an element of order p are as accurate as its values. The Gauss weights come along: Σ weight × line force is the integral that the
//! elements balance, to the last digits.

use crate::adhesion::friction::dahl::FrictionLaw;
use crate::adhesion::section::sheared::Farthest;
use crate::adhesion::spatial_section::section::SectionShape;
use crate::adhesion::substrate_response::GroundLaw;
use crate::beam::element::energy_density::SectionState;
use crate::beam::planar::chain::NodeState;
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::section::Section;
use crate::beam::spatial::section_state::SpatialSectionState;
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::model::peel::PeelModel;
use crate::number::gauss::{Rule, gauss_legendre};
use crate::solve::state::State;
use std::num::NonZeroUsize;

/// The beam at one place. Its loads are those that it exerts on the ground, which exerts the opposite on it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionFields {
    /// S, nm
    pub place: f64,
    /// Of the axis along the ground, nm
    pub x: f64,
    /// Of the axis above the ground, nm
    pub y: f64,
    /// θ of the section, rad
    pub rotation: f64,
    /// N, normal to the section, nN; positive in tension
    pub normal_force: f64,
    /// Q, along the section, nN
    pub shear_force: f64,
    /// M, nN nm
    pub moment: f64,
    /// κ = θ' - θ0', 1/nm, so that M = EI κ
    pub curvature: f64,
    /// Distance of the nearer edge of the section from the ground, nm
    pub gap: f64,
    /// b ∂Ψ/∂y, nN/nm: the attraction of the ground per length; below zero where it repels. Its integral is P of a pull straight up
    pub line_force: f64,
    /// b ∂Ψ/∂x, nN/nm: zero on flat ground
    pub line_force_along: f64,
    /// b ∂Ψ/∂θ, nN: moment per length
    pub line_moment: f64,
    /// t of friction, GPa: what the face exerts on the ground, positive along x; zero without friction
    pub friction_traction: f64,
    /// bΨ, aJ/nm
    pub adhesion_energy: f64,
    /// ½(N²/EA + Q²/GA_s + M²/EI), aJ/nm
    pub stored_energy: f64,
    /// Width b and height h of the section, nm
    pub width: f64,
    /// See `width`
    pub height: f64,
    /// Of the quadrature along S, nm: the integral of a field is the sum of this times the field
    pub weight: f64,
}

/// What the fields of all states of one peel in the plane are read with.
pub(in crate::study) struct PlanarReader<'p> {
    model: &'p PeelModel,
    beam: &'p PlanarBeam,
    friction: Option<FrictionLaw>,
    /// Local coordinates in [-1, 1] and weights of the Gauss points of an element.
    gauss: Vec<(f64, f64)>,
    /// Of the integral of x' between two samples.
    between: Rule,
}

/// Of the integral of x' between two samples: x' has no higher order there.
const POINTS_BETWEEN: NonZeroUsize = NonZeroUsize::new(3).expect("three is not zero");

impl<'p> PlanarReader<'p> {
    pub(crate) fn new(model: &'p PeelModel, beam: &'p PlanarBeam) -> Self {
        let gauss = NonZeroUsize::new(beam.chain.order()).map_or_else(Vec::new, gauss_legendre);
        Self { model, beam, friction: model.friction_law(), gauss, between: Rule::new(POINTS_BETWEEN) }
    }

    /// The fields from S = 0 to S = L.
    pub(crate) fn sections(&self, at: &State) -> Vec<SectionFields> {
        let configuration = self.beam.configuration(at);
        let elements = at.mesh.elements();
        let ends = self.beam.chain.node_states(configuration, 0..elements);
        let (mut sections, mut x) = (Vec::new(), 0.0);
        for element in 0..elements {
            let (from, to) = (at.mesh.boundaries[element], at.mesh.boundaries[element + 1]);
            let place = |local: f64| from + 0.5 * (1.0 + local) * (to - from);
            let sample = |local: f64| self.beam.chain.sample(configuration, element, local);
            sections.push(self.at_end(at, &ends[element], x));
            let mut before = -1.0;
            for &(local, weight) in &self.gauss {
                x += self.advance(before, local, to - from, &sample);
                before = local;
                let (values, section) = sample(local);
                let weight = 0.5 * weight * (to - from);
                sections.push(SectionFields { weight, ..self.fields(at, place(local), values, &section, x) });
            }
            x += self.advance(before, 1.0, to - from, &sample);
        }
        sections.extend(ends.last().map(|end| self.at_end(at, end, x)));
        sections
    }

    /// The gap of the section at S = 0, nm.
    pub(crate) fn free_end_gap(&self, at: &State) -> f64 {
        let ends = self.beam.chain.node_states(self.beam.configuration(at), 0..1);
        self.at_end(at, &ends[0], 0.0).gap
    }

    /// How far x goes between two local coordinates of an element of this length, nm.
    fn advance<V>(&self, from: f64, to: f64, length: f64, sample: &impl Fn(f64) -> (V, SectionState)) -> f64 {
        let slopes = self.between.over(from, to).map(|(local, weight)| weight * sample(local).1.horizontal_slope);
        0.5 * length * slopes.sum::<f64>()
    }

    fn at_end(&self, at: &State, end: &NodeState, x: f64) -> SectionFields {
        self.fields(at, end.position, end.values, &end.section, x)
    }

    /// The fields at one place; x is that of the fields where they have it.
    fn fields(&self, at: &State, place: f64, values: [f64; 3], state: &SectionState, x: f64) -> SectionFields {
        let beam = self.beam;
        let (section, width, height) = self.model.section_at(place);
        let (level, rotation) = (values[beam.rotation - 1], values[beam.rotation]);
        let x = if beam.rotation > 1 { values[0] } else { x };
        let y = level + 0.5 * height;
        let (sin, cos) = rotation.sin_cos();
        let closest = beam.substrate.project(x, y);
        let tilt = rotation - closest.sin.atan2(closest.cos);
        let (energy, gradient) = match self.model.face_law() {
            Some(law) => {
                let [distance, slip] = at.history.as_ref().map_or([0.0; 2], |history| history.at(place));
                let place = [x - place, level];
                let response = law.response_after(height, place, [sin, cos], Farthest { distance, slip });
                (response.energy, response.gradient)
            }
            None => {
                let ground = GroundLaw { law: self.model.adhesion.line_law(height), substrate: beam.substrate.clone() };
                let response = ground.response(height, [x, level], [sin, cos]);
                (response.energy, response.gradient)
            }
        };
        let [along, across, moment] = gradient.map(|load| width * load);
        SectionFields {
            place,
            x,
            y,
            rotation,
            normal_force: state.horizontal_force * cos + state.vertical_force * sin,
            shear_force: state.vertical_force * cos - state.horizontal_force * sin,
            moment: state.moment,
            curvature: state.moment / section.bending,
            gap: closest.distance - 0.5 * height * tilt.cos().abs(),
            line_force: across,
            line_force_along: along,
            line_moment: moment,
            friction_traction: self.friction_at(at, place, [x, level], [sin, cos], height),
            adhesion_energy: width * energy,
            stored_energy: self.stored(state, &section, [sin, cos]),
            width,
            height,
            weight: 0.0,
        }
    }

    /// w + ½(Q²/GA_s + M²/EI), nN, with w = ½N²/EA where the stretch is linear.
    fn stored(&self, state: &SectionState, section: &Section, [sin, cos]: [f64; 2]) -> f64 {
        let normal = state.horizontal_force * cos + state.vertical_force * sin;
        let shear = state.vertical_force * cos - state.horizontal_force * sin;
        let stretched = self.model.material().stretch.energy(section.axial, normal);
        stretched + 0.5 * (shear.powi(2) / section.shear + state.moment.powi(2) / section.bending)
    }

    /// The traction of friction on the ground, GPa.
    fn friction_at(&self, at: &State, place: f64, [x, level]: [f64; 2], [sin, cos]: [f64; 2], height: f64) -> f64 {
        let (Some(law), Some(history)) = (&self.friction, &at.history) else { return 0.0 };
        let [before, mobilisation] = history.at::<2>(place);
        let (face, gap) = (x + 0.5 * height * sin, level + 0.5 * height * (1.0 - cos));
        law.traction(face - before, gap, mobilisation).value
    }
}

// -- The fields of one equilibrium along a beam in space, sampled as those of a planar beam are --

/// The beam in space at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialSectionFields {
    /// Where the section lies, what it carries, and what it exerts on the ground
    pub state: SpatialSectionState,
    /// Distance of its lowest point from the ground, nm
    pub gap: f64,
    /// Of the quadrature along S, nm: the integral of a field is the sum of this times the field
    pub weight: f64,
}

/// What the fields of all states of one peel in space are read with.
pub(in crate::study) struct SpatialReader<'p> {
    beam: &'p SpatialBeam,
    pub outline: SectionShape,
    /// Shares of an element at its Gauss points, from 0 to 1, and their weights.
    gauss: Vec<(f64, f64)>,
}

impl<'p> SpatialReader<'p> {
    pub(crate) fn new(model: &PeelModel, beam: &'p SpatialBeam) -> Self {
        let gauss = NonZeroUsize::new(beam.chain.order()).map_or_else(Vec::new, gauss_legendre);
        let gauss = gauss.into_iter().map(|(local, weight)| (0.5 * (1.0 + local), 0.5 * weight)).collect();
        Self { beam, outline: model.space.map_or(SectionShape::Rectangle, |space| space.section), gauss }
    }

    /// The fields from S = 0 to S = L.
    pub(crate) fn sections(&self, at: &State) -> Vec<SpatialSectionFields> {
        let elements = at.mesh.elements();
        let mut ends = self.beam.end_states(at, 0..elements).into_iter();
        let mut sections = Vec::with_capacity(elements * (1 + self.gauss.len()) + 1);
        for (element, pair) in at.mesh.boundaries.windows(2).enumerate() {
            sections.extend(ends.next().map(|end| self.fields(end, 0.0)));
            let inside = self.gauss.iter().map(|&(share, weight)| {
                self.fields(self.beam.state_at(at, element, share), weight * (pair[1] - pair[0]))
            });
            sections.extend(inside);
        }
        sections.extend(ends.next().map(|end| self.fields(end, 0.0)));
        sections
    }

    /// The gap of the section at S = 0, nm.
    pub(crate) fn free_end_gap(&self, at: &State) -> f64 {
        let ends = self.beam.end_states(at, 0..1);
        self.fields(ends[0], 0.0).gap
    }

    fn fields(&self, state: SpatialSectionState, weight: f64) -> SpatialSectionFields {
        let section = &state.section;
        let (across, up) = (section.width * section.directors[1][1], section.height * section.directors[2][1]);
        let below = match self.outline {
            SectionShape::Rectangle => across.abs() + up.abs(),
            SectionShape::Ellipse => across.hypot(up),
        };
        SpatialSectionFields { state, gap: section.place[1] - 0.5 * below, weight }
    }
}
