//! A beam on its own: nothing adheres, it may be curved at rest, and its ends are held as chosen.

use super::beam_problem::{Beam, BeamProblem};
use super::build::{Discretisation, three_field};
use crate::adhesion::section::barrier::Barrier;
use crate::adhesion::substrate::Substrate;
use crate::beam::mesh::{MeshIntervals, MeshKind, MeshPolicy};
use crate::beam::planar::chain::MOST_FIELDS;
use crate::beam::planar::density::reissner::ReissnerRod;
use crate::beam::planar::model_limits::ModelLimits;
use crate::beam::planar::planar_beam::{BeamMemory, FrontPosition, PlanarBeam};
use crate::beam::reference_configuration::{ReferenceConfiguration, ReferenceCurve};
use crate::beam::section::Section;
use crate::model::peel::Hold;
use crate::solve::problem::{EndConditions, InitialState, MeasuredBeside, PathMeasure};
use crate::solve::system::INTERFACE;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// What an end of a rod does with each of its unknowns: `Fixed` at the value of the rest curve, or `Free`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Support {
    /// Along the substrate
    pub x: Hold,
    /// Normal to it
    pub y: Hold,
    /// Of the section
    pub rotation: Hold,
}

impl Support {
    /// Nothing held.
    pub const FREE: Self = Self { x: Hold::Free, y: Hold::Free, rotation: Hold::Free };
    /// Place held, free to turn.
    pub const HINGED: Self = Self { x: Hold::Fixed, y: Hold::Fixed, rotation: Hold::Free };
    /// Place and rotation held.
    pub const CLAMPED: Self = Self { x: Hold::Fixed, y: Hold::Fixed, rotation: Hold::Fixed };

    /// Whether x, y and θ are held.
    fn held(self) -> [bool; 3] {
        [self.x, self.y, self.rotation].map(|hold| hold == Hold::Fixed)
    }
}

/// Which unknown of the right end is driven.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Drive {
    /// x: the displacement and the force are along x
    X,
    /// y: along y
    Y,
    /// θ: the displacement is an angle in rad and the force an end moment in nN·nm
    Rotation,
}

/// A rod of uniform section: stress-free along `rest`, held at both ends, driven at the right one (S = L).
///
/// The driven unknown must be free at the right end; its conjugate force is what the solver calls the force.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RodModel {
    /// L along the rest curve, nm
    pub length: f64,
    /// EA, GA_s and EI: nN, nN, nN nm²
    pub section: Section,
    /// The stress-free axis
    pub rest: ReferenceCurve,
    /// At S = 0
    pub left: Support,
    /// At S = L
    pub right: Support,
    /// Which unknown of the right end is moved
    pub drive: Drive,
}

/// What is wrong with a [`RodModel`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum RodError {
    #[error("{what} is {value}; it must be a positive finite number")]
    NotPositive { what: &'static str, value: f64 },
    #[error("the rest curve has a number that is not finite: {0:?}")]
    ReferenceConfiguration(ReferenceCurve),
    #[error("{0:?} is driven at the right end and held there as well; it must be free")]
    DrivenAndHeld(Drive),
    #[error("elements of order {0} do not exist; the order is 1 to 8")]
    Order(usize),
}

impl RodModel {
    /// What the solver is given, with elements of order 1 to 8, equally long.
    pub fn problem(&self, order: usize) -> Result<BeamProblem, RodError> {
        self.discretised(order, |_| {})
    }

    /// What its left end holds.
    pub(super) fn pinned_left(&self) -> [Option<f64>; MOST_FIELDS] {
        let (start, left) = (self.rest.at(0.0), self.left.held());
        std::array::from_fn(|f| left[f].then_some(start[f]))
    }

