//! One branch of the energy of a tip, as a table: interpolated by splines, and its derivatives.
//!
//! A branch is a sheet over (s, v, θ), where s goes along its equilibria from 0, where the table begins, to 1, where the branch ends in a
//! limit point. On it U(s, v, θ) is the displacement u and Ê(s, v, θ) the energy. Along s both are known with their slopes, U_s and Ê_s = P U_s, and
//! neither is singular where u turns back. The energy is E(u, v, θ) = Ê(S(u, v, θ), v, θ) with U(S, v, θ) = u, one
//! function: with i and j for u, v, θ, and what depends on u alone left out of U and Ê,
//!
//!   P = Ê_s/U_s,  E_u = P,  E_i = Ê_i - P U_i,
//!   S_u = 1/U_s,  S_i = -U_i/U_s,
//!   E_ij = Φ_ss S_i S_j + Φ_si S_j + Φ_sj S_i + Φ_ij,  Φ = Ê - P U with P held.
//!
//! Next to the limit point, s > s_c = 0.9998, and beyond it, κ (s - s_c)³ is added to U and as many times the mean force there to Ê: then the branch has an
//! energy a little beyond its end as well, with a force near to that at the limit.

use super::place::{TipPlace, TipResponse};
use super::spline::{Basis, SplineAxis};
use serde::{Deserialize, Serialize};

/// A node of a sheet: an equilibrium that was solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SheetNode {
    /// u, nm
    pub normal: f64,
    /// ∂u/∂s, nm
    pub slope: f64,
    /// E, aJ
    pub energy: f64,
    /// ∂E/∂(u, v, θ), nN, nN and nN·nm
    pub force: [f64; 3],
    /// Length of the pad that adheres: energy of adhesion over that of a unit length of its free end at rest, nm
    pub adhering: f64,
}

/// The nodes of one branch.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SheetTable {
    /// s from 0 to 1, ascending
    pub path: Vec<f64>,
    /// v, nm, ascending; one where the pad slides
    pub lateral: Vec<f64>,
    /// θ, rad, ascending
    pub rotation: Vec<f64>,
    /// By v, then θ, then s
    pub nodes: Vec<SheetNode>,
}

impl SheetTable {
    /// The nodes along s of a column.
    pub fn column(&self, lateral: usize, rotation: usize) -> &[SheetNode] {
        let length = self.path.len();
        &self.nodes[(lateral * self.rotation.len() + rotation) * length..][..length]
    }

    /// The limit points of its columns, with their places.
    pub fn limits(&self) -> impl Iterator<Item = (TipPlace, &SheetNode)> + '_ {
        let last = self.path.len() - 1;
        (0..self.lateral.len()).flat_map(move |v| {
            (0..self.rotation.len()).map(move |t| {
                let node = &self.column(v, t)[last];
                (TipPlace { normal: node.normal, lateral: self.lateral[v], rotation: self.rotation[t] }, node)
            })
        })
    }
}

/// Where a branch ends, at one v and θ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetLimit {
    /// u, nm
    pub normal: f64,
    /// E, aJ
    pub energy: f64,
    /// ∂E/∂(u, v, θ), nN, nN and nN·nm
    pub force: [f64; 3],
}

/// A value with its derivatives by s, v and θ.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Jet {
    pub value: f64,
    pub gradient: [f64; 3],
    pub hessian: [[f64; 3]; 3],
}

/// A branch, interpolated.
#[derive(Clone, Debug)]
pub struct Sheet {
    table: SheetTable,
    axes: [SplineAxis; 3],
    /// Coefficients of U and Ê, by v, then θ, then s.
    displacement: Vec<f64>,
    energy: Vec<f64>,
    /// Coefficients of the forces at the limit point, by v, then θ.
    limit_forces: [Vec<f64>; 3],
    /// κ, nm, and the mean force at the limit, nN.
    beyond: [f64; 2],
}

/// s from which the branch is continued beyond its limit.
const CONTINUED: f64 = 0.9998;
/// At the limit point P = Ê_s/U_s is 0/0: it is taken so little before it.
const BEFORE_LIMIT: f64 = 1e-6;
/// s between which it is known or continued.
const FIRST: f64 = -0.1;
const LAST: f64 = 1.2;
/// Steps of the search for s.
const MOST_STEPS: usize = 60;
/// Its error.
const FOUND: f64 = 1e-13;

