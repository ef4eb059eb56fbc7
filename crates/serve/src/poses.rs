//! The beam along the path as whole numbers, and the ground below it.

use peelkit::study::Peel;
use peelkit_report::Pose;
use serde::Serialize;

/// Parts of the largest extent to which a place of an outline is rounded.
const FINE: f64 = 2e4;
/// Points of the surface that are drawn where it is not flat.
const DRAWN: usize = 600;
/// Of the surface beside the beam, over the extent of that.
const BESIDE: f64 = 2.0;

/// The beam along the path.
#[derive(Debug, Serialize)]
pub(crate) struct Poses {
    /// What a whole number of an outline or of the ground is, nm
    #[serde(rename = "unit_nm")]
    unit: f64,
    /// x and y in turn
    ground: Vec<i32>,
    /// In path order
    along: Vec<PoseNumbers>,
}

/// The beam at one equilibrium.
#[derive(Debug, Serialize)]
struct PoseNumbers {
    #[serde(rename = "displacement_nm")]
    displacement: f64,
    #[serde(rename = "force_nN")]
    force: f64,
    unstable: bool,
    /// How far along the curve as it is seen, from 0 to 1
    position: f64,
    /// x and y in turn: the lower side from the free end on, and the upper one back
    outline: Vec<i32>,
}

impl Poses {
    /// The poses of a peel; none where it has no shapes.
    pub fn of(peel: &Peel) -> Self {
        let poses = peelkit_report::poses(peel);
        let places = || poses.iter().flat_map(|pose| &pose.outline).copied();
        let [low, high] =
            [f64::min, f64::max].map(|pick| places().fold((0.0, 0.0), |(x, y), at| (pick(x, at.0), pick(y, at.1))));
        let extent = (high.0 - low.0).max(high.1 - low.1).max(f64::MIN_POSITIVE);
        let unit = extent / FINE;
        let whole = |value: f64| (value / unit).round() as i32;
        let numbers = |places: &[(f64, f64)]| places.iter().flat_map(|&(x, y)| [whole(x), whole(y)]).collect();
        let along = |pose: &Pose| PoseNumbers {
            displacement: pose.displacement,
            force: pose.force,
            unstable: pose.unstable,
            position: pose.time,
            outline: numbers(&pose.outline),
        };
        let (from, to) = (low.0 - BESIDE * extent, high.0 + BESIDE * extent);
        Self { unit, ground: numbers(&surface(peel, from, to)), along: poses.iter().map(along).collect() }
    }
}

/// The upper side of the ground between two places.
fn surface(peel: &Peel, from: f64, to: f64) -> Vec<(f64, f64)> {
    let substrate = &peel.model.ground.substrate;
    let pieces = if substrate.is_flat() { 1 } else { DRAWN };
    let place = |k: usize| from + (to - from) * k as f64 / pieces as f64;
    (0..=pieces).map(place).map(|x| (x, substrate.top(x, x))).collect()
}
