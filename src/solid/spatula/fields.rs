//! Displacements, places and stresses of a solid spatula at any of its points, and its state on another mesh.

use super::element::{Element, ElementPlace, quadratic};
use super::layout::{ACROSS, ALONG, ELEMENT, FUNCTIONS, THROUGH};
use super::material::Vector;
use super::solid_spatula::SolidSpatula;
use crate::solid::grip::turned;
use crate::solid::mesh::StripMesh;
use crate::solve::state::State;

impl SolidSpatula {
    /// S of its stations, and ζ of its nodes through the thickness, from -1, the underside, to 1.
    pub fn mesh_lines(&self) -> (&[f64], &[f64]) {
        (&self.mesh.stations, &[-1.0, 0.0, 1.0])
    }

    /// The element at S in the plane of symmetry, with ξ there.
    fn element_in_plane(&self, place: f64) -> (usize, ElementPlace<'_>, f64) {
        let (column, xi) = StripMesh::located(&self.mesh.stations, place);
        let own = ElementPlace {
            stations: [self.mesh.stations[column], self.mesh.stations[column + 1]],
            axis: [self.axis[column], self.axis[column + 1]],
            sides: [self.mesh.sides[0], self.mesh.sides[1]],
            face_points: 0,
            geometry: &self.geometry,
            material: &self.material,
        };
        (column * self.layout.strips, own, xi)
    }

    /// x and y of the point (S, ζ) of the plane of symmetry, over the ground, nm.
    pub fn place_at(&self, values: &[f64], place: f64, zeta: f64) -> [f64; 2] {
        let (rest, moved) = (self.rest_at(place, zeta), self.displacement_at(values, place, zeta));
        [rest[0] + moved[0], rest[1] + moved[1]]
    }

    /// The same without stress.
    pub(super) fn rest_at(&self, place: f64, zeta: f64) -> [f64; 2] {
        let (_, own, xi) = self.element_in_plane(place);
        let mut at = [0.0; 2];
        for (rest, share) in own.coefficients().iter().zip(own.values([xi, zeta, -1.0])) {
            (0..2).for_each(|axis| at[axis] += share * rest[axis]);
        }
        at
    }

    /// Its displacement (u_x, u_y), nm.
    pub(in crate::solid) fn displacement_at(&self, values: &[f64], place: f64, zeta: f64) -> [f64; 2] {
        let (index, own, xi) = self.element_in_plane(place);
        let (moved, shares) = (self.moved(values, index), own.values([xi, zeta, -1.0]));
        let of = |axis: usize| shares.iter().enumerate().map(|(k, share)| share * moved[3 * k + axis]).sum();
        [of(0), of(1)]
    }

    /// Thickness of the free end, nm.
    pub(in crate::solid) fn thickness(&self) -> f64 {
        let [low, high] = [-1.0, 1.0].map(|zeta| self.geometry.in_plane(0.0, self.axis[0], zeta, 0.0).place);
        (high[0] - low[0]).hypot(high[1] - low[1])
    }

    /// σ, Cauchy's stress xx, yy, xy at a point of the plane of symmetry, GPa.
    pub fn stress_at(&self, values: &[f64], place: f64, zeta: f64) -> [f64; 3] {
        let (index, own, xi) = self.element_in_plane(place);
        let moved: [f64; ELEMENT] = self.moved(values, index);
        let (_, gradients) = own.gradients(&own.coefficients(), [xi, zeta, -1.0]);
        let mut h = [[0.0; 3]; 3];
        for k in 0..FUNCTIONS {
            for (i, row) in h.iter_mut().enumerate() {
                (0..3).for_each(|j| row[j] += moved[3 * k + i] * gradients[j][k]);
            }
        }
        let stress = self.material.stress(&h, &self.material.at(&h));
        let f: [Vector; 3] = std::array::from_fn(|i| std::array::from_fn(|j| h[i][j] + f64::from(u8::from(i == j))));
        let minor = |a: usize, b: usize| f[1][a] * f[2][b] - f[1][b] * f[2][a];
        let volume = f[0][0] * minor(1, 2) - f[0][1] * minor(0, 2) + f[0][2] * minor(0, 1);
        let of = |i: usize, j: usize| (0..3).map(|k| stress[i][k] * f[j][k]).sum::<f64>() / volume;
        [of(0, 0), of(1, 1), of(0, 1)]
    }

