//! What the sections of a branch of a tree are, and whether they adhere to the flat ground y = 0.
//!
//! A branch that adheres has the sections of a beam in space, which may vary along it, with their adhesion. Its nodes near the ground are measured
//! by how far the lowest point of their section is from one that lies there, as those of [`crate::beam::SpatialBeam`].

use super::density::SpatialDensity;
use super::held_sections::HeldSections;
use super::kinematics::SPATIAL_FIELDS;
use super::lying_section::LyingSection;
use super::spatial_profile::{SpatialProfile, SpatialStiffness, Station};
use crate::adhesion::section::barrier::Barrier;
use crate::adhesion::section::sheared::ShearedLaw;
use crate::adhesion::spatial_section::section::{SectionShape, SpatialSection};
use crate::beam::spatial::rest::BranchRest;
use crate::beam::spatial::rotation::{matrix, normalised};
use std::sync::Arc;

/// What the sections of a branch are.
#[derive(Clone, Debug)]
pub enum BranchSections {
    /// The same all along; nothing adheres.
    Uniform(Box<SpatialStiffness>),
    /// They adhere to the ground, and may vary. Branches that share them are computed side by side.
    Adhering(Arc<AdheringSections>),
}

/// Sections that adhere.
#[derive(Clone, Debug)]
pub struct AdheringSections {
    /// Stiffness and outline along S, with the curvature at rest, and the adhesion
    pub profile: SpatialProfile,
    /// The law
    pub law: SpatialSection,
    /// What holds them along the ground as well, where they lie without stress; none: they slide
    pub(crate) held: Option<ShearedLaw>,
    /// The section at S = 0 as it lies on the ground
    pub lying: LyingSection,
}

impl AdheringSections {
    /// Height of the lowest point of a section at S with these fields above the ground, nm.
    pub(in crate::beam::spatial) fn lowest(&self, place: f64, fields: &[f64; SPATIAL_FIELDS]) -> f64 {
        lowest(self.profile.outline(place), self.law.shape(), fields)
    }

    /// What keeps it out of the ground.
    pub(in crate::beam::spatial) fn barrier(&self) -> Barrier {
        self.law.law().barrier()
    }
}

/// Height of the lowest point of a section of this outline, b and h, with these fields above the ground, nm.
pub(in crate::beam::spatial) fn lowest(
    [width, height]: [f64; 2],
    shape: SectionShape,
    fields: &[f64; SPATIAL_FIELDS],
) -> f64 {
    let [_, y, _, turn @ ..] = *fields;
    let [_, up, _] = matrix(normalised(turn));
    let (aside, up) = (width * up[1], height * up[2]);
    y - 0.5
        * match shape {
            SectionShape::Ellipse => aside.hypot(up),
            SectionShape::Rectangle => aside.abs() + up.abs(),
        }
}

impl BranchSections {
    /// What is integrated along a branch with this configuration at rest.
    pub(in crate::beam::spatial) fn density(&self, rest: &BranchRest) -> Arc<SpatialDensity> {
        let density = match self {
            Self::Uniform(stiffness) => {
                let station =
                    Station { stiffness: stiffness.0, rest_curvature: rest.curvature(), width: 0.0, height: 0.0 };
                SpatialDensity { profile: SpatialProfile::Uniform(Box::new(station)), adhesion: None, held: None }
            }
            Self::Adhering(own) => {
                let held = own.held.map(|law| HeldSections { law, rest: rest.clone() });
                SpatialDensity { profile: own.profile.clone(), adhesion: Some(own.law), held }
            }
        };
        Arc::new(density)
    }

    /// What adheres, if anything does.
    pub(in crate::beam::spatial) fn adhering(&self) -> Option<&Arc<AdheringSections>> {
        match self {
            Self::Uniform(_) => None,
            Self::Adhering(own) => Some(own),
        }
    }

    /// Whether elements of two branches may be computed side by side: not where each is held at a place of its own.
    pub(in crate::beam::spatial) fn is_alike(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Uniform(one), Self::Uniform(other)) => one == other,
            (Self::Adhering(one), Self::Adhering(other)) => Arc::ptr_eq(one, other) && one.held.is_none(),
            _ => false,
        }
    }
}