impl Sheet {
    /// Through the nodes of a table; none where its coordinates do not ascend or nodes are missing.
    pub fn new(table: SheetTable) -> Option<Self> {
        let SheetTable { path, lateral, rotation, nodes } = &table;
        if nodes.len() != path.len() * lateral.len() * rotation.len() {
            return None;
        }
        let axes = [SplineAxis::of_slopes(path)?, SplineAxis::of_values(lateral)?, SplineAxis::of_values(rotation)?];
        let numbers = |of: fn(&SheetNode) -> [f64; 2]| nodes.iter().flat_map(of).collect::<Vec<_>>();
        let displacement = coefficients(&axes, numbers(|node| [node.normal, node.slope]));
        let energy = coefficients(&axes, numbers(|node| [node.energy, node.force[0] * node.slope]));
        let last = path.len() - 1;
        let limit_forces = std::array::from_fn(|i| {
            let numbers = nodes.chunks_exact(last + 1).map(|column| column[last].force[i]).collect();
            tensor_coefficients(&axes[1], &axes[2], numbers)
        });
        let mut sheet = Self { axes, displacement, energy, limit_forces, beyond: [0.0; 2], table };
        sheet.beyond = sheet.continuation();
        Some(sheet)
    }

    /// κ such that U grows with s everywhere, and the mean force at the limit.
    fn continuation(&self) -> [f64; 2] {
        let limits: Vec<_> = self.table.limits().collect();
        let mean = limits.iter().map(|(_, node)| node.force[0]).sum::<f64>() / limits.len() as f64;
        let bend = |place: &TipPlace| self.jets(1.0, place)[0].hessian[0][0];
        let (sum, most) = limits
            .iter()
            .fold((0.0f64, 0.0f64), |(sum, most), (place, _)| (sum + bend(place), most.max(bend(place).abs())));
        [(most / (3.0 * (1.0 - CONTINUED))).copysign(-sum), mean]
    }

    /// The nodes.
    pub fn table(&self) -> &SheetTable {
        &self.table
    }

    /// u where the branch begins and where it ends, at v and θ, nm.
    pub fn ends(&self, place: TipPlace) -> [f64; 2] {
        let displacement = self.along(&self.clamped(place));
        [0.0, 1.0].map(|s| {
            let basis = self.axes[0].basis(s);
            (0..basis.count).map(|i| basis.derivatives[0][i] * displacement[basis.first + i]).sum()
        })
    }

    /// The limit point at v and θ: u, energy and forces.
    pub fn limit(&self, place: TipPlace) -> SheetLimit {
        let inside = self.clamped(place);
        let [v, t] = [self.axes[1].basis(inside.lateral), self.axes[2].basis(inside.rotation)];
        let rotations = self.axes[2].len();
        let force = |i: usize| -> f64 {
            let own = |a: usize, b: usize| self.limit_forces[i][(v.first + a) * rotations + t.first + b];
            let places = (0..v.count).flat_map(|a| (0..t.count).map(move |b| (a, b)));
            places.map(|(a, b)| v.derivatives[0][a] * t.derivatives[0][b] * own(a, b)).sum()
        };
        let [normal, energy] = self.jets(1.0, &inside).map(|jet| jet.value);
        SheetLimit { normal, energy, force: std::array::from_fn(force) }
    }

    /// Whether u, v and θ are within the table, before the limit point.
    pub fn contains(&self, place: TipPlace) -> bool {
        let [begin, end] = self.ends(place);
        let inside = if begin < end { begin..=end } else { end..=begin };
        self.clamped(place) == place && inside.contains(&place.normal)
    }

    /// Whether u is beyond the limit point in which the branch ends.
    pub fn is_beyond(&self, place: TipPlace) -> bool {
        let [begin, end] = self.ends(place);
        (place.normal - end) * (end - begin) > 0.0
    }

