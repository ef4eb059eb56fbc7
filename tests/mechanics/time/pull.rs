//! A strip that is pulled at a rate: inertia, viscous material, and where the work goes.
//!
//!                                      U = V t
//!      ____________________            /|\
//!     |____________________|____________|    Kelvin and Voigt's material, or a standard linear solid
//!     ======================
//!
//! References: the path of equilibria and the test with its jumps; the balance of energy; the product of rate and retardation time, by which alone
//! inertialess pulls differ. Parameters: the paper's strip, L = 100 nm, 1300 kg/m³.
//! Expected: what stands beside each assertion. Why: a pull in time has to end in the statics, and a snap-off has to send its energy somewhere.

use crate::common::paper_strip;
use approx::assert_relative_eq;
use peelkit::beam::Viscosity;
use peelkit::model::{Friction, MovingMaterial, NotInTime, PeelModel, Spatula};
use peelkit::study::{
    Accuracy, InTimeFailureKind, PullInTime, PullRate, StopCriteria, TimeAccuracy, Until, observed, peel, pull_in_time,
};

const ELASTIC: MovingMaterial = MovingMaterial { density: 1300.0, viscosity: Viscosity::Elastic, opening: None };

fn strip() -> PeelModel {
    paper_strip(100.0, 1.0).into()
}

fn viscous(retardation_time: f64) -> MovingMaterial {
    MovingMaterial { density: 1300.0, viscosity: Viscosity::KelvinVoigt { retardation_time }, opening: None }
}

fn pulled(material: &MovingMaterial, pull: &PullRate) -> PullInTime {
    pull_in_time(&strip(), material, pull, &TimeAccuracy::default(), None).unwrap()
}

/// To the first peak, which is at 0.25 nm, and a little farther.
fn first_peak(rate: f64) -> PullRate {
    PullRate { until: Until::Held(0.0), ..PullRate::new(1.0, rate) }
}

/// Slowly the peak is that of the equilibria; what viscosity adds is proportional to the rate.
#[test]
fn slow_pulls_are_statics() {
    let statics = peel(&paper_strip(100.0, 1.0), &Accuracy::to(1e-6), &StopCriteria::default());
    let peak = statics.initiation_peak.unwrap().force;
    for material in [
        viscous(1e3),
        MovingMaterial {
            viscosity: Viscosity::StandardLinearSolid { relaxation_time: 1e3, stiffness_ratio: 2.0 },
            ..ELASTIC
        },
    ] {
        let [slow, slower] = [1e-7, 1e-8].map(|rate| pulled(&material, &first_peak(rate)).largest_force() / peak - 1.0);
        assert!(slower > 0.0 && slower < 2e-5, "{material:?}: {slower:.2e}");
        assert!((slow / slower - 10.0).abs() < 1.0, "{material:?}: {slow:.2e}, {slower:.2e}");
    }
    let elastic = pulled(&ELASTIC, &first_peak(1e-4)).largest_force();
    assert_relative_eq!(elastic, peak, max_relative = 2e-5);
}

/// Where inertia does not count the peak depends on rate times retardation time alone, in two materials and without mass.
#[test]
fn rate_times_retardation_time() {
    for product in [1e-1, 1.0, 1e1] {
        let peak = |time: f64| pulled(&viscous(time), &first_peak(product / time)).largest_force();
        assert_relative_eq!(peak(1e4), peak(1e3), max_relative = 1e-5);
        let massless = MovingMaterial { density: 0.0, ..viscous(1e3) };
        assert_relative_eq!(
            pulled(&massless, &first_peak(1e-3 * product)).largest_force(),
            peak(1e3),
            max_relative = 1e-5
        );
    }
}

/// The whole of a pull: work = stored + kinetic + adhesion + dissipated.
#[test]
fn the_balance_closes() {
    for (material, rate) in [(viscous(1e3), 1e-3), (viscous(1e3), 1e-1), (ELASTIC, 1e-1)] {
        let pull = pulled(&material, &PullRate::new(60.0, rate));
        assert!(pull.balance_error() < 1e-4, "{material:?} at {rate}: {:.2e}", pull.balance_error());
        assert!(pull.last().balance.work > 3.0);
    }
}

