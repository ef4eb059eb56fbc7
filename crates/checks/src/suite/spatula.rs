//! Beams of varying section and curved rest shape, against a collocation that uses no finite elements: spatulae, and beams that a
//! table or a list of pieces gives.

use super::reference::Row;
use crate::check::{Check, Measure, Topic};
use crate::suite::accuracy::bounds;
use crate::suite::reference;
use peelkit::adhesion::LineLoad;
use peelkit::model::{Body, Grip, Hold, PeelModel, Piece, Profile, ProfileForm, ProfilePieces, Spatula, Transition};
use peelkit::study::{Accuracy, Peel, StationAt, StationQuantity, StopCriteria, peel};
use peelkit_scene::parse_profile;
use rayon::prelude::*;

pub(super) const TOPIC: Topic = Topic {
    name: "spatula",
    about: "peaks, snap-offs and the curve of spatulae and profiles, and the published 6.7 nN",
    checks,
};

const TABLE: &str = include_str!("../../verification/spatula.csv");
const PROFILES: &str = include_str!("../../verification/profile.csv");
/// The tables of those beams, by name.
const TABLES: [(&str, &str); 3] = [
    ("taper", include_str!("../../verification/profiles/taper.csv")),
    ("curved", include_str!("../../verification/profiles/curved.csv")),
    ("spatula", include_str!("../../verification/profiles/spatula.csv")),
];
const PIECE_BEAMS: &str = include_str!("../../verification/piece_beams.csv");
/// The lists of pieces of those, by name; of the last one, a spatula, the numbers stand with the spatulae.
const LISTS: [(&str, &str); 5] = [
    ("stepped", include_str!("../../verification/profiles/stepped.csv")),
    ("raised", include_str!("../../verification/profiles/raised.csv")),
    ("wedge", include_str!("../../verification/profiles/wedge.csv")),
    ("lobe", include_str!("../../verification/profiles/lobe.csv")),
    (NECK, include_str!("../../verification/profiles/neck.csv")),
];
const NECK: &str = "neck";
/// The spatula that bends where its neck is, so that three pieces are the same.
const NECK_CASE: &str = "neck_length=50";
const CURVE: &str = include_str!("../../verification/spatula_curve.csv");
const SOURCE: &str = "verification/spatula.py: collocation of the strong form";
/// The accuracy of the table's spatulae: the default.
const RELATIVE: f64 = 1e-6;
/// That of the curve and of the balance of work and energy, and what is wanted of them.
const FINE: f64 = 1e-9;
const BALANCE: f64 = 1e-8;
const BOUNDS: StopCriteria = StopCriteria::after_points(20_000);
/// Peak force of the paper's spatula, Fig. 7, nN.
const PUBLISHED: f64 = 6.7;
/// Steps of the search for the tip width.
const MOST_WIDTHS: usize = 12;

fn checks() -> Vec<Check> {
    let rows = reference::read(TABLE);
    let peeled = |row: &Row| peel(&model(row), &Accuracy::to(RELATIVE), &BOUNDS);
    let peels: Vec<Peel> = rows.par_iter().map(peeled).collect();
    let mut checks: Vec<Check> = rows
        .iter()
        .zip(&peels)
        .flat_map(|(row, peel)| numbers(row.text("case").unwrap_or_default(), row, peel))
        .collect();
    let mut beams: Vec<Row> = [PROFILES, PIECE_BEAMS].into_iter().flat_map(reference::read).collect();
    beams.extend(rows.iter().find(|row| row.text("case") == Some(NECK_CASE)).cloned());
    let held = |row: &Row| {
        let name = row.text("profile").unwrap_or(NECK);
        let peel = peel(&profile(name, rotation(row))?, &Accuracy::to(RELATIVE), &BOUNDS);
        let case = format!("profile {name}, rotation {}", row.text("grip_rotation").unwrap_or_default());
        Some(numbers(&case, row, &peel))
    };
    checks.extend(beams.par_iter().filter_map(held).collect::<Vec<_>>().into_iter().flatten());
    let Some(default) = rows.first().map(model) else { return checks };
    let fine = peel(&default, &Accuracy::to(FINE), &BOUNDS);
    checks.extend(curve(&fine));
    checks.push(balance(&fine));
    checks.extend(published(&rows, &default, &peels));
    checks
}

fn check(name: String, source: &str, computed: Result<f64, String>, expected: f64, how: (Measure, f64)) -> Check {
    Check::new(name, source, computed, expected, how.0, how.1)
}

