//! A strip as a plane solid: first peaks against solid elements of another program, and what the reported bounds hold.

use super::reference;
use crate::check::{Check, Measure, Topic};
use peelkit::model::{PeelModel, SolidSettings, StripModel};
use peelkit::solid::{Grading, Plane, SolidElement, SolidGrip};
use peelkit::study::{SolidLimitPoint, SolidOptions, StopCriteria, peel_solid};
use rayon::prelude::*;

pub(super) const TOPIC: Topic = Topic {
    name: "solid",
    about: "a strip as a plane solid: first peaks by other elements, and whether the reported bounds hold",
    checks,
};

const TABLE: &str = include_str!("../../verification/solid.csv");
const SOURCE: &str = "verification/solid.py: elements of order 6, two meshes";
/// Of the strips of the table, nm: the first peak is made at the grip, and a longer one has the same.
const LENGTH: f64 = 40.0;
/// The force of the table has six digits, and two of its meshes agree to this.
const FORCE: f64 = 1e-5;
/// There the force is level: the meshes of the table differ by 3.2e-4 nm.
const DISPLACEMENT: f64 = 3.2e-4;
/// No further than behind the first peak, nm.
const FAR: f64 = 0.6;

/// As the table calls them.
const GRIPS: [(&str, SolidGrip); 2] = [("rigid", SolidGrip::Rigid), ("parabolic", SolidGrip::Parabolic)];
const PLANES: [(&str, Plane); 2] = [("stress", Plane::Stress), ("strain", Plane::Strain)];

fn checks() -> Vec<Check> {
    reference::read(TABLE).par_iter().flat_map_iter(of_row).collect()
}

/// The peak of a row: on a fine mesh as the table has it, and on the mesh that a scene takes by itself within its bound.
fn of_row(row: &reference::Row) -> Vec<Check> {
    let word = |column| row.text(column).unwrap_or("none");
    let known = |column| row.number(column).unwrap_or(f64::NAN);
    let (grip, plane) = (word("grip"), word("plane"));
    let asked = named(&GRIPS, grip).zip(named(&PLANES, plane));
    let of = |settings: SolidSettings, bounded| {
        let (grip, plane) = asked.ok_or_else(|| format!("{grip} is no grip, or {plane} no plane"))?;
        first_peak(&SolidSettings { grip, plane, ..settings }, bounded)
    };
    let fine = SolidSettings {
        element: SolidElement::Full { along: 5, through: 5 },
        along: 2.5,
        through: 4,
        grading: Grading::OF_GRIP,
        ..SolidSettings::default()
    };
    let (fine, usual) = (of(fine, 0), of(SolidSettings::default(), 1));
    let (force, displacement) = (known("peak_force_nN"), known("peak_displacement_nm"));
    let name = |what: &str| format!("{what}, solid, {grip} grip, plane {plane}");
    // the distance to the table over the bound
    let share = usual.and_then(|peak| {
        let errors = peak.errors.ok_or_else(|| "the peak has no bound".to_owned())?;
        Ok((peak.force - force).abs() / (errors.force + 0.5e-6))
    });
    vec![
        Check::new(
            name("first peak (nN)"),
            SOURCE,
            fine.as_ref().map(|peak| peak.force).map_err(String::clone),
            force,
            Measure::Relative,
            FORCE,
        ),
        Check::new(
            name("its displacement (nm)"),
            SOURCE,
            fine.map(|peak| peak.displacement),
            displacement,
            Measure::Absolute,
            DISPLACEMENT,
        ),
        Check::new(name("error of the first peak over its bound"), SOURCE, share, 1.0, Measure::AtMost, 0.0),
    ]
}

fn named<T: Copy>(all: &[(&str, T)], name: &str) -> Option<T> {
    all.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
}

/// Without a bound where none of the limit points is `bounded`.
fn first_peak(settings: &SolidSettings, bounded: usize) -> Result<SolidLimitPoint, String> {
    let mut model = PeelModel::from(StripModel::of_the_paper(LENGTH, 1.0));
    model.adhesion.far_face = false;
    let options = SolidOptions { stop: StopCriteria::up_to(FAR), bounded, ..SolidOptions::default() };
    let peel = peel_solid(&model, settings, &options).map_err(|error| error.to_string())?;
    peel.initiation_peak().cloned().ok_or_else(|| format!("no first peak: the path ended {:?}", peel.end))
}
