//! A measured force-displacement curve: the points on its first stable branch, and where it jumps.

use crate::study::parameters::fit::result::FitDataError;

/// A measured point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeasuredPoint {
    /// As the machine records it, nm
    pub displacement: f64,
    /// nN
    pub force: f64,
    /// Standard error of the force, nN, where it is known
    pub force_error: Option<f64>,
}

/// Where a measured curve jumps for the first time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredJump {
    /// As the machine records it, nm: half-way between the points before and behind it
    pub displacement: f64,
    /// Its standard error, nm: that of a place which is equally likely anywhere between the two, or, where both have the same displacement, over the
    /// smallest distance of the others
    pub error: f64,
}

/// A measured curve.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredCurve {
    /// Those before the jump, in the order of their displacements
    pub points: Vec<MeasuredPoint>,
    /// None where the curve ends before it jumps
    pub jump: Option<MeasuredJump>,
    /// Points behind the jump, which are not fitted
    pub behind_jump: Vec<MeasuredPoint>,
    /// The mean force of these, nN, where the jump was found by their having none
    pub rest: Option<f64>,
}

/// Fewest points of a curve.
const LEAST: usize = 4;
/// A way back that is this share of the whole range is no noise.
const BACK: f64 = 0.5;
/// Fewest points without a force behind a jump that is found.
const LEAST_BEHIND: usize = 3;
/// A force within so many standard errors is none; one of more than twice as many is one.
const NO_FORCE: f64 = 4.0;

impl MeasuredCurve {
    /// Of points in the order in which they were measured. `jump` is the measured displacement of the first jump; none: it is looked for where
    /// the force falls to zero for good, three or more points of at most four standard errors behind one of more than eight. `zero` is the force that is
    /// recorded where nothing pulls, nN; none: it is not known, and the median of the last three points is taken for it.
    ///
    /// # Errors
    /// With too few points, points that go there and back, no force, and a jump that is not among them.
    pub fn new(points: Vec<MeasuredPoint>, jump: Option<f64>, zero: Option<f64>) -> Result<Self, FitDataError> {
        in_one_direction(&points)?;
        let mut points = points;
        points.sort_by(|a, b| a.displacement.total_cmp(&b.displacement));
        let few = |points: usize, before_jump| FitDataError::TooFew { points, least: LEAST, before_jump };
        if points.len() < LEAST {
            return Err(few(points.len(), None));
        }
        if points.iter().all(|point| point.force == points[0].force) {
            return Err(FitDataError::NoForce { force: points[0].force });
        }
        let (from, to) = (points[0].displacement, points[points.len() - 1].displacement);
        let before = match jump {
            Some(jump) if !(from < jump && jump < to) => return Err(FitDataError::JumpOutside { from, to, jump }),
            Some(jump) => Some(points.partition_point(|point| point.displacement < jump)),
            None => detached_from(&points, zero),
        };
        let Some(before) = before else { return Ok(Self { points, jump: None, behind_jump: Vec::new(), rest: None }) };
        let behind_jump = points.split_off(before);
        let (last, next) = (points[before - 1].displacement, behind_jump[0].displacement);
        // two rows at one displacement say where it jumps as well as the record tells places apart
        let apart =
            || points.windows(2).map(|pair| pair[1].displacement - pair[0].displacement).filter(|way| *way > 0.0);
        let width = if next > last { next - last } else { apart().fold(f64::INFINITY, f64::min) };
        let found = MeasuredJump { displacement: 0.5 * (last + next), error: width / 12f64.sqrt() };
        if points.len() < LEAST {
            return Err(few(points.len(), Some(found.displacement)));
        }
        let mean = || behind_jump.iter().map(|point| point.force).sum::<f64>() / behind_jump.len() as f64;
        let rest = jump.is_none().then(mean);
        Ok(Self { points, jump: Some(found), behind_jump, rest })
    }

    /// First and last displacement, nm.
    pub fn range(&self) -> (f64, f64) {
        (self.points[0].displacement, self.points[self.points.len() - 1].displacement)
    }

