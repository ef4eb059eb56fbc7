//! A body as it lies on flat ground: its sections and their adhesion, its stress-free configuration, and how a mesh follows its front. It is a beam in
//! space of its own, or a branch of a tree.

use super::stress_free_placement::StressFreePlacement;
use crate::adhesion::spatial_section::error::SpatialSectionError;
use crate::adhesion::spatial_section::section::SpatialSection;
use crate::beam::mesh::{Focus, MeshIntervals, MeshKind, MeshPolicy, Reach};
use crate::beam::reference_configuration::ReferenceConfiguration;
use crate::beam::spatial::rest::{RestOutline, SpatialRest, SpatialRestCurve};
use crate::beam::spatial::section::branch_sections::AdheringSections;
use crate::beam::spatial::section::lying_section::LyingSection;
use crate::beam::spatial::section::spatial_profile::SpatialProfile;
use crate::beam::varying::Varying;
use crate::model::peel::{PeelModel, Space};
use crate::model::step::Step;
use std::sync::Arc;

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

/// A body that adheres, from its free end at S = 0.
#[derive(Clone, Debug)]
pub struct BodyBranch {
    /// Its sections and their adhesion
    pub sections: Arc<AdheringSections>,
    /// Stress-free, lying along x on the ground
    pub rest: Arc<SpatialRest>,
    /// nm
    pub length: f64,
    /// How its elements follow the front
    pub mesh: Arc<MeshPolicy>,
}

impl PeelModel {
    /// Its body as a branch of a tree.
    ///
    /// # Errors
    /// A law that has no adhesion of sections in space; a work of slip that is not that of opening, which has no potential.
    pub fn branch(&self) -> Result<BodyBranch, SpatialSectionError> {
        let space = Space::default();
        if self.adhesion.sheared_law().is_some_and(|law| !law.has_potential()) {
            return Err(SpatialSectionError::TwoWorks);
        }
        Ok(self.on_ground(&space, self.spatial_section(&space)?))
    }

    /// Its body as it lies on the ground.
    pub(super) fn on_ground(&self, space: &Space, section: SpatialSection) -> BodyBranch {
        let ((width, height), length) = (self.free_end(), self.length());
        let varying = self.contour().map(|contour| Varying::new(contour, self.material()));
        let (stiffness, held_law) = (self.spatial_stiffness(space), self.adhesion.sheared_law());
        let lying = LyingSection::of(&section, &stiffness);
        let LyingSection { gap_scale, process_length, .. } = lying;
        let edge = (0.36 * process_length).min(0.25 * gap_scale);
        let front = Focus { center: 0.0, length: process_length, weight: 1.0, reach: Reach::Far };
        // behind the front the strip twists off within √(12 GJ / (b² Ψ_yy))
        let twist_length = (12.0 * stiffness.0[3][3] / (width * width * lying.stiffness)).sqrt();
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
                let rest = SpatialRestCurve::along_x(lying.height).into();
                (profile, rest, MeshIntervals::whole(length), [vec![front, twist], Vec::new()])
            }
            Some(beam) => {
                fixed_foci.push(even);
                let (rest, pieces) = self.rest_outline(&beam, &[letting_go; 2], &mut fixed_foci);
                (SpatialProfile::Varying(beam), rest, pieces, [Vec::new(), vec![letting_go]])
            }
        };
        let mesh = MeshPolicy { kind: MeshKind::Moving, front_foci, edge_foci, fixed_foci, pieces };
        BodyBranch {
            sections: Arc::new(AdheringSections { profile, law: section, held: held_law, lying }),
            rest: Arc::new(rest),
            length,
            mesh: Arc::new(mesh),
        }
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
}
