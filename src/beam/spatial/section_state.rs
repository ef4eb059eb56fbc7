//! What sections of a beam in space carry and how they lie, what is the same at all of them, and what the grip exerts.
//!
//! Over flat ground without friction a uniform beam in equilibrium has four integrals, whatever loads its ends: with the section force n, the
//! moment m and the stress-free curvatures K0 in the axes of the directors,
//!
//!   n·r' + m·K - stored - Ψ = n·d1 + m·K0 + stored - Ψ,    n_x,    n_z,    m_y + (r × n)_y
//!
//! are the same all along it: the density depends neither on S nor on x, z and the turn about y (Noether). The last three hold of the
//! elements as well, to round-off; the first one holds of the exact solution, and shows the error of a mesh. Where the adhesive holds a strip along
//! the ground the density depends on x - S alone, and the first one less n_x is the same.

use super::chain::read::normalise;
use super::chain::spatial_chain::quaternion_of;
use super::end_rotation::{EndRotation, angles};
use super::rotation::{apply, cross, dot, matrix, normalised};
use super::section::kinematics::SPATIAL_FIELDS;
use super::section::spatial_profile::{SpatialProfile, Station};
use super::spatial_beam::SpatialBeam;
use crate::beam::grip_state::{ForcesInSpace, GripForces, GripState, PlaceInSpace};
use crate::solve::state::State;
use crate::solve::system::EndRoll;
use nalgebra::{Matrix6, Vector6};
use std::f64::consts::TAU;
use std::ops::Range;

/// What a section of a beam in space carries. The loads are those that it exerts on the ground, which exerts the opposite on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialSectionState {
    /// Where it lies, with its forces and moments
    pub section: SpatialSectionPlace,
    /// Γ along the directors: of the axis, and of shear along the width and the height
    pub stretch: [f64; 3],
    /// K - K0: twist, and curvatures about the width and about the height, 1/nm
    pub curvature: [f64; 3],
    /// ½ (n·Γ + m·(K - K0)), nN
    pub stored: f64,
    /// Ψ, nN
    pub adhesion: f64,
    /// Ψ_y e_y per length, nN/nm: x, y, z; with Ψ_x and Ψ_z where the adhesive holds along the ground
    pub line_force: [f64; 3],
    /// (b Ψ_a d2 + h Ψ_c d3) × e_y per length, nN, about x, y, z; b and h the width and the height, and a and c how far d2 and d3 rise along them
    pub line_moment: [f64; 3],
}

/// What is the same at all sections of a uniform beam in equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialIntegrals {
    /// n·d1 + m·K0 + stored - Ψ, nN
    pub energy: f64,
    /// n_x and n_z, nN
    pub force: [f64; 2],
    /// m_y + (r × n)_y, nN·nm
    pub moment: f64,
}

impl SpatialSectionState {
    /// Sum of a force and a moment along and about the directors in the axes of space.
    fn in_space(&self, along: [f64; 3]) -> [f64; 3] {
        let directors = &self.section.directors;
        std::array::from_fn(|i| (0..3).map(|d| directors[d][i] * along[d]).sum())
    }

    /// n along x, y, z, nN
    pub fn force(&self) -> [f64; 3] {
        self.in_space(self.section.force)
    }

    /// m about x, y, z, nN·nm
    pub(crate) fn moment(&self) -> [f64; 3] {
        self.in_space(self.section.moment)
    }

    /// The integrals of a beam with these stress-free curvatures, 1/nm.
    pub fn integrals(&self, rest_curvature: [f64; 3]) -> SpatialIntegrals {
        let SpatialSectionPlace { place, force: own, moment, .. } = self.section;
        let force = self.force();
        SpatialIntegrals {
            energy: own[0] + dot(moment, rest_curvature) + self.stored - self.adhesion,
            force: [force[0], force[2]],
            moment: self.moment()[1] + cross(place, force)[1],
        }
    }
}

impl SpatialBeam {
    /// The stress-free curvatures of a beam that is the same all along; none of another one.
    pub(crate) fn uniform_rest_curvature(&self) -> Option<[f64; 3]> {
        match &self.chain.density.profile {
            SpatialProfile::Uniform(station) => Some(station.rest_curvature),
            SpatialProfile::Varying(_) => None,
        }
    }

