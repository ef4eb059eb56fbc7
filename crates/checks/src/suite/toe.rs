//! Arrays of setae: shafts, bundles, domes, bands, tapes and a pad, against closed forms and Green's functions.
//!
//! Units of the table: µm, µN, kPa. Inside: nm, nN, GPa.

use super::reference;
use crate::check::{Check, Measure, Topic};
use peelkit::analytic as closed;
use peelkit::study::coarsening::ExitPlane;
use peelkit::toe::{ArrayDrive, ArrayError, Backing, BandSection, Lamella, Patch, PatchStep, RootLaw, Scatter, Toe};
use rayon::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const TOPIC: Topic = Topic {
    name: "toe",
    about: "arrays of setae: bundles, domes, bands, tapes and a pad, by closed forms and Green's functions",
    checks,
};

const TABLE: &str = include_str!("../../verification/toe.csv");
const SOURCE: &str = "verification/toe.py: closed forms, Green's functions of bands";

/// In nm and nN.
const UM: f64 = 1000.0;
const UN: f64 = 1000.0;
const MOMENT: f64 = UN * UM;
/// GPa
const KPA: f64 = 1e-6;
/// Setae over an area, 1/nm².
const DENSITY: f64 = 0.0144e-6;
/// The law of a seta: stiffness in nN/nm, reach in nm.
const STIFFNESS: f64 = 0.45445 / 5.14267;
const REACH: f64 = 5142.67;
/// From row to row, nm; setae in a row; of a lamella.
const PITCH: f64 = 25_000.0 / 3.0;
const COLUMNS: usize = 360;
const ROWS: usize = 60;
/// Of a load up to which a seta holds, deg from the ground.
const CONE: f64 = 30.0;
const LIFT: ArrayDrive = ArrayDrive::Force { angle: FRAC_PI_2 };

/// Relative. Formulas that both evaluate; sums of thousands of terms; bands, where cubes of lengths lose half of the digits; a golden sequence in
/// place of a spread that is even; rows 4 µm apart in place of a foundation.
const FORMULA: f64 = 1e-9;
const SUM: f64 = 1e-11;
const BAND: f64 = 1e-7;
const SEQUENCE: f64 = 2e-3;
const APART: f64 = 1e-3;
/// Of a maximum that a search finds, where the function is level.
const SEARCHED: f64 = 1e-6;

/// A row of the table as the library computes it.
struct Computed {
    case: &'static str,
    quantity: String,
    value: Result<f64, String>,
    tolerance: f64,
    /// Where a row is computed in more ways than one
    how: &'static str,
}

fn computed(case: &'static str, quantity: impl Into<String>, value: f64, tolerance: f64) -> Computed {
    Computed { case, quantity: quantity.into(), value: Ok(value), tolerance, how: "" }
}

type Part = fn() -> Result<Vec<Computed>, ArrayError>;
const PARTS: [(&str, Part); 10] = [
    ("shafts", shafts),
    ("bundles and a dome", bundles),
    ("a dome of 20 mm", || dome(20_000.0, 121)),
    ("heights that scatter", heights),
    ("bands lifted at the end", bands),
    ("shear lag", shear_lag),
    ("softening", softening),
    ("tapes and critical angles", angles),
    ("a pad", pad),
    ("a thousand losses", scattered),
];

fn checks() -> Vec<Check> {
    let parts: Vec<(&str, Result<Vec<Computed>, ArrayError>)> =
        PARTS.par_iter().map(|(name, part)| (*name, part())).collect();
    let failed = parts.iter().filter_map(|(name, found)| Some(format!("{name}: {}", found.as_ref().err()?)));
    let missing = failed.collect::<Vec<_>>().join("; ");
    let found: Vec<&Computed> = parts.iter().filter_map(|(_, found)| found.as_ref().ok()).flatten().collect();
    // every row of the table, so that one which nothing computes fails
    let of_row = |row: &reference::Row| {
        let (case, quantity) = (row.text("case").unwrap_or("none"), row.text("quantity").unwrap_or("none"));
        let expected = row.number("value").unwrap_or(f64::NAN);
        let own: Vec<_> = found.iter().filter(|own| own.case == case && own.quantity == quantity).collect();
        if own.is_empty() {
            let failure = if missing.is_empty() { "nothing computes this row" } else { &missing };
            let name = format!("{case}: {quantity}");
            return vec![Check::new(name, SOURCE, Err(failure.to_owned()), expected, Measure::Relative, 0.0)];
        }
        let check = |own: &&&Computed| {
            let name = format!("{case}: {quantity}{}", own.how);
            Check::new(name, SOURCE, own.value.clone(), expected, Measure::Relative, own.tolerance)
        };
        own.iter().map(check).collect()
    };
    reference::read(TABLE).iter().flat_map(of_row).collect()
}

