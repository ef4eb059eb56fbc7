//! How the law of a seta is made of resolved paths: each sheet by least squares, and sheets divided until peaks and works are those of the paths.
//!
//! The first sheet is fitted to forces. On one behind it tips let go while it holds, so that the force falls from loss to loss and rises between them.
//! Its stiffness K is that of the rises, ΔF = K Δu from one point to the next one with the same tips: that of a set of tips, and never negative.

use super::law::{ExitPlane, LawSheet, RootResponse, SetaLaw, SetaLawErrors, length, powers, term};
use super::path::{RootPath, RootPoint, SetaLawError};
use nalgebra::{DMatrix, DVector, Matrix2, Vector2};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Least singular value over the largest one of columns of equal length: below that the paths do not determine the first sheet.
const RANK: f64 = 1e-9;
/// The same of the stiffness of a sheet behind it: what the paths determine less than so is left out.
const STRIP: f64 = 1e-3;
/// Fewest paths: one is left out, and two determine a plane.
const FEWEST_PATHS: usize = 3;
/// Most sheets that may be asked for.
const MOST_SHEETS: usize = 64;
/// Where the tips of a sheet are divided.
const PARTS: [f64; 5] = [0.125, 0.25, 0.5, 0.75, 0.875];
/// Further sheets have to leave less than that of the sum of the squares of the errors.
const GAIN: f64 = 0.9;

/// What is asked of the law of a seta.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetaLawOptions {
    /// Of the potential of its first sheet: 2, 3 or 4
    pub degree: usize,
    /// Most sheets; with one the law is brittle
    pub sheets: usize,
    /// Sheets are divided until peak and work of each path are within it, relative
    pub tolerance: f64,
}

impl Default for SetaLawOptions {
    fn default() -> Self {
        Self { degree: 2, sheets: 16, tolerance: 0.03 }
    }
}

impl SetaLawOptions {
    /// Whether there may be such a law.
    ///
    /// # Errors
    /// The first number that is none.
    pub fn check(&self) -> Result<(), SetaLawError> {
        let &Self { degree, sheets, tolerance } = self;
        if !(2..=4).contains(&degree) {
            return Err(SetaLawError::Degree { degree });
        }
        if !(1..=MOST_SHEETS).contains(&sheets) {
            return Err(SetaLawError::Sheets { sheets });
        }
        if tolerance > 0.0 && tolerance < 1.0 { Ok(()) } else { Err(SetaLawError::Tolerance { tolerance }) }
    }
}

impl SetaLaw {
    /// Of resolved paths. Every point of a sheet counts alike. Where no law is within the tolerance, it has the fewest sheets that are hardly worse
    /// than the best.
    ///
    /// # Errors
    /// What cannot be asked for; paths that are too few, that are none, or that do not determine the first sheet with any one of them left out.
    pub fn fitted(paths: &[RootPath], options: &SetaLawOptions) -> Result<Self, SetaLawError> {
        options.check()?;
        let &SetaLawOptions { degree, sheets, tolerance } = options;
        if paths.len() < FEWEST_PATHS {
            return Err(SetaLawError::TooFewPaths { paths: paths.len() });
        }
        let tips = paths[0].tips();
        if let Some(path) = paths.iter().position(|path| !path.is_usable() || path.tips() != tips) {
            return Err(SetaLawError::Path { path });
        }
        let all: Vec<&RootPath> = paths.iter().collect();
        let fit = Fit::of(&all, degree)?;
        let whole = fit.law(&[tips]);
        let mut made = vec![(Errors::of(&whole, &all), whole, vec![tips])];
        while let Some((errors, _, most)) = made.last()
            && most.len() < sheets
            && errors.largest() > tolerance
        {
            let further = divided(most).into_iter().filter_map(|most| {
                let law = fit.law(&most);
                (law.sheets.len() == most.len()).then(|| (Errors::of(&law, &all), law, most))
            });
            let Some(best) = further.min_by(|a, b| a.0.squares().total_cmp(&b.0.squares())) else { break };
            made.push(best);
        }
        // where none is within the tolerance, the first one that is hardly worse than the best
        let least = made.iter().map(|law| law.0.squares()).fold(f64::INFINITY, f64::min);
        let good = |(errors, ..): &(Errors, Self, Vec<usize>)| {
            errors.largest() <= tolerance || GAIN * errors.squares() <= least
        };
        let found = made.iter().position(good).unwrap_or(0);
        let (_, mut law, most) = made.swap_remove(found);
        law.errors = errors(&law, paths, degree, &most)?;
        Ok(law)
    }
}

