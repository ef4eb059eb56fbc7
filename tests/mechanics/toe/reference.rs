//! Patch, lamella and toe against closed forms and against bands of Green's functions.
//!
//! ```text
//!        P
//!        ↑
//!        o-----o-----o-----o---   band, EI = 1.0125e10 µN µm²; rows 25/3 µm apart, of 360 setae
//!        |     |     |     |      k = 0.45445/5.14267 N/m up to 5.14267 µm
//!     =============================
//! ```
//!
//! Reference: `verification/toe.csv`, which `toe.py` writes: w = a + b x + Σ F |x - x_j|³/12EI for bands, sums over setae for bundles and a dome,
//! roots of equations for tapes. Expected: closed forms to 1e-9; bands to 1e-7, as cubes of lengths lose half of the digits there.

use crate::toe::setup::{COLUMNS, PITCH, REACH, STIFFNESS, UM, UN, lamella, spring, table};
use approx::assert_relative_eq;
use peelkit::analytic as closed;
use peelkit::toe::{ArrayDrive, ArrayEnd, Backing, BandSection, Lamella, Patch, PatchStep, RootLaw, Scatter};
use std::f64::consts::{FRAC_PI_2, PI};

const LIFT: ArrayDrive = ArrayDrive::Force { angle: FRAC_PI_2 };
/// µN µm
const MOMENT: f64 = UN * UM;

fn close(case: &str, quantity: &str, value: f64, relative: f64) {
    let table = table();
    let key = (case.to_owned(), quantity.to_owned());
    let wanted = *table.get(&key).unwrap_or_else(|| panic!("no {key:?} in the table"));
    assert!((value / wanted - 1.0).abs() <= relative, "{key:?}: {value} and {wanted}, {:.1e}", value / wanted - 1.0);
}

#[test]
fn arrays_of_shafts() {
    let (length, radius, angle) = (110_000.0, 2100.0, 43f64.to_radians());
    let inertia = 0.25 * PI * f64::powi(radius, 4);
    for (quantity, friction) in [("", 0.0), (" along 0.29", 0.29), (" against 0.24", -0.24)] {
        let modulus = closed::array_modulus(1.5, inertia, 0.0144e-6, length, angle, friction);
        close("A1", &format!("modulus kPa{quantity}"), modulus * 1e6, 1e-11);
    }
    let RootLaw::Held { exit, .. } = RootLaw::shaft(length, radius, 1.5, angle, 454.45) else { panic!() };
    close("A3", "angle of the plane deg", exit.direction[1].atan2(exit.direction[0]).to_degrees(), 1e-11);
    close("A3", "distance um", exit.distance / UM, 1e-11);
}

fn flat(rows: usize, columns: usize, scatter: Scatter) -> Patch {
    let steps = vec![PatchStep { angle: FRAC_PI_2, distance: None }];
    Patch { rows, columns, pitch: PITCH, backing: Backing::Flat, law: spring(), scatter, press: 0.0, steps }
}

/// A patch is the bundle of its strengths, whatever their order in it.
#[test]
fn bundles() {
    let quantiles: Vec<f64> = (1..=100).map(|i| (f64::from(i) - 0.5) / 100.0).collect();
    let uniform: Vec<f64> = quantiles.iter().map(|q| 0.5 + q).collect();
    let weibull: Vec<f64> = quantiles.iter().map(|q| (-(1.0 - q).ln()).powf(0.2)).collect();
    close("P1", "bundle of 100 uniform", closed::bundle_strength(&uniform) / 100.0, 1e-12);
    close("P1", "bundle of 100 Weibull 5", closed::bundle_strength(&weibull) / 100.0, 1e-12);
    let patch = flat(10, 10, Scatter { strength: 0.5, ..Scatter::default() });
    let followed = patch.follow().unwrap();
    assert_eq!((followed.events.len(), followed.end), (100, ArrayEnd::Detached));
    close("P1", "bundle of 100 golden", followed.largest_load / (100.0 * STIFFNESS * REACH), 1e-11);
    assert_relative_eq!(followed.largest_load, followed.events[followed.peak].load, max_relative = 1e-14);
    let strengths: Vec<f64> = (0..100).map(|i| patch.scatter.of(i).strength).collect();
    assert_relative_eq!(
        followed.largest_load,
        closed::bundle_strength(&strengths) * STIFFNESS * REACH,
        max_relative = 1e-12
    );
}

#[test]
fn domes() {
    for (radius, count) in [(2000.0, 61), (20_000.0, 121)] {
        let dome = Patch {
            backing: Backing::Dome { radius: radius * UM },
            press: 40.0 * UM,
            ..flat(count, count, Scatter::default())
        };
        let peak = dome.follow().unwrap().largest_load;
        close("P4", &format!("sphere {radius:.0} um pull-off uN"), peak / UN, 1e-11);
        let work = 0.5 * STIFFNESS * REACH * REACH / (PITCH * PITCH);
        let many = closed::dome_pull_off(radius * UM, work);
        assert!(peak / many > 1.0 && peak / many < 1.03, "{}", peak / many);
    }
}