    /// The same with v and θ put within their ranges.
    fn clamped(&self, place: TipPlace) -> TipPlace {
        let within = |value: f64, nodes: &[f64]| value.clamp(nodes[0], nodes[nodes.len() - 1]);
        let SheetTable { lateral, rotation, .. } = &self.table;
        TipPlace {
            normal: place.normal,
            // where the pad slides v changes nothing
            lateral: if lateral.len() == 1 { place.lateral } else { within(place.lateral, lateral) },
            rotation: within(place.rotation, rotation),
        }
    }

    /// Energy, forces and stiffness at a place. Beyond the ranges of v and θ it is their expansion of second order from there, beyond those of u the
    /// continuation of the branch.
    pub fn response(&self, place: TipPlace) -> TipResponse {
        let inside = self.clamped(place);
        let s = self.path_at(inside);
        let near = self.response_at(s, inside);
        if inside == place {
            return near;
        }
        let away = [0.0, place.lateral - inside.lateral, place.rotation - inside.rotation];
        let more: [f64; 3] = std::array::from_fn(|i| (0..3).map(|j| near.stiffness[i][j] * away[j]).sum());
        let work: f64 = (0..3).map(|i| away[i] * (near.force[i] + 0.5 * more[i])).sum();
        TipResponse {
            energy: near.energy + work,
            force: std::array::from_fn(|i| near.force[i] + more[i]),
            stiffness: near.stiffness,
        }
    }

    /// The coefficients along s of U at v and θ.
    fn along(&self, place: &TipPlace) -> Vec<f64> {
        let [v, t] = [self.axes[1].basis(place.lateral), self.axes[2].basis(place.rotation)];
        let (length, rotations) = (self.axes[0].len(), self.axes[2].len());
        let mut displacement = vec![0.0; length];
        for i in 0..v.count {
            for j in 0..t.count {
                let weight = v.derivatives[0][i] * t.derivatives[0][j];
                let from = ((v.first + i) * rotations + t.first + j) * length;
                let own = &self.displacement[from..from + length];
                displacement.iter_mut().zip(own).for_each(|(sum, coefficient)| *sum += weight * coefficient);
            }
        }
        displacement
    }

    /// S(u, v, θ): by Newton's method in a bracket.
    fn path_at(&self, place: TipPlace) -> f64 {
        let displacement = self.along(&place);
        let at = |s: f64| {
            let basis = self.axes[0].basis(s);
            let sum = |d: usize| -> f64 {
                (0..basis.count).map(|i| basis.derivatives[d][i] * displacement[basis.first + i]).sum()
            };
            let [more, slope, _] = self.added(s);
            (sum(0) + more - place.normal, sum(1) + slope)
        };
        let (mut low, mut high) = (FIRST, LAST);
        let rising = at(high).0 > at(low).0;
        let mut s = 0.5;
        for _ in 0..MOST_STEPS {
            let (miss, slope) = at(s);
            if (miss > 0.0) == rising {
                high = s
            } else {
                low = s
            }
            let next = s - miss / slope;
            let step = if next > low && next < high { next } else { 0.5 * (low + high) };
            let moved = (step - s).abs();
            s = step;
            if moved < FOUND {
                break;
            }
        }
        s
    }

    /// What continues U beyond the limit, with its derivatives by s.
    fn added(&self, s: f64) -> [f64; 3] {
        let ahead = (s - CONTINUED).max(0.0);
        let [kappa, _] = self.beyond;
        [kappa * ahead.powi(3), 3.0 * kappa * ahead * ahead, 6.0 * kappa * ahead]
    }

    /// U and Ê with their derivatives, as they are interpolated.
    fn jets(&self, s: f64, place: &TipPlace) -> [Jet; 2] {
        let bases = [self.axes[0].basis(s), self.axes[1].basis(place.lateral), self.axes[2].basis(place.rotation)];
        [&self.displacement, &self.energy].map(|coefficients| self.jet(coefficients, &bases))
    }