/// At the default tolerance of the steps the peak is good to 1e-4, at fifty times as much to 1e-3.
#[test]
fn steps_do_not_matter() {
    let peak = |tolerance: f64| {
        let accuracy = TimeAccuracy { tolerance, ..TimeAccuracy::default() };
        pull_in_time(&strip(), &viscous(1e3), &first_peak(1e-3), &accuracy, None).unwrap().largest_force()
    };
    let [coarse, fine, finer] = [1e-4, 2e-6, 2e-7].map(peak);
    assert_relative_eq!(fine, finer, max_relative = 1e-4);
    assert_relative_eq!(coarse, finer, max_relative = 1e-3);
}

/// Pulled slowly over the displacement at which the test with held displacement jumps, the strip snaps off in time, and dissipates what the jump
/// releases and what the grip works on the last 0.02 nm.
#[test]
fn a_snap_off_dissipates_what_the_jump_releases() {
    let test = observed(&paper_strip(100.0, 1.0), &Accuracy::to(1e-6), &StopCriteria::default()).unwrap();
    let jump = &test.jumps[0];
    let pull = PullRate {
        from: jump.machine - 0.2,
        to: jump.machine + 0.02,
        rate: 1e-3,
        accelerates: None,
        until: Until::Held(3e4),
    };
    let snapped = pulled(&viscous(100.0), &pull);
    let (first, last) = (snapped.points[0].balance, snapped.last().balance);
    assert!(snapped.contact_lost.is_some());
    assert!(last.kinetic < 1e-9 * jump.released, "it still moves: {last:?}");
    assert!(last.defect(&first).abs() < 1e-4 * jump.released);
    assert_relative_eq!(last.dissipated, jump.released, max_relative = 4e-3);
    assert_relative_eq!(snapped.last().force, jump.after.force, max_relative = 2e-2);
}

/// A spatula that is pulled slowly lets go at the peak of the equilibria, 6.67038 nN at 361.243 nm, and a little above that.
#[test]
fn a_spatula_lets_go() {
    let accuracy = TimeAccuracy { tolerance: 2e-5, ..TimeAccuracy::default() };
    let pull = PullRate::new(420.0, 1e-3);
    let slow = pull_in_time(&Spatula::default().model(), &viscous(10.0), &pull, &accuracy, None).unwrap();
    let peak = slow.peak.unwrap();
    assert_relative_eq!(peak.force, 6.67038424, max_relative = 4e-3);
    assert!(peak.force > 6.67038424, "{peak:?}");
    assert_relative_eq!(peak.displacement, 361.243, max_relative = 2e-3);
    assert!(slow.contact_lost.is_some() && slow.balance_error() < 1e-4, "{:.2e}", slow.balance_error());
}

/// What is not covered is refused, by name.
#[test]
fn what_it_cannot_do_is_said() {
    let why = |model: &PeelModel, material: MovingMaterial, pull: PullRate| {
        pull_in_time(model, &material, &pull, &TimeAccuracy::default(), None).unwrap_err().why
    };
    let rubbing = PeelModel { friction: Friction { strength: Some(0.05), ..Friction::NONE }, ..strip() };
    let pull = PullRate::new(1.0, 1e-2);
    assert_eq!(why(&rubbing, ELASTIC, pull), InTimeFailureKind::Model(NotInTime::NotCovered { what: "friction" }));
    let said = why(&strip(), MovingMaterial { density: -1.0, ..ELASTIC }, pull).to_string();
    assert_eq!(said, "the density in kg/m³ is -1; it must be zero or positive");
    let said = why(&strip(), ELASTIC, PullRate { rate: 0.0, ..pull }).to_string();
    assert_eq!(said, "the rate of the pull in nm/ns is 0; it must be positive");
}
