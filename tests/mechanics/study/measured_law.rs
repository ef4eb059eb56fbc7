//! A tape under a measured law: a table of traction over opening.
//!
//! ```text
//!   traction       __
//!      |         /    \          rows of an exponential law, 100 J/m² and 1 MPa,
//!      |       /        \__      up to 20 times the opening of the strength
//!      |_____/_____________ \____ opening
//! ```
//!
//! The tape is 5 mm by 50 µm by 20 mm, 2 GPa, pulled straight up. Expected: the steady force P + P²/(2 EA) = w b with the work of adhesion of the
//! curve through the rows, from energy alone; and with more rows the peak of the law
//! that they were taken from.

use peelkit::adhesion::{
    Attraction, Cohesive, CohesiveShape, LineResponse, Measured, OwnLaw, SectionLaw, TiltedSection, TractionTable,
};
use peelkit::beam::Material;
use peelkit::model::{Adhesion, Body, Grip, PeelModel, Strip};
use peelkit::study::{Accuracy, Peel, StopCriteria, peel};
use std::f64::consts::E;

const WORK: f64 = 100.0;
const STRENGTH: f64 = 1e-3;
const WIDTH: f64 = 2e7;

fn tape(attraction: Attraction) -> PeelModel {
    let strip =
        Strip { length: 5e6, height: 5e4, width: WIDTH, material: Material::of(2.0, 0.35), crack: None, layers: None };
    let known = attraction.takes_work_and_strength();
    let [work, strength] = [WORK, STRENGTH].map(|value| known.then_some(value));
    let law = Adhesion { attraction, work, strength, ..Adhesion::default() };
    // where the face lies closed is the same for all
    PeelModel::of(Body::Strip(strip), Adhesion { equilibrium_distance: 1e4, ..law }, Grip::FREE)
}

fn rows(count: usize) -> TractionTable {
    let scale = WORK / (E * STRENGTH);
    let share = |k: usize| k as f64 / (count - 1) as f64;
    let openings: Vec<f64> = (0..count).map(|k| 20.0 * share(k) * (0.3 + 0.7 * share(k))).collect();
    let traction = |k: usize| if k + 1 == count { 0.0 } else { STRENGTH * openings[k] * (1.0 - openings[k]).exp() };
    let tractions = (0..count).map(traction).collect();
    TractionTable::new(openings.iter().map(|opening| opening * scale).collect(), tractions).unwrap()
}

fn measured(count: usize) -> PeelModel {
    tape(Attraction::Cohesive(CohesiveShape::Measured(Measured::through(&rows(count)))))
}

fn peeled(model: &PeelModel) -> Peel {
    let stop = StopCriteria { displacement: Some(4e6), ..StopCriteria::default() };
    peel(model, &Accuracy::to(1e-4), &stop)
}

#[test]
fn its_steady_force_is_that_of_its_work() {
    let model = measured(40);
    let derived = model.derived();
    assert_eq!(derived.strength, Some(rows(40).strength()));
    let section = derived.section.unwrap();
    let plateau = peeled(&model).plateau.unwrap();
    let work = rows(40).work() * WIDTH;
    let closed = plateau.force + plateau.force.powi(2) / (2.0 * section.stiffness.axial);
    assert!((closed / work - 1.0).abs() < 1e-5, "{plateau:?}, {work}");
}

/// The exponential law of an open face, told from outside, which repels a pressed face in proportion, as a measured law does.
#[derive(Debug)]
struct Known(Cohesive);

impl SectionLaw for Known {
    fn name(&self) -> &'static str {
        "known"
    }

    fn response(&self, section: &TiltedSection) -> LineResponse<f64> {
        let Cohesive { closed, range, strength, .. } = self.0;
        section.face_load(|r| match (r - closed) / range {
            t if t > 0.0 => self.0.levels(r),
            t => [-strength * range * E * (1.0 - 0.5 * t * t), -strength * E * t, strength * E / range],
        })
    }

    fn cutoff_distance(&self) -> f64 {
        self.0.cutoff_distance()
    }

    fn rest_gap(&self, _height: f64) -> f64 {
        self.0.closed
    }
}

#[test]
fn its_peak_is_that_of_the_law_that_the_rows_are_of() {
    let peak = |model: &PeelModel| peeled(model).initiation_peak.unwrap().force;
    let half_space = measured(160).adhesion.half_space();
    let known = Known(Cohesive::calibrated(CohesiveShape::Exponential, STRENGTH, WORK, &half_space));
    let known = peak(&tape(Attraction::Own(OwnLaw::kept(known))));
    let off = |count: usize| (peak(&measured(count)) / known - 1.0).abs();
    let [coarse, fine] = [40, 160].map(off);
    assert!(coarse < 1e-3 && fine < 2e-5 && coarse > 16.0 * fine, "{coarse:e} {fine:e}");
}

/// A model is written with its rows and read again.
#[test]
fn it_is_written_with_its_rows() {
    let model = measured(40);
    let text = serde_json::to_string(&model.adhesion).unwrap();
    assert_eq!(serde_json::from_str::<Adhesion>(&text).unwrap(), model.adhesion);
    let wrong = text.replacen("\"openings\":[0.0", "\"openings\":[1.0", 1);
    assert_ne!(wrong, text);
    assert!(serde_json::from_str::<Adhesion>(&wrong).is_err());
}

#[test]
fn a_work_beside_it_is_refused() {
    let mut model = measured(40);
    model.adhesion.work = Some(WORK);
    assert_eq!(model.check().unwrap_err().key(), "adhesion.work");
}