/// A thousand and more setae of the fixed sequence come as near to heights that are spread evenly as that sequence does.
#[test]
fn heights() {
    for height in [1.0, 3.0, 4.5] {
        let patch = flat(40, 40, Scatter { height: height * UM, ..Scatter::default() });
        let followed = patch.follow().unwrap();
        let area = 0.0144e-6 / 1600.0;
        close("L2", &format!("peak kPa heights {height:?}"), followed.largest_load * area * 1e6, 2e-3);
        // the table counts from where the mean height is at rest, with setae stretched by less than their reach already stored
        let start: f64 = (0..1600).map(|i| 0.5 * STIFFNESS * patch.scatter.of(i).height.powi(2)).sum();
        let work = followed.events.last().map(|last| last.work).unwrap();
        assert_relative_eq!(followed.released - start, work, max_relative = 1e-9);
        close("L2", &format!("work mJ/m2 heights {height:?}"), work * area * 1e3, 2e-3);
    }
}

#[test]
fn bunching() {
    for (name, radius, gap) in [("seta", 2.1, 25.0 / 3.0 - 4.2), ("branch", 0.1, 0.8)] {
        let longest = closed::bunching_length(radius * UM, gap * UM, 2.0, 0.3, 0.0307 / 2.0);
        close("P5", &format!("longest {name} um"), longest / UM, 1e-11);
    }
}

#[test]
fn lamella_lifted_at_its_end() {
    for (rows, losses) in [(60, &[1, 2, 3, 6, 11, 21, 41][..]), (400, &[1, 11, 51])] {
        let followed = lamella(rows).follow(LIFT, [0.0; 3], 60).unwrap();
        for &loss in losses {
            let event = &followed.events[loss - 1];
            assert_eq!((event.row, event.setae.len()), (loss - 1, COLUMNS));
            close("P2", &format!("{rows} rows loss {loss} uN"), event.load / UN, 1e-7);
            if rows == 60 {
                close("P2", &format!("{rows} rows loss {loss} lift um"), event.lift / UM, 1e-7);
            }
        }
        assert_eq!(followed.peak, 0);
    }
    let band = lamella(400);
    let (row, section) = (band.row_stiffness()[1][1], band.section);
    let lambda = closed::winkler_number(row, PITCH, section.bending);
    for loss in [1, 11, 51] {
        let overhang = f64::from(loss - 1) * PITCH;
        let smeared = closed::winkler_force(row * REACH, lambda, PITCH, overhang);
        close("P2", &format!("Winkler loss {loss} uN"), smeared / UN, 1e-11);
        // a band that hangs over by as much lets its first row go at the same force
        let hangs = Lamella { overhang, ..lamella(400 - loss as usize + 1) };
        let force = hangs.follow(LIFT, [0.0; 3], 1).unwrap().events[0].load;
        close("P2", &format!("400 rows loss {loss} uN"), force / UN, 1e-7);
    }
}

/// Pressed at its end, a short band lets its last row go first.
#[test]
fn lamella_turned_at_its_end() {
    for (drive, name, row) in [(ArrayDrive::Moment, "lifts", 0), (ArrayDrive::Press, "presses", 59)] {
        let first = lamella(60).follow(drive, [0.0; 3], 1).unwrap().events.remove(0);
        assert_eq!(first.row, row);
        close("P2", &format!("60 rows moment that {name} the end uN um"), first.load / MOMENT, 1e-7);
    }
    let lambda = closed::winkler_number(lamella(2).row_stiffness()[1][1], PITCH, lamella(2).section.bending);
    let strength = f64::from(COLUMNS as u32) * STIFFNESS * REACH;
    close("P2", "half-infinite moment uN um", closed::winkler_moment(strength, lambda, PITCH) / MOMENT, 1e-11);
}

/// Three times as stiff along the ground.
fn held(rows: usize) -> Lamella {
    let exit = peelkit::study::coarsening::ExitPlane { direction: [1.0, 0.0], distance: 100.0 };
    Lamella { law: RootLaw::Held { stiffness: [[3.0 * STIFFNESS, 0.0], [0.0, STIFFNESS]], exit }, ..lamella(rows) }
}

#[test]
fn shear_lag() {
    for rows in [60, 400, 3000] {
        let first = held(rows).follow(ArrayDrive::Force { angle: 0.0 }, [0.0; 3], 1).unwrap().events.remove(0);
        let strength = 3.0 * STIFFNESS * COLUMNS as f64 * 100.0;
        close("P3", &format!("{rows} rows over one"), first.load / strength, 1e-9);
        let row = held(rows).row_stiffness()[0][0];
        let closed = closed::shear_lag(rows, row, PITCH, held(rows).section.axial);
        close("P3", &format!("{rows} rows over one"), closed, 1e-9);
        close("P3", "alpha", closed::shear_lag_number(row, PITCH, held(rows).section.axial), 1e-9);
    }
}

