//! A seta whose spatulae are beams that adhere.
//!
//! ```text
//!              ● root, moved up, never turned
//!             /
//!            ●
//!           / \
//!       ===/===/    two spatulae, each a branch of 32 elements
//!      ----------
//! ```
//!
//! Reference: the same seta whose tips follow the table of their spatula, which knows nothing of how a pad rolls, slides or turns about the
//! normal; energies, because work has to be stored, in adhesion or released. Parameters: the last two of the default seta's 256 tips, with the
//! shaft and the branch that carry them. Expected: the same tip lets go first, forces within 3 %, and work that balances to 1e-4; the iterations are
//! pinned.

use peelkit::model::{
    Adhesion, Body, Grip, PeelModel, Seta, SetaError, SetaMesh, SetaModel, SetaOfBeams, Sideways, Spatula,
};
use peelkit::solve::{Pace, PathOptions};
use peelkit::study::coarsening::{CoarseningOptions, GrowingTable, PadEnd, TipRange, coarsen, pull_off_by_table};
use peelkit::study::{EventCause, SetaEnd, SetaLoading, SetaOptions, StopCriteria, pull_off_of_beams};
use std::sync::Arc;

fn seta() -> Seta {
    let brush_height = 28_000.0 * 0.6f64.powi(7);
    Seta {
        forks: 1,
        shaft_diameter: 4000.0 * 0.625f64.powi(7),
        brush_height,
        shaft_length: 2.5 * brush_height,
        height_scatter: 20.0,
        ..Seta::default()
    }
}

fn of_beams() -> SetaOfBeams {
    let spatula = Spatula::default().model().branch().unwrap();
    SetaOfBeams { seta: seta(), mesh: SetaMesh { order: 5, elements: vec![1; 2] }, spatula, elements: 32 }
}

fn options() -> PathOptions {
    PathOptions { pace: Pace::Wary, first_displacement: 0.1, ..PathOptions::default() }
}

#[test]
fn two_spatulae_let_go_as_tips_by_their_table_do() {
    let loading = SetaLoading::pull([0.0, 1.0, 0.0], 1e5);
    let found = pull_off_of_beams(&of_beams(), &loading, &options(), &StopCriteria::default()).unwrap();
    let model = PeelModel::of(Body::Spatula(Spatula::default()), Adhesion::default(), Grip::FREE);
    let range = TipRange { press: 5.0, rotation: [-0.4, 0.65], ..TipRange::SLIDING };
    let making = CoarseningOptions { range, tolerance: 1e-2, ..CoarseningOptions::of(PadEnd::Sliding) };
    let law = |law: Arc<dyn peelkit::model::TipLaw>| SetaModel::new(seta(), law);
    let by = SetaOptions { balance: 1e-6, ..SetaOptions::default() };
    let mut table = GrowingTable::of(&model, Arc::new(coarsen(&model, &making).unwrap()));
    let stop = StopCriteria::default();
    let (by_table, _) = pull_off_by_table(&mut table, (&law, Sideways::Free), (&loading, &by), &stop).unwrap();
    for (of, name) in [(&found, "beams"), (&by_table, "table")] {
        println!(
            "{name}: end {:?}, {} points, {:?}, imbalance {:.1e}",
            of.end,
            of.points.len(),
            of.effort,
            of.imbalance()
        );
        for event in &of.events {
            let tips: Vec<_> = event.tips.iter().map(|tip| tip.tip).collect();
            println!(
                "  u {:.3} P {:.4} to {:.4} released {:.2} {tips:?}",
                event.before.displacement, event.before.force_along, event.after.force_along, event.released
            );
        }
    }
    assert_eq!(found.end, SetaEnd::Completed);
    assert!(found.imbalance() < 1e-4, "{}", found.imbalance());
    let lose = |of: &peelkit::study::SetaPullOff| -> Vec<(usize, f64)> {
        let events = of.events.iter().filter(|event| event.cause == EventCause::Tips);
        events.flat_map(|event| event.tips.iter().map(|tip| (tip.tip, event.before.force_along))).collect()
    };
    let (own, others) = (lose(&found), lose(&by_table));
    assert_eq!(own.len(), 2);
    for ((tip, force), (other, wanted)) in own.iter().zip(&others) {
        assert!(tip == other && (force / wanted - 1.0).abs() < 0.03, "{own:?} {others:?}");
    }
    assert!(found.effort.newton_iterations < 4500 && found.points.len() < 260, "{:?}", found.effort);
}

#[test]
fn a_seta_of_beams_starts_adhering() {
    let loading = SetaLoading::pressed_and_dragged(300.0, 10.0, 0.0, 1e5);
    let error = pull_off_of_beams(&of_beams(), &loading, &options(), &StopCriteria::default()).unwrap_err();
    assert_eq!(error, SetaError::NotAdhering { height: 300.0 });
}

#[test]
fn what_stops_it_keeps_what_it_has_reached() {
    let loading = SetaLoading::pull([0.0, 1.0, 0.0], 1e5);
    let found = pull_off_of_beams(&of_beams(), &loading, &options(), &StopCriteria::after_points(12)).unwrap();
    assert!(found.end.is_cut_short() && !found.end.is_failure() && found.points.len() == 12, "{:?}", found.end);
    assert!(found.peak.is_some_and(|peak| peak.point.attached == 2));
}
