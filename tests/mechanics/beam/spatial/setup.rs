//! What the topics share: a rod in space of any consistent units, loads that keep their directions, and the values of
//! an independent program (verification/space_benchmarks.py, Gauss collocation of the strong form).

use nalgebra::{Matrix6, Vector6};
use peelkit::adhesion::Barrier;
use peelkit::beam::{
    EndRotation, MeshIntervals, MeshKind, MeshPolicy, SpatialBeam, SpatialChain, SpatialDensity, SpatialEnd,
    SpatialProfile, SpatialRestCurve, SpatialStiffness, Station,
};
use peelkit::solve::{
    EndConditions, INTERFACE, InitialState, MeasuredBeside, NewtonOptions, Observables, PathConstraint, PathMeasure,
    Problem, State, System, Workspace, solve,
};
use std::sync::Arc;

/// Axes along which an end is moved.
pub const XYZ: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// Directors that are the axes of space.
pub const PLAIN: [f64; 4] = [1.0, 0.0, 0.0, 0.0];
/// A force and a moment.
pub type Load = [[f64; 3]; 2];
/// None.
pub const NO_LOAD: Load = [[0.0; 3]; 2];

/// A rod to which nothing adheres, its left end held.
#[derive(Clone, Debug)]
pub struct Rod {
    pub stiffness: SpatialStiffness,
    pub rest: SpatialRestCurve,
    pub length: f64,
    pub order: usize,
    /// Of the left end's place and angles.
    pub held_left: [bool; INTERFACE],
    /// Of the right end
    pub rotation: EndRotation,
    /// On the right end
    pub load: Load,
}

impl Rod {
    /// Clamped at the left, free at the right, elements of order 7.
    pub fn clamped(stiffness: SpatialStiffness, rest: SpatialRestCurve, length: f64) -> Self {
        let (held_left, rotation) = ([true; INTERFACE], EndRotation::Free);
        Self { stiffness, rest, length, order: 7, held_left, rotation, load: NO_LOAD }
    }

    /// What the solver sees.
    pub fn beam(&self) -> SpatialBeam {
        let SpatialStiffness(stiffness) = self.stiffness;
        let rest_curvature = self.rest.curvature;
        let profile = SpatialProfile::Uniform(Box::new(Station { stiffness, rest_curvature, width: 1.0, height: 1.0 }));
        let end = |place: f64, rotation, dead_load| SpatialEnd {
            axes: XYZ,
            rotation,
            rest: self.rest.at(place).1,
            dead_load,
        };
        let ends = [end(0.0, EndRotation::Angles, NO_LOAD), end(self.length, self.rotation, self.load)];
        let [x, y, z] = self.rest.start;
        let rest = [x, y, z, 0.0, 0.0, 0.0];
        let held = std::array::from_fn(|f| self.held_left[f].then_some(rest[f]));
        SpatialBeam {
            chain: SpatialChain::new(SpatialDensity { profile, adhesion: None, held: None }, self.order, ends, held),
            length: self.length,
            rest: self.rest.into(),
            scale: [0.01 * self.length, 0.01],
            round_off: 0.0,
            rest_adhesion: 0.0,
            process_length: self.length,
            barrier: Barrier::Pole,
            mesh: MeshPolicy {
                kind: MeshKind::Uniform,
                front_foci: vec![],
                edge_foci: Vec::new(),
                fixed_foci: vec![],
                pieces: MeshIntervals::whole(self.length),
            },
            inertia: None,
        }
    }

    /// Its right end in a grip that drives one unknown and holds others, where they are at rest.
    pub fn problem(&self, driven: usize, held: &[usize]) -> (Problem, Arc<SpatialBeam>) {
        problem(self.beam(), driven, held)
    }

    /// The states under `load` times each of the targets, one after the other, in steps as long as Newton's method
    /// bears, and the iterations of all steps so far. The first step is `first`.
    pub fn under(
        &self,
        elements: usize,
        load: impl Fn(f64) -> Load,
        first: f64,
        targets: &[f64],
    ) -> Vec<(State, usize)> {
        let options =
            NewtonOptions { tolerance: 1e-12, largest_update: 100.0, most_iterations: 12, exact_slope: false };
        let nothing = PathConstraint { weights: Observables::FORCE, target: 0.0 };
        let (mut at, mut done, mut step, mut iterations) = (self.beam().stress_free(elements), 0.0, first, 0);
        let mut before = (at.clone(), -first);
        let mut found = Vec::new();
        for &target in targets {
            while done < target {
                let next = if done + 1.001 * step > target { target } else { done + step };
                let (problem, beam) = Self { load: load(next), ..self.clone() }.problem(0, &[]);
                // on along the secant
                let ahead = (next - done) / (done - before.1);
                let values = beam.combine(&[&at.values, &before.0.values], &[1.0 + ahead, -ahead]);
                let start = State { values, ..at.clone() };
                match solve(&problem, start, &nothing, &options, &mut Workspace::default()) {
                    Ok(solution) => {
                        before = (std::mem::replace(&mut at, solution.at), done);
                        (done, step) = (next, 1.5 * step);
                        iterations += solution.iterations;
                    }
                    Err(error) => {
                        step *= 0.4;
                        assert!(step > 1e-9, "{error} at {done}");
                    }
                }
            }
            found.push((at.clone(), iterations));
        }
        found
    }
}

