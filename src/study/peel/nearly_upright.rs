//! A mesh that resolves sections which are nearly upright, in the reach of a pole of their law.
//!
//! Where a beam hangs between its front and its grip, an upright pull brings its sections near to 90 degrees. The energy of the near face alone,
//! -b|W|/cos θ, softens a tilt there by 2b|W|/cos³θ, and tension and bending hold it with V + EI/y², y the height. Where they no longer do is a displacement
//! limit point of the path, behind which cos θ falls to nothing at one place. Elements that follow the front are too long there to see it.

use crate::beam::mesh::{Focus, Reach};
use crate::beam::planar::model_limits::{PoleInReach, UprightSection};
use crate::model::peel::PeelModel;
use crate::model::problem::beam_problem::BeamProblem;
use crate::model::problem::build::Discretisation;
use crate::study::accuracy::Resolution;
use std::sync::Arc;

/// Length of the elements at such a section over that over which the pole bends the beam.
const ELEMENT: f64 = 0.33;
/// The same where that was not short enough, over the time before.
const SHORTER: f64 = 0.6;

/// Where elements are small because sections there are nearly upright.
pub(super) struct NearlyUpright {
    foci: Vec<Focus>,
    /// How many elements of the mesh those are.
    elements: usize,
    /// Over the length that was taken at first.
    share: f64,
}

impl NearlyUpright {
    /// No such section.
    pub(super) const fn nowhere() -> Self {
        Self { foci: Vec::new(), elements: 0, share: 1.0 }
    }

    /// The problem on a mesh that resolves a section which this one does not, and the elements it takes.
    pub(super) fn resolved(
        &mut self,
        (model, how): (&PeelModel, Discretisation),
        problem: &BeamProblem,
        section: &UprightSection,
        resolution: Resolution,
    ) -> Option<(Arc<BeamProblem>, Resolution)> {
        let PoleInReach::Unresolved { length, .. } = section.pole else { return None };
        let (beam, whole) = (problem.beam.planar()?, model.length());
        // what hangs is as long as it is high, at least
        let hanging = section.height.max(whole - section.place).min(whole);
        let front = (section.place - hanging).max(0.0);
        let at_front = beam.mesh.front_foci.iter().map(|focus| Focus { center: front + focus.center, ..*focus });
        let others: Vec<Focus> = at_front.chain(beam.mesh.fixed_foci.iter().copied()).collect();
        let before = resolution.elements - self.elements;
        let each = Focus::between(&others, 0.0, whole) / before as f64;
        if !self.foci.is_empty() {
            self.share *= SHORTER;
        }
        let weight = each * hanging / (ELEMENT * self.share * length);
        let focus = Focus { center: section.place, length: hanging, weight, reach: Reach::Near };
        self.foci.retain(|other| (other.center - section.place).abs() > hanging);
        self.foci.push(focus);
        self.elements = (Focus::between(&self.foci, 0.0, whole) / each).ceil() as usize;
        let finer = resolution.with_elements((before + self.elements) as f64);
        Some((Arc::new(model.with_foci(problem, how, &self.foci)?), finer))
    }
}
