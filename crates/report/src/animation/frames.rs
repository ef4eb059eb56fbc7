//! The beam at points of the path, all with the same number of points around it.

use peelkit::study::{DeformedShape, LimitPoint, Peel};

/// Places of a path at which the beam is shown, its limit points aside.
const MOST: usize = 90;
/// Points along the beam.
const ALONG: usize = 56;

/// The beam at one point of the path.
#[derive(Clone, Debug, PartialEq)]
pub struct Pose {
    /// u, nm
    pub displacement: f64,
    /// P, nN
    pub force: f64,
    /// Whether it is unstable under displacement control
    pub unstable: bool,
    /// How far along the curve as it is seen, from 0 to 1
    pub time: f64,
    /// Its outline, nm: the lower side from the free end on, and the upper one back
    pub outline: Vec<(f64, f64)>,
}

/// A point of the path, or a limit point behind one.
enum Place<'a> {
    Point(usize),
    Limit(&'a LimitPoint),
}

/// The beam along the path, in its order: at about 90 points of the path, by even distances along the curve, and at every limit point. Each is
/// an equilibrium that was computed, and none lies between two. Empty where the solutions behind the path are not known.
pub fn poses(peel: &Peel) -> Vec<Pose> {
    let mut places = Vec::new();
    for index in 0..peel.points.len() {
        places.push(Place::Point(index));
        let behind = peel.limit_points.iter().filter(|limit| limit.after == index);
        places.extend(behind.map(Place::Limit));
    }
    let at = |place: &Place| match place {
        Place::Point(index) => (peel.points[*index].displacement, peel.points[*index].force),
        Place::Limit(limit) => (limit.displacement, limit.force),
    };
    let range = |pick: fn((f64, f64)) -> f64| {
        let (low, high) =
            places.iter().map(|place| pick(at(place))).fold((0.0f64, 0.0f64), |(a, b), v| (a.min(v), b.max(v)));
        (high - low).max(f64::MIN_POSITIVE)
    };
    let (wide, high) = (range(|at| at.0), range(|at| at.1));
    let mut length = 0.0;
    let mut lengths = vec![0.0];
    for pair in places.windows(2) {
        let (from, to) = (at(&pair[0]), at(&pair[1]));
        length += ((to.0 - from.0) / wide).hypot((to.1 - from.1) / high);
        lengths.push(length);
    }
    let whole = length.max(f64::MIN_POSITIVE);
    let mut chosen: Vec<usize> = (0..MOST)
        .filter_map(|frame| {
            let wanted = length * frame as f64 / (MOST - 1) as f64;
            (0..places.len()).min_by(|&a, &b| (lengths[a] - wanted).abs().total_cmp(&(lengths[b] - wanted).abs()))
        })
        .collect();
    let is_limit_point = |index: &usize| matches!(places[*index], Place::Limit(_));
    chosen.extend((0..places.len()).filter(is_limit_point));
    chosen.sort_unstable();
    chosen.dedup();
    let pose = |index: usize| {
        let (displacement, force) = at(&places[index]);
        let (shape, unstable) = match places[index] {
            Place::Point(point) => (peel.smooth_shape(point), peel.points[point].negative_eigenvalues > 0),
            Place::Limit(limit) => {
                (peel.shape_at_limit_point(limit)?, peel.points[limit.after].negative_eigenvalues > 0)
            }
        };
        let outline = outline(&shape)?;
        Some(Pose { displacement, force, unstable, time: lengths[index] / whole, outline })
    };
    chosen.into_iter().filter_map(pose).collect()
}

/// Points around the beam, evenly along its axis.
fn outline(shape: &DeformedShape) -> Option<Vec<(f64, f64)>> {
    let mut lengths = vec![0.0];
    for index in 1..shape.x.len() {
        let step = (shape.x[index] - shape.x[index - 1]).hypot(shape.y[index] - shape.y[index - 1]);
        lengths.push(lengths[index - 1] + step);
    }
    let whole = *lengths.last().filter(|&&length| length.is_finite() && length > 0.0)?;
    let section = |k: usize| {
        let wanted = whole * k as f64 / (ALONG - 1) as f64;
        let to = lengths.partition_point(|&length| length < wanted).clamp(1, lengths.len() - 1);
        let part = (wanted - lengths[to - 1]) / (lengths[to] - lengths[to - 1]).max(f64::MIN_POSITIVE);
        [&shape.x, &shape.y, &shape.rotation, &shape.height].map(|of| of[to - 1] + part * (of[to] - of[to - 1]))
    };
    let side = |part: f64| {
        let edge =
            move |[x, y, turn, height]: [f64; 4]| (x - part * height * turn.sin(), y + part * height * turn.cos());
        (0..ALONG).map(section).map(edge).collect::<Vec<_>>()
    };
    let mut rim = side(-0.5);
    rim.extend(side(0.5).into_iter().rev());
    rim.iter().all(|point| point.0.is_finite() && point.1.is_finite()).then_some(rim)
}
