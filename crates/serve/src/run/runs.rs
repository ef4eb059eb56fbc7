//! Runs on threads of their own: so many at once, so many that wait, each with an end.

use crate::asked::limits::Limits;
use crate::asked::refusal::Refusal;
use peelkit::study::{Stage, StopCriteria, StopReason};
use peelkit_analyses::Watcher;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use tokio::sync::Semaphore;

/// The runs of one server.
#[derive(Clone, Debug)]
pub(crate) struct Runs {
    places: Arc<Semaphore>,
    waiting: Arc<AtomicUsize>,
    ending: Arc<AtomicBool>,
    limits: Limits,
}

/// When one run ends, although its path goes on.
#[derive(Clone, Debug)]
pub(crate) struct RunEnd {
    /// Nobody waits for it any more.
    left: Arc<AtomicBool>,
    ending: Arc<AtomicBool>,
    started: Instant,
    time: Duration,
}

impl Watcher for RunEnd {
    /// These criteria, and besides: the run ends when its page has gone, when the server ends, and after its time.
    fn ends(&self, stop: StopCriteria) -> StopCriteria {
        let end = self.clone();
        stop.or_when(move |stage| end.reason(stage))
    }

    fn asked(&self) -> bool {
        self.left.load(Ordering::Relaxed) || self.ending.load(Ordering::Relaxed)
    }
}

impl RunEnd {
    fn reason(&self, stage: Stage) -> Option<StopReason> {
        if self.asked() {
            return Some(StopReason::Interrupted);
        }
        let most = match stage {
            Stage::Path => self.time,
            Stage::Results => 2 * self.time,
        };
        (self.started.elapsed() > most).then_some(StopReason::Time { seconds: self.time.as_secs_f64() })
    }
}

/// Sets a flag when who waits has gone.
struct OnDrop(Arc<AtomicBool>);

impl Drop for OnDrop {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// One that waits, counted.
struct Waiting(Arc<AtomicUsize>);

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

impl Runs {
    pub fn new(limits: Limits) -> Self {
        Self { places: Arc::new(Semaphore::new(limits.runs)), waiting: Arc::default(), ending: Arc::default(), limits }
    }

    /// Ends all runs, and begins no other.
    pub fn end(&self) {
        self.ending.store(true, Ordering::Relaxed);
        self.places.close();
    }

    /// Does work on a thread of its own as soon as there is a place. Where this is dropped before, the work is not begun or is asked to end.
    ///
    /// Fails where too many wait, where the server is ending, and where the work panics.
    pub async fn run<T: Send + 'static>(&self, work: impl FnOnce(&RunEnd) -> T + Send + 'static) -> Result<T, Refusal> {
        let place = {
            let counted = Waiting(Arc::clone(&self.waiting));
            let before = self.waiting.fetch_add(1, Ordering::Relaxed);
            if before >= self.limits.waiting && self.places.available_permits() == 0 {
                return Err(Refusal::Busy(before));
            }
            let place = Arc::clone(&self.places).acquire_owned().await;
            drop(counted);
            place.map_err(|_| Refusal::Ending)?
        };
        let left = Arc::new(AtomicBool::new(false));
        let end = RunEnd {
            left: Arc::clone(&left),
            ending: Arc::clone(&self.ending),
            started: Instant::now(),
            time: self.limits.time,
        };
        let _left = OnDrop(left);
        let done = tokio::task::spawn_blocking(move || {
            let _place = place;
            work(&end)
        });
        let done = done.await.map_err(|error| Refusal::Broken(error.to_string()));
        if self.ending.load(Ordering::Relaxed) { Err(Refusal::Ending) } else { done }
    }
}
