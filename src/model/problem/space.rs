//! A beam that is peeled in space: pulled sideways, twisted, rolled off.

use super::beam_problem::{ACROSS, ALONG, Beam, BeamProblem, ROLL, ROTATION, ROUNDED, SIDEWAYS, YAW};
use super::build::{Discretisation, NoSuchOrder};
use super::stress_free_placement::StressFreePlacement;
use crate::adhesion::spatial_section::error::SpatialSectionError;
use crate::adhesion::spatial_section::section::{SectionShape, SpatialSection};
use crate::beam::mesh::{Focus, MeshIntervals, MeshPolicy, Reach};
use crate::beam::reference_configuration::ReferenceConfiguration;
use crate::beam::spatial::chain::spatial_chain::{SpatialChain, SpatialEnd};
use crate::beam::spatial::end_rotation::EndRotation;
use crate::beam::spatial::rest::{ALONG_X, RestOutline, SpatialRest, SpatialRestCurve};
use crate::beam::spatial::section::density::SpatialDensity;
use crate::beam::spatial::section::spatial_profile::{SpatialProfile, SpatialStiffness};
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::beam::torsion::torsion_constant;
use crate::beam::varying::Varying;
use crate::model::peel::{Hold, PeelModel, Space};
use crate::model::step::Step;
use crate::solve::problem::{EndConditions, InitialState, MeasuredBeside, PathMeasure};
use crate::solve::system::INTERFACE;
use std::f64::consts::{FRAC_PI_4, PI};

/// The left end moves along x, y and z.
const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// How far behind the front a strip twists off, over the length of the process zone, and the weight of that place beside the front. With it 20
/// elements give what 32 gave without, of the strip of scenes/strip-sideways.toml.
const TWIST_BEHIND: f64 = 3.0;
const TWIST_WEIGHT: f64 = 0.7;
/// Where the mesh of a body whose section varies is fine at each of the two edges that let go: behind that place, how long that is, both over the length
/// of the process zone, and its weight. With it 48 elements give the first displacement limit point of scenes/spatula.toml in space to 3e-10, and 96
/// gave it to 9e-8 where the mesh followed the front alone.
const BEHIND_EDGE: f64 = 0.6;
const EDGE_LENGTH: f64 = 0.6;
const EDGE_WEIGHT: f64 = 0.9;
/// Weight of the right end where a step has rolled it.
const HELD_WEIGHT: f64 = 0.4;
/// Length of the elements everywhere else where the front has elements of one process length, over that, and over the length of the beam where that is
/// more: of what bends and twists far away.
const EVEN: f64 = 20.0;
const EVEN_SHARE: f64 = 0.25;