    /// S up to which it adheres from the tip on, nm: where the gap passes twice that of the largest attraction, by its logarithm between stations.
    pub(crate) fn front(&self, values: &[f64]) -> f64 {
        let near = 2.0 * self.half_space.strongest_gap();
        let gaps = self.gaps(values);
        let stations = self.adhering_stations();
        let Some(last) = (0..stations).rev().find(|&station| gaps[station] < near) else { return 0.0 };
        let place = self.mesh.stations[last];
        if last + 1 == stations {
            return place;
        }
        let share = (near / gaps[last]).ln() / (gaps[last + 1] / gaps[last]).ln();
        place + share.clamp(0.0, 1.0) * (self.mesh.stations[last + 1] - place)
    }

    /// Displacement of a node: station, node through the thickness (0 to 2, the underside first) and across.
    pub fn displacement(&self, values: &[f64], station: usize, (through, across): (usize, usize)) -> [f64; 3] {
        debug_assert!(through < THROUGH);
        std::array::from_fn(|axis| self.number(values, station, (through, across), (false, axis)))
    }

    /// A number of a node: displacement or its slope, x, y or z.
    fn number(&self, values: &[f64], station: usize, node: (usize, usize), (slope, axis): (bool, usize)) -> f64 {
        let own = self.layout.unknown(station, node, slope, axis).map_or(0.0, |unknown| values[unknown]);
        if slope || axis == 2 || station < self.layout.columns {
            return own;
        }
        own + turned(self.rotation(values), self.end_face.lever(node))[axis]
    }

    /// The state of this mesh that has the displacements of one of another mesh of the same body, at its nodes.
    pub(crate) fn state_of(&self, other: &Self, at: &State) -> State {
        let mut values = vec![0.0; self.unknowns()];
        let lines: Vec<_> =
            (0..self.layout.lines()).map(|line| StripMesh::located(&other.mesh.sides, self.mesh.line(line))).collect();
        for (station, &place) in self.mesh.stations.iter().enumerate() {
            let (column, xi) = StripMesh::located(&other.mesh.stations, place);
            let length = other.mesh.stations[column + 1] - other.mesh.stations[column];
            let functions = Element::along(xi, length);
            for (across, &(strip, eta)) in lines.iter().enumerate() {
                let shares = quadratic(eta);
                for (through, slope, axis) in numbers() {
                    let Some(unknown) = self.layout.unknown(station, (through, across), slope, axis) else { continue };
                    let mut sum = 0.0;
                    for along in 0..ALONG {
                        let [value, by_xi] = functions[along];
                        let factor = if slope { 2.0 * by_xi / length } else { value };
                        for (side, [share, _]) in shares.into_iter().enumerate() {
                            let node = (through, (ACROSS - 1) * strip + side);
                            let from = other.number(&at.values, column + along / 2, node, (along % 2 == 1, axis));
                            sum += factor * share * from;
                        }
                    }
                    values[unknown] = sum;
                }
            }
        }
        values[self.interface_start()..].copy_from_slice(&at.values[other.interface_start()..]);
        State { values, force: at.force, ..self.at_rest() }
    }
}

/// The numbers of a line of nodes at a station: node through the thickness, whether it is a slope, and its axis.
fn numbers() -> impl Iterator<Item = (usize, bool, usize)> {
    (0..THROUGH)
        .flat_map(|through| [false, true].map(|slope| (through, slope)))
        .flat_map(|(through, slope)| (0..3).map(move |axis| (through, slope, axis)))
}
