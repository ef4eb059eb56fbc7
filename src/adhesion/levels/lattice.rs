//! Bodies made of atoms: the pair sum of eq. (2) over two lists of atoms, and an endless lattice below a plane.

use super::half_space::HalfSpace;
use super::pair::LennardJones;
use std::f64::consts::PI;

/// A place, nm; y away from the substrate.
pub(crate) type LatticeSite = [f64; 3];

/// A block of a simple cubic lattice: the centres of `counts` cubes of edge `spacing` (nm) that fill the block above `corner`.
pub fn cubic_block(corner: LatticeSite, counts: [usize; 3], spacing: f64) -> Vec<LatticeSite> {
    let at = |k: usize, axis: usize| corner[axis] + (k as f64 + 0.5) * spacing;
    let mut atoms = Vec::with_capacity(counts.iter().product());
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            atoms.extend((0..counts[2]).map(|k| [at(i, 0), at(j, 1), at(k, 2)]));
        }
    }
    atoms
}

/// Energy (aJ) and force on the first body (nN) of two lists of atoms, eq. (2): n1 n2 pairs.
pub fn pair_sum(pair: &LennardJones, body: &[LatticeSite], other: &[LatticeSite]) -> (f64, LatticeSite) {
    let (mut energy, mut force) = (0.0, [0.0; 3]);
    for one in body {
        for two in other {
            let apart = [one[0] - two[0], one[1] - two[1], one[2] - two[2]];
            let squared = apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2];
            energy += pair.energy(squared);
            let push = pair.force_over_distance(squared);
            (0..3).for_each(|i| force[i] += push * apart[i]);
        }
    }
    (energy, force)
}

/// A simple cubic lattice that fills the half space y < 0: planes at y = -a/2, -3a/2, ..., atoms at x = i a and z = k a, so
/// that each stands for a volume a³ and the density is a^-3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LatticeHalfSpace {
    /// What acts between two of the centres
    pub pair: LennardJones,
    /// Spacing a, nm, positive
    pub spacing: f64,
    /// Atoms within this distance (nm) are summed one by one; those beyond it count as a continuum of the same density.
    pub cutoff: f64,
}

impl LatticeHalfSpace {
    /// Force on an atom above the lattice, nN: the force of eq. (2), the continuum beyond the cutoff included.
    pub fn force_on(&self, atom: LatticeSite) -> LatticeSite {
        let (a, cutoff_squared) = (self.spacing, self.cutoff * self.cutoff);
        let mut force = [0.0, self.beyond(atom[1]), 0.0];
        let planes = ((self.cutoff - atom[1]) / a + 0.5).max(0.0) as usize;
        for plane in 0..planes {
            let dy = atom[1] + (plane as f64 + 0.5) * a;
            let across = cutoff_squared - dy * dy;
            for dx in self.row(atom[0], across) {
                for dz in self.row(atom[2], across - dx * dx) {
                    let push = self.pair.force_over_distance(dx * dx + dy * dy + dz * dz);
                    force[0] += push * dx;
                    force[1] += push * dy;
                    force[2] += push * dz;
                }
            }
        }
        force
    }

    /// Normal force an area between this lattice and another in register with it whose surface is at `gap` (nm), nN/nm²; the
    /// atoms of the other lie at (`x`, `z`) over one of this. Layers more than a cutoff away count as a continuum.
    pub fn traction(&self, gap: f64, x: f64, z: f64) -> f64 {
        let a = self.spacing;
        let layers = (self.cutoff / a).ceil() as usize;
        let near: f64 = (0..layers).map(|k| self.force_on([x, gap + (k as f64 + 0.5) * a, z])[1]).sum();
        let density = a.powi(-3);
        let continuum = HalfSpace {
            hamaker_constant: self.pair.hamaker_constant(density, density),
            equilibrium_distance: self.pair.equilibrium_distance,
        };
        near / (a * a) + continuum.traction(gap + layers as f64 * a)
    }

    /// Distances along a row of atoms at multiples of the spacing, as far as their squares stay below a bound.
    fn row(&self, place: f64, squared: f64) -> impl Iterator<Item = f64> {
        let (a, reach) = (self.spacing, squared.max(0.0).sqrt());
        let (first, last) = (((place - reach) / a).ceil() as i64, ((place + reach) / a).floor() as i64);
        (first..=last).map(move |i| place - i as f64 * a)
    }

    /// Normal force on an atom at the height r of the continuum beyond the cutoff m, nN; of all of it where r > m:
    ///
    ///   πβ ∫_m^∞ F(ρ) (ρ² - r²) dρ = 12πβε [ r0¹² (m^-10/10 - r² m^-12/12) - r0⁶ (m^-4/4 - r² m^-6/6) ],
    ///
    /// because the part of a sphere of radius ρ below the surface pulls on average by half the cosine at its rim.
    fn beyond(&self, height: f64) -> f64 {
        let m = self.cutoff.max(height);
        let (ratio, q) = ((height / m).powi(2), (self.pair.equilibrium_distance / m).powi(6));
        let shape = q * q * (1.0 / 10.0 - ratio / 12.0) - q * (1.0 / 4.0 - ratio / 6.0);
        12.0 * PI * self.pair.well_depth * self.spacing.powi(-3) * m * m * shape
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adhesion::HalfSpace;
    use approx::assert_relative_eq;

    const LAW: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };

    fn lattice(spacing: f64, cutoff: f64) -> LatticeHalfSpace {
        let density = spacing.powi(-3);
        LatticeHalfSpace { pair: LennardJones::behind(&LAW, density, density), spacing, cutoff }
    }

    #[test]
    fn a_block_fills_its_volume() {
        let atoms = cubic_block([1.0, 2.0, 3.0], [2, 1, 3], 0.5);
        assert_eq!(atoms.len(), 6);
        assert_eq!((atoms[0], atoms[5]), ([1.25, 2.25, 3.25], [1.75, 2.25, 4.25]));
    }

    #[test]
    fn far_beyond_the_cutoff_an_atom_feels_the_half_space() {
        let body_force = lattice(0.2, 1.0).force_on([0.03, 1.5, 0.0])[1] / 0.2f64.powi(3);
        assert_relative_eq!(body_force, LAW.body_force(1.5), max_relative = 1e-14);
    }

    #[test]
    fn the_cutoff_hardly_matters() {
        let at = [0.1, 0.6, 0.05];
        let (near, far) = (lattice(0.4, 4.0).force_on(at), lattice(0.4, 12.0).force_on(at));
        assert_relative_eq!(near[1], far[1], max_relative = 2e-5);
        assert_relative_eq!(near[0], far[0], epsilon = 1e-5 * far[1].abs());
    }

    #[test]
    fn endless_lattice_is_the_limit_of_a_block() {
        let lattice = lattice(0.5, 4.0);
        // a block that holds the sphere of the cutoff, centred under the atom
        let block = cubic_block([-5.25, -5.0, -5.25], [21, 10, 21], 0.5);
        let atom = [0.0, 0.3, 0.0];
        let within: Vec<_> = block
            .into_iter()
            .filter(|p| p.iter().zip(atom).map(|(a, b)| (a - b).powi(2)).sum::<f64>() <= 16.0)
            .collect();
        let (_, force) = pair_sum(&lattice.pair, &[atom], &within);
        assert_relative_eq!(force[1] + lattice.beyond(0.3), lattice.force_on(atom)[1], max_relative = 1e-13);
    }
}
