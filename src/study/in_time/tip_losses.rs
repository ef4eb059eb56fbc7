//! Where in a step a tip comes to the end of its branch, and which tips lose their hold where no step is short enough.

use crate::solve::state::State;
use crate::study::seta::rest::share_of_change;
use crate::study::seta::standing::Standing;

/// Place of a tip along the normal
const HEIGHT: usize = 1;
/// A step that is cut ends so far behind the end of the branch, over how near to it it has to end.
const BEHIND: f64 = 0.3;
/// Tips that differ by this share are alike, by symmetry.
const ALIKE: f64 = 1e-6;

/// At which share of a step the first tip comes to the end of its branch; none where no tip does, or only within the distance `located`, nm, of where
/// the step ends.
pub(in crate::study) fn event_within(standing: &Standing, from: &State, to: &State, located: f64) -> Option<f64> {
    let changing = standing.changing(to).into_iter();
    let shares = changing.map(|tip| (share_of_change(standing, from, to, tip), travel(standing, from, to, tip)));
    let (share, travel) = shares.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let late = (1.0 - share) * travel > located;
    late.then(|| share + BEHIND * located / travel)
}

/// How far a tip goes, nm.
fn travel(standing: &Standing, from: &State, to: &State, tip: usize) -> f64 {
    let (a, b) = (standing.place(from, tip).0, standing.place(to, tip).0);
    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
}

/// The tips that adhere, soften and go up the fastest, between two states, for how much they soften: those that lose their hold.
pub(in crate::study) fn softest(standing: &Standing, from: &State, to: &State) -> Vec<usize> {
    let softening = |tip: usize| {
        let rise = standing.place(to, tip).0[HEIGHT] - standing.place(from, tip).0[HEIGHT];
        let own = standing.response(to, tip).hessian[HEIGHT][HEIGHT];
        let counts = standing.tips[tip].on.adheres() && rise > 0.0 && own < 0.0;
        if counts { own * rise * rise } else { 0.0 }
    };
    let all: Vec<f64> = (0..standing.tips.len()).map(softening).collect();
    let least = all.iter().copied().fold(0.0, f64::min);
    (0..all.len()).filter(|&tip| all[tip] < 0.0 && all[tip] <= (1.0 - ALIKE) * least).collect()
}
