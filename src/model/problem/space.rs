//! A beam that is peeled in space: pulled sideways, twisted, rolled off.

use super::beam_problem::{ACROSS, ALONG, Beam, BeamProblem, ROLL, ROTATION, ROUNDED, SIDEWAYS, YAW};
use super::branch::BodyBranch;
use super::build::{Discretisation, NoSuchOrder};
use crate::adhesion::spatial_section::error::SpatialSectionError;
use crate::adhesion::spatial_section::section::{SectionShape, SpatialSection};
use crate::beam::mesh::MeshPolicy;
use crate::beam::spatial::chain::spatial_chain::{SpatialChain, SpatialEnd};
use crate::beam::spatial::end_rotation::EndRotation;
use crate::beam::spatial::rest::{ALONG_X, BranchRest, SpatialRest};
use crate::beam::spatial::section::branch_sections::AdheringSections;
use crate::beam::spatial::section::density::SpatialDensity;
use crate::beam::spatial::section::held_sections::HeldSections;
use crate::beam::spatial::section::lying_section::LyingSection;
use crate::beam::spatial::section::spatial_profile::SpatialStiffness;
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::beam::torsion::torsion_constant;
use crate::model::peel::{Hold, PeelModel, Space};
use crate::solve::problem::{EndConditions, InitialState, MeasuredBeside, PathMeasure};
use crate::solve::system::INTERFACE;
use std::f64::consts::{FRAC_PI_4, PI};
use std::sync::Arc;

