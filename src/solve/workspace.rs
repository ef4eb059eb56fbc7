//! Room that solves use again, whether they are stopped, and at what pace they go.

use serde::{Deserialize, Serialize};
use std::any::Any;
use std::sync::Arc;

/// What is tried where Newton's method does not converge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Pace {
    /// Nothing more.
    #[default]
    Quick,
    /// It is begun again, and ends by the size of its updates alone: first with linear ones, then with those that follow the section force.
    Wary,
    /// The same, with the slopes and the inertia of every solution those at the solution itself, and no step believed whose inertia says that it has led
    /// to another part of the path.
    Watchful,
}

/// Asks whether to go on: once it says true, no solve is begun.
pub type ShouldStop = Arc<dyn Fn() -> bool + Send + Sync>;

/// Room that solves use again, and the factors of the last of them.
#[derive(Default)]
pub struct Workspace {
    /// Of a type that the system alone knows.
    factors: Option<Box<dyn Any + Send + Sync>>,
    should_stop: Option<ShouldStop>,
    pace: Pace,
}

impl Workspace {
    /// One in which no solve is begun once `should_stop` says so: it is [`crate::solve::SolveError::Stopped`].
    pub(crate) fn until(should_stop: Option<ShouldStop>) -> Self {
        Self { factors: None, should_stop, pace: Pace::Quick }
    }

    /// The same in which solves go at this pace.
    pub fn at(self, pace: Pace) -> Self {
        Self { pace, ..self }
    }

    /// How solves go in it.
    pub(super) fn pace(&self) -> Pace {
        self.pace
    }

    /// Lets the next solves go at this pace.
    pub(super) fn set_pace(&mut self, pace: Pace) {
        self.pace = pace;
    }

    /// Whether no solve is to be begun.
    pub(crate) fn is_stopped(&self) -> bool {
        self.should_stop.as_ref().is_some_and(|should_stop| should_stop())
    }

    /// The factors of a system, made anew where the last ones were of another kind.
    pub fn factors<F: Any + Send + Sync + Default>(&mut self) -> &mut F {
        let known = self.factors.as_ref().is_some_and(|factors| factors.is::<F>());
        if !known {
            self.factors = Some(Box::<F>::default());
        }
        let factors = self.factors.as_mut().and_then(|factors| factors.downcast_mut());
        factors.unwrap_or_else(|| unreachable!("factors of this kind were put there"))
    }

    /// The factors of the last factorisation.
    ///
    /// # Panics
    /// Where the last system that was factorised in this workspace is of another kind.
    pub fn factored<F: Any + Send + Sync>(&self) -> &F {
        let factors = self.factors.as_ref().and_then(|factors| factors.downcast_ref());
        factors.unwrap_or_else(|| panic!("a system of this kind has been factorised in this workspace"))
    }
}