fn spring() -> RootLaw {
    RootLaw::Spring { stiffness: STIFFNESS, reach: REACH }
}

/// Three times as stiff along the ground, and never let go of.
fn held() -> RootLaw {
    let exit = ExitPlane { direction: [1.0, 0.0], distance: 100.0 };
    RootLaw::Held { stiffness: [[3.0 * STIFFNESS, 0.0], [0.0, STIFFNESS]], exit }
}

fn patch(rows: usize, columns: usize, scatter: Scatter) -> Patch {
    let steps = vec![PatchStep { angle: FRAC_PI_2, distance: None }];
    Patch { rows, columns, pitch: PITCH, backing: Backing::Flat, law: spring(), scatter, press: 0.0, steps }
}

/// 3 mm wide, 30 µm thick, of 1.5 GPa.
fn lamella(rows: usize, law: RootLaw) -> Lamella {
    let section = BandSection::rectangular(3000.0 * UM, 30.0 * UM, 1.5);
    let scatter = Scatter::default();
    Lamella { rows, columns: COLUMNS, pitch: PITCH, section, law, scatter, overhang: 0.0, pulled_at: None }
}

/// Load of the first loss.
fn first(band: &Lamella, drive: ArrayDrive) -> Result<f64, ArrayError> {
    let followed = band.follow(drive, [0.0; 3], 1)?;
    Ok(followed.events.first().map_or(f64::NAN, |event| event.load))
}

/// Inclined shafts of 110 µm, their exit plane in closed form, and how long fibres may be beside one another.
fn shafts() -> Result<Vec<Computed>, ArrayError> {
    let (length, radius, angle) = (110.0 * UM, 2.1 * UM, 43f64.to_radians());
    let inertia = 0.25 * PI * f64::powi(radius, 4);
    let modulus = |(quantity, friction): (&str, f64)| {
        let modulus = closed::array_modulus(1.5, inertia, DENSITY, length, angle, friction);
        computed("A1", format!("modulus kPa{quantity}"), modulus / KPA, SUM)
    };
    let mut out: Vec<Computed> =
        [("", 0.0), (" along 0.29", 0.29), (" against 0.24", -0.24)].into_iter().map(modulus).collect();
    if let Some(sheet) = RootLaw::shaft(length, radius, 1.5, angle, 0.45445 * UN).sheet(0, 1.0) {
        let [along, off] = sheet.exit.direction;
        out.push(computed("A3", "angle of the plane deg", off.atan2(along).to_degrees(), SUM));
        out.push(computed("A3", "distance um", sheet.exit.distance / UM, SUM));
    }
    for (name, radius, gap) in [("seta", 2.1, 25.0 / 3.0 - 4.2), ("branch", 0.1, 0.8)] {
        let longest = closed::bunching_length(radius * UM, gap * UM, 2.0, 0.3, 0.5 * 0.0307);
        out.push(computed("P5", format!("longest {name} um"), longest / UM, SUM));
    }
    Ok(out)
}

fn bundles() -> Result<Vec<Computed>, ArrayError> {
    let quantiles = || (1..=100).map(|i| (f64::from(i) - 0.5) / 100.0);
    let uniform: Vec<f64> = quantiles().map(|q| 0.5 + q).collect();
    let weibull: Vec<f64> = quantiles().map(|q| (-(1.0 - q).ln()).powf(0.2)).collect();
    let golden = patch(10, 10, Scatter { strength: 0.5, ..Scatter::default() }).follow()?.largest_load;
    let mut out = dome(2000.0, 61)?;
    out.extend([
        computed("P1", "bundle of 100 uniform", closed::bundle_strength(&uniform) / 100.0, SUM),
        computed("P1", "bundle of 100 Weibull 5", closed::bundle_strength(&weibull) / 100.0, SUM),
        computed("P1", "bundle of 100 golden", golden / (100.0 * STIFFNESS * REACH), SUM),
    ]);
    Ok(out)
}