    /// Largest force by its amount, nN.
    pub fn largest_force(&self) -> f64 {
        self.points.iter().fold(0.0, |most, point| point.force.abs().max(most))
    }
}

/// Refuses a record of the way there and the way back.
fn in_one_direction(points: &[MeasuredPoint]) -> Result<(), FitDataError> {
    let places = || points.iter().map(|point| point.displacement);
    let range = places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min);
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return Ok(()) };
    let (from, to) = (first.displacement, last.displacement);
    let upward = if to >= from { 1.0 } else { -1.0 };
    let mut furthest = from;
    for place in places() {
        if upward * (place - furthest) > 0.0 {
            furthest = place;
        }
        if upward * (furthest - place) > BACK * range {
            return Err(FitDataError::ThereAndBack { from, turn: furthest, to });
        }
    }
    let start = places().map(|place| upward * (from - place)).fold(0.0, f64::max);
    if start > BACK * range {
        return Err(FitDataError::ThereAndBack { from, turn: from - upward * start, to });
    }
    Ok(())
}

/// Where the points begin that have no force any more, if the curve jumps there.
fn detached_from(points: &[MeasuredPoint], zero: Option<f64>) -> Option<usize> {
    let estimated = noise_of([points]);
    let mut last: Vec<f64> = points.iter().rev().take(LEAST_BEHIND).map(|point| point.force).collect();
    let zero = zero.unwrap_or_else(|| median(&mut last));
    let largest = points.iter().fold(0.0f64, |most, point| (point.force - zero).abs().max(most));
    let in_errors =
        |point: &MeasuredPoint| (point.force - zero) / point.force_error.unwrap_or(estimated).max(1e-6 * largest);
    let behind = points.iter().rev().take_while(|point| in_errors(point).abs() <= NO_FORCE).count();
    let before = points.len() - behind;
    let jumps = behind >= LEAST_BEHIND && before > 0 && in_errors(&points[before - 1]) > 2.0 * NO_FORCE;
    jumps.then_some(before)
}

/// Standard error of the forces of several curves from how neighbours differ, nN: from second differences, which a smooth curve does not show. A
/// median, which its few sharp bends do not change.
pub(in crate::study::parameters::fit) fn noise<'c>(curves: impl IntoIterator<Item = &'c MeasuredCurve>) -> f64 {
    noise_of(curves.into_iter().map(|curve| &curve.points[..]))
}

fn noise_of<'p>(curves: impl IntoIterator<Item = &'p [MeasuredPoint]>) -> f64 {
    // of normal errors the median of |a - 2b + c| is 0.6745 √6 times their standard deviation
    const MEDIAN: f64 = 0.6745;
    let threes = curves.into_iter().flat_map(|points| points.windows(3));
    let mut all: Vec<f64> = threes.map(|three| second_difference(three).0.abs()).collect();
    median(&mut all) / MEDIAN
}

/// The second of three points less what lies between the others on a line, over the standard deviation of that, nN; and the slope of the line, nN/nm.
pub(in crate::study::parameters::fit) fn second_difference(three: &[MeasuredPoint]) -> (f64, f64) {
    let [a, b, c] = [0, 1, 2].map(|k| (three[k].displacement, three[k].force));
    let share = if c.0 > a.0 { (b.0 - a.0) / (c.0 - a.0) } else { 0.5 };
    let slope = if c.0 > a.0 { (c.1 - a.1) / (c.0 - a.0) } else { 0.0 };
    let off = b.1 - (1.0 - share) * a.1 - share * c.1;
    (off / (1.0 + share * share + (1.0 - share).powi(2)).sqrt(), slope)
}

