//! What a solid spatula lies on: a half space, whose surface may be uneven along the spatula and is the same across it.
//!
//! With the distance d of a point from the surface, its normal n and its tangent t there, κ the curvature of the surface and μ = κ/(1 - κd),
//!
//!   W(d),   ∇W = -T n,   ∇∇W = B n⊗n + T μ t⊗t,
//!
//! T = -W' and B = -T', as ∇∇d = -μ t⊗t ([`crate::adhesion::Substrate`]).

use crate::adhesion::levels::half_space::HalfSpace;
use crate::adhesion::substrate::Substrate;

/// A half space with its surface.
#[derive(Clone, Debug)]
pub(super) struct SolidGround {
    pub half_space: HalfSpace,
    pub substrate: Substrate,
}

/// What the ground does to a point: per area, by x and y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct GroundResponse {
    /// W, nN/nm
    pub energy: f64,
    /// ∇W, nN/nm²
    pub gradient: [f64; 2],
    /// ∇∇W by xx, xy and yy, nN/nm³
    pub hessian: [f64; 3],
}

impl SolidGround {
    /// At a place (x, y), nm.
    pub(super) fn at(&self, [x, y]: [f64; 2]) -> GroundResponse {
        let foot = self.substrate.project(x, y);
        let [energy, traction, slope] = self.half_space.levels(foot.distance);
        let bent = traction * foot.curvature / (1.0 - foot.curvature * foot.distance);
        let (sin, cos) = (foot.sin, foot.cos);
        GroundResponse {
            energy,
            gradient: [traction * sin, -traction * cos],
            hessian: [
                slope * sin * sin + bent * cos * cos,
                (bent - slope) * sin * cos,
                slope * cos * cos + bent * sin * sin,
            ],
        }
    }

    /// How far a place is from the surface, nm, and the normal there.
    pub(super) fn distance(&self, [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
        let foot = self.substrate.project(x, y);
        (foot.distance, [-foot.sin, foot.cos])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Sixth order differences, over a crest, a slope and a valley.
    #[test]
    fn gradient_and_hessian_are_differences() {
        let mut substrate = Substrate::all().into_iter().find(|(name, _)| *name == "sinusoid").unwrap().1;
        for (key, value) in [("height", 8.0), ("wavelength", 100.0), ("offset", 0.0)] {
            *substrate.number(key).unwrap() = value;
        }
        let half_space = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
        let ground = SolidGround { half_space, substrate };
        for (x, above) in [(0.3, 0.24), (21.0, 0.4), (52.0, 0.9), (80.0, 0.3)] {
            let place = [x, ground.substrate.above(x, above)];
            let here = ground.at(place);
            let step = 1e-3;
            let slope = |of: &dyn Fn(&GroundResponse) -> f64, axis: usize| {
                let moved = |k: f64| {
                    let mut moved = place;
                    moved[axis] += k * step;
                    of(&ground.at(moved))
                };
                let pair = |k: f64| moved(k) - moved(-k);
                (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * step)
            };
            for axis in 0..2 {
                assert_relative_eq!(
                    slope(&|at| at.energy, axis),
                    here.gradient[axis],
                    epsilon = 1e-9,
                    max_relative = 1e-7
                );
                for i in 0..2 {
                    let own = here.hessian[i + axis];
                    assert_relative_eq!(slope(&|at| at.gradient[i], axis), own, epsilon = 1e-8, max_relative = 1e-6);
                }
            }
        }
    }
}
