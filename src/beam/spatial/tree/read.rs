//! What is read off a tree: its energy, its residual, its tangent entry by entry, and its branches as they lie.

use super::beam_tree::{BeamTree, TreeBranch};
use crate::beam::element::integration::{Element, Responses};
use crate::beam::spatial::chain::projection::{FieldFront, SpatialFront, project, projected, turn_to_quaternion};
use crate::beam::spatial::chain::read::normalise;
use crate::beam::spatial::chain::spatial_chain::{no_values, quaternion_of};
use crate::beam::spatial::rotation::{Quaternion, apply, matrix};
use crate::beam::spatial::section::kinematics::{SPATIAL_FIELDS, SPATIAL_UNKNOWNS};
use crate::number::F64x4;
use crate::solve::frontal::nodes::{BUNDLE, MOST_NODES, slot};
use crate::solve::state::State;
use serde::{Deserialize, Serialize};

const F: usize = SPATIAL_UNKNOWNS;
const N: usize = SPATIAL_FIELDS;

/// A section of a branch as it lies.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BranchSection {
    /// x, y, z of the axis, nm
    pub place: [f64; 3],
    /// The directors of the branch
    pub directors: Quaternion,
    /// Section force along x, y and z, nN: what the part behind, at larger S, exerts
    pub force: [f64; 3],
    /// Section moment about x, y and z, nN·nm
    pub moment: [f64; 3],
}

impl BeamTree {
    /// Π: the stored energy and that of adhesion, with that of the joints and, less its work, of dead forces, aJ.
    pub fn energy(&self, at: &State) -> f64 {
        self.energies(at)[0]
    }

    /// The same, and the length that adheres, of all branches, nm.
    pub(super) fn energies(&self, at: &State) -> [f64; 2] {
        let (nodes, mut bundle) = (self.count(), Element::<F64x4, N>::zero());
        let mut energy: f64 = (0..self.ends.len()).map(|end| self.own(&at.values, end).energy).sum();
        let mut adhering = 0.0;
        for own in self.bundles.iter() {
            let lanes = self.lanes(own);
            self.gather(at, &lanes, &mut bundle);
            let [total, coverage, _] = bundle.energy_in_pieces(&self.integration(nodes, lanes[0].0), &no_values::<N>());
            energy += total.0[..own.count].iter().sum::<f64>();
            if let Some(sections) = &lanes[0].0.adhering {
                adhering += coverage.0[..own.count].iter().sum::<f64>() / sections.lying.energy;
            }
        }
        [energy, adhering]
    }

    /// The residual: the gradient of the energy less dead moments, and by how much what is held of tips is off.
    pub(super) fn residual_of(&self, at: &State) -> Vec<f64> {
        let mut residual = self.forces(at);
        for end in 0..self.ends.len() {
            let from = self.ends[end].joint * F;
            for (f, off) in self.off(&at.values, end).into_iter().enumerate() {
                residual[from + f] = off.unwrap_or(residual[from + f]);
            }
        }
        residual
    }

    /// What holds each joint and each node in its place, by its unknowns: zero of what is free and in equilibrium, nN and nN·nm; of what is held
    /// or driven the reaction.
    pub fn reactions(&self, at: &State) -> Vec<f64> {
        self.forces(at)
    }

    fn forces(&self, at: &State) -> Vec<f64> {
        let mut out = vec![0.0; self.nodes * F];
        for branch in self.branches.iter() {
            let by = self.integration(self.count(), branch);
            self.add_forces(at, (branch, 1.0), |element| element.forces(&by), &mut out);
        }
        for end in 0..self.ends.len() {
            let (own, from) = (self.own(&at.values, end), self.ends[end].joint * F);
            (0..F).for_each(|f| out[from + f] += own.gradient[f]);
        }
        out
    }

    /// By how much the length that adheres changes with each unknown.
    pub(super) fn adhering_gradient(&self, at: &State) -> Vec<f64> {
        let mut out = vec![0.0; self.nodes * F];
        for branch in self.branches.iter() {
            let Some(sections) = branch.adhering.as_ref().filter(|_| branch.density.adhesion.is_some()) else {
                continue;
            };
            let by = self.integration(self.count(), branch);
            let weight = 1.0 / sections.lying.energy;
            self.add_forces(at, (branch, weight), |element| element.coverage_forces(&by), &mut out);
        }
        out
    }

    /// Adds what the elements of a branch say of the fields of their nodes, times a weight, by the unknowns.
    fn add_forces(
        &self,
        at: &State,
        (branch, weight): (&TreeBranch, f64),
        of: impl Fn(&Element<f64, N>) -> [[f64; N]; MOST_NODES],
        out: &mut [f64],
    ) {
        let order = self.order();
        for e in 0..branch.elements {
            let own = self.by_turns(&self.element(at, branch, e), &of);
            for rank in 0..=order {
                let mut by = own[slot(order + 1, rank)];
                if let Some(end) = branch.end_at(order, e, rank) {
                    let map = self.end_map(&at.values, branch.joints[end], branch.offsets[end], [0.0; 3]);
                    by = map.map_or(by, |(map, _)| map.back(&by));
                }
                let from = branch.node(order, e, rank) * F;
                (0..F).for_each(|f| out[from + f] += weight * by[f]);
            }
        }
    }

