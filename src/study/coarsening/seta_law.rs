//! The law of a seta: the force on its root as the gradient of one potential, up to the plane on which its first tip lets go.
//!
//!   E(u) = Σ a_ij (u/s)ⁱ (v/s)ʲ, i + j ≤ n, while all tips adhere and u·d < c;   E(u) = 0 once it is detached
//!
//! u = (u, v) is how far the root has been moved along the ground and along its normal, from where the plane of the tips is the ground; it neither
//! turns nor moves sideways. n is 2, 3 or 4. Energies and forces of resolved paths of the root are fitted together, so that no closed way of the
//! root below the plane takes or gives work. The direction d and the distance c come from where the first tip lets go on each path.
//! The law is brittle: what the tips behind the first one hold is left out.

use crate::model::seta::check::SetaError;
use crate::model::seta::parameters::SetaModel;
use crate::model::seta::tip_law::TipBranch;
use crate::study::asked::stop_criteria::{Bound, StopCriteria};
use crate::study::seta::loading::{SetaLoading, SetaOptions, SetaStart};
use crate::study::seta::result::{EventCause, SetaEnd, SetaFailure, SetaPullOff};
use crate::study::seta::run::pull_off_from;
use crate::study::states::seta_state::SetaPoint;
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

/// Points after which a pull is looked at: it is followed to its first event alone.
const LOOK: usize = 4;
/// Least singular value over the largest one of columns of equal length: below that the paths do not determine the law.
const RANK: f64 = 1e-9;
/// Fewest paths: one is left out, and two determine a plane.
const FEWEST_PATHS: usize = 3;

// -- Resolved paths of the root --

/// A place of the root in a resolved path, in the plane of x and y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RootPoint {
    /// (u, v), nm
    pub root: [f64; 2],
    /// That holds the root, nN
    pub force: [f64; 2],
    /// Against being detached and stress-free, aJ
    pub energy: f64,
}

/// A path of the root of a resolved seta on which all tips adhere; at its last point the first one lets go.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RootPath {
    /// In their order, two at least
    pub points: Vec<RootPoint>,
}

/// Why the law of a seta cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)] // the message of each names its numbers
pub enum SetaLawError {
    #[error(transparent)]
    Seta(#[from] SetaError),
    #[error("a potential of degree {degree} is asked of the law of a seta: give 2, 3 or 4")]
    Degree { degree: usize },
    #[error("the law of a seta is made of {paths} paths of its root: give at least three, in different directions")]
    TooFewPaths { paths: usize },
    #[error(
        "step {} of the path of the root goes along {direction:?}, out of the plane of x and y: the law of a seta knows no way along z", .step + 1
    )]
    OutOfPlane { step: usize, direction: [f64; 3] },
    #[error(
        "the path of the root starts {height} nm above the ground: the law of a seta wants all tips to adhere at the start"
    )]
    StartsAbove { height: f64 },
    #[error(
        "{attached} of {tips} tips adhere at the start of the path of the root: the law of a seta wants all; try a smaller scatter of the tips"
    )]
    NotAllAdhere { attached: usize, tips: usize },
    #[error("the path of the root cannot be followed to the first loss of a tip: {0}")]
    Failed(SetaFailure),
    #[error("the path of the root is stopped by {0} before a tip lets go: allow more")]
    Stopped(Bound),
    #[error("no tip lets go on the path of the root, up to {displacement:.6} nm of its last step: pull farther")]
    NoLoss { displacement: f64 },
    #[error(
        "the first event on the path of the root, at {displacement:.6} nm of its step {}, is not the loss of a tip: beams buckle or tips adhere; leave out this direction", .step + 1
    )]
    OtherEvent { step: usize, displacement: f64 },
    #[error("path {} of the root has a number that is not finite, or fewer than two points: compute it again", .path + 1)]
    Path { path: usize },
    #[error(
        "{paths} paths of the root do not determine a potential of degree {degree}, and with each one left out they have to: least singular value {least:.1e}; give more directions or a lower degree"
    )]
    Undetermined { paths: usize, degree: usize, least: f64 },
}

