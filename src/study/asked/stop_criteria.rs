//! Where a path is stopped although it goes on. The library looks at no clock and hears no user: a caller that does says so.

use super::events::{EventAction, EventAt};
use crate::solve::points::passing::SoughtValue;
use crate::solve::workspace::ShouldStop;
use crate::units::length_text;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

/// What a run is doing when it asks whether to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// It is about to compute the next point of a path, or to follow the path on another mesh. Stopped there it still locates the
    /// limit points of what it has reached, and their error bounds.
    Path,
    /// It is about to solve for a point, a limit point, an error bound or the work. Stopped there its result is a failure.
    Results,
}

/// Why a caller stops a run.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // the text of each names its fields
pub enum StopReason {
    /// It has lasted so long, s.
    Time { seconds: f64 },
    /// The user wants it to.
    Interrupted,
}

/// Says at a stage why a run is to stop, if it is. It is asked often, and from any thread.
pub(crate) type StopCheck = Arc<dyn Fn(Stage) -> Option<StopReason> + Send + Sync>;

/// As far as what a path is followed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FollowedUntil {
    /// Just behind the first displacement limit point at which u turns back: where a displacement-controlled test makes its first jump
    FirstJump,
    /// Behind the displacement limit point at which the last of the beam comes off: to where nothing adheres and the grip is further away than there
    Detachment,
    /// Its end
    #[default]
    End,
}

impl FollowedUntil {
    /// Every one with its name in a scene.
    pub const NAMED: [(&'static str, Self); 3] =
        [("first-jump", Self::FirstJump), ("detachment", Self::Detachment), ("end", Self::End)];

    /// Its name in a scene.
    pub fn name(self) -> &'static str {
        Self::NAMED.iter().find(|named| named.1 == self).map_or("", |named| named.0)
    }
}

/// Where a path is stopped although it goes on.
#[derive(Clone)]
pub struct StopCriteria {
    /// Most path points.
    pub points: usize,
    /// Largest grip displacement, nm; none when absent.
    pub displacement: Option<f64>,
    /// As far as what it is followed; of a limit point behind that nothing is known.
    pub until: FollowedUntil,
    /// Stations and events of the user that are looked for on the way. One whose action is [`EventAction::Stop`] ends a path where it lies; the
    /// others are located besides, and leave every point as it is. Those of a [`crate::study::Peel`] are read from it:
    /// [`crate::study::Peel::events`].
    pub events: Vec<EventAt>,
    /// What only the caller knows: the time, an interruption. Nothing when absent.
    pub should_stop: Option<StopCheck>,
    /// How much work a path may take that is lost
    pub patience: Patience,
}

/// How much work a path may take that is lost on one mesh after another.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Patience {
    /// A hundred times what a path usually takes.
    #[default]
    Usual,
    /// As much as there is to try: for who says himself when to stop.
    Unlimited,
}

/// Most path points unless others are given.
const MOST_POINTS: usize = 20_000;

/// The criterion that was met.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs)] // the text of each names its fields
pub enum Bound {
    /// [`StopCriteria::points`]
    Points(usize),
    /// [`StopCriteria::displacement`], nm
    Displacement(f64),
    /// [`StopCriteria::until`]
    Until(FollowedUntil),
    /// An event of [`StopCriteria::events`], by its name
    Event { name: String },
    /// [`StopReason::Time`], s
    Time { seconds: f64 },
    /// [`StopReason::Interrupted`]
    Interrupted,
}

impl fmt::Display for Bound {
    /// By the name of the key of a scene that sets it.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Points(most) => write!(f, "bounds.points = {most}"),
            Self::Displacement(most) => write!(f, "bounds.displacement = {}", length_text(*most)),
            Self::Until(until) => write!(f, "path.until = \"{}\"", until.name()),
            Self::Event { name } => write!(f, "the event \"{name}\""),
            Self::Time { seconds } => write!(f, "bounds.time = {seconds} s"),
            Self::Interrupted => f.write_str("interrupted"),
        }
    }
}

impl From<StopReason> for Bound {
    fn from(reason: StopReason) -> Self {
        match reason {
            StopReason::Time { seconds } => Self::Time { seconds },
            StopReason::Interrupted => Self::Interrupted,
        }
    }
}

impl Default for StopCriteria {
    /// 20 000 points.
    fn default() -> Self {
        Self::after_points(MOST_POINTS)
    }
}

impl StopCriteria {
    /// After so many points, and nothing else.
    pub const fn after_points(points: usize) -> Self {
        Self::within(points, None)
    }

    /// Where the grip is further than so far, nm, or after 20 000 points.
    pub const fn up_to(displacement: f64) -> Self {
        Self::within(MOST_POINTS, Some(displacement))
    }

    const fn within(points: usize, displacement: Option<f64>) -> Self {
        Self {
            points,
            displacement,
            until: FollowedUntil::End,
            events: Vec::new(),
            should_stop: None,
            patience: Patience::Usual,
        }
    }

    /// The same with another check, which is asked where those before say nothing.
    pub fn or_when(self, check: impl Fn(Stage) -> Option<StopReason> + Send + Sync + 'static) -> Self {
        let before = self.should_stop;
        let should_stop: StopCheck = match before {
            Some(before) => Arc::new(move |stage| before(stage).or_else(|| check(stage))),
            None => Arc::new(check),
        };
        Self { should_stop: Some(should_stop), ..self }
    }

    /// The events that end a path.
    pub(in crate::study) fn ending(&self) -> impl Iterator<Item = &EventAt> {
        self.events.iter().filter(|event| event.action == EventAction::Stop)
    }

    /// The first event that ends a path which it passes on the step behind a point.
    pub(in crate::study) fn first_passed<'e, 'p>(
        &'e self,
        after: usize,
        sought: impl Fn(&'e EventAt) -> SoughtValue<'p>,
    ) -> Option<&'e EventAt> {
        let passed = self.ending().filter_map(|event| Some((sought(event).first_passing(after)?, event)));
        passed.min_by(|a, b| a.0.total_cmp(&b.0)).map(|passed| passed.1)
    }

    /// What the caller says at a stage.
    pub(in crate::study) fn reached_bound(&self, stage: Stage) -> Option<Bound> {
        self.should_stop.as_ref().and_then(|should_stop| should_stop(stage)).map(Bound::from)
    }

    /// What stops a motion that is followed in time: the caller, as it stops a path.
    pub fn while_followed(&self) -> Option<ShouldStop> {
        self.for_solves(Stage::Path)
    }

    /// What tells solves to stop: the caller, at this stage.
    pub(in crate::study) fn for_solves(&self, stage: Stage) -> Option<ShouldStop> {
        let should_stop = self.should_stop.clone()?;
        Some(Arc::new(move || should_stop(stage).is_some()))
    }
}

impl fmt::Debug for StopCriteria {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Self { points, displacement, until, events, should_stop, patience } = self;
        f.debug_struct("StopCriteria")
            .field("points", points)
            .field("displacement", displacement)
            .field("until", until)
            .field("events", events)
            .field("should_stop", &should_stop.is_some())
            .field("patience", patience)
            .finish()
    }
}
