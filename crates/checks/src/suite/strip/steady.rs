//! What holds exactly while the free end is at rest: the first integral, and the steady force that follows from it.

use super::case::DEFAULT;
use crate::check::{Check, Measure};
use crate::suite::reference::published;
use peelkit::adhesion::LineLoad;
use peelkit::analytic::steady_force;
use peelkit::model::StripModel;
use peelkit::study::{PathPoint, Peel, StopCriteria, peel};
use rayon::prelude::*;

/// Lengths, factors on EI and loads of strips with a plateau of many process zones.
const LONG: [(f64, f64, LineLoad, &str); 5] = [
    (1000.0, 1e-4, LineLoad::Full, "full"),
    (1000.0, 1e-2, LineLoad::Full, "full"),
    (1000.0, 1.0, LineLoad::Full, "full"),
    (3000.0, 10.0, LineLoad::Full, "full"),
    (1000.0, 1.0, LineLoad::AxisGap, "axis-gap"),
];

pub(super) fn checks() -> Vec<Check> {
    let steady = published("strip_steady_force_nN_per_nm");
    let paper = StripModel::of_the_paper(100.0, 1.0);
    let mut checks = vec![Check::new(
        "steady force of a long strip, nN",
        "P + P²/(2EA) = -bΨ(y_eq, 0); verification/published.py: mpmath",
        Ok(steady_force(paper.strip.width * paper.line_law().rest_energy(), paper.section().axial)),
        steady,
        Measure::Relative,
        1e-12,
    )];
    checks.extend(LONG.par_iter().flat_map(|case| long(case, steady)).collect::<Vec<_>>());
    checks
}

/// One long strip: its plateau, the first integral at its grip, and P sin θ(L).
fn long(&(length, factor, load, load_name): &(f64, f64, LineLoad, &str), steady: f64) -> Vec<Check> {
    let mut model = StripModel::of_the_paper(length, factor);
    model.adhesion.line_load = load;
    let peel = peel(&model, &DEFAULT, &StopCriteria::after_points(20_000));
    let name = |what: &str| format!("{what}, {load_name}, EI × {factor}, L = {length} nm");
    let w = -model.strip.width * model.line_law().rest_energy();
    let until = peel.plateau.map_or(0.0, |plateau| plateau.displacement);
    let along: Vec<&PathPoint> = peel.points.iter().skip(1).take_while(|p| p.displacement <= until).collect();
    let worst = |value: &dyn Fn(&PathPoint) -> f64| {
        let values = along.iter().map(|p| value(p).abs());
        if along.is_empty() { Err("no plateau".to_owned()) } else { Ok(values.fold(0.0, f64::max)) }
    };
    vec![
        Check::new(
            name("plateau, nN"),
            "root of P + P²/(2EA) = -bΨ(y_eq, 0); verification/published.py: mpmath",
            peel.plateau.map(|plateau| plateau.force).ok_or_else(|| "no plateau".to_owned()),
            steady,
            Measure::Relative,
            DEFAULT.relative,
        ),
        Check::new(
            name("P y'(L) - stored(L) - bΨ(L) over -bΨ(y_eq, 0) less 1, largest from rest to the plateau"),
            "first integral of a uniform beam (Noether), free end at rest",
            worst(&|p| at_the_grip(&peel, p) / w - 1.0),
            0.0,
            Measure::Absolute,
            DEFAULT.relative,
        ),
        Check::new(
            name("P sin θ(L) on the plateau, nN"),
            "w less P²/(2EA), w = -bΨ(y_eq, 0); verification/published.py: mpmath",
            along.last().map(|p| p.force * p.end_rotation.sin()).ok_or_else(|| "no plateau".to_owned()),
            steady,
            Measure::Relative,
            DEFAULT.relative,
        ),
    ]
}

/// The first integral at the grip, where M = H = 0: with N = P sin θ and Q = P cos θ
/// P y' - stored - bΨ = P sin θ + N²/(2EA) + Q²/(2GA_s) - bΨ(L).
fn at_the_grip(peel: &Peel, p: &PathPoint) -> f64 {
    let (section, law) = (peel.model.section(), peel.model.line_law());
    let (sin, cos) = p.end_rotation.sin_cos();
    let adhesion = peel.model.free_end().0 * law.response(law.rest_gap() + p.displacement, sin, cos).energy;
    let (axial, shear) = (p.force * sin, p.force * cos);
    axial + 0.5 * axial * axial / section.axial + 0.5 * shear * shear / section.shear - adhesion
}