/// The left end moves along x, y and z.
const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl PeelModel {
    /// The model in the plane whose solution is the same, of a model in space whose solution stays in the body's vertical plane: one
    /// whose adhesion is that of a rectangle, that is pulled within it, in one direction or the other, and that no step has moved out of
    /// it before. What is held along the ground is computed in the plane where it is a strip alone.
    pub fn in_the_plane(&self) -> Option<Self> {
        let space = self.space?;
        let leaves = self.steps.iter().any(|step| step.motion().is_some_and(|(moved, _)| moved.leaves_plane()));
        let in_space_alone = self.adhesion.shear_strength.is_some() && self.strip().is_none();
        if leaves || in_space_alone || space.section != SectionShape::Rectangle || space.azimuth.sin().abs() > ROUNDED {
            return None;
        }
        let mut model = Self { space: None, ..self.clone() };
        if space.azimuth.cos() < 0.0 {
            model.pull.angle = PI - model.pull.angle;
        }
        Some(model)
    }

    /// The same model in space, in a grip that lets the end roll, turn about the normal and move sideways: what leaves its plane is free to.
    pub fn left_plane(&self) -> Self {
        Self { space: Some(Space::default()), ..self.clone() }
    }

    /// Adhesion of its section in space.
    ///
    /// # Errors
    /// A law that has none there.
    pub(crate) fn spatial_section(&self, space: &Space) -> Result<SpatialSection, SpatialSectionError> {
        SpatialSection::new(space.section, self.free_end().0, self.line_law())
    }

    /// Stiffness of its section in space, from the outline's area, second moments and torsion constant.
    pub(crate) fn spatial_stiffness(&self, space: &Space) -> SpatialStiffness {
        let (width, height) = self.free_end();
        let share = |moment: f64| if space.section == SectionShape::Ellipse { moment } else { 1.0 };
        let area = width * height * share(FRAC_PI_4);
        // of an ellipse π/64 of the axes instead of 1/12
        let bent = share(12.0 * PI / 64.0) / 12.0;
        let second_moments = [bent * width * height.powi(3), bent * height * width.powi(3)];
        let torsion = torsion_constant(space.section, width, height);
        SpatialStiffness::isotropic(&self.material(), area, second_moments, torsion)
    }

    /// What the solver is given of a body in space.
    pub(super) fn spatial_problem(
        &self,
        space: &Space,
        section: SpatialSection,
        how: Discretisation,
    ) -> Result<BeamProblem, NoSuchOrder> {
        how.check().map_err(|_| NoSuchOrder { order: how.order })?;
        let BodyBranch { sections, rest, length, mesh } = self.on_ground(space, section);
        let held = sections.held.map(|law| HeldSections { law, rest: BranchRest::as_made(&rest) });
        let (AdheringSections { profile, lying, .. }, rest) =
            (Arc::unwrap_or_clone(sections), Arc::unwrap_or_clone(rest));
        let LyingSection { gap_scale, process_length, .. } = lying;
        let start = match rest {
            SpatialRest::Curve(_) => InitialState::StressFree,
            SpatialRest::Outline(_) => InitialState::Settling,
        };
        let angles = [self.grip.rotation, space.yaw, space.roll].contains(&Hold::Fixed);
        let rotation = if angles { EndRotation::Angles } else { EndRotation::Free };
        let end = |axes, rotation| SpatialEnd { axes, rotation, rest: ALONG_X, dead_load: [[0.0; 3]; 2] };
        let ends = [end(AXES, EndRotation::Angles), end(self.pull_axes(space), rotation)];
        let density = SpatialDensity { profile, adhesion: Some(section), held };
        let beam = SpatialBeam {
            chain: SpatialChain::new(density, how.order, ends, self.held_left(space)),
            length,
            rest,
            scale: [gap_scale, (gap_scale / process_length).min(1.0)],
            round_off: 0.0,
            rest_adhesion: lying.energy,
            process_length,
            barrier: section.law().barrier(),
            mesh: MeshPolicy { kind: how.mesh, ..Arc::unwrap_or_clone(mesh) },
            inertia: None,
        };
        let measure = PathMeasure {
            monitors: [beam.process_length, beam.scale[1]],
            force: beam.rest_adhesion.abs(),
            beside: MeasuredBeside::Nothing,
        };
        let grip = self.spatial_grip(space, &beam);
        Ok(BeamProblem::new(Beam::Spatial(beam.into()), grip, measure, start))
    }

    /// Columns: along the pull, across it in its vertical plane, and sideways.
    fn pull_axes(&self, space: &Space) -> [[f64; 3]; 3] {
        let direction = self.pull.direction();
        let (sin, cos) = space.azimuth.sin_cos();
        let pull = [direction.along * cos, direction.up, direction.along * sin];
        let across = [direction.up * cos, -direction.along, direction.up * sin];
        let sideways = [-sin, 0.0, cos];
        std::array::from_fn(|i| [pull[i], across[i], sideways[i]])
    }

    /// What the left end holds.
    fn held_left(&self, space: &Space) -> [Option<f64>; 6] {
        let (width, height) = self.free_end();
        let disc = space.section == SectionShape::Ellipse && width == height;
        let held = |holds: bool| holds.then_some(0.0);
        // what is held along the ground holds the free end
        let slides = self.adhesion.shear_strength.is_none();
        let yaw = slides && space.yaw == Hold::Free && space.lateral == Hold::Free;
        [held(slides), None, held(slides), None, held(yaw), held(disc && space.roll == Hold::Free)]
    }

    fn spatial_grip(&self, space: &Space, beam: &SpatialBeam) -> EndConditions {
        let fixed = |hold: Hold| hold == Hold::Fixed;
        let mut held = [false; INTERFACE];
        held[ACROSS] = fixed(self.grip.horizontal);
        held[SIDEWAYS] = fixed(space.lateral);
        held[ROTATION] = fixed(self.grip.rotation);
        held[YAW] = fixed(space.yaw);
        held[ROLL] = fixed(space.roll);
        let [place, turn] = beam.scale;
        EndConditions {
            held,
            geared: ROTATION,
            gear: if held[ROTATION] { self.pull.turn } else { 0.0 },
            origin: beam.interface_at_rest(),
            scale: [place, place, place, turn, turn, turn],
            ..EndConditions::drive(ALONG)
        }
    }
}
