//! A problem whose system is a beam, in the plane or in space.

use crate::adhesion::substrate::Substrate;
use crate::beam::grip_state::{GripForces, GripState};
use crate::beam::planar::planar_beam::PlanarBeam;
use crate::beam::spatial::rotation::{Matrix3, apply_transposed};
use crate::beam::spatial::spatial_beam::SpatialBeam;
use crate::solve::problem::{EndConditions, InitialState, MeasuredBeside, PathMeasure, Problem};
use crate::solve::state::{Mesh, State};
use crate::solve::system::System;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

/// The beam of a problem.
#[derive(Clone)]
pub enum Beam {
    /// In the plane
    Planar(Arc<PlanarBeam>),
    /// In space
    Spatial(Arc<SpatialBeam>),
}

impl Beam {
    /// The planar one, where it is one: what only the plane knows is asked of it.
    pub fn planar(&self) -> Option<&Arc<PlanarBeam>> {
        if let Self::Planar(beam) = self { Some(beam) } else { None }
    }

    /// The one in space, where it is one.
    pub(crate) fn spatial(&self) -> Option<&Arc<SpatialBeam>> {
        if let Self::Spatial(beam) = self { Some(beam) } else { None }
    }

    /// What a solver sees.
    pub fn system(&self) -> Arc<dyn System> {
        match self {
            Self::Planar(beam) => beam.clone(),
            Self::Spatial(beam) => beam.clone(),
        }
    }

    /// What it is on.
    pub(crate) fn substrate(&self) -> &Substrate {
        match self {
            Self::Planar(beam) => &beam.substrate,
            Self::Spatial(_) => &Substrate::Flat,
        }
    }

    /// Slot of the interface for the rotation.
    pub(crate) fn slot_of_rotation(&self) -> usize {
        match self {
            Self::Planar(beam) => beam.slot_of_rotation(),
            Self::Spatial(_) => ROTATION,
        }
    }

    /// Order p of its elements.
    pub fn order(&self) -> usize {
        match self {
            Self::Planar(beam) => beam.chain.order(),
            Self::Spatial(beam) => beam.chain.order(),
        }
    }

    /// L, nm
    pub fn length(&self) -> f64 {
        match self {
            Self::Planar(beam) => beam.length,
            Self::Spatial(beam) => beam.length,
        }
    }

    /// Length ℓ of the process zone, nm; L where nothing adheres
    pub(crate) fn process_length(&self) -> f64 {
        match self {
            Self::Planar(beam) => beam.process_length,
            Self::Spatial(beam) => beam.process_length,
        }
    }

    /// Adhesion energy per length at rest at the left end, nN.
    pub(crate) fn rest_adhesion(&self) -> f64 {
        match self {
            Self::Planar(beam) => beam.rest_adhesion,
            Self::Spatial(beam) => beam.rest_adhesion,
        }
    }

    /// S of a front, nm.
    pub(crate) fn front_place(&self, front: f64) -> f64 {
        match self {
            Self::Planar(beam) => beam.fronts.place(front),
            Self::Spatial(beam) => beam.rest.fronts().place(front),
        }
    }

    /// Whether no part of the beam is nearer to the substrate than `far`, nm.
    pub fn is_clear(&self, at: &State, far: f64) -> bool {
        match self {
            Self::Planar(beam) => beam.is_clear(at, far),
            Self::Spatial(beam) => beam.is_clear(at, far),
        }
    }

    /// How much farther than `far` the beam is from what attracts it, nm.
    pub(crate) fn beyond(&self, at: &State, far: f64) -> f64 {
        match self {
            Self::Planar(beam) => beam.beyond(at, far),
            Self::Spatial(beam) => beam.beyond(at, far),
        }
    }

    /// Distance of the beam from the substrate, nm.
    pub fn nearest(&self, at: &State) -> f64 {
        match self {
            Self::Planar(beam) => beam.nearest(at),
            Self::Spatial(beam) => beam.nearest(at),
        }
    }

    /// Distance of the beam from what it cannot pass, nm: the pole of a half space at the distance zero; above the spring of a cohesive law it is
    /// never zero.
    pub(crate) fn clearance(&self, at: &State) -> f64 {
        match self {
            Self::Planar(beam) => beam.clearance(at),
            Self::Spatial(beam) => beam.clearance(at),
        }
    }

    /// The mesh for a front and [`Mesh::follows`] with as many elements as another one.
    pub(crate) fn mesh_near(&self, front: f64, follows: &[f64], like: &Mesh) -> Mesh {
        match self {
            Self::Planar(beam) => beam.mesh_near(front, like),
            Self::Spatial(beam) => beam.mesh_near(front, follows, like),
        }
    }

    /// A state read off on another mesh.
    pub fn resampled(&self, at: &State, mesh: Mesh) -> State {
        match self {
            Self::Planar(beam) => beam.resampled(at, mesh),
            Self::Spatial(beam) => beam.resampled(at, mesh),
        }
    }

    /// The numbers of a state of this beam, or of one that is pulled in another direction.
    pub(crate) fn adopted<'a>(&self, at: &'a State) -> Cow<'a, [f64]> {
        match self {
            Self::Planar(beam) => beam.adopted(at),
            Self::Spatial(_) => Cow::Borrowed(&at.values),
        }
    }

    /// What the grip exerts on the end of an equilibrium.
    pub fn grip_forces(&self, at: &State) -> GripForces {
        match self {
            Self::Planar(beam) => beam.grip_forces(at),
            Self::Spatial(beam) => beam.grip_forces(at),
        }
    }

    /// The grip in an equilibrium, seen from an earlier one.
    pub(crate) fn grip_state(&self, at: &State, from: &State) -> GripState {
        match self {
            Self::Planar(beam) => beam.grip_state(at, from),
            Self::Spatial(beam) => beam.grip_state(at, from),
        }
    }

    /// A mesh of its own for a front and [`Mesh::follows`].
    pub(crate) fn mesh_at(&self, front: f64, follows: &[f64], elements: usize) -> Mesh {
        match self {
            Self::Planar(beam) => beam.mesh_at(front, elements),
            Self::Spatial(beam) => beam.mesh_at(front, follows, elements),
        }
    }
}

