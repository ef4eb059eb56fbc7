//! A finite step of Newton's method that does not stretch the beam.
//!
//! A beam is far stiffer along its axis than in bending. An update that is linear in y and θ turns a section by δθ and leaves
//! y' - sin θ off by ½ sin θ δθ²: a vertical section force of GA_s times that, which no linearisation has foreseen and which is
//! far above the true one where little pulls on a long beam. The next tangent is that of a beam under this force and its
//! update takes it off, blind to whatever is soft; then all begins again. So y follows the force instead: at each Gauss point y' becomes
//! what it is under the force V + δV of the linearisation, and y is the integral of that from the left end, exact with p points
//! and order p. Forces are the unknowns of Newton's method then, as in the mixed integration point method.
//!
//! Source: D. Magisano, L. Leonetti, G. Garcea, How to improve efficiency and robustness of the Newton method in geometrically
//! non-linear structural problems discretized via displacement-based finite elements, Comput. Methods Appl. Mech. Engrg. 313 (2017) 986-1005.

use super::elements::UniformChain;
use crate::beam::element::energy_density::Point;
use crate::beam::element::integration::Element;
use crate::beam::planar::chain::Configuration;
use crate::number::{F64x4, Real};
use crate::solve::frontal::nodes::{BUNDLE, MOST_NODES, Nodes, slot};

/// [`UniformChain::follow`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
pub(super) fn follow_force<N: Nodes, const F: usize>(
    chain: &UniformChain<F>,
    ends: &[f64],
    state: &mut [f64],
    direction: &[f64],
    axial: [f64; 2],
) {
    chain.follow(N::of_order(chain.basis.order), ends, state, direction, axial);
}

impl<const F: usize> UniformChain<F> {
    /// [`super::Chain::follow_force`]
    #[inline(always)]
    fn follow(&self, nodes: impl Nodes, ends: &[f64], state: &mut [f64], direction: &[f64], axial: [f64; 2]) {
        let (elements, order, up) = (ends.len() - 1, nodes.count() - 1, F - 2);
        let left_end = slot(nodes.count(), 0);
        let zero = F64x4::splat(0.0);
        let (mut bundle, mut changes) = (Element::zero(), Element::zero());
        let mut points = [Point::zero(); MOST_NODES];
        let (mut steps, mut beyond) = ([Point::zero(); MOST_NODES], [zero; MOST_NODES]);
        // what is added to the end that two bundles share, and what it was before
        let (mut lifted, mut shared) = (0.0, state[up]);
        for first in (0..elements).step_by(BUNDLE) {
            let at = Configuration { ends, state, axial_multiplier: axial[0], history: None, strains: None };
            self.gather_bundle(nodes, at, first, &mut bundle);
            bundle.values[left_end][up].0[0] = shared;
            (changes.from, changes.length) = (bundle.from, bundle.length);
            changes.values = self.gather_values(nodes, direction, first, elements);
            for q in 0..order {
                points[q] = bundle.point(nodes, &self.basis, q);
                steps[q] = changes.point(nodes, &self.basis, q);
            }
            self.density.slopes_beyond_step(&points[..order], &steps[..order], axial, &mut beyond);
            for e in first..elements.min(first + BUNDLE) {
                let (l, start) = (e - first, lifted);
                for rank in 1..=order {
                    let mut rise = 0.0;
                    for q in 0..order {
                        rise += self.basis.primitive[slot(nodes.count(), rank)][q] * beyond[q].0[l];
                    }
                    lifted = start + 0.5 * (ends[e + 1] - ends[e]) * rise;
                    let place = (e * order + rank) * F + up;
                    shared = state[place];
                    state[place] += lifted;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::{HalfSpace, Law, LineLaw, LineLoad, TiltCount};
    use crate::beam::{Chain, Profile, ReducedBeam, Section};

    const PLACES: [f64; 6] = [0.0, 0.4, 1.1, 2.0, 3.5, 4.0];

    /// V at every Gauss point.
    fn forces(chain: &UniformChain<2>, state: &[f64], axial_multiplier: f64) -> Vec<f64> {
        let at = Configuration { ends: &PLACES, state, axial_multiplier, history: None, strains: None };
        let points = &chain.basis.points[..chain.basis.order];
        let of = |e: usize| points.iter().map(move |&local| chain.sample(at, e, local).1.vertical_force);
        (0..PLACES.len() - 1).flat_map(of).collect()
    }

    /// Rotations of half a radian, in five elements, so that a bundle is not full: behind the step V is what differences say that it changes by,
    /// and the left end and the rotations are where the step alone puts them.
    fn follows<const HELD: bool>(order: usize) {
        let half_space = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
        let law = LineLaw { half_space, height: 10.0, law: Law::BodyForce, line_load: LineLoad::Full, far_face: true };
        let profile = Profile::uniform(Section { axial: 20.0, shear: 7.0, bending: 160.0 }, 1.0, 10.0);
        let density = ReducedBeam::<HELD> { profile, law, count: TiltCount::Coarse };
        let chain = UniformChain::<2>::new::<HELD>(Box::new(density), order, [None; 2]);
        let nodes = (PLACES.len() - 1) * order + 1;
        let wave = |k: usize, phase: f64| (0.8 * k as f64 * 7.0 / order as f64 + phase).sin();
        let state: Vec<f64> = (0..nodes).flat_map(|k| [0.4 + 0.1 * wave(k, 0.3), 0.7 + 0.3 * wave(k, 1.0)]).collect();
        let step: Vec<f64> = (0..nodes).flat_map(|k| [0.2 * wave(k, 2.0), 0.5 * wave(k, 4.0)]).collect();
        let axial = if HELD { [0.6, -0.25] } else { [0.0; 2] };
        let ahead = |part: f64| {
            let state: Vec<f64> = state.iter().zip(&step).map(|(value, change)| value + part * change).collect();
            forces(&chain, &state, axial[0] + part * axial[1])
        };
        let (little, from) = (1e-5, forces(&chain, &state, axial[0]));
        let (up, down) = (ahead(little), ahead(-little));
        let mut after = state.clone();
        chain.follow_force(&PLACES, &mut after, &step, axial);
        assert_eq!(after[0], state[0]);
        assert!(after.iter().zip(&state).skip(1).step_by(2).all(|(after, before)| after == before));
        after.iter_mut().zip(&step).for_each(|(value, change)| *value += change);
        let largest = from.iter().fold(0.0f64, |largest, force| largest.max(force.abs()));
        let found = forces(&chain, &after, axial[0] + axial[1]);
        for (k, found) in found.iter().enumerate() {
            let expected = from[k] + (up[k] - down[k]) / (2.0 * little);
            assert!((found - expected).abs() < 1e-8 * largest, "order {order}, point {k}: {found} {expected}");
        }
        let linear = ahead(1.0);
        let off = linear.iter().zip(&found).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off > 1e-2 * largest, "the step is not finite: {off:e}");
    }

    #[test]
    fn forces_are_those_of_the_linearisation() {
        for order in [1, 2, 5, 7, 8] {
            follows::<false>(order);
            follows::<true>(order);
        }
    }
}