/// The middle one of some numbers; 0 where there are none.
pub(in crate::study::parameters::fit) fn median(numbers: &mut [f64]) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let count = numbers.len();
    if count == 0 { 0.0 } else { 0.5 * (numbers[(count - 1) / 2] + numbers[count / 2]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(forces: &[f64]) -> Vec<MeasuredPoint> {
        let point = |(k, &force): (usize, &f64)| MeasuredPoint { displacement: k as f64, force, force_error: None };
        forces.iter().enumerate().map(point).collect()
    }

    /// A deterministic wobble of about 0.01.
    fn wobble(k: usize) -> f64 {
        0.014 * (7.3 * k as f64).sin()
    }

    #[test]
    fn a_fall_to_zero_for_good_is_a_jump() {
        let forces: Vec<f64> = (0..30).map(|k| if k < 20 { 1.0 + wobble(k) } else { wobble(k) }).collect();
        let curve = MeasuredCurve::new(points(&forces), None, Some(0.0)).unwrap();
        assert_eq!(curve.jump.unwrap().displacement, 19.5);
        assert!((curve.jump.unwrap().error - 1.0 / 12f64.sqrt()).abs() < 1e-15);
        assert_eq!((curve.points.len(), curve.behind_jump.len()), (20, 10));
        assert!((0.3..3.0).contains(&(noise([&curve]) / 0.01)), "{}", noise([&curve]));
    }

    #[test]
    fn a_jump_at_one_displacement_has_an_error() {
        let forces: Vec<f64> = (0..30).map(|k| if k < 20 { 1.0 + wobble(k) } else { wobble(k) }).collect();
        let mut points = points(&forces);
        points[20].displacement = points[19].displacement;
        let jump = MeasuredCurve::new(points, None, Some(0.0)).unwrap().jump.unwrap();
        assert_eq!((jump.displacement, jump.error), (19.0, 1.0 / 12f64.sqrt()));
    }

    #[test]
    fn a_fall_to_the_unknown_zero_of_the_load_cell_is_a_jump_as_well() {
        let forces: Vec<f64> = (0..30).map(|k| 5.0 + if k < 20 { 1.0 + wobble(k) } else { wobble(k) }).collect();
        assert_eq!(MeasuredCurve::new(points(&forces), None, Some(0.0)).unwrap().jump, None);
        let curve = MeasuredCurve::new(points(&forces), None, None).unwrap();
        assert_eq!(curve.jump.unwrap().displacement, 19.5);
        assert!((curve.rest.unwrap() - 5.0).abs() < 0.01, "{:?}", curve.rest);
    }

    #[test]
    fn a_curve_that_levels_off_does_not_jump() {
        let forces: Vec<f64> = (0..30).map(|k| (-(k as f64) / 3.0).exp() + wobble(k)).collect();
        assert_eq!(MeasuredCurve::new(points(&forces), None, Some(0.0)).unwrap().jump, None);
        let said = MeasuredCurve::new(points(&forces), Some(20.2), Some(0.0)).unwrap();
        assert_eq!((said.points.len(), said.jump.unwrap().displacement), (21, 20.5));
    }

    #[test]
    fn what_is_no_curve_is_refused() {
        let there: Vec<f64> = (0..10).map(|k| k as f64).collect();
        let mut both = points(&there);
        both.extend(points(&there).into_iter().rev());
        assert!(matches!(MeasuredCurve::new(both, None, Some(0.0)), Err(FitDataError::ThereAndBack { .. })));
        let backward: Vec<_> = points(&there).into_iter().rev().collect();
        assert_eq!(MeasuredCurve::new(backward, None, Some(0.0)).unwrap().points, points(&there));
        assert!(matches!(MeasuredCurve::new(points(&[1.0, 2.0]), None, Some(0.0)), Err(FitDataError::TooFew { .. })));
        assert!(matches!(MeasuredCurve::new(points(&[1.0; 9]), None, Some(0.0)), Err(FitDataError::NoForce { .. })));
        assert!(matches!(
            MeasuredCurve::new(points(&there), Some(-1.0), Some(0.0)),
            Err(FitDataError::JumpOutside { .. })
        ));
        assert!(matches!(MeasuredCurve::new(points(&there), Some(2.5), Some(0.0)), Err(FitDataError::TooFew { .. })));
    }
}