/// A beam in a grip, with the start of its path.
#[derive(Clone)]
pub struct BeamProblem {
    problem: Problem,
    /// What the solver sees as a system
    pub beam: Beam,
}

impl Deref for BeamProblem {
    type Target = Problem;

    fn deref(&self) -> &Problem {
        &self.problem
    }
}

impl DerefMut for BeamProblem {
    fn deref_mut(&mut self) -> &mut Problem {
        &mut self.problem
    }
}

impl BeamProblem {
    /// A beam in a grip.
    pub fn new(beam: Beam, grip: EndConditions, measure: PathMeasure, start: InitialState) -> Self {
        Self { problem: Problem { system: beam.system(), grip, measure, start }, beam }
    }

    /// Makes the right end of a beam in space move along these axes: the columns, in the order of its interface. States stay what they are.
    pub(crate) fn move_along(&mut self, axes: Matrix3) {
        if let Beam::Spatial(beam) = &self.beam {
            let mut beam = SpatialBeam::clone(beam);
            beam.chain.ends[1].axes = axes;
            self.beam = Beam::Spatial(beam.into());
            self.problem.system = self.beam.system();
        }
    }

    /// Whether the vertical plane of the body at rest is one of symmetry: it is pulled within that, and what the grip holds does not lead out of it.
    pub(crate) fn has_plane_of_symmetry(&self) -> bool {
        let Beam::Spatial(beam) = &self.beam else { return true };
        let (axes, grip) = (&beam.chain.ends[1].axes, &self.problem.grip);
        let is_zero = |number: f64| number.abs() <= ROUNDED;
        let in_plane = |slot: usize| is_zero(axes[2][slot]);
        let normal = |slot: usize| is_zero(axes[0][slot]) && is_zero(grip.origin[slot]);
        in_plane(ALONG)
            && [ACROSS, SIDEWAYS].iter().all(|&slot| !grip.held[slot] || in_plane(slot) || normal(slot))
            && [YAW, ROLL].iter().all(|&slot| !grip.held[slot] || is_zero(grip.origin[slot]))
    }

    /// The same problem with its paths measured by this beside the monitors and the displacement.
    pub fn measured_beside(&self, beside: MeasuredBeside) -> Self {
        let measure = PathMeasure { beside, ..self.problem.measure };
        Self { problem: Problem { measure, ..self.problem.clone() }, beam: self.beam.clone() }
    }

    /// The same problem of another beam.
    pub(super) fn with_beam(&self, beam: Beam) -> Self {
        Self { problem: Problem { system: beam.system(), ..self.problem.clone() }, beam }
    }

    /// The same problem under other end conditions.
    pub fn with_grip(&self, grip: EndConditions) -> Self {
        Self { problem: Problem { grip, ..self.problem.clone() }, beam: self.beam.clone() }
    }
}

/// A pull that is off the vertical plane of the strip by less, rad, is in that plane.
pub(super) const ROUNDED: f64 = 1e-12;

/// Slots of the interface: along the pull, across it in its vertical plane, sideways, and the three angles.
pub(crate) const ALONG: usize = 0;

pub(crate) const ACROSS: usize = 1;

pub(crate) const SIDEWAYS: usize = 2;

pub(crate) const ROTATION: usize = 3;

pub(crate) const YAW: usize = 4;

pub(crate) const ROLL: usize = 5;

/// How the right end of a strip in space is turned, beside its rotation in the plane, and what the grip exerts, beside
/// the force along the pull. A reaction is exactly zero where the grip does not hold what it works on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SpatialGrip {
    /// ρ about the axis, rad: of the directors Rz(θ) Ry(ψ) Rx(ρ)
    pub roll: f64,
    /// ψ, rad
    pub yaw: f64,
    /// Moment on the roll, nN·nm
    pub torque: f64,
    /// Force across the pull in its vertical plane, nN: along (sin α cos β, -cos α, sin α sin β) for the elevation α and
    /// the azimuth β
    pub across: f64,
    /// Force normal to the vertical plane of the pull, nN: along (-sin β, 0, cos β)
    pub lateral: f64,
}

impl BeamProblem {
    /// The same strip in space in a grip that holds its end at this roll, rad, or lets it roll.
    pub(crate) fn with_roll(&self, roll: Option<f64>) -> Self {
        let mut grip = self.grip;
        grip.held[ROLL] = roll.is_some();
        grip.origin[ROLL] = roll.unwrap_or(0.0);
        self.with_grip(grip)
    }

    /// The grip at an equilibrium of a strip in space; none of one in the plane.
    pub(crate) fn spatial_grip(&self, at: &State) -> Option<SpatialGrip> {
        let beam = self.beam.spatial()?;
        let [_, yaw, roll] = beam.angles_of_grip(at);
        let reactions = beam.grip_reactions(at);
        let along = apply_transposed(&beam.chain.ends[1].axes, &reactions.force);
        let held = |slot: usize, value: f64| if self.grip.held[slot] { value } else { 0.0 };
        Some(SpatialGrip {
            roll,
            yaw,
            torque: held(ROLL, reactions.moment[2]),
            across: held(ACROSS, along[ACROSS]),
            lateral: held(SIDEWAYS, along[SIDEWAYS]),
        })
    }
}