    /// The state at a share of an element, from 0 to 1: as accurate as the slopes are there.
    pub(crate) fn state_at(&self, at: &State, element: usize, share: f64) -> SpatialSectionState {
        let boundaries = &at.mesh.boundaries;
        let place = boundaries[element] + share * (boundaries[element + 1] - boundaries[element]);
        let (value, _) = self.chain.sample(self.configuration(at), element, 2.0 * share - 1.0);
        self.state_of(place, &value, self.section_at(at, element, share))
    }

    /// The states at the ends of the elements of a range, from nodal forces: as accurate as the energy.
    pub(crate) fn end_states(&self, at: &State, elements: Range<usize>) -> Vec<SpatialSectionState> {
        let (configuration, order) = (self.configuration(at), self.chain.order());
        let forces = self.chain.end_forces(configuration, elements.clone());
        let one = |(end, [x, y, z, m0, m1, m2]): (usize, [f64; 6])| {
            let mut node = [0.0; SPATIAL_FIELDS];
            node.copy_from_slice(&configuration.fields[end * order * SPATIAL_FIELDS..][..SPATIAL_FIELDS]);
            let place = at.mesh.boundaries[end];
            let lying = self.section_of(place, &node, [0.0; 3], [m0, m1, m2]);
            let force = lying.directors.map(|director| dot(director, [x, y, z]));
            self.state_of(place, &node, SpatialSectionPlace { force, ..lying })
        };
        (elements.start..).zip(forces).map(one).collect()
    }

    /// What a section with these fields carries.
    fn state_of(&self, place: f64, value: &[f64; SPATIAL_FIELDS], section: SpatialSectionPlace) -> SpatialSectionState {
        let density = &self.chain.density;
        let [g0, g1, g2, k0, k1, k2] = strains(&density.profile.at(place), &section);
        let (stretch, curvature) = ([g0, g1, g2], [k0, k1, k2]);
        let stored = 0.5 * (dot(section.force, stretch) + dot(section.moment, curvature));
        let load = density.load(place, value);
        SpatialSectionState {
            section,
            stretch,
            curvature,
            stored,
            adhesion: load.energy,
            line_force: load.force,
            line_moment: apply(&matrix(normalised(quaternion_of(value))), &load.moment),
        }
    }
}

/// C⁻¹ times section forces and moments.
fn strains(station: &Station, section: &SpatialSectionPlace) -> [f64; 6] {
    let stiffness = Matrix6::from_fn(|i, j| station.stiffness[i][j]);
    let forces = Vector6::from_iterator(section.force.into_iter().chain(section.moment));
    stiffness.cholesky().map_or([f64::NAN; 6], |factors| factors.solve(&forces).into())
}

/// What the grip exerts on the right end of a beam in space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct GripReactions {
    /// Along x, y and z, nN
    pub force: [f64; 3],
    /// What works on the end's rotation θ, yaw and roll, nN·nm; zeros of an end that turns freely
    pub moment: [f64; 3],
}

/// A section of a beam in space as it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialSectionPlace {
    /// S, nm
    pub arc_length: f64,
    /// x, y, z of the axis, nm
    pub place: [f64; 3],
    /// d1 along the axis, d2 along the width, d3 along the height: x, y, z of each
    pub directors: [[f64; 3]; 3],
    /// b, nm
    pub width: f64,
    /// h, nm
    pub height: f64,
    /// Section forces along the directors, nN: axial, along the width, along the height
    pub force: [f64; 3],
    /// Section moments about the directors, nN·nm: torsion, about the width, about the height
    pub moment: [f64; 3],
}

/// An angle with as many whole turns more as bring it nearest to another one, rad.
fn nearest_turn(angle: f64, other: f64) -> f64 {
    angle + TAU * ((other - angle) / TAU).round()
}

impl SpatialBeam {
    /// What the grip exerts on the end of an equilibrium.
    pub(crate) fn grip_reactions(&self, at: &State) -> GripReactions {
        let end = self.chain.residual_of_right_end(self.configuration(at));
        GripReactions {
            force: apply(&self.chain.ends[1].axes, &[end[0], end[1], end[2]]),
            moment: [end[3], end[4], end[5]],
        }
    }

    /// θ, yaw and roll of the right end, rad. Where it turns freely, θ and roll are what the directors say, with as many whole turns as the
    /// state has counted.
    pub fn angles_of_grip(&self, at: &State) -> [f64; 3] {
        let (end, configuration) = (&self.chain.ends[1], self.configuration(at));
        let counted = configuration.angles[1];
        match end.rotation {
            EndRotation::Angles => counted,
            EndRotation::Free => {
                let [rotation, yaw, roll] = angles(quaternion_of(self.chain.end_node(configuration, 1)), end.rest);
                [nearest_turn(rotation, counted[0]), yaw, nearest_turn(roll, counted[2])]
            }
        }
    }