/// A beam with its right end in a grip.
pub fn problem(beam: SpatialBeam, driven: usize, held: &[usize]) -> (Problem, Arc<SpatialBeam>) {
    let beam = Arc::new(beam);
    let mut grip = EndConditions::drive(driven);
    held.iter().for_each(|&slot| grip.held[slot] = true);
    grip.origin = beam.interface_values(&beam.stress_free(1));
    grip.scale = std::array::from_fn(|slot| beam.scale[slot / 3]);
    let measure = match beam.adheres() {
        true => PathMeasure {
            monitors: [beam.process_length, beam.scale[1]],
            force: beam.rest_adhesion.abs(),
            beside: MeasuredBeside::Nothing,
        },
        false => PathMeasure { monitors: [f64::INFINITY; 2], force: 1.0, beside: MeasuredBeside::Force },
    };
    (Problem { system: beam.clone(), grip, measure, start: InitialState::StressFree }, beam)
}

/// Where the right end of a state is.
pub fn tip(at: &State) -> [f64; 3] {
    let from = at.values.len() - 13;
    std::array::from_fn(|i| at.values[from + i])
}

/// The quaternion of its directors.
pub fn tip_directors(at: &State) -> [f64; 4] {
    let from = at.values.len() - 10;
    std::array::from_fn(|i| at.values[from + i])
}

/// At most `most` apart, each of them.
#[track_caller]
pub fn assert_close(found: &[f64], wanted: &[f64], most: f64, what: &str) {
    assert_eq!(found.len(), wanted.len(), "{what}");
    for (k, (found, wanted)) in found.iter().zip(wanted).enumerate() {
        let off = (found - wanted).abs();
        assert!(off <= most, "{what}, number {k}: {found:.13}, wanted {wanted:.13}, off by {off:.1e}");
    }
}

/// A number of verification/space_benchmarks.csv.
#[track_caller]
pub fn tabulated(case: &str, quantity: &str) -> f64 {
    let rows = include_str!("../../../../verification/space_benchmarks.csv").lines();
    let values =
        rows.filter_map(|row| row.strip_prefix(&format!("{case},{quantity},"))?.split(',').next()?.parse().ok());
    let values: Vec<f64> = values.collect();
    assert_eq!(values.len(), 1, "{case}, {quantity}");
    values[0]
}

/// The end of a rod under a load, of the same table.
#[track_caller]
pub fn tabulated_tip(case: &str, load: f64) -> [f64; 3] {
    ["x", "y", "z"].map(|axis| tabulated(case, &format!("tip_{axis}_at_{load}")))
}

/// What a function comes to as the compliance of its argument vanishes: a parabola through three values.
pub fn rigid<const N: usize>(compliance: f64, of: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    let [one, half, quarter] = [1.0, 0.5, 0.25].map(|share| of(share * compliance));
    std::array::from_fn(|i| (8.0 * quarter[i] - 6.0 * half[i] + one[i]) / 3.0)
}

/// The 6 by 6 block of an elimination, or its transpose, solved.
pub fn block_solved(
    matrix: &[[f64; INTERFACE]; INTERFACE],
    right: &[f64; INTERFACE],
    transposed: bool,
) -> [f64; INTERFACE] {
    let block = Matrix6::from_fn(|i, j| if transposed { matrix[j][i] } else { matrix[i][j] });
    let solved = block.lu().solve(&Vector6::from_column_slice(right)).expect("the block is regular");
    std::array::from_fn(|i| solved[i])
}

/// Numbers between -1 and 1 that are the same in every run.
pub struct Numbers(pub u64);

impl Numbers {
    pub fn next(&mut self) -> f64 {
        let s = &mut self.0;
        *s ^= *s << 13;
        *s ^= *s >> 7;
        *s ^= *s << 17;
        (*s >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
    }

    pub fn several(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.next()).collect()
    }

    /// A symmetric positive definite stiffness that couples everything.
    pub fn stiffness(&mut self) -> SpatialStiffness {
        let mut c = [[0.0; 6]; 6];
        for i in 0..6 {
            for j in 0..=i {
                c[i][j] = 0.3 * self.next();
                c[j][i] = c[i][j];
            }
            c[i][i] += 2.0;
        }
        SpatialStiffness(c)
    }
}