impl RootPath {
    /// Moves the root of a seta as the loading says until the first tip lets go.
    ///
    /// # Errors
    /// A loading out of the plane or from above the ground; a path that fails, is stopped, or has another event before a tip lets go.
    pub fn resolved(
        model: &SetaModel,
        loading: &SetaLoading,
        options: &SetaOptions,
        stop: &StopCriteria,
    ) -> Result<Self, SetaLawError> {
        loading.check()?;
        if let SetaStart::Above(height) = loading.start {
            return Err(SetaLawError::StartsAbove { height });
        }
        for (step, own) in loading.steps.iter().enumerate() {
            if own.direction[2] != 0.0 {
                return Err(SetaLawError::OutOfPlane { step, direction: own.direction });
            }
        }
        Self::before_loss(&first_event(model, loading, options, stop)?, model.seta.tips())
    }

    /// What of a pull-off comes before its first event, which has to be the loss of a tip.
    fn before_loss(pulled: &SetaPullOff, tips: usize) -> Result<Self, SetaLawError> {
        if let Some(&start) = pulled.points.first()
            && start.attached != tips
        {
            return Err(SetaLawError::NotAllAdhere { attached: start.attached, tips });
        }
        let Some(event) = pulled.events.first() else {
            return Err(match &pulled.end {
                SetaEnd::Failed(failure) => SetaLawError::Failed(failure.clone()),
                SetaEnd::Bound(bound) => SetaLawError::Stopped(bound.clone()),
                SetaEnd::Completed => {
                    SetaLawError::NoLoss { displacement: pulled.points.last().map_or(0.0, |last| last.displacement) }
                }
            });
        };
        let lets_go = event.tips.first().is_some_and(|change| change.to == TipBranch::Detached);
        if event.cause != EventCause::Tips || !lets_go {
            let (step, displacement) = (event.before.step, event.before.displacement);
            return Err(SetaLawError::OtherEvent { step, displacement });
        }
        let until = pulled.points.iter().position(|point| *point == event.before).map_or(0, |last| last + 1);
        let of = |point: &SetaPoint| RootPoint {
            root: [point.root[0], point.root[1]],
            force: [point.force[0], point.force[1]],
            energy: point.energy,
        };
        Ok(Self { points: pulled.points[..until].iter().map(of).collect() })
    }

    /// Where the first tip lets go, nm.
    fn loss(&self) -> [f64; 2] {
        self.points[self.points.len() - 1].root
    }

    fn is_usable(&self) -> bool {
        let finite = |p: &RootPoint| p.root.iter().chain(&p.force).chain([&p.energy]).all(|number| number.is_finite());
        self.points.len() >= 2 && self.points.iter().all(finite)
    }
}

/// A pull-off as far as its first event.
fn first_event(
    model: &SetaModel,
    loading: &SetaLoading,
    options: &SetaOptions,
    stop: &StopCriteria,
) -> Result<SetaPullOff, SetaLawError> {
    let (mut points, mut reached) = (LOOK.min(stop.points), None);
    loop {
        let own = StopCriteria { points, ..stop.clone() };
        let (pulled, progress) = pull_off_from(model, loading, options, &own, reached)?;
        let goes_on = matches!(pulled.end, SetaEnd::Bound(Bound::Points(_))) && points < stop.points;
        if !pulled.events.is_empty() || !goes_on {
            return Ok(pulled);
        }
        (points, reached) = ((points + LOOK).min(stop.points), progress);
    }
}

// -- The law --

/// On which of its sheets a seta is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SetaSheet {
    /// All tips adhere.
    Adhering,
    /// None does.
    Detached,
}

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

/// The plane u·d = c on which the first tip lets go.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExitPlane {
    /// d, of length one
    pub direction: [f64; 2],
    /// c, nm
    pub distance: f64,
}