    fn jet(&self, coefficients: &[f64], [s, v, t]: &[Basis; 3]) -> Jet {
        let (length, rotations) = (self.axes[0].len(), self.axes[2].len());
        let mut sums = [[[0.0; 3]; 3]; 3];
        for i in 0..v.count {
            for j in 0..t.count {
                let from = ((v.first + i) * rotations + t.first + j) * length + s.first;
                let mut own = [0.0; 3];
                for k in 0..s.count {
                    let c = coefficients[from + k];
                    (0..3).for_each(|d| own[d] += s.derivatives[d][k] * c);
                }
                for (a, b) in [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)] {
                    let weight = v.derivatives[a][i] * t.derivatives[b][j];
                    (0..3 - a - b).for_each(|d| sums[d][a][b] += weight * own[d]);
                }
            }
        }
        Jet {
            value: sums[0][0][0],
            gradient: [sums[1][0][0], sums[0][1][0], sums[0][0][1]],
            hessian: [
                [sums[2][0][0], sums[1][1][0], sums[1][0][1]],
                [sums[1][1][0], sums[0][2][0], sums[0][1][1]],
                [sums[1][0][1], sums[0][1][1], sums[0][0][2]],
            ],
        }
    }

    /// U at s, v and θ.
    pub(super) fn displacement_at(&self, s: f64, place: TipPlace) -> f64 {
        self.jets(s, &place)[0].value
    }

    /// The response at s, v and θ without what continues the branch beyond its limit.
    pub(super) fn interpolated_at(&self, s: f64, place: TipPlace) -> TipResponse {
        response(&self.jets(s.min(1.0 - BEFORE_LIMIT), &place))
    }

    /// The response at s, v and θ.
    fn response_at(&self, s: f64, place: TipPlace) -> TipResponse {
        let [mut u, mut e] = self.jets(s, &place);
        let [value, slope, bend] = self.added(s);
        let mean = self.beyond[1];
        u.value += value;
        e.value += mean * value;
        u.gradient[0] += slope;
        e.gradient[0] += mean * slope;
        u.hessian[0][0] += bend;
        e.hessian[0][0] += mean * bend;
        response(&[u, e])
    }
}

/// The response of U and Ê.
fn response([u, e]: &[Jet; 2]) -> TipResponse {
    let force = e.gradient[0] / u.gradient[0];
    let phi = |i: usize, j: usize| e.hessian[i][j] - force * u.hessian[i][j];
    let along = [1.0 / u.gradient[0], -u.gradient[1] / u.gradient[0], -u.gradient[2] / u.gradient[0]];
    // what depends on u through s alone has no derivatives of its own by u
    let own = |i: usize, j: usize| if i == 0 || j == 0 { 0.0 } else { phi(i, j) };
    let mixed = |i: usize| if i == 0 { 0.0 } else { phi(0, i) };
    TipResponse {
        energy: e.value,
        force: std::array::from_fn(|i| if i == 0 { force } else { e.gradient[i] - force * u.gradient[i] }),
        stiffness: std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                phi(0, 0) * along[i] * along[j] + mixed(i) * along[j] + mixed(j) * along[i] + own(i, j)
            })
        }),
    }
}

/// Coefficients over v and θ of numbers by v, then θ.
fn tensor_coefficients(lateral: &SplineAxis, rotation: &SplineAxis, numbers: Vec<f64>) -> Vec<f64> {
    let [v, t] = [lateral.len(), rotation.len()];
    let rows: Vec<f64> = numbers.chunks_exact(t).flat_map(|row| rotation.coefficients(row)).collect();
    let columns: Vec<Vec<f64>> =
        (0..t).map(|k| lateral.coefficients(&(0..v).map(|i| rows[i * t + k]).collect::<Vec<_>>())).collect();
    (0..v).flat_map(|i| columns.iter().map(move |column| column[i])).collect()
}

/// Coefficients of the tensor product, one coordinate after the other.
fn coefficients(axes: &[SplineAxis; 3], numbers: Vec<f64>) -> Vec<f64> {
    let [s, v, t] = [axes[0].len(), axes[1].len(), axes[2].len()];
    let mut out = numbers;
    for (axis, count, stride) in [(&axes[0], s, 1), (&axes[2], t, s), (&axes[1], v, s * t)] {
        for start in (0..s * v * t).filter(|index| (index / stride).is_multiple_of(count)) {
            let line: Vec<f64> = (0..count).map(|k| out[start + k * stride]).collect();
            let solved = axis.coefficients(&line);
            (0..count).for_each(|k| out[start + k * stride] = solved[k]);
        }
    }
    out
}
