//! The law of a seta: the force on its root as the gradient of few potentials, each up to the plane on which tips let go.
//!
//!   E_k(u) = Σ a_ij (u/s)ⁱ (v/s)ʲ, i + j ≤ n, up to u·d_k = c_k;   E(u) = 0 behind the last one: detached
//!
//! u = (u, v) is how far the root has been moved along the ground and along its normal, from where the plane of the tips is the ground; it neither
//! turns nor moves sideways. On sheet 0 all tips adhere, and n is 2, 3 or 4: no closed way of the root below its plane takes or gives work.
//! On each sheet behind it some of the tips adhere, and n is 2: its stiffness is that between two losses, its force the mean of the sheet.
//! A law with one sheet is brittle: what the tips behind the first one hold is left out. A seta remembers nothing but the number of its sheet, and
//! does not go back to an earlier one.

use super::path::RootPath;
use serde::{Deserialize, Serialize};

/// Energy of a seta with its derivatives by the place of its root.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RootResponse {
    /// aJ
    pub energy: f64,
    /// ∂E/∂u, nN: what holds the root
    pub force: [f64; 2],
    /// ∂²E/∂u², nN/nm
    pub stiffness: [[f64; 2]; 2],
}

/// The plane u·d = c on which tips let go.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExitPlane {
    /// d, of length one
    pub direction: [f64; 2],
    /// c, nm
    pub distance: f64,
}

impl ExitPlane {
    /// Of d to the ground, rad.
    pub fn angle(&self) -> f64 {
        self.direction[1].atan2(self.direction[0])
    }

    /// u·d/c: one on the plane.
    pub fn share(&self, root: [f64; 2]) -> f64 {
        dot(root, self.direction) / self.distance
    }

    /// How far the root goes from a place along a direction, in lengths of that, until it is on the plane: zero beyond it. None where it does not
    /// come nearer.
    pub fn ahead(&self, root: [f64; 2], direction: [f64; 2]) -> Option<f64> {
        let left = self.distance - dot(root, self.direction);
        let nearer = dot(direction, self.direction);
        if left <= 0.0 { Some(0.0) } else { (nearer > 0.0).then(|| left / nearer) }
    }
}

/// A sheet of the law of a seta.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LawSheet {
    /// Most tips that adhere on it; the fewest are one more than the most on the next one
    pub tips: usize,
    /// a_ij, aJ, by rising i + j, and by falling i where that is the same
    pub coefficients: Vec<f64>,
    /// Where it is left
    pub exit: ExitPlane,
}

/// How wrong a law is on the paths that it was made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SetaLawErrors {
    /// Largest |F - F_resolved| before the first loss over the largest force there
    pub force: f64,
    /// The same of each path by the law of all others: what is to be expected on another path among these
    pub force_left_out: f64,
    /// Largest |u·d/c - 1| where the first tip lets go
    pub exit: f64,
    /// The same of each path by the plane of all others
    pub exit_left_out: f64,
    /// Largest difference of the largest force of a path from that of the resolved seta, over that
    pub peak: f64,
    /// The same of each path by the law of all others
    pub peak_left_out: f64,
    /// Largest difference of the work until the seta is detached from that of the resolved one, over that
    pub work: f64,
    /// The same of each path by the law of all others
    pub work_left_out: f64,
}

/// The law of a seta.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaLaw {
    /// n of its first sheet
    pub degree: usize,
    /// s, nm
    pub scale: f64,
    /// In the order in which they are left, one at least
    pub sheets: Vec<LawSheet>,
    /// Largest force of the paths before the first loss, nN
    pub largest_force: f64,
    /// On the paths that it was made of
    pub errors: SetaLawErrors,
}

impl SetaLaw {
    /// Energy, force and stiffness on a sheet with the root at a place, nm. Nothing behind the last one.
    pub fn response(&self, sheet: usize, root: [f64; 2]) -> RootResponse {
        let mut out = RootResponse::default();
        let Some(own) = self.sheets.get(sheet) else { return out };
        for (power, coefficient) in powers(self.degree).into_iter().zip(&own.coefficients) {
            let own = term(power, root, self.scale);
            out.energy += coefficient * own.energy;
            for i in 0..2 {
                out.force[i] += coefficient * own.force[i];
                (0..2).for_each(|j| out.stiffness[i][j] += coefficient * own.stiffness[i][j]);
            }
        }
        out
    }