/// The most tips of each sheet, with one sheet more; the first one keeps all tips alone.
fn divided(most: &[usize]) -> Vec<Vec<usize>> {
    if let [all] = most {
        return if *all > 1 { vec![vec![*all, all - 1]] } else { Vec::new() };
    }
    let mut out = Vec::new();
    for sheet in 1..most.len() {
        let fewest = most.get(sheet + 1).copied().unwrap_or(0);
        let mut places = PARTS.map(|part| fewest + (part * (most[sheet] - fewest) as f64).round() as usize).to_vec();
        places.dedup();
        for place in places.into_iter().filter(|&place| place > fewest && place < most[sheet]) {
            let mut finer = most.to_vec();
            finer.insert(sheet + 1, place);
            out.push(finer);
        }
    }
    out
}

// -- One law --

/// Paths that a law is made of, with its first sheet.
struct Fit<'a> {
    paths: &'a [&'a RootPath],
    degree: usize,
    first: LawSheet,
    /// Of the paths on it, nN
    largest_force: f64,
    /// Sheets behind it by their fewest and most tips
    known: RefCell<BTreeMap<[usize; 2], Option<LawSheet>>>,
}

impl<'a> Fit<'a> {
    fn of(paths: &'a [&'a RootPath], degree: usize) -> Result<Self, SetaLawError> {
        let undetermined = |least| SetaLawError::Undetermined { paths: paths.len(), degree, least };
        let tips = paths[0].tips();
        let exit = exit(paths, tips - 1).ok_or_else(|| undetermined(0.0))?;
        let points: Vec<&RootPoint> = paths.iter().flat_map(|path| path.with(tips - 1, tips)).collect();
        let (coefficients, least) = potential(&points, degree, exit.distance);
        let coefficients = coefficients.filter(|_| least >= RANK).ok_or_else(|| undetermined(least))?;
        let largest_force = points.iter().map(|point| length(point.force)).fold(0.0, f64::max);
        let first = LawSheet { tips, coefficients, exit };
        Ok(Self { paths, degree, first, largest_force, known: RefCell::default() })
    }

    /// With sheets of so many tips at most, the first one with all of them, without its errors. A sheet on which the paths have too few points is left
    /// out.
    fn law(&self, most: &[usize]) -> SetaLaw {
        let mut sheets = vec![self.first.clone()];
        for (sheet, &tips) in most.iter().enumerate().skip(1) {
            let fewest = most.get(sheet + 1).copied().unwrap_or(0);
            let mut known = self.known.borrow_mut();
            sheets.extend(known.entry([fewest, tips]).or_insert_with(|| self.behind(fewest, tips)).clone());
        }
        let &Self { degree, largest_force, .. } = self;
        SetaLaw { degree, scale: self.first.exit.distance, sheets, largest_force, errors: SetaLawErrors::default() }
    }

    /// A sheet behind the first one.
    fn behind(&self, fewest: usize, tips: usize) -> Option<LawSheet> {
        Some(LawSheet { tips, coefficients: self.spring(fewest, tips)?, exit: exit(self.paths, fewest)? })
    }

    fn with(&self, fewest: usize, most: usize) -> impl Iterator<Item = &RootPoint> {
        self.paths.iter().flat_map(move |path| path.with(fewest, most))
    }

    /// E0 + g·u + ½ u·K u where more than `fewest` and at most `most` tips adhere, with the mean force and the mean energy. None where fewer than three
    /// paths have two points with the same tips there.
    fn spring(&self, fewest: usize, most: usize) -> Option<Vec<f64>> {
        let (mut rows, mut wanted, mut paths) = (Vec::new(), Vec::new(), 0);
        for path in self.paths {
            let before = wanted.len();
            for pair in path.points.windows(2) {
                let [one, next] = pair else { continue };
                let way = [next.root[0] - one.root[0], next.root[1] - one.root[1]];
                if one.tips == next.tips && one.tips > fewest && one.tips <= most && length(way) > 0.0 {
                    rows.extend([way[0], way[1], 0.0, 0.0, way[0], way[1]]);
                    wanted.extend([next.force[0] - one.force[0], next.force[1] - one.force[1]]);
                }
            }
            paths += usize::from(wanted.len() > before);
        }
        if paths < FEWEST_PATHS {
            return None;
        }
        let matrix = DMatrix::from_row_slice(wanted.len(), 3, &rows);
        let entries = least_squares(matrix, &DVector::from_vec(wanted), STRIP).0?;
        let stiffness = never_negative(Matrix2::new(entries[0], entries[1], entries[1], entries[2]));
        let (mut points, mut force, mut energy) = (0.0, Vector2::zeros(), 0.0);
        for point in self.with(fewest, most) {
            let root = Vector2::from(point.root);
            points += 1.0;
            force += Vector2::from(point.force) - stiffness * root;
            energy += point.energy - 0.5 * root.dot(&(stiffness * root));
        }
        force /= points;
        let places = self.with(fewest, most).map(|point| force.dot(&Vector2::from(point.root)));
        energy = (energy - places.sum::<f64>()) / points;
        let [along, mixed, normal] = [stiffness[(0, 0)], stiffness[(0, 1)], stiffness[(1, 1)]];
        let scale = self.first.exit.distance;
        let square = scale * scale;
        Some(vec![
            energy,
            force[0] * scale,
            force[1] * scale,
            0.5 * along * square,
            mixed * square,
            0.5 * normal * square,
        ])
    }
}