impl ExitPlane {
    /// Of the places (nm) at which tips let go: the least sum of squares of u·d/c - 1. None where they do not determine it.
    fn through(losses: &[[f64; 2]]) -> Option<Self> {
        let places = DMatrix::from_fn(losses.len(), 2, |row, i| losses[row][i]);
        let (over, _) = least_squares(places, &DVector::from_element(losses.len(), 1.0));
        let over = over?;
        let norm = over.norm();
        (norm > 0.0).then(|| Self { direction: [over[0] / norm, over[1] / norm], distance: 1.0 / norm })
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

/// How wrong a law is on the paths that it was made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SetaLawErrors {
    /// Largest |F - F_resolved| over the largest force of all paths
    pub force: f64,
    /// The same of each path by the law of all others: what is to be expected on another path among these
    pub force_left_out: f64,
    /// Largest |u·d/c - 1| where a tip lets go
    pub exit: f64,
    /// The same of each path by the plane of all others
    pub exit_left_out: f64,
}

/// The law of a seta with one sheet: brittle at the first loss of a tip.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetaLaw {
    /// n
    pub degree: usize,
    /// s, nm
    pub scale: f64,
    /// a_ij, aJ, by rising i + j, and by falling i where that is the same
    pub coefficients: Vec<f64>,
    /// Where it is left
    pub exit: ExitPlane,
    /// Largest force of the paths, nN
    pub largest_force: f64,
    /// On the paths that it was made of
    pub errors: SetaLawErrors,
}

impl SetaLaw {
    /// Of resolved paths, with a potential of degree 2, 3 or 4. Every point counts alike.
    ///
    /// # Errors
    /// A degree that does not exist; paths that are too few, that are none, or that do not determine the law with any one of them left out.
    pub fn fitted(paths: &[RootPath], degree: usize) -> Result<Self, SetaLawError> {
        if !(2..=4).contains(&degree) {
            return Err(SetaLawError::Degree { degree });
        }
        if paths.len() < FEWEST_PATHS {
            return Err(SetaLawError::TooFewPaths { paths: paths.len() });
        }
        if let Some(path) = paths.iter().position(|path| !path.is_usable()) {
            return Err(SetaLawError::Path { path });
        }
        let all: Vec<&RootPath> = paths.iter().collect();
        let mut law = Self::of(&all, degree)?;
        for (path, own) in paths.iter().enumerate() {
            let others: Vec<&RootPath> = (0..paths.len()).filter(|&other| other != path).map(|k| &paths[k]).collect();
            let without = Self::of(&others, degree)?;
            let off = |law: &Self| law.largest_force_error(own) / law.largest_force;
            let apart = |law: &Self| (law.exit.share(own.loss()) - 1.0).abs();
            let without = Self { largest_force: law.largest_force, ..without };
            law.errors = SetaLawErrors {
                force: law.errors.force.max(off(&law)),
                force_left_out: law.errors.force_left_out.max(off(&without)),
                exit: law.errors.exit.max(apart(&law)),
                exit_left_out: law.errors.exit_left_out.max(apart(&without)),
            };
        }
        Ok(law)
    }