/// Rows that are a thirtieth of their pitch apart and as much softer are a foundation, but for half a row at the end.
#[test]
fn softening() {
    let section = lamella(2).section;
    let foundation = STIFFNESS * COLUMNS as f64 / PITCH;
    for ratio in [1.5, 2.0, 4.0] {
        let peak = closed::softening_peak(foundation, section.bending, REACH, ratio * REACH).unwrap();
        close("L1", &format!("peak uN {ratio:?}"), peak.force / UN, 1e-9);
        close("L1", &format!("lift um {ratio:?}"), peak.lift / UM, 1e-6);
        close("L1", &format!("zone um {ratio:?}"), peak.zone / UM, 1e-6);
        let rows_apart = |pitch: f64| {
            let stiffness = foundation * pitch;
            let law = RootLaw::Softening { stiffness, first: REACH, last: ratio * REACH };
            let rows = (2400.0 * UM / pitch) as usize;
            let band = Lamella { rows, columns: 1, pitch, law, overhang: 0.5 * pitch, ..lamella(2) };
            let followed = band.follow(LIFT, [0.0; 3], 200).unwrap();
            followed.events[followed.peak].load
        };
        // half a pitch of band in front of the first row: what is left of the error is that of a sum in place of an integral
        let errors = [8.0, 4.0].map(|pitch| (rows_apart(pitch * UM) / peak.force - 1.0).abs());
        assert!(errors[1] < 1e-3 && errors[1] < errors[0], "{ratio}: {errors:?}");
    }
}

#[test]
fn tapes_with_tension() {
    let section = lamella(2).section;
    let energy = 0.0144e-6 * 0.5 * STIFFNESS * REACH * REACH * 3000.0 * UM;
    for tension in [0.0, 3000.0, 60_000.0] {
        for degrees in [10.0, 30.0, 90.0, 150.0f64] {
            let force = closed::pretensioned_force(energy, section.axial, tension * UN, degrees.to_radians()).unwrap();
            close("T1", &format!("tension {tension:.0} at {degrees:.0} deg uN"), force / UN, 1e-10);
        }
    }
    let alone = closed::self_peeling_tension(energy, section.axial);
    close("T1", "peels by itself uN", alone / UN, 1e-11);
    assert_eq!(closed::pretensioned_force(energy, section.axial, 1.001 * alone, 0.5), None);
    let along = closed::pretensioned_force(energy, section.axial, 3000.0 * UN, 0.0).unwrap();
    assert_relative_eq!(along, alone + 3000.0 * UN, max_relative = 1e-7);
}

#[test]
fn critical_angles() {
    for (sheared, lifted) in [(0, 0), (0, 15), (0, 29), (15, 15), (29, 29)] {
        let band = Lamella { pulled_at: Some(lifted), ..held(60) };
        let angle = band.critical_angle(30f64.to_radians(), sheared).unwrap();
        close("T2", &format!("sheared at row {sheared} lifted at row {lifted} deg"), angle.to_degrees(), 1e-7);
        if sheared == lifted {
            // the same as events: sheared first, then lifted, each row lets go on its cone
            let law = RootLaw::cone(STIFFNESS, 3.0 * STIFFNESS, 30f64.to_radians());
            let first = Lamella { law, ..band }.follow(LIFT, [1e6, 0.0, 0.0], 1).unwrap().events.remove(0);
            assert_relative_eq!((first.load / 1e6).atan(), angle, max_relative = 1e-8);
        }
    }
}

/// Lamellae as rows of a pad.
#[test]
fn a_pad_lifted_at_its_end() {
    let stiffness = 60.0 * COLUMNS as f64 * STIFFNESS;
    let limit = 30f64.to_radians().tan() * 2e6 * UN / 12.0;
    let pad = Lamella {
        rows: 12,
        columns: 1,
        pitch: 500.0 * UM,
        section: BandSection { bending: 2e11 * UN * UM * UM, axial: 1.35e8 * UN },
        law: RootLaw::Spring { stiffness, reach: limit / stiffness },
        ..lamella(12)
    };
    let followed = pad.follow(LIFT, [0.0; 3], 5).unwrap();
    for (number, event) in followed.events.iter().enumerate() {
        close("T3", &format!("end lifted loss {} uN", number + 1), event.load / UN, 1e-8);
    }
    for (drive, name) in [(ArrayDrive::Moment, "lifts"), (ArrayDrive::Press, "presses")] {
        let first = pad.follow(drive, [0.0; 3], 1).unwrap().events.remove(0);
        close("T3", &format!("moment that {name} the end uN um"), first.load / MOMENT, 1e-8);
    }
}

/// Each of a thousand losses, with strengths that scatter: which event is the largest, and its force.
#[test]
fn scattered_strengths() {
    let band = Lamella { scatter: Scatter { strength: 0.2, ..Scatter::default() }, ..lamella(278) };
    let followed = band.follow(LIFT, [0.0; 3], 1100).unwrap();
    close("Z", "event of the peak", (followed.peak + 1) as f64, 0.0);
    close("Z", "peak uN", followed.events[followed.peak].load / UN, 1e-8);
    assert!(followed.imbalance < 1e-6, "{:.1e}", followed.imbalance);
}
