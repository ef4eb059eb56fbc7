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
//! Before s = 0 the branch goes on in another way (before.rs). Next to the limit point, s > s_c = 0.9998, and beyond it, κ (s - s_c)³ is added to U and as many times the mean force there to Ê: then the branch has an
//! energy a little beyond its end as well, with a force near to that at the limit.

use super::options::{TipPlace, TipResponse};
use super::spline::{Basis, Jet, PiecePolynomial, SUPPORT, SplineAxis};
use serde::{Deserialize, Serialize};

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
    /// Whether u grows along it
    rises: bool,
    /// κ, nm, and the mean force at the limit, nN.
    beyond: [f64; 2],
}

/// s from which the branch is continued beyond its limit.
const CONTINUED: f64 = 0.9998;
/// At the limit point P = Ê_s/U_s is 0/0: it is taken so little before it.
const BEFORE_LIMIT: f64 = 1e-6;
/// s up to which it is continued.
const LAST: f64 = 1.2;
/// Orders of the derivatives by v and θ.
const ORDERS: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (2, 0)];
/// Steps of the search for s.
const MOST_STEPS: usize = 60;
/// Its error, and that of u, nm.
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
        let rises = nodes[last].normal > nodes[0].normal;
        let mut sheet = Self { axes, displacement, energy, limit_forces, rises, beyond: [0.0; 2], table };
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
        self.ends_by(&self.weights(&place))
    }

    /// The same: at its ends a spline is its first and its last coefficient.
    fn ends_by(&self, weights: &Weights) -> [f64; 2] {
        [0, self.axes[0].len() - 1].map(|k| weights.of(&self.displacement, k))
    }

    /// u at s as a function of u, v and θ, on which it depends by v and θ alone.
    pub(super) fn end_jet(&self, s: f64, place: TipPlace) -> Jet {
        let [mut end, _] = self.jets(s, &place);
        (end.gradient[0], end.hessian[0]) = (0.0, [0.0; 3]);
        end.hessian.iter_mut().for_each(|row| row[0] = 0.0);
        end
    }

    /// Whether v and θ are within the table.
    pub(super) fn spans(&self, place: TipPlace) -> bool {
        self.clamped(place) == place
    }

    /// The limit point at v and θ: u, energy and forces.
    pub fn limit(&self, place: TipPlace) -> SheetLimit {
        let [v, t] = self.across_at(&place);
        let rotations = self.axes[2].len();
        let force = |i: usize| -> f64 {
            let own = |a: usize, b: usize| self.limit_forces[i][(v.first + a) * rotations + t.first + b];
            let places = (0..v.count).flat_map(|a| (0..t.count).map(move |b| (a, b)));
            places.map(|(a, b)| v.derivatives[0][a] * t.derivatives[0][b] * own(a, b)).sum()
        };
        let [normal, energy] = self.jets(1.0, &place).map(|jet| jet.value);
        SheetLimit { normal, energy, force: std::array::from_fn(force) }
    }

    /// Whether u, v and θ are within the table, before the limit point.
    pub(crate) fn contains(&self, place: TipPlace) -> bool {
        let [begin, end] = self.ends(place);
        let inside = if begin < end { begin..=end } else { end..=begin };
        self.clamped(place) == place && inside.contains(&place.normal)
    }

    /// Whether u is beyond the limit point in which the branch ends.
    pub fn is_beyond(&self, place: TipPlace) -> bool {
        let weights = self.weights(&place);
        let end = weights.of(&self.displacement, self.axes[0].len() - 1);
        if self.rises { place.normal > end } else { place.normal < end }
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

    /// Energy, forces and stiffness at a place. Beyond the ranges of v and θ they are those of the expansions of U and Ê of second order from
    /// there, beyond those of u the continuation of the branch.
    pub fn response(&self, place: TipPlace) -> TipResponse {
        let weights = self.weights(&place);
        let ends = self.ends_by(&weights);
        let [begin, end] = ends;
        if (place.normal - begin) * (end - begin) < 0.0 {
            return self.before(place, begin < end, weights.bases);
        }
        self.response_at(self.path_at(place.normal, ends, &weights), weights.bases)
    }

    /// The response before the begin of the branch.
    fn before(&self, place: TipPlace, rising: bool, [v, t]: [Basis; 2]) -> TipResponse {
        let bases = [self.axes[0].basis(0.0), v, t];
        let along = |coefficients: &[f64]| {
            let sums = self.sums(coefficients, &bases);
            std::array::from_fn(|d| across(&sums[d]))
        };
        let (displacement, energy) = (along(&self.displacement), along(&self.energy));
        let continued = if rising { straight } else { decaying };
        let Jet { value, gradient, hessian } = continued(displacement, energy, place.normal);
        TipResponse { energy: value, force: gradient, stiffness: hessian }
    }

    /// The B-splines of v and θ at a place.
    fn across_at(&self, place: &TipPlace) -> [Basis; 2] {
        [self.axes[1].basis(place.lateral), self.axes[2].basis(place.rotation)]
    }

    /// The weights of coefficients at v and θ.
    fn weights(&self, place: &TipPlace) -> Weights {
        let bases @ [v, t] = self.across_at(place);
        let (length, rotations) = (self.axes[0].len(), self.axes[2].len());
        let mut weights = Weights { bases, count: 0, of: [(0, 0.0); SUPPORT * SUPPORT] };
        for i in 0..v.count {
            for j in 0..t.count {
                let from = ((v.first + i) * rotations + t.first + j) * length;
                weights.of[weights.count] = (from, v.derivatives[0][i] * t.derivatives[0][j]);
                weights.count += 1;
            }
        }
        weights
    }

    /// U at v and θ, on the piece of s.
    fn along(&self, s: f64, weights: &Weights) -> PiecePolynomial {
        let piece = self.axes[0].piece(s);
        piece.polynomial(&std::array::from_fn(|k| weights.of(&self.displacement, piece.first + k)))
    }

    /// S(u, v, θ): by Newton's method in a bracket.
    fn path_at(&self, normal: f64, ends: [f64; 2], weights: &Weights) -> f64 {
        let rising = ends[1] > ends[0];
        let (mut low, mut high) = (0.0, LAST);
        let mut s = self.first_guess((normal - ends[0]) / (ends[1] - ends[0]));
        let mut along = self.along(s, weights);
        for _ in 0..MOST_STEPS {
            if !along.holds(s) {
                along = self.along(s, weights);
            }
            // beyond the limit as in `response_at`
            let (value, slope) = along.at(s);
            let [more, steeper, _] = self.added(s);
            let (miss, slope) = (value + more - normal, slope + steeper);
            if (miss > 0.0) == rising {
                high = s
            } else {
                low = s
            }
            let next = s - miss / slope;
            if miss.abs() < FOUND || (next - s).abs() < FOUND {
                break;
            }
            s = if next > low && next < high { next } else { 0.5 * (low + high) };
        }
        s
    }

    /// s at a share of the way in u, by the nodes in the middle of the table.
    fn first_guess(&self, share: f64) -> f64 {
        let SheetTable { path, lateral, rotation, .. } = &self.table;
        let nodes = self.table.column(lateral.len() / 2, rotation.len() / 2);
        let (first, whole) = (nodes[0].normal, nodes[nodes.len() - 1].normal - nodes[0].normal);
        let share_of = |node: &SheetNode| (node.normal - first) / whole;
        let behind = nodes.partition_point(|node| share_of(node) <= share).clamp(1, nodes.len() - 1);
        let (a, b) = (share_of(&nodes[behind - 1]), share_of(&nodes[behind]));
        let part = ((share - a) / (b - a)).clamp(0.0, 1.0);
        path[behind - 1] + part * (path[behind] - path[behind - 1])
    }

    /// What continues U beyond the limit, with its derivatives by s.
    fn added(&self, s: f64) -> [f64; 3] {
        let ahead = (s - CONTINUED).max(0.0);
        let [kappa, _] = self.beyond;
        [kappa * ahead.powi(3), 3.0 * kappa * ahead * ahead, 6.0 * kappa * ahead]
    }

    /// U and Ê with their derivatives, as they are interpolated.
    fn jets(&self, s: f64, place: &TipPlace) -> [Jet; 2] {
        self.jets_by(s, self.across_at(place))
    }

    /// The same with the B-splines of v and θ.
    fn jets_by(&self, s: f64, [v, t]: [Basis; 2]) -> [Jet; 2] {
        let bases = [self.axes[0].basis(s), v, t];
        [&self.displacement, &self.energy].map(|coefficients| self.jet(coefficients, &bases))
    }

    fn jet(&self, coefficients: &[f64], bases: &[Basis; 3]) -> Jet {
        let sums = self.sums(coefficients, bases);
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

    /// Derivatives by s, v and θ, of each order in s and of up to two in v and θ together.
    fn sums(&self, coefficients: &[f64], [s, v, t]: &[Basis; 3]) -> [[[f64; 3]; 3]; 3] {
        let (length, rotations) = (self.axes[0].len(), self.axes[2].len());
        let mut sums = [[[0.0; 3]; 3]; 3];
        // a table of one v has no derivatives by it
        let orders = if v.count == 1 { &ORDERS[..3] } else { &ORDERS };
        for i in 0..v.count {
            for j in 0..t.count {
                let from = ((v.first + i) * rotations + t.first + j) * length + s.first;
                let mut own = [0.0; 3];
                for k in 0..s.count {
                    let c = coefficients[from + k];
                    (0..3).for_each(|d| own[d] += s.derivatives[d][k] * c);
                }
                for &(a, b) in orders {
                    let weight = v.derivatives[a][i] * t.derivatives[b][j];
                    (0..3).for_each(|d| sums[d][a][b] += weight * own[d]);
                }
            }
        }
        sums
    }

    /// U at s, v and θ.
    pub(super) fn displacement_at(&self, s: f64, place: TipPlace) -> f64 {
        self.jets(s, &place)[0].value
    }

    /// The response at s, v and θ without what continues the branch beyond its limit.
    pub(super) fn interpolated_at(&self, s: f64, place: TipPlace) -> TipResponse {
        response(&self.jets(s.min(1.0 - BEFORE_LIMIT), &place))
    }

    /// The response at s and the B-splines of v and θ.
    fn response_at(&self, s: f64, across: [Basis; 2]) -> TipResponse {
        let [mut u, mut e] = self.jets_by(s, across);
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

/// Coefficients of B-splines of v and θ, by where those along s begin, with their weights.
struct Weights {
    /// The B-splines of v and θ
    bases: [Basis; 2],
    count: usize,
    of: [(usize, f64); SUPPORT * SUPPORT],
}

impl Weights {
    /// The coefficient k along s.
    fn of(&self, coefficients: &[f64], k: usize) -> f64 {
        self.of[..self.count].iter().map(|(from, weight)| weight * coefficients[from + k]).sum()
    }
}

/// A derivative by s, with those of it by v and θ.
fn across(sums: &[[f64; 3]; 3]) -> Jet {
    Jet {
        value: sums[0][0],
        gradient: [0.0, sums[1][0], sums[0][1]],
        hessian: [[0.0; 3], [0.0, sums[2][0], sums[1][1]], [0.0, sums[1][1], sums[0][2]]],
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

// -- The nodes of one branch of a table --

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

// -- A branch before its begin: an energy of u, v and θ that goes on from there as a function that is twice differentiable, once where it decays --
//
// With U, U_s, U_ss and Ê, Ê_s, Ê_ss at s = 0, all functions of v and θ, and w = u - U,
//
// P0 = Ê_s/U_s,  K0 = (Ê_ss - P0 U_ss)/U_s².
//
// Pressed farther than the table goes, the tip is as stiff as where that begins: E = Ê + P0 w + ½ K0 w². Farther away than where the detached
// branch begins, its attraction falls off to zero: E = Ê (1 + w P0/(3 Ê))³ up to where that is zero.

/// The displacement less that at the begin.
fn beyond(begin: Jet, normal: f64) -> Jet {
    Jet::coordinate(normal, 0) - begin
}

/// With the stiffness at the begin: of U and Ê with their derivatives by s.
pub(super) fn straight(u: [Jet; 3], e: [Jet; 3], normal: f64) -> Jet {
    let force = e[1] / u[1];
    let stiffness = (e[2] - force * u[2]) / (u[1] * u[1]);
    let w = beyond(u[0], normal);
    e[0] + (force + stiffness * w * 0.5) * w
}

/// Down to zero.
pub(super) fn decaying(u: [Jet; 3], e: [Jet; 3], normal: f64) -> Jet {
    let share = beyond(u[0], normal) * (e[1] / u[1]) / (e[0] * 3.0);
    let left = Jet { value: 1.0 + share.value, ..share };
    // none is left, and where there is no attraction none was
    if left.value > 0.0 && left.value <= 1.0 { e[0] * left.cube() } else { Jet::default() }
}
