//! Where a path is stopped although it goes on, as a scene says it.

use peelkit::study::{FollowedUntil, Patience, Stage, StopCriteria, StopReason};
use std::time::{Duration, Instant};

/// The table `bounds`, and how far a path is followed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoundsTable {
    /// Most path points.
    pub points: usize,
    /// Most seconds of wall clock; none when absent.
    pub time_s: Option<f64>,
    /// Largest grip displacement, nm; none when absent.
    pub displacement: Option<f64>,
    /// As far as what a path is followed: `until` of the table `path`.
    pub until: FollowedUntil,
}

impl BoundsTable {
    /// What a run is given that begins now: its clock starts here.
    pub fn from_now(&self) -> StopCriteria {
        let Self { points, time_s, displacement, until } = *self;
        let stop = StopCriteria { displacement, until, ..StopCriteria::after_points(points) };
        match time_s {
            Some(seconds) => StopCriteria { patience: Patience::Unlimited, ..stop.or_when(time_limit(seconds)) },
            None => stop,
        }
    }
}

/// Ends a path after so many seconds from now, and limit points, error bounds and work after as long again and a second.
fn time_limit(seconds: f64) -> impl Fn(Stage) -> Option<StopReason> + Send + Sync + 'static {
    let started = Instant::now();
    let last = Duration::try_from_secs_f64(2.0 * seconds + 1.0).ok().and_then(|most| started.checked_add(most));
    move |stage| {
        let over = match stage {
            Stage::Path => started.elapsed().as_secs_f64() > seconds,
            Stage::Results => last.is_some_and(|last| Instant::now() > last),
        };
        over.then_some(StopReason::Time { seconds })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the clock of so many seconds says at once.
    fn at_once(seconds: f64) -> [bool; 2] {
        let stop = BoundsTable { points: 1, time_s: Some(seconds), ..BoundsTable::default() }.from_now();
        let check = stop.should_stop.unwrap();
        [Stage::Path, Stage::Results].map(|stage| check(stage) == Some(StopReason::Time { seconds }))
    }

    #[test]
    fn no_time_at_all_ends_the_path_and_leaves_a_second_for_its_results() {
        assert_eq!(at_once(0.0), [true, false]);
    }

    #[test]
    fn a_time_that_no_clock_can_tell_is_never_over() {
        assert_eq!([at_once(1e6), at_once(1e300)], [[false; 2]; 2]);
        assert!(BoundsTable { points: 1, ..BoundsTable::default() }.from_now().should_stop.is_none());
    }
}