impl PeelModel {
    /// The model in the plane whose solution is the same, of a model in space whose solution stays in the body's vertical plane: one
    /// whose adhesion is that of a rectangle, that is pulled within it, in one direction or the other, and that no step has moved out of
    /// it before.
    pub fn in_the_plane(&self) -> Option<Self> {
        let space = self.space?;
        let leaves = self.steps.iter().any(|step| step.motion().is_some_and(|(moved, _)| moved.leaves_plane()));
        if leaves || space.section != SectionShape::Rectangle || space.azimuth.sin().abs() > ROUNDED {
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
    pub fn spatial_section(&self, space: &Space) -> Result<SpatialSection, SpatialSectionError> {
        SpatialSection::new(space.section, self.free_end().0, self.line_law())
    }

    /// Stiffness of its section in space, from the outline's area, second moments and torsion constant.
    pub fn spatial_stiffness(&self, space: &Space) -> SpatialStiffness {
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
        let ((width, height), length) = (self.free_end(), self.length());
        let gap_scale = section.law().gap_scale();
        let varying = self.contour().map(|contour| Varying::new(contour, self.material()));
        let rest_height = rest_height(&section, 0.5 * height + self.line_law().rest_gap());
        let at_rest = section.response(rest_height, 0.0, height);
        let stiffness = self.spatial_stiffness(space);
        let process_length = 0.7
            * (stiffness.0[4][4] / at_rest.hessian[0])
                .powf(0.25)
                .min(3.0 * (stiffness.0[2][2] / at_rest.hessian[0]).sqrt());
        let edge = (0.36 * process_length).min(0.25 * gap_scale);
        let front = Focus { center: 0.0, length: process_length, weight: 1.0, reach: Reach::Far };
        // behind the front the strip twists off within √(12 GJ / (b² Ψ_yy))
        let twist_length = (12.0 * stiffness.0[3][3] / (width * width * at_rest.hessian[0])).sqrt();
        let twist =
            Focus { center: -TWIST_BEHIND * process_length, length: twist_length, weight: TWIST_WEIGHT, ..front };
        let letting_go = Focus {
            center: -BEHIND_EDGE * process_length,
            length: EDGE_LENGTH * process_length,
            weight: EDGE_WEIGHT,
            ..front
        };
        // a strip that has been rolled twists flat next to the grip
        let held = Focus { center: length, length: twist_length, weight: HELD_WEIGHT, ..front };
        let even = Focus::everywhere(length, (EVEN * process_length).max(EVEN_SHARE * length));
        let mut fixed_foci = vec![Focus { length: edge, weight: 0.8, ..front }];
        fixed_foci.extend(self.steps.iter().any(|step| matches!(step, Step::Roll(_))).then_some(held));
        let (profile, rest, pieces, [front_foci, edge_foci]) = match varying {
            None => {
                fixed_foci.extend([Focus { center: length, weight: 0.2, ..front }, even]);
                let profile = SpatialProfile::uniform(stiffness, width, height);
                let rest = SpatialRestCurve::along_x(rest_height).into();
                (profile, rest, MeshIntervals::whole(length), [vec![front, twist], Vec::new()])
            }
            Some(beam) => {
                fixed_foci.push(even);
                let (rest, pieces) = self.rest_outline(&beam, &[letting_go; 2], &mut fixed_foci);
                (SpatialProfile::Varying(beam), rest, pieces, [Vec::new(), vec![letting_go]])
            }
        };
        let start = match rest {
            SpatialRest::Curve(_) => InitialState::StressFree,
            SpatialRest::Outline(_) => InitialState::Settling,
        };
        let angles = [self.grip.rotation, space.yaw, space.roll].contains(&Hold::Fixed);
        let rotation = if angles { EndRotation::Angles } else { EndRotation::Free };
        let end = |axes, rotation| SpatialEnd { axes, rotation, rest: ALONG_X, dead_load: [[0.0; 3]; 2] };
        let ends = [end(AXES, EndRotation::Angles), end(self.pull_axes(space), rotation)];
        let density = SpatialDensity { profile, adhesion: Some(section) };
        let beam = SpatialBeam {
            chain: SpatialChain::new(density, how.order, ends, self.held_left(space)),
            length,
            rest,
            scale: [gap_scale, (gap_scale / process_length).min(1.0)],
            round_off: 0.0,
            rest_adhesion: at_rest.energy,
            process_length,
            barrier: section.law().barrier(),
            mesh: MeshPolicy { kind: how.mesh, front_foci, edge_foci, fixed_foci, pieces },
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

    /// The stress-free configuration of a body whose section varies, in its vertical plane, and between which places its elements lie.
    fn rest_outline(&self, beam: &Varying, front: &[Focus], fixed: &mut Vec<Focus>) -> (SpatialRest, MeshIntervals) {
        let placement = StressFreePlacement::varying(beam, &self.adhesion, &self.ground, front, fixed);
        let rest = match placement.rest {
            ReferenceConfiguration::Varying(reference) => {
                let outline = RestOutline::new(*reference, placement.fronts, placement.rest_front);
                SpatialRest::Outline(Box::new(outline))
            }
            ReferenceConfiguration::Curve(curve) => SpatialRestCurve::along_x(curve.start[1]).into(),
        };
        (rest, placement.pieces)
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
        let yaw = space.yaw == Hold::Free && space.lateral == Hold::Free;
        [Some(0.0), None, Some(0.0), None, held(yaw), held(disc && space.roll == Hold::Free)]
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

/// Height of the axis at which the ground neither pulls nor pushes, from the one of the law in the plane: Newton's method.
fn rest_height(section: &SpatialSection, start: f64) -> f64 {
    const MOST: usize = 100;
    let (mut y, height) = (start, section.law().height);
    for _ in 0..MOST {
        let at = section.response(y, 0.0, height);
        let step = at.gradient[0] / at.hessian[0];
        y -= step;
        if step.abs() <= 4.0 * f64::EPSILON * y {
            break;
        }
    }
    y
}