    /// Counts the turns of a right end that turns freely on, from those of the state before it was moved by less than half of one.
    pub(super) fn count_turns(&self, at: &mut State) {
        if self.chain.ends[1].rotation == EndRotation::Free {
            let (angles, from) = (self.angles_of_grip(at), at.values.len() - 3);
            at.values[from..].copy_from_slice(&angles);
        }
    }

    /// The roll of the right end with how it changes with the three turns there.
    pub(super) fn roll_of_grip(&self, at: &State) -> EndRoll {
        let end = &self.chain.ends[1];
        let by_turns = if end.rotation == EndRotation::Angles {
            [0.0, 0.0, 1.0]
        } else {
            let rest = matrix(end.rest);
            let r = matrix(quaternion_of(self.chain.end_node(self.configuration(at), 1)));
            // what lies along y and z at rest rises above the plane by sine and cosine of the roll, both times the cosine of the yaw
            let [(sin, by_sin), (cos, by_cos)] =
                [rest[1], rest[2]].map(|along| (apply(&r, &along)[2], cross(along, r[2])));
            let square = (sin * sin + cos * cos).max(f64::MIN_POSITIVE);
            std::array::from_fn(|k| (cos * by_sin[k] - sin * by_cos[k]) / square)
        };
        let gradient = std::array::from_fn(|slot| if slot < 3 { 0.0 } else { by_turns[slot - 3] });
        EndRoll { angle: self.angles_of_grip(at)[2], gradient }
    }

    /// A state whose right end is turned by angles, for this beam, whose right end turns freely.
    pub(crate) fn without_angles_of_grip(&self, mut at: State) -> State {
        let angles = at.values.len() - 3;
        at.values[angles..].fill(0.0);
        at
    }

    /// What the grip exerts along x, y and z, and on the end's angles.
    pub(crate) fn grip_forces(&self, at: &State) -> GripForces {
        let reactions = self.grip_reactions(at);
        let ([horizontal, vertical, lateral], [moment, yaw_moment, torque]) = (reactions.force, reactions.moment);
        GripForces { horizontal, vertical, moment, in_space: Some(ForcesInSpace { lateral, yaw_moment, torque }) }
    }

    /// The grip in an equilibrium, seen from an earlier one.
    pub(crate) fn grip_state(&self, at: &State, from: &State) -> GripState {
        let place = |state: &State| -> [f64; 3] {
            let node = self.chain.end_node(self.configuration(state), 1);
            [node[0], node[1], node[2]]
        };
        let (here, there, [rotation, yaw, roll]) = (place(at), place(from), self.angles_of_grip(at));
        GripState {
            x: Some(here[0] - there[0]),
            y: here[1] - there[1],
            rotation,
            in_space: Some(PlaceInSpace { z: here[2] - there[2], yaw, roll }),
            forces: self.grip_forces(at),
        }
    }

    /// The section at a share of an element, from 0 to 1.
    pub(crate) fn section_at(&self, at: &State, element: usize, share: f64) -> SpatialSectionPlace {
        let boundaries = &at.mesh.boundaries;
        let arc_length = boundaries[element] + share * (boundaries[element + 1] - boundaries[element]);
        let (value, slope) = self.chain.sample(self.configuration(at), element, 2.0 * share - 1.0);
        let [force, moment] = self.chain.density.section_forces(arc_length, &value, &slope);
        let mut node = value;
        normalise(&mut node);
        self.section_of(arc_length, &node, force, moment)
    }

    /// A section with these fields, forces along and moments about the directors.
    pub(super) fn section_of(
        &self,
        arc_length: f64,
        node: &[f64],
        force: [f64; 3],
        moment: [f64; 3],
    ) -> SpatialSectionPlace {
        let frame = matrix(quaternion_of(node));
        let station = self.chain.density.profile.at(arc_length);
        SpatialSectionPlace {
            arc_length,
            place: [node[0], node[1], node[2]],
            directors: std::array::from_fn(|d| std::array::from_fn(|i| frame[i][d])),
            width: station.width,
            height: station.height,
            force,
            moment,
        }
    }
}
