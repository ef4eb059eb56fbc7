//! How the law of a seta is made of resolved paths: each sheet by least squares, and sheets divided until peaks and works are those of the paths.

use super::law::{ExitPlane, LawSheet, RootResponse, SetaLaw, SetaLawErrors, powers, term};
use super::path::{RootPath, RootPoint, SetaLawError};
use nalgebra::{DMatrix, DVector};

/// Least singular value over the largest one of columns of equal length: below that the paths do not determine the first sheet.
const RANK: f64 = 1e-9;
/// The same of a sheet behind it: what the paths determine less than so is left out of its potential, as they cross it in a narrow strip.
const STRIP: f64 = 1e-3;
/// Degree of the sheets behind the first one.
const BEHIND: usize = 2;
/// Fewest paths: one is left out, and two determine a plane.
const FEWEST_PATHS: usize = 3;
/// Most sheets that may be asked for.
const MOST_SHEETS: usize = 64;
/// Where the tips of a sheet are divided.
const PARTS: [f64; 3] = [0.25, 0.5, 0.75];
/// A further sheet has to leave less than that of the sum of the squares of the errors.
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
        Self { degree: 2, sheets: 16, tolerance: 0.02 }
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
    /// Of resolved paths. Every point of a sheet counts alike. Where more sheets would help little the law has fewer than may be, and its errors may
    /// be above the tolerance.
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
        let mut most = vec![tips];
        let mut law = Fit { paths: &all, degree }.law(&most)?;
        let mut left = Errors::of(&law, &all);
        while most.len() < sheets && left.largest() > tolerance {
            let further = divided(&most).into_iter().filter_map(|most| {
                let law = Fit { paths: &all, degree }.law(&most).ok()?;
                (law.sheets.len() == most.len()).then(|| (Errors::of(&law, &all), law, most))
            });
            let Some((errors, best, finer)) = further.min_by(|a, b| a.0.squares().total_cmp(&b.0.squares())) else {
                break;
            };
            if errors.squares() > GAIN * left.squares() {
                break;
            }
            (law, most, left) = (best, finer, errors);
        }
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

/// Paths that a law is made of.
struct Fit<'a> {
    paths: &'a [&'a RootPath],
    degree: usize,
}

impl Fit<'_> {
    /// With sheets of so many tips at most, without its errors. A sheet on which the paths have too few points is left out.
    fn law(&self, most: &[usize]) -> Result<SetaLaw, SetaLawError> {
        let undetermined = |least| SetaLawError::Undetermined { paths: self.paths.len(), degree: self.degree, least };
        let tips = most[0];
        let exit = self.exit(tips - 1).ok_or_else(|| undetermined(0.0))?;
        let (scale, mut largest_force) = (exit.distance, 0.0f64);
        self.with(tips - 1, tips)
            .for_each(|point| largest_force = largest_force.max(point.force[0].hypot(point.force[1])));
        let (coefficients, least) = self.potential([tips - 1, tips], self.degree, scale, RANK);
        let coefficients = coefficients.filter(|_| least >= RANK).ok_or_else(|| undetermined(least))?;
        let mut sheets = vec![LawSheet { tips, coefficients, exit }];
        for (sheet, &tips) in most.iter().enumerate().skip(1) {
            let fewest = most.get(sheet + 1).copied().unwrap_or(0);
            let potential = self.potential([fewest, tips], BEHIND, scale, STRIP).0;
            if let (Some(coefficients), Some(exit)) = (potential, self.exit(fewest)) {
                sheets.push(LawSheet { tips, coefficients, exit });
            }
        }
        Ok(SetaLaw { degree: self.degree, scale, sheets, largest_force, errors: SetaLawErrors::default() })
    }

    fn with(&self, fewest: usize, most: usize) -> impl Iterator<Item = &RootPoint> {
        self.paths.iter().flat_map(move |path| path.with(fewest, most))
    }

    /// Of the places at which no more than so many tips are left: the least sum of squares of u·d/c - 1. None where they do not determine it.
    fn exit(&self, tips: usize) -> Option<ExitPlane> {
        let places = DMatrix::from_fn(self.paths.len(), 2, |row, i| self.paths[row].loss(tips)[i]);
        let (over, least) = least_squares(places, &DVector::from_element(self.paths.len(), 1.0), RANK);
        let over = over.filter(|_| least >= RANK)?;
        let norm = over.norm();
        (norm > 0.0).then(|| ExitPlane { direction: [over[0] / norm, over[1] / norm], distance: 1.0 / norm })
    }

    /// The potential whose gradient is nearest to the forces where more than `fewest` and at most `most` tips adhere, at their mean energy, with the
    /// least singular value over the largest one. None where there are fewer points than coefficients.
    fn potential(&self, [fewest, most]: [usize; 2], degree: usize, scale: f64, rank: f64) -> (Option<Vec<f64>>, f64) {
        let points: Vec<&RootPoint> = self.with(fewest, most).collect();
        let powers = powers(degree);
        if points.len() < powers.len() {
            return (None, 0.0);
        }
        let force = points.iter().map(|point| point.force[0].hypot(point.force[1])).fold(f64::MIN_POSITIVE, f64::max);
        let terms: Vec<Vec<RootResponse>> =
            points.iter().map(|point| powers.iter().map(|&power| term(power, point.root, scale)).collect()).collect();
        // numbers without units: forces over the largest one, energies over that times s; the constant has no force
        let rows = terms.iter().flat_map(|terms| [0, 1].map(|i| (terms, i)));
        let rows = rows.flat_map(|(terms, i)| terms[1..].iter().map(move |term| term.force[i] * scale));
        let matrix = DMatrix::from_row_iterator(2 * points.len(), powers.len() - 1, rows);
        let wanted =
            DVector::from_iterator(2 * points.len(), points.iter().flat_map(|p| p.force.map(|own| own / force)));
        let (solved, least) = least_squares(matrix, &wanted, rank);
        let Some(solved) = solved else { return (None, least) };
        let own: Vec<f64> = solved.iter().map(|own| own * force * scale).collect();
        let rest = points.iter().zip(&terms).map(|(point, terms)| {
            point.energy - terms[1..].iter().zip(&own).map(|(term, own)| term.energy * own).sum::<f64>()
        });
        let mean = rest.sum::<f64>() / points.len() as f64;
        (Some([&[mean][..], &own].concat()), least)
    }
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
        let without = Fit { paths: &others, degree }.law(most)?;
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
