//! Where a section that stands upright on a pressed edge holds the beam: a corner of the energy.
//!
//! The face that looks down is another one on either side of θ = 90 degrees. A law of that face has Ψ = W(r), r = y - (h/2)|cos θ| above the height of
//! the axis, whose slope by θ changes there from -T h/2 to +T h/2, T = -W' the traction, above zero where the edge is pressed. Then the energy has a
//! corner that is a least value: an upright section stays upright under any moment between the two, and so do those beside it over some length, where
//! nothing but the corner holds them. No smooth solution goes on from there.

use super::model_limits::{PoleInReach, UprightCorner, UprightSection};
use super::planar_beam::PlanarBeam;
use crate::solve::state::State;

/// A section with a smaller |cos θ| is upright, where a path cannot be continued.
const UPRIGHT: f64 = 1e-3;
/// To either side of upright: where a corner is told from a curve.
const BESIDE: f64 = 1e-9;
/// A jump of the line moment below this share of the work of adhesion per length holds nothing.
const WEAK: f64 = 1e-2;

impl PlanarBeam {
    /// The first section of a state, from the free end on, that stands upright on a pressed edge.
    pub fn held_upright(&self, at: &State) -> Option<UprightSection> {
        let corner = self.limits.corner.as_ref()?;
        self.elements_near_upright(at).find_map(|element| {
            let looks = self.looks(at, element);
            let [place, axis, rotation] = *looks.iter().min_by(|a, b| a[2].cos().abs().total_cmp(&b[2].cos().abs()))?;
            let cosine = rotation.cos().abs();
            let moment = self.moment_jump(corner, place, axis, rotation.sin().signum());
            let held = cosine < UPRIGHT && moment > WEAK * self.rest_adhesion.abs();
            held.then(|| UprightSection {
                place,
                height: axis + 0.5 * self.height_at(place),
                pole: PoleInReach::Edge { cosine, moment: 0.5 * moment },
            })
        })
    }

    /// How much b ∂Ψ/∂θ grows where a section turns through upright, nN; `side` is the sign of sin θ.
    fn moment_jump(&self, corner: &UprightCorner, place: f64, axis: f64, side: f64) -> f64 {
        let height = self.height_at(place);
        let slope = |cos: f64| corner.law.response_of(height, axis, side, cos).by_rotation;
        // cos θ falls with θ where sin θ is above zero
        (corner.width)(place) * (slope(-side * BESIDE) - slope(side * BESIDE))
    }
}