/// The spatula of a row.
fn model(row: &Row) -> PeelModel {
    let number = |column: &str| row.number(column).unwrap_or(f64::NAN);
    let mut spatula = Spatula {
        pad_length: number("pad_length_nm"),
        neck_length: number("neck_length_nm"),
        shaft_length: number("shaft_length_nm"),
        bend_length: number("bend_length_nm"),
        tip_width: number("tip_width_nm"),
        neck_width: number("neck_width_nm"),
        shaft_diameter: number("shaft_diameter_nm"),
        pad_thickness: number("pad_thickness_nm"),
        shaft_angle: number("shaft_angle_deg").to_radians(),
        tip_rounding_length: number("tip_rounding_length_nm"),
        tip_rounding_width: number("tip_rounding_width_nm"),
        ..Spatula::default()
    };
    spatula.material.youngs_modulus = number("youngs_modulus_GPa");
    spatula.material.poissons_ratio = number("poissons_ratio");
    let mut model = spatula.model();
    model.adhesion.hamaker_constant = 1e18 * number("hamaker_constant_J");
    model.adhesion.equilibrium_distance = number("equilibrium_distance_nm");
    model.adhesion.far_face = row.text("far_face") == Some("true");
    if row.text("line_load") == Some("force-only") {
        model.adhesion.line_load = LineLoad::ForceOnly;
    }
    model.grip.rotation = rotation(row);
    model
}

/// What the grip of a row does with the rotation.
fn rotation(row: &Row) -> Hold {
    if row.text("grip_rotation") == Some("fixed") { Hold::Fixed } else { Hold::Free }
}

