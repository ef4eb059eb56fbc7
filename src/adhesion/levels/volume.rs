//! Continua that interact by their volumes, eqs. (3)-(7), by quadrature.
//!
//! Densities are the current ones: eqs. (4) and (5) say that β dv = β0 dV, so that a deformed body needs no other formula.

use super::lattice::LatticeSite;
use super::pair::LennardJones;
use crate::number::gauss::Rule;
use std::f64::consts::PI;

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// Corner of the smallest coordinates, nm
    pub corner: LatticeSite,
    /// Lengths of the edges, nm
    pub edges: LatticeSite,
}

impl Cuboid {
    /// Gauss points and weights (nm³), the cube of the rule's number.
    fn points<'a>(&'a self, rule: &'a Rule) -> impl Iterator<Item = (LatticeSite, f64)> + 'a {
        let along = move |axis: usize| rule.over(self.corner[axis], self.corner[axis] + self.edges[axis]);
        along(0).flat_map(move |(x, wx)| {
            along(1).flat_map(move |(y, wy)| along(2).map(move |(z, wz)| ([x, y, z], wx * wy * wz)))
        })
    }
}

/// Energy Π_c = ∫∫ β1β2 φ dv2 dv1 (aJ), eq. (3), and the force on the first body (nN), by a six-dimensional Gauss rule.
///
/// `densities` is β1β2 in nm⁻⁶. The rule converges slowly where the boxes are nearer than about their edge over its points.
pub fn double_integral(
    pair: &LennardJones,
    densities: f64,
    body: &Cuboid,
    other: &Cuboid,
    rule: &Rule,
) -> (f64, LatticeSite) {
    let others: Vec<_> = other.points(rule).collect();
    let (mut energy, mut force) = (0.0, [0.0; 3]);
    for (one, weight) in body.points(rule) {
        for (two, other_weight) in &others {
            let apart = [one[0] - two[0], one[1] - two[1], one[2] - two[2]];
            let squared = apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2];
            let volumes = densities * weight * other_weight;
            energy += volumes * pair.energy(squared);
            let push = volumes * pair.force_over_distance(squared);
            (0..3).for_each(|i| force[i] += push * apart[i]);
        }
    }
    (energy, force)
}

/// Body force of a half space on a point at `distance` r (nm) from it, nN/nm³, eq. (7) times the point's own density; y points
/// away from the half space. A cubed rule: n equal steps around, n angles down, n points along a ray.
///
/// On a ray at the angle ψ from -y the half space begins at r/μ, μ = cos ψ. With ρ = r/(μt) the force of r^-n is
/// a polynomial in μ and t, of degree 11 at most: from 6 points on the rule is exact and only round-off is left.
pub fn body_force_by_volume(pair: &LennardJones, densities: f64, distance: f64, rule: &Rule) -> LatticeSite {
    let mut force = [0.0; 3];
    let w_azimuth = 2.0 * PI / rule.points() as f64;
    for turn in 0..rule.points() {
        let (sin, cos) = ((turn as f64 + 0.5) * w_azimuth).sin_cos();
        for (mu, w_mu) in rule.over(0.0, 1.0) {
            let across = (1.0 - mu * mu).sqrt();
            let ray = [-across * cos, mu, -across * sin];
            for (t, w_t) in rule.over(0.0, 1.0) {
                let reach = distance / (mu * t);
                // dv = ρ² dρ dμ dφ, dρ = ρ dt/t
                let volume = densities * w_azimuth * w_mu * w_t * reach * reach * reach / t;
                let push = volume * pair.force_over_distance(reach * reach) * reach;
                (0..3).for_each(|i| force[i] += push * ray[i]);
            }
        }
    }
    force
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::HalfSpace;
    use approx::assert_relative_eq;
    use std::num::NonZeroUsize;

    const LAW: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    fn rule(points: usize) -> Rule {
        Rule::new(NonZeroUsize::new(points).unwrap())
    }

    #[test]
    fn six_rays_give_the_half_space() {
        let pair = LennardJones::behind(&LAW, 10.0, 20.0);
        for r in [0.2, 0.31, 0.4, 3.0] {
            let force = body_force_by_volume(&pair, 200.0, r, &rule(6));
            let largest = LAW.potential_scale() / 0.16 * ((0.4 / r).powi(10) / 5.0 + (0.4 / r).powi(4));
            assert_relative_eq!(force[1], LAW.body_force(r), epsilon = 1e-14 * largest);
            assert!(force[0].abs().max(force[2].abs()) < 1e-14 * largest);
        }
    }

    #[test]
    fn fewer_rays_do_not() {
        let pair = LennardJones::behind(&LAW, 10.0, 20.0);
        let off =
            |points| (body_force_by_volume(&pair, 200.0, 0.4, &rule(points))[1] / LAW.body_force(0.4) - 1.0).abs();
        assert!(off(2) > 1e-2 && off(5) > 1e-6 && off(6) < 1e-13, "{:e} {:e} {:e}", off(2), off(5), off(6));
    }

    #[test]
    fn forces_between_boxes_are_equal_and_opposite() {
        let pair = LennardJones::behind(&LAW, 10.0, 20.0);
        let one = Cuboid { corner: [0.0, 0.5, 0.0], edges: [1.0, 2.0, 0.7] };
        let two = Cuboid { corner: [0.2, -1.0, 0.3], edges: [1.5, 1.0, 1.0] };
        let (energy, force) = double_integral(&pair, 200.0, &one, &two, &rule(4));
        let (same, back) = double_integral(&pair, 200.0, &two, &one, &rule(4));
        assert_relative_eq!(energy, same, max_relative = 1e-13);
        (0..3).for_each(|i| assert_relative_eq!(force[i], -back[i], epsilon = 1e-13 * force[1].abs()));
    }
}