/// Of a radius in µm, on a square of so many setae each way.
fn dome(radius: f64, count: usize) -> Result<Vec<Computed>, ArrayError> {
    let backing = Backing::Dome { radius: radius * UM };
    let peak = Patch { backing, press: 40.0 * UM, ..patch(count, count, Scatter::default()) }.follow()?.largest_load;
    Ok(vec![computed("P4", format!("sphere {radius:.0} um pull-off uN"), peak / UN, SUM)])
}

fn heights() -> Result<Vec<Computed>, ArrayError> {
    let mut out = Vec::new();
    for height in [1.0, 3.0, 4.5] {
        let followed = patch(40, 40, Scatter { height: height * UM, ..Scatter::default() }).follow()?;
        let area = 1600.0 / DENSITY;
        let work = followed.events.last().map_or(f64::NAN, |last| last.work);
        out.push(computed("L2", format!("peak kPa heights {height:?}"), followed.largest_load / area / KPA, SEQUENCE));
        // 1 nN/nm = 1e3 mJ/m²
        out.push(computed("L2", format!("work mJ/m2 heights {height:?}"), work / area * 1e3, SEQUENCE));
    }
    Ok(out)
}

/// Losses of bands lifted at the end or turned there, and of half-infinite ones on a foundation.
fn bands() -> Result<Vec<Computed>, ArrayError> {
    let mut out = Vec::new();
    for (rows, losses) in [(ROWS, &[1, 2, 3, 6, 11, 21, 41][..]), (400, &[1, 11, 51])] {
        let events = lamella(rows, spring()).follow(LIFT, [0.0; 3], 60)?.events;
        for &loss in losses {
            let Some(event) = events.get(loss - 1) else { continue };
            out.push(computed("P2", format!("{rows} rows loss {loss} uN"), event.load / UN, BAND));
            if rows == ROWS {
                out.push(computed("P2", format!("{rows} rows loss {loss} lift um"), event.lift / UM, BAND));
            }
        }
    }
    for (drive, name) in [(ArrayDrive::Moment, "lifts"), (ArrayDrive::Press, "presses")] {
        let moment = first(&lamella(ROWS, spring()), drive)?;
        out.push(computed("P2", format!("60 rows moment that {name} the end uN um"), moment / MOMENT, BAND));
    }
    let band = lamella(2, spring());
    let row = band.row_stiffness()[1][1];
    let (strength, lambda) = (row * REACH, closed::winkler_number(row, PITCH, band.section.bending));
    for loss in [1, 11, 51] {
        let force = closed::winkler_force(strength, lambda, PITCH, f64::from(loss - 1) * PITCH);
        out.push(computed("P2", format!("Winkler loss {loss} uN"), force / UN, SUM));
    }
    let moment = closed::winkler_moment(strength, lambda, PITCH);
    out.push(computed("P2", "half-infinite moment uN um", moment / MOMENT, SUM));
    Ok(out)
}

fn shear_lag() -> Result<Vec<Computed>, ArrayError> {
    let band = lamella(2, held());
    let (row, axial) = (band.row_stiffness()[0][0], band.section.axial);
    let mut out = vec![computed("P3", "alpha", closed::shear_lag_number(row, PITCH, axial), FORMULA)];
    for rows in [60, 400, 3000] {
        let load = first(&lamella(rows, held()), ArrayDrive::Force { angle: 0.0 })? / (100.0 * row);
        let quantity = format!("{rows} rows over one");
        out.push(Computed { how: ", by events", ..computed("P3", quantity.clone(), load, FORMULA) });
        let form = closed::shear_lag(rows, row, PITCH, axial);
        out.push(Computed { how: ", closed form", ..computed("P3", quantity, form, FORMULA) });
    }
    Ok(out)
}

/// A foundation that softens, in closed form and as rows that are close together.
fn softening() -> Result<Vec<Computed>, ArrayError> {
    let section = lamella(2, spring()).section;
    let foundation = STIFFNESS * COLUMNS as f64 / PITCH;
    let mut out = Vec::new();
    for ratio in [1.5, 2.0, 4.0] {
        let Some(peak) = closed::softening_peak(foundation, section.bending, REACH, ratio * REACH) else { continue };
        let quantity = format!("peak uN {ratio:?}");
        let form = computed("L1", quantity.clone(), peak.force / UN, FORMULA);
        out.push(Computed { how: ", closed form", ..form });
        out.push(computed("L1", format!("lift um {ratio:?}"), peak.lift / UM, SEARCHED));
        out.push(computed("L1", format!("zone um {ratio:?}"), peak.zone / UM, SEARCHED));
        let pitch = 4.0 * UM;
        let law = RootLaw::Softening { stiffness: foundation * pitch, first: REACH, last: ratio * REACH };
        let band = Lamella { columns: 1, pitch, overhang: 0.5 * pitch, ..lamella(600, law) };
        let followed = band.follow(LIFT, [0.0; 3], 200)?;
        let load = followed.events.get(followed.peak).map_or(f64::NAN, |event| event.load);
        out.push(Computed { how: ", rows 4 µm apart", ..computed("L1", quantity, load / UN, APART) });
    }
    Ok(out)
}