/// The beam of this name, with the default's material and adhesion.
fn profile(name: &str, rotation: Hold) -> Option<PeelModel> {
    let text = |texts: &[(&str, &'static str)]| texts.iter().find(|(known, _)| *known == name).map(|(_, text)| *text);
    let form = match text(&TABLES) {
        Some(table) => ProfileForm::Table(parse_profile(table).ok()?),
        None => ProfileForm::Pieces(pieces(text(&LISTS)?)?),
    };
    let spatula = Spatula::default().model();
    let body = Body::Profile(Profile { form, material: spatula.material() });
    Some(PeelModel::of(body, spatula.adhesion, Grip { rotation, ..Grip::FREE }))
}

/// The pieces of a list, a row a piece.
fn pieces(list: &str) -> Option<ProfilePieces> {
    let piece = |row: &Row| {
        let ends = |begins: &str, ends: &str| Some([row.number(begins)?, row.number(ends)?]);
        let course =
            |column: &str| if row.text(column) == Some("smooth") { Transition::Smooth } else { Transition::Linear };
        Some(Piece {
            length: row.number("length_nm")?,
            width: ends("width_nm", "width_end_nm")?,
            height: ends("height_nm", "height_end_nm")?,
            roundness: ends("roundness", "roundness_end")?,
            bend: row.number("bend_deg")?.to_radians(),
            course: course("course"),
            height_course: course("height_course"),
        })
    };
    ProfilePieces::new(reference::read(list).iter().map(piece).collect::<Option<_>>()?).ok()
}

/// Every number of a row: met to the accuracy asked for, and its bound no smaller than its error.
fn numbers(case: &str, row: &Row, peel: &Peel) -> Vec<Check> {
    let (first, largest, snap) = (peel.initiation_peak, peel.peak, peel.snap_off);
    // where a path falls from its beginning the largest force is no limit point and has no bound: the accuracy asked for is expected of it
    let computed = peel.largest_computed_force;
    let reported = [
        ("initiation_displacement_nm", first.map(|p| (p.displacement, p.displacement_error))),
        ("initiation_force_nN", first.map(|p| (p.force, p.force_error))),
        (
            "peak_displacement_nm",
            largest
                .map(|p| (p.displacement, p.displacement_error))
                .or(computed.map(|p| (p.displacement, RELATIVE * p.displacement))),
        ),
        (
            "peak_force_nN",
            largest.map(|p| (p.force, p.force_error)).or(computed.map(|p| (p.force, RELATIVE * p.force))),
        ),
        ("lp1_displacement_nm", snap.map(|p| (p.displacement, p.displacement_error))),
        ("lp1_force_nN", snap.map(|p| (p.force, p.force_error))),
    ];
    let mut over = 0.0f64;
    let mut checks = Vec::new();
    for (quantity, reported) in reported {
        let Some((text, exact)) = row.text(quantity).and_then(|text| Some((text, row.number(quantity)?))) else {
            continue;
        };
        if let Some((value, bound)) = reported {
            // a path that falls from its beginning has its peak at u = 0
            if exact == 0.0 {
                continue;
            }
            over = over.max(((value - exact).abs() - 0.5 * bounds::last_digit(text)).max(0.0) / bound);
        }
        let computed = reported.map(|(value, _)| value).ok_or_else(|| format!("not reported: {:?}", peel.end));
        checks.push(check(format!("{quantity}, {case}"), SOURCE, computed, exact, (Measure::Relative, RELATIVE)));
    }
    let effort = &peel.effort;
    let effort =
        format!("{} points, {} iterations, {} elements", effort.points, effort.newton_iterations, effort.elements);
    let name = format!("largest error over its bound, {case}; {effort}");
    checks.push(check(name, SOURCE, Ok(over), 1.0, (Measure::AtMost, 0.0)));
    checks
}

/// The force at given displacements on the way to the peak.
fn curve(peel: &Peel) -> Vec<Check> {
    let check = |row: &Row| {
        let (displacement, force) = (row.number("displacement_nm")?, row.number("force_nN")?);
        let name = format!("force at u = {displacement} nm, default, nN");
        let stations = peel.stations(StationAt { quantity: StationQuantity::Displacement, value: displacement });
        let first = stations.found.first().map(|at| at.force);
        let computed = first.ok_or_else(|| "the path does not go there".to_owned());
        Some(check(name, "verification/spatula_curve.py", computed, force, (Measure::Relative, BALANCE)))
    };
    reference::read(CURVE).iter().filter_map(check).collect()
}

/// ∫ P du by quadrature, which knows nothing of energies, over the change of stored and adhesion energy up to the snap-off.
fn balance(peel: &Peel) -> Check {
    let ratio = || {
        let (paid, change) = peel.work_and_energy(peel.snap_off?.after)?;
        Some(paid / change)
    };
    check(
        "∫ P du over the change of energy, rest to snap-off, default".into(),
        "a load with a potential conserves energy",
        ratio().ok_or_else(|| "no snap-off".to_owned()),
        1.0,
        (Measure::Relative, BALANCE),
    )
}

/// The published peak of a solid model, and the tip width at which the beam has it.
fn published(rows: &[Row], default: &PeelModel, peels: &[Peel]) -> Vec<Check> {
    let force = peels.first().and_then(|peel| peel.peak).map(|peak| peak.force).ok_or_else(|| "no peak".to_owned());
    let wanted = rows.iter().find(|row| row.text("peak_force_nN").is_some_and(|text| text.starts_with("6.70000000")));
    let width = wanted.and_then(|row| row.number("tip_width_nm")).unwrap_or(f64::NAN);
    vec![
        check(
            "peak force of the default spatula, nN, against a solid of 100 000 elements".into(),
            "the paper, Fig. 7, to the digits printed; the dimensions are a choice",
            force,
            PUBLISHED,
            (Measure::Absolute, 0.05),
        ),
        check(
            "tip width at which the peak force is 6.70 nN, nm".into(),
            SOURCE,
            tip_width(default, PUBLISHED),
            width,
            (Measure::Relative, BALANCE),
        ),
    ]
}

/// The tip width at which the peak force is `force`, by the secant method.
fn tip_width(default: &PeelModel, force: f64) -> Result<f64, String> {
    let miss = |width: f64| {
        let Body::Spatula(spatula) = &default.body else { return Err("not a spatula".to_owned()) };
        let body = Body::Spatula(Spatula { tip_width: width, ..spatula.clone() });
        let peel = peel(&PeelModel { body, ..default.clone() }, &Accuracy::to(FINE), &BOUNDS);
        peel.peak.map(|peak| peak.force - force).ok_or_else(|| format!("no peak at a width of {width} nm"))
    };
    let (mut before, mut here) = (200.0, 201.0);
    let (mut miss_before, mut miss_here) = (miss(before)?, miss(here)?);
    for _ in 0..MOST_WIDTHS {
        let next = here - miss_here * (here - before) / (miss_here - miss_before);
        (before, miss_before) = (here, miss_here);
        (here, miss_here) = (next, miss(next)?);
        if miss_here.abs() <= FINE * force {
            return Ok(here);
        }
    }
    Err(format!("the peak is {:.3e} nN off at a width of {here} nm", miss_here))
}