    /// Without its errors.
    fn of(paths: &[&RootPath], degree: usize) -> Result<Self, SetaLawError> {
        let undetermined = |least| SetaLawError::Undetermined { paths: paths.len(), degree, least };
        let losses: Vec<[f64; 2]> = paths.iter().map(|path| path.loss()).collect();
        let exit = ExitPlane::through(&losses).ok_or_else(|| undetermined(0.0))?;
        let points: Vec<&RootPoint> = paths.iter().flat_map(|path| &path.points).collect();
        let largest_force = points.iter().map(|point| length(point.force)).fold(0.0, f64::max);
        if largest_force == 0.0 {
            return Err(undetermined(0.0));
        }
        // numbers without units: forces over the largest one, energies over that times c
        let (scale, unit) = (exit.distance, largest_force * exit.distance);
        let powers = powers(degree);
        let (mut rows, mut wanted) = (Vec::new(), Vec::new());
        for point in &points {
            let terms: Vec<RootResponse> = powers.iter().map(|&power| term(power, point.root, scale)).collect();
            rows.extend(terms.iter().map(|term| term.energy));
            wanted.push(point.energy / unit);
            for i in 0..2 {
                rows.extend(terms.iter().map(|term| term.force[i] * scale));
                wanted.push(point.force[i] / largest_force);
            }
        }
        let matrix = DMatrix::from_row_slice(wanted.len(), powers.len(), &rows);
        let (solved, least) = least_squares(matrix, &DVector::from_vec(wanted));
        let coefficients = solved.ok_or_else(|| undetermined(least))?.iter().map(|own| own * unit).collect();
        Ok(Self { degree, scale, coefficients, exit, largest_force, errors: SetaLawErrors::default() })
    }

    /// Energy, force and stiffness with the root at a place, nm.
    pub fn response(&self, on: SetaSheet, root: [f64; 2]) -> RootResponse {
        let mut out = RootResponse::default();
        if on == SetaSheet::Detached {
            return out;
        }
        for (power, coefficient) in powers(self.degree).into_iter().zip(&self.coefficients) {
            let own = term(power, root, self.scale);
            out.energy += coefficient * own.energy;
            for i in 0..2 {
                out.force[i] += coefficient * own.force[i];
                (0..2).for_each(|j| out.stiffness[i][j] += coefficient * own.stiffness[i][j]);
            }
        }
        out
    }

    /// The sheet of a seta that has been on `before` when its root is at a place, nm. What is detached stays so.
    pub fn sheet(&self, before: SetaSheet, root: [f64; 2]) -> SetaSheet {
        if before == SetaSheet::Adhering && self.exit.share(root) < 1.0 {
            SetaSheet::Adhering
        } else {
            SetaSheet::Detached
        }
    }

    /// Largest |F - F_resolved| on a path, nN.
    pub fn largest_force_error(&self, path: &RootPath) -> f64 {
        let off = |point: &RootPoint| {
            let force = self.response(SetaSheet::Adhering, point.root).force;
            length([force[0] - point.force[0], force[1] - point.force[1]])
        };
        path.points.iter().map(off).fold(0.0, f64::max)
    }
}

/// (i, j) of all terms.
fn powers(degree: usize) -> Vec<[usize; 2]> {
    (0..=degree).flat_map(|sum| (0..=sum).map(move |j| [sum - j, j])).collect()
}

/// (u/s)ⁱ (v/s)ʲ with its derivatives by u and v.
fn term(power: [usize; 2], root: [f64; 2], scale: f64) -> RootResponse {
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

/// The least squares of A x = b with columns of equal length, and the least of its singular values over the largest. No x where that is too small.
fn least_squares(mut matrix: DMatrix<f64>, wanted: &DVector<f64>) -> (Option<DVector<f64>>, f64) {
    if matrix.nrows() < matrix.ncols() {
        return (None, 0.0);
    }
    let norms: Vec<f64> = matrix.column_iter().map(|column| column.norm().max(f64::MIN_POSITIVE)).collect();
    norms.iter().enumerate().for_each(|(k, norm)| matrix.column_mut(k).scale_mut(1.0 / norm));
    let svd = matrix.svd(true, true);
    let least = svd.singular_values.min() / svd.singular_values.max();
    if least.is_nan() || least < RANK {
        return (None, least);
    }
    let solved = svd.solve(wanted, 0.0).ok();
    (solved.map(|x| DVector::from_fn(x.len(), |k, _| x[k] / norms[k])), least)
}

/// a·b
pub(crate) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn length(of: [f64; 2]) -> f64 {
    of[0].hypot(of[1])
}
