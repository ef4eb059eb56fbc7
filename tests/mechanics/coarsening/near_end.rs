//! Tips that are solved as spatulae where they are near to snapping off.
//!
//! Reference: the spatula solved at the same place; the table farther away; differences of the energy; the same seta by the table alone.
//! Parameters: the default spatula with a pad that slides; θ within ±0.1 rad, to 1e-2; resolved within 20 nm. A seta of two tips.
//! Expected: near the end forces and stiffness are those of the spatula, far away those of the table to the last bit, and everywhere the derivatives
//! of one energy; the branch ends where it does by the table; the seta is pulled off by the table first, then once more, all of its tips are resolved,
//! and its peak changes by less than the bound of the table's error.

use super::{at, spatula};
use peelkit::model::{Seta, SetaModel, Sideways, TipBranch, TipLaw};
use peelkit::study::coarsening::{
    AfterRound, Coarsening, CoarseningError, CoarseningOptions, GrowingTable, NearEnd, PadEnd, TableLaw, TipRange,
    TipSheet, TipTable, coarsen, pull_off_by_table,
};
use peelkit::study::{SetaEnd, SetaLoading, SetaOptions, StopCriteria};
use std::sync::Arc;

const WITHIN: f64 = 20.0;
const UPRIGHT: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

fn options() -> CoarseningOptions {
    let range = TipRange { press: 30.0, rotation: [-0.1, 0.1], ..TipRange::SLIDING };
    CoarseningOptions { range, tolerance: 1e-2, ..CoarseningOptions::of(PadEnd::Sliding) }
}

fn turned(angle: f64) -> [f64; 4] {
    [(0.5 * angle).cos(), 0.0, 0.0, (0.5 * angle).sin()]
}

fn laws(table: &Arc<TipTable>) -> [Arc<dyn TipLaw>; 2] {
    let near_end = NearEnd::new(&spatula(), table, WITHIN).unwrap();
    let by_table = TableLaw::new(table.clone(), Sideways::Free);
    [by_table.clone().resolved(Arc::new(near_end)), by_table].map(|law| law.oriented(UPRIGHT).unwrap())
}

#[test]
fn near_the_end_of_its_branch_a_tip_is_the_spatula() {
    let table = Arc::new(coarsen(&spatula(), &options()).unwrap());
    let [resolved, by_table] = laws(&table);
    let angle = 0.023;
    let end = table.attached.ends(at(0.0, 0.0, angle))[1];
    let ask =
        |law: &Arc<dyn TipLaw>, u: f64, angle: f64| law.response(TipBranch::Attached, [0.0, u, 0.0], turned(angle));
    let fine = Coarsening::new(&spatula(), &CoarseningOptions { tolerance: 1e-3, ..options() }).unwrap();
    for depth in [19.0, 7.0, 1.0, 0.1] {
        let found = ask(&resolved, end - depth, angle);
        let solved = fine.resolve(TipSheet::Attached, at(end - depth, 0.0, angle)).unwrap();
        // two meshes of the spatula; next to the end the force is steep
        let off = (found.gradient[1] - solved.force[0]).abs();
        assert!(off < 2e-5, "{depth}: {} {}", found.gradient[1], solved.force[0]);
        assert!((found.gradient[5] - solved.force[2]).abs() < 5e-3, "{depth}: {found:?} {solved:?}");
        let (one, other) = (found.hessian[1][1], solved.stiffness[0][0]);
        assert!((one - other).abs() < 1e-3 * other.abs().max(0.01), "{depth}: {one} {other}");
        let known = ask(&by_table, end - depth, angle);
        assert!(known != found && (known.gradient[1] - found.gradient[1]).abs() < 0.1, "{depth}: {known:?}");
    }
    for u in [end - 26.0, end - 200.0, -20.0, end + 0.1] {
        let [one, other] = [&resolved, &by_table].map(|law| ask(law, u, angle));
        if u < end {
            assert_eq!(one, other);
        }
        assert_eq!(
            resolved.branch(TipBranch::Attached, [0.0, u, 0.0], turned(angle)),
            by_table.branch(TipBranch::Attached, [0.0, u, 0.0], turned(angle))
        );
    }
}

