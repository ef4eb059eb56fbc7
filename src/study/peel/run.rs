//! The run behind [`super::peel`]: the path on meshes that follow its front, at one pace after another, and, where none of them gives a path that can be
//! used, on fixed meshes.

use super::assembly::widened;
use super::budget::{Budget, Checkpoint, Limits};
use super::meshes::{Collapsed, KnownStart, on_meshes};
use super::result::{Failure, PathEnd, Peel};
use crate::beam::mesh::MeshKind;
use crate::model::peel::PeelModel;
use crate::solve::workspace::Pace;
use crate::study::asked::accuracy::{Accuracy, Choice, Resolution, aim};
use crate::study::asked::stop_criteria::StopCriteria;

/// How a path is followed, one way after another until it can be used.
const PACES: [Pace; 3] = [Pace::Quick, Pace::Wary, Pace::Watchful];
/// The same of a beam that its adhesive holds along the ground. It is lost where it hangs by its edge: its path has a cusp there, which is seen at the
/// watchful pace alone.
const PACES_HELD: [Pace; 2] = [Pace::Quick, Pace::Watchful];

/// In space a path that was lost takes as long as many that are not, and is not watched. With friction, and of a film that yields, the other paces take
/// ten times as long and find next to nothing: what slides or yields depends on the steps there.
fn paces(model: &PeelModel) -> &'static [Pace] {
    match model.space {
        _ if model.friction_law().is_some() || model.yields() => &PACES[..1],
        Some(_) => &PACES[..2],
        None if model.is_held() => &PACES_HELD,
        None => &PACES,
    }
}

/// The work that a peel may take.
fn budget(model: &PeelModel, accuracy: &Accuracy, stop: &StopCriteria) -> Budget {
    Budget::of(stop, Resolution::first(model, &accuracy.fitted(model)).elements)
}

/// Follows the peel from rest to its end.
pub(in crate::study) fn run(
    model: &PeelModel,
    accuracy: &Accuracy,
    stop: &StopCriteria,
    checkpoint: &Checkpoint,
) -> Peel {
    let (aimed, least) = aim(model, accuracy);
    let limits = Limits { stop, checkpoint };
    let paces = paces(model);
    let mut budget = budget(model, &aimed, stop);
    let mut peel = on_meshes(model, &aimed, &limits, None, paces, Collapsed::Refined, &mut budget);
    let lost = matches!(peel.end, PathEnd::Failed(Failure::Path { .. })) && limits.reached().is_none();
    let is_watched = paces.contains(&Pace::Watchful);
    let is_moving = aimed.fitted(model).choice.mesh == MeshKind::Moving;
    if lost && !budget.is_spent() && is_watched && is_moving {
        peel = on_fixed_meshes(peel, model, &aimed, stop, &mut budget);
    }
    widened(peel, accuracy, least)
}

/// The same path on fixed meshes, if that can be used. A mesh that follows the front is coarse far from it, where a strip that is compressed waves:
/// the more, the nearer the compression is to that under which what is bonded wrinkles.
fn on_fixed_meshes(
    lost: Peel,
    model: &PeelModel,
    accuracy: &Accuracy,
    stop: &StopCriteria,
    budget: &mut Budget,
) -> Peel {
    let fixed = accuracy.with(Choice { mesh: MeshKind::Graded, ..accuracy.choice });
    let limits = Limits { stop, checkpoint: &Checkpoint::NOTHING };
    let mut peel = on_meshes(model, &fixed, &limits, None, &[Pace::Quick, Pace::Watchful], Collapsed::Lost, budget);
    if peel.unfinished || matches!(peel.end, PathEnd::Failed(_)) {
        return lost;
    }
    peel.effort.newton_iterations += lost.effort.newton_iterations;
    peel
}

/// From an equilibrium on.
pub(in crate::study) fn run_from(
    start: &KnownStart,
    model: &PeelModel,
    accuracy: &Accuracy,
    stop: &StopCriteria,
) -> Peel {
    let (aimed, least) = aim(model, accuracy);
    let limits = Limits { stop, checkpoint: &Checkpoint::NOTHING };
    let mut budget = budget(model, &aimed, stop);
    let peel = on_meshes(model, &aimed, &limits, Some(start), paces(model), Collapsed::Refined, &mut budget);
    widened(peel, accuracy, least)
}
