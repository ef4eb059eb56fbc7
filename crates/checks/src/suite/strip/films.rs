//! Films that yield, peeled steadily, against an infinite one.

use crate::check::{Check, Measure, Topic, missing};
use crate::suite::reference::{Row, read};
use peelkit::adhesion::{Attraction, CohesiveShape};
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Grip, PeelModel, Strip};
use peelkit::study::{Accuracy, StopCriteria, peel};
use rayon::prelude::*;

pub(in crate::suite) const TOPIC: Topic = Topic {
    name: "yielding",
    about: "films that yield, peeled steadily: force, and the work that yielding leaves in them",
    checks,
};

const TABLE: &str = include_str!("../../../verification/yielding.csv");
const SOURCE: &str = "verification/yielding.py: an infinite film, marched fibre by fibre";
/// Length of the films, and the displacement at which they have peeled steadily for long, nm.
const LENGTH: f64 = 300.0;
const UNTIL: f64 = 220.0;
/// Yield strengths and tangent moduli (GPa) of those that are peeled, straight up.
const PEELED: [[f64; 2]; 3] = [[0.1, 0.0], [0.06, 0.2], [0.04, 0.5]];
/// What is asked of the force; the work is a difference over one process zone, and is known to a few times that.
const ASKED: f64 = 1e-2;
const OF_WORK: f64 = 4e-2;

fn checks() -> Vec<Check> {
    read(TABLE).par_iter().filter_map(of_film).flatten_iter().collect()
}

fn of_film(row: &Row) -> Option<[Check; 2]> {
    let number = |column| row.number(column);
    let (strength, tangent) = (number("yield_strength_GPa")?, number("tangent_modulus_GPa")?);
    if !PEELED.contains(&[strength, tangent]) {
        return None;
    }
    let material = Material {
        yield_strength: Some(strength),
        tangent_modulus: Some(tangent).filter(|tangent| *tangent > 0.0),
        ..Material::of(2.0, 0.2)
    };
    let strip = Strip { length: LENGTH, height: 10.0, width: 1.0, material, crack: None, layers: None };
    let law = Adhesion { attraction: Attraction::Cohesive(CohesiveShape::Exponential), ..Adhesion::default() };
    let model = PeelModel::of(Body::Strip(strip), law, Grip::FREE);
    let until = StopCriteria { displacement: Some(UNTIL), ..StopCriteria::default() };
    let found = peel(&model, &Accuracy::to(ASKED), &until);
    let name = format!("σ₀ = {strength} GPa, Eₜ = {tangent} GPa");
    let force = found.plateau.map(|plateau| plateau.force).ok_or_else(|| missing(&found.end));
    let last = found.points.len().saturating_sub(1);
    let left = found.yielded_at(last).and_then(|yielded| yielded.work_per_area).ok_or_else(|| missing(&found.end));
    Some([
        Check::new(format!("steady force, nN, {name}"), SOURCE, force, number("force_nN")?, Measure::Relative, ASKED),
        Check::new(
            format!("left in the film, J/m², {name}"),
            SOURCE,
            left,
            number("plastic_work_nN")?,
            Measure::Relative,
            OF_WORK,
        ),
    ])
}