    /// The sheet of a seta that has been on `before` when its root is at a place, nm; the number of sheets where it is detached.
    pub fn sheet(&self, before: usize, root: [f64; 2]) -> usize {
        let holds = |sheet: &usize| self.sheets[*sheet].exit.share(root) < 1.0;
        (before..self.sheets.len()).find(holds).unwrap_or(self.sheets.len())
    }

    /// Where the first tip lets go.
    pub fn first_exit(&self) -> ExitPlane {
        self.sheets[0].exit
    }

    /// Largest |F - F_resolved| on a path before its first loss, nN.
    pub fn largest_force_error(&self, path: &RootPath) -> f64 {
        let tips = path.tips();
        let off = path.with(tips - 1, tips).map(|point| {
            let force = self.response(0, point.root).force;
            length([force[0] - point.force[0], force[1] - point.force[1]])
        });
        off.fold(0.0, f64::max)
    }

    /// By how much largest force and work along a path differ from those of the resolved seta, relative.
    pub fn peak_and_work_error(&self, path: &RootPath) -> [f64; 2] {
        let [largest, work] = self.along(&path.corners());
        [largest / path.largest_force() - 1.0, work / path.work() - 1.0]
    }

    /// Largest force (nN) and work (aJ) of the root straight from place to place, and straight on on the last way, from sheet 0 until the seta is
    /// detached. The force is looked at where a way or a sheet begins or ends.
    pub fn along(&self, places: &[[f64; 2]]) -> [f64; 2] {
        let (mut largest, mut work, mut on) = (0.0f64, 0.0, 0);
        for (leg, ends) in places.windows(2).enumerate() {
            let &[from, to] = ends else { continue };
            let most = if leg + 2 == places.len() { f64::INFINITY } else { 1.0 };
            let way = [to[0] - from[0], to[1] - from[1]];
            let at = |share: f64| [from[0] + share * way[0], from[1] + share * way[1]];
            let mut done = 0.0;
            while let Some(sheet) = self.sheets.get(on) {
                let left_at = sheet.exit.ahead(at(done), way).map_or(f64::INFINITY, |ahead| done + ahead);
                let until = left_at.min(most);
                if until.is_infinite() {
                    break;
                }
                let [start, end] = [done, until].map(|share| self.response(on, at(share)));
                work += end.energy - start.energy;
                largest = largest.max(length(start.force)).max(length(end.force));
                done = until;
                if left_at > most {
                    break;
                }
                on += 1;
            }
        }
        [largest, work]
    }
}

/// (i, j) of all terms.
pub(super) fn powers(degree: usize) -> Vec<[usize; 2]> {
    (0..=degree).flat_map(|sum| (0..=sum).map(move |j| [sum - j, j])).collect()
}

/// (u/s)ⁱ (v/s)ʲ with its derivatives by u and v.
pub(super) fn term(power: [usize; 2], root: [f64; 2], scale: f64) -> RootResponse {
    // of one factor: its value and its two derivatives
    let factor = |k: usize| {
        let (n, x) = (power[k] as i32, root[k] / scale);
        let first = if n < 1 { 0.0 } else { f64::from(n) * x.powi(n - 1) };
        let second = if n < 2 { 0.0 } else { f64::from(n * (n - 1)) * x.powi(n - 2) };
        [x.powi(n), first / scale, second / scale.powi(2)]
    };
    let (a, b) = (factor(0), factor(1));
    let mixed = a[1] * b[1];
    RootResponse {
        energy: a[0] * b[0],
        force: [a[1] * b[0], a[0] * b[1]],
        stiffness: [[a[2] * b[0], mixed], [mixed, a[0] * b[2]]],
    }
}

/// a·b
pub(crate) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn length(of: [f64; 2]) -> f64 {
    of[0].hypot(of[1])
}