/// Of the places at which no more than so many tips are left: the least sum of squares of u·d/c - 1. None where they do not determine it.
fn exit(paths: &[&RootPath], tips: usize) -> Option<ExitPlane> {
    let places = DMatrix::from_fn(paths.len(), 2, |row, i| paths[row].loss(tips)[i]);
    let (over, least) = least_squares(places, &DVector::from_element(paths.len(), 1.0), RANK);
    let over = over.filter(|_| least >= RANK)?;
    let norm = over.norm();
    (norm > 0.0).then(|| ExitPlane { direction: [over[0] / norm, over[1] / norm], distance: 1.0 / norm })
}

/// The potential whose gradient is nearest to the forces at points, at their mean energy, with the least singular value over the
/// largest one. None where there are fewer points than coefficients.
fn potential(points: &[&RootPoint], degree: usize, scale: f64) -> (Option<Vec<f64>>, f64) {
    let powers = powers(degree);
    if points.len() < powers.len() {
        return (None, 0.0);
    }
    let force = points.iter().map(|point| length(point.force)).fold(f64::MIN_POSITIVE, f64::max);
    let terms: Vec<Vec<RootResponse>> =
        points.iter().map(|point| powers.iter().map(|&power| term(power, point.root, scale)).collect()).collect();
    // numbers without units: forces over the largest one, energies over that times s; the constant has no force
    let rows = terms.iter().flat_map(|terms| [0, 1].map(|i| (terms, i)));
    let rows = rows.flat_map(|(terms, i)| terms[1..].iter().map(move |term| term.force[i] * scale));
    let matrix = DMatrix::from_row_iterator(2 * points.len(), powers.len() - 1, rows);
    let wanted = DVector::from_iterator(2 * points.len(), points.iter().flat_map(|p| p.force.map(|own| own / force)));
    let (solved, least) = least_squares(matrix, &wanted, RANK);
    let Some(solved) = solved else { return (None, least) };
    let own: Vec<f64> = solved.iter().map(|own| own * force * scale).collect();
    let rest = points.iter().zip(&terms).map(|(point, terms)| {
        point.energy - terms[1..].iter().zip(&own).map(|(term, own)| term.energy * own).sum::<f64>()
    });
    let mean = rest.sum::<f64>() / points.len() as f64;
    (Some([&[mean][..], &own].concat()), least)
}

