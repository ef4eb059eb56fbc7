//! What a section of a beam in space carries, and what is the same at all sections of one beam.
//!
//! Over flat ground without friction a uniform beam in equilibrium has four integrals, whatever loads its ends: with the section force n, the
//! moment m and the stress-free curvatures K0 in the axes of the directors,
//!
//!   n·r' + m·K - stored - Ψ = n·d1 + m·K0 + stored - Ψ,    n_x,    n_z,    m_y + (r × n)_y
//!
//! are the same all along it: the density depends neither on S nor on x, z and the turn about y (Noether). The last three hold of the
//! elements as well, to round-off; the first one holds of the exact solution, and shows the error of a mesh.

use super::kinematics::{Kinematics, SPATIAL_FIELDS};
use super::local_adhesion::LocalAdhesion;
use super::spatial_profile::{SpatialProfile, Station};
use crate::beam::spatial::rotation::{apply, cross, dot};
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::beam::spatial::spatial_grip::SpatialSectionPlace;
use crate::solve::state::State;
use nalgebra::{Matrix6, Vector6};
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
    /// Ψ_y e_y per length, nN/nm: x, y, z
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
    pub fn moment(&self) -> [f64; 3] {
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
    pub fn uniform_rest_curvature(&self) -> Option<[f64; 3]> {
        match &self.chain.density.profile {
            SpatialProfile::Uniform(station) => Some(station.rest_curvature),
            SpatialProfile::Varying(_) => None,
        }
    }

    /// The state at a share of an element, from 0 to 1: as accurate as the slopes are there.
    pub fn state_at(&self, at: &State, element: usize, share: f64) -> SpatialSectionState {
        let boundaries = &at.mesh.boundaries;
        let place = boundaries[element] + share * (boundaries[element + 1] - boundaries[element]);
        let (value, _) = self.chain.sample(self.configuration(at), element, 2.0 * share - 1.0);
        self.state_of(place, &value, self.section_at(at, element, share))
    }

    /// The states at the ends of the elements of a range, from nodal forces: as accurate as the energy.
    pub fn end_states(&self, at: &State, elements: Range<usize>) -> Vec<SpatialSectionState> {
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
        let station = density.profile.at(place);
        let [g0, g1, g2, k0, k1, k2] = strains(&station, &section);
        let (stretch, curvature) = ([g0, g1, g2], [k0, k1, k2]);
        let stored = 0.5 * (dot(section.force, stretch) + dot(section.moment, curvature));
        let at = Kinematics::new(value, &[0.0; SPATIAL_FIELDS]);
        let load = density.adhesion.as_ref().map(|law| LocalAdhesion::new(law, &at, value[1], &station));
        let load = load.unwrap_or_else(LocalAdhesion::none);
        // turned by exp(φ/2), the quaternion changes with φ/2
        let [_, x, y, z] = load.by_value.map(|by| 0.5 * by);
        SpatialSectionState {
            section,
            stretch,
            curvature,
            stored,
            adhesion: load.energy,
            line_force: [0.0, load.by_height, 0.0],
            line_moment: apply(&at.frame, &[x, y, z]),
        }
    }
}

/// C⁻¹ times section forces and moments.
fn strains(station: &Station, section: &SpatialSectionPlace) -> [f64; 6] {
    let stiffness = Matrix6::from_fn(|i, j| station.stiffness[i][j]);
    let forces = Vector6::from_iterator(section.force.into_iter().chain(section.moment));
    stiffness.cholesky().map_or([f64::NAN; 6], |factors| factors.solve(&forces).into())
}