#[test]
fn its_forces_are_the_derivatives_of_one_energy() {
    let table = Arc::new(coarsen(&spatula(), &options()).unwrap());
    let [resolved, _] = laws(&table);
    let angle = 0.023;
    let end = table.attached.ends(at(0.0, 0.0, angle))[1];
    let ask = |u: f64, angle: f64| resolved.response(TipBranch::Attached, [0.0, u, 0.0], turned(angle));
    // spatula; both; table; not where the cells of 2 nm meet, from whose middles spatulae are solved on their own meshes
    for depth in [15.3, 21.3, 23.1, 24.5, 30.0] {
        let (u, step) = (end - depth, 1e-3);
        let here = ask(u, angle);
        let slope = |[behind, ahead]: [f64; 2], step: f64| (ahead - behind) / (2.0 * step);
        let force = slope([-step, step].map(|s| ask(u + s, angle).energy), step);
        assert!((force - here.gradient[1]).abs() < 1e-5, "{depth}: {force} {}", here.gradient[1]);
        let stiffness = slope([-step, step].map(|s| ask(u + s, angle).gradient[1]), step);
        assert!((stiffness - here.hessian[1][1]).abs() < 1e-5, "{depth}: {stiffness} {}", here.hessian[1][1]);
        let turn = 1e-5;
        let moment = slope([-turn, turn].map(|s| ask(u, angle + s).energy), turn);
        assert!((moment - here.gradient[5]).abs() < 1e-2, "{depth}: {moment} {}", here.gradient[5]);
        let coupling = slope([-turn, turn].map(|s| ask(u, angle + s).gradient[1]), turn);
        assert!((coupling - here.hessian[1][5]).abs() < 5e-3, "{depth}: {coupling} {}", here.hessian[1][5]);
    }
}

#[test]
fn a_seta_is_pulled_off_once_more_with_its_detaching_tips_resolved() {
    let table = Arc::new(coarsen(&spatula(), &options()).unwrap());
    let bound = 2.0 * table.attached_errors.force[0];
    let growing = GrowingTable::of(&spatula(), table);
    let seta = Seta { forks: 1, ..Seta::default() };
    let of = |law: Arc<dyn TipLaw>| SetaModel::new(seta.clone(), law);
    let loading = SetaLoading::pull([0.0, 1.0, 0.0], 60_000.0);
    let options = SetaOptions { balance: 1e-6, ..SetaOptions::default() };
    let mut growing = growing.resolved(WITHIN).unwrap();
    let stop = StopCriteria::default();
    let (pulled, after) = pull_off_by_table(&mut growing, (&of, Sideways::Free), (&loading, &options), &stop).unwrap();
    assert_eq!((after, &pulled.end), (AfterRound::Done, &SetaEnd::Completed));
    let [.., by_table, last] = growing.rounds() else { panic!("{:?}", growing.rounds()) };
    assert_eq!((by_table.within, last.within), (None, Some(WITHIN)));
    assert!(by_table.visited.resolved.tips.is_empty() && by_table.visited.outside.is_empty());
    let resolved = &last.visited.resolved;
    assert!(resolved.tips.len() == 2 && resolved.unsolved.is_empty(), "{resolved:?}");
    assert!(resolved.force > 0.0 && resolved.force < bound, "{resolved:?} {bound}");
    let change = growing.changed_by_resolved().unwrap();
    assert!(change != 0.0 && change.abs() < bound && pulled.imbalance() < 1e-6, "{change} {bound}");
    // that of the table, which may have grown before
    assert!(growing.changed().unwrap().abs() < bound);
}

#[test]
fn a_pad_that_is_held_is_refused() {
    let range = TipRange { press: 1.0, lateral: [-1.0, 1.0], rotation: [-0.01, 0.01] };
    let options = CoarseningOptions { range, tolerance: 0.1, ..CoarseningOptions::of(PadEnd::Held) };
    let table = coarsen(&spatula(), &options).unwrap();
    let refused = NearEnd::new(&spatula(), &table, WITHIN);
    assert!(matches!(refused, Err(CoarseningError::Refused { .. })), "{:?}", refused.err());
}