/// The nearest symmetric matrix without negative eigenvalues.
fn never_negative(stiffness: Matrix2<f64>) -> Matrix2<f64> {
    let mut eigen = stiffness.symmetric_eigen();
    eigen.eigenvalues.apply(|own| *own = own.max(0.0));
    eigen.recompose()
}

/// The least squares of A x = b with columns of equal length, and the least of its singular values over the largest. Of x what belongs to singular
/// values below `rank` times the largest one is left out.
fn least_squares(mut matrix: DMatrix<f64>, wanted: &DVector<f64>, rank: f64) -> (Option<DVector<f64>>, f64) {
    let norms: Vec<f64> = matrix.column_iter().map(|column| column.norm().max(f64::MIN_POSITIVE)).collect();
    norms.iter().enumerate().for_each(|(k, norm)| matrix.column_mut(k).scale_mut(1.0 / norm));
    let svd = matrix.svd(true, true);
    let most = svd.singular_values.max();
    let least = svd.singular_values.min() / most;
    let solved = if least.is_nan() { None } else { svd.solve(wanted, rank * most).ok() };
    (solved.map(|x| DVector::from_fn(x.len(), |k, _| x[k] / norms[k])), least)
}

// -- Its errors --

/// Differences of a law from resolved paths in peak and work, relative.
struct Errors(Vec<[f64; 2]>);

impl Errors {
    fn of(law: &SetaLaw, paths: &[&RootPath]) -> Self {
        Self(paths.iter().map(|path| law.peak_and_work_error(path)).collect())
    }

    /// Of peak and work.
    fn each(&self) -> [f64; 2] {
        [0, 1].map(|k| self.0.iter().map(|own| own[k].abs()).fold(0.0, f64::max))
    }

    fn largest(&self) -> f64 {
        self.each().into_iter().fold(0.0, f64::max)
    }

    fn squares(&self) -> f64 {
        self.0.iter().flatten().map(|own| own * own).sum()
    }
}

/// Of a law with these sheets on each path, and of that of all others.
fn errors(law: &SetaLaw, paths: &[RootPath], degree: usize, most: &[usize]) -> Result<SetaLawErrors, SetaLawError> {
    let mut out = SetaLawErrors::default();
    for (left_out, path) in paths.iter().enumerate() {
        let others: Vec<&RootPath> = (0..paths.len()).filter(|&other| other != left_out).map(|k| &paths[k]).collect();
        let without = Fit::of(&others, degree)?.law(most);
        let [own, other] = [law, &without].map(|made| {
            let [peak, work] = Errors::of(made, &[path]).each();
            let force = made.largest_force_error(path) / law.largest_force;
            [force, (made.first_exit().share(path.loss(path.tips() - 1)) - 1.0).abs(), peak, work]
        });
        let SetaLawErrors { force, force_left_out, exit, exit_left_out, peak, peak_left_out, work, work_left_out } =
            &mut out;
        let own = [force, exit, peak, work].into_iter().zip(own);
        let other = [force_left_out, exit_left_out, peak_left_out, work_left_out].into_iter().zip(other);
        own.chain(other).for_each(|(most, here)| *most = most.max(here));
    }
    Ok(out)
}