    /// The same, with a beam that `adjust` may change before it is shared.
    pub(super) fn discretised(
        &self,
        order: usize,
        adjust: impl FnOnce(&mut PlanarBeam),
    ) -> Result<BeamProblem, RodError> {
        self.check(order)?;
        let Self { length, section, rest, .. } = *self;
        let start = rest.at(0.0);
        // a force by the moment that bends the rod by a radian
        let moment = section.bending / length;
        let scale: [f64; MOST_FIELDS] = std::array::from_fn(|f| if f == 2 { 1.0 } else { length });
        let mut beam = PlanarBeam {
            chain: three_field(ReissnerRod { section, rest }, order, self.pinned_left()),
            length,
            rest: ReferenceConfiguration::Curve(rest),
            rest_gap: start[1],
            rotation: 2,
            pretension: 0.0,
            stretch: 0.0,
            scale,
            round_off: f64::EPSILON * section.axial.max(section.shear) * length / moment,
            rest_adhesion: 0.0,
            fronts: FrontPosition::Even,
            rest_front: length,
            mesh: MeshPolicy {
                kind: MeshKind::Moving,
                front_foci: Vec::new(),
                edge_foci: Vec::new(),
                fixed_foci: Vec::new(),
                pieces: MeshIntervals::whole(length),
            },
            process_length: length,
            height: 0.0,
            sees_tilt: false,
            barrier: Barrier::Pole,
            substrate: Substrate::Flat,
            memory: BeamMemory::Nothing,
            slip_reach: None,
            conservative: true,
            limits: ModelLimits::default(),
            inertia: None,
        };
        adjust(&mut beam);
        let (mut held, mut scales) = ([false; INTERFACE], [1.0; INTERFACE]);
        held[..MOST_FIELDS].copy_from_slice(&self.right.held());
        scales[..MOST_FIELDS].copy_from_slice(&scale);
        let grip = EndConditions {
            held,
            scale: scales,
            origin: beam.interface_at_rest(),
            ..EndConditions::drive(self.driven())
        };
        let force = if self.drive == Drive::Rotation { moment } else { moment / length };
        let measure = PathMeasure { monitors: [f64::INFINITY, scale[2]], force, beside: MeasuredBeside::Force };
        Ok(BeamProblem::new(Beam::Planar(Arc::new(beam)), grip, measure, InitialState::StressFree))
    }

    fn driven(&self) -> usize {
        match self.drive {
            Drive::X => 0,
            Drive::Y => 1,
            Drive::Rotation => 2,
        }
    }

    fn check(&self, order: usize) -> Result<(), RodError> {
        let Section { axial, shear, bending } = self.section;
        for (what, value) in [("the length", self.length), ("EA", axial), ("GA_s", shear), ("EI", bending)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(RodError::NotPositive { what, value });
            }
        }
        if self.rest.start.iter().chain(&self.rest.curvature).any(|number| !number.is_finite()) {
            return Err(RodError::ReferenceConfiguration(self.rest));
        }
        if self.right.held()[self.driven()] {
            return Err(RodError::DrivenAndHeld(self.drive));
        }
        if (1..=Discretisation::MOST_ORDER).contains(&order) { Ok(()) } else { Err(RodError::Order(order)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rod() -> RodModel {
        RodModel {
            length: 10.0,
            section: Section { axial: 1e3, shear: 1e3, bending: 1.0 },
            rest: ReferenceCurve::default(),
            left: Support::CLAMPED,
            right: Support::FREE,
            drive: Drive::Y,
        }
    }

    #[test]
    fn bad_rods_are_refused_by_name() {
        assert!(rod().problem(3).is_ok());
        assert_eq!(
            RodModel { right: Support::HINGED, ..rod() }.problem(3).err(),
            Some(RodError::DrivenAndHeld(Drive::Y))
        );
        assert_eq!(rod().problem(9).err(), Some(RodError::Order(9)));
        let wrong = RodModel { length: -1.0, ..rod() }.problem(3).err().map(|e| e.to_string());
        assert_eq!(wrong.as_deref(), Some("the length is -1; it must be a positive finite number"));
        let rest = ReferenceCurve { curvature: [f64::NAN, 0.0, 0.0], ..ReferenceCurve::default() };
        assert!(matches!(RodModel { rest, ..rod() }.problem(3).err(), Some(RodError::ReferenceConfiguration(_))));
    }
}