/// Tapes with a tension, and up to which angle each row of a band holds.
fn angles() -> Result<Vec<Computed>, ArrayError> {
    let axial = lamella(2, spring()).section.axial;
    let energy = DENSITY * 0.5 * STIFFNESS * REACH * REACH * 3000.0 * UM;
    let alone = closed::self_peeling_tension(energy, axial);
    let mut out = vec![computed("T1", "peels by itself uN", alone / UN, SUM)];
    for tension in [0.0, 3000.0, 60_000.0] {
        for degrees in [10.0, 30.0, 90.0, 150.0f64] {
            let force = closed::pretensioned_force(energy, axial, tension * UN, degrees.to_radians());
            let quantity = format!("tension {tension:.0} at {degrees:.0} deg uN");
            out.push(computed("T1", quantity, force.unwrap_or(f64::NAN) / UN, FORMULA));
        }
    }
    for (sheared, lifted) in [(0, 0), (0, 15), (0, 29), (15, 15), (29, 29)] {
        let band = Lamella { pulled_at: Some(lifted), ..lamella(ROWS, held()) };
        let angle = band.critical_angle(CONE.to_radians(), sheared)?.to_degrees();
        let quantity = format!("sheared at row {sheared} lifted at row {lifted} deg");
        let way = if sheared == lifted { ", by shares" } else { "" };
        out.push(Computed { how: way, ..computed("T2", quantity.clone(), angle, BAND) });
        if sheared == lifted {
            // sheared first, then lifted: each row lets go on its cone
            let law = RootLaw::cone(STIFFNESS, 3.0 * STIFFNESS, CONE.to_radians());
            let followed = Lamella { law, ..band }.follow(LIFT, [1e6, 0.0, 0.0], 1)?;
            let load = followed.events.first().map_or(f64::NAN, |event| event.load);
            let angle = (load / 1e6).atan().to_degrees();
            out.push(Computed { how: ", by events", ..computed("T2", quantity, angle, BAND) });
        }
    }
    Ok(out)
}

/// Twelve rigid lamellae, whose setae let go together at the limit of a lamella in shear.
fn pad() -> Result<Vec<Computed>, ArrayError> {
    let limit = CONE.to_radians().tan() * 2e6 * UN / 12.0;
    let whole = (ROWS * COLUMNS) as f64 * STIFFNESS;
    let law = RootLaw::Spring { stiffness: STIFFNESS, reach: limit / whole };
    let pad = BandSection { bending: 2e11 * UN * UM * UM, axial: 1.35e8 * UN };
    let toe = Toe { lamellae: 12, pitch: 500.0 * UM, pad, lamella: lamella(ROWS, law), joined_at: None };
    let mut out = Vec::new();
    for (number, event) in toe.follow(LIFT, [0.0; 3], 5)?.events.iter().enumerate() {
        out.push(computed("T3", format!("end lifted loss {} uN", number + 1), event.load / UN, BAND));
    }
    for (drive, name) in [(ArrayDrive::Moment, "lifts"), (ArrayDrive::Press, "presses")] {
        let load = toe.follow(drive, [0.0; 3], 1)?.events.first().map_or(f64::NAN, |event| event.load);
        out.push(computed("T3", format!("moment that {name} the end uN um"), load / MOMENT, BAND));
    }
    Ok(out)
}

/// A band of 278 rows with scattered strengths: which loss is the largest, and its force.
fn scattered() -> Result<Vec<Computed>, ArrayError> {
    let scatter = Scatter { strength: 0.2, ..Scatter::default() };
    let followed = Lamella { scatter, ..lamella(278, spring()) }.follow(LIFT, [0.0; 3], 1100)?;
    let peak = followed.events.get(followed.peak).map_or(f64::NAN, |event| event.load);
    Ok(vec![
        computed("Z", "event of the peak", (followed.peak + 1) as f64, 0.0),
        computed("Z", "peak uN", peak / UN, BAND),
    ])
}