    /// Numbers by the places and turns of the nodes of an element, in the directors of the branch, of those by their fields.
    fn by_turns(
        &self,
        element: &Element<f64, N>,
        of: impl Fn(&Element<f64, N>) -> [[f64; N]; MOST_NODES],
    ) -> [[f64; F]; MOST_NODES] {
        let (fields, mut out) = (of(element), [[0.0; F]; MOST_NODES]);
        for a in 0..=self.order() {
            out[a] = projected(&fields[a], &turn_to_quaternion(quaternion_of(&element.values[a])));
        }
        out
    }

    /// The forces that hold an element in place.
    fn element_forces(&self, at: &State, branch: &TreeBranch, e: usize) -> [[f64; F]; MOST_NODES] {
        let by = self.integration(self.count(), branch);
        self.by_turns(&self.element(at, branch, e), |element| element.forces(&by))
    }

    /// The section at an end of an element of a branch, 0 at S = 0, from nodal forces: as accurate as the energy.
    pub fn section(&self, at: &State, branch: usize, boundary: usize) -> BranchSection {
        let (own, order) = (&self.branches[branch], self.order());
        let (e, rank, sign) = if boundary == 0 { (0, 0, -1.0) } else { (boundary.min(own.elements) - 1, order, 1.0) };
        let forces = self.element_forces(at, own, e)[slot(order + 1, rank)].map(|force| sign * force);
        let mut node = self.fields(&at.values, own, e, rank);
        normalise(&mut node);
        let directors = quaternion_of(&node);
        BranchSection {
            place: [node[0], node[1], node[2]],
            directors,
            force: [forces[0], forces[1], forces[2]],
            moment: apply(&matrix(directors), &[forces[3], forces[4], forces[5]]),
        }
    }

    /// The tangent as entries (row, column, value), to be summed where they meet: for a general solver. Rows of what is held of tips are those
    /// of the identity.
    pub fn tangent_entries(&self, at: &State) -> Vec<(usize, usize, f64)> {
        let (nodes, order) = (self.count(), self.order());
        let (mut fields, mut front) = (Box::new(FieldFront::zero()), Box::new(SpatialFront::zero()));
        let (mut room, mut bundle) = (Box::<Responses<N>>::default(), Element::zero());
        let held = self.held_unknowns();
        let mut entries: Vec<(usize, usize, f64)> = held.iter().map(|&unknown| (unknown, unknown, 1.0)).collect();
        let mut add = |row: usize, column: usize, value: f64| {
            if held.binary_search(&row).is_err() {
                entries.push((row, column, value));
            }
        };
        for branch in self.branches.iter() {
            let by = self.integration(nodes, branch);
            for first in (0..branch.elements).step_by(BUNDLE) {
                let lanes = self.lanes_of(branch, first);
                self.gather(at, &lanes, &mut bundle);
                bundle.integrate::<false>(&by, 0.0, &mut room, &mut fields);
                project(nodes, by.symmetric, &fields, &bundle.values, &mut front);
                self.take_ends(nodes, &at.values, &lanes, &mut front);
                for (l, &(_, e)) in lanes.iter().enumerate().take(branch.elements - first) {
                    let mut places = [0; MOST_NODES];
                    (0..=order).for_each(|rank| places[slot(order + 1, rank)] = branch.node(order, e, rank) * F);
                    for i in 0..(order + 1) * F {
                        let (row, own) = (places[i / F] + i % F, &front.rows[i / F][i % F]);
                        for j in i..(order + 1) * F {
                            let (column, value) = (places[j / F] + j % F, own.fields[j / F][j % F].0[l]);
                            add(row, column, value);
                            if j > i {
                                add(column, row, value);
                            }
                        }
                    }
                }
            }
        }
        for end in 0..self.ends.len() {
            let (own, from) = (self.own(&at.values, end), self.ends[end].joint * F);
            for i in 0..F {
                (0..F).for_each(|j| add(from + i, from + j, own.tangent[i][j]));
            }
        }
        entries
    }

    /// Which unknowns of tips are held, ascending.
    fn held_unknowns(&self) -> Vec<usize> {
        let held = |end: &super::beam_tree::TreeEnd| {
            let joint = end.joint;
            end.held
                .map(|held| held.is_some())
                .into_iter()
                .enumerate()
                .filter(|held| held.1)
                .map(move |held| joint * F + held.0)
        };
        let mut all: Vec<usize> = self.ends.iter().flat_map(held).collect();
        all.sort_unstable();
        all
    }
}
